# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isotherm: laps along the isotherms of a heated plate, refitted to smooth curves [HQS24].

For pockets of soft, roundish outline, with or without islands, also where walls
hide behind corners; the laps are the smoothest of all, but close to a wall that
is far from the others they lie closer than they need.

- The temperature comes from poisson.py, cold at the wall and at islands. The wall's
  corners are rounded before by as much as the closing lap can take: isotherms crowd
  at walls whose corners are sharp.
- Laps are chosen from the wall inwards: the next one is the hottest isotherm of which
  no point of the lap before is farther than the step-over (eq. 10).
- Each isotherm is refitted with C2 Hermite quartic patches (hermite_quartic.py) within
  a bound on the deviation, which is halved until the laps are nested.
- Laps become spirals by eq. 11, along gradient lines (turns.py). Where the plate has
  several hottest places there is a spiral about each; laps around them follow outside of
  the saddle (nested.py). The paper spirals from one of them only.
- A start point that is asked for decides which core is opened first, and where on it.
- In the middle a helix goes down; where that would mean many laps about a long ridge, or
  where the ridge is closed about an island, a slot along the innermost isotherm that leaves
  no post.
- Where the plate has several summits, or laps to its only one would be longer, a slot along the
  ridges joins them and is kept hot instead (hot_slots.py): everything is then laps about
  that one slot, without lifts.

The step-over is held, the engagement in bends is not: the report says how far.
"""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass

import shapely
from shapely import Point, Polygon

from ..errors import CutterDoesNotFitError, NotYetError
from ..floor import FloorPath, Slot
from ..heat.family import Enclosed, Family, distances, evenly_divided, family_of, points_of
from ..heat.hot_slots import hot_slot
from ..heat.isotherm_slots import core_of
from ..heat.isotherms import mover, outer_room
from ..heat.nested import SPACING, Lap, Mover, path_through
from ..heat.next_laps import REFITTED, holds, inner_rooms, rooms_about
from ..heat.poisson import HeatField
from ..links.estimates import LIFT_SECONDS, motion_of
from ..model import PocketRequest, Tick
from ..opening.start import slot_bite
from ..shapes.polyline import ring_points
from ..shapes.shaping import slim_region
from ..shapes.skeleton import medial_axis
from .closing import corner_fillet

#: From a lap that is nowhere farther from the hot slot than this over the step-over the way there
#: is divided evenly.
EVEN = 5.0
#: A grid whose spacing is less than this over the step-over is not made finer there.
FINE = 0.2
#: Laps about a hot slot crowd where all of them pass through a channel: if they are longer than
#: this over evenly spaced ones, laps about all summits are taken that have less than this share of
#: their length.
CROWDED, MUCH_SHORTER = 3.5, 0.85
#: A region whose ridges are shorter than this over its largest clearance is compact.
COMPACT = 1.5
#: More laps than this are refused.
MOST_LAPS = 300


def floor_path(
    region: Polygon, request: PocketRequest, tick: Tick, deviation: float | None = None
) -> FloorPath:
    """Make the spirals of one cutter-center region.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise.
    request : PocketRequest
    tick : callable
        See `model.Tick`.
    deviation : float, optional
        Largest deviation of refitted laps [mm]; 0 for raw isotherms.

    Raises
    ------
    NotYetError
        If a place is too narrow for any isotherm, or the pocket takes too many laps.
    CutterDoesNotFitError
        If there is no room to go down.
    """
    region = slim_region(region)
    wall, move = _shortest(region, request, deviation, tick)
    if request.cutting.finishing_lap:
        wall = Lap(region, 0.0, (wall,))
    return path_through(wall, region, request, motion_of(request), move, tick)


def _shortest(
    region: Polygon, request: PocketRequest, deviation: float | None, tick: Tick
) -> tuple[Lap, Mover]:
    """Return the laps about a hot slot, or those to the plate's summits if they are shorter.

    Those to an only summit if they are shorter at all, those to several if much. And what moves
    points from one to another.

    The parameters are those of `floor_path` and `isotherms.family_of`.
    """
    fillet = corner_fillet(region, request.cutting.stepover)
    axis = medial_axis(region, request.tool_diameter)
    about, effort, limit, tried = None, _Effort(), None, None
    for all_rooms in (False, True):
        slot = hot_slot(region, axis, request, all_rooms=all_rooms)
        if slot is None or slot == tried:
            continue
        tried = slot
        # partners on rings are sought beside their vertices
        slot = shapely.segmentize(slot, SPACING)
        try:
            family = family_of(region, request, fillet, deviation, slot)
            wall = _lap(family, outer_room(family), tick, effort)
        except (NotYetError, CutterDoesNotFitError):
            effort = _Effort()
            continue
        about = wall, mover(family.field, effort.even, family.heat)
        if not _is_compact(region, slot, float(axis.clearance.max())):
            if effort.length < CROWDED * region.area / request.cutting.stepover:
                return about
            limit = _Effort(MUCH_SHORTER * effort.length)
        break
    family = family_of(region, request, fillet, deviation)
    if about is None:
        return laps_of(family, tick), mover(family.field)
    try:
        wall = _lap(family, outer_room(family), tick, limit or _Effort(effort.length, 1))
    except (NotYetError, CutterDoesNotFitError):
        return about
    return wall, mover(family.field)


def _is_compact(region: Polygon, slot: Polygon, widest: float) -> bool:
    """Return whether a region may have one summit, or one ridge, to which laps are shorter.

    Parameters
    ----------
    region : shapely.Polygon
    slot : shapely.Polygon
        Along its ridges.
    widest : float
        Largest clearance [mm].
    """
    if region.interiors:
        return len(region.interiors) == 1
    return slot.length < 2 * COMPACT * widest


def laps_of(family: Family, tick: Tick) -> Lap:
    """Return all laps, from the rounded wall inwards.

    Raises
    ------
    NotYetError
        See `floor_path`.
    """
    return _lap(family, outer_room(family), tick, _Effort())


@dataclass(slots=True)
class _Effort:
    """What laps take, and may take at most.

    Attributes
    ----------
    most : float
        Length of all laps and ways down, and of what is cut in the time of lifts [mm].
    cores : int
        Places where the cutter goes down.
    laps : int
    length : float
        [mm]
    even : HeatField or None
        Along which the laps beside a hot slot were chosen.
    """

    most: float = math.inf
    cores: float = math.inf
    laps: int = 0
    length: float = 0.0
    even: HeatField | None = None

    def spend(self, length: float, place: shapely.Point) -> None:
        """Count a lap or a way down of a length [mm]."""
        self.length += length
        if self.laps > MOST_LAPS or self.length > self.most:
            raise NotYetError(
                f"Isotherm would need more than {MOST_LAPS} laps.",
                "Take a larger step-over or the strategy Automatic.",
                (place.x, place.y),
            )


def _lap(family: Family, room: Enclosed, tick: Tick, effort: _Effort) -> Lap:
    """Return the lap about a room, with all inside of it."""
    effort.laps += 1
    effort.spend(room.region.length, room.region.representative_point())
    tick(0.1 + 0.5 * (1 - room.region.area / family.region.area))
    if family.hot is not None and holds(room.region, family.hot):
        return _lap_about(family, family.hot, room, tick, effort)
    core = core_of(family, room)
    if core is not None:
        if isinstance(core.entry, Slot) and core.region is room.region:
            effort.length -= room.region.exterior.length  # the slot is that lap
        effort.spend(_way_down(core, family), room.region.representative_point())
        # of a summit that is hardly higher than the saddle before it nothing is left
        is_all = core.region is room.region or core.region.contains(room.region)
        return core if is_all else Lap(room.region, room.level, (core,))
    rooms, slots = inner_rooms(family, room)
    if len(rooms) + len(slots) > effort.cores:
        raise NotYetError("The plate has several summits.", "", None)
    for slot in slots:
        effort.spend(_way_down(slot, family), slot.region.representative_point())
    # the hottest first: its core is the first to be opened
    laps = [*(_lap(family, one, tick, effort) for one in reversed(rooms)), *slots]
    asked = family.request.start_point
    if asked is not None:
        laps.sort(key=lambda lap: lap.region.distance(Point(asked)))
    return Lap(room.region, room.level, tuple(laps))


def _way_down(core: Lap, family: Family) -> float:
    """Return the length of the way down into a core, and what is cut in the time of a lift [mm]."""
    request, once = family.request, core.region.exterior.length
    lift = LIFT_SECONDS * motion_of(request).cut_feed
    if isinstance(core.entry, Slot):
        return lift + math.ceil(request.axial_depth / core.entry.bite) * once
    return lift + request.axial_depth / math.tan(request.entry.helix_angle) + once


def _lap_about(family: Family, hot: Polygon, room: Enclosed, tick: Tick, effort: _Effort) -> Lap:
    """Return the lap about a room that has the hot slot inside, with all inside of it.

    Raises
    ------
    NotYetError
        If no laps lead to the slot.
    """
    level = room.level + (family.heat if family.is_even else 0.0)
    points = points_of(room.region)
    off = float(distances(points, [hot]).max())
    if off <= REFITTED * family.stepover:
        slot = Slot(ring_points(hot.exterior), slot_bite(family.request))
        core = Lap(hot, level - room.level + family.heat, (), slot)
        effort.spend(_way_down(core, family), hot.representative_point())
        return Lap(room.region, level, (core,))
    spent = effort.laps, effort.length
    is_near = off <= EVEN * family.stepover and not family.is_even
    if is_near:
        with suppress(NotYetError):
            return Lap(room.region, level, _evened_laps(family, room, tick, effort))
        effort.laps, effort.length = spent
    rooms = rooms_about(family, hot, room, points)
    if rooms:
        laps = (_lap(family, one, tick, effort) for one in reversed(rooms))
        return Lap(room.region, level, tuple(laps))
    if is_near or family.is_even:
        place = room.region.representative_point()
        raise NotYetError("No isotherm leads to the slot.", "", (place.x, place.y))
    return Lap(room.region, level, _evened_laps(family, room, tick, effort))


def _evened_laps(family: Family, room: Enclosed, tick: Tick, effort: _Effort) -> tuple[Lap, ...]:
    """Return the laps inside of a room's lap that divide the way to the hot slot evenly.

    Raises
    ------
    NotYetError
        If no laps lead to the slot.
    """
    effort.length -= room.region.length  # it is counted once more
    laps, length, finer = effort.laps, effort.length, 1
    while True:
        even, start = evenly_divided(family, room, finer)
        effort.even = even.field
        try:
            return _lap(even, start, tick, effort).inner
        except NotYetError:
            if even.field.spacing < FINE * family.stepover:
                raise
        # where laps are close the grid hardly shows what is between the last ones
        effort.laps, effort.length, finer = laps, length, 2 * finer
