# SPDX-License-Identifier: LGPL-2.1-or-later
"""In which order the strokes are cut, and how the cutter gets from one to the next.

A stroke may be cut when the strokes that it leans on are done. Among those that
may, the one whose link costs least time goes next. Links run through free
ground at depth; a lift is the last resort.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from scipy.spatial import cKDTree
from shapely import LineString, Polygon

from .cleared import ClearedMap
from .linking import Motion, hermite_links, link_times
from .model import Floats
from .routing import route
from .spiral import chains_of, closed_line, spiral_through
from .strokes import CHORD, Stroke

#: A stroke leans on strokes of lower levels within this many step-overs.
LEANS = 1.25
#: So many of the nearest ready runs are tried.
TRIED = 6
#: Points of a link as it is cut.
FINE = 97
#: A link that may not leave the region may still do so by this much [mm].
SLACK = 0.003


@dataclass(frozen=True, slots=True, eq=False)
class Run:
    """One or more strokes that are cut without a break.

    Attributes
    ----------
    points : ndarray of shape (n, 2)
    strokes : tuple of int
    needs : frozenset of int
        Indices of the runs that must be done before.
    """

    points: Floats
    strokes: tuple[int, ...]
    needs: frozenset[int]


@dataclass(frozen=True, slots=True, eq=False)
class Step:
    """A run with the way to it.

    Attributes
    ----------
    link : ndarray of shape (k, 2) or None
        None: lift, and go down again at the run's start.
    points : ndarray of shape (n, 2)
    """

    link: Floats | None
    points: Floats


def leanings(strokes: Sequence[Stroke], stepover: float) -> list[set[int]]:
    """Return for each stroke the strokes of lower levels that it leans on."""
    lines = np.array([LineString(s.points) for s in strokes], dtype=object)
    tree = shapely.STRtree(lines)
    pairs = tree.query(lines, predicate="dwithin", distance=LEANS * stepover)
    needs: list[set[int]] = [set() for _ in strokes]
    for i, j in pairs.T.tolist():
        if strokes[j].level < strokes[i].level:
            needs[i].add(j)
    return needs


def runs_of(
    strokes: Sequence[Stroke],
    fronts: Sequence[Polygon],
    ring: LineString,
    leave: float,
    radius: float,
    stepover: float,
) -> list[Run]:
    """Join strokes to runs: closed laps to spirals, the first of which begins on the entry's ring.

    Parameters
    ----------
    strokes : sequence of Stroke
    fronts : sequence of shapely.Polygon
    ring : LineString
        The entry's last lap, closed.
    leave : float
        Where the entry ends, along `ring` [mm].
    radius, stepover : float
        [mm]
    """
    needs = leanings(strokes, stepover)
    groups: list[list[int]] = []
    for chain in chains_of(strokes, len(fronts)):
        groups.append([])
        for i in chain:
            if groups[-1] and not needs[i] <= set(groups[-1]):
                groups.append([])
            groups[-1].append(i)
    chained = {i for group in groups for i in group}
    groups += [[i] for i in range(len(strokes)) if i not in chained]
    groups.sort(key=lambda group: group[0])
    home = {i: g for g, group in enumerate(groups) for i in group}
    runs = []
    for g, group in enumerate(groups):
        first = strokes[group[0]]
        if first.closed:
            if first.level == 1 and first.exterior:
                source, at = ring, leave
            else:
                source, at = _source(fronts[first.level - 1], first, radius)
            laps = [closed_line(strokes[i].points) for i in group]
            points = spiral_through(source, at, laps, radius)
        else:
            points = first.points
        before = frozenset(home[j] for i in group for j in needs[i]) - {g}
        runs.append(Run(points, tuple(group), before))
    return runs


def _source(before: Polygon, lap: Stroke, radius: float) -> tuple[LineString, float]:
    """Return the old front that a closed lap without predecessor grows from, and where to leave.

    It is left where the step to the lap is least.
    """
    rings = [before.exterior, *before.interiors]
    edge = np.vstack([shapely.get_coordinates(shapely.segmentize(r, CHORD)) for r in rings])
    steps, _ = cKDTree(edge).query(lap.points)
    best = lap.points[int(np.argmin(steps))]
    ring = min(rings, key=lambda r: r.distance(shapely.Point(best)))
    line = LineString(shapely.get_coordinates(ring))
    return line, (line.project(shapely.Point(best)) - 2 * radius) % line.length


def order(
    runs: Sequence[Run],
    cleared: ClearedMap,
    omega: Polygon,
    start: Floats,
    heading: Floats,
    motion: Motion,
    radius: float,
) -> list[Step]:
    """Return the runs in order, each with its link.

    Parameters
    ----------
    runs : sequence of Run
    cleared : ClearedMap
        Is used up.
    omega : shapely.Polygon
        The cutter-center region.
    start, heading : ndarray of shape (2,)
        Where the entry ends, and its direction there.
    motion : Motion
    radius : float
        R [mm].
    """
    fence = shapely.buffer(omega, SLACK)
    shapely.prepare(fence)
    starts = np.array([r.points[0] for r in runs])
    headings = np.array([_unit(r.points[1] - r.points[0]) for r in runs])
    waiting = [set(r.needs) for r in runs]
    open_runs = set(range(len(runs)))
    steps = []
    while open_runs:
        ready = sorted(i for i in open_runs if not waiting[i])
        near = np.argsort(np.hypot(*(starts[ready] - start).T), kind="stable")[:TRIED]
        tried = [ready[i] for i in near]
        link, chosen = _best_link(
            start, heading, tried, starts, headings, cleared, fence, motion, radius
        )
        run = runs[chosen]
        steps.append(Step(link, run.points))
        open_runs.remove(chosen)
        for needs in waiting:
            needs.discard(chosen)
        for stroke in run.strokes:
            cleared.finish(stroke)
        start, heading = run.points[-1], _unit(run.points[-1] - run.points[-2])
    return steps


def _unit(v: Floats) -> Floats:
    return v / (np.hypot(*v) + 1e-12)


def _best_link(
    start: Floats,
    heading: Floats,
    tried: list[int],
    starts: Floats,
    headings: Floats,
    cleared: ClearedMap,
    fence: Polygon,
    motion: Motion,
    radius: float,
) -> tuple[Floats | None, int]:
    """Return the fastest admissible link and the run that it leads to."""
    gaps = np.hypot(*(starts[tried] - start).T)
    for i, gap in zip(tried, gaps, strict=True):
        if gap < 1e-6:
            return np.empty((0, 2)), i
    paths = hermite_links(start, heading, starts[tried], headings[tried], radius)
    free = cleared.is_free(paths).all(axis=-1)
    times = np.where(free, link_times(paths, motion), np.inf)
    ranked = np.argsort(times, axis=None, kind="stable")
    for flat in ranked[:40]:
        m, h = np.unravel_index(flat, times.shape)
        if not np.isfinite(times[m, h]):
            break
        i = tried[int(m)]
        fine = hermite_links(start, heading, starts[[i]], headings[[i]], radius, FINE)[0, h]
        if fence.covers(LineString(fine)):
            return fine, i
    for m, i in enumerate(tried):
        found = route(start, heading, starts[i], headings[i], cleared, fence, radius)
        if found is not None:
            return found, tried[m]
    return None, tried[0]
