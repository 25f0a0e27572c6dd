# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview's legend: a color bar for the cuts and a swatch for everything else."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from ..texts.measures import feed_unit
from . import colors

translate = FreeCAD.Qt.translate

#: Heights in the font's own: of the bar, and of everything.
BAR, ALL = 0.7, 2.4
#: Steps between the values at the bar, at most so many.
STEPS, MOST = (5, 10, 15, 20, 30, 45, 50, 100, 200, 250, 500, 1000, 2000, 2500, 5000, 10000), 5
COLUMNS = 3  # of swatches, at most


def ticks(top: float) -> list[int]:
    """Return round values from 0 to at most `top`."""
    step = next((s for s in STEPS if top / s <= MOST), STEPS[-1])
    return list(range(0, int(top) + 1, step))


class ColorBar(QtGui.QWidget):
    """The scale with its values and the mark of the limit."""

    def __init__(self) -> None:
        super().__init__()
        self._scale = colors.Scale("engagement", 180.0)
        self.setMinimumHeight(int(ALL * self.fontMetrics().height()))

    def set_scale(self, scale: colors.Scale) -> None:
        """Show another scale."""
        self._scale = scale
        tip = f"0 - {scale.top:.0f} {self._unit or feed_unit()[1]}"
        if scale.mark is not None:
            limit = translate("SpiralPocket", "The mark is the limit at the step-over: {:.0f}°")
            tip += "\n" + limit.format(scale.mark)
        self.setToolTip(tip)
        self.update()

    def paintEvent(self, event: Any) -> None:  # noqa: N802 - the name Qt calls
        """Draw bar, values and mark."""
        painter = QtGui.QPainter(self)
        metrics, scale = self.fontMetrics(), self._scale
        text_color = self.palette().color(QtGui.QPalette.WindowText)
        left, right = metrics.height() // 2, self.width() - metrics.height()
        bar = QtCore.QRect(left, 2, right - left, int(BAR * metrics.height()))
        gradient = QtGui.QLinearGradient(left, 0, right, 0)
        for share, color in zip(np.linspace(0, 1, len(colors.SCALE)), colors.SCALE, strict=True):
            gradient.setColorAt(float(share), QtGui.QColor.fromRgbF(*(float(c) for c in color)))
        painter.fillRect(bar, QtGui.QBrush(gradient))
        painter.setPen(text_color)
        painter.drawRect(bar)
        base = bar.bottom() + metrics.ascent() + 5
        for value in ticks(scale.top):
            x = left + int(bar.width() * value / scale.top)
            painter.drawLine(x, bar.bottom(), x, bar.bottom() + 3)
            text = f"{value}{self._unit}"
            width = metrics.boundingRect(text).width()
            painter.drawText(max(0, min(x - width // 2, self.width() - width - 2)), base, text)
        if scale.mark is not None:
            x = left + int(bar.width() * min(1.0, scale.mark / scale.top))
            painter.fillRect(x - 2, bar.top() - 2, 5, bar.height() + 4, text_color)
            painter.fillRect(
                x - 1, bar.top() - 2, 3, bar.height() + 4, self.palette().color(QtGui.QPalette.Base)
            )
        painter.end()

    @property
    def _unit(self) -> str:
        return "°" if self._scale.quantity == "engagement" else ""


class Swatches(QtGui.QWidget):
    """Names the colors of what is not cut: lines as they are drawn, areas as squares."""

    def __init__(self) -> None:
        super().__init__()
        self._entries = (
            ("line", colors.ENTRY, translate("SpiralPocket", "entry")),
            ("line", colors.LINK, translate("SpiralPocket", "link")),
            ("dashes", colors.AIR, translate("SpiralPocket", "rapid")),
            ("area", colors.CLEARED, translate("SpiralPocket", "cleared")),
            ("area", colors.LEFT, translate("SpiralPocket", "left over")),
            ("area", colors.ISLAND, translate("SpiralPocket", "island")),
        )
        self.setMinimumWidth(self.widest)
        self.setMinimumHeight(self.height_of(COLUMNS))

    def resizeEvent(self, event: Any) -> None:  # noqa: N802 - the name Qt calls
        """Take the height of as many columns as there is room for."""
        self.setMinimumHeight(self.height_of(self.columns(self.width())))

    def height_of(self, columns: int) -> int:
        """Return how high all are in so many columns."""
        return int(-(-len(self._entries) // columns) * self._row)

    def columns(self, width: int) -> int:
        """Return how many columns there is room for."""
        return max(1, min(COLUMNS, width // self.widest))

    @property
    def _row(self) -> float:
        return 1.25 * self.fontMetrics().height()

    @property
    def widest(self) -> int:
        """Return how wide a column is at least, with some space on its left."""
        metrics = self.fontMetrics()
        widest = max(metrics.boundingRect(text).width() for _, _, text in self._entries)
        return widest + metrics.height() // 2 + 5 * metrics.ascent() // 2

    def paintEvent(self, event: Any) -> None:  # noqa: N802 - the name Qt calls
        """Draw all, in columns."""
        painter = QtGui.QPainter(self)
        metrics = self.fontMetrics()
        side, left = metrics.ascent(), metrics.height() // 2
        columns = self.columns(self.width())
        column = (self.width() - left) // columns
        for i, (kind, rgb, text) in enumerate(self._entries):
            x, y = left + i % columns * column, int(i // columns * self._row)
            color = QtGui.QColor.fromRgbF(*rgb)
            if kind == "area":
                painter.fillRect(x + (2 * side - side) // 2, y + 1, side, side, color)
            else:
                dashes = QtCore.Qt.DashLine if kind == "dashes" else QtCore.Qt.SolidLine
                painter.setPen(QtGui.QPen(color, 3, dashes, QtCore.Qt.FlatCap))
                middle = y + 1 + side // 2
                painter.drawLine(x, middle, x + 2 * side, middle)
            painter.setPen(self.palette().color(QtGui.QPalette.WindowText))
            painter.drawText(x + 2 * side + side // 2, y + metrics.ascent(), text)
        painter.end()
