# SPDX-License-Identifier: LGPL-2.1-or-later
"""In which order runs are cut, and how the cutter gets from one to the next.

A run may be cut when the runs that it leans on are done. Among those that may, the one
whose link costs least time goes next, or the next of a given sequence. Links run through
free ground at depth; a lift is the last resort.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import LineString, Point, Polygon
from shapely.ops import substring

from ..growth.stroke_runs import Run
from ..model import Floats
from ..shapes.points import unit
from .cleared import ClearedMap
from .linking import Motion, are_nervous, fine_link, hermite_links, link_times
from .ring_ways import back_along_ring, onto_ring
from .routing import LongWays

#: So many of the nearest ready runs are tried at a time.
TRIED = 8
#: To so many of the nearest a longer way round is sought where no plain link fits.
ROUTED = 6
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


@dataclass(frozen=True, slots=True, eq=False)
class Situation:
    """What the cutter finds when the entry is cut and no run yet.

    Attributes
    ----------
    cleared : ClearedMap
    omega : shapely.Polygon
        The cutter-center region.
    here, heading : ndarray of shape (2,)
        Where the entry ends [mm], and the unit direction there.
    motion : Motion
    radius : float
        R [mm].
    takes_spares : bool
        Whether a run may be begun by one of its spare ways, where no link leads to the others.
    """

    cleared: ClearedMap
    omega: Polygon
    here: Floats
    heading: Floats
    motion: Motion
    radius: float
    takes_spares: bool = False


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


def order(
    runs: Sequence[Run],
    situation: Situation,
    tick: Callable[[], None],
    sequence: Sequence[int] = (),
    known: Sequence[Step] = (),
) -> list[Step]:
    """Return the runs in order, each with its link.

    Parameters
    ----------
    runs : sequence of Run
    situation : Situation
    tick : callable
        Is called once a run; may raise.
    sequence : sequence of int
        Which runs to go to one after the other; where no link leads to the next, and after the
        last, the nearest comes first.
    known : sequence of Step
        In another order, whose links are taken over where they fit.
    """
    waiting = [set(r.needs) for r in runs]
    open_runs = set(range(len(runs)))
    cutter = _Cutter(runs, situation)
    after = [None, *(step.run for step in known)]
    again = {(run, step.run): step for run, step in zip(after, known, strict=False)}
    steps: list[Step] = []
    while open_runs:
        tick()
        ready = [r for r in sorted(open_runs) if not waiting[r]]
        turn = next((r for r in sequence if r in open_runs), None)
        step = None
        if turn is not None and turn in ready:
            step = again.get((steps[-1].run if steps else None, turn))
            if step is None or not cutter.may_take(step):
                step = cutter.next([turn])
        if step is None or step.link is None:
            step = cutter.next(ready)
        steps.append(step)
        cutter.cut(step)
        open_runs.remove(step.run)
        for needs in waiting:
            needs.discard(step.run)
    return steps


class _Cutter:
    """Where the cutter is, and what is free by now; parameters are those of `order`."""

    def __init__(self, runs: Sequence[Run], situation: Situation) -> None:
        self._runs, self._cleared = runs, situation.cleared.copied()
        self._motion, self._radius = situation.motion, situation.radius
        self._takes_spares = situation.takes_spares
        self._here, self._heading = situation.here, situation.heading
        self._fence = shapely.buffer(situation.omega, SLACK)
        shapely.prepare(self._fence)
        self._starts = np.concatenate([r.starts for r in runs])
        self._headings = np.concatenate([r.headings for r in runs])
        self._ways = [(i, way) for i, run in enumerate(runs) for way in run.ways]
        self._first = np.cumsum([0, *(len(run.ways) for run in runs)]).tolist()

    def next(self, ready: Sequence[int]) -> Step:
        """Return the step to one of the runs."""
        bounds = [(self._first[r], self._first[r + 1], self._runs[r].spare) for r in ready]
        ways, near = self._nearest_first([w for a, b, n in bounds for w in range(a, b - n)])
        runs = [self._runs[self._ways[w][0]] for w in near]
        behind = [w for w, r in zip(near, runs, strict=True) if r.is_late or len(r.strokes) == 1]
        step = self._going_on(behind)
        if step is None:
            link, way = self._fastest_link(ways)
            if link is None and self._takes_spares:
                spare, _ = self._nearest_first([w for _, b, n in bounds for w in range(b - n, b)])
                if spare:
                    link, other = self._fastest_link(spare)
                    way = way if link is None else other
            run, points = self._ways[way]
            step = Step(link, points(), run)
        return step

    def _nearest_first(self, ways: Sequence[int]) -> tuple[list[int], list[int]]:
        """Return ways by how far they begin from here, and those among them that do so near by."""
        away = np.hypot(*(self._starts[list(ways)] - self._here).T)
        nearest = [ways[i] for i in np.argsort(away, kind="stable")]
        return nearest, nearest[: np.count_nonzero(away < OVERLAP)]

    def may_take(self, step: Step) -> bool:
        """Return whether a step leads on from here through free ground, without a lift."""
        if step.link is None:
            return False
        begin = step.link[0] if len(step.link) else step.points[0]
        is_here = np.hypot(*(begin - self._here)) < TOUCHES
        return bool(is_here and (len(step.link) == 0 or self._cleared.are_free(step.link)))

    def cut(self, step: Step) -> None:
        """Be where a step ends, all that it cuts being free."""
        for stroke in self._runs[step.run].strokes:
            self._cleared.finish(stroke)
        self._here, self._heading = step.points[-1], unit(step.points[-1] - step.points[-2])

    def _going_on(self, behind: Sequence[int]) -> Step | None:
        """Return the first of the ways that leads on from here, from here on; None if none does."""
        for w in behind:
            run, way = self._ways[w]
            rest = _from_here(way(), self._here, self._heading)
            if rest is not None:
                return Step(np.empty((0, 2)), rest, run)
        return None

    def _fastest_link(self, ways: Sequence[int]) -> tuple[Floats | None, int]:
        """Return the fastest admissible link and the way that it leads to, `ways` nearest first."""
        here, heading, radius, motion = self._here, self._heading, self._radius, self._motion
        starts, headings = self._starts, self._headings
        if np.hypot(*(starts[ways[0]] - here)) < TOUCHES:
            return np.empty((0, 2)), ways[0]
        long_ways = LongWays(here, heading, self._cleared, self._fence, radius, motion.least_radius)
        for first in range(0, len(ways), TRIED):
            tried = ways[first : first + TRIED]
            paths = hermite_links(here, heading, starts[tried], headings[tried], radius)
            end, handles = np.nonzero(self._cleared.are_free(paths))
            times = link_times(paths[end, handles], motion)
            for flat in np.argsort(times, kind="stable")[:CHECKED]:
                w = tried[int(end[flat])]
                which = int(handles[flat])
                fine = fine_link(here, heading, starts[w], headings[w], radius, which, FINE)
                if self._cleared.are_free(fine) and self._fence.covers(LineString(fine)):
                    if not are_nervous(fine, motion):
                        return fine, w
                    # a long way round may take less than that stop
                    found = long_ways.to(starts[w], headings[w])
                    if found is None or link_times(found, motion) > link_times(fine, motion):
                        return fine, w
                    return found, w
        for w in self._open_ways(ways)[:ROUTED]:
            found = long_ways.to(starts[w], headings[w])
            if found is not None:
                return found, w
        ends, arriving = starts[ways], headings[ways]
        over = onto_ring(long_ways, ends, arriving, self._cleared, self._fence, radius)
        over = over or back_along_ring(here, ends, self._cleared, self._fence)
        return (None, ways[0]) if over is None else (over[0], ways[over[1]])

    def _open_ways(self, ways: Sequence[int]) -> list[int]:
        """Return the ways whose beginnings a path could reach from here; quick."""
        cleared, chosen = self._cleared, np.array(ways)
        if not cleared.are_open(self._here[None], self._heading[None])[0]:
            return []
        open_ = cleared.are_open(self._starts[chosen], -self._headings[chosen])
        return chosen[open_].tolist()


def _from_here(points: Floats, here: Floats, heading: Floats) -> Floats | None:
    """Return a stroke from a place on its beginning onwards; None where that is not on it.

    Strokes begin before the stock does, so that one may begin behind the end of the one before.
    """
    line = LineString(points)
    at = float(line.project(Point(here)))
    if at > OVERLAP or line.distance(Point(here)) > TOUCHES or at > line.length - OVERLAP:
        return None
    rest = np.vstack([here, shapely.get_coordinates(substring(line, at + ONTO, line.length))])
    return rest if unit(rest[1] - rest[0]) @ heading > ONWARD else None
