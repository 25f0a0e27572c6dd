# SPDX-License-Identifier: LGPL-2.1-or-later
"""A polyline as few lines and circular arcs, each within a tolerance of it.

Neighboring pieces are joined, pairwise and many at a time, for as long as one line or
one arc through first, middle and last point keeps to all points and to the middles of all
chords between them. Programs become several times shorter and run more
evenly on controllers that look few blocks ahead.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from ..numerics.ragged import rows_of
from .points import circumcenters, cross, distances_along

#: Arcs wider than this are lines [mm].
WIDEST = 2000.0
#: No arc turns farther than this [rad]: posts and controllers agree on what is left of a circle.
LARGEST_SWEEP = 0.9 * np.pi
#: No arc is longer than this over its chords: a path that turns back is no arc.
LONGEST = 1.01


@dataclass(frozen=True, slots=True, eq=False)
class Fitted:
    """Lines and arcs from point to point of a polyline.

    Attributes
    ----------
    ends : ndarray of int, shape (m,)
        The point at which each ends; the first begins at point 0.
    centers : ndarray of shape (m, 2)
        Of arcs [mm]; nan for lines.
    ccw : ndarray of bool, shape (m,)
    """

    ends: NDArray[np.intp]
    centers: Floats
    ccw: NDArray[np.bool_]


def fit_arcs(points: Floats, tolerance: float, begins: NDArray[np.intp] | None = None) -> Fitted:
    """Fit lines and arcs to polylines.

    Parameters
    ----------
    points : ndarray of shape (n, 2)
        Of one polyline or of several, one after the other; of each at least two, no two
        successive ones the same [mm].
    tolerance : float
        Largest distance of a piece from its polyline [mm].
    begins : ndarray of int, optional
        The first point of each polyline, ascending; without it there is only one.
    """
    along = distances_along(points)
    bounds = np.arange(len(points))
    is_first = np.zeros(len(points), bool)
    is_first[0 if begins is None else begins] = True
    is_end = is_first | np.roll(is_first, -1)
    # what cannot be left out: the ends, and where it was tried with the same neighbors
    settled = is_end.copy()
    parity = 1
    while not settled.all():
        index = np.arange(len(bounds))
        place = index - np.maximum.accumulate(np.where(is_first[bounds], index, 0))
        inner = index[~settled & (place % 2 == parity)]
        fits = _fit(points, along, bounds[inner - 1], bounds[inner + 1], tolerance)[0]
        settled[inner] = True
        out = inner[fits]
        settled[out - 1] = is_end[bounds[out - 1]]
        settled[out + 1] = is_end[bounds[out + 1]]
        bounds, settled = np.delete(bounds, out), np.delete(settled, out)
        parity = 1 - parity
    real = ~is_first[bounds[1:]]
    _, centers, ccw = _fit(points, along, bounds[:-1][real], bounds[1:][real], tolerance)
    return Fitted(bounds[1:][real], centers, ccw)


def _fit(
    points: Floats,
    along: Floats,
    begin: NDArray[np.intp],
    end: NDArray[np.intp],
    tolerance: float,
) -> tuple[NDArray[np.bool_], Floats, NDArray[np.bool_]]:
    """Return whether one line or arc does from each `begin` to `end`, its center, and its sense."""
    if len(begin) == 0:
        return np.zeros(0, bool), np.zeros((0, 2)), np.zeros(0, bool)
    a, b = points[begin], points[end]
    middle = np.searchsorted(along, (along[begin] + along[end]) / 2)
    c = points[np.clip(middle, begin + 1, np.maximum(end - 1, begin + 1))]
    centers = circumcenters(a, b, c)
    chord = b - a
    count = end - begin  # chords: the end of each, and its middle
    first = np.cumsum(count) - count
    row, place = rows_of(count)
    at = begin[row] + place
    x, y = points.T
    x, y = (
        np.stack([x[at + 1], (x[at] + x[at + 1]) / 2]),
        np.stack([y[at + 1], (y[at] + y[at + 1]) / 2]),
    )

    span = np.hypot(*chord.T)
    side = chord[row, 0] * (y - a[row, 1]) - chord[row, 1] * (x - a[row, 0])
    side = np.abs(side).max(axis=0) / np.maximum(span, 1e-12)[row]
    length = along[end] - along[begin]
    straight = (np.maximum.reduceat(side, first) <= tolerance) & (length <= LONGEST * span)

    radius = np.hypot(*(a - centers).T)
    with np.errstate(invalid="ignore", divide="ignore"):
        off = np.hypot(x - centers[row, 0], y - centers[row, 1]) - radius[row]
        half = np.arcsin(np.minimum(span / (2 * radius), 1.0))
        bent = np.maximum.reduceat(np.abs(off).max(axis=0), first) <= tolerance
        # chords are shorter than their arc; a way back and forth is much longer
        bent &= (length <= LONGEST * 2 * half * radius) & (2 * half < LARGEST_SWEEP)
        bent &= radius < WIDEST
    centers = np.where((bent & ~straight)[:, None], centers, np.nan)
    ccw = cross(c - a, b - c) > 0
    return straight | bent, centers, ccw
