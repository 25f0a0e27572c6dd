# SPDX-License-Identifier: LGPL-2.1-or-later
"""A slow planner with jerk limits: sequential linear programs over speed squared.

On a fine grid of the arc length, with w the speed squared: ``|w'| <= 2 a``,
``|sqrt(w) w''| <= 2 J``, ``w <= cap``. The time's derivative and the square root are taken
from the last solution until it stays the same. Starts and ends without acceleration.
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import diags_array, vstack

CELLS, ROUNDS, SETTLED = 300, 20, 0.1  # -, -, mm/s


def fastest_time(
    tops: np.ndarray, lengths: np.ndarray, end_speed: float, acceleration: float, jerk: float
) -> float:
    """Return the time [s] over blocks with speed limits, from and to `end_speed`."""
    total = lengths.sum()
    h, s = total / CELLS, np.linspace(0.0, total, CELLS + 1)
    ends = np.cumsum(lengths)
    left, right = (np.minimum(np.searchsorted(ends, s + e), len(tops) - 1) for e in (-1e-9, 1e-9))
    cap = np.minimum(tops[left], tops[right]) ** 2
    cap[[0, -1]] = end_speed**2
    first = diags_array([-1.0, 1.0], offsets=[0, 1], shape=(CELLS, CELLS + 1)) / h
    second = diags_array([1.0, -2.0, 1.0], offsets=[0, 1, 2], shape=(CELLS - 1, CELLS + 1)) / h**2
    slopes = np.full(CELLS, 2 * acceleration)
    slopes[[0, -1]] = min(2 * acceleration, jerk * h / end_speed)
    matrix = vstack([first, -first, second, -second])
    rise = 2 * acceleration * s
    w = np.minimum.accumulate(cap - rise) + rise
    w = np.minimum.accumulate((w + rise)[::-1])[::-1] - rise
    for round_ in range(ROUNDS):
        bends = 2 * jerk / np.sqrt(np.maximum(w[1:-1], 1.0))
        answer = linprog(
            -h / (2 * np.maximum(w, 1.0) ** 1.5),
            A_ub=matrix,
            b_ub=np.concatenate([slopes, slopes, bends, bends]),
            bounds=np.column_stack([np.ones(CELLS + 1), cap + 1e-9]),
            method="highs",
        )
        new = answer.x if round_ < 3 else (w + answer.x) / 2
        change = np.abs(np.sqrt(new) - np.sqrt(w)).max()
        w = new
        if change < SETTLED:
            break
    v = np.sqrt(w)
    return float((2 * h / (v[1:] + v[:-1])).sum())
