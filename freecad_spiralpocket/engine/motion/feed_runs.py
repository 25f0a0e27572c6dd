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

from ..model import Floats
from ..numerics.distinct import distinct

Rungs = NDArray[np.int64]
#: A step this share too short is long enough: what it lacks would be lost in rounding, and it
#: would be cured for ever.
ROUNDING = 1e-9


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
    fine = distinct(np.r_[edges, low, high])
    values = rungs[np.searchsorted(edges, fine[:-1], side="right") - 1]
    first, last = np.searchsorted(fine, low), np.searchsorted(fine, high)
    for dip, i, j in zip(dips, first, last, strict=True):
        values[i:j] = np.minimum(values[i:j], rungs[dip])
    return fine, values


def _lower_short(edges: Floats, rungs: Rungs, least: float, ratio: float) -> tuple[Floats, Rungs]:
    """Return the step function without short steps between others, except dips.

    A short step goes down to its higher lower neighbor, or takes what it lacks from a higher
    neighbor that can spare it: whichever costs less time, the cheapest of all steps first.
    """
    steps = _Steps(edges, rungs, least, ratio)
    heap: list[tuple[float, int, int, float]] = []

    def offer(i: int) -> None:
        way = steps.cheapest_way(i)
        if way is not None:
            heapq.heappush(heap, way)

    for i in range(len(rungs)):
        offer(i)
    while heap:
        way = heapq.heappop(heap)
        _, i, j, _ = way
        # what changed in between has been offered again
        if steps.alive[i] and steps.alive[j] and steps.cheapest_way(i) == way:
            for k in steps.go(i, j):
                offer(k)
    return steps.result()


class _Steps:
    """A step function as a linked list of steps, while it is being changed."""

    def __init__(self, edges: Floats, rungs: Rungs, least: float, ratio: float) -> None:
        count = len(rungs)
        self.least, self.ratio = least, ratio
        self.start, self.end = edges[:-1].tolist(), edges[1:].tolist()
        self.rung = rungs.tolist()
        self.before = list(range(-1, count - 1))
        self.after = [*range(1, count), -1]
        self.alive = [True] * count

    def _near(self, i: int) -> list[int]:
        """Return the neighbors of step i."""
        return [j for j in (self.before[i], self.after[i]) if j >= 0]

    def cheapest_way(self, i: int) -> tuple[float, int, int, float] | None:
        """Return (cost, step, neighbor, length) of the best cure for a short step, or None."""
        length, slowness = self.end[i] - self.start[i], self.ratio ** -self.rung[i]
        if length >= self.least * (1 - ROUNDING):
            return None
        ways = []
        for j in self._near(i):
            other = self.ratio ** -self.rung[j]
            if self.rung[j] <= self.rung[i]:
                ways.append((length * (other - slowness), i, j, length))
            elif (self.end[j] - self.start[j]) - (self.least - length) >= self.least:
                ways.append(((self.least - length) * (slowness - other), i, j, length))
        lower = any(self.rung[j] <= self.rung[i] for j in self._near(i))
        return min(ways) if lower and ways else None

    def go(self, i: int, j: int) -> list[int]:
        """Cure step i with its neighbor j and return the steps to look at again."""
        if self.rung[j] > self.rung[i]:
            missing = self.least - (self.end[i] - self.start[i])
            if j == self.after[i]:
                self.end[i] = self.start[j] = self.end[i] + missing
            else:
                self.start[i] = self.end[j] = self.start[i] - missing
            return [j, *self._near(j)]
        self.rung[i] = self.rung[j]
        for k in self._near(i):
            if self.rung[k] == self.rung[i]:
                self._absorb(i, k)
        return [i, *self._near(i)]

    def _absorb(self, i: int, k: int) -> None:
        """Make neighbor k part of step i."""
        self.alive[k] = False
        if k == self.before[i]:
            self.start[i], self.before[i] = self.start[k], self.before[k]
            if self.before[i] >= 0:
                self.after[self.before[i]] = i
        else:
            self.end[i], self.after[i] = self.end[k], self.after[k]
            if self.after[i] >= 0:
                self.before[self.after[i]] = i

    def result(self) -> tuple[Floats, Rungs]:
        """Return the step function."""
        kept = sorted((i for i, is_alive in enumerate(self.alive) if is_alive), key=self._at)
        edges = [self.start[i] for i in kept] + [self.end[kept[-1]]]
        return np.array(edges), np.array([self.rung[i] for i in kept])

    def _at(self, i: int) -> float:
        """Return where step i begins."""
        return self.start[i]
