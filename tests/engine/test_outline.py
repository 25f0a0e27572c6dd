# SPDX-License-Identifier: LGPL-2.1-or-later
"""Once round the wall and inwards: one spiral, gentle, all of it cut."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from shapely import LineString, Point, Polygon, box
from shapely.affinity import rotate
from shapes import DUMBBELL, L_SHAPE, SQUARE, request

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.growth.front_rules import FrontRules, engagement_step
from freecad_spiralpocket.engine.growth.spiral import slim_ends_of, spiral_through, without_air
from freecad_spiralpocket.engine.growth.strokes import strokes_between
from freecad_spiralpocket.engine.model import Cutting, Strategy
from freecad_spiralpocket.engine.opening import open_sides
from freecad_spiralpocket.engine.opening.outline import outline_of
from freecad_spiralpocket.engine.shapes.polyline import closed_line
from freecad_spiralpocket.engine.shapes.shaping import rim_points, thick_parts, without_whiskers
from freecad_spiralpocket.engine.toolpath import Role

R = 3.0
ROUND = Point(0, 0).buffer(30, quad_segs=64)
#: Sharp, in the middle of the coordinates: its walls come back from a buffer off by a hairline.
DIAMOND = Polygon([(-35, 0), (0, -25), (35, 0), (0, 25)])
POCKETS = {
    "square": SQUARE,
    "L": L_SHAPE,
    "dumbbell": DUMBBELL,
    "round": ROUND,
    "diamond": DIAMOND,
}


def regions(pocket: Polygon) -> Polygon:
    return pocket.buffer(-R, quad_segs=32)


@pytest.fixture
def only_outline(monkeypatch):
    """Let Automatic open pockets along their walls only."""
    every = open_sides.candidates

    def outline(region, asked):
        return [start for start in every(region, asked) if start.name == "outline"]

    monkeypatch.setattr(open_sides, "candidates", outline)


@pytest.mark.parametrize("name", POCKETS)
def test_pocket_is_cleared_inwards(name, only_outline):
    report = plan(request(POCKETS[name], strategy=Strategy.AUTOMATIC)).report
    assert report.uncut_area < 0.01
    assert report.gouge <= 0.01
    assert report.rapid_hit == 0 and report.link_hit == 0
    assert report.engagement_p99 <= report.engagement_limit + math.radians(6)


def test_hairlines_along_the_walls_join_no_corners():
    frame = DIAMOND.difference(DIAMOND.buffer(-1e-9))
    assert len(thick_parts(frame)) == 0
    corners = shapely.union_all([frame, *(Point(c).buffer(2) for c in DIAMOND.exterior.coords[1:])])
    parts = thick_parts(corners.intersection(DIAMOND))
    assert len(parts) == 4
    assert shapely.area(parts).sum() == pytest.approx(corners.intersection(DIAMOND).area, rel=1e-4)


def test_round_pocket_is_one_spiral_without_links(only_outline):
    made = plan(request(ROUND, strategy=Strategy.AUTOMATIC))
    roles = made.toolpath.roles
    assert not (roles == Role.LINK).any()
    cuts = np.flatnonzero(roles == Role.CUT)
    assert (np.diff(cuts) == 1).all()


def test_laps_of_a_round_plug_keep_the_engagement_exactly():
    # the plug's radius p: the cutter at distance d from its middle, rim and plug meet at the limit
    rules = FrontRules(R, math.acos(1 - 2.4 / R), 4.0, 4.2)
    for front in (40.0, 25.0):
        step = float(engagement_step(np.array([-1 / front]), rules)[0])
        plug, d = front - R, front - step
        angle = math.acos((R**2 + d**2 - plug**2) / (2 * R * d))
        assert angle == pytest.approx(rules.limit, abs=1e-9)
        assert step > rules.stepover


def test_sharp_corners_are_rounded_and_cut(only_outline):
    sharp = box(0, 0, 40, 40)
    outline = outline_of(regions(sharp), R)
    corner = Point(R, R)
    assert outline.ring.distance(corner) > 0.02
    made = plan(request(sharp, strategy=Strategy.AUTOMATIC))
    assert made.report.uncut_area < 0.01
    ends = made.toolpath.points[made.toolpath.roles == Role.ENTRY][:, :2]
    assert shapely.distance(LineString(ends), corner) < 1e-6


@pytest.mark.parametrize("width", [15.0, 22.0, 26.0, 33.0])
@pytest.mark.parametrize("angle", [0.0, 37.0])
def test_slot_goes_into_slim_tips(width, angle, only_outline):
    wedge = rotate(Polygon([(0, 0), (120, 0), (120, width)]), angle, origin=(0, 0))
    region = regions(wedge)
    assert shapely.hausdorff_distance(outline_of(region, R).ring, region.exterior) < 0.55
    report = plan(request(wedge, strategy=Strategy.AUTOMATIC)).report
    assert report.engagement_p99 <= report.engagement_limit + math.radians(6)
    assert report.uncut_area < 0.01


def test_rims_keep_what_hangs_on_by_a_hairline():
    wedge = Polygon([(33, 3), (117, 18.4), (117, 3)])
    blunt = shapely.intersection(wedge.buffer(-0.45).buffer(0.45), wedge)
    pieces = shapely.get_parts(shapely.difference(wedge, blunt))
    assert not any(shapely.segmentize(p, 0.5).distance(Point(33, 3)) == 0 for p in pieces)
    points, piece = rim_points(pieces, 0.5)
    assert shapely.distance(Point(33, 3), shapely.points(points)).min() == 0.0
    for i, shape in enumerate(pieces):
        assert shapely.distance(shape.boundary, shapely.points(points[piece == i])).max() < 1e-9


@pytest.mark.parametrize("name", POCKETS)
def test_wall_is_no_boundary_of_the_region_to_grow_in(name):
    region = regions(POCKETS[name])
    outline = outline_of(region, R)
    assert outline.omega.contains(region)
    # all but the plugs is visited, and the ring runs along the wall
    left = outline.omega.difference(outline.visited)
    assert region.buffer(1e-6).contains(left)
    assert left.area == pytest.approx(region.area, rel=0.01)
    # at a corner of 71 degrees as far as a circle of 0.02 R stays off it
    assert shapely.hausdorff_distance(outline.ring, region.exterior) < 0.1
    assert not shapely.is_ccw(outline.ring)


def test_island_is_not_cut_where_the_cutter_just_passes_between_it_and_the_wall():
    pocket = box(-40, -30, 40, 30).difference(Point(0, 18).buffer(6, quad_segs=64))
    assert plan(request(pocket, strategy=Strategy.AUTOMATIC)).report.gouge <= 0.01


def test_neck_narrower_than_the_slot_stays_one_ring():
    neck = box(0, 0, 30, 30).union(box(29, 11, 61, 19)).union(box(60, 0, 90, 30))
    assert outline_of(regions(neck), R) is not None


def test_stroke_that_is_narrow_in_places_stays_one_ring():
    along = np.linspace(0, 120, 241)
    widths = 3.1 + 0.2 * np.sin(along / 9) ** 2
    discs = [Point(x, 0).buffer(w, quad_segs=24) for x, w in zip(along, widths, strict=True)]
    assert outline_of(regions(shapely.union_all(discs)), R) is not None


def test_path_ends_where_nothing_is_left():
    # a rib of 1 mm: one side of the lap round it takes all
    stock = box(-20, -0.5, 20, 0.5)
    hole, lap = (stock.buffer(R + d).exterior.segmentize(0.5).coords for d in (0.1, -1.1))
    hole, lap = closed_line(hole[:-1]), closed_line(lap[:-1])
    path = spiral_through(hole, slim_ends_of(hole, lap, R, 2.4)[0], [lap], R)
    trimmed = without_air(path, stock, R)
    assert LineString(trimmed).length < 0.8 * LineString(path).length
    assert stock.difference(LineString(trimmed).buffer(R, quad_segs=32)).area < 2e-3


def test_path_that_leaves_stock_is_not_cut_short():
    far = box(-20, 10, 20, 11)
    lap = shapely.get_coordinates(box(-20, -1, 20, 1).exterior.segmentize(0.5))
    assert without_air(lap, far, R) is None
    half = far.union(box(-20, -0.5, 20, 0.5))
    assert without_air(lap, half, R) is None


def test_small_step_over_is_planned(only_outline):
    made = plan(request(SQUARE, strategy=Strategy.AUTOMATIC, cutting=Cutting(0.9)))
    assert made.report.uncut_area < 0.01
    assert made.report.engagement_p99 <= made.report.engagement_limit + math.radians(8)


def test_a_stroke_does_not_run_round_a_crack_along_the_wall():
    before = box(0, 0, 10, 10)
    crack = box(9.4, 9.996, 9.9, 9.999)  # opens to the wall at its end
    after = box(0, 0, 20, 10) - crack - box(9.89, 9.996, 9.9, 10)
    (stroke,) = strokes_between(before, after, 1)
    steps = np.diff(stroke.points, axis=0)
    assert ((steps[1:] * steps[:-1]).sum(axis=1) > -1e-9).all()
    assert stroke.points[0, 0] < 10


def test_a_whisker_along_a_wall_is_removed():
    whisker = Polygon([(0, 0), (9, 0), (9, 5), (0, 5), (0, 1e-9), (-4, 0), (0, 0)])
    cleared = without_whiskers(whisker)
    assert cleared.bounds == pytest.approx((0, 0, 9, 5), abs=1e-6)
    assert cleared.area == pytest.approx(45)
    assert without_whiskers(cleared) is cleared


@pytest.mark.parametrize("post", [0.004, 0.02, 0.05])
def test_thin_post_between_two_sides_of_the_slot_is_cut(post):
    half, length = R * 2 + post / 2, 24.0
    arms = [box(-length, -half, length, half), box(-half, -length, half, length)]
    report = plan(request(rotate(arms[0] | arms[1], 14), strategy=Strategy.AUTOMATIC)).report
    assert report.uncut_area < 0.01
    assert report.rapid_hit == 0 and report.link_hit == 0
    assert not any("instead of" in notice.message for notice in report.notices)
