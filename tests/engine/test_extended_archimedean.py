# SPDX-License-Identifier: LGPL-2.1-or-later
"""Extended Archimedean: everything cleared, laps b apart, links of clothoids."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, Phase, given, settings
from shapely import LineString, Point, Polygon, box
from shapely.affinity import rotate, scale, translate
from shapes import CIRCLE, DUMBBELL, L_SHAPE, RING, SQUARE, TEE, crossed_bars, rounded
from shapes import request as make_request

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError
from freecad_spiralpocket.engine.floor import Helix, Slot
from freecad_spiralpocket.engine.laps import extended_archimedean
from freecad_spiralpocket.engine.middle_line.archimedean import bend_at
from freecad_spiralpocket.engine.middle_line.coverable import maximal_centers
from freecad_spiralpocket.engine.model import Cutting, Strategy
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.shapes.skeleton import medial_axis

POSTS = box(0, 0, 90, 64).difference(Point(24, 34).buffer(9)).difference(box(48, 18, 62, 40))
COMB = box(0, 0, 96, 20).union(shapely.union_all([box(x, 18, x + 14, 55) for x in (4, 40, 76)]))
POCKETS = {
    "square": SQUARE,
    "circle": CIRCLE,
    "L": L_SHAPE,
    "T": TEE,
    "dumbbell": DUMBBELL,
    "ring": RING,
    "posts": POSTS,
    "comb": COMB,
    "slot": box(0, 0, 25, 8.75),
    "just a cutter wide": box(0, 0, 60, 6.2),
}
#: Strokes thinner than 0.03 mm are not worth a move.
SLIVERS = 5e-5


def lay(pocket: Polygon, **changes):
    request = make_request(pocket, **changes)
    region = center_regions(pocket, request.cutter_radius, 0.0)[0]
    return region, extended_archimedean.lay(region, request, lambda done: None)


@pytest.mark.parametrize("name", POCKETS)
def test_pocket_is_cleared_inside_its_walls(name):
    report = plan(make_request(POCKETS[name], strategy=Strategy.EXTENDED_ARCHIMEDEAN)).report
    assert report.uncut_area < SLIVERS * POCKETS[name].area
    assert report.gouge <= 0.01
    assert report.rapid_hit == 0
    assert report.link_hit == 0


@pytest.mark.parametrize("shape", ["slim", "teardrop"])
def test_a_mirrored_or_shifted_pocket_is_planned_at_once_as_well(shape):
    pocket = rounded(box(-90, -7.5, 90, 7.5), 3.05)
    if shape == "teardrop":
        drop = shapely.union(Point(0, 0).buffer(22), Point(-50, 0).buffer(4)).convex_hull
        pocket = rounded(drop, 3.5)
    others = scale(pocket, -1, 1, origin=(0, 0)), translate(pocket, 1e-6, 0), rotate(pocket, 90)
    reports = [
        plan(make_request(p, strategy=Strategy.EXTENDED_ARCHIMEDEAN)).report
        for p in (pocket, *others)
    ]
    assert not [n for r in reports for n in r.notices if "the path asked for" in n.message]
    times = [report.time for report in reports]
    assert max(times) < 1.1 * min(times)


# each example takes a good part of a second: a failing one is told as it is, not shrunk
@settings(
    max_examples=12,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.reuse, Phase.generate],
)
@given(crossed_bars())
def test_any_branched_pocket_is_cleared(pocket):
    try:
        report = plan(make_request(pocket, strategy=Strategy.EXTENDED_ARCHIMEDEAN)).report
    except CutterDoesNotFitError:
        assert pocket.buffer(-3.3).is_empty
        return
    assert report.uncut_area < SLIVERS * pocket.area
    assert report.gouge <= 0.01


def test_circle_gives_archimedes_spiral():
    _, layout = lay(CIRCLE)
    (spiral,) = layout.spirals
    rays = layout.steps[0].points - [10.0, 5.0]
    radius = np.hypot(*rays.T)
    turned = np.unwrap(np.arctan2(rays[:, 1], rays[:, 0])) / (2 * math.pi)
    turned -= turned[0]
    laps = spiral.center.laps
    expected = radius[0] + 2.4 * np.minimum(turned, laps)
    # behind that it turns away from the stock
    spiral_only = turned < laps + 1
    assert np.abs(radius - expected)[spiral_only].max() < 0.02


@pytest.mark.parametrize("pocket", [SQUARE, L_SHAPE, POSTS, DUMBBELL], ids=["4", "L", "posts", "2"])
def test_laps_are_one_step_apart(pocket):
    _, layout = lay(pocket)
    for spiral, step in zip(layout.spirals, layout.steps, strict=False):
        last = spiral.rings[-1]
        along = shapely.line_locate_point(last, shapely.points(step.points)) / last.length
        turns = np.unwrap(2 * np.pi * along) / (2 * np.pi)
        turns -= turns[0]
        for turn in range(1, spiral.center.laps):
            # half of a turn, and the half turn beside it
            here = step.points[(turns > turn + 0.25) & (turns < turn + 0.75)]
            before = step.points[(turns > turn - 0.9) & (turns < turn - 0.1)]
            gap = shapely.distance(shapely.points(here), LineString(before))
            assert np.abs(np.quantile(gap, [0.01, 0.99]) - 2.4).max() < 0.024


def test_spirals_are_linked_by_clothoids_that_meet_them():
    _, layout = lay(DUMBBELL)
    assert sum(link is not None for link in layout.links) >= len(layout.spirals) - 1 > 0
    for i, link in enumerate(layout.links):
        if link is None:
            continue
        end = np.array([link.length])
        np.testing.assert_allclose(link.points_at(end)[0], layout.steps[i].points[0], atol=1e-6)
        # curvature goes on where the spiral before leaves it
        if i > 0:
            ring = layout.spirals[i - 1].rings[-1]
            at = ring.project(Point(link.start))
            _, heading, curvature = bend_at(ring, at, 3.0)
            assert math.remainder(link.heading - heading, 2 * math.pi) == pytest.approx(0, abs=1e-3)
            assert link.curvatures[0] == pytest.approx(curvature, abs=1e-3)


def test_centers_are_opened_in_shallow_levels():
    _, layout = lay(L_SHAPE)
    entry = layout.opening.start.entry
    assert isinstance(entry, Slot)
    assert entry.bite < 2.0
    ring = Polygon(entry.ring)
    assert ring.difference(ring.exterior.buffer(3.0)).area < 0.01
    _, layout = lay(CIRCLE)
    assert isinstance(layout.opening.start.entry, Helix)


def test_same_request_gives_the_same_path():
    (_, one), (_, two) = lay(POSTS), lay(POSTS)
    for a, b in zip(one.steps, two.steps, strict=True):
        np.testing.assert_array_equal(a.points, b.points)


@pytest.mark.parametrize("share", [0.1, 0.7, 1.0])
def test_thin_and_wide_steps_clear_the_pocket(share):
    request = make_request(
        L_SHAPE, strategy=Strategy.EXTENDED_ARCHIMEDEAN, cutting=Cutting(6.0 * share)
    )
    assert plan(request).report.uncut_area < 2 * SLIVERS * L_SHAPE.area


def test_greatest_piece_comes_first_and_walls_are_kept():
    region = center_regions(DUMBBELL, 3.0, 0.0)[0]
    centers = maximal_centers(region, medial_axis(region), 2.76, 2.4, 3.0)
    covered = [center.curve.buffer(2.76 + 2.4 * center.laps).area for center in centers]
    assert covered[0] == pytest.approx(max(covered))
    for center in centers[:2]:
        assert region.buffer(1e-3).covers(center.curve.buffer(2.76 + 2.4 * center.laps))
    # both rooms and the neck between them
    assert len(centers) == 3
    assert [center.laps > 0 for center in centers] == [True, True, False]


def test_center_of_a_square_is_its_middle_not_a_diagonal():
    region = center_regions(SQUARE, 3.0, 0.0)[0]
    (center,) = maximal_centers(region, medial_axis(region), 2.76, 2.4, 3.0)
    assert center.curve.length < 6.0
    assert center.curve.distance(Point(22, 22)) < 2.0


def test_a_corner_gets_no_spiral_however_many_laps_it_takes_and_a_room_does():
    def centers_in(pocket: Polygon) -> int:
        (region,) = center_regions(pocket, 3.0, 0.0)
        return len(maximal_centers(region, medial_axis(region), 2.76, 0.6, 3.0))

    triangle = Polygon([(0, 0), (60, 0), (30, 52)])
    room = Point(30, 58).buffer(16)
    assert centers_in(triangle) == 1
    assert centers_in(triangle.union(room)) == 2


def test_no_spiral_closes_round_an_island():
    # all of the middle line is wide but for a short piece: the rest leads nearly round
    pocket = Point(0, 0).buffer(34).difference(Point(6, 0).buffer(5))
    region, layout = lay(pocket, cutting=Cutting(0.6))
    island = Polygon(region.interiors[0])
    assert layout.spirals
    for spiral in layout.spirals:
        assert not any(within.intersects(island.buffer(-0.1)) for within in spiral.within)


BENT = LineString([(0, 0), (30, 0), (30, 14), (60, 14), (60, 0), (90, 0)])
CROSS = shapely.MultiLineString([[(0, 0), (60, 0)], [(30, -30), (30, 30)]])
RUNG = shapely.MultiLineString([[(0, y), (60, y)] for y in (0, 8, 16)] + [[(0, 0), (0, 16)]])


@pytest.mark.parametrize("line", [BENT, CROSS, RUNG, Point(0, 0).buffer(20).exterior])
@pytest.mark.parametrize("width", [6.05, 6.2, 6.8])
def test_channel_hardly_wider_than_the_cutter_is_cut_by_its_slot(line, width):
    channel = line.buffer(width / 2, join_style="mitre", cap_style="square")
    report = plan(make_request(channel, strategy=Strategy.EXTENDED_ARCHIMEDEAN)).report
    assert report.over_limit_share < 0.01
    assert report.uncut_area < SLIVERS * channel.area


def test_rooms_along_a_channel_are_opened_with_it():
    rooms = [Point(x, y).buffer(9.3) for y in (0, 24) for x in range(0, 81, 20)]
    ways = [box(0, y - 3.6, 80, y + 3.6) for y in (0, 24)] + [box(-3.6, 0, 3.6, 24)]
    _, layout = lay(shapely.union_all([*rooms, *ways]).buffer(0))
    visited = layout.opening.start.visited
    assert all(visited.distance(Point(x, y)) < 6.0 for y in (0, 24) for x in range(0, 81, 20))


def test_centers_that_cross_are_opened_all_at_once():
    pocket = CROSS.buffer(5, join_style="mitre", cap_style="square")
    _, layout = lay(pocket)
    tips = [Point(p) for p in ((2, 0), (58, 0), (30, -28), (30, 28))]
    assert all(layout.opening.start.visited.distance(tip) < 3.0 for tip in tips)


@pytest.mark.parametrize("width", [7.6, 8.8])
def test_bent_channel_without_room_for_laps_is_cut_by_its_slot(width):
    channel = BENT.buffer(width / 2, join_style="mitre", cap_style="square")
    path = plan(make_request(channel, strategy=Strategy.EXTENDED_ARCHIMEDEAN))
    # a center that left the middle would leave stock all along, a stroke across for each step
    assert path.report.over_limit_share < 0.01
    assert path.report.time < 30
