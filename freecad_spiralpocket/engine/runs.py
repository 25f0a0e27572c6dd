# SPDX-License-Identifier: LGPL-2.1-or-later
"""Few long runs of equal feed instead of many short ones."""

from __future__ import annotations

import heapq

import numpy as np
from numpy.typing import NDArray

from .model import Floats


def merge_short_runs(
    rungs: NDArray[np.int64],
    lengths: Floats,
    groups: NDArray[np.int64],
    least: float,
    ratio: float,
) -> NDArray[np.int64]:
    """Lower rungs so that runs of equal ones are not short.

    Of all runs that are shorter than `least`, the one that can join a neighbor at the least
    cost of time does so first, both at the lower rung.

    Parameters
    ----------
    rungs : ndarray of int, shape (n,)
        Largest allowed rung of each piece; the feed is proportional to ``ratio ** rung``.
    lengths : ndarray of shape (n,)
        Of the pieces [mm].
    groups : ndarray of int, shape (n,)
        Runs end where this changes.
    least : float
        Least length of a run [mm]; only a whole group may be shorter.
    ratio : float
        Above 1.

    Returns
    -------
    ndarray of int, shape (n,)
        Nowhere above `rungs`.

    Notes
    -----
    O(n log n).
    """
    if len(rungs) == 0:
        return rungs
    starts = np.flatnonzero(np.r_[True, (np.diff(rungs) != 0) | (np.diff(groups) != 0)])
    count = len(starts)
    rung = rungs[starts].tolist()
    length = np.add.reduceat(lengths, starts).tolist()
    group = groups[starts].tolist()
    before = list(range(-1, count - 1))
    after = [*range(1, count), -1]
    owner = list(range(count))

    def offer(i: int) -> None:
        """Queue the cheaper of the two ways in which run i can join a neighbor."""
        if length[i] >= least:
            return
        ways = []
        for j in (before[i], after[i]):
            if j >= 0 and group[j] == group[i]:
                high = i if rung[i] > rung[j] else j
                lost = length[high] * (ratio ** -min(rung[i], rung[j]) - ratio ** -rung[high])
                ways.append((lost, i, j, rung[i], rung[j], length[i], length[j]))
        if ways:
            heapq.heappush(heap, min(ways))

    heap: list[tuple[float, int, int, int, int, float, float]] = []
    alive = [True] * count
    for i in range(count):
        offer(i)
    while heap:
        _, i, j, rung_i, rung_j, length_i, length_j = heapq.heappop(heap)
        if not (alive[i] and alive[j]) or (rung_i, rung_j, length_i, length_j) != (
            rung[i],
            rung[j],
            length[i],
            length[j],
        ):
            continue
        left, right = min(i, j), max(i, j)
        alive[right], owner[right] = False, left
        rung[left], length[left] = min(rung_i, rung_j), length_i + length_j
        after[left] = after[right]
        if after[right] >= 0:
            before[after[right]] = left
        for k in (before[left], left, after[left]):
            if k >= 0:
                offer(k)
    for i in range(count):  # an owner is always to the left, so its own owner is known
        owner[i] = owner[owner[i]]
    final = np.array([rung[owner[i]] for i in range(count)])
    return np.repeat(final, np.diff(np.r_[starts, len(rungs)]))
