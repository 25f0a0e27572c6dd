# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets that were cleared in part before: only the rest is cut, begun in the air."""

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from shapely import Point, Polygon, box
from shapes import assert_ways_down_are_fed, lifts, opened
from shapes import request as make_request

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.contact.air import intervals_in_air
from freecad_spiralpocket.engine.contact.swept import cut_into_pieces
from freecad_spiralpocket.engine.errors import AlreadyClearedError
from freecad_spiralpocket.engine.model import CutMode, Cutting, Strategy
from freecad_spiralpocket.engine.proof.coverage import polylines
from freecad_spiralpocket.engine.toolpath import Kind

R = 3.0
DUMBBELL = box(0, 0, 40, 40).union(box(70, 0, 110, 40)).union(box(39, 15, 71, 25))
POCKETS = {
    "square": box(0, 0, 60, 60),
    "rooms": DUMBBELL,
    "islands": box(0, 0, 90, 55)
    .difference(Point(28, 27).buffer(9))
    .difference(box(60, 18, 72, 36)),
}


def rest_request(pocket, cleared, **changes):
    """Return a request for what a larger cutter left, in stock that goes on all around."""
    rest = pocket.difference(cleared).buffer(-0.015).buffer(0.02).intersection(pocket)
    stock = box(*pocket.bounds).buffer(60, join_style="mitre").difference(pocket.difference(rest))
    return make_request(pocket, stock=stock, strategy=Strategy.AUTOMATIC, **changes)


def swept(result):
    request = result.request
    pieces = cut_into_pieces(result.toolpath, R, request.heights.start_depth, request.axial_depth)
    deep = pieces.select((pieces.heights <= request.floor + 1e-6) & ~pieces.rapid)
    return shapely.union_all(shapely.buffer(polylines(deep), R, quad_segs=32))


def seconds(result):
    return result.report.time


@pytest.mark.parametrize(
    ("name", "left_on_walls", "mode"),
    [
        ("square", 0.0, CutMode.CONVENTIONAL),
        ("square", 0.4, CutMode.CLIMB),
        ("rooms", 0.0, CutMode.CLIMB),
        ("rooms", 0.4, CutMode.CONVENTIONAL),
        ("islands", 0.0, CutMode.CLIMB),
        ("islands", 0.4, CutMode.CONVENTIONAL),
    ],
)
def test_the_rest_is_cleared_and_takes_less_time(name, left_on_walls, mode):
    pocket = POCKETS[name]
    cleared = opened(pocket.buffer(-left_on_walls), 8.0)
    asked = rest_request(pocket, cleared)
    asked = replace(asked, cutting=replace(asked.cutting, cut_mode=mode))
    result = plan(asked)
    left = opened(pocket, R).difference(cleared).difference(swept(result).buffer(0.03))
    assert left.buffer(-0.01).area < 0.01
    report = result.report
    assert report.gouge < 0.01 and report.rapid_hit == 0 and report.uncut_area < 0.02
    assert_ways_down_are_fed(result)
    # the ways down in cleared ground are fed, and take a part of the time saved
    assert seconds(result) < 0.77 * seconds(plan(replace(asked, stock=None)))


def test_a_room_that_was_not_cleared_is_cut_from_within():
    result = plan(rest_request(DUMBBELL, opened(box(0, 0, 40, 40), 8.0)))
    down = result.toolpath.points[result.toolpath.points[:, 2] < -1e-6][0]
    assert 39 < down[0] < 110
    assert result.report.engagement_p99 < result.report.engagement_limit + math.radians(12)


def test_nothing_left_is_told():
    with pytest.raises(AlreadyClearedError, match="UseRestMachining"):
        plan(rest_request(POCKETS["square"], POCKETS["square"]))


def test_rooms_with_nothing_left_are_left_out():
    apart = box(0, 0, 40, 40).union(box(70, 0, 110, 40)).union(box(39, 18, 71, 22))
    result = plan(rest_request(apart, opened(box(0, 0, 40, 40), R).union(box(39, 18, 50, 22))))
    assert (result.toolpath.points[result.toolpath.points[:, 2] < -1e-6][:, 0] > 60).all()


@pytest.mark.parametrize("asked", [(20.0, 22.0), (45.0, 30.0)])
def test_begins_where_it_is_asked_to_in_cleared_ground(asked):
    cleared = opened(POCKETS["square"], 10.0)
    result = plan(rest_request(POCKETS["square"], cleared, start_point=asked))
    down = result.toolpath.points[result.toolpath.points[:, 2] < -1e-6][0]
    assert math.dist(down[:2], asked) < 2 * R
    assert result.report.uncut_area < 0.02


def test_the_cutter_goes_down_in_the_air_and_cuts_nothing_there():
    cleared = opened(POCKETS["square"], 10.0)
    result = plan(rest_request(POCKETS["square"], cleared))
    path = result.toolpath
    down = np.flatnonzero(
        (path.starts[:, 2] - path.points[:, 2] > 0.1) & (path.kinds != Kind.RAPID)
    )
    assert len(np.unique(path.points[down, :2], axis=0)) == 1
    assert cleared.contains(Point(path.points[down[0], :2]).buffer(R))


STOCKS = {
    "plate": box(-10, -10, 10, 10),
    "wedge": Polygon([(-8, -6), (9, 0), (-8, 2)]),
    "holes": box(-20, -20, 20, 20).difference(Point(2, 1).buffer(4)).difference(box(-9, -9, -3, 9)),
    "islands": shapely.union_all(
        [Point(-6, 0).buffer(2), Point(3, 3).buffer(1), box(2, -7, 3, -2)]
    ),
}


@pytest.mark.parametrize("name", STOCKS)
def test_intervals_in_air_are_those_of_a_fine_rim(name):
    stock, random, count = STOCKS[name], np.random.default_rng(5), 300
    centers, headings = random.uniform(-13, 13, (count, 2)), random.uniform(-9, 9, count)
    rims, low, high = intervals_in_air(centers, headings, stock, R)
    assert (high > low).all()
    turn = np.linspace(-np.pi, np.pi, 720, endpoint=False)
    angle = headings[:, None] + turn
    rim = centers[:, None] + R * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    found = np.zeros((count, len(turn)), bool)
    for i, a, b in zip(rims, low, high, strict=True):
        found[i] |= np.mod(turn - a, 2 * np.pi) < b - a
    true = ~shapely.contains_xy(stock, rim[..., 0], rim[..., 1])
    near = shapely.distance(stock.boundary, shapely.points(rim)) < 1e-6
    np.testing.assert_array_equal(found[~near], true[~near])


def test_a_rim_that_only_touches_is_whole():
    rims, low, high = intervals_in_air(np.array([[0.0, 13.0]]), np.zeros(1), STOCKS["plate"], R)
    assert len(rims) == 1 or np.isclose((high - low).sum(), 2 * np.pi)


def test_links_lead_through_the_cleared_middle():
    result = plan(rest_request(POCKETS["square"], opened(POCKETS["square"], 10.0)))
    assert lifts(result) == 1


def test_ribs_that_were_no_stock_above_are_no_air():
    """Where a wall ends below the level that a larger cutter came from, nothing goes through it."""
    top = box(0, 0, 114, 74)
    posts = [Point(x, y).buffer(5) for x, y in ((50, 25), (20, 50), (90, 50))]
    ribs = [box(28, -1, 30, 25), box(70, -1, 72, 25), box(40, 40, 80, 42)]
    pocket = top.difference(shapely.union_all(posts + ribs))
    rest = pocket.difference(opened(pocket, 5.0)).buffer(-0.015).buffer(0.02).intersection(pocket)
    stock = box(*top.bounds).buffer(60, join_style="mitre").difference(top.difference(rest))
    wanted = make_request(
        pocket,
        stock=stock,
        tool_diameter=3.0,
        cutting=Cutting(stepover=1.2),
        strategy=Strategy.AUTOMATIC,
    )
    made = plan(wanted)
    assert made.report.gouge <= 0.01 and made.report.uncut_area < 0.01
    # nothing was repaired, and the cutter stays down: its links end within the region
    assert not [n for n in made.report.notices if "instead of" in n.message]
    assert lifts(made) == 1
    assert_ways_down_are_fed(made)
