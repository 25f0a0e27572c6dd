# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nearest of many points, for many places at once, by sorting them into square cells.

The points of a row of cells lie in one stretch of the sorted order, so that a place
looks at three stretches: its own row of three cells and those above and below. Who
finds nothing that near asks a tree, which takes some ten times as long.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray

from ..model import Floats
from .distinct import distinct

#: So few pairs of point and place are all measured.
FEW = 30_000
#: Places whose distance is measured to all points, to choose the first cells by.
PROBES = 24
#: With more points in the nine cells about a place a tree is faster.
CROWD = 100
#: Pairs that are measured at once.
PORTION = 200_000


def nearest(
    points: Floats, places: Floats, within: float = np.inf
) -> tuple[Floats, NDArray[np.intp]]:
    """Return the distance to the nearest point for each place, and that point's index.

    Parameters
    ----------
    points : ndarray of shape (n, 2)
        At least one.
    places : ndarray of shape (k, 2)
    within : float
        Points farther than this are not looked for.

    Returns
    -------
    distances : ndarray of shape (k,)
        Infinite where no point is near enough.
    index : ndarray of int, shape (k,)
        0 where no point is near enough.
    """
    found = np.full(len(places), np.inf)
    index = np.zeros(len(places), np.intp)
    if len(places) == 0:
        return found, index
    if len(points) * len(places) <= FEW:
        squares = _squares(points, places)
        index = squares.argmin(axis=1)
        found = np.sqrt(squares.min(axis=1))
    else:
        size = within if np.isfinite(within) else _typical(points, places)
        looked = _within_cells(points, places, size, found, index)
        if not looked or size < within:
            asking = np.flatnonzero(found > size)
            tree = shapely.STRtree(shapely.points(points))
            hits = tree.query_nearest(shapely.points(places[asking]), all_matches=False)
            index[asking] = hits[1]
            found[asking] = np.hypot(*(points[index[asking]] - places[asking]).T)
    far = found > within
    found[far], index[far] = np.inf, 0
    return found, index


def _typical(points: Floats, places: Floats) -> float:
    """Return how far most places are from the points, about."""
    probes = places[:: max(1, len(places) // PROBES)]
    least = np.sort(_squares(points, probes).min(axis=1))
    return 1.01 * math.sqrt(least[math.ceil(0.8 * (len(least) - 1))]) + 1e-6


def _squares(points: Floats, places: Floats) -> Floats:
    """Return the square of the distance of each place to each point, shape (k, n) [mm2]."""
    x, y = (places[:, None, i] - points[:, i] for i in (0, 1))
    return np.asarray(x * x + y * y)


def _within_cells(
    points: Floats, places: Floats, size: float, found: Floats, index: NDArray[np.intp]
) -> bool:
    """Write distance and index of the nearest point in the nine cells about each place.

    Returns
    -------
    bool
        Whether it did: not where that would take longer than asking a tree.
    """
    low = points.min(axis=0)
    column, row = np.floor((points - low) / size).astype(np.int64).T
    width = int(column.max()) + 3
    key = row * width + column + 1
    order = np.argsort(key, kind="stable")
    key, sorted_points = key[order], points[order]
    at, rows = np.floor((places - low) / size).astype(np.int64).T
    begin, end = np.clip(at, 0, width - 1), np.clip(at + 2, 0, width - 1)
    rows = (rows[:, None] + np.arange(-1, 2)) * width
    first = np.searchsorted(key, rows + begin[:, None])
    last = np.searchsorted(key, rows + end[:, None], "right")
    total = np.cumsum((last - first).sum(axis=1))
    if total[-1] > CROWD * len(places):
        return False
    cuts = np.searchsorted(total, np.arange(PORTION, total[-1], PORTION)) + 1
    for a, b in pairwise(distinct(np.r_[0, cuts, len(places)]).tolist()):
        _measure(sorted_points, places, first, last, slice(a, b), found, index)
    index[:] = order[index]
    return True


def _measure(
    points: Floats,
    places: Floats,
    first: NDArray[np.intp],
    last: NDArray[np.intp],
    part: slice,
    found: Floats,
    index: NDArray[np.intp],
) -> None:
    """Write distance and index of the nearest candidate of each place in `part`."""
    begin = first[part].ravel()
    count = last[part].ravel() - begin
    ends = np.cumsum(count)
    if ends[-1] == 0:
        return
    candidate = np.arange(ends[-1]) + np.repeat(begin - (ends - count), count)
    each = count.reshape(-1, 3).sum(axis=1)
    here = np.flatnonzero(each)
    each = each[here]
    x, y = points[candidate].T
    px, py = places[part][here].T
    square = (x - np.repeat(px, each)) ** 2 + (y - np.repeat(py, each)) ** 2
    starts = np.cumsum(each) - each
    least = np.minimum.reduceat(square, starts)
    hits = np.flatnonzero(square == np.repeat(least, each))
    # the first of those that are equally near
    hits = hits[np.searchsorted(hits, starts)]
    found[part][here] = np.sqrt(least)
    index[part][here] = candidate[hits]
