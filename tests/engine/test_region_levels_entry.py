# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutter-center regions, levels and the helical entry."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from shapely import GeometryCollection, LineString, MultiPolygon, Point, box
from shapely.affinity import rotate
from shapes import DUMBBELL, FEEDS, HEIGHTS, request

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError, named
from freecad_spiralpocket.engine.floor import Descent, Helix, Slot
from freecad_spiralpocket.engine.levels import floors
from freecad_spiralpocket.engine.model import Cutting, Entry, Heights
from freecad_spiralpocket.engine.necks import unreachable_notices
from freecad_spiralpocket.engine.opening.entry import (
    cut_entry,
    entry_start,
    fit_helix_radius,
    ramp_feed,
)
from freecad_spiralpocket.engine.shapes.region import (
    center_regions,
    grow,
    polygons_of,
)
from freecad_spiralpocket.engine.toolpath import Kind, ToolpathBuilder


def test_region_of_a_rectangle_is_the_inset_rectangle():
    (region,) = center_regions(box(0, 0, 40, 20), 3.0, 0.5)
    assert region.symmetric_difference(box(3.5, 3.5, 36.5, 16.5)).area < 1e-9


def test_region_grown_again_never_passes_the_wall():
    pocket = box(0, 0, 40, 20).union(Point(40, 10).buffer(10))
    (region,) = center_regions(pocket, 3.0, 0.0)
    assert pocket.boundary.distance(region) > 3.0 - 1e-3


def test_polygons_are_found_in_what_repair_makes_of_a_shape():
    small, large = box(0, 0, 1, 1), box(5, 0, 9, 9)
    mixed = GeometryCollection([MultiPolygon([small, large]), LineString([(0, 0), (1, 1)])])
    assert [p.area for p in polygons_of(mixed)] == [large.area, small.area]


def test_stock_to_leave_without_end_leaves_no_room():
    assert grow(box(0, 0, 40, 20), -1e99).is_empty


def test_cutter_wider_than_the_pocket_is_told_with_the_width():
    with pytest.raises(CutterDoesNotFitError, match="does not fit.*5.8.* mm wide") as caught:
        center_regions(box(0, 0, 40, 5.8), 3.0, 0.0)
    assert "below 5.8" in caught.value.hint


@pytest.mark.parametrize("turn", [0, 17, 90])
@pytest.mark.parametrize("diameter", [1.0, 6.0, 20.0])
def test_slot_as_wide_as_the_cutter_is_refused_and_a_little_wider_one_is_cut(diameter, turn):
    def slot(more):
        line = LineString([(0, 0), (3 * diameter, 0)])
        return rotate(line.buffer(diameter / 2 * (1 + more), quad_segs=64), turn)

    cutting = Cutting(0.4 * diameter)
    for more in (2e-4, 1e-3, 2e-3, 2.4e-3):
        with pytest.raises(CutterDoesNotFitError, match="no wider than the"):
            plan(request(slot(more), tool_diameter=diameter, cutting=cutting))
    for more in (2.8e-3, 4e-3, 0.01):
        report = plan(request(slot(more), tool_diameter=diameter, cutting=cutting)).report
        assert report.uncut_area == 0 and report.gouge < 0.01


def test_neck_that_the_cutter_cannot_pass_is_told_with_its_place():
    pocket = box(0, 0, 30, 30).union(box(30, 12, 60, 17.8))
    regions = center_regions(pocket, 3.0, 0.0)
    (notice,) = unreachable_notices(pocket, regions, 3.0, 0.0)
    assert "5.8 mm neck" in str(notice)
    assert 30 < notice.place[0] < 60 and abs(notice.place[1] - 14.9) < 0.5


@pytest.mark.parametrize(("arms", "notices"), [(3, 3), (4, 1), (9, 1)])
def test_many_necks_are_told_together(arms, notices):
    widths = [5.0 - 0.2 * i for i in range(arms)]
    parts = [box(10.0 * i, -20, 10.0 * i + w, 1) for i, w in enumerate(widths)]
    pocket = shapely.union_all([box(-1, 0, 100, 20), *parts])
    told = unreachable_notices(pocket, center_regions(pocket, 3.0, 0.0), 3.0, 0.0)
    assert len(told) == notices
    if notices == 1:
        text = str(told[0])
        assert f"{arms} necks" in text
        assert 0 <= told[0].place[0] <= widths[0]  # the widest
        assert float(text.split("below ")[1].split()[0]) <= min(widths) + 0.1


def test_no_cutter_is_named_for_gaps_that_are_as_good_as_closed():
    def hint_for(*widths):
        rooms = [box(30 * i, 0, 30 * i + 20, 20) for i in range(len(widths) + 1)]
        necks = [box(30 * i + 19, 8, 30 * i + 31, 8 + w) for i, w in enumerate(widths)]
        pocket = shapely.union_all([*rooms, *necks])
        (notice,) = unreachable_notices(pocket, center_regions(pocket, 3.0, 0.0), 3.0, 0.0)
        return notice.hint

    assert hint_for(0.3) == "No cutter goes through so narrow a gap; check the model."
    assert hint_for(5.0, 0.3, 4.0, 4.4) == "A cutter below 4 mm reaches 3 of them."
    assert hint_for(5.0, 0.7, 4.0, 4.4) == "A cutter below 0.7 mm reaches all of them."


@pytest.mark.parametrize(
    ("width", "length"), [(5.4, 3.6), (5.94, 4.8), (5.94, 5.7), (5.94, 7.2), (5.4, 6), (5.94, 12)]
)
def test_short_neck_is_told_once_with_its_width(width, length):
    half = length / 2
    rooms = [box(-half - 18, -9, -half, 9), box(half, -9, half + 18, 9)]
    neck = box(-half - 1, -width / 2, half + 1, width / 2)
    pocket = rotate(shapely.union_all([*rooms, neck]), 20, origin=(0, 0))
    (notice,) = unreachable_notices(pocket, center_regions(pocket, 3.0, 0.0), 3.0, 0.0)
    told = float(str(notice).split("fit the ")[1].split()[0])
    assert told == pytest.approx(width, abs=0.01)
    assert math.hypot(*notice.place) < 0.1
    # a smaller cutter goes through
    assert unreachable_notices(pocket, center_regions(pocket, told / 2.01, 0), told / 2.01, 0) == ()


def test_gap_round_an_island_is_told_with_its_width():
    pocket = Point(0, 0).buffer(30, quad_segs=64).difference(Point(2.3, 0).buffer(22, quad_segs=64))
    (notice,) = unreachable_notices(pocket, center_regions(pocket, 3.0, 0.0), 3.0, 0.0)
    assert float(str(notice).split("fit the ")[1].split()[0]) == pytest.approx(5.7, abs=0.01)
    assert notice.place[0] > 25


@pytest.mark.parametrize("cutter", [30.0, 24.0, 21.0, 19.0])
def test_neck_before_all_that_a_large_cutter_leaves_is_told(cutter):
    """It gets into one end only, round which what it leaves lies on three sides."""
    pocket = box(0, 0, 60, 36).difference(Point(20, 18).buffer(5, quad_segs=64))
    radius = cutter / 2
    (notice,) = unreachable_notices(pocket, center_regions(pocket, radius, 0.0), radius, 0.0)
    assert " 13 mm neck" in notice.message and "below 13 mm" in notice.hint
    x, y = notice.place
    assert x == pytest.approx(20, abs=0.5) and min(y, 36 - y) == pytest.approx(6.5, abs=0.2)
    smaller = center_regions(pocket, 6.4, 0.0)
    assert unreachable_notices(pocket, smaller, 6.4, 0.0) == ()


def test_dead_end_is_told_with_its_width():
    pocket = box(0, 0, 40, 20).union(box(10, 19, 15.99, 29))
    (notice,) = unreachable_notices(pocket, center_regions(pocket, 3.0, 0.0), 3.0, 0.0)
    assert "5.99 mm neck" in str(notice)


def test_corners_are_nobodys_news():
    regions = center_regions(DUMBBELL, 3.0, 0.0)
    assert len(regions) == 1
    assert unreachable_notices(DUMBBELL, regions, 3.0, 0.0) == ()


def beside_a_bridge(width, hair=1e-3, at=20.0):
    """Return a room, and one so wide beyond a bridge, joined by a hair."""
    rooms = [box(0, 0, 40, 20), box(0, 27, 40, 27 + width)]
    return shapely.union_all([*rooms, box(at, 19, at + hair, 28)])


@pytest.mark.parametrize("at", [0.0, 20.0, 40 - 1e-3])
@pytest.mark.parametrize("stock", [0.0, 0.2])
def test_corners_beside_a_bridge_are_no_neck(at, stock):
    pocket = beside_a_bridge(20, at=at)
    assert unreachable_notices(pocket, center_regions(pocket, 4.0, stock), 4.0, stock) == ()


def test_rooms_that_also_meet_round_the_end_of_a_bridge_have_no_neck_beside_it():
    pocket = shapely.union(beside_a_bridge(20, at=0.0), box(28, 0, 40, 47))
    assert unreachable_notices(pocket, center_regions(pocket, 4.0, 0.0), 4.0, 0.0) == ()


def test_a_room_beyond_a_bridge_is_told_with_its_own_width():
    pocket = beside_a_bridge(4.1, at=0.0)
    (notice,) = unreachable_notices(pocket, center_regions(pocket, 4.0, 0.0), 4.0, 0.0)
    assert "does not fit the room at" in notice.message and "4.1 mm wide" in notice.message
    assert "neck" not in notice.message and "164 mm2" in notice.message
    assert notice.hint == "A cutter below 4.1 mm reaches it." and 27 < notice.place[1] < 32


def test_many_rooms_without_a_neck_are_told_together_beside_necks():
    rooms = [box(60.0 * i, 0, 60.0 * i + 40, 4 + 0.1 * i) for i in range(5)]
    bridges = [box(60.0 * i, 1, 60.0 * i + 60, 1.001) for i in range(5)]
    large = box(300, 0, 340, 40).union(box(339, 10, 360, 15))
    pocket = shapely.union_all([*rooms, *bridges, large])
    neck, told = unreachable_notices(pocket, center_regions(pocket, 4.0, 0), 4.0, 0)
    assert "5 mm neck" in neck.message
    assert "5 rooms, up to 4.4 mm wide" in told.message and 240 < told.place[0] < 280


@given(st.floats(0.5, 40), st.floats(0.2, 20), st.floats(0, 0.2))
def test_levels_go_down_by_no_more_than_the_step(depth, step_down, finish):
    finish = min(finish, step_down, depth)
    levels = floors(Heights(8, 3, 1.0, 1.0 - depth, step_down, finish))
    steps = -np.diff([1.0, *levels])
    assert (steps > 0).all() and steps.max() <= step_down + 1e-5
    assert levels[-1] == pytest.approx(1.0 - depth)
    if 1e-5 < finish < depth - 1e-5:
        assert steps[-1] == pytest.approx(finish)


def test_full_steps_come_first_as_in_freecads_operations():
    assert floors(Heights(8, 3, 0.0, -10.0, 4.0)) == pytest.approx([-4.0, -8.0, -10.0])
    assert floors(Heights(8, 3, 0.0, -10.0, 4.0, 0.5)) == pytest.approx([-4, -8, -9.5, -10])


@pytest.mark.parametrize("degrees", [1.0, 5.0, 20.0])
def test_helix_descends_at_its_angle_and_ends_where_the_spiral_begins(degrees):
    angle = math.radians(degrees)
    helix = Helix(np.array([5.0, -2.0]), 2.8, 0.7)
    x, y = entry_start(helix, Descent(0.0, -5.0, angle))
    builder = ToolpathBuilder((x, y, 0.5))
    cut_entry(builder, helix, Descent(0.0, -5.0, angle), FEEDS, 0.004)
    toolpath = builder.build()
    assert (np.abs(toolpath.sweeps) <= math.pi + 1e-9).all()
    assert (toolpath.kinds == Kind.ARC_CCW).all()
    flat = helix.radius * np.abs(toolpath.sweeps)
    drop = -(toolpath.points[:, 2] - toolpath.starts[:, 2])
    np.testing.assert_allclose(drop[:-2], flat[:-2] * math.tan(angle), rtol=1e-6)
    np.testing.assert_allclose(drop[-2:], 0, atol=1e-12)
    assert flat[-2:].sum() == pytest.approx(2 * math.pi * helix.radius)
    end = helix.center + 2.8 * np.array([math.cos(0.7), math.sin(0.7)])
    np.testing.assert_allclose(toolpath.points[-1], [*end, -5.0], atol=1e-9)


@pytest.mark.parametrize("depth", [1.0, 5.0])
def test_slot_sinks_by_its_bite_a_loop_and_ends_flat_where_its_ring_begins(depth):
    ring = np.array(box(0, 0, 40, 6).exterior.coords)[:-1][::-1]
    slot, angle = Slot(ring, 1.8), math.radians(5)
    x, y = entry_start(slot, Descent(0.0, -depth, angle))
    builder = ToolpathBuilder((x, y, 0.5))
    cut_entry(builder, slot, Descent(0.0, -depth, angle), FEEDS, 0.004)
    toolpath = builder.build()
    along = np.cumsum(np.hypot(*(toolpath.points - toolpath.starts)[:, :2].T))
    levels = math.ceil(depth / 1.8)
    ramp = depth / levels / math.tan(angle)
    assert along[-1] == pytest.approx(92 * levels + ramp)
    drop = toolpath.starts[:, 2] - toolpath.points[:, 2]
    flat = np.hypot(*(toolpath.points - toolpath.starts)[:, :2].T)
    assert (drop[1:] <= flat[1:] * math.tan(angle) + 1e-9).all() and (drop >= -1e-12).all()
    last_lap = along > along[-1] - 92 + 1e-6
    assert toolpath.points[last_lap, 2] == pytest.approx(-depth)
    np.testing.assert_allclose(toolpath.points[-1], [*ring[0], -depth], atol=1e-9)


@pytest.mark.parametrize("width", [0.5, 2.0, 4.0])
def test_slot_shorter_than_its_ramps_is_no_steeper(width):
    ring = np.array(box(0, 0, width, width).exterior.coords)[:-1][::-1]
    slot, angle = Slot(ring, 1.8), math.radians(5)
    builder = ToolpathBuilder((*entry_start(slot, Descent(0.0, -5.0, angle)), 0.5))
    cut_entry(builder, slot, Descent(0.0, -5.0, angle), FEEDS, 0.004)
    toolpath = builder.build()
    drop = toolpath.starts[:, 2] - toolpath.points[:, 2]
    flat = np.hypot(*(toolpath.points - toolpath.starts)[:, :2].T)
    assert (drop[1:] <= flat[1:] * math.tan(angle) + 1e-9).all() and (drop >= -1e-12).all()
    np.testing.assert_allclose(toolpath.points[-1], [*ring[0], -5.0], atol=1e-9)


def test_ramp_feed_keeps_both_feeds():
    assert ramp_feed(FEEDS, math.radians(5)) == FEEDS.horizontal
    steep = math.radians(30)
    assert ramp_feed(FEEDS, steep) * math.sin(steep) == pytest.approx(FEEDS.vertical)


def test_helix_is_as_wide_as_fits_and_leaves_no_post():
    region = box(-20, -20, 20, 20)
    assert fit_helix_radius(region, np.zeros(2), 3.0, Entry()) == pytest.approx(2.82)
    narrow = box(-20, -1.0, 20, 1.0)
    assert fit_helix_radius(narrow, np.zeros(2), 3.0, Entry()) == pytest.approx(1.0)
    limited = Entry(max_diameter=3.0)
    assert fit_helix_radius(region, np.zeros(2), 3.0, limited) == pytest.approx(1.5)
    with pytest.raises(CutterDoesNotFitError, match="no room for its helix"):
        fit_helix_radius(box(-20, -0.05, 20, 0.05), np.zeros(2), 3.0, Entry())


def test_heights_of_the_tests_are_sound():
    assert floors(HEIGHTS) == [-5.0]


def test_one_of_several_pockets_without_room_for_the_helix_is_named():
    with pytest.raises(CutterDoesNotFitError) as caught:
        fit_helix_radius(box(0, 0, 0.1, 0.1), np.array([0.05, 0.05]), 3.0, Entry())
    (error,) = named([("Plate, Face7", caught.value)], 2)
    assert error.message.startswith("Plate, Face7: The 6 mm cutter fits the pocket, but has no")
    assert (error.hint, error.place) == (caught.value.hint, (0.05, 0.05))
    assert named([("Plate, Face7", caught.value)], 1) == [caught.value]
