# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where fronts may start: candidates for the opening of a region.

How a pocket is opened decides elongated pockets and pockets with islands:

- a *point*: a helix at the innermost place, for compact regions (CS08's center);
- a *curve*: a slot about a piece of the medial axis (EAS07's center curve), opened
  as a racetrack so that no post remains and nothing reverses;
- an *island ring*: once round all islands, joined by bridges. After that no front
  ever meets an island; everything is laps outwards to the outer wall;
- the *outline*: once round the wall, and inwards from there (wall_slot.py);
- an *open side*: from the air beside the stock (open_sides.py).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np
import shapely
from shapely import LineString, Point, Polygon

from ..errors import CutterDoesNotFitError
from ..floor import Groove, Helix, Slot
from ..growth.fronts import FLAT
from ..growth.spiral import BLEND
from ..model import Floats, PocketRequest
from ..shapes.polyline import between, closed_line
from ..shapes.region import grow
from ..shapes.shaping import (
    SLIVER,
    Region,
    grow_coarsely,
    largest,
    oriented,
    simplified_region,
)
from ..shapes.skeleton import (
    Edges,
    Skeleton,
    longest_edges,
    longest_path,
    medial_axis,
    peel,
    without_spurs,
)
from .branches import feet_between, lengthened, slim_ring, smoothed
from .entry import NARROWEST, WIDEST, fit_helix_radius
from .groove import loop_rooms
from .islands import bridges_between, into_notches
from .leaving import straightest
from .start import Start, equal_bite, slot_bite
from .wall_slot import wall_slot

#: The whole tree is tried if it is longer than its longest path by this.
BRANCHED = 1.15
#: Vertices of the tree that matter less than this are left out [mm].
SPINE_SLACK = 0.1
#: Half the racetrack's width over D; less where a post would remain in a bend.
HALF_WIDTHS = (0.46, 0.42, 0.38, 0.33)
#: Slots run about the axis peeled to this share of the largest clearance, without branches shorter
#: than this over the clearance at their foot.
UNFORKED, SPUR = 0.8, 1.6
#: A racetrack is tried as well where walls are so near to the axis, over D: it clears all at once.
NARROW = 1.0
#: Ends of a groove with this share of the most room are as good.
ROOMY = 0.8
#: A groove is tried where a slot's bite stays below the equal one by this.
CAPPED = 0.95
#: Half the distance between the ways forth and back of a groove, over D.
GROOVE_HALF_WIDTH = 0.08
#: At each tip of a groove there is at least so much room for its ramp, over R.
LEAST_ROOM = 0.1
#: Radius of reentrant curves of the racetrack, over R; the first that leaves no post.
ROUNDINGS = (1.0, 0.5)
#: The same for the ring round islands.
RING_ROUNDINGS = (1.0, 0.5, 0.2, 0.1, 0.02, 0.005, 0.002, 0.0005)
#: The ring keeps off the islands' walls by this [mm].
CHORD_SLACK = 0.004
#: Width of the smoothing of the center curve, over R.
SMOOTHING = 1.0


def candidates(region: Polygon, request: PocketRequest) -> list[Start]:
    """Return the ways to open a region, at least one.

    Raises
    ------
    CutterDoesNotFitError
        If there is no room for any entry.
    """
    axis = medial_axis(region)
    asked = request.start_point
    if asked is not None and region.distance(Point(asked)) < request.tool_diameter:
        near = _near(region, axis, request)
        if near:
            return near
    # elsewhere any place is as good
    request = replace(request, start_point=None)
    starts: list[Start] = []
    failure = None
    try:
        starts.append(_point(region, _innermost(region, axis), request))
    except CutterDoesNotFitError as error:
        failure = error
    # the axis round islands has no one path; a slot along a part of it is a poor start
    ringed = island_ring(region, request) if region.interiors else None
    starts.extend([ringed] if ringed is not None else _slots(region, axis, request))
    outlined = wall_slot(region, axis, request)
    if outlined is not None:
        starts.append(outlined)
    starts = [start for start in starts if not _is_plunge(start, request)]
    if not starts:
        raise (
            failure
            if failure is not None
            else CutterDoesNotFitError(
                "The cutter has no room to go down anywhere in the pocket.",
                "Take a smaller cutter.",
            )
        )
    return starts


def _near(region: Polygon, axis: Skeleton, request: PocketRequest) -> list[Start]:
    """Return the ways to open a region near the start point that was asked for; maybe none."""
    outlined = wall_slot(region, axis, request)
    starts = [] if outlined is None else [outlined]
    with suppress(CutterDoesNotFitError):
        starts.insert(0, _point(region, _roomy(region, axis, request), request))
    return [start for start in starts if not _is_plunge(start, request)]


def _is_plunge(start: Start, request: PocketRequest) -> bool:
    """Return whether a slot is so short that the cutter would hardly move but down."""
    shortest = 2 * np.pi * NARROWEST * request.cutter_radius
    return isinstance(start.entry, Slot) and start.ring.length < shortest


def _slots(region: Polygon, axis: Skeleton, request: PocketRequest) -> list[Start]:
    """Return the ways to open a long region along its middle."""
    starts = []
    if slot_bite(request) < CAPPED * equal_bite(request):
        starts = _grooves(region, axis, request)
    if not starts or axis.clearance.max() < NARROW * request.tool_diameter:
        raced = [_curve(region, spine, request) for spine in _spines(axis, request)]
        starts.extend(start for start in raced if start is not None)
    return starts


def _innermost(region: Polygon, axis: Skeleton) -> Floats:
    """Return the place that is farthest from all walls."""
    if len(axis.nodes):
        return axis.nodes[int(np.argmax(axis.clearance))]
    return np.array(shapely.maximum_inscribed_circle(region).coords[0])


def _roomy(region: Polygon, axis: Skeleton, request: PocketRequest) -> Floats:
    """Return the place nearest to the start point that was asked for with room for a helix."""
    widest = float(region.boundary.distance(Point(_innermost(region, axis))))
    roomy = grow_coarsely(region, -min(WIDEST * request.cutter_radius, 0.99 * widest))
    return np.array(shapely.shortest_line(roomy, Point(request.start_point)).coords[0])


def _point(region: Polygon, center: Floats, request: PocketRequest) -> Start:
    radius = fit_helix_radius(region, center, request.cutter_radius, request.entry)
    angles = np.linspace(0, 2 * np.pi, 97)[:-1]
    circle = center + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    ring = closed_line(circle)
    return Start("point", oriented(Polygon(circle)), region, Helix(center, radius), ring)


def _spines(axis: Skeleton, request: PocketRequest) -> list[shapely.Geometry]:
    """Return the curves to open: the longest path of the peeled axis, and all of it if branched."""
    radius = request.cutter_radius
    edges = without_spurs(axis, peel(axis, UNFORKED), SPUR)
    points = longest_path(axis, edges)
    if len(points) < 2 or LineString(points).length <= radius:
        return []
    path = LineString(points)
    spines: list[shapely.Geometry] = [LineString(smoothed(path, SMOOTHING * radius))]
    pieces = shapely.multilinestrings([axis.nodes[list(edge)] for edge in edges])
    tree = shapely.simplify(shapely.line_merge(pieces), SPINE_SLACK)
    if tree.length > BRANCHED * path.length and not _has_loop(edges):
        spines.append(tree)
    return spines


def _has_loop(edges: Edges) -> bool:
    nodes = {node for edge in edges for node in edge}
    return len(edges) >= len(nodes)


def _curve(region: Polygon, spine: shapely.Geometry, request: PocketRequest) -> Start | None:
    for half in HALF_WIDTHS:
        start = slot_round(region, grow_coarsely(spine, half * request.tool_diameter), request)
        if start is not None:
            return start
    return None


def slot_round(
    region: Polygon,
    shape: Polygon,
    request: PocketRequest,
    roundings: Sequence[float] = ROUNDINGS,
) -> Start | None:
    """Return the start that opens a shape by going round it; None if a post remains in it.

    Parameters
    ----------
    region : shapely.Polygon
        The cutter-center region.
    shape : shapely.Polygon
        Nowhere wider than the cutter clears from its edge.
    request : PocketRequest
    roundings : sequence of float, optional
        Radii of its reentrant curves over R: the first is taken that leaves no post.
    """
    for rounding in roundings:
        visited = _rounded(shape, region, rounding * request.cutter_radius, grow_coarsely)
        if not visited.is_empty and leaves_no_post(visited, request):
            return _slot_start("curve", visited, region, request)
    return None


def _grooves(region: Polygon, axis: Skeleton, request: PocketRequest) -> list[Start]:
    """Return slots forth and back along a long region's middle, and along all its branches."""
    edges = without_spurs(axis, peel(axis, UNFORKED), SPUR)
    path = longest_edges(axis, edges)
    if not path:
        return []
    trees = [path]
    if not _has_loop(edges) and len(edges) > BRANCHED * len(path):
        trees.append(edges)
    starts = [_groove(region, axis, tree, request) for tree in trees]
    return [start for start in starts if start is not None]


def _groove(region: Polygon, axis: Skeleton, edges: Edges, request: PocketRequest) -> Start | None:
    """Return the slot about a tree; None where that is shorter than the cutter is wide."""
    branches, tips = lengthened(axis, edges, region, SMOOTHING * request.cutter_radius)
    if sum(LineString(b).length for b in branches) < request.tool_diameter:
        return None
    visited = slim_ring(branches, GROOVE_HALF_WIDTH * request.tool_diameter, region)
    rim = LineString(visited.exterior.coords)
    room = shapely.distance(region.boundary, shapely.points(tips))
    # the spiral begins where there is room; programs come from the origin
    roomy = np.flatnonzero(room > ROOMY * room.max())
    first = int(roomy[np.argmin(np.hypot(*tips[roomy].T))])
    points = between(rim, rim.project(Point(tips[first])), rim.length)[:-1]
    ring = closed_line(points)
    others = sorted(ring.project(Point(t)) for t in np.delete(tips, first, axis=0))
    feet, trunk = feet_between(ring, others, axis, edges)
    groove = Groove(points, tuple(others), tuple(feet), trunk, slot_bite(request))
    if min(loop_rooms(groove, ring.length)) < LEAST_ROOM * request.cutter_radius:
        return None  # a tip at the foot of its own branch
    return Start("groove", visited, region, groove, ring)


def _rounded(
    shape: Polygon, omega: Polygon, q: float, shrink: Callable[[Region, float], Region]
) -> Polygon:
    """Return `shape` within `omega`, its reentrant curves at least of radius `q` [mm].

    These are as fine as `shrink` makes them, which grows a region by a negative distance.
    """
    bumps = 0.5 * q
    shape = grow_coarsely(shrink(grow_coarsely(shape, q), -q - bumps), bumps)
    return largest(shapely.intersection(shape, omega))


def leaves_no_post(
    visited: Polygon, request: PocketRequest, islands: Sequence[Polygon] = ()
) -> bool:
    """Return whether the cutter, its center once round `visited`, clears all of it but islands.

    Parameters
    ----------
    visited : shapely.Polygon
    request : PocketRequest
        For the cutter's radius.
    islands : sequence of shapely.Polygon, optional
    """
    ring = LineString(shapely.simplify(visited.exterior, 0.01).coords)
    swept = shapely.buffer(ring, request.cutter_radius, quad_segs=16)
    standing = shapely.difference(Polygon(visited.exterior), shapely.union_all([swept, *islands]))
    return bool(standing.area < SLIVER)


def _slot_start(name: str, visited: Polygon, omega: Polygon, request: PocketRequest) -> Start:
    ring = LineString(shapely.get_coordinates(shapely.simplify(visited.exterior, 0.002)))
    leave = straightest(ring, BLEND * request.cutter_radius, request.cutter_radius)
    points = between(ring, leave, ring.length)[:-1]
    closed = closed_line(points)
    return Start(name, visited, omega, Slot(points, slot_bite(request)), closed)


def island_ring(region: Polygon, request: PocketRequest) -> Start | None:
    """Return the ring round all islands, bridged along a shortest tree; None if it is no ring."""
    filled, radius = Polygon(region.exterior), request.cutter_radius
    # chords of the ring cut into round islands by about so much
    islands = [grow_coarsely(Polygon(r), CHORD_SLACK) for r in region.interiors]
    bridges = bridges_between(islands)
    if not all(filled.contains(b) for b in bridges):
        return None
    for half in HALF_WIDTHS:
        corridors = [grow_coarsely(b, half * request.tool_diameter) for b in bridges]
        shape = largest(shapely.union_all([*islands, *corridors]))
        # a narrow channel between islands must not be filled: nothing would go through it
        for rounding in RING_ROUNDINGS:
            # coarse chords across hollows, on top of what curves leave, would be a skin on the wall
            round_ = _rounded(shape, filled, rounding * radius, grow)
            visited = simplified_region(Polygon(round_.exterior), FLAT)
            visited = into_notches(visited, shape, region, corridors, rounding * radius, radius)
            if visited.area and leaves_no_post(visited, request, islands):
                return _slot_start("island ring", oriented(visited), filled, request)
    return None
