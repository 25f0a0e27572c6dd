# SPDX-License-Identifier: LGPL-2.1-or-later
"""The button that opens the comparison, and what keeps it at what the panel foresees."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from ..planning.outlook import Outlook
from .window import Comparison

translate = FreeCAD.Qt.translate


class Compare:
    """An extra of the panel: the button, and the window that it opens."""

    def __init__(self, page: Any) -> None:
        self._page = page
        self._outlook = Outlook.of(page)
        self.window: Comparison | None = None
        self.button = QtGui.QPushButton(translate("SpiralPocket", "Compare..."))
        self.button.setToolTip(translate("SpiralPocket", "All strategies side by side"))
        self.button.clicked.connect(self._open)
        self._outlook.listeners.append(self._update)
        page.compare = self

    def widget(self) -> None:
        """Return nothing: the button stands in the result box."""
        self._page.result_box.buttons.addWidget(self.button)

    def changed(self) -> None:
        """Wait for the outlook."""

    computed = changed

    def close(self) -> None:
        """Close the window."""
        window, self.window = self.window, None
        if window is not None:
            window.close_for_good()

    def _open(self, *_: Any) -> None:
        self.close()
        self.window = Comparison(self._page.form.strategy)
        self.window.dialog.show()
        self._update()

    def _update(self) -> None:
        if self.window is not None:
            self.window.show([(p.label, p.request) for p in self._outlook.pockets])
