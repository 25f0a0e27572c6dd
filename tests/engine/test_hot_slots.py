# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hot slots: where they lead, and which laps follow."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely
from heated import (
    FINS,
    FOUR_POSTS,
    ROUND_RING,
    SIX_POSTS,
    STEP,
    TWO_ISLANDS,
    TWO_LOBES,
    arc,
    laps_of,
    pairs,
    path_of,
)
from shapely import LineString, MultiPoint, MultiPolygon, Point, Polygon, box
from shapes import (
    CIRCLE,
    HEIGHTS,
    L_SHAPE,
    PENTAGON,
    SQUARE,
    TRIANGLE,
)
from shapes import request as make_request

from freecad_spiralpocket.engine.errors import CutterDoesNotFitError
from freecad_spiralpocket.engine.floor import FloorPath, Pass, Slot
from freecad_spiralpocket.engine.heat.family import evenly_divided, family_of
from freecad_spiralpocket.engine.heat.hot_slots import hot_slot
from freecad_spiralpocket.engine.heat.isotherms import outer_room, rooms_at
from freecad_spiralpocket.engine.model import Cutting, Plan, Strategy
from freecad_spiralpocket.engine.planner import plan
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.shapes.skeleton import medial_axis
from freecad_spiralpocket.engine.toolpath import Kind, Role

CROSS = box(-45, -35, 45, 35).difference(box(-25, -5, 25, 5).union(box(-5, -22, 5, 22)))


def entries_of(path: FloorPath) -> list:
    return [path.entry, *(p for p in path.passes if not isinstance(p, Pass))]


def test_fingers_that_no_isotherm_leads_through_are_opened_by_slots_at_last():
    # so deep that a slot takes longer than laps would that creep along a finger
    deep = replace(HEIGHTS, final_depth=-12.0, step_down=13.0)
    pocket = box(0, 0, 67, 18).union(box(14, 0, 32, 62))
    changes = {"tool_diameter": 12.0, "cutting": Cutting(5.4), "heights": deep}
    result = plan(make_request(pocket, strategy=Strategy.ISOTHERM, **changes))
    assert result.report.uncut_area == 0 and result.report.gouge < 0.01


def test_a_summit_in_a_slit_without_room_for_a_helix_is_opened_by_a_slot():
    pocket = box(0, 0, 30, 30).union(box(29, 12, 70, 18.2)).union(box(60, 0, 70, 30))
    result = plan(make_request(pocket, strategy=Strategy.ISOTHERM))
    assert result.report.uncut_area == 0 and result.report.gouge < 0.01
    hole = Point(0, 0).buffer(3.05)
    with pytest.raises(CutterDoesNotFitError, match="no room for its helix"):
        plan(make_request(hole, strategy=Strategy.ISOTHERM))


@pytest.mark.parametrize("pocket", [TWO_LOBES, L_SHAPE, TWO_ISLANDS, SIX_POSTS, FOUR_POSTS])
def test_one_slot_opens_all_rooms_and_nothing_is_lifted_over(pocket):
    _, path = path_of(pocket)
    assert isinstance(path.entry, Slot)
    assert entries_of(path) == [path.entry]
    assert all(p.role is not Role.AIR for p in path.passes)


@pytest.mark.parametrize(("pocket", "step"), [(CROSS, 1.8), (CROSS, 0.6), (SIX_POSTS, 0.6)])
def test_laps_lead_to_the_slot_where_it_is_close_to_walls_or_steps_are_fine(pocket, step):
    plan_ = plan(make_request(pocket, strategy=Strategy.ISOTHERM, cutting=Cutting(step)))
    assert lifts_of(plan_) == 0
    assert plan_.report.uncut_area < 1e-3


#: Channels in which a slot fits that keeps off walls less than elsewhere.
CELLS = MultiPoint([(0, 0), (20, 0), (40, 0)]).buffer(8.6).union(box(0, -3.7, 40, 3.7))


def test_a_hot_slot_leads_through_channels_that_are_narrower_than_it_likes():
    region = center_regions(CELLS, 3.0, 0.0)[0]
    slot = hot_slot(region, medial_axis(region), make_request(CELLS))
    assert all(slot.distance(Point(x, 0)) < 3.0 for x in (0, 20, 40))
    plan_ = plan(make_request(CELLS, strategy=Strategy.ISOTHERM))
    assert lifts_of(plan_) == 0
    assert plan_.report.uncut_area < 1e-3


#: In which a lap goes up one side and down the other.
LADDER = box(0, 0, 70, 46.1).difference(
    MultiPolygon([box(8.7, 8.7, 30.65, 37.4), box(39.35, 8.7, 61.3, 37.4)])
)


@pytest.mark.parametrize(("pocket", "share"), [(FINS, 0.4), (LADDER, 0.4), (LADDER, 0.6)])
def test_narrow_channels_between_islands_are_opened_by_the_slot(pocket, share):
    cutting = Cutting(share * 6.0)
    plan_ = plan(make_request(pocket, strategy=Strategy.ISOTHERM, cutting=cutting))
    assert lifts_of(plan_) == 0
    assert plan_.report.uncut_area < 1e-3


def test_a_hot_slot_leads_along_all_ridges_that_cross():
    loops = arc(44, 112, 28, -0.37, 3.74)[::-1] + arc(36, 32, 32, 2.13, 5.7)
    ampersand = LineString([(104, 0), *loops, (95, 58)])
    pocket = ampersand.buffer(7)
    region = center_regions(pocket, 3.0, 0.0)[0]
    slot = hot_slot(region, medial_axis(region), make_request(pocket))
    along = [ampersand.interpolate(share, normalized=True) for share in np.linspace(0, 1, 100)]
    assert max(slot.distance(place) for place in along) < 3.0


#: A room with a small one behind a neck, and another that is hardly narrower before it.
THREE_ROOMS = shapely.union_all(
    [Point(x, y).buffer(r) for x, y, r in ((40, -1, 30), (-4, 11.5, 16.5), (51, -35.5, 18.5))]
)
THREE_ROOMS = THREE_ROOMS.buffer(-3).buffer(6).buffer(-3)


def test_a_hot_slot_goes_on_to_small_rooms_where_it_is_to():
    region = center_regions(THREE_ROOMS, 3.0, 0.0)[0]
    slot = hot_slot(region, medial_axis(region), make_request(THREE_ROOMS), all_rooms=True)
    assert all(slot.distance(Point(x, y)) < 3.0 for x, y in ((40, -1), (-4, 11.5), (51, -35.5)))


@pytest.mark.parametrize("share", [0.1, 0.4])
def test_small_rooms_behind_necks_are_cut_without_lifts(share):
    plan_ = plan(
        make_request(THREE_ROOMS, strategy=Strategy.ISOTHERM, cutting=Cutting(share * 6.0))
    )
    assert lifts_of(plan_) == 0
    assert plan_.report.uncut_area < 1e-3


def test_lifts_count_where_laps_about_all_summits_are_weighed():
    rings = [Point(x, 0).buffer(14).exterior for x in (-13, 13)]
    pocket = shapely.union_all(rings).buffer(4.9)
    _, path = path_of(pocket)
    # to all the noise on so even a ridge they are shorter, but the cutter is lifted 150 times
    assert entries_of(path) == [path.entry]


def test_laps_about_all_summits_are_taken_where_those_about_a_slot_crowd():
    bosses = [Point(x, y).buffer(4.5) for x in (12.2, 67.8) for y in (12.2, 47.8)]
    pocket = box(0, 0, 80, 60).difference(MultiPolygon(bosses))
    region, path = path_of(pocket)
    # about the slot they would be more than four times as long as evenly spaced ones
    assert length_of(path) < 2.5 * region.area / STEP


def lifts_of(plan_: Plan) -> int:
    """Return how often the cutter is lifted before the end."""
    rapid = plan_.toolpath.kinds == Kind.RAPID
    return int((rapid[1:] & ~rapid[:-1]).sum()) - 1


def test_even_laps_are_the_same_on_a_finer_grid():
    region = center_regions(TWO_ISLANDS, 3.0, 0.0)[0]
    request = make_request(TWO_ISLANDS)
    slot = hot_slot(region, medial_axis(region), request)
    family = family_of(region, request, 0.5, 0.0, slot)
    coarse, room = evenly_divided(family, outer_room(family))
    fine, finer_room = evenly_divided(family, outer_room(family), 2)
    assert fine.field.spacing == coarse.field.spacing / 2
    (one,) = rooms_at(coarse, room, 0.5 * family.heat)
    (other,) = rooms_at(fine, finer_room, 0.5 * family.heat)
    assert one.region.area == pytest.approx(other.region.area, rel=0.01)


@pytest.mark.parametrize("pocket", [TWO_LOBES, L_SHAPE, TWO_ISLANDS])
def test_a_hot_slot_gives_shorter_laps_than_an_even_heat(pocket):
    _, wall = laps_of(pocket)
    _, path = path_of(pocket, cutting=Cutting(STEP, finishing_lap=False))
    creeping = sum(lap.region.length for lap, _ in pairs(wall))
    assert length_of(path) < 0.95 * creeping


def length_of(path: FloorPath) -> float:
    """Return the length of all that is cut [mm]."""
    cuts = [p for p in path.passes if isinstance(p, Pass) and p.role is Role.CUT]
    return sum(LineString(p.points).length for p in cuts)


@pytest.mark.parametrize("pocket", [TWO_LOBES, TWO_ISLANDS, SIX_POSTS])
def test_a_hot_slot_keeps_off_walls_and_is_in_one_piece(pocket):
    region = center_regions(pocket, 3.0, 0.0)[0]
    slot = hot_slot(region, medial_axis(region), make_request(pocket))
    assert slot.is_valid
    assert not slot.interiors
    assert slot.distance(region.boundary) > 0.25 * STEP


@pytest.mark.parametrize("pocket", [CIRCLE, SQUARE, TRIANGLE, PENTAGON])
def test_a_compact_pocket_has_no_ridge(pocket):
    region = center_regions(pocket, 3.0, 0.0)[0]
    assert hot_slot(region, medial_axis(region), make_request(pocket)) is None


def test_a_hot_slot_is_nowhere_a_hairline():
    # between the boss and both walls beside it there is 1 mm for the center
    bosses = [Point(x, y).buffer(5) for x, y in ((14, 14), (46, 26))]
    pocket = box(0, 0, 60, 40).difference(shapely.union_all(bosses))
    request = make_request(pocket, tool_diameter=8.0, cutting=Cutting(1.6))
    region = center_regions(pocket, 4.0, 0.0)[0]
    core = hot_slot(region, medial_axis(region), request).buffer(-0.05 * 1.6)
    assert isinstance(core, Polygon)
    assert not core.is_empty


def test_a_level_ridge_round_an_island_is_opened_by_a_slot():
    _, path = path_of(ROUND_RING)
    assert isinstance(path.entry, Slot)
    assert Polygon(path.entry.ring).contains(Point(0, 0))
    assert all(isinstance(p, Pass) for p in path.passes)


def test_a_hot_slot_that_runs_into_a_corner_is_in_the_plate():
    corners = [(-11.4, 14.1), (16.2, -10.5), (10.5, -23.6), (9.4, -23.4), (-17.7, 10.5)]
    pocket = Polygon(corners)
    region = center_regions(pocket, 3.0, 0.0)[0]
    request = make_request(pocket, strategy=Strategy.ISOTHERM)
    slot = hot_slot(region, medial_axis(region), request)
    family = family_of(region, request, 4 * STEP, None, slot)
    assert family.region.covers(slot)
    assert plan(request).report.uncut_area < 1e-3
