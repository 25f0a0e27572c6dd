# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs: strokes that are cut without a break, closed laps one after the other as spirals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from ..model import Floats
from ..numerics.distinct import distinct_pairs
from ..shapes.points import unit
from ..shapes.polyline import closed_line, located, points_at
from ..shapes.region import rings_of
from ..shapes.shaping import Region, grow_coarsely
from .spiral import (
    anywhere,
    chains_of,
    gaps,
    gaps_all_round,
    onward,
    slim_ends_of,
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
#: A spiral goes on to the next lap where that is no farther than this over the step-over: outwards,
#: and about a plug, whose corners are rounded.
WIDEST, WIDEST_INWARDS = 1.3, 3.4
#: And no farther than this over R, for else a cusp may stay between two turns.
WITHOUT_CUSPS = 1.72
#: So many of a spiral's last laps are looked at for what they leave: in its zone each lags behind.
LAST = 3
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
    is_late : bool
        Whether a way may be begun a little behind its start, though it is several strokes.
    spare : int
        So many of the last ways are worse, for where no link leads to the others.
    """

    strokes: tuple[int, ...]
    ways: tuple[Callable[[], Floats], ...]
    starts: Floats
    headings: Floats
    needs: frozenset[int] = frozenset()
    is_late: bool = False
    spare: int = 0


def leanings(strokes: Sequence[Stroke], stepover: float) -> list[set[int]]:
    """Return for each stroke the strokes of lower levels that it leans on; `stepover` is in mm."""
    chunks, owner = [], []
    for i, stroke in enumerate(strokes):
        for k in range(0, len(stroke.points) - 1, CHUNK):
            chunks.append(LineString(stroke.points[k : k + CHUNK + 1]))
            owner.append(i)
    lines, of, reach = np.array(chunks, dtype=object), np.array(owner), LEANS * stepover
    low_x, low_y, high_x, high_y = shapely.bounds(lines).T
    boxes = shapely.box(low_x - reach, low_y - reach, high_x + reach, high_y + reach)
    upper, lower = shapely.STRtree(lines).query(boxes)
    # most that is near is of the same lap
    levels = np.array([s.level for s in strokes])[of]
    upper, lower = np.stack([upper, lower])[:, levels[lower] < levels[upper]]
    near = shapely.dwithin(lines[upper], lines[lower], reach)
    needs: list[set[int]] = [set() for _ in strokes]
    pairs = np.column_stack([of[upper], of[lower]])[near]
    for i, j in distinct_pairs(pairs).tolist():
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
    spirals = _Spirals(strokes, needs, fronts, ring, radius, stepover)
    for chain in chains_of(strokes):
        while chain:
            run = spirals.first_of(chain)
            runs.append(run)
            chain = chain[len(run.strokes) :]
    runs.sort(key=lambda run: run.strokes[0])
    home = {i: r for r, run in enumerate(runs) for i in run.strokes}
    return [
        replace(run, needs=frozenset(home[j] for i in run.strokes for j in needs[i]) - {r})
        for r, run in enumerate(runs)
    ]


def _plain(points: Floats, stroke: int) -> Run:
    heading = unit(points[1] - points[0])
    return Run((stroke,), (lambda: points,), points[:1], heading[None])


@dataclass(frozen=True, slots=True, eq=False)
class _Spirals:
    """What spirals through closed laps are made of.

    Attributes
    ----------
    strokes : sequence of Stroke
    needs : list of set of int
        Of each stroke those that it leans on.
    fronts, ring, radius, stepover
        See `runs_of`.
    """

    strokes: Sequence[Stroke]
    needs: list[set[int]]
    fronts: Sequence[Polygon]
    ring: LineString
    radius: float
    stepover: float

    def first_of(self, chain: list[int]) -> Run:
        """Return the spiral through the first laps of a chain.

        It ends where a lap leans on something else, or is too far from the one before.
        """
        laps = [closed_line(self.strokes[i].points) for i in chain]
        source, at, spare = self._beginnings(self.strokes[chain[0]], laps[0])
        count = self._reach(chain, laps, source, float(at[0]))
        if count < len(chain) and self.needs[chain[count]] <= set(chain[:count]):
            # from elsewhere the next lap may be near enough
            own = len(at) - spare
            counts = np.array([self._reach(chain, laps, source, float(a)) for a in at[:own]])
            if counts.max() > count:
                count = int(counts.max())
                at = np.append(at[:own][counts == count], at[own:])
        starts, ahead = points_at(source, at), points_at(source, (at + 0.2) % source.length)
        way = self._way([self.strokes[i] for i in chain[:count]], laps[:count], source)
        return Run(
            tuple(chain[:count]),
            tuple(partial(way, float(a)) for a in at),
            starts,
            np.array([unit(v) for v in ahead - starts]),
            spare=spare,
        )

    @property
    def size(self) -> float:
        """Return what stands for R where zones between laps are laid out [mm]."""
        return zone_size(self.radius, self.stepover)

    def widest(self, exterior: bool) -> float:
        """Return how far the next lap may be for a spiral to go on to it [mm]."""
        return _widest(exterior, self.radius, self.stepover)

    def _beginnings(self, first: Stroke, lap: LineString) -> tuple[LineString, Floats, int]:
        """Return on which line a spiral begins, where along it, and how many of these are spare."""
        size, widest = self.size, self.widest(first.exterior)
        if begins_on(self.ring, first, self.radius, self.stepover):
            return self.ring, np.zeros(1), 0
        before = self.fronts[first.level - 1]
        sides = [LineString(shapely.get_coordinates(r)) for r in rings_of(before)]
        source = sides[int(shapely.STRtree(sides).query_nearest(lap, all_matches=False)[0])]
        if first.exterior:
            return source, zones(source, lap, size, widest), 0
        at = slim_ends_of(source, lap, size, widest)
        if len(at) == 0:
            at = zones(source, lap, size, widest)
        others = anywhere(source, lap, size, widest)
        return source, np.append(at, others), len(others)

    def _reach(
        self, chain: list[int], laps: list[LineString], source: LineString, place: float
    ) -> int:
        """Return how many laps a spiral takes that leaves `source` at a place along it [mm]."""
        size, widest = self.size, self.widest(self.strokes[chain[0]].exterior)
        count, here = 1, source
        while count < len(chain) and self.needs[chain[count]] <= set(chain[:count]):
            place = float(laps[count - 1].project(here.interpolate(place)))
            here = laps[count - 1]
            further = onward(here, place, laps[count], size, widest)
            if further is None:
                break
            place += further
            count += 1
        return count

    def _way(
        self, strokes: list[Stroke], laps: list[LineString], source: LineString
    ) -> Callable[[float], Floats]:
        """Return what gives the points of a spiral that leaves `source` at a place along it [mm].

        About a plug it ends where all of the stock there is taken.
        """
        exterior = strokes[0].exterior
        size, widest = self.size, self.widest(exterior)
        stock = None if exterior else _taken_by(strokes[-LAST:], self.fronts, self.radius)

        @cache
        def way(start: float) -> Floats:
            points = spiral_through(source, start, laps, size, widest)
            if stock is None:
                return points
            trimmed = without_air(points, stock, self.radius)
            if trimmed is None:
                points = spiral_through(source, start, laps, size, widest, LAST)
                trimmed = without_air(points, stock, self.radius)
            return points if trimmed is None else trimmed

        return way


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
    if any(outermost.contains(h) and not grow_coarsely(h, -radius).is_empty for h in left):
        return None
    stock = grow_coarsely(hole, -radius)
    if any(hole.contains(h) and not outermost.contains(h) for h in (*islands, *left)):
        # other laps take the rest of that hole
        lines = shapely.multilinestrings([closed_line(lap.points) for lap in laps])
        stock = shapely.intersection(stock, shapely.buffer(lines, radius, quad_segs=32))
    return stock


def first_laps(
    strokes: Sequence[Stroke], ring: LineString, radius: float, stepover: float
) -> list[LineString]:
    """Return the closed laps about a plug that begin where the entry ends, each in the next.

    Empty where no such lap is; the parameters are those of `begins_on`.
    """
    for chain in chains_of(strokes):
        first = strokes[chain[0]]
        if not first.exterior and begins_on(ring, first, radius, stepover):
            return [closed_line(strokes[i].points) for i in chain]
    return []


def followed(
    source: LineString, places: Floats, laps: Sequence[LineString], radius: float, stepover: float
) -> NDArray[np.intp]:
    """Return how many laps about a plug a spiral takes that leaves a line at each of some places.

    Nearly: places are told apart by half of R.

    Parameters
    ----------
    source : LineString
        Closed.
    places : ndarray of shape (n,)
        Along it [mm].
    laps : sequence of LineString
        Closed, each within the one before.
    radius, stepover : float
        [mm]

    Returns
    -------
    ndarray of shape (n,)
    """
    size, widest = zone_size(radius, stepover), _widest(False, radius, stepover)
    counts, goes_on = np.zeros(len(places), dtype=np.intp), np.ones(len(places), dtype=bool)
    here, at = source, places
    for number, lap in enumerate(laps):
        count = max(12, int(here.length / (size / 2)))
        length = zone_length(here, lap, size)
        wide = gaps_all_round(here, lap, count, length, 1.01 * widest)
        good = np.flatnonzero(wide <= widest)
        if len(good) == 0:
            break
        beside = np.round(at / here.length * count).astype(np.intp) % count
        following = np.append(good, good[0] + count)[np.searchsorted(good, beside)]
        further = (following - beside) * here.length / count
        # the first lap is left where the entry ends
        goes_on &= further < (length if number else here.length / count / 2)
        counts += goes_on
        at = located(lap, points_at(here, (at + further) % here.length))
        here = lap
    return counts


def begins_on(ring: LineString, stroke: Stroke, radius: float, stepover: float) -> bool:
    """Return whether a lap of the first level may be begun where the entry ends.

    Not so where the entry ends in a notch of an island, which the lap passes by.

    Parameters
    ----------
    ring : LineString
        The entry's last lap, closed, from where the entry ends.
    stroke : Stroke
    radius, stepover : float
        [mm]
    """
    if stroke.level != 1 or not stroke.closed:
        return False
    lap, widest = closed_line(stroke.points), _widest(stroke.exterior, radius, stepover)
    if stroke.exterior:
        widest *= LEFT_BEHIND
    zone = zone_length(ring, lap, zone_size(radius, stepover))
    return bool(gaps(ring, lap, np.zeros(1), zone)[0] <= widest)


def _widest(exterior: bool, radius: float, stepover: float) -> float:
    if exterior:
        return WIDEST * stepover
    return min(WIDEST_INWARDS * stepover, WITHOUT_CUSPS * radius)
