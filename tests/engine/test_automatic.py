# SPDX-License-Identifier: LGPL-2.1-or-later
"""Automatic: any pocket is cleared, gently, inside its walls, without lifts."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, Phase, given, settings
from shapely import LineString, Point, Polygon, box
from shapely.affinity import rotate, translate
from shapely.geometry.polygon import orient
from shapes import (
    CIRCLE,
    DUMBBELL,
    HEIGHTS,
    L_SHAPE,
    RING,
    SQUARE,
    TRIANGLE,
    assert_ways_down_are_fed,
    convex_pockets,
    lifts,
    regular,
)
from shapes import request as make_request

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError
from freecad_spiralpocket.engine.growth.front_rules import FrontRules, engagement_step
from freecad_spiralpocket.engine.growth.fronts import advance
from freecad_spiralpocket.engine.laps import automatic as automatic_laps
from freecad_spiralpocket.engine.links.estimates import motion_of
from freecad_spiralpocket.engine.machine import MIDDLING
from freecad_spiralpocket.engine.model import CutMode, Cutting, Entry, Heights, Plan, Strategy
from freecad_spiralpocket.engine.opening.mouths import mouths_of
from freecad_spiralpocket.engine.opening.start import slot_bite
from freecad_spiralpocket.engine.opening.starts import island_ring
from freecad_spiralpocket.engine.proof.findings import TOUCH
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.sizes import (
    planned_resized,
    resized,
    resized_path,
    resized_request,
)
from freecad_spiralpocket.engine.toolpath import Role

ISLANDS = (
    box(0, 0, 80, 60)
    .difference(Point(22, 30).buffer(7))
    .difference(box(45, 20, 55, 34))
    .difference(Point(64, 44).buffer(4))
)
SLOT = box(0, 0, 25, 8.75)
POCKETS = {
    "triangle": TRIANGLE,
    "square": SQUARE,
    "circle": CIRCLE,
    "L": L_SHAPE,
    "dumbbell": DUMBBELL,
    "ring": RING,
    "islands": ISLANDS,
    "slot": SLOT,
}
#: Share of the cutting length whose engagement may pass 1.15 times the limit and 4 degrees.
OVER = 0.005
#: Share of the floor that may stay: strokes thinner than 0.015 mm are not worth a move.
SLIVERS = 5e-5


def automatic(pocket: Polygon, **changes) -> Plan:
    return plan(make_request(pocket, strategy=Strategy.AUTOMATIC, **changes))


@pytest.mark.parametrize("name", POCKETS)
def test_pocket_is_cleared_gently_without_lifts(name):
    result = automatic(POCKETS[name])
    report = result.report
    assert report.uncut_area < 0.01
    assert report.gouge <= 0.01
    assert report.rapid_hit == 0
    assert report.link_hit == 0
    assert report.engagement_p99 <= report.engagement_limit + math.radians(11)
    assert report.over_limit_share <= OVER
    assert lifts(result) == 1
    assert_ways_down_are_fed(result)


def test_branched_ground_between_islands_is_reached_without_lifts():
    # where three channels meet stock stays, the slot round it hardly wider than a line
    hexagons = [
        regular(6, 9.0, math.pi / 6, (27.0 * i + 13.5 * (j % 2), 23.4 * j))
        for i in range(4)
        for j in range(3)
    ]
    result = automatic(box(-24, -24, 119, 70.8).difference(shapely.union_all(hexagons)))
    assert lifts(result) == 1
    assert result.report.uncut_area < 0.01
    assert result.report.link_hit <= TOUCH


@pytest.mark.parametrize(("depth", "bite"), [(18.0, 0.0), (6.0, 0.6)], ids=["deep", "small bite"])
def test_a_helix_opens_a_plain_pocket_where_a_slot_takes_long(depth, bite):
    times = []
    for low, entry in ((6.0, Entry()), (depth, Entry(slot_bite=bite))):
        heights = replace(HEIGHTS, final_depth=-low, step_down=low)
        times.append(automatic(box(0, 0, 60, 40), heights=heights, entry=entry).report.time)
    assert times[1] < 1.5 * times[0]


def test_rooms_in_a_row_are_entered_from_either_side():
    # two rows of cells; the slot round what stands in each is hardly wider than a line
    cells = [Point(20 * i, 22 * j).buffer(9.3) for i in range(4) for j in range(2)]
    necks = [box(0, 22 * j - 3.6, 60, 22 * j + 3.6) for j in range(2)]
    tray = shapely.union_all([*cells, *necks, box(56.4, 0, 63.6, 22)])
    result = automatic(Polygon(tray.buffer(-3.05).buffer(3.05, quad_segs=32).exterior))
    assert lifts(result) <= 2
    assert result.report.uncut_area < 0.01
    assert result.report.link_hit <= TOUCH


# each example takes a good part of a second: a failing one is told as it is, not shrunk
@settings(
    max_examples=15,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.reuse, Phase.generate],
)
@given(convex_pockets())
def test_any_convex_pocket_is_cleared(pocket):
    try:
        result = automatic(pocket)
    except CutterDoesNotFitError:
        assert pocket.buffer(-3.3).is_empty
        return
    assert result.report.uncut_area < SLIVERS * pocket.area
    assert result.report.gouge <= 0.01
    assert lifts(result) == 1


def gear(teeth: int, root: float, tip: float) -> Polygon:
    """Return a gear whose notches are narrower at their bottom."""
    shares = np.arange(teeth)[:, None] + np.array([-0.37, -0.19, 0.19, 0.37])
    angles = 2 * math.pi / teeth * shares
    radii = np.array([root, tip, tip, root])
    return Polygon(np.dstack([radii * np.cos(angles), radii * np.sin(angles)]).reshape(-1, 2))


@pytest.mark.parametrize(
    ("radius", "apart"), [(0.6, 1.2), (1.2, 1.5), (1.2, 2.0), (2.0, 2.3), (2.0, 3)]
)
def test_notches_between_pins_are_cut_however_shallow(radius, apart):
    pins = [Point(24 + x, 20).buffer(radius, quad_segs=32) for x in (0, apart)]
    pocket = box(0, 0, 64, 40).difference(shapely.union_all(pins))
    region = pocket.buffer(-3, quad_segs=64)
    start = island_ring(region, make_request(pocket))
    mouths = mouths_of(start, region, 3.0)
    cut = shapely.union_all([start.ring, *(LineString(mouth) for mouth in mouths)])
    wall = shapely.segmentize(region.interiors[0], 0.02)
    assert shapely.distance(shapely.points(wall.coords), cut).max() < 0.03


def test_hub_whose_wall_the_ring_meets_nowhere_is_led_onto_from_the_ring():
    turns = 2 * math.pi / 7 * np.arange(7)
    pins = [Point(19.44 * math.cos(t), 19.44 * math.sin(t)).buffer(2.19) for t in turns]
    islands = shapely.union_all([Point(0, 0).buffer(4.91), *pins])
    pocket = box(-40, -32, 40, 32).buffer(-9).buffer(9).difference(islands)
    region = pocket.buffer(-3, quad_segs=64)
    start = island_ring(region, make_request(pocket))
    around = [m for m in mouths_of(start, region, 3.0) if np.abs(np.hypot(*m.T) - 8).max() < 1]
    assert len(around) == 1
    assert start.ring.distance(Point(around[0][0])) < 1e-3
    wall = next(r for r in region.interiors if Polygon(r).contains(Point(0, 0)))
    cut = LineString(around[0])
    assert shapely.distance(shapely.points(wall.coords), cut).max() < 0.01
    report = automatic(pocket, cutting=Cutting(0.9)).report
    assert report.link_hit == report.rapid_hit == 0
    assert report.uncut_area < 0.01


@pytest.mark.parametrize("hub", [5.16, 5.2])
def test_strokes_round_a_hub_that_the_ring_just_touches_begin_where_it_was(hub):
    turns = 2 * math.pi / 7 * np.arange(7)
    pins = [Point(18.3 * math.cos(t), 18.3 * math.sin(t)).buffer(2.3) for t in turns]
    islands = shapely.union_all([Point(0, 0).buffer(hub, quad_segs=32), *pins])
    pocket = box(-40, -34, 40, 34).buffer(-9).buffer(9).difference(islands)
    report = automatic(pocket).report
    assert report.link_hit <= TOUCH and report.rapid_hit == 0
    assert report.uncut_area < 0.01 and report.gouge <= 0.01
    assert not any("the path asked for" in notice.message for notice in report.notices)


@pytest.mark.parametrize("angle", [0.0, 37.0])
@pytest.mark.parametrize("teeth", [10, 16])
def test_notches_of_an_island_are_cut_as_gently_as_the_rest(teeth, angle):
    around = Point(0, 0).buffer(45, quad_segs=64).union(box(0, -30, 75, 30))
    pocket = around.difference(gear(teeth, 22, 28)).difference(Point(55, 0).buffer(6))
    report = automatic(rotate(pocket, angle, origin=(0, 0))).report
    assert report.uncut_area < 0.01
    assert report.gouge <= 0.01
    assert report.engagement_p99 <= report.engagement_limit + math.radians(11)
    assert report.over_limit_share <= 0.5 * OVER


@pytest.mark.parametrize("angle", [15.0, 40.0, 90.0])
def test_turning_and_shifting_the_pocket_changes_little(angle):
    before = automatic(L_SHAPE).report
    after = automatic(translate(rotate(L_SHAPE, angle, origin=(0, 0)), 37.0, -211.0)).report
    assert after.uncut_area < 0.01 and after.gouge <= 0.01
    assert after.time == pytest.approx(before.time, rel=0.05)


@pytest.mark.parametrize("name", ["L", "islands"])
@pytest.mark.parametrize("factor", [0.1, 10.0])
def test_pocket_and_cutter_of_another_size_are_planned_as_well(name, factor):
    made = make_request(POCKETS[name], strategy=Strategy.AUTOMATIC)
    result = plan(resized_request(made, factor))
    assert result.report.uncut_area < 0.01 * factor**2
    assert result.report.gouge <= 0.01 * factor
    assert result.report.rapid_hit == 0
    assert result.report.link_hit <= TOUCH * factor
    assert lifts(result) == 1


@pytest.mark.parametrize(("radius", "tolerance"), [(0.3, 0.01), (9.0, 0.01), (3.0, 0.1)])
def test_size_and_tolerance_need_not_go_together(radius, tolerance):
    made = make_request(L_SHAPE, strategy=Strategy.AUTOMATIC)
    result = plan(replace(resized_request(made, radius / 3.0), tolerance=tolerance))
    assert result.report.uncut_area < 0.01 * max(1.0, radius / 3.0) ** 2
    assert result.report.gouge <= tolerance + 0.005


@pytest.mark.parametrize(
    "strategy", [s for s in Strategy if s is not Strategy.AUTOMATIC], ids=lambda s: s.name
)
def test_the_smallest_cutters_are_planned_as_any(strategy):
    made = resized_request(make_request(SQUARE, strategy=strategy), 1 / 30)
    report = plan(replace(made, tolerance=0.0005)).report
    assert report.uncut_area < 1e-4 and report.gouge <= 0.001
    assert not [n for n in report.notices if "the path asked for" in n.message]


@pytest.mark.parametrize("strategy", [Strategy.AUTOMATIC, Strategy.ISOTHERM])
def test_errors_of_small_cutters_tell_the_sizes_of_the_pocket(strategy):
    pocket = Point(20, 10).buffer(0.503, quad_segs=64)
    made = replace(resized_request(make_request(pocket, strategy=strategy), 1.0), tolerance=0.001)
    made = replace(made, tool_diameter=1.0, cutting=Cutting(0.4))
    with pytest.raises(CutterDoesNotFitError) as caught:
        plan(made)
    assert caught.value.message.startswith("The 1 mm cutter fits the pocket")
    assert caught.value.place == pytest.approx((20, 10), abs=0.1)


def test_all_else_resized_too_the_path_is_the_same():
    made = make_request(L_SHAPE, strategy=Strategy.AUTOMATIC)
    region = center_regions(made.pocket, made.cutter_radius, 0.0)[0]
    path = planned_resized(automatic_laps.floor_path, region, made, lambda done: None)
    small = planned_resized(
        automatic_laps.floor_path,
        resized(region, 0.125),  # exact in binary: GEOS would else meet other last digits
        resized_request(made, 0.125),
        lambda done: None,
    )
    back = resized_path(small, 8.0)
    assert [p.role for p in back.passes] == [p.role for p in path.passes]
    for one, other in zip(path.passes, back.passes, strict=True):
        assert LineString(one.points).hausdorff_distance(LineString(other.points)) < 1e-9


def test_where_geos_gives_up_another_size_is_tried():
    made = make_request(L_SHAPE, strategy=Strategy.AUTOMATIC)
    region = center_regions(made.pocket, made.cutter_radius, 0.0)[0]
    met = []

    def fails_twice(region, request, tick):
        met.append(request.tool_diameter)
        if len(met) < 3:
            raise shapely.GEOSException("found two shells in EdgeRing list")
        return automatic_laps.floor_path(region, request, tick)

    path = planned_resized(fails_twice, region, made, lambda done: None)
    assert met[0] == made.tool_diameter and len(set(met)) == 3
    within = region.buffer(0.011)
    assert all(within.covers(LineString(part.points)) for part in path.passes)


def test_links_know_the_acceleration_along_the_path():
    brisk = replace(MIDDLING, acceleration=(900.0, 800.0, 300.0))
    made = make_request(SQUARE)
    assert motion_of(replace(made, machine=brisk)).acceleration == 800.0
    slow = replace(brisk, path_acceleration=250.0)
    assert motion_of(replace(made, machine=slow)).acceleration == 250.0


def test_conventional_runs_the_other_way_round():
    climb = automatic(L_SHAPE)
    other = automatic(L_SHAPE, cutting=Cutting(2.4, CutMode.CONVENTIONAL))
    # the spindle turns clockwise: climb milling keeps the wall on the right
    assert wall_on_the_right(climb) > 0.95
    assert wall_on_the_right(other) < 0.05
    assert other.report.time == pytest.approx(climb.report.time, rel=0.05)
    assert other.report.uncut_area < 0.01 and other.report.gouge <= 0.01


def wall_on_the_right(result: Plan) -> float:
    """Return which share of the way cut along the wall has it on the right."""
    path, request = result.toolpath, result.request
    wall = LineString(orient(request.pocket.buffer(-request.cutter_radius)).exterior.coords)
    cutting = np.isin(path.roles, (Role.CUT, Role.ENTRY)) & (path.starts[:, 2] <= -4.99)
    lines = zip(path.starts[cutting, :2], path.points[cutting, :2], strict=True)
    right = total = 0.0
    for a, b in lines:
        if max(wall.distance(Point(a)), wall.distance(Point(b))) < 0.01:
            length = float(np.hypot(*(b - a)))
            d = (wall.project(Point(b)) - wall.project(Point(a))) % wall.length
            total += length
            right += length if d < wall.length / 2 else 0.0
    assert total > 100
    return right / total


def test_same_request_gives_the_same_path():
    one, two = automatic(ISLANDS), automatic(ISLANDS)
    np.testing.assert_array_equal(one.toolpath.points, two.toolpath.points)
    np.testing.assert_array_equal(one.toolpath.feeds, two.toolpath.feeds)


def test_levels_are_cut_one_below_the_other():
    heights = Heights(8, 3, 0, -5, 2.5)
    result = automatic(L_SHAPE, heights=heights)
    cuts = result.toolpath.points[result.toolpath.roles == Role.CUT]
    assert set(np.round(cuts[:, 2], 6)) == {-2.5, -5.0}
    assert result.report.uncut_area < 0.01


def test_stock_to_leave_keeps_off_the_walls():
    result = automatic(SQUARE, cutting=Cutting(2.4, stock_to_leave=0.5))
    moves = LineString(result.toolpath.points[result.toolpath.points[:, 2] < 0][:, :2])
    assert SQUARE.buffer(-3.49).covers(moves)


@pytest.mark.parametrize("curvature", [0.0, 0.05, 0.2, 0.5])
def test_step_keeps_the_engagement_of_a_growing_disc(curvature):
    rules = FrontRules(3.0, math.radians(70), 4.0, 4.0)
    step = float(engagement_step(np.array([curvature]), rules)[0])
    if curvature == 0:
        assert step == pytest.approx(rules.stepover, rel=1e-3)
        return
    old = 1 / curvature
    edge, center = old + 3.0, old + step
    # the rim leaves the cleared disc where its distance to the middle is the edge's radius
    cosine = (edge**2 - center**2 - 9.0) / (2 * center * 3.0)
    assert math.acos(cosine) == pytest.approx(math.radians(70), abs=1e-9)


def test_slot_bites_as_much_as_the_step_removes_but_not_too_deep():
    assert slot_bite(make_request(SQUARE)) == pytest.approx(1.8)  # 0.3 D
    shallow = make_request(SQUARE, cutting=Cutting(1.2))
    assert slot_bite(shallow) == pytest.approx(1.2 * 5 / 6)


@pytest.mark.parametrize("mode", CutMode)
@pytest.mark.parametrize("asked", [(12.0, 8.0), (0.5, 0.5)])
def test_cutter_goes_down_near_the_start_point(mode, asked):
    cutting = Cutting(stepover=2.4, cut_mode=mode)
    result = automatic(L_SHAPE, start_point=asked, cutting=cutting)
    path = result.toolpath
    first = path.starts[path.points[:, 2] < 0][0]
    # two radii off both walls, and the radius of the helix on
    assert math.hypot(*(first[:2] - asked)) < 2 * result.request.tool_diameter
    assert result.report.uncut_area < 0.01


def front_of_two_discs(radius: float, apart: float, bar: Polygon) -> Polygon:
    """Return the front after discs side by side [mm], and a bar that joins them."""
    rules = FrontRules(3.0, math.acos(1 - 2.4 / 3.0), 1.33 * 3.0, 1.75 * 2.4)
    discs = [Point(x, 0).buffer(radius, quad_segs=64) for x in (0, apart)]
    visited = orient(shapely.union_all([*discs, bar]))
    return advance(visited, box(-3 * radius, -3 * radius, 6 * radius, 3 * radius), rules)


def sharpest_turn(front: Polygon) -> float:
    """Return by how much the rings of a region turn at most at a point [rad]."""
    sharpest = 0.0
    for ring in (front.exterior, *front.interiors):
        points = np.array(ring.coords)[:-1]
        steps = np.diff(np.vstack([points[-1:], points, points[:1]]), axis=0)
        headings = np.arctan2(*steps.T[::-1])
        turns = (np.diff(headings) + math.pi) % (2 * math.pi) - math.pi
        sharpest = max(sharpest, np.abs(turns).max())
    return sharpest


@pytest.mark.parametrize("width", [45.9, 46.0, 46.1, 52.0])
def test_a_front_that_closes_a_channel_has_no_cusp(width):
    # two discs and what joins them: the fronts between come nearer and nearer to each other
    front = front_of_two_discs(20, width, box(0, -18, width, -8))
    assert sharpest_turn(front) < math.radians(20)


@pytest.mark.parametrize("gap", [2.0, 3.0, 3.5, 4.0, 4.3])
def test_fronts_that_meet_leave_no_slim_tip(gap):
    front = front_of_two_discs(40, 80 + gap, box(0, -40, 80 + gap, -32))
    assert len(front.interiors) == 1
    assert sharpest_turn(front) < math.radians(20)
