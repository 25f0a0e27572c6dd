# SPDX-License-Identifier: LGPL-2.1-or-later
"""Room for the panel: FreeCAD's dock may be narrower than the fields, which it then cuts off."""

from __future__ import annotations

from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

from ..compat import TASK_DOCKS

#: Pixels for what FreeCAD draws around its boxes.
FRAMES = 8


def make_room(pages: Any, shown: Any, folded: Any) -> bool:
    """Make the dock wide enough for the panel; return whether to look again, after the layout.

    Parameters
    ----------
    pages : QWidget
        Holds all pages.
    shown : QWidget
        The page that needs the most.
    folded : QWidget
        What may be unfolded in it.
    """
    window, before = FreeCADGui.getMainWindow(), pages.minimumWidth()
    docks = [window.findChild(QtGui.QDockWidget, name) for name in TASK_DOCKS]
    for dock in docks:
        if dock is None or dock.isFloating() or not dock.isAncestorOf(shown):
            continue
        if window.dockWidgetArea(dock) == QtCore.Qt.NoDockWidgetArea:
            continue  # it lies over the view (since 1.0), where FreeCAD keeps the width it has
        lacks, has = 0, dock.width()
        for area in dock.findChildren(QtGui.QScrollArea):
            if area.isAncestorOf(shown) and area.widget() is not None:
                # a bar may come later; asked for by its name it could be what has gone (names.py)
                around = area.style().pixelMetric(QtGui.QStyle.PM_ScrollBarExtent)
                around += 2 * area.frameWidth()
                wide = area.widget().minimumSizeHint().width()
                if area.widget() is shown:  # FreeCAD leaves it out of its reckoning
                    wide = max(wide, folded.minimumSizeHint().width())
                    pages.setMinimumWidth(wide + around)
                lacks = max(lacks, wide + around - area.width())
                has = max(has, area.width())  # the dock may be about to follow
        if lacks > 0:
            window.resizeDocks([dock], [has + lacks + FRAMES], QtCore.Qt.Horizontal)
    return pages.minimumWidth() != before  # what is around them has not heard of it
