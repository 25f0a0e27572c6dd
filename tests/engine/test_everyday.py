# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes that parts have: arms, teeth, dog bones, narrow rooms, sharp tips; mostly by Automatic."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath
from shapely import LineString, Point, Polygon, box
from shapely.affinity import rotate, scale, translate
from shapes import assert_ways_down_are_fed, lifts, rounded
from shapes import request as make_request

from freecad_spiralpocket.engine import plan, planner
from freecad_spiralpocket.engine.contact.engagement import along_path
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError
from freecad_spiralpocket.engine.links.linking import Motion, link_times
from freecad_spiralpocket.engine.model import Cutting, Heights, Plan, Strategy
from freecad_spiralpocket.engine.toolpath import Kind, Role

TOOTHED = shapely.union_all(
    [Point(0, 0).buffer(28), *(rotate(box(-4, 20, 4, 38), 45 * i, (0, 0)) for i in range(8))]
)
DOG_BONES = shapely.union_all(
    [
        box(-35, -20, 35, 20),
        *(Point(x, y).buffer(3.2, quad_segs=24) for x in (-32.74, 32.74) for y in (-17.74, 17.74)),
    ]
)
#: Between the islands there is a channel hardly wider than the cutter.
CHANNEL = (
    box(-30, -35, 30, 35)
    .buffer(-6)
    .buffer(6)
    .difference(box(-14, 3.75, 14, 16))
    .difference(box(-14, -16, 14, -3.75))
)
#: The cutter just passes between the island and the wall.
BY_THE_WALL = box(-40, -30, 40, 30).buffer(-5).buffer(5).difference(Point(0, 18).buffer(6))
#: Between the three islands there are channels that meet.
FORKED = box(-50, -35, 50, 35).buffer(-4).buffer(4)
CROSS = box(-40, -9, 40, 9).union(box(-9, -40, 9, 40))
WEDGE = Polygon([(0, 0), (90, 0), (0, 18)])


def petals(count: int) -> Polygon:
    turn = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    radius = 32 + 5 * np.cos(count * turn)
    return Polygon(np.column_stack([radius * np.cos(turn), radius * np.sin(turn)]))


def planned(pocket: Polygon, stepover: float = 2.4) -> Plan:
    return plan(make_request(pocket, strategy=Strategy.AUTOMATIC, cutting=Cutting(stepover)))


def test_from_the_end_of_an_arm_the_cutter_goes_back_over_its_slot():
    result = planned(TOOTHED)
    assert lifts(result) == 1
    assert result.report.link_hit == 0


def test_dog_bones_are_cut_by_the_slot_along_the_wall():
    report = planned(DOG_BONES).report
    assert report.uncut_area < 0.01
    assert report.over_limit_share == 0
    assert report.engagement_p99 < report.engagement_limit + math.radians(5)


@pytest.mark.parametrize("angle", [0, 30, 62])
@pytest.mark.parametrize("size", [(8, 12), (16, 6)])
def test_strokes_turn_gently_into_the_stock_beside_an_island(size, angle):
    island = rotate(box(-size[0] / 2, -size[1] / 2, size[0] / 2, size[1] / 2), angle)
    pocket = rounded(box(-32, -22, 32, 22), 5).difference(translate(island, 3, 4))
    report = planned(pocket).report
    assert report.uncut_area < 0.01
    assert report.engagement_p99 < report.engagement_limit + math.radians(8)


def test_channel_between_islands_is_no_full_cut_at_the_full_depth():
    report = planned(CHANNEL).report
    assert report.uncut_area < 0.01
    assert report.engagement_max < report.engagement_limit + math.radians(35)


@pytest.mark.parametrize("width", [6.02, 6.5])
def test_channels_that_meet_between_islands_are_cut_in_levels(width):
    islands = [
        box(-24 - width / 2, -10, -6 - width / 2, 14),
        box(-6 + width / 2, -10, 16 + width / 2, 14),
        box(-20, 14 + width, 20, 20 + width),
    ]
    result = planned(FORKED.difference(shapely.union_all(islands)))
    report = result.report
    assert lifts(result) == 1
    assert_ways_down_are_fed(result)
    assert report.uncut_area < 0.01
    assert report.engagement_p99 < report.engagement_limit + math.radians(9)
    assert report.engagement_max < report.engagement_limit + math.radians(35)


@pytest.mark.parametrize("side", [14.0, 16.0, 19.0])
def test_no_cut_is_too_small_to_be_judged(side):
    result = planned(box(0, 0, side, side))
    request, path = result.request, result.toolpath
    measured = along_path(path, 3.0, axial_depth=request.axial_depth, top=0.0)
    cuts = np.isin(path.roles[measured.moves], (Role.CUT, Role.FINISH))
    cuts &= np.abs(measured.points[:, 2] - request.floor) < 1e-6
    assert result.report.engagement_max >= measured.angles[cuts].max() - 1e-9 > 0.0


@pytest.mark.parametrize("width", [6.5, 7.5])
def test_links_take_the_channel_beside_an_island(width):
    island = rounded(box(width, width, width + 24, width + 24), 4.0)
    path = planned(rounded(box(0, 0, 100, 60), 6.0) - island).toolpath
    # round the other side of the island a dozen of them would go 140 mm farther each
    assert path.lengths[path.roles == Role.LINK].sum() < 1000


def test_blunt_tips_are_cut_wholly():
    assert planned(petals(9)).report.uncut_area < 0.01


def test_sharp_tip_is_left_to_the_levels_of_the_slot():
    report = planned(WEDGE).report
    assert report.engagement_p99 < report.engagement_limit + math.radians(9)
    assert report.over_limit_share < 0.003


@pytest.fixture
def proofs(monkeypatch):
    """Return the reports of all proofs, also of those after which something else was planned."""
    found = []
    prove = planner.prove
    monkeypatch.setattr(planner, "prove", lambda *args: found.append(prove(*args)) or found[-1])
    return found


@pytest.mark.parametrize("stepover", [2.9, 3.6, 5.0])
def test_laps_that_meet_leave_nothing_between_them(stepover, proofs):
    planned(CROSS, stepover)
    assert [proof.uncut_area < 0.01 for proof in proofs] == [True]


def test_a_slim_arm_of_a_plug_does_not_hide_the_rest_of_it(proofs):
    jaw = Point(0, 0).buffer(15, quad_segs=32) - box(-20, -4.5, 0, 4.5)
    eye = Point(100, 0).buffer(13, quad_segs=32)
    wrench = rounded(jaw | eye | LineString([(0, 0), (95, 0)]).buffer(6.5), 3.3)
    result = planned(wrench - Point(100, 0).buffer(3.3))
    assert result.report.uncut_area < 0.01 and len(proofs) == 1


def kinks(result: Plan, at_walls: bool = False) -> int:
    """Return how many turns over 20 degrees on the spot there are at depth, off walls or at all."""
    path = result.toolpath
    floor = path.points[:, 2].min() + 1e-6
    flat = (path.points[:, 2] < floor) & (path.starts[:, 2] < floor)
    aside = np.array([[0.0, 1.0], [-1.0, 0.0]])
    sense = np.where(path.kinds == Kind.ARC_CCW, 1.0, -1.0)[:, None]

    def headings(places):
        ahead = np.where(
            path.is_arc[:, None],
            sense * ((places[:, :2] - path.centers) @ aside),
            (path.points - path.starts)[:, :2],
        )
        return np.arctan2(ahead[:, 1], ahead[:, 0])

    leaving, arriving = headings(path.starts), headings(path.points)
    turns = np.abs((leaving[1:] - arriving[:-1] + np.pi) % (2 * np.pi) - np.pi)
    long = path.lengths > 1e-3
    wall = result.request.pocket.boundary.buffer(result.request.cutter_radius + 0.05)
    free = at_walls | ~shapely.contains_xy(wall, path.points[:-1, :2])
    sharp = (turns > math.radians(20)) & flat[1:] & flat[:-1] & long[1:] & long[:-1] & free
    return int(sharp.sum())


@pytest.mark.parametrize("share", [0.4, 0.5])
def test_fronts_that_meet_have_no_hooks_however_wide_the_step(share):
    bosses = [Point(x, y).buffer(6) for x in (-35, 35) for y in (-22, 22)]
    plate = box(-50, -35, 50, 35).buffer(-6).buffer(6).difference(shapely.union_all(bosses))
    assert kinks(planned(plate, 6 * share)) < 10


@pytest.mark.parametrize("gap", [7.5, 9.0, 11.0])
def test_strokes_between_bosses_come_to_them_and_leave_them_smoothly(gap):
    bosses = [Point(0, y).buffer(4, quad_segs=16) for y in (-4 - gap / 2, 4 + gap / 2)]
    plate = rounded(box(-35, -29, 35, 29), 4.0).difference(shapely.union_all(bosses))
    result = planned(plate, 0.9)
    assert kinks(result, at_walls=True) < 6
    assert result.report.over_limit_share < 0.003


@pytest.mark.parametrize("name", ["dog bones", "channel", "island by the wall"])
def test_isotherms_keep_out_of_corners_that_stick_out(name, proofs):
    pocket = {"dog bones": DOG_BONES, "channel": CHANNEL, "island by the wall": BY_THE_WALL}[name]
    plan(make_request(pocket, strategy=Strategy.ISOTHERM))
    assert proofs[0].gouge <= 0.01


@pytest.mark.parametrize("pocket", [petals(5), petals(9)], ids=["five", "nine"])
def test_ramps_along_curved_walls_are_few_moves(pocket):
    path = planned(pocket).toolpath
    entry = (path.kinds != Kind.RAPID) & (path.roles == Role.ENTRY)
    assert np.median(path.lengths[entry]) > 0.5
    # what a small controller reads in a second
    ends = np.cumsum(path.lengths / path.feeds)
    begun = np.searchsorted(ends, ends - 1.0)
    assert (np.arange(len(ends)) - begun).max() < 200


@pytest.mark.parametrize("width", [6.5, 7.5, 9.5])
def test_four_rooms_in_a_ring_of_channels_are_cut_without_a_lift(width):
    rooms = [box(x, y, x + 25, y + 25) for x in (0, 40) for y in (0, 40)]
    half = width / 2
    channels = [box(0, y - half, 65, y + half) for y in (12.5, 52.5)]
    channels += [box(x - half, 0, x + half, 65) for x in (12.5, 52.5)]
    result = planned(rounded(shapely.union_all([*rooms, *channels]), 3.2))
    assert lifts(result) == 1
    assert result.report.link_hit == 0


def test_slot_goes_to_the_ends_of_a_narrow_room():
    narrow = LineString([(0, 0), (40, 0), (40, 30)]).buffer(4)
    result = planned(narrow)
    assert result.report.uncut_area < 0.01
    assert lifts(result) == 1


@pytest.mark.parametrize(("width", "count"), [(6.03, 2), (6.1, 2), (6.6, 1)])
def test_channel_hardly_wider_than_the_cutter_is_cut_in_levels(width, count):
    rooms = box(0, 0, 60, width).union(box(-20, -10, 0, 20)).union(box(60, -10, 80, 20))
    result = planned(rooms)
    report = result.report
    assert report.uncut_area < 0.01
    assert report.engagement_p99 < report.engagement_limit + math.radians(9)
    assert lifts(result) <= count  # from plug to plug no raster shows the narrowest


@pytest.mark.parametrize("width", [6.03, 6.2])
def test_slot_hardly_wider_than_the_cutter_is_cut(width):
    result = planned(box(0, 0, 30, width))
    assert result.report.uncut_area < 0.01
    assert result.report.gouge <= 0.01
    assert lifts(result) == 1


def test_hole_in_which_the_cutter_can_only_plunge_is_refused():
    with pytest.raises(CutterDoesNotFitError, match="no room for its helix"):
        planned(Point(0, 0).buffer(3.05, quad_segs=64))


@pytest.mark.parametrize("pocket", [Point(0, 0).buffer(3.4), box(0, 0, 8, 8)], ids=["hole", "room"])
def test_way_down_in_a_room_hardly_wider_than_the_cutter_is_no_steeper(pocket):
    path = planned(pocket).toolpath
    in_stock = (path.roles == Role.ENTRY) & (path.starts[:, 2] <= 1e-9)
    drop = (path.starts - path.points)[in_stock, 2]
    assert (drop <= path.lengths[in_stock] * math.sin(math.radians(5)) * 1.01).all()


@pytest.mark.parametrize("strategy", [Strategy.LINEAR_MORPH, Strategy.CENTRAL_SPIRAL])
@pytest.mark.parametrize("diameter", [0.1, 0.3])
def test_room_of_hundredths_about_a_small_cutter_is_cut(diameter, strategy):
    room = Point(0, 0).buffer(0.56 * diameter, quad_segs=64)
    values = {"tool_diameter": diameter, "tolerance": diameter / 60, "strategy": strategy}
    heights = Heights(8.0, 3.0, 0.0, -diameter, diameter)
    asked = make_request(room, heights=heights, cutting=Cutting(0.4 * diameter), **values)
    report = plan(asked).report
    assert report.uncut_area < 1e-3 * diameter**2
    assert report.gouge < 0.01 * diameter


def test_extended_archimedean_cuts_a_slot_hardly_wider_than_the_cutter_along_its_middle():
    slot = make_request(box(0, 0, 30, 6.1), strategy=Strategy.EXTENDED_ARCHIMEDEAN)
    report = plan(slot).report
    assert report.uncut_area < 1e-3
    assert report.over_limit_share < 0.01


def test_extended_archimedean_refuses_a_room_without_a_middle_line():
    with pytest.raises(CutterDoesNotFitError):
        plan(make_request(box(0, 0, 6.1, 6.1), strategy=Strategy.EXTENDED_ARCHIMEDEAN))


def test_the_time_of_a_way_of_two_points_is_told():
    motion = Motion(acceleration=500.0, link_feed=80.0, cut_feed=50.0, least_radius=0.4)
    assert 0.1 < link_times(np.array([[0.0, 0.0], [10.0, 0.0]]), motion) < 0.21


def letter_q(turn, length, width):
    """Return a letter Q, whose tail cuts a notch into the island in its middle."""
    disc = Point(0, 0).buffer(1, quad_segs=64)
    ring = scale(disc, 38, 40).difference(scale(disc, 22, 34))
    tail = rotate(box(-width / 2, -50, width / 2, length - 28), turn, origin=(0, -30))
    return ring.union(tail.intersection(scale(disc, 38, 55)))


@pytest.mark.parametrize(
    ("turn", "length", "width"), [(20, 14, 7), (20, 18, 8), (45, 14, 7), (45, 24, 9)]
)
def test_a_notch_in_an_island(turn, length, width):
    cutting = Cutting(1.25)
    pocket = letter_q(turn, length, width)
    report = plan(make_request(pocket, tool_diameter=5.0, cutting=cutting)).report
    assert report.uncut_area < 0.02 and report.gouge < 0.01
    assert report.rapid_hit == 0 and report.link_hit < 0.05
    assert report.engagement_p99 < report.engagement_limit + math.radians(9)


@pytest.mark.parametrize("more", [1e-6, 1e-4, 1e-3, 0.005])
def test_a_neck_as_wide_as_the_cutter_and_no_more_is_told_and_the_rooms_are_cut(more):
    neck = box(-11, -3 - more / 2, 11, 3 + more / 2)
    rooms = box(-40, -15, -10, 15).union(box(10, -12, 34, 12))
    report = plan(make_request(rooms.union(neck), strategy=Strategy.AUTOMATIC)).report
    assert report.uncut_area < 0.01
    assert sum("does not fit the 6 mm neck" in str(notice) for notice in report.notices) == 1
    assert report.engagement_p99 < report.engagement_limit + math.radians(9)


@pytest.mark.parametrize("diameter", [5.0, 5.2])
def test_an_arm_of_a_plug_beyond_reach_is_not_taken_for_cleared(diameter):
    # filled by the rounding of fronts, the Q's tail has no edge left that would tell
    path = TextPath(
        (0, 0), "Q", size=100, prop=FontProperties(family="DejaVu Serif", weight="bold")
    )
    rings = sorted((Polygon(ring) for ring in path.to_polygons()), key=lambda ring: -ring.area)
    pocket = rings[0].difference(shapely.union_all(rings[1:]))
    cutting = Cutting(diameter / 4)
    report = plan(make_request(pocket, tool_diameter=diameter, cutting=cutting)).report
    assert report.uncut_area < 0.02 and report.link_hit < 0.05


def test_crowds_of_points_cost_nothing():
    plain = box(-10, -6, 10, 6).buffer(-2).buffer(2, quad_segs=32)
    crowded = planned(shapely.segmentize(plain, 0.002))
    assert len(crowded.toolpath) == len(planned(plain).toolpath)
    assert crowded.request.pocket.exterior.length == pytest.approx(plain.exterior.length)


def test_a_room_without_a_way_down_is_told_once():
    hole = Point(30, 0).buffer(3.06, quad_segs=64)
    pocket = shapely.union_all([box(-15, -12, 15, 12), box(14, -1, 30, 1), hole])
    report = plan(make_request(pocket, strategy=Strategy.AUTOMATIC)).report
    assert report.uncut_area > 25
    told = [str(notice) for notice in report.notices]
    assert sum("no room for its helix" in text for text in told) == 1
    assert not any("of the floor stay uncut" in text for text in told)
