# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strokes: the cutting runs along the fronts, open from wall to wall or closed laps.

A stroke follows the boundary of a visited region where that boundary is new;
stock is on its right. Open strokes begin and end where the new front
leaves the old one, tangentially.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from ..model import Floats
from ..shapes.points import cross
from ..shapes.region import rings_of
from ..shapes.shaping import are_within
from .front_rules import NEW

#: Thinner strokes than this cut nothing worth a move [mm].
THINNEST = 0.015
#: Gaps shorter than this are cut through [mm]; a stroke begins so much early, before the rim ahead
#: meets stock, and ends so much late [mm].
GAP, LEAD, OVERRUN = 2.5, 0.8, 0.4
#: Longest chord of a stroke [mm].
CHORD = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Stroke:
    """One cutting run.

    Attributes
    ----------
    points : ndarray of shape (n, 2)
        In the direction of travel [mm]; of a closed lap the first is not repeated.
    level : int
        Index of the front that it follows.
    closed : bool
    exterior : bool
        Whether it runs along the outer boundary of the visited region.
    """

    points: Floats
    level: int
    closed: bool
    exterior: bool


def strokes_of(fronts: Sequence[Polygon]) -> list[Stroke]:
    """Return all strokes, level by level."""
    return [
        stroke
        for level in range(1, len(fronts))
        for stroke in strokes_between(fronts[level - 1], fronts[level], level)
    ]


def strokes_between(before: Polygon, after: Polygon, level: int) -> list[Stroke]:
    """Return the strokes from one front to the next, which is that of `level`."""
    return [
        Stroke(points, level, closed, i == 0)
        for i, ring in enumerate(rings_of(after))
        for points, closed in _new_runs(ring, before)
    ]


def _new_runs(ring: shapely.LinearRing, before: Polygon) -> list[tuple[Floats, bool]]:
    """Return the parts of a ring outside of `before`, and whether each is the whole ring."""
    points = shapely.get_coordinates(shapely.segmentize(ring, CHORD))[:-1]
    new = ~are_within(before, points, NEW)
    if not new.any():
        return []
    step = np.hypot(*(np.roll(points, -1, axis=0) - points).T)
    if new.all():
        return [(points, True)]
    first = int(np.flatnonzero(~new)[0])  # begin in a gap
    points, step = np.roll(points, -first, axis=0), np.roll(step, -first)
    new = np.roll(new, -first)
    along = np.concatenate([[0.0], np.cumsum(step)])
    merged = _merged(new, along)
    if merged is None:
        return [(points, True)]
    kept = []
    for a, b in merged:
        here = points[np.arange(a, b + 1) % len(points)]
        if not are_within(before, here, THINNEST).all():
            run = _overrun(points, along, float(along[-1]), a, b)
            kept.append((_without_needles(run), False))
    return kept


def _without_needles(points: Floats) -> Floats:
    """Return a stroke without places where it turns back upon itself.

    Along a wall cracks of a few micrometers stay between fronts, and a ring runs round them.
    """
    while len(points) > 2:
        before, here, after = points[:-2], points[1:-1], points[2:]
        to, onwards = here - before, after - here
        length = np.minimum(np.hypot(*to.T), np.hypot(*onwards.T))
        # how far apart the two ways are where the shorter one ends
        width = np.abs(cross(to, onwards)) / np.maximum(np.hypot(*to.T), np.hypot(*onwards.T))
        needles = ((to * onwards).sum(axis=1) < 0) & (width < NEW) & (length < LEAD)
        if not needles.any():
            break
        points = np.delete(points, 1 + int(np.flatnonzero(needles)[0]), axis=0)
    return points


def _merged(new: NDArray[np.bool_], along: Floats) -> list[list[int]] | None:
    """Return first and last index of each run of `new`, short gaps closed; None for the whole ring.

    The ring begins in a gap; a run that goes on through its beginning starts at a negative index.
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[0], new.astype(np.int8), [0]])))
    runs = [[a, b - 1] for a, b in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)]
    merged = [runs[0]]
    for run in runs[1:]:
        if along[run[0]] - along[merged[-1][1]] < GAP:
            merged[-1][1] = run[1]
        else:
            merged.append(run)
    if along[-1] - along[merged[-1][1]] + along[merged[0][0]] < GAP:
        if len(merged) == 1:
            return None
        last = merged.pop()
        merged[0] = [last[0] - len(new), merged[0][1]]
    return merged


def _overrun(points: Floats, along: Floats, total: float, a: int, b: int) -> Floats:
    """Return points a..b of a ring (a may be negative), run on along it at both ends."""
    n = len(points)
    begin = along[a % n] - (total if a < 0 else 0.0) - LEAD
    end = along[b % n] + OVERRUN
    index = np.arange(a - n, b + n + 1)
    s = along[index % n] + total * (index // n)
    inner = (s > begin + 1e-6) & (s < end - 1e-6)

    def at(where: float) -> Floats:
        closed = np.vstack([points, points[:1]])
        return np.array([np.interp(where % total, along, closed[:, i]) for i in (0, 1)])

    return np.vstack([at(begin), points[index[inner] % n], at(end)])
