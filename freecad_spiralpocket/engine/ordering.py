# SPDX-License-Identifier: LGPL-2.1-or-later
"""In which order the strokes are cut, and how the cutter gets from one to the next.

A stroke may be cut when the strokes that it leans on are done. Among those that
may, the one whose link costs least time goes next. Links run through free
ground at depth; a lift is the last resort.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import shapely
from shapely import LineString, Point, Polygon
from shapely.ops import substring

from .cleared import ClearedMap
from .linking import Motion, are_nervous, fine_link, hermite_links, link_times
from .model import Floats
from .polyline import points_at
from .routing import LongWays, back_along_ring
from .shaping import Region, buffer
from .spiral import (
    chains_of,
    closed_line,
    ends_of,
    gaps,
    onward,
    spiral_through,
    without_air,
    zone_length,
    zone_size,
    zones,
)
from .strokes import Stroke

#: A stroke leans on strokes of lower levels within this many step-overs.
LEANS = 1.25
#: Strokes are compared in pieces of so many points.
CHUNK = 24
#: So many of the nearest ready runs are tried at a time.
TRIED = 8
#: To so many of the nearest a longer way round is sought where no plain link fits.
ROUTED = 6
#: A spiral goes on to the next lap where that is no farther than this over the step-over.
WIDEST = 1.3
#: And no farther than this over R, for else a cusp may stay between two turns.
WITHOUT_CUSPS = 1.6
#: So many of a spiral's last laps are looked at for what they leave: in its zone each lags behind.
LAST = 3
#: The same about a plug: where it is farther there the plug's corners are rounded.
WIDEST_INWARDS = 2.2
#: So many of the fastest links are checked point by point.
CHECKED = 160
#: Points of a link as it is cut.
FINE = 193
#: A run that begins so near to where the last one ended needs no link [mm]; it would be a hairpin.
TOUCHES = 0.03
#: A stroke that begins so far behind, on the way that the cutter has come, is gone on with [mm]:
#: a lead and an overrun; onto it within so much, where its direction differs by no more than has
#: this cosine.
OVERLAP, ONTO, ONWARD = 1.3, 0.3, 0.98
#: A link that may not leave the region may still do so by this much [mm].
SLACK = 0.003
#: A first lap outwards may be farther from the place where the entry ends, by this factor.
LEFT_BEHIND = 1.5


@dataclass(frozen=True, slots=True, eq=False)
class Run:
    """One or more strokes that are cut without a break.

    Attributes
    ----------
    strokes : tuple of int
    ways : tuple of Callable
        Each returns the points of one way to cut it, shape (n, 2) [mm]: a spiral may be begun in
        several places.
    starts, headings : ndarray of shape (len(ways), 2)
        Where each way begins, and the unit direction there.
    needs : frozenset of int
        Indices of the runs that must be done before.
    """

    strokes: tuple[int, ...]
    ways: tuple[Callable[[], Floats], ...]
    starts: Floats
    headings: Floats
    needs: frozenset[int] = frozenset()


@dataclass(frozen=True, slots=True, eq=False)
class Step:
    """A run with the way to it.

    Attributes
    ----------
    link : ndarray of shape (k, 2) or None
        None: lift, and go down again at the run's start.
    points : ndarray of shape (n, 2)
    run : int
        Its index.
    """

    link: Floats | None
    points: Floats
    run: int


def leanings(strokes: Sequence[Stroke], stepover: float) -> list[set[int]]:
    """Return for each stroke the strokes of lower levels that it leans on."""
    chunks, owner = [], []
    for i, stroke in enumerate(strokes):
        for k in range(0, len(stroke.points) - 1, CHUNK):
            chunks.append(LineString(stroke.points[k : k + CHUNK + 1]))
            owner.append(i)
    lines = np.array(chunks, dtype=object)
    pairs = shapely.STRtree(lines).query(lines, predicate="dwithin", distance=LEANS * stepover)
    of = np.array(owner)[pairs]
    levels = np.array([s.level for s in strokes])
    needs: list[set[int]] = [set() for _ in strokes]
    for i, j in np.unique(of[:, levels[of[1]] < levels[of[0]]], axis=1).T.tolist():
        needs[i].add(j)
    return needs


def runs_of(
    strokes: Sequence[Stroke],
    fronts: Sequence[Polygon],
    ring: LineString,
    radius: float,
    stepover: float,
) -> list[Run]:
    """Join strokes to runs: closed laps to spirals, the first of which begins on the entry's ring.

    Parameters
    ----------
    strokes : sequence of Stroke
    fronts : sequence of shapely.Polygon
    ring : LineString
        The entry's last lap, closed, from where the entry ends.
    radius, stepover : float
        [mm]
    """
    needs = leanings(strokes, stepover)
    runs = [_plain(s.points, i) for i, s in enumerate(strokes) if not s.closed]
    for chain in chains_of(strokes):
        while chain:
            count, run = _spiral(chain, strokes, needs, fronts, ring, radius, stepover)
            runs.append(run)
            chain = chain[count:]
    runs.sort(key=lambda run: run.strokes[0])
    home = {i: r for r, run in enumerate(runs) for i in run.strokes}
    return [
        replace(run, needs=frozenset(home[j] for i in run.strokes for j in needs[i]) - {r})
        for r, run in enumerate(runs)
    ]


def _plain(points: Floats, stroke: int) -> Run:
    heading = _unit(points[1] - points[0])
    return Run((stroke,), (lambda: points,), points[:1], heading[None])


def _spiral(
    chain: list[int],
    strokes: Sequence[Stroke],
    needs: list[set[int]],
    fronts: Sequence[Polygon],
    ring: LineString,
    radius: float,
    stepover: float,
) -> tuple[int, Run]:
    """Return how many laps of a chain one spiral takes from its beginning, and the spiral.

    It ends where a lap leans on something else, or is too far from the one before.
    """
    first = strokes[chain[0]]
    laps = [closed_line(strokes[i].points) for i in chain]
    widest = WIDEST * stepover
    if not first.exterior:
        widest = min(WIDEST_INWARDS * stepover, WITHOUT_CUSPS * radius)
    size = zone_size(radius, stepover)
    if first.level == 1 and _begins_on(ring, laps[0], first.exterior, size, widest):
        source, at = ring, np.zeros(1)
    else:
        before = fronts[first.level - 1]
        rings = [before.exterior, *before.interiors]
        sides = [LineString(shapely.get_coordinates(r)) for r in rings]
        source = sides[int(shapely.STRtree(sides).query_nearest(laps[0], all_matches=False)[0])]
        at = np.empty(0) if first.exterior else ends_of(source, laps[0], size, widest)
        if len(at) == 0:
            at = zones(source, laps[0], size, widest)
    count, here, place = 1, source, float(at[0])
    while count < len(chain) and needs[chain[count]] <= set(chain[:count]):
        place = float(laps[count - 1].project(here.interpolate(place)))
        here = laps[count - 1]
        further = onward(here, place, laps[count], size, widest)
        if further is None:
            break
        place += further
        count += 1
    taken = laps[:count]
    last = [strokes[i] for i in chain[:count][-LAST:]]
    stock = None if first.exterior else _taken_by(last, fronts, radius)

    def way(start: float) -> Floats:
        points = spiral_through(source, start, taken, size, widest)
        if stock is None:
            return points
        trimmed = without_air(points, stock, radius)
        if trimmed is None:
            points = spiral_through(source, start, taken, size, widest, LAST)
            trimmed = without_air(points, stock, radius)
        return points if trimmed is None else trimmed

    starts, ahead = points_at(source, at), points_at(source, (at + 0.2) % source.length)
    return count, Run(
        tuple(chain[:count]),
        tuple(partial(way, float(a)) for a in at),
        starts,
        np.array([_unit(v) for v in ahead - starts]),
    )


def _taken_by(laps: Sequence[Stroke], fronts: Sequence[Polygon], radius: float) -> Region | None:
    """Return the stock that the last laps about a plug take.

    None where some is left within them, or where they run along an island's wall.
    """
    outermost = Polygon(laps[0].points)
    inside = Polygon(laps[-1].points).representative_point()
    around = [Polygon(ring) for ring in fronts[laps[0].level - 1].interiors]
    hole = next((h for h in around if h.contains(inside)), None)
    if hole is None:
        return None
    islands = [Polygon(ring) for ring in fronts[-1].interiors]
    if any(outermost.contains(island) for island in islands):
        return None
    left = [Polygon(ring) for ring in fronts[laps[-1].level].interiors]
    if any(outermost.contains(h) and not buffer(h, -radius).is_empty for h in left):
        return None
    stock = buffer(hole, -radius)
    if any(hole.contains(h) and not outermost.contains(h) for h in (*islands, *left)):
        # other laps take the rest of that hole
        lines = shapely.multilinestrings([closed_line(lap.points) for lap in laps])
        stock = shapely.intersection(stock, shapely.buffer(lines, radius, quad_segs=32))
    return stock


def _begins_on(
    ring: LineString, lap: LineString, exterior: bool, radius: float, widest: float
) -> bool:
    """Return whether a lap of the first level may be begun where the entry ends.

    Not so where the entry ends in a notch of an island, which the lap passes by.
    """
    if exterior:
        widest *= LEFT_BEHIND
    return bool(gaps(ring, lap, np.zeros(1), zone_length(ring, lap, radius))[0] <= widest)


def order(
    runs: Sequence[Run],
    cleared: ClearedMap,
    omega: Polygon,
    start: Floats,
    heading: Floats,
    motion: Motion,
    radius: float,
    tick: Callable[[], None],
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
    tick : callable
        Is called once a run; may raise.
    """
    fence = shapely.buffer(omega, SLACK)
    shapely.prepare(fence)
    starts = np.concatenate([r.starts for r in runs])
    headings = np.concatenate([r.headings for r in runs])
    ways = [(i, way) for i, run in enumerate(runs) for way in run.ways]
    is_single = [len(runs[i].strokes) == 1 for i, _ in ways]
    waiting = [set(r.needs) for r in runs]
    open_runs = set(range(len(runs)))
    steps = []
    while open_runs:
        tick()
        ready = [w for w, (i, _) in enumerate(ways) if i in open_runs and not waiting[i]]
        away = np.hypot(*(starts[ready] - start).T)
        near = np.argsort(away, kind="stable")
        nearest_first = [ready[i] for i in near]
        behind = [w for w in nearest_first[: np.count_nonzero(away < OVERLAP)] if is_single[w]]
        found = _going_on(behind, ways, start, heading)
        if found is None:
            link, taken = _next(
                start, heading, nearest_first, starts, headings, cleared, fence, motion, radius
            )
            chosen, way = ways[taken]
            points = way()
        else:
            link, (chosen, points) = np.empty((0, 2)), found
        steps.append(Step(link, points, chosen))
        open_runs.remove(chosen)
        for needs in waiting:
            needs.discard(chosen)
        for stroke in runs[chosen].strokes:
            cleared.finish(stroke)
        start, heading = points[-1], _unit(points[-1] - points[-2])
    return steps


def _going_on(
    behind: Sequence[int],
    ways: Sequence[tuple[int, Callable[[], Floats]]],
    here: Floats,
    heading: Floats,
) -> tuple[int, Floats] | None:
    """Return the first of the ways that leads on from here, its run and the rest of it, or None."""
    for w in behind:
        run, way = ways[w]
        rest = _from_here(way(), here, heading)
        if rest is not None:
            return run, rest
    return None


def _from_here(points: Floats, here: Floats, heading: Floats) -> Floats | None:
    """Return a stroke from a place on its beginning onwards; None where that is not on it.

    Strokes begin before the stock does, so that one may begin behind the end of the one before.
    """
    line = LineString(points)
    at = float(line.project(Point(here)))
    if at > OVERLAP or line.distance(Point(here)) > TOUCHES or at > line.length - OVERLAP:
        return None
    rest = np.vstack([here, shapely.get_coordinates(substring(line, at + ONTO, line.length))])
    return rest if _unit(rest[1] - rest[0]) @ heading > ONWARD else None


def _unit(v: Floats) -> Floats:
    return v / (np.hypot(*v) + 1e-12)


def _next(
    start: Floats,
    heading: Floats,
    ready: list[int],
    starts: Floats,
    headings: Floats,
    cleared: ClearedMap,
    fence: Polygon,
    motion: Motion,
    radius: float,
) -> tuple[Floats | None, int]:
    """Return the fastest admissible link and the way that it leads to, `ready` nearest first."""
    if np.hypot(*(starts[ready[0]] - start)) < TOUCHES:
        return np.empty((0, 2)), ready[0]

    ways = LongWays(start, heading, cleared, fence, radius, motion.least_radius)
    for first in range(0, len(ready), TRIED):
        tried = ready[first : first + TRIED]
        paths = hermite_links(start, heading, starts[tried], headings[tried], radius)
        free = cleared.are_free(paths)
        end, handles = np.nonzero(free)
        times = link_times(paths[end, handles], motion)
        for flat in np.argsort(times, kind="stable")[:CHECKED]:
            i = tried[int(end[flat])]
            which = int(handles[flat])
            fine = fine_link(start, heading, starts[i], headings[i], radius, which, FINE)
            if cleared.are_free(fine) and fence.covers(LineString(fine)):
                if not are_nervous(fine, motion):
                    return fine, i
                # a long way round may take less than that stop
                found = ways.to(starts[i], headings[i])
                if found is None or link_times(found, motion) > link_times(fine, motion):
                    return fine, i
                return found, i
    for i in ready[:ROUTED]:
        found = ways.to(starts[i], headings[i])
        if found is not None:
            return found, i
    backs = [(i, back_along_ring(start, starts[i], cleared, fence)) for i in ready]
    there = [(way, i) for i, way in backs if way is not None]
    return min(there, key=lambda w: LineString(w[0]).length, default=(None, ready[0]))
