# SPDX-License-Identifier: LGPL-2.1-or-later
"""Few long runs of equal feed instead of many short ones.

Feeds are rungs of a ladder; a step function gives the rung along one stretch of path. A dip
that is too short is widened, everything else that is too short is lowered to its higher
neighbor, so the result is nowhere above what it came from.
"""

from __future__ import annotations

import heapq

import numpy as np
from numpy.typing import NDArray

from .model import Floats

Rungs = NDArray[np.int64]


def lengthen_runs(edges: Floats, rungs: Rungs, least: float, ratio: float) -> tuple[Floats, Rungs]:
    """Lower a step function until no step is short.

    Parameters
    ----------
    edges : ndarray of shape (n + 1,)
        Ascending stations at which the steps begin and end [mm].
    rungs : ndarray of int, shape (n,)
        Of each step; the feed is proportional to ``ratio ** rung``.
    least : float
        Least length of a step [mm].
    ratio : float
        Above 1.

    Returns
    -------
    edges : ndarray of shape (m + 1,)
    rungs : ndarray of int, shape (m,)
        Neighbors differ. A step is shorter than `least` only between higher ones that end with
        the stretch, or if it is all there is.

    Notes
    -----
    O(n log n).
    """
    edges, rungs = _join_equal(edges, rungs)
    edges, rungs = _join_equal(*_widen_dips(edges, rungs, least))
    return _lower_short(edges, rungs, least, ratio)


def _join_equal(edges: Floats, rungs: Rungs) -> tuple[Floats, Rungs]:
    """Return the step function with equal neighbors as one."""
    keep = np.r_[True, np.diff(rungs) != 0]
    return np.r_[edges[:-1][keep], edges[-1]], rungs[keep]


def _widen_dips(edges: Floats, rungs: Rungs, least: float) -> tuple[Floats, Rungs]:
    """Return the step function with its short local minima widened evenly to both sides."""
    lengths = np.diff(edges)
    below_last = np.r_[True, rungs[1:] < rungs[:-1]]
    below_next = np.r_[rungs[:-1] < rungs[1:], True]
    dips = np.flatnonzero(below_last & below_next & (lengths < least))
    if not len(dips):
        return edges, rungs
    more = (least - lengths[dips]) / 2
    low, high = edges[dips] - more, edges[dips + 1] + more
    # what would stick out at one end of the stretch goes to the other side
    low, high = low - np.maximum(0.0, high - edges[-1]), high + np.maximum(0.0, edges[0] - low)
    low, high = np.maximum(low, edges[0]), np.minimum(high, edges[-1])
    fine = np.unique(np.r_[edges, low, high])
    values = rungs[np.searchsorted(edges, fine[:-1], side="right") - 1]
    first, last = np.searchsorted(fine, low), np.searchsorted(fine, high)
    for dip, i, j in zip(dips, first, last, strict=True):
        values[i:j] = np.minimum(values[i:j], rungs[dip])
    return fine, values


def _lower_short(edges: Floats, rungs: Rungs, least: float, ratio: float) -> tuple[Floats, Rungs]:
    """Return the step function with short steps lowered to their higher neighbor.

    The one that costs the least time goes first.
    """
    count = len(rungs)
    start, end, rung = edges[:-1].tolist(), edges[1:].tolist(), rungs.tolist()
    before, after = list(range(-1, count - 1)), [*range(1, count), -1]
    alive = [True] * count
    heap: list[tuple[float, int, float, int]] = []

    def offer(i: int) -> None:
        lower = [rung[j] for j in (before[i], after[i]) if j >= 0 and rung[j] <= rung[i]]
        length = end[i] - start[i]
        if lower and length < least:
            cost = length * (ratio ** -max(lower) - ratio ** -rung[i])
            heapq.heappush(heap, (cost, i, length, max(lower)))

    for i in range(count):
        offer(i)
    while heap:
        _, i, length, target = heapq.heappop(heap)
        if not alive[i] or length != end[i] - start[i] or target > rung[i]:
            continue
        near = [j for j in (before[i], after[i]) if j >= 0 and rung[j] <= rung[i]]
        if not near or max(rung[j] for j in near) != target:
            continue
        rung[i] = target
        for j in near:
            if rung[j] == target:
                alive[j] = False
                start[i], end[i] = min(start[i], start[j]), max(end[i], end[j])
                if j == before[i]:
                    before[i] = before[j]
                    if before[i] >= 0:
                        after[before[i]] = i
                else:
                    after[i] = after[j]
                    if after[i] >= 0:
                        before[after[i]] = i
        for j in (before[i], i, after[i]):
            if j >= 0:
                offer(j)
    kept = [i for i in range(count) if alive[i]]
    kept.sort(key=start.__getitem__)
    new_edges = np.array([*(start[i] for i in kept), edges[-1]])
    return new_edges, np.array([rung[i] for i in kept])
