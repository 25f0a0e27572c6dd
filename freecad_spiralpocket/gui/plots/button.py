# SPDX-License-Identifier: LGPL-2.1-or-later
"""The button that opens the plots, and what keeps them at what the panel foresees."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from ...beside.tasks import Drawn
from ...engine.errors import SpiralPocketError
from ..planning.outlook import Outlook
from ..texts import messages
from .curves import Curves, curves_of
from .dock import PlotDock

translate = FreeCAD.Qt.translate


class Plots:
    """An extra of the panel."""

    def __init__(self, page: Any) -> None:
        self._page = page
        self._outlook = Outlook.of(page)
        self._shown: tuple[Any, ...] | None = None
        self._known: tuple[Any, Curves] | None = None  # the last curves and what they are of
        self.dock: PlotDock | None = None
        self.button = QtGui.QPushButton(translate("SpiralPocket", "Plots"))
        self.button.setToolTip(
            translate("SpiralPocket", "Engagement, feed, velocity and force along the time")
        )
        self.button.setCheckable(True)
        self.button.toggled.connect(self._toggle)
        self._outlook.listeners.append(self._update)
        page.plots = self

    def widget(self) -> None:
        """Return nothing: the button stands in the result box."""
        self._page.result_box.buttons.addWidget(self.button)

    def changed(self) -> None:
        """Wait for the outlook."""

    computed = changed

    def close(self) -> None:
        """Take the dock away."""
        dock, self.dock = self.dock, None
        if dock is not None:
            dock.close()

    def _toggle(self, wanted: bool) -> None:
        if not wanted:
            self.close()
            return
        try:
            self.dock = PlotDock(self._page.preview.point_at)
        except SpiralPocketError as error:
            self.button.setChecked(False)
            messages.show(error)
            return
        self.dock.dock.visibilityChanged.connect(self._hidden)
        self._shown = None
        self._update()

    def _hidden(self, visible: bool) -> None:
        """Let the button go up when the user closes the dock."""
        if not visible and self.dock is not None and self.dock.dock.isHidden():
            self.button.setChecked(False)

    def _update(self) -> None:
        """Plot the proved plans, if they are others."""
        if self.dock is None:
            return
        drawn = self._outlook.drawn
        if not drawn and not self._outlook.is_settled:
            return  # what is drawn stays until there is something new
        controller = self._page.obj.ToolController
        tool = controller.Proxy.getTool(controller) if drawn else None
        forces = (controller.SpindleSpeed, getattr(tool, "Flutes", 0)) if drawn else ()
        shown = (*map(id, drawn), *forces)
        if shown != self._shown:
            self._shown = shown
            self.dock.show(self._curves_of(drawn, forces) if drawn else None)

    def _curves_of(self, drawn: list[Drawn], forces: tuple[Any, ...]) -> Curves:
        """Return the curves, from the last time if they were the same."""
        known = self._known
        if known is None or known[0] != (drawn, forces):
            known = (drawn, forces), curves_of(drawn, self._page.obj.ToolController)
        self._known = known
        return known[1]
