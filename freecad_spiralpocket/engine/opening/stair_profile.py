# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far off the wall a slot's upper loops may run along it: less in corners and narrow places.

In a corner all loops run along the wall, or else the last one would meet the ribs beside both
walls at once; from there on their lines leave it tangentially. In places so narrow that no lap
goes between, nothing would clear what they leave on the floor.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from ..growth.front_rules import FrontRules, engagement_step
from ..model import Floats
from ..numerics.distinct import distinct
from ..numerics.filters import evened, lowest
from ..shapes.drawing_near import s_curve
from ..shapes.points import cross, distances_along
from ..shapes.polyline import points_at
from ..shapes.shaping import CRACK, Region, opening_of, thick_parts

#: Samples along the wall, over R.
SPACING = 0.1
#: A line at a distance from the wall reaches it over the root of this times R and the distance.
TAPER = 6.5
#: Between two corners lines are so near to the wall that both tapers take no more than this of the
#: way each.
SPAN = 0.45
#: Half the length over which the wall's bends are told, over R.
BEND = 0.5
#: The bends of the innermost line have at least this radius, over R.
TIGHTEST = 1.0
#: Half the width of the plug that must be left within, over R: a lap goes round it.
PLUG = 1.1
#: A narrow place reaches farther than this beyond the wide ones, over half their width.
NARROW = 0.7
#: Shares of the distances that are tried where there is not room for all of them.
SHARES = (1.0, 0.75, 0.5)
#: Where the room changes, the distances do over so much to both sides, over R.
EVEN = 1.2


@dataclass(frozen=True, slots=True, eq=False)
class Profile:
    """How far off the wall lines may run, sample by sample along it.

    Attributes
    ----------
    wall : shapely.LineString
        Closed, counter-clockwise.
    samples : ndarray of shape (n,)
        Places along it [mm].
    share : ndarray of shape (n,)
        What part of the distances there is room for, in [0, 1].
    away : ndarray of shape (n,)
        How far it is to the next corner, either way; infinite without any [mm].
    radius : float
        R [mm].
    """

    wall: LineString
    samples: Floats
    share: Floats
    away: Floats
    radius: float

    @property
    def along(self) -> Floats:
        """Return the places of all points of the lines: the wall's own and the samples [mm]."""
        corners = distances_along(shapely.get_coordinates(self.wall))[:-1]
        return distinct(np.concatenate([corners, self.samples]))

    @property
    def tapers(self) -> int:
        """Return how often lines leave the wall."""
        at_wall = self.away <= 0
        return int(np.count_nonzero(at_wall & ~np.roll(at_wall, 1)))

    def offsets(self, distance: float) -> Floats:
        """Return how far off the wall a line at a distance [mm] runs at each sample, (n,) [mm]."""
        if distance == 0:
            return np.zeros(len(self.samples))
        taper = math.sqrt(TAPER * self.radius * distance)
        return distance * self.share * s_curve(self.away / taper)

    def line(self, offsets: Floats) -> Floats:
        """Return the line so far off the wall at each sample, shape (n, 2), a point for each place.

        The first point is not repeated.
        """
        along, length = self.along, self.wall.length
        inwards = _inwards(self.wall, along, BEND * self.radius)
        off = np.interp(along, self.samples, offsets, period=length)
        return points_at(self.wall, along) + off[:, None] * inwards


def profile_of(
    wall: LineString,
    region: Polygon,
    innermost: float,
    inner: float,
    rules: FrontRules,
    bare: float,
) -> Profile | None:
    """Return how far off the wall lines may run; None where all must run along it.

    Parameters
    ----------
    wall : shapely.LineString
        Closed, counter-clockwise.
    region : shapely.Polygon
        The cutter-center region, with the wall as its exterior.
    innermost, inner : float
        How far the innermost line is off the wall, and the one that laps go on from [mm].
    rules : FrontRules
    bare : float
        So far beside corners lines still run along the wall [mm].
    """
    radius = rules.cutter_radius
    count = max(64, math.ceil(wall.length / (SPACING * radius)))
    s = np.linspace(0.0, wall.length, count, endpoint=False)
    bend = _bends(wall, s, BEND * radius)
    tightest = 1 / (innermost + TIGHTEST * radius)
    curvature = np.minimum(bend, tightest)
    step = engagement_step(curvature / (1 - curvature * inner), rules)
    share = np.minimum(step / rules.stepover, 1.0)
    corner = bend > tightest
    share *= _room(points_at(wall, s), corner, region, inner, radius)
    share[corner] = 0.0
    free = share > 0
    if not free.any():
        return None
    after, before = (away - bare for away in _spans(free, wall.length / count))
    span = np.maximum(after + before, 0.0)
    share *= np.clip((SPAN * span) ** 2 / (TAPER * radius * innermost), 0.0, 1.0)
    # in corners the tapers do without
    share = np.interp(s, s[free], share[free], period=wall.length)
    even = round(EVEN * radius * count / wall.length)
    share = evened(lowest(share, 2 * even + 1, closed=True), even / 2, closed=True)
    return Profile(wall, s, share, np.minimum(after, before), radius)


def _inwards(line: LineString, at: Floats, half: float) -> Floats:
    """Return the unit vectors to the left of a closed line, evened over `half` to both sides."""
    ahead = points_at(line, (at + half) % line.length) - points_at(line, (at - half) % line.length)
    left = np.column_stack([-ahead[:, 1], ahead[:, 0]])
    return left / (np.hypot(*left.T)[:, None] + 1e-12)


def _bends(line: LineString, s: Floats, half: float) -> Floats:
    """Return the curvature of a closed line, positive to the left, over `half` to both sides."""
    here = points_at(line, s)
    before = here - points_at(line, (s - half) % line.length)
    after = points_at(line, (s + half) % line.length) - here
    return np.asarray(np.arctan2(cross(before, after), (before * after).sum(axis=1)) / half)


def _room(
    places: Floats, corner: NDArray[np.bool_], region: Polygon, inner: float, radius: float
) -> Floats:
    """Return what part of `inner` the line that laps go on from may be off the wall.

    Nothing where no disc fits between the wall and what is opposite, but in corners.
    """
    room, points, near = np.ones(len(places)), shapely.points(places), 0.01 * radius
    tree = shapely.STRtree(points)
    for share, less in pairwise((*SHARES, 0.0)):
        half = share * inner + PLUG * radius
        wide = opening_of(region, half)
        lost = thick_parts(shapely.difference(region, wide))
        narrow = lost[~_are_corners(lost, wide, points[corner], NARROW * half)]
        if len(narrow) == 0:
            break
        room[tree.query(narrow, predicate="dwithin", distance=near)[1]] = less
    return room


def _are_corners(
    parts: NDArray[np.object_], wide: Region, corners: NDArray[np.object_], far: float
) -> NDArray[np.bool_]:
    """Return which parts touch a corner and reach no farther than `far` beyond what is wide."""
    found = np.zeros(len(parts), dtype=bool)
    found[shapely.STRtree(parts).query(corners, predicate="dwithin", distance=CRACK)[1]] = True
    coords, of = shapely.get_coordinates(parts, return_index=True)
    # asked once: growing what is full of short arcs may take GEOS a hundred times as long
    shapely.prepare(wide)
    found[of[~shapely.dwithin(wide, shapely.points(coords), far)]] = False
    return found


def _spans(free: NDArray[np.bool_], spacing: float) -> tuple[Floats, Floats]:
    """Return how far each sample is behind the last one that is not free, and before the next [mm].

    Infinite where all are.
    """
    barred, count = np.flatnonzero(~free), len(free)
    if len(barred) == 0:
        return np.full(count, np.inf), np.full(count, np.inf)
    around = np.concatenate([barred - count, barred, barred + count])
    place = np.arange(count)
    last = np.searchsorted(around, place, side="right") - 1
    following = around[np.searchsorted(around, place, side="left")]
    behind: Floats = spacing * (place - around[last]).astype(float)
    ahead: Floats = spacing * (following - place).astype(float)
    return behind, ahead
