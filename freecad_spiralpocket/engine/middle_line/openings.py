# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the centers of extended Archimedean spirals are opened.

EAS07 cuts the center curves full wide at the full depth, and names a trochoid as the
cure. Here one slot goes round all of them in shallow levels, and along the medial axis
from one to the next: on machines of ordinary acceleration that is several times faster
than trochoids. A single point is opened by a helix.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import shapely
from shapely import LineString, Point, Polygon

from ..floor import Helix, Slot
from ..model import PocketRequest
from ..opening.entry import fit_helix_radius
from ..opening.slot import slot_end
from ..opening.start import Start
from ..opening.starts import HALF_WIDTHS, slot_round
from ..shapes.polyline import closed_line, ring_from, ring_points
from ..shapes.shaping import grow_coarsely, oriented
from ..shapes.skeleton import Skeleton
from .coverable import Center, along_axis, maximal_centers
from .joints import Joint, joined

#: Half the width of what is opened about centers, over D: less where they cross at right angles.
HALVES = (*HALF_WIDTHS, 0.26, 0.2)
#: Half the width of the ways between centers, over D.
JOINT = 0.3
#: Rounding takes no more than this off what is opened [mm].
ROUNDING = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class Opening:
    """The centers of spirals and how they are opened.

    Attributes
    ----------
    start : Start
    centers : tuple of Center
    half_width : float
        Of what is opened about them [mm].
    joints : tuple of Joint
        Between the centers, by index.
    """

    start: Start
    centers: tuple[Center, ...]
    half_width: float
    joints: tuple[Joint, ...] = ()


def open_centers(region: Polygon, axis: Skeleton, request: PocketRequest) -> Opening:
    """Return the centers of spirals in a region and the slot or helix that opens them.

    As wide as leaves no post where centers meet. If every width leaves one, only the first
    center is opened, at last only its widest place.

    Raises
    ------
    CutterDoesNotFitError
        If there is no room to go down.
    """
    stepover, radius = request.cutting.stepover, request.cutter_radius
    halves = [share * request.tool_diameter for share in HALVES]
    for most in (len(axis.nodes), 1):
        for half in halves:
            centers = maximal_centers(region, axis, half, stepover, radius)[:most]
            if sum(c.curve.length for c in centers) == 0 and len(centers) < 2:
                break
            joints = joined(axis, [c.nodes for c in centers])
            shapes = [grow_coarsely(c.curve, half) for c in centers]
            joint = min(half, JOINT * request.tool_diameter)
            ways = grow_coarsely(_ways(axis, centers, joints), joint)
            start = slot_round(region, shapely.union_all([*shapes, ways]), request)
            if start is not None and _opens(start, shapes, region):
                start = _from_place(start, request)
                return Opening(start, tuple(centers), half, tuple(joints))
    return _open_point(region, axis, request)


def _from_place(start: Start, request: PocketRequest) -> Start:
    """Return a slot that begins as near to the start point as it can, if one is asked for."""
    asked = request.start_point
    if asked is None or not isinstance(start.entry, Slot):
        return start
    end = start.ring.interpolate(slot_end(start.entry, asked, request))
    ring = ring_from(shapely.get_coordinates(start.ring)[:-1], np.array(end.coords[0]))
    return replace(start, entry=replace(start.entry, ring=ring[:-1]), ring=LineString(ring))


def _opens(start: Start, shapes: list[Polygon], region: Polygon) -> bool:
    """Return whether a start opens all of some shapes within a region, but for rounding."""
    wanted = shapely.intersection(shapely.union_all(shapes), region)
    return bool(start.visited.buffer(ROUNDING).covers(wanted))


def _ways(axis: Skeleton, centers: list[Center], joints: list[Joint]) -> shapely.Geometry:
    """Return the ways between centers, up to their smoothed curves."""
    ways = []
    for joint in joints:
        ends = [axis.nodes[joint.nodes[i]] for i in (-1, 0)]
        curves = (centers[joint.one].curve, centers[joint.other].curve)
        line = joint.nodes[::-1]
        whole = len(line) > 1
        way = [shapely.get_coordinates(along_axis(axis, line)) if whole else axis.nodes[line]]
        for end, curve, at in zip(ends, curves, (0, 1), strict=True):
            near = shapely.get_coordinates(shapely.shortest_line(curve, Point(end)))[:1]
            way.insert(0 if at == 0 else len(way), near)
        ways.append(LineString(np.vstack(way)))
    return shapely.union_all(ways)


def _open_point(region: Polygon, axis: Skeleton, request: PocketRequest) -> Opening:
    """Return the opening by a helix at the widest place."""
    place = np.array(shapely.maximum_inscribed_circle(region).coords[0])
    room = 0.0
    nodes = np.empty(0, np.intp)
    if len(axis.nodes):
        nodes = np.array([np.argmax(axis.clearance)])
        place, room = axis.nodes[nodes[0]], float(axis.clearance[nodes[0]])
    radius = fit_helix_radius(region, place, request.cutter_radius, request.entry)
    laps = int(max(0.0, room - radius) / request.cutting.stepover + 1e-6)
    center = Center(Point(place), laps, nodes)
    circle = oriented(grow_coarsely(center.curve, radius))
    points = ring_points(circle.exterior)
    if request.start_point is not None:
        points = ring_from(points, np.array(request.start_point))[:-1]
    angle = float(np.arctan2(*(points[0] - place)[::-1]))
    ring = closed_line(points)
    start = Start("point", circle, region, Helix(place, radius, angle), ring)
    return Opening(start, (center,), radius)
