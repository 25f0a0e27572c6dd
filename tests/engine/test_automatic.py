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
    ISLANDS,
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
from freecad_spiralpocket.engine.laps import automatic as laps
from freecad_spiralpocket.engine.links.estimates import motion_of
from freecad_spiralpocket.engine.machine import MIDDLING
from freecad_spiralpocket.engine.model import CutMode, Cutting, Entry, Heights, Plan, Strategy
from freecad_spiralpocket.engine.opening.mouths import mouths_of
from freecad_spiralpocket.engine.opening.start import slot_bite
from freecad_spiralpocket.engine.opening.starts import island_ring
from freecad_spiralpocket.engine.proof.findings import TOUCH
from freecad_spiralpocket.engine.toolpath import Role

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


def test_of_two_starts_that_with_many_more_links_must_be_much_faster():
    best = laps._Best(seconds=100.0, links=20)
    assert best.is_beaten_by(99, 20) and best.is_beaten_by(93, 30)
    assert not best.is_beaten_by(95, 30) and not best.is_beaten_by(93, 101)
    assert best.is_beaten_by(88, 101)
    # the other way round too, and a few links more are no more than a few
    assert laps._Best(seconds=100.0, links=101).is_beaten_by(112, 20)
    assert laps._Best(seconds=100.0, links=0).is_beaten_by(93, 5)


def test_a_ring_runs_along_faceted_hollows_of_islands():
    turns = np.linspace(2.0, 2 * math.pi - 2.0, 24)
    inner = 8.5 * np.column_stack([np.cos(turns), np.sin(turns)])
    outer = 16.0 * np.column_stack([np.cos(turns), np.sin(turns)])[::-1]
    pocket = box(-45, -45, 45, 45).difference(Polygon(np.vstack([inner, outer])))
    region = pocket.buffer(-4, quad_segs=64)
    start = island_ring(region, make_request(pocket, tool_diameter=8.0))
    wall = np.array(shapely.segmentize(region.interiors[0], 0.02).coords)
    hollow = wall[(np.hypot(*wall.T) < 5.0) & (wall[:, 0] < -3.0)]
    assert shapely.distance(shapely.points(hollow), start.ring).max() < 0.012


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


def test_an_island_that_a_wide_curve_does_not_keep_is_gone_round_by_a_finer_one():
    crescent = [
        *((38.0, 19.8), (36.3, 23.4), (31.5, 25.4), (31.5, 28.0), (30.2, 30.2), (28.0, 31.5)),
        *((25.4, 31.5), (23.4, 36.3), (19.8, 38.0), (20.6, 42.1), (22.5, 46.1), (25.2, 49.2)),
        *((28.7, 51.7), (34.7, 53.6), (41.4, 53.1), (47.3, 50.1), (51.7, 44.9), (53.7, 38.7)),
        *((53.1, 32.1), (50.0, 26.1), (44.9, 21.8)),
    ]
    island = [(37.2, 34.3), (38.8, 35.3), (39.2, 37.2), (38.2, 38.8), (36.4, 39.2), (34.8, 38.3)]
    asked = make_request(SQUARE, tool_diameter=10.0)
    start = island_ring(Polygon(crescent, [island]), asked)
    assert start is not None and start.visited.covers(Polygon(island).buffer(-0.6))
