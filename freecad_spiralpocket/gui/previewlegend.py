# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview's legend: a color bar for the cuts and a swatch for everything else."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from . import previewcolors as colors

translate = FreeCAD.Qt.translate

#: Heights in the font's own: of the bar, and of everything.
BAR, ALL = 0.7, 2.4
TICKS = 4  # stretches of the bar


class ColorBar(QtGui.QWidget):
    """The scale with its values and the mark of the limit."""

    def __init__(self) -> None:
        super().__init__()
        self._scale = colors.Scale("engagement", 180.0)
        self.setMinimumHeight(int(ALL * self.fontMetrics().height()))

    def set_scale(self, scale: colors.Scale) -> None:
        """Show another scale."""
        self._scale = scale
        unit = "°" if scale.quantity == "engagement" else translate("SpiralPocket", "mm/min")
        self.setToolTip(f"0 - {scale.top:.0f} {unit}")
        self.update()

    def paintEvent(self, event: Any) -> None:  # noqa: N802 - the name Qt calls
        """Draw bar, values and mark."""
        painter = QtGui.QPainter(self)
        metrics = self.fontMetrics()
        left, right = metrics.height() // 2, self.width() - metrics.height()
        bar = QtCore.QRect(left, 2, right - left, int(BAR * metrics.height()))
        gradient = QtGui.QLinearGradient(left, 0, right, 0)
        for share, color in zip(np.linspace(0, 1, len(colors.SCALE)), colors.SCALE, strict=True):
            gradient.setColorAt(float(share), QtGui.QColor.fromRgbF(*(float(c) for c in color)))
        painter.fillRect(bar, QtGui.QBrush(gradient))
        painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
        painter.drawRect(bar)
        base = bar.bottom() + metrics.ascent() + 3
        unit = "°" if self._scale.quantity == "engagement" else ""
        for i in range(TICKS + 1):
            text = f"{self._scale.top * i / TICKS:.0f}{unit}"
            x = left + bar.width() * i // TICKS - metrics.boundingRect(text).width() // 2
            x = max(0, min(x, self.width() - metrics.boundingRect(text).width() - 2))
            painter.drawText(x, base, text)
        if self._scale.mark is not None:
            x = left + int(bar.width() * min(1.0, self._scale.mark / self._scale.top))
            painter.setPen(QtGui.QPen(self.palette().color(QtGui.QPalette.WindowText), 2))
            painter.drawLine(x, bar.top() - 2, x, bar.bottom() + 3)
        painter.end()


def swatches() -> QtGui.QLabel:
    """Return a label that names the colors of what is not cut."""
    entries = (
        (colors.ENTRY, translate("SpiralPocket", "entry")),
        (colors.LINK, translate("SpiralPocket", "link")),
        (colors.AIR, translate("SpiralPocket", "rapid")),
        (colors.CLEARED, translate("SpiralPocket", "cleared")),
        (colors.LEFT, translate("SpiralPocket", "left over")),
        (colors.ISLAND, translate("SpiralPocket", "island")),
    )
    words = [f'<span style="color:{_html(color)}">■</span>&nbsp;{text}' for color, text in entries]
    label = QtGui.QLabel(" &nbsp;".join(words))
    label.setWordWrap(True)
    return label


def _html(color: tuple[float, float, float]) -> str:
    return "#" + "".join(f"{round(255 * c):02x}" for c in color)
