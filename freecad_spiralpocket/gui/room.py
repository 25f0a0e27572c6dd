# SPDX-License-Identifier: LGPL-2.1-or-later
"""Room for the panel: FreeCAD's dock may be narrower than the fields, which it then cuts off."""

from __future__ import annotations

from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

#: The dock that holds task panels, since 1.0 and before.
DOCKS = ("Tasks", "Combo View")


def make_room(shown: Any) -> None:
    """Make the dock wide enough for the panel that a widget belongs to."""
    window = FreeCADGui.getMainWindow()
    docks = [window.findChild(QtGui.QDockWidget, name) for name in DOCKS]
    for dock in docks:
        if dock is None or dock.isFloating() or not dock.isAncestorOf(shown):
            continue
        for area in dock.findChildren(QtGui.QScrollArea):
            if area.isAncestorOf(shown) and area.widget() is not None:
                bar = area.verticalScrollBar().sizeHint().width()  # it may come later
                needed = area.widget().minimumSizeHint().width() + bar + 2 * area.frameWidth()
                lacks = needed - area.width()
                if lacks > 0:
                    wide = dock.width() + lacks
                    window.resizeDocks([dock], [wide], QtCore.Qt.Horizontal)
                    return
