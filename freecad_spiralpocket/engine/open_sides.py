# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets that are open at a side: the stock is peeled from there, or cut from within.

Where the pocket reaches out of the stock, the cutter goes straight down in the air beside it and
fronts grow inwards from there: no helix, no slot. The curve that these laps start from is the
stock's own side, as EAS07's spirals start from a curve. Whether that is faster than a spiral from
within is simulated, as for all starts. What begins within has nothing to do out there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely
from shapely import LineString, Point, Polygon
from shapely.ops import substring

from .errors import CutterDoesNotFitError
from .floor import Plunge
from .model import Floats, PocketRequest
from .region import grow, polygons_of
from .shaping import Region, buffer, largest, oriented, welded
from .starts import Start, candidates
from .strokes import Stroke

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
#: A stroke along a wall may be beyond it by this, as rounding has it [mm].
ALONG = 0.005
#: From so many sides peeling is tried, the widest ones.
TRIED = 2


def needed(region: Polygon, request: PocketRequest) -> Polygon:
    """Return the part of a cutter-center region from which all stock in its reach is cleared.

    Parameters
    ----------
    region : shapely.Polygon
    request : PocketRequest
    """
    radius, ground = request.cutter_radius, request.to_clear(request.pocket)
    if ground.equals(request.pocket):
        return region
    wanted = request.to_clear(grow(region, radius))
    for share in OVERHANGS:
        part = shapely.intersection(region, buffer(ground, share * radius))
        if part.is_empty:
            continue
        inner = largest(part)
        left = shapely.difference(wanted, grow(inner, radius))
        if buffer(left, -HAIR).is_empty:
            return inner
    return region


def starts_of(region: Polygon, request: PocketRequest) -> list[tuple[Start, Polygon]]:
    """Return the ways to open a region, and the cutter-center region that each keeps to.

    Raises
    ------
    CutterDoesNotFitError
        If there is no room for any entry.
    """
    inner = needed(region, request)
    peeled = _from_sides(region, inner, request)
    try:
        return [*((start, inner) for start in candidates(inner, request)), *peeled]
    except CutterDoesNotFitError:
        if not peeled:
            raise
    return peeled


def strokes_within(strokes: Sequence[Stroke], region: Polygon) -> list[Stroke]:
    """Return strokes without what of their ends lies in the air beside the region."""
    here = buffer(region, ALONG)
    shapely.prepare(here)
    kept = []
    for stroke in strokes:
        line = LineString(stroke.points)
        if stroke.closed or here.covers(line):
            kept.append(stroke)
            continue
        ends = shapely.get_coordinates(shapely.intersection(line, here))
        inside = shapely.line_locate_point(line, shapely.points(ends))
        if len(inside) > 1:
            part = substring(line, inside.min(), inside.max())
            kept.append(replace(stroke, points=shapely.get_coordinates(part)))
    return kept


def _from_sides(
    region: Polygon, inner: Polygon, request: PocketRequest
) -> list[tuple[Start, Polygon]]:
    """Return the starts in the air, from the widest side on, and the region of each."""
    stock, radius = request.stock, request.cutter_radius
    if stock is None or request.start_point is not None:
        return []
    solid = grow(stock, radius + CLEAR)
    sides = polygons_of(shapely.difference(region, solid))
    beyond = polygons_of(shapely.difference(region, inner))
    starts = []
    for side in sides:
        elsewhere = [other for other in beyond if not other.intersects(side)]
        within = oriented(largest(shapely.difference(region, shapely.union_all(elsewhere))))
        if not buffer(side, -ROOM * radius).is_empty and within.intersects(side):
            air = shapely.difference(buffer(side, MARGIN * radius), solid)
            air = shapely.difference(air, shapely.difference(within, side))
            starts.append((_from(side, within, air, radius), within))
        if len(starts) == TRIED:
            break
    return starts


def _from(side: Polygon, within: Polygon, air: Region, radius: float) -> Start:
    """Return the start from a side of a region, the air about which fronts take as visited."""
    first, heading = _beginning(side, within)
    near = buffer(side, -ROOM * radius)
    near = shapely.shortest_line(near, Point(first - BEFORE * radius * heading))
    place = np.array(near.coords[0])
    visited, omega = (oriented(largest(welded([shape, air]))) for shape in (side, within))
    ring = _loop(place, heading, ROOM * radius)
    return Start("open side", visited, omega, Plunge(place), ring)


def _beginning(side: Polygon, within: Polygon) -> tuple[Floats, Floats]:
    """Return where the first stroke from a side begins, climb, and in which direction."""
    wall = buffer(within.boundary, 2 * CLEAR)
    edges = [shapely.difference(ring, wall) for ring in (side.exterior, *side.interiors)]
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
