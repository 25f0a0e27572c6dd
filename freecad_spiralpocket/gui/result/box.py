# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result box: figures of the path that is foreseen or made, and remarks to click on.

A click on a remark that has a place brings the view there and sets the cutter on it.
"""

from __future__ import annotations

from html import escape
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..compat import freecad_icon
from ..planning.outlook import Outlook
from ..texts.localized import in_panel
from ..texts.measures import as_table, switched_off
from .figures import (
    Place,
    Remark,
    figures_of,
    is_applied,
    made_plans,
    remarks_of,
    summary_of,
)
from .zoom import zoom_to

translate = FreeCAD.Qt.translate

#: Height of the list in lines at most, and how much of the part a zoom shows, in cutters.
MOST_LINES, SHOWN = 7, 5.0


class ResultBox:
    """An extra of the panel."""

    def __init__(self, page: Any) -> None:
        self._page, self._obj = page, page.obj
        self._outlook = Outlook.of(page)
        self._remarks: list[Remark] = []
        self._refusals: list[Remark] = []
        self.box = QtGui.QWidget()
        self.box.setWindowTitle(translate("SpiralPocket", "Result"))
        self.box.setWindowIcon(QtGui.QIcon(freecad_icon("Inspect")))
        self.box.setObjectName("SpiralPocketResultBox")
        self._state = QtGui.QLabel()
        self._state.setWordWrap(True)
        self.texts: dict[str, str] = {}  # the figures by their names, as they are shown
        self.figures = QtGui.QLabel()
        self.figures.setWordWrap(True)  # in a narrow panel
        self.figures.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self.list = QtGui.QListWidget()
        self.list.setWordWrap(True)
        self.list.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
        self.list.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.list.itemClicked.connect(self._clicked)
        self.buttons = QtGui.QHBoxLayout()
        layout = QtGui.QVBoxLayout(self.box)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.addWidget(self._state)
        self.body = QtGui.QWidget()
        body = QtGui.QVBoxLayout(self.body)
        body.setContentsMargins(0, 0, 0, 0)
        body.addWidget(self.figures)
        body.addWidget(self.list)
        layout.addWidget(self.body)
        layout.addLayout(self.buttons)
        self._shown: Any = None
        self._outlook.listeners.append(self._update)
        page.result_box = self

    def widget(self) -> Any:
        """Return the box."""
        return self.box

    def changed(self) -> None:
        """Wait for the outlook; what stands here is out of date."""
        self._enable(False)

    def computed(self) -> None:
        """Say whether the path was made."""
        self._shown = None
        self._update()

    def close(self) -> None:
        """Forget the page."""
        self._remarks = []

    def _update(self) -> None:
        """Show what is known by now, if it is something else.

        Until there is something new, what stands there stays, in grey, but for the first line of
        the page: the panel must not jump while a value is typed.
        """
        plans = self._outlook.plans or made_plans(self._obj, self._outlook)
        applied = is_applied(self._obj, plans)
        refusals = [Remark(text) for text in self._page.refusals]
        remarks = [*refusals, *remarks_of(self._obj, self._outlook, plans)]
        state = self._state_of(bool(plans), applied)
        is_known = bool(plans) or self._outlook.is_settled
        shown = ([id(p) for p in plans], state, remarks, is_known)
        self._enable(is_known)
        if shown == self._shown:
            return
        self._shown = shown
        self._state.setText(state)
        waits = not is_known or (self._outlook.is_stopped and not plans)
        told = "" if waits else summary_of(self._obj, plans, remarks, self._missing())
        self._page.form.summary.setText(refusals[0].text if refusals else told or state)
        if is_known:
            self._show_figures(figures_of(self._obj, plans) if plans else [])
        if is_known or remarks or self._refusals:
            self._show_remarks(remarks)
        self._refusals = refusals

    def _missing(self) -> int:
        """Return how many of the pockets cannot be cut."""
        return len(self._outlook.failures if self._outlook.is_on else self._obj.Proxy.errors)

    def _enable(self, on: bool) -> None:
        """Show what stands here, and the line at the top of the page, in black or in grey."""
        self.body.setEnabled(on)
        self._page.form.summary.setEnabled(on)

    def _state_of(self, planned: bool, applied: bool) -> str:
        if applied:
            return translate("SpiralPocket", "The operation has this path.")
        if planned:
            return translate("SpiralPocket", "OK or Apply makes this path.")
        if self._outlook.is_stopped:
            return translate("SpiralPocket", "Stopped: no new path. OK or Apply plans it again.")
        if not self._obj.Active:
            return switched_off()
        if not self._outlook.is_on:
            return translate("SpiralPocket", "Live is off: OK or Apply plans the path.")
        if self._outlook.is_settled:
            return translate("SpiralPocket", "There is no path.")
        return translate("SpiralPocket", "Planning: {:.0f} %").format(100 * self._outlook.fraction)

    def _show_figures(self, figures: list[tuple[str, str]]) -> None:
        self.texts = dict(figures)
        self.figures.setText(as_table([(escape(n), escape(v)) for n, v in figures]))
        self.figures.setVisible(bool(figures))

    def _show_remarks(self, remarks: list[Remark]) -> None:
        self._remarks = remarks
        self.list.clear()
        warning = self.list.style().standardIcon(QtGui.QStyle.SP_MessageBoxWarning)
        for remark in remarks:
            item = QtGui.QListWidgetItem(warning, in_panel(remark.text))
            if remark.place is not None:
                item.setToolTip(translate("SpiralPocket", "Click to see the place"))
            self.list.addItem(item)
        self.list.setVisible(bool(remarks))
        height = self.list.fontMetrics().height()
        self.list.setFixedHeight(height * min(MOST_LINES, 1 + 3 * len(remarks)))

    def _clicked(self, item: Any) -> None:
        place = self._remarks[self.list.row(item)].place
        if place is not None:
            self.show_place(place)

    def show_place(self, place: Place) -> None:
        """Bring the view to a place and set the cutter on it."""
        radius = self._obj.OpToolDiameter.Value / 2
        view = FreeCADGui.getDocument(self._obj.Document.Name).ActiveView
        if hasattr(view, "getCameraNode"):
            zoom_to(view, place, 2 * SHOWN * radius)
        self._page.preview.mark(place, radius)
