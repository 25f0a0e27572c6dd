# SPDX-License-Identifier: LGPL-2.1-or-later
"""The start once round the outer wall: where its slot begins, and by which stairs it goes down.

What it opens is told by outline.py, how its loops come nearer to the wall by stairs.py.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import numpy as np
import shapely
from shapely import Point, Polygon

from ..floor import Descent, Slot
from ..growth.front_rules import rules_of
from ..growth.fronts import FLAT, fronts_from
from ..growth.spiral import BLEND
from ..growth.stroke_runs import begins_on
from ..growth.strokes import strokes_of
from ..model import Floats, PocketRequest
from ..shapes.points import distances_along
from ..shapes.polyline import between, closed_line, located, points_at
from ..shapes.shaping import grow_coarsely, largest, oriented, simplified_region
from ..shapes.skeleton import Skeleton
from .leaving import STRAIGHT, bends
from .outline import WIDTH, outline_of
from .sharp_corners import run_into_corners
from .slot import beside, slot_lead
from .stairs import leaves_crumbs, stairs_of
from .start import Start, slot_bite

#: A spiral begins beside a middle of the plug: where there is this share of the most room.
DEEP = 0.8
#: So far beside corners all loops of a slot run along the wall, over R; the first that leaves
#: nothing on the floor.
BARE = (0.0, 0.25, 0.6)
#: Stairs that save more than this over all stock need no comparison: of seventy pockets none lost.
SURE = 0.085


def wall_slot(region: Polygon, axis: Skeleton, request: PocketRequest) -> Start | None:
    """Return the slot once round the wall, None where it cannot be.

    Nor where it cannot begin near the start point that was asked for.

    Parameters
    ----------
    region : shapely.Polygon
        The cutter-center region.
    axis : Skeleton
        Its medial axis.
    request : PocketRequest
    """
    outline = outline_of(region, request.cutter_radius)
    if outline is None:
        return None
    asked = request.start_point
    if asked is not None and outline.ring.distance(Point(asked)) > request.tool_diameter:
        return None
    # beside a middle of the plug lap follows lap for longest, best along a straight wall
    deep = axis.nodes[axis.clearance > DEEP * axis.clearance.max(initial=0.0)]
    if len(deep) == 0 or asked is not None:  # too narrow for an axis, or anywhere near a place
        deep = shapely.get_coordinates(shapely.segmentize(outline.ring, request.cutter_radius))
    zone = BLEND * request.cutter_radius
    leaves = located(outline.ring, deep) - zone / 2
    bent = bends(outline.ring, leaves - zone / 4, 1.5 * zone)
    leaves = leaves[bent <= max(STRAIGHT, float(bent.min()))]

    def begun(lead: float) -> Start:
        """Return the slot that begins so far before where it ends [mm]."""
        begins = (leaves + lead) % outline.ring.length  # it runs the other way round
        if asked is None:  # programs come from the origin
            ahead = np.zeros(len(leaves))
            away = np.hypot(*points_at(outline.ring, begins).T)
        else:  # beside a bend it begins all the same, and ends where the wall is straight
            ahead = away = (outline.ring.project(Point(asked)) - begins) % outline.ring.length
        best = int(np.argmin(away))
        points = between(outline.ring, float(leaves[best]), outline.ring.length)[:-1]
        # the wall is cut climb; the plug lies on the other side: its laps go the other way
        ring = np.vstack([points[:1], points[:0:-1]])
        slot = Slot(ring, slot_bite(request), ahead=float(ahead[best]))
        slot, within = _into_corners(slot, region, outline.within)
        return Start("outline", outline.visited, outline.omega, slot, closed_line(points), within)

    down = Descent(request.axial_depth, 0.0, request.entry.helix_angle)
    slot = Slot(shapely.get_coordinates(outline.ring)[:0:-1], slot_bite(request))
    start = begun(0.0 if asked is None else slot_lead(slot, down))
    wider = _with_stairs(start, outline.within, request)
    if asked is None or wider is start:
        return wider
    assert isinstance(wider.entry, Slot)
    # with stairs the way down is longer
    return _with_stairs(begun(slot_lead(wider.entry, down)), outline.within, request)


def _into_corners(slot: Slot, region: Polygon, rounded: Polygon) -> tuple[Slot, Polygon]:
    """Return a slot whose last loop runs into sharp corners, and all of the region within it."""
    found = run_into_corners(slot.ring, region)
    if found is None:
        return slot, rounded
    ring, wall = found
    within = shapely.intersection(Polygon(wall), region)
    if not isinstance(within, Polygon) or len(within.interiors) != len(region.interiors):
        return slot, rounded
    return replace(slot, ring=ring, wall=wall), oriented(within)


def _with_stairs(start: Start, region: Polygon, request: PocketRequest) -> Start:
    """Return a slot whose loops come nearer to the wall level by level, where that is worth it.

    The corners of the region are rounded as the slot does.
    """
    radius, rules = request.cutter_radius, rules_of(request)
    slot = start.entry
    assert isinstance(slot, Slot)
    for bare in BARE:
        found = stairs_of(slot.ring, region, slot.bite, request, bare)
        if found is None:
            break
        stairs, saved = found
        plug = grow_coarsely(Polygon(stairs.inner), -WIDTH)
        around = Polygon(start.visited.exterior)
        visited = oriented(largest(shapely.difference(around, plug)))
        # as fronts are: full of short chords it takes GEOS up to 0.1 s to grow
        visited = simplified_region(visited, FLAT)
        fronts = tuple(islice(fronts_from(visited, start.omega, rules), 2))
        ring = closed_line(np.vstack([stairs.inner[:1], stairs.inner[:0:-1]]))
        laps = strokes_of(fronts)
        if not laps or leaves_crumbs(stairs, laps, radius):
            continue
        # nothing else leads onto what the stairs leave on the floor
        if not any(begins_on(ring, lap, radius, request.cutting.stepover) for lap in laps):
            break
        if slot.wall is not None:
            stairs = replace(stairs, lines=_last_into_corners(stairs.lines, slot))
        return replace(
            start,
            visited=visited,
            entry=replace(slot, ring=stairs.lines[-1], stairs=stairs, wall=None),
            ring=ring,
            plain=start,
            is_sure=saved > SURE,
            fronts=fronts,
        )
    return start


def _last_into_corners(lines: Floats, slot: Slot) -> Floats:
    """Return the lines of stairs, the last of them where the slot runs into corners."""
    assert slot.wall is not None
    ring, last = closed_line(slot.ring), lines[-1]
    along = distances_along(np.vstack([last, last[:1]]))[:-1]
    wall = beside(slot.wall, distances_along(shapely.get_coordinates(ring)), along)
    return np.concatenate([lines[:-1], wall[None]])
