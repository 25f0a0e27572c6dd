# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets that are open at a side, or cleared in part: peeled from there, or cut from within.

Where the pocket reaches out of the stock, or where it was cleared before, the cutter goes straight
down in the air and fronts grow into the stock from there: no helix, no slot. The curve that these
laps start from is the stock's own side, as EAS07's spirals start from a curve. Whether that is
faster than a spiral from within is simulated, as for all starts. What begins within has nothing to
do out there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely
from shapely import LineString, Point, Polygon
from shapely.ops import substring

from ..errors import CutterDoesNotFitError
from ..floor import Plunge
from ..growth.strokes import Stroke
from ..model import Floats, PocketRequest
from ..shapes.region import grow, polygons_of, rings_of
from ..shapes.shaping import Region, grow_coarsely, largest, oriented, welded
from .start import Start
from .starts import candidates

#: What begins within goes so far beyond what shall be cleared, over R; the first that leaves
#: nothing standing. Round a boss it need not go out; where a wall ends at the side it has to.
OVERHANGS = (-0.9, -0.7, -0.4, 0.02, 0.3, 1.0)
#: What is thinner than twice this is left by rounding alone [mm].
HAIR = 0.01
#: In the air the cutter keeps off the stock by this [mm].
CLEAR = 0.01
#: It goes down where it has so much room around, and begins so far before the first stroke, over R.
ROOM, BEFORE = 0.1, 0.5
#: The air that counts as visited reaches so far, over R: farther than any fillet or closing.
MARGIN = 4.0
#: A stroke along a wall may be beyond it by the first, as rounding has it [mm]. One that is cut off
#: ends the second beyond it, from where links are still within the region.
ALONG, BEYOND = 0.005, 0.002
#: From so many sides peeling is tried, the widest ones.
TRIED = 2
#: What is left of a stroke outside of the air is none if it is shorter than this [mm].
SHORTEST = 0.1


def needed(region: Polygon, request: PocketRequest) -> Polygon:
    """Return the part of a cutter-center region from which all stock in its reach is cleared.

    Parameters
    ----------
    region : shapely.Polygon
    request : PocketRequest
    """
    ground = request.to_clear(request.pocket)
    if ground.equals(request.pocket):
        return region
    wanted = request.to_clear(grow(region, request.cutter_radius))
    # levels above low islands and slopes are wider than the floor
    if not grow_coarsely(shapely.difference(wanted, ground), -HAIR).is_empty:
        ground = shapely.union(ground, wanted)
    inner = needed_for(ground, wanted, region, request.cutter_radius)
    return region if inner is None else inner


def needed_for(ground: Region, wanted: Region, region: Polygon, radius: float) -> Polygon | None:
    """Return the part of a region beside some ground from which all that is wanted is cleared.

    None if it is in several parts.
    """
    for share in OVERHANGS:
        part = shapely.intersection(region, grow_coarsely(ground, share * radius))
        if not part.area:  # nothing, or a line where the two touch
            continue
        inner = largest(part)
        left = shapely.difference(wanted, grow(inner, radius))
        if grow_coarsely(left, -HAIR).is_empty:
            return inner
    return None


def starts_of(region: Polygon, request: PocketRequest) -> list[tuple[Start, Polygon]]:
    """Return the ways to open a region, and the cutter-center region that each keeps to.

    Raises
    ------
    CutterDoesNotFitError
        If there is no room for any entry.
    """
    inner = needed(region, request)
    from_air = _from_air(region, inner, request)
    if from_air and inner is region and _mostly_air(from_air[0][0], region):
        return from_air
    try:
        return [*((start, inner) for start in candidates(inner, request)), *from_air]
    except CutterDoesNotFitError:
        if not from_air:
            raise
    return from_air


def _mostly_air(start: Start, region: Polygon) -> bool:
    """Return whether so much was cleared before that nothing needs to be begun in the stock."""
    free = shapely.intersection(shapely.union_all([start.visited, *start.idle]), region)
    return bool(free.area > region.area / 2)


def strokes_in_stock(strokes: Sequence[Stroke], idle: Sequence[Polygon]) -> list[Stroke]:
    """Return strokes without what of them lies where nothing is cut."""
    if not idle:
        return list(strokes)
    free = shapely.union_all([grow_coarsely(ground, ALONG) for ground in idle])
    kept = []
    for stroke in strokes:
        points = np.vstack([stroke.points, stroke.points[:1]]) if stroke.closed else stroke.points
        rest = shapely.difference(LineString(points), free)
        if rest.length > LineString(points).length - ALONG:
            kept.append(stroke)
            continue
        lines = shapely.line_merge(rest) if rest.geom_type[:5] == "Multi" else rest
        for part in shapely.get_parts(lines):
            if part.length > SHORTEST:
                here = shapely.get_coordinates(part)
                kept.append(replace(stroke, points=here, closed=False))
    return kept


def strokes_within(strokes: Sequence[Stroke], region: Polygon) -> list[Stroke]:
    """Return strokes without what of their ends lies in the air beside the region."""
    here = grow_coarsely(region, ALONG)
    nearer = grow_coarsely(region, BEYOND)
    shapely.prepare(here)
    kept = []
    for stroke in strokes:
        line = LineString(stroke.points)
        if stroke.closed or here.covers(line):
            kept.append(stroke)
            continue
        ends = shapely.get_coordinates(shapely.intersection(line, nearer))
        inside = shapely.line_locate_point(line, shapely.points(ends))
        if len(inside) > 1:
            part = substring(line, inside.min(), inside.max())
            kept.append(replace(stroke, points=shapely.get_coordinates(part)))
    return kept


def _from_air(
    region: Polygon, inner: Polygon, request: PocketRequest
) -> list[tuple[Start, Polygon]]:
    """Return the starts in the air, from the widest part of it on, and the region of each."""
    stock, radius = request.stock, request.cutter_radius
    if stock is None:
        return []
    asked = None if request.start_point is None else Point(request.start_point)
    solid = grow(stock, radius + CLEAR)
    # the walls need no room: the center keeps off them anyway
    ground = shapely.intersection(stock, grow(region, radius - CLEAR))
    standing = grow(ground, radius + CLEAR)
    sides = [
        side
        for side in polygons_of(shapely.difference(region, standing))
        if not grow_coarsely(side, -ROOM * radius).is_empty
    ]
    beyond = polygons_of(shapely.difference(region, inner))
    starts: list[tuple[Start, Polygon]] = []
    for side in sides:
        if any(start.idle and start.omega.contains(side.centroid) for start, _ in starts):
            continue  # from there it is reached as well
        elsewhere = [other for other in beyond if not other.intersects(side)]
        within = oriented(largest(shapely.difference(region, shapely.union_all(elsewhere))))
        if within.intersects(side) and (asked is None or side.intersects(asked)):
            air = shapely.difference(_beside(side, request), solid)
            air = shapely.difference(air, shapely.difference(within, side))
            others = [shapely.intersection(o, within) for o in sides if o is not side]
            idle = [largest(o) for o in others if not grow_coarsely(o, -ROOM * radius).is_empty]
            starts.append((_from(side, within, air, idle, radius, asked), within))
        if len(starts) == TRIED:
            break
    return starts


def _beside(side: Polygon, request: PocketRequest) -> Region:
    """Return the ground about a side of a region that may be air.

    Not where stock is all around: ribs that end below other levels were no stock for what cleared
    these. With open sides only beyond them.
    """
    reach = MARGIN * request.cutter_radius
    ground = grow_coarsely(side, reach)
    if request.beyond is not None:
        ground = shapely.intersection(ground, grow_coarsely(request.beyond, reach))
    inside = [Polygon(part.exterior) for part in polygons_of(request.stock)]
    return shapely.difference(ground, shapely.union_all(inside))


def _from(
    side: Polygon,
    within: Polygon,
    air: Region,
    idle: Sequence[Polygon],
    radius: float,
    asked: Point | None,
) -> Start:
    """Return the start from a side of a region, the air about which fronts take as visited."""
    first, heading = _beginning(side, within)
    near = grow_coarsely(side, -ROOM * radius)
    target = Point(first - BEFORE * radius * heading) if asked is None else asked
    place = np.array(shapely.shortest_line(near, target).coords[0])
    visited, omega = (oriented(largest(welded([shape, air]))) for shape in (side, within))
    ring = _loop(place, heading, ROOM * radius)
    return Start("open side", visited, omega, Plunge(place), ring, idle=tuple(idle))


def _beginning(side: Polygon, within: Polygon) -> tuple[Floats, Floats]:
    """Return where the first stroke from a side begins, climb, and in which direction."""
    wall = grow_coarsely(within.boundary, 2 * CLEAR)
    edges = [shapely.difference(ring, wall) for ring in rings_of(side)]
    lines = [shapely.line_merge(e) if e.geom_type[:5] == "Multi" else e for e in edges]
    pieces = [p for line in lines for p in shapely.get_parts(line) if p.length > 0]
    longest = max(pieces, key=lambda p: p.length, default=LineString(side.exterior))
    begin, ahead = shapely.get_coordinates(longest)[:2]
    return begin, (ahead - begin) / np.hypot(*(ahead - begin))


def _loop(place: Floats, heading: Floats, radius: float) -> LineString:
    """Return a small loop to the left from a place, which stands for the entry's last lap."""
    turn = np.linspace(0, 2 * np.pi, 25)
    left = np.array([-heading[1], heading[0]])
    ahead = np.sin(turn)[:, None] * heading + (1 - np.cos(turn))[:, None] * left
    return LineString(place + radius * ahead)
