# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long ways round: over free ground, and back over the slot that the entry cut."""

import math

import numpy as np
import pytest
import shapely
from shapely import LineString, Point, Polygon, box
from shapely.geometry.polygon import orient

from freecad_spiralpocket.engine.growth.strokes import Stroke
from freecad_spiralpocket.engine.links.cleared import ClearedMap
from freecad_spiralpocket.engine.links.ground import COARSE, Ground
from freecad_spiralpocket.engine.links.ring_ways import back_along_ring, onto_ring
from freecad_spiralpocket.engine.links.routing import HOPE, LongWays, tightest_bend
from freecad_spiralpocket.engine.shapes.shaping import largest


@pytest.mark.parametrize("arriving", [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0)])
@pytest.mark.parametrize("end", [(10.0, 20.0), (10.0, 26.0), (34.0, 20.0)])
def test_long_way_round_turns_in_a_loop_where_there_is_room(end, arriving):
    room, radius, least = box(0, 0, 60, 40), 3.0, 0.36
    cleared = ClearedMap([room], [], room, [], radius, 0.25)
    start, heading = np.array([30.0, 20.0]), np.array([1.0, 0.0])
    ends = np.array(end), np.array(arriving)
    way = LongWays(start, heading, cleared, room.buffer(0.003), radius, least).to(*ends)
    assert way is not None and tightest_bend(way) >= least
    np.testing.assert_allclose([way[0], way[-1]], [start, end], atol=1e-9)
    leaving, reaching = way[1] - way[0], way[-1] - way[-2]
    assert leaving @ heading > 0.9 * np.hypot(*leaving)
    assert reaching @ arriving > 0.9 * np.hypot(*reaching)
    # in a turn as tight as it may be a chord turns by less than 24 degrees
    assert np.hypot(*np.diff(way, axis=0).T).max() < least * math.radians(24)


@pytest.mark.parametrize("off", [0.0, 0.3, 0.6])
@pytest.mark.parametrize("half", [1.0, 4.0])
@pytest.mark.parametrize("gap", [0.3, 3.0])
def test_a_way_round_the_tip_of_what_stands_is_found(off, half, gap):
    room = orient(box(0, 0, 60, 40))
    wedge = Polygon([(-1, 20 - half + off), (30 + off, 20 + off), (-1, 20 + half + off)])
    points = np.column_stack([np.linspace(0, 30, 61), np.full(61, 20 + off)])
    before = orient(room.difference(wedge))
    cleared = ClearedMap([before, room], [Stroke(points, 1, False, False)], room, [], 6.0, 0.25)
    x, aside = 10.0, half * (20 + off) / (31 + off) + gap
    start, end = np.array([x, 20 + off + aside]), np.array([x, 20 + off - aside])
    heading = np.array([1.0, 0.0])
    way = LongWays(start, heading, cleared, room.buffer(0.003), 3.0, 0.36).to(end, -heading)
    assert way is not None
    assert not LineString(way).intersects(wedge.buffer(-0.25))


@pytest.mark.parametrize("angle", [-2.0, -0.5, 0.3, 1.0, 3.0])
@pytest.mark.parametrize("off", [0.0, 0.03, 0.09])
def test_no_step_aside_on_the_way_back_over_the_slot(angle, off):
    room, middle = box(0, 0, 60, 40), Point(30, 20)
    ring = LineString(middle.buffer(10, quad_segs=64).exterior)
    cleared = ClearedMap([orient(ring.buffer(0.05))], [], room, [], 3.0, 0.25, ring)
    start = np.array([40.0 - off, 20.0])
    end = np.array([30.0, 20.0]) + (10 + off) * np.array([math.cos(angle), math.sin(angle)])
    way, _ = back_along_ring(start, end[None], cleared, room)
    np.testing.assert_allclose([way[0], way[-1]], [start, end], atol=1e-9)
    headings = np.arctan2(*np.diff(way, axis=0).T[::-1])
    assert np.abs(np.diff(np.unwrap(headings))).max() < math.radians(10)
    # it keeps to the slot but at its ends
    inner = way[np.minimum(*(np.hypot(*(way - end_).T) for end_ in (start, end))) > 1.5]
    assert shapely.distance(ring, shapely.points(inner)).max(initial=0.0) < 1e-3


def test_beside_one_place_of_the_slot_the_way_leads_straight_across():
    room, ring = box(0, 0, 60, 40), LineString(Point(30, 20).buffer(10).exterior)
    cleared = ClearedMap([orient(ring.buffer(0.05))], [], room, [], 3.0, 0.25, ring)
    start, end = np.array([40.05, 20.0]), np.array([39.96, 20.0])
    way, _ = back_along_ring(start, end[None], cleared, room)
    np.testing.assert_allclose(way, [start, end])


@pytest.mark.parametrize("turn", [1, -1])
@pytest.mark.parametrize("end", [(40.0, 6.0), (40.0, 34.0), (31.0, 6.3)])
def test_a_way_turns_onto_the_slot_out_of_a_channel(end, turn):
    room, channel = box(32, 8, 60, 32).buffer(2), box(0, 18, 34, 22)
    region = orient(room.union(channel).buffer(-1).buffer(3, quad_segs=32).buffer(-2))
    ring = LineString(region.exterior.coords[::turn])
    # in the room the slot has stock beside it
    slot = orient(channel.union(region.difference(region.buffer(-0.02))))
    cleared = ClearedMap([slot], [], region, [], 3.0, 0.25, ring)
    start, fence, radius = np.array([5.0, 20.0]), region.buffer(0.003), 3.0
    shapely.prepare(fence)
    at = ring.project(Point(end))
    place, ahead = (np.array(ring.interpolate(at + off).coords[0]) for off in (0, turn * 0.1))
    onward = 1 if end[1] < 20 else -1  # away from the channel: counter-clockwise below it
    heading = onward * (ahead - place) / 0.1
    ways = LongWays(start, np.array([1.0, 0.0]), cleared, fence, radius)
    assert ways.to(place, heading) is None  # no spline keeps to the slot
    found = onto_ring(ways, place[None], heading[None], cleared, fence, radius)
    assert found is not None and found[1] == 0
    way = found[0]
    np.testing.assert_allclose([way[0], way[-1]], [start, place], atol=1e-9)
    headings = np.unwrap(np.arctan2(*np.diff(way, axis=0).T[::-1]))
    assert np.abs(np.diff(headings)).max() < math.radians(25)
    within = shapely.contains_xy(room, way)
    assert within.any()
    assert shapely.distance(ring, shapely.points(way[within])).max() < 0.01


@pytest.mark.parametrize("gap", [0.1, 0.6, 2.0])
@pytest.mark.parametrize("seed", range(4))
def test_hopeful_ground_knows_of_every_way(gap, seed):
    random = np.random.default_rng(seed)
    posts = [Point(x, y).buffer(random.uniform(2, 7)) for x, y in random.uniform(5, 55, (30, 2))]
    gate = random.uniform(5, 50)
    wall = [box(29, 0, 31, gate), box(29, gate + gap, 31, 60)]
    ground = largest(box(0, 0, 60, 60).difference(shapely.union_all([*posts, *wall])))
    start, *ends = random.uniform(2, 58, (9, 2))
    cleared = ClearedMap([orient(ground)], [], box(0, 0, 60, 60), [], 3.0, 0.25)
    hopeful = Ground(cleared, cleared.near, start, hopeful=True)
    for free, coarse in ((cleared.free, COARSE), (cleared.near, COARSE), (cleared.free, 1)):
        for end in ends:
            way = Ground(cleared, free, start, coarse).way_to(end)
            if way is not None:
                least = hopeful.way_to(end)
                assert least is not None
                slack = HOPE * COARSE * cleared.pixel
                assert LineString(least).length < LineString(way).length + slack


def _half_cleared():
    """Return a room whose left half is cleared, and two strokes side by side along its edge."""
    room = orient(box(0, 0, 60, 40))
    before = orient(box(0, 0, 30, 40))
    rows = np.linspace(5, 24, 39), np.linspace(20, 35, 31)  # the first runs on beside the second
    strokes = [Stroke(np.column_stack([np.full(len(y), 32.0), y]), 1, False, False) for y in rows]
    return ClearedMap([before, room], strokes, room, [], 6.0, 0.25), room, strokes


@pytest.mark.parametrize("angle", np.radians(range(0, 360, 30)))
def test_places_are_open_where_a_way_may_begin(angle):
    cleared, _, _ = _half_cleared()
    heading = np.array([[math.cos(angle), math.sin(angle)]])
    assert cleared.are_open(np.array([[20.0, 20.0]]), heading)[0]
    assert not cleared.are_open(np.array([[34.0, 20.0]]), heading)[0]
    # on the edge of what stands it may only lead back
    if abs(heading[0, 0]) > 0.6:
        assert cleared.are_open(np.array([[30.2, 20.0]]), heading)[0] == (heading[0, 0] < 0)


@pytest.mark.parametrize("angle", np.radians(range(0, 360, 45)))
@pytest.mark.parametrize("x", [20.0, 29.0, 30.1, 33.0])
def test_where_a_way_is_found_its_ends_are_open(angle, x):
    cleared, room, _ = _half_cleared()
    start, end = np.array([10.0, 20.0]), np.array([x, 12.0])
    heading, arriving = np.array([0.0, 1.0]), np.array([math.cos(angle), math.sin(angle)])
    way = LongWays(start, heading, cleared, room.buffer(0.003), 3.0).to(end, arriving)
    if way is not None and tightest_bend(way) > 0.1:  # less is a turn on the spot
        assert cleared.are_open(np.array([start, end]), np.array([heading, -arriving])).all()


def test_where_a_stroke_ends_on_the_ground_of_another_a_link_may_begin():
    cleared, _, strokes = _half_cleared()
    cleared.finish(0)
    points = strokes[0].points
    assert cleared.near[cleared.cells(points)].all()
    assert cleared.are_open(points[-1:], np.array([[0.0, -1.0]]))[0]
