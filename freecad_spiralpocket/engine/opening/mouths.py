# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mouths: what a ring round islands leaves of their walls, where bridges meet them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
import shapely.ops
from numpy.typing import NDArray
from shapely import LineString, Polygon

from ..model import Floats
from ..shapes.drawing_near import drawn_to
from ..shapes.polyline import between, located, points_at
from ..shapes.region import polygons_of
from ..shapes.shaping import CRACK, Region
from .start import Start

#: Strokes at the mouths of bridges begin and end so much early and late, over R.
OVERRUN = 0.5
#: Where the ring meets an island's wall nowhere its stroke comes onto that over so much, over R.
LEAD = 2.0
#: An island's wall has a mouth or a notch where it is farther than the first from the ring round it
#: [mm]; a notch that is nothing else, too, where it is farther than the second.
PASSED_BY = (0.05, 0.02)
#: Height of the cusp at an island's wall between the two sides of a bridge, over R, and a little.
CUSP = 0.8


def mouths_of(start: Start, region: Polygon, radius: float) -> list[Floats]:
    """Return the parts of ringed islands' walls where bridges meet them, and shallow notches.

    They are cut last: the laps around them make the room to reach them. Each is a line (n, 2)
    that runs on by `OVERRUN` at both ends.

    Parameters
    ----------
    start : Start
    region : shapely.Polygon
        The cutter-center region.
    radius : float
        The cutter's [mm].
    """
    walls = [LineString(w.coords) for w in region.interiors if start.omega.contains(w)]
    if not walls:
        return []
    near, nearer = (shapely.buffer(start.ring, off) for off in PASSED_BY)
    overrun = OVERRUN * radius
    mouths = []
    for wall in walls:
        parts, shallow = _parts_outside(wall, near), _parts_outside(wall, nearer)
        if len(parts):
            shallow = shallow[~shapely.dwithin(shallow, shapely.union_all(parts), CRACK)]
        for part in (*parts, *shallow):
            if part.is_closed:  # the ring meets the wall nowhere
                mouths.append(_led_onto(wall, start.ring, LEAD * radius))
                continue
            begin = wall.project(shapely.Point(part.coords[0]))
            along = between(wall, begin, part.length)
            lead = _overrun(wall, begin, start.ring, -overrun)
            rest = _overrun(wall, begin + part.length, start.ring, overrun)
            mouths.append(np.vstack([lead[:-1], along, rest[1:]]))
    return mouths


def _overrun(wall: LineString, at: float, ring: LineString, length: float) -> Floats:
    """Return the way on from a place along a wall, or the way to there if `length` is negative.

    Shape (n, 2) [mm]; along the wall, or where the ring only touches that, along the ring: beyond
    stands what another stroke cuts.
    """
    way = between(wall, min(at, at + length), abs(length))
    if shapely.distance(ring, shapely.points(way)).max() < 2 * PASSED_BY[0]:
        return way
    place = points_at(wall, np.array([at % wall.length]))[0]
    there = ring.project(shapely.Point(place))
    ahead = way[-1] - way[-2] if length < 0 else way[1] - way[0]
    near = points_at(ring, (there + np.array([-0.1, 0.1])) % ring.length)
    with_it = bool((near[1] - near[0]) @ ahead > 0)
    # as far behind or ahead on the ring as the wall goes on
    onward = length if with_it else -length
    way = between(ring, min(there, there + onward), abs(length))
    way = shapely.get_coordinates(shapely.segmentize(LineString(way), abs(length) / 10))
    way = way if with_it else way[::-1]
    return _out_of(wall, drawn_to(way, place, abs(length), at_end=length < 0))


def _led_onto(wall: LineString, ring: LineString, lead: float) -> Floats:
    """Return the way from where a ring is nearest to a wall along all of that, shape (n, 2) [mm].

    It comes nearer to the wall over `lead` [mm], and runs on by as much in the end.
    """
    near = np.array(shapely.shortest_line(wall, ring).coords)
    points = between(wall, wall.project(shapely.Point(near[0])), wall.length + lead)
    points = shapely.get_coordinates(shapely.segmentize(LineString(points), lead / 20))
    return _out_of(wall, drawn_to(points, near[1], lead))


def _out_of(wall: LineString, way: Floats) -> Floats:
    """Return a way with what is within an island's closed wall moved onto that."""
    within = shapely.contains_xy(Polygon(wall), way)
    way[within] = points_at(wall, located(wall, way[within]))
    return way


def _parts_outside(line: LineString, ground: Region) -> NDArray[np.object_]:
    """Return the parts of a line outside of some ground that are worth a stroke."""
    parts = shapely.get_parts(shapely.line_merge(shapely.difference(line, ground)))
    return parts[shapely.length(parts) > 0.1]


def cusps_at(mouths: Sequence[Floats], radius: float) -> list[Polygon]:
    """Return where cusps stand at mouths until these are cut; `radius` is the cutter's [mm]."""
    inner = [
        shapely.ops.substring(LineString(m), OVERRUN * radius, -OVERRUN * radius) for m in mouths
    ]
    zones = [line.buffer(CUSP * radius, cap_style="flat", quad_segs=4) for line in inner]
    # about a short mouth with a corner in it such a zone falls apart
    return [part for zone in zones for part in polygons_of(zone)]
