# SPDX-License-Identifier: LGPL-2.1-or-later
"""Extended Archimedean: spirals about pieces of the medial axis, joined by clothoids [EAS07].

1. The pieces that cover most become the centers of spirals (coverable.py).
2. All centers are opened at once, by a slot in shallow levels along the medial axis that joins
   them (openings.py, joints.py): the paper cuts them full wide at the full depth.
3. Spirals of even spacing b unwind about them until they would meet a wall (archimedean.py), in
   the order of a shortest walk over the joints, linked by clothoids through cleared
   ground (clothoid_links.py); where none fits by the routes of Automatic, or a lift.
4. What is left, corners and the margin between spirals and walls, is taken by laps and strokes
   parallel to the edge of what is cleared, up to the wall (fronts.py): closed laps
   go on as one spiral, open strokes leave and meet the walls tangentially.

Islands are obstacles like walls. In spirals of even spacing the engagement is a little above that
of a straight cut; the report says how far.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from itertools import islice

import numpy as np
import shapely
from shapely import LineString, Polygon

from ..errors import NotYetError
from ..floor import FloorPath
from ..growth.corners import levels_from
from ..growth.front_rules import rules_of
from ..growth.fronts import MAX_FRONTS
from ..growth.stroke_runs import runs_of
from ..growth.strokes import Stroke, strokes_of
from ..links.cleared import ClearedMap, pixel_of
from ..links.estimates import motion_of
from ..links.ordering import SLACK, Situation, Step, order
from ..links.passes import passes_of, with_leads
from ..links.routing import LongWays
from ..middle_line.archimedean import Spiral, bend_at, spiral_about
from ..middle_line.clothoid_links import Place, clothoid_link, clothoid_way, turn_away
from ..middle_line.clothoids import ClothoidPath
from ..middle_line.joints import walk_over
from ..middle_line.openings import Opening, open_centers
from ..model import Floats, PocketRequest, Tick
from ..opening.start import Start
from ..shapes.points import distances_along, unit, wrapped
from ..shapes.polyline import points_at, ring_points
from ..shapes.shaping import largest, oriented, slim_region
from ..shapes.skeleton import Skeleton, medial_axis

#: Laps are no farther apart than this over D: in a square bend they are 1.41 times as far.
WIDEST = 0.7
#: Places of a spiral's first lap where it may be begun.
BEGINNINGS = 12
#: So many of those with the least detour are tried, and along a longer way.
TRIED, ROUTED = 6, 6
#: A spiral whose first lap passes this near begins without a link, and so do laps and strokes [mm].
TOUCHES = 0.05
#: Links by clothoids are cuts over this at both ends, over R.
LEAD = 0.5
#: It comes to its own over this length [mm].
MERGES = 5.0


@dataclass(frozen=True, slots=True, eq=False)
class Layout:
    """All that is cut after the entry.

    Attributes
    ----------
    opening : Opening
    spirals : tuple of Spiral
        In the order in which they are cut.
    links : tuple of ClothoidPath or None
        The way to each; None where it is none or no clothoids.
    steps : tuple of Step
        The spirals' first, one each, then those of the laps and strokes that follow.
    """

    opening: Opening
    spirals: tuple[Spiral, ...]
    links: tuple[ClothoidPath | None, ...]
    steps: tuple[Step, ...]


def floor_path(region: Polygon, request: PocketRequest, tick: Tick) -> FloorPath:
    """Make the path of one cutter-center region.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise.
    request : PocketRequest
    tick : callable
        See `model.Tick`.

    Raises
    ------
    CutterDoesNotFitError
        If there is no room to go down.
    NotYetError
        If the region is thousands of step-overs wide.
    """
    layout = lay(region, request, tick)
    passes = passes_of(list(layout.steps), region, request)
    path = FloorPath(layout.opening.start.entry, passes)
    return with_leads(path, _tight(layout), LEAD * request.cutter_radius)


def _tight(layout: Layout) -> list[int]:
    """Return the passes that are links between spirals by clothoids.

    These begin and end on the very edge of the stock, which they may touch.
    """
    found, number = [], 0
    for step, clothoids in zip(layout.steps, layout.links, strict=False):
        has_way = step.link is None or len(step.link) > 0
        if clothoids is not None:
            found.append(number)
        number += 1 + has_way
    return found


def lay(region: Polygon, request: PocketRequest, tick: Tick) -> Layout:
    """Return the spirals of one cutter-center region, with their links and what follows them.

    Parameters and errors are those of `floor_path`.
    """
    region = slim_region(region)
    spacing = min(request.cutting.stepover, WIDEST * request.tool_diameter)
    request = replace(request, cutting=replace(request.cutting, stepover=spacing))
    axis = medial_axis(region, request.tool_diameter)
    opening = open_centers(region, axis, request)
    tick(0.2)
    spirals = _in_order(opening, axis, request)
    fronts, laps = [oriented(opening.start.visited)], []
    for i, spiral in enumerate(spirals):
        for within in spiral.within[1:]:
            visited = largest(shapely.union(fronts[-1], within))
            laps.append((i, Stroke(_ring(within), len(fronts), True, True)))
            fronts.append(oriented(shapely.simplify(visited, 0.002)))
    turns = len(fronts) - 1
    rules = rules_of(request)
    for front, _ in islice(levels_from(fronts[-1], region, rules), 1, None):
        tick(0.4)
        fronts.append(front)
        if len(fronts) > turns + MAX_FRONTS:
            raise NotYetError(
                f"More than {MAX_FRONTS} laps are left beside the spirals.",
                "Take a wider cutter or a larger step-over.",
            )
    rest = [replace(s, level=s.level + turns) for s in strokes_of(fronts[turns:])]
    strokes = rest + [lap for _, lap in laps]
    radius = request.cutter_radius
    cleared = ClearedMap(fronts, strokes, region, (), radius, pixel_of(request))
    owners = [i for i, _ in laps]
    freed = [
        [len(rest) + k for k, owner in enumerate(owners) if owner == i] for i in range(len(spirals))
    ]
    steps, links = _linked(opening.start, spirals, freed, cleared, region, request)
    tick(0.6)
    here, heading = _end_of(steps, opening.start)
    if rest:
        runs = runs_of(rest, fronts, opening.start.ring, radius, request.cutting.stepover)
        situation = Situation(cleared, region, here, heading, motion_of(request), radius)
        ordered = order(runs, situation, partial(tick, 0.8))
        steps += [_without_hairpin(step) for step in ordered]
    return Layout(opening, tuple(spirals), tuple(links), tuple(steps))


def _without_hairpin(step: Step) -> Step:
    """Return a step without its link if it begins where the one before ended, but for a touch."""
    link = step.link
    if link is None or len(link) < 2 or np.hypot(*(link[-1] - link[0])) >= TOUCHES:
        return step
    return replace(step, link=np.empty((0, 2)))


def _in_order(opening: Opening, axis: Skeleton, request: PocketRequest) -> list[Spiral]:
    """Return the spirals about the centers that have room for laps, in a short order."""
    centers = opening.centers
    middles = np.array([shapely.get_coordinates(c.curve.centroid)[0] for c in centers])
    turning = [i for i, c in enumerate(centers) if c.laps > 0]
    order_ = walk_over(opening.joints, turning, middles, axis) if turning else []
    half, stepover, radius = opening.half_width, request.cutting.stepover, request.cutter_radius
    return [spiral_about(centers[i], half, stepover, radius) for i in order_]


def _ring(shape: Polygon) -> Floats:
    """Return the outside of a polygon, its first point not repeated."""
    return ring_points(shape.exterior)


def _linked(
    start: Start,
    spirals: list[Spiral],
    freed: list[list[int]],
    cleared: ClearedMap,
    region: Polygon,
    request: PocketRequest,
) -> tuple[list[Step], list[ClothoidPath | None]]:
    """Return the spirals with the ways to them, and those that are clothoids."""
    fence = shapely.buffer(region, SLACK)
    shapely.prepare(fence)
    steps: list[Step] = []
    links: list[ClothoidPath | None] = []
    ring, at = start.ring, 0.0
    for spiral, strokes in zip(spirals, freed, strict=True):
        link, clothoids, begin = _way_to(spiral, ring, at, cleared, fence, request)
        points, end = spiral.unwound(begin)
        if link is not None and len(link) == 0:
            points = _from(points_at(ring, np.array([at]))[0], points)
        steps.append(Step(link, points, -1))
        links.append(clothoids)
        for stroke in strokes:
            cleared.finish(stroke)
        ring, at = spiral.rings[-1], end
    if steps:
        # away from the stock, as the links between spirals begin
        tail = turn_away(Place(*bend_at(ring, at, request.cutter_radius)), request.cutter_radius)
        last = np.vstack([steps[-1].points, tail.sampled(request.tolerance / 2)[1:]])
        steps[-1] = replace(steps[-1], points=last)
    return steps, links


def _from(here: Floats, points: Floats) -> Floats:
    """Return a path that begins `here`, a hair beside its start, and comes back to itself."""
    along = distances_along(points)
    return points + np.maximum(0.0, 1 - along / MERGES)[:, None] * (here - points[0])


def _way_to(
    spiral: Spiral,
    ring: LineString,
    at: float,
    cleared: ClearedMap,
    fence: Polygon,
    request: PocketRequest,
) -> tuple[Floats | None, ClothoidPath | None, float]:
    """Return the way from a place of a ring to a spiral, its clothoids, and where that begins."""
    first = spiral.rings[0]
    here = points_at(ring, np.array([at]))[0]
    nearest = float(first.project(shapely.Point(here)))
    if first.distance(shapely.Point(here)) < TOUCHES:
        return np.empty((0, 2)), None, nearest
    beginnings = (nearest + np.arange(BEGINNINGS) * first.length / BEGINNINGS) % first.length
    radius, motion = request.cutter_radius, motion_of(request)
    leave = Place(*bend_at(ring, at, radius))
    arrive = [_beginning(spiral, float(b), radius) for b in beginnings]
    near = np.argsort([_detour(leave, place, radius) for place in arrive], kind="stable")[:TRIED]
    beginnings, arrive = beginnings[near], [arrive[i] for i in near]
    found = clothoid_link(leave, arrive, cleared, fence, motion, radius, request.tolerance / 2)
    if found is not None:
        path, chosen = found
        return path.sampled(request.tolerance / 2), path, float(beginnings[chosen])
    for i in range(ROUTED):
        way = clothoid_way(leave, arrive[i], cleared, fence, radius, request.tolerance / 2)
        if way is not None:
            return way.sampled(request.tolerance / 2), way, float(beginnings[i])
    ways = LongWays(here, _ahead(leave), cleared, fence, radius)
    for b, place in zip(beginnings, arrive, strict=True):
        curve = ways.to(place.point, _ahead(place))
        if curve is not None:
            return curve, None, float(b)
    return None, None, nearest


def _detour(leave: Place, arrive: Place, radius: float) -> float:
    """Return about how long the way between two places is [mm]."""
    straight = arrive.point - leave.point
    heading = np.arctan2(straight[1], straight[0])
    turns = np.array([heading - leave.heading, arrive.heading - heading])
    turns = np.abs(wrapped(turns))
    return float(np.hypot(*straight) + radius * turns.sum())


def _beginning(spiral: Spiral, at: float, radius: float) -> Place:
    """Return where a spiral that begins at `at` on its first ring leaves that."""
    point, heading, curvature = bend_at(spiral.rings[0], at, radius)
    step = spiral.within[1].exterior.distance(shapely.Point(point))
    return Place(point, heading - float(np.arctan2(step, spiral.rings[0].length)), curvature)


def _ahead(place: Place) -> Floats:
    return np.array([np.cos(place.heading), np.sin(place.heading)])


def _end_of(steps: list[Step], start: Start) -> tuple[Floats, Floats]:
    """Return where the spirals end and the unit direction there; of the entry if there are none."""
    points = steps[-1].points[-2:] if steps else shapely.get_coordinates(start.ring)[:2]
    return points[1] if steps else points[0], unit(points[1] - points[0])
