# SPDX-License-Identifier: LGPL-2.1-or-later
"""The long way round: a smooth link through free ground where no single curve fits.

The shortest way over the coarsened raster of free ground becomes the control
polygon of a clamped cubic B-spline, tangent at both ends; the closer its control
points, the closer it keeps to that way.
"""

from __future__ import annotations

import numpy as np
import shapely
from scipy import ndimage
from shapely import LineString, Polygon

from .cleared import ClearedMap
from .model import Floats

#: Raster pixels to a cell of the coarse grid.
COARSE = 3
#: Longest chord of a link [mm].
CHORD = 0.12
#: Distances of control points tried, over R.
SPACINGS = (3.0, 2.0, 1.3, 0.8, 0.5)


def route(
    start: Floats,
    heading: Floats,
    end: Floats,
    arriving: Floats,
    cleared: ClearedMap,
    fence: Polygon,
    radius: float,
) -> Floats | None:
    """Return a smooth way through free ground, shape (n, 2) [mm]; None if there is none."""
    way = shortest_way(start, end, cleared)
    if way is None:
        return None
    line = LineString(way)
    for share in SPACINGS:
        count = max(2, int(np.ceil(line.length / (share * radius))))
        middle = shapely.get_coordinates(
            shapely.line_interpolate_point(
                line, np.linspace(0, 1, count + 1)[1:-1], normalized=True
            )
        )
        handle = min(share * radius, line.length / 3)
        controls = np.vstack(
            [start, start + handle * heading / 2, middle, end - handle * arriving / 2, end]
        )
        curve = _clamped(controls, max(97, int(line.length / CHORD)))
        if cleared.are_free(curve) and fence.covers(LineString(curve)):
            return curve
    return None


def _clamped(controls: Floats, count: int) -> Floats:
    from scipy.interpolate import BSpline  # takes a quarter second to load

    n = len(controls)
    degree = min(3, n - 1)
    knots = np.concatenate([np.zeros(degree), np.linspace(0, 1, n - degree + 1), np.ones(degree)])
    return BSpline(knots, controls, degree)(np.linspace(0, 1, count))


def shortest_way(start: Floats, end: Floats, cleared: ClearedMap) -> Floats | None:
    """Return the shortest way over the coarse grid, its ends replaced by the exact ones."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    free = cleared.near
    rows, columns = (n // COARSE for n in free.shape)
    blocks = free[: rows * COARSE, : columns * COARSE].reshape(rows, COARSE, columns, COARSE)
    open_ = blocks.all(axis=(1, 3))
    ids = np.arange(rows * columns).reshape(rows, columns)
    size = COARSE * cleared.pixel
    source = _nearest_open(start, open_, cleared, size)
    target = _nearest_open(end, open_, cleared, size)
    if source is None or target is None:
        return None
    heads, tails, weights = [], [], []
    clear = ndimage.distance_transform_edt(open_)
    for dr, dc in ((0, 1), (1, 0), (1, 1), (1, -1)):
        a = (slice(0, rows - dr), slice(max(0, -dc), columns - max(0, dc)))
        b = (slice(dr, rows), slice(max(0, dc), columns - max(0, -dc)))
        both = open_[a] & open_[b]
        heads.append(ids[a][both])
        tails.append(ids[b][both])
        # keep off the edge where that costs little
        weights.append(np.hypot(dr, dc) * (1 + 0.5 / np.minimum(clear[a], clear[b])[both]))
    graph = coo_array(
        (np.concatenate(weights), (np.concatenate(heads), np.concatenate(tails))),
        shape=(ids.size, ids.size),
    ).tocsr()
    distance, before = dijkstra(graph, directed=False, indices=source, return_predecessors=True)
    if not np.isfinite(distance[target]):
        return None
    path = [target]
    while path[-1] != source:
        path.append(int(before[path[-1]]))
    cells = np.array(path[::-1])
    centers = cleared.origin + size * np.column_stack(
        [cells % columns + 0.5, cells // columns + 0.5]
    )
    return np.vstack([start, centers[1:-1], end])


def _nearest_open(point: Floats, open_: np.ndarray, cleared: ClearedMap, size: float) -> int | None:
    column, row = ((point - cleared.origin) / size).astype(int)
    reach = 3
    r0, c0 = max(0, row - reach), max(0, column - reach)
    window = open_[r0 : row + reach + 1, c0 : column + reach + 1]
    r, c = np.nonzero(window)
    if len(r) == 0:
        return None
    k = int(np.argmin((r + r0 - row) ** 2 + (c + c0 - column) ** 2))
    return int((r[k] + r0) * open_.shape[1] + c[k] + c0)
