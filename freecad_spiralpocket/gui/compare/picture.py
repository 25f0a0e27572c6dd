# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of one pocket's path from above, in the preview's colors."""

from __future__ import annotations

from typing import Any

import numpy as np
from PySide import QtCore, QtGui

from ...beside.tasks import Drawn
from ...engine.toolpath import Role
from ...trace import loaded_level
from ..preview import colors
from ..qt.theme import Theme

#: Colors of the scale that are told apart, and margin around the pocket in pixels.
SHADES, MARGIN = 24, 6
#: Heights closer than this are one level [mm].
_LEVEL = 1e-3


def picture_of(
    drawn: Drawn, scale: colors.Scale, size: Any, worn: Theme, fineness: float = 1.0
) -> QtGui.QPixmap:
    """Return the deepest level of a plan, but for a thin last one, as a picture.

    Parameters
    ----------
    drawn : Drawn
    scale : Scale
    size : QSize
        In the window's pixels.
    worn : Theme
        Of the window that it is shown in.
    fineness : float
        How many of the screen's pixels are one of the window's.
    """
    picture = QtGui.QPixmap(size * fineness)
    picture.setDevicePixelRatio(fineness)
    picture.fill(worn.background)
    walls = np.concatenate(drawn.areas.walls)
    low, high = walls.min(axis=0), walls.max(axis=0)
    room = np.array([size.width(), size.height()]) - 2 * MARGIN
    factor = float((room / np.maximum(high - low, 1e-9)).min())
    painter = QtGui.QPainter(picture)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.translate(size.width() / 2, size.height() / 2)
    painter.scale(factor, -factor)
    painter.translate(*(-(low + high) / 2).tolist())
    for rings, color, alpha in (
        (drawn.areas.left, colors.LEFT, 0.6),
        (drawn.areas.islands, colors.ISLAND, 0.6),
    ):
        painter.setPen(QtCore.Qt.NoPen)
        painter.setBrush(QtGui.QColor.fromRgbF(*color, alpha))
        for ring in rings:
            painter.drawPolygon(_polygon(ring))
    painter.setBrush(QtCore.Qt.NoBrush)
    _draw_path(painter, drawn, scale)
    painter.setPen(_pen(worn.text, 1.5))
    for wall in drawn.areas.walls:
        painter.drawPolygon(_polygon(wall))
    painter.end()
    return picture


def _draw_path(painter: Any, drawn: Drawn, scale: colors.Scale) -> None:
    trace = drawn.trace
    z = trace.points[:, 2]
    values, is_cut = scale.values(trace), colors.is_cut(trace)
    height = loaded_level(z[1:][is_cut], trace.angles[is_cut]) if is_cut.any() else z.min()
    shown = (np.abs(z[1:] - height) < _LEVEL) & (np.abs(z[:-1] - height) < _LEVEL)
    starts, ends = trace.points[:-1, :2], trace.points[1:, :2]
    flat = np.hypot(*(ends - starts).T) > _LEVEL
    shade = (values / scale.top * (SHADES - 1)).clip(0, SHADES - 1).astype(int)
    cut = is_cut & shown
    layers = [
        (shown & (trace.roles == Role.LINK), colors.LINK, 0.8),
        (flat & (trace.roles == Role.AIR), colors.AIR, 0.8),
        (trace.roles == Role.ENTRY, colors.ENTRY, 0.8),
    ]
    layers += [
        (cut & (shade == i), tuple(colors.colors_at(np.array([(i + 0.5) / SHADES]))[0]), 1.2)
        for i in range(SHADES)
    ]
    for chosen, color, width in layers:
        painter.setPen(_pen(QtGui.QColor.fromRgbF(*(float(c) for c in color)), width))
        lines = np.column_stack([starts, ends])[chosen].tolist()
        painter.drawLines([QtCore.QLineF(*line) for line in lines])


def _pen(color: Any, width: float) -> QtGui.QPen:
    pen = QtGui.QPen(color, width)
    pen.setCosmetic(True)
    return pen


def _polygon(ring: Any) -> QtGui.QPolygonF:
    return QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in ring.tolist()])
