# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colors of FreeCAD's theme, for what paints itself.

FreeCAD's themes are style sheets, of which a widget's palette knows only a part, and that not
before it is shown. So the background is looked at on a widget that is painted for this.
"""

from __future__ import annotations

from dataclasses import dataclass

import FreeCADGui
from PySide import QtCore, QtGui

from .names import forget_namesakes


@dataclass(frozen=True)
class Theme:
    """Colors of a window's text and background, each a QColor."""

    text: QtGui.QColor
    background: QtGui.QColor


def theme() -> Theme:
    """Return the colors of a dialog in the theme that is in use."""
    probe = QtGui.QDialog(FreeCADGui.getMainWindow())
    label = QtGui.QLabel(probe)
    label.ensurePolished()
    probe.resize(8, 8)
    image = probe.grab(QtCore.QRect(0, 0, 8, 8)).toImage()
    found = Theme(
        QtGui.QColor(label.palette().color(QtGui.QPalette.WindowText)),
        QtGui.QColor(image.pixel(4, 4)),
    )
    forget_namesakes()
    probe.setParent(None)
    probe.deleteLater()
    return found
