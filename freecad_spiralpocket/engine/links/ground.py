# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shortest ways from one place over free ground, on the coarsened raster of it."""

from __future__ import annotations

import heapq
import math
from array import array

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from ..numerics.filters import dilated, patches_of
from .cleared import ClearedMap

#: Raster pixels to a cell of the coarse grid.
COARSE = 3
#: A way begins and ends in an open cell no more than so many cells away.
NEAR = 3
#: A step along the edge of free ground counts as longer by this share; farther from it by that
#: over the number of cells, up to so many.
EDGE_TOLL, OFF = 0.5, 6
#: So much longer than it is every step counts at least.
LEAST_TOLL = 1.0 + EDGE_TOLL / OFF
#: Steps to the cells around one, and their lengths.
NEIGHBORS = tuple(
    (dr, dc, math.hypot(dr, dc)) for dr in (-1, 0, 1) for dc in (-1, 0, 1) if dr or dc
)


class Ground:
    """Free ground as it is now, in coarse cells, and a place on it.

    Parameters
    ----------
    cleared : ClearedMap
    free : ndarray of bool
        Which pixels of it are free.
    start : ndarray of shape (2,)
        Where all ways begin [mm].
    coarse : int
        Raster pixels to a cell: what is narrower than that is no way.
    hopeful : bool
        Open is each cell with a free pixel, and one step is as good as another: where such ground
        has no way none has one, and no way is much shorter than those over it.
    """

    def __init__(
        self,
        cleared: ClearedMap,
        free: NDArray[np.bool_],
        start: Floats,
        coarse: int = COARSE,
        *,
        hopeful: bool = False,
    ) -> None:
        rows, columns = (n // coarse for n in free.shape)
        blocks = free[: rows * coarse, : columns * coarse].reshape(rows, coarse, columns, coarse)
        # closed all around, so that no step leads over the edge
        self._open = np.pad((blocks.any if hopeful else blocks.all)(axis=(1, 3)), 1)
        self._size = coarse * cleared.pixel
        self._origin = cleared.origin - self._size
        self._start = start
        self._source = self._cell(start)
        self._hopeful = hopeful
        self._patches: NDArray[np.intp] | None = None
        self._tolls: array[float] | None = None

    def way_to(self, end: Floats, longest: float = math.inf) -> Floats | None:
        """Return the shortest way to a place, shape (n, 2) [mm].

        None if there is none, and perhaps where all are longer than `longest` [mm].
        """
        target = self._cell(end)
        if self._source is None or target is None:
            return None
        if self._patches is None:
            self._patches = patches_of(self._open).ravel()
        if self._patches[self._source] != self._patches[target]:
            return None
        dearest = (LEAST_TOLL if self._hopeful else 1.0 + EDGE_TOLL) * longest / self._size
        path = self._cheapest(self._source, target, dearest)
        if path is None:
            return None
        row, column = np.divmod(path, self._open.shape[1])
        centers = self._origin + self._size * np.column_stack([column + 0.5, row + 0.5])
        return np.vstack([self._start, centers[1:-1], end])

    def _cheapest(self, source: int, target: int, dearest: float) -> list[int] | None:
        """Return the cells along the cheapest way; None if there is none up to `dearest`.

        A*, with the distance as the crow flies for what lies ahead.
        """
        rows, columns = self._open.shape
        rows_off = (np.arange(rows) - target // columns)[:, None]
        off = np.hypot(rows_off, np.arange(columns) - target % columns)
        if self._tolls is None:
            cells = np.where(self._open, OFF, 0) if self._hopeful else _cells_off(self._open)
            with np.errstate(divide="ignore"):
                self._tolls = array("d", (EDGE_TOLL / cells).tobytes())
        # lists would take four times the memory, 250 MB for a plate of 350 mm pixel by pixel
        ahead, toll = array("d", (LEAST_TOLL * off).tobytes()), self._tolls
        neighbors = [(dr * columns + dc, step) for dr, dc, step in NEIGHBORS]
        gone = [math.inf] * len(toll)
        gone[source] = 0.0
        before = array("i", bytes(4 * len(toll)))
        heap = [(0.0, source)]
        done = bytearray(len(toll))
        while heap:
            least, cell = heapq.heappop(heap)
            if least > dearest:
                return None
            if cell == target:
                path = [target]
                while path[-1] != source:
                    path.append(before[path[-1]])
                return path[::-1]
            if done[cell]:
                continue
            done[cell] = 1
            so_far, here = gone[cell], 1.0 + toll[cell]
            for step_to, step in neighbors:
                other = cell + step_to
                there = 1.0 + toll[other]
                cost = so_far + step * (there if there > here else here)
                if cost < gone[other]:
                    gone[other] = cost
                    before[other] = cell
                    heapq.heappush(heap, (cost + ahead[other], other))
        return None

    def _cell(self, place: Floats) -> int | None:
        """Return the open cell nearest to a place, as an index; None if none is near."""
        column, row = ((place - self._origin) / self._size).astype(int)
        r0, c0 = max(0, row - NEAR), max(0, column - NEAR)
        r, c = np.nonzero(self._open[r0 : row + NEAR + 1, c0 : column + NEAR + 1])
        if len(r) == 0:
            return None
        k = int(np.argmin((r + r0 - row) ** 2 + (c + c0 - column) ** 2))
        return int((r[k] + r0) * self._open.shape[1] + c[k] + c0)


def _cells_off(open_: NDArray[np.bool_]) -> Floats:
    """Return how many cells each is off the edge of free ground, at most `OFF`; 0 where closed.

    Keeping off that edge is worth a little; farther from it nothing is gained any more.
    """
    off = np.zeros(open_.shape)
    closed = ~open_
    for _ in range(OFF):
        off += ~closed
        closed = dilated(closed)
    return off
