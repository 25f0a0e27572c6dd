# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the cutter may go without cutting, as strokes are done one after the other.

A raster over the cutter-center region. Each pixel knows at which level the fronts
pass it; the pixels between two fronts fall into pieces, one or a few per stroke.
When a stroke is done its pieces become free ground. Tests of link candidates are
then array look-ups, thousands at a time.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from shapely import Polygon

from .model import Floats
from .strokes import Stroke


class ClearedMap:
    """The free ground of one cutter-center region.

    Parameters
    ----------
    fronts : sequence of shapely.Polygon
        Nested visited regions; the first is free from the start.
    strokes : sequence of Stroke
    region : shapely.Polygon
        The cutter-center region; ringed islands are holes here, filled in the fronts.
    pixel : float
        [mm]
    """

    def __init__(
        self, fronts: Sequence[Polygon], strokes: Sequence[Stroke], region: Polygon, pixel: float
    ) -> None:
        x0, y0, x1, y1 = fronts[-1].bounds
        self.pixel = pixel
        self.origin = np.array([x0 - 2 * pixel, y0 - 2 * pixel])
        self.shape = (int((y1 - y0) / pixel) + 5, int((x1 - x0) / pixel) + 5)
        level = np.full(self.shape, len(fronts), np.int32)
        for k in range(len(fronts) - 1, -1, -1):
            level[self.rasterize(fronts[k])] = k
        self._level = level
        self._pieces, self._piece_of = self._label(len(fronts))
        self._inside = ndimage.binary_dilation(self.rasterize(region))
        self._waiting, self._stroke_pieces = self._assign(strokes)
        # a piece that needs no stroke holds no stock: the cutter reached over it
        idle = self._waiting[self._pieces] == 0
        self.free = ndimage.binary_dilation((level < len(fronts)) & idle) & self._inside

    def rasterize(self, polygon: Polygon) -> NDArray[np.bool_]:
        """Return which pixel centers are inside a polygon, by parity along the rows."""
        flips = np.zeros((self.shape[0], self.shape[1] + 1), np.int8)
        for ring in (polygon.exterior, *polygon.interiors):
            points = (np.asarray(ring.coords) - self.origin) / self.pixel - 0.5
            a, b = points[:-1], points[1:]
            low = np.ceil(np.minimum(a[:, 1], b[:, 1])).astype(int)
            high = np.ceil(np.maximum(a[:, 1], b[:, 1])).astype(int)  # half open: low <= row < high
            counts = high - low
            edge = np.repeat(np.arange(len(a)), counts)
            offset = np.arange(len(edge)) - np.repeat(np.cumsum(counts) - counts, counts)
            row = low[edge] + offset
            share = (row - a[edge, 1]) / (b[edge, 1] - a[edge, 1])
            column = np.ceil(a[edge, 0] + share * (b[edge, 0] - a[edge, 0])).astype(int)
            np.add.at(flips, (row, np.clip(column, 0, self.shape[1])), 1)
        return (np.cumsum(flips[:, :-1], axis=1) & 1).astype(bool)

    def _label(self, n_levels: int) -> tuple[NDArray[np.int32], list[NDArray[np.intp]]]:
        """Return the piece of each pixel (0: none) and each piece's flat pixel indices."""
        pieces = np.zeros(self.shape, np.int32)
        count = 0
        for k in range(1, n_levels):
            labels, n = ndimage.label(self._level == k, structure=np.ones((3, 3)))
            pieces[labels > 0] = labels[labels > 0] + count
            count += n
        order = np.argsort(pieces, axis=None, kind="stable")
        bounds = np.searchsorted(pieces.ravel()[order], np.arange(count + 2))
        return pieces, [order[bounds[i] : bounds[i + 1]] for i in range(count + 1)]

    def _assign(self, strokes: Sequence[Stroke]) -> tuple[NDArray[np.int64], list[list[int]]]:
        """Return how many strokes each piece waits for, and the pieces of each stroke."""
        waiting = np.zeros(len(self._piece_of), np.int64)
        assigned = []
        for stroke in strokes:
            ahead = np.gradient(stroke.points, axis=0)
            ahead /= np.hypot(ahead[:, 0], ahead[:, 1])[:, None] + 1e-12
            left = np.column_stack([-ahead[:, 1], ahead[:, 0]])
            found: set[int] = set()
            for share in (0.6, 1.4):
                row, column = self.cells(stroke.points + share * self.pixel * left)
                here = self._level[row, column] == stroke.level
                found.update(np.unique(self._pieces[row, column][here]).tolist())
            found.discard(0)
            assigned.append(sorted(found))
            for piece in found:
                waiting[piece] += 1
        return waiting, assigned

    def cells(self, points: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Return row and column of each point's pixel, clipped to the raster."""
        cell = ((points - self.origin) / self.pixel).astype(int)
        row = np.clip(cell[..., 1], 0, self.shape[0] - 1)
        column = np.clip(cell[..., 0], 0, self.shape[1] - 1)
        return row, column

    def is_free(self, points: Floats) -> NDArray[np.bool_]:
        """Return which points, shape (..., 2) [mm], are free ground, within one pixel."""
        return self.free[self.cells(points)]

    def finish(self, stroke: int) -> None:
        """Free the pieces for which this stroke was the last one needed."""
        width = self.shape[1]
        for piece in self._stroke_pieces[stroke]:
            self._waiting[piece] -= 1
            if self._waiting[piece] == 0:
                cells = self._piece_of[piece]
                rows, columns = cells // width, cells % width
                for dr, dc in ((0, 0), (0, 1), (0, -1), (1, 0), (-1, 0)):
                    r = np.clip(rows + dr, 0, self.shape[0] - 1)
                    c = np.clip(columns + dc, 0, width - 1)
                    self.free[r, c] = self._inside[r, c]
