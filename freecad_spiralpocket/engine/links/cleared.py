# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the cutter may go without cutting, as strokes are done one after the other.

A raster over the cutter-center region. Each pixel knows at which level the fronts
pass it, and so the stroke that frees it: the nearest one of that level. Tests of
link candidates are then array look-ups, thousands at a time.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from ..growth.strokes import Stroke
from ..model import Floats, PocketRequest
from ..numerics.filters import dilated
from ..numerics.nearest import nearest
from ..numerics.ragged import crossings_of
from ..shapes.region import rings_of

#: Raster pixels across the cutter.
PIXELS = 24
#: Pixels along the side of a block.
BLOCK = 4
#: Pixels from the ends of a path within which the edge of free ground is good enough.
ENDS = 3.0
#: A path bends by so much to either side at most over the first pixel [rad], and is looked at there
#: in so many places.
BENT, LOOKED_AT = np.radians(30.0), 5
#: What frees a pixel, if no stroke does: it is free from the start, or never.
START, NEVER = -1, -2


def pixel_of(request: PocketRequest) -> float:
    """Return the side of a pixel for the request's cutter [mm]."""
    return request.tool_diameter / PIXELS


class ClearedMap:
    """The free ground of one cutter-center region.

    Parameters
    ----------
    fronts : sequence of shapely.Polygon
        Nested visited regions; the first is free from the start.
    strokes : sequence of Stroke
    region : shapely.Polygon
        The cutter-center region; ringed islands are holes here, filled in the fronts.
    late : sequence of shapely.Polygon
        Ground inside the first front that only strokes of level ``len(fronts)`` free.
    reach : float
        Ground farther than this from all strokes of its level needs none [mm].
    pixel : float
        [mm]
    ring : LineString, optional
        Closed: along it the cutter has been, in however narrow a slot.
    begun : LineString, optional
        Runs may begin and end along it as well.
    """

    def __init__(
        self,
        fronts: Sequence[Polygon],
        strokes: Sequence[Stroke],
        region: Polygon,
        late: Sequence[Polygon],
        reach: float,
        pixel: float,
        ring: LineString | None = None,
        begun: LineString | None = None,
    ) -> None:
        x0, y0, x1, y1 = region.bounds
        self.pixel, self.reach, self.ring = pixel, reach, ring
        self.origin = np.array([x0 - 2 * pixel, y0 - 2 * pixel])
        self.shape = (int((y1 - y0) / pixel) + 5, int((x1 - x0) / pixel) + 5)
        self._beside = (1, -1, self.shape[1], -self.shape[1])
        self._freed_by: NDArray[np.int32] | None = None
        # the fronts are nested: who is in many of them was in early
        level = len(fronts) - self._turns(fronts)
        level[level == len(fronts)] += 1
        for zone in late:
            level[self.rasterize(zone) & (level == 0)] = len(fronts)
        inside = self.rasterize(region)
        owner = self._owners(level, strokes)
        order = np.argsort(owner, axis=None, kind="stable").astype(np.int32)
        bounds = np.searchsorted(owner.ravel()[order], np.arange(len(strokes) + 1))
        self._outside = ~inside.ravel()
        cells_of = [order[a:b] for a, b in pairwise(bounds)]
        self._cells_of = [cells[~self._outside[cells]] for cells in cells_of]
        self._strokes = strokes
        # ground that needs no stroke holds no stock: the cutter reached over it
        idle = owner < 0
        cleared = (level <= len(fronts)) & idle & inside
        #: Within a pixel of cleared ground: strokes begin and end on the very edge of it.
        self.near = dilated(cleared | self._along(ring) | self._along(begun))
        #: Cleared ground, and beside a wall the pixel that the wall cuts through.
        self.free = cleared | (dilated(cleared) & ~inside)

    def _along(self, ring: LineString | None) -> NDArray[np.bool_]:
        """Return the pixels that a line runs through."""
        through = np.zeros(self.shape, dtype=bool)
        if ring is not None:
            points = shapely.get_coordinates(shapely.segmentize(ring, 0.5 * self.pixel))
            through[self.cells(points)] = True
        return through

    def rasterize(self, polygon: Polygon) -> NDArray[np.bool_]:
        """Return which pixel centers are inside a polygon."""
        return self._turns([polygon]) != 0

    def _turns(self, polygons: Sequence[Polygon]) -> NDArray[np.int16]:
        """Return in how many of the polygons, counter-clockwise, each pixel's center is."""
        width = self.shape[1] + 1
        flips = np.zeros(self.shape[0] * width, np.int16)
        for polygon in polygons:
            ends, ring = shapely.get_coordinates(rings_of(polygon), return_index=True)
            points = (ends - self.origin) / self.pixel - 0.5
            points[:, 1] = np.clip(points[:, 1], 0, self.shape[0] - 1)
            same = ring[1:] == ring[:-1]
            a, b = points[:-1][same], points[1:][same]
            edge, row, x = crossings_of(a, b)
            column = np.ceil(x).astype(np.int64)
            # counter-clockwise, what is entered from the left is entered on the way down
            sign = np.where(a[edge, 1] > b[edge, 1], 1, -1).astype(np.int16)
            np.add.at(flips, row * width + np.clip(column, 0, width - 1), sign)
        return np.cumsum(flips.reshape(self.shape[0], width)[:, :-1], axis=1, dtype=np.int16)

    def _owners(self, level: NDArray[np.int16], strokes: Sequence[Stroke]) -> NDArray[np.int32]:
        """Return which stroke frees each pixel: the nearest of its level; -1 where none does."""
        owner = np.full(level.size, -1, np.int32)
        of_level: dict[int, list[int]] = {}
        for i, stroke in enumerate(strokes):
            of_level.setdefault(stroke.level, []).append(i)
        order = np.argsort(level, axis=None, kind="stable").astype(np.int32)
        bounds = np.searchsorted(level.ravel()[order], np.arange(max(of_level, default=0) + 2))
        for k, members in of_level.items():
            pixels = order[bounds[k] : bounds[k + 1]]
            if len(pixels):
                owner[pixels] = self._nearest_strokes(pixels, members, strokes)
        return owner.reshape(level.shape)

    def _nearest_strokes(
        self, pixels: NDArray[np.int32], members: list[int], strokes: Sequence[Stroke]
    ) -> NDArray[np.int32]:
        """Return the nearest of the member strokes for each pixel, -1 beyond the reach.

        Blocks of pixels are asked first. Where the answer is the same for all blocks around and
        surely within reach, it holds for each pixel of the block.
        """
        points = np.concatenate([strokes[i].points for i in members])
        which = np.repeat(np.array(members, np.int32), [len(strokes[i].points) for i in members])
        row, column = np.divmod(pixels, self.shape[1])
        across = self.shape[1] // BLOCK + 3
        block, of = np.unique(
            (row // BLOCK + 1) * across + column // BLOCK + 1, return_inverse=True
        )
        middles = np.column_stack([block % across - 1, block // across - 1]) + 0.5
        slack = 0.75 * BLOCK * self.pixel  # more than half a diagonal
        places = self.origin + BLOCK * self.pixel * middles
        distance, index = nearest(points, places, self.reach + slack)
        found = np.where(np.isfinite(distance), which[index], -1)
        alike = np.abs(distance - self.reach) > slack
        if len(members) > 1:
            for step in (1, across - 1, across, across + 1):
                at = np.minimum(np.searchsorted(block, block + step), len(block) - 1)
                differs = (block[at] == block + step) & (found[at] != found)
                alike &= ~differs
                alike[at[differs]] = False
        result = found[of.ravel()]
        doubtful = np.flatnonzero(~alike[of.ravel()])
        places = np.column_stack([column[doubtful], row[doubtful]]) + 0.5
        distance, index = nearest(points, self.origin + self.pixel * places, self.reach)
        result[doubtful] = np.where(np.isfinite(distance), which[index], -1)
        return result

    def cells(self, points: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Return row and column of each point's pixel, clipped to the raster; points are in mm."""
        cell = ((points - self.origin) / self.pixel).astype(int)
        row = np.clip(cell[..., 1], 0, self.shape[0] - 1)
        column = np.clip(cell[..., 0], 0, self.shape[1] - 1)
        return row, column

    def are_free(self, paths: Floats) -> NDArray[np.bool_]:
        """Return which paths, shape (..., n, 2) [mm], keep to free ground.

        At both ends, for a few pixels, the edge of free ground is good enough.
        """
        cells = self.cells(paths)
        at_end = self._are_at_ends(paths)
        return np.asarray((self.free[cells] | (at_end & self.near[cells])).all(axis=-1))

    def are_open(self, places: Floats, headings: Floats) -> NDArray[np.bool_]:
        """Return from which places a path may begin, its first pixel being free or the edge of it.

        Where none may none needs to be looked for, but for one that turns back on the spot.

        Parameters
        ----------
        places, headings : ndarray of shape (n, 2)
            Where paths would begin [mm], and the unit directions there.
        """
        sine, cosine = np.sin(BENT), np.cos(BENT)
        aside = sine * np.column_stack([-headings[:, 1], headings[:, 0]])
        ways = np.stack([headings, cosine * headings + aside, cosine * headings - aside])
        ahead = np.linspace(0.0, self.pixel, LOOKED_AT)[:, None]
        passed = self.near[self.cells(places[:, None] + ahead * ways[..., None, :])]
        return np.asarray(passed.all(axis=-1).any(axis=0))

    def _are_at_ends(self, paths: Floats) -> NDArray[np.bool_]:
        """Return which points are near one of the ends of their path."""
        from_start = np.hypot(*np.moveaxis(paths - paths[..., :1, :], -1, 0))
        from_end = np.hypot(*np.moveaxis(paths - paths[..., -1:, :], -1, 0))
        return np.asarray(np.minimum(from_start, from_end) < ENDS * self.pixel)

    def needed(self, paths: Floats) -> NDArray[np.int32]:
        """Return which stroke must be done at each point of paths, shape (..., n, 2) [mm].

        `START` or `NEVER` where none does; `START` too near both ends, see `are_free`.

        Returns
        -------
        ndarray of int, shape (..., n)
        """
        if self._freed_by is None:
            self._freed_by = self._who_frees()
        freed_by = self._freed_by[self.cells(paths)]
        freed_by[self._are_at_ends(paths)] = START
        return freed_by

    def _who_frees(self) -> NDArray[np.int32]:
        """Return which stroke frees each pixel; beside a wall one of those that do."""
        freed_by = np.full(self.free.size, NEVER, np.int32)
        for stroke, cells in enumerate(self._cells_of):
            beside = np.concatenate([cells + step for step in self._beside])
            freed_by[beside[self._outside[beside]]] = stroke
            freed_by[cells] = stroke
        freed_by[self.free.ravel()] = START
        return freed_by.reshape(self.shape)

    def copied(self) -> ClearedMap:
        """Return a map on which other strokes may be done than on this."""
        other = copy.copy(self)
        other.free, other.near = self.free.copy(), self.near.copy()
        return other

    def finish(self, stroke: int) -> None:
        """Free the ground of a stroke that is done."""
        cells, free, near = self._cells_of[stroke], self.free.ravel(), self.near.ravel()
        free[cells] = near[cells] = True
        # where it ends on ground of another's the cutter has been all the same
        if not self._strokes[stroke].closed:
            near[self._along(LineString(self._strokes[stroke].points)).ravel()] = True
        for step in self._beside:
            beside = cells + step
            near[beside] = True
            free[beside[self._outside[beside]]] = True
