# SPDX-License-Identifier: LGPL-2.1-or-later
"""The long way round: a smooth link through free ground where no single curve fits.

The shortest way over the coarsened raster of free ground becomes the control
polygon of a clamped cubic B-spline, tangent at both ends; the closer its control
points, the closer it keeps to that way.
"""

from __future__ import annotations

import heapq
import math

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from .cleared import ClearedMap
from .filters import dilated
from .model import Floats
from .spiral import between

#: Raster pixels to a cell of the coarse grid.
COARSE = 3
#: Longest chord of a link [mm].
CHORD = 0.12
#: A way begins and ends in an open cell no more than so many cells away.
NEAR = 3
#: Distances of control points tried, over R.
SPACINGS = (3.0, 2.0, 1.3, 0.8, 0.5, 0.3)
#: How far the loops go that turn round, over R.
TURNS = (0.5, 1.0)
#: A step along the edge of free ground counts as longer by this share; farther from it by that
#: over the number of cells, up to so many.
EDGE_TOLL, OFF = 0.5, 6
#: So much longer than it is every step counts at least.
LEAST_TOLL = 1.0 + EDGE_TOLL / OFF
#: What is nearer than this to the slot that the entry cut is on it [mm].
ON_RING = 0.1
#: Steps to the cells around one, and their lengths.
NEIGHBORS = tuple(
    (dr, dc, math.hypot(dr, dc)) for dr in (-1, 0, 1) for dc in (-1, 0, 1) if dr or dc
)


def route(
    start: Floats,
    heading: Floats,
    end: Floats,
    arriving: Floats,
    cleared: ClearedMap,
    fence: Polygon,
    radius: float,
    least_radius: float = 0.0,
) -> Floats | None:
    """Return a smooth way through free ground, shape (n, 2) [mm]; None if there is none.

    Where it would bend more tightly than `least_radius` [mm], because it leads back from where the
    cutter comes or goes, it turns round in a loop if there is room for one.
    """
    # a way along the very edge is hard to follow smoothly
    closed = ~cleared.free
    for _ in range(COARSE):
        closed = dilated(closed)
    for ground in (~closed, cleared.free, cleared.near):
        way = shortest_way(start, end, cleared, ground)
        if way is None:
            continue
        found = _along(way, start, heading, end, arriving, cleared, fence, radius, least_radius)
        if found is not None:
            return found
    return None


def back_along_ring(
    start: Floats, end: Floats, cleared: ClearedMap, fence: Polygon
) -> Floats | None:
    """Return the way over the slot that the entry cut, the shorter way round; None if it is none.

    The cutter stops and turns where it leaves and where it arrives: from the end of an arm hardly
    wider than itself there is no other way back but to lift.

    Parameters
    ----------
    start, end : ndarray of shape (2,)
        [mm]
    cleared : ClearedMap
    fence : shapely.Polygon
        Is not left.
    """
    ring = cleared.ring
    if ring is None:
        return None
    off = shapely.distance(ring, shapely.points([start, end]))
    a, b = shapely.line_locate_point(ring, shapely.points([start, end])).tolist()
    onwards = (b - a) % ring.length
    if onwards < ring.length / 2:
        way = between(ring, a, onwards)
    else:
        way = between(ring, b, ring.length - onwards)[::-1]
    points = np.vstack([start, way, end])
    line = LineString(points[np.append(True, np.hypot(*np.diff(points, axis=0).T) > 1e-6)])
    if off.max() > ON_RING or not fence.covers(line):
        return None
    # the time of a link is told from its points
    return shapely.get_coordinates(shapely.segmentize(line, CHORD))


def _along(
    way: Floats,
    start: Floats,
    heading: Floats,
    end: Floats,
    arriving: Floats,
    cleared: ClearedMap,
    fence: Polygon,
    radius: float,
    least_radius: float,
) -> Floats | None:
    """Return a free curve near a way over the grid, tangent at both ends; None if none is free."""
    line = LineString(way)

    def curve(share: float, leaving: Floats, reaching: Floats) -> Floats | None:
        count = max(2, int(np.ceil(line.length / (share * radius))))
        middle = shapely.get_coordinates(
            shapely.line_interpolate_point(
                line, np.linspace(0, 1, count + 1)[1:-1], normalized=True
            )
        )
        controls = np.vstack([start, start + leaving, middle, end - reaching[::-1], end])
        points = clamped_spline(controls, max(97, int(line.length / CHORD)))
        is_free = cleared.are_free(points) and fence.covers(LineString(points))
        return points if is_free else None

    found = None
    for share in SPACINGS:
        handle = min(share * radius, line.length / 3) / 2
        found = curve(share, handle * heading[None], handle * arriving[None])
        if found is not None:
            break
    if found is None or tightest_bend(found) >= least_radius:
        return found
    for share in SPACINGS:
        turns = [
            curve(share, leaving, reaching)
            for leaving in _turns(heading, radius)
            for reaching in _turns(arriving, radius)
        ]
        smooth = [c for c in turns if c is not None and tightest_bend(c) >= least_radius]
        if smooth:
            return min(smooth, key=lambda points: LineString(points).length)
    return found


def _turns(heading: Floats, radius: float) -> list[Floats]:
    """Return the first control points after a place, straight on and round to both sides [mm]."""
    aside = np.array([-heading[1], heading[0]])
    wide = [np.vstack([w * heading, w * (heading + s * aside)]) for w in TURNS for s in (1, -1)]
    return [radius * turn for turn in [0.5 * heading[None], *wide]]


def tightest_bend(points: Floats) -> float:
    """Return the least radius of the circles through three points in a row [mm]."""
    a, b, c = points[:-2], points[1:-1], points[2:]
    ab, bc, ac = b - a, c - b, c - a
    area = np.abs(ab[:, 0] * bc[:, 1] - ab[:, 1] * bc[:, 0])
    sides = np.hypot(*ab.T) * np.hypot(*bc.T) * np.hypot(*ac.T)
    return float((sides / (2 * area + 1e-12)).min())


def clamped_spline(controls: Floats, count: int) -> Floats:
    """Return `count` points of a clamped cubic B-spline, by de Boor's algorithm."""
    n = len(controls)
    degree = min(3, n - 1)
    knots = np.concatenate([np.zeros(degree), np.linspace(0, 1, n - degree + 1), np.ones(degree)])
    u = np.linspace(0, 1, count)
    span = np.clip(np.searchsorted(knots, u, side="right") - 1, degree, n - 1)
    points = controls[span[:, None] + np.arange(-degree, 1)]
    for r in range(1, degree + 1):
        i = span[:, None] + np.arange(r - degree, 1)
        low, high = knots[i], knots[i + degree - r + 1]
        share = ((u[:, None] - low) / (high - low))[..., None]
        points = (1 - share) * points[:, :-1] + share * points[:, 1:]
    return points[:, 0]


def shortest_way(
    start: Floats, end: Floats, cleared: ClearedMap, free: NDArray[np.bool_]
) -> Floats | None:
    """Return the shortest way over the coarse grid of free pixels, between the exact ends."""
    rows, columns = (n // COARSE for n in free.shape)
    blocks = free[: rows * COARSE, : columns * COARSE].reshape(rows, COARSE, columns, COARSE)
    # closed all around, so that no step leads over the edge
    open_ = np.pad(blocks.all(axis=(1, 3)), 1)
    size = COARSE * cleared.pixel
    origin = cleared.origin - size
    source, target = (_nearest_open((p - origin) / size, open_) for p in (start, end))
    if source is None or target is None:
        return None
    path = _cheapest(_tolls(open_), source, target)
    if path is None:
        return None
    row, column = np.divmod(path, open_.shape[1])
    centers = origin + size * np.column_stack([column + 0.5, row + 0.5])
    return np.vstack([start, centers[1:-1], end])


def _tolls(open_: NDArray[np.bool_]) -> Floats:
    """Return by how much longer a step into each cell counts than it is; infinite where closed.

    Keeping off the edge of free ground is worth a little; farther from it than `OFF` cells
    nothing is gained any more.
    """
    off = np.zeros(open_.shape)
    closed = ~open_
    for _ in range(OFF):
        off += ~closed
        closed = dilated(closed)
    toll = np.full(open_.shape, np.inf)
    toll[open_] = EDGE_TOLL / off[open_]
    return toll


def _cheapest(tolls: Floats, source: int, target: int) -> list[int] | None:
    """Return the cells along the cheapest way from `source` to `target`; None if there is none.

    A*, with the distance as the crow flies for what lies ahead.

    Parameters
    ----------
    tolls : ndarray of shape (rows, columns)
        Infinite all around.
    source, target : int
        Indices into the raveled grid.
    """
    columns = tolls.shape[1]
    rows_off = (np.arange(tolls.shape[0]) - target // columns)[:, None]
    ahead = (LEAST_TOLL * np.hypot(rows_off, np.arange(columns) - target % columns)).ravel()
    ahead, toll = ahead.tolist(), tolls.ravel().tolist()
    neighbors = [(dr * columns + dc, step) for dr, dc, step in NEIGHBORS]
    gone = [math.inf] * len(toll)
    gone[source] = 0.0
    before: dict[int, int] = {}
    heap = [(0.0, source)]
    done = bytearray(len(toll))
    while heap:
        cell = heapq.heappop(heap)[1]
        if cell == target:
            path = [target]
            while path[-1] != source:
                path.append(before[path[-1]])
            return path[::-1]
        if done[cell]:
            continue
        done[cell] = 1
        so_far, here = gone[cell], 1.0 + toll[cell]
        for off, step in neighbors:
            other = cell + off
            there = 1.0 + toll[other]
            cost = so_far + step * (there if there > here else here)
            if cost < gone[other]:
                gone[other] = cost
                before[other] = cell
                heapq.heappush(heap, (cost + ahead[other], other))
    return None


def _nearest_open(place: Floats, open_: NDArray[np.bool_]) -> int | None:
    """Return the open cell nearest to a place in the grid, as an index; None if none is near."""
    column, row = place.astype(int)
    r0, c0 = max(0, row - NEAR), max(0, column - NEAR)
    r, c = np.nonzero(open_[r0 : row + NEAR + 1, c0 : column + NEAR + 1])
    if len(r) == 0:
        return None
    k = int(np.argmin((r + r0 - row) ** 2 + (c + c0 - column) ** 2))
    return int((r[k] + r0) * open_.shape[1] + c[k] + c0)
