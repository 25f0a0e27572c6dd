# SPDX-License-Identifier: LGPL-2.1-or-later
"""Central spiral: circles, then rays to the wall, as CS08 has them."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, given, settings
from shapely import LineString, Point, box
from shapes import CIRCLE, DUMBBELL, PENTAGON, RING, SQUARE, convex_pockets, no_tick
from shapes import request as make_request

from freecad_spiralpocket.engine.errors import CutterDoesNotFitError, NotYetError
from freecad_spiralpocket.engine.laps import central
from freecad_spiralpocket.engine.machine import Machine
from freecad_spiralpocket.engine.model import Cutting, Strategy
from freecad_spiralpocket.engine.motion.timing import polyline_seconds
from freecad_spiralpocket.engine.planner import plan
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.shapes.starshape import deepest_center
from freecad_spiralpocket.engine.toolpath import Role

STEP = 2.4


def path_of(pocket, ratio=None, **changes):
    region = center_regions(pocket, 3.0, 0.0)[0]
    return region, central.floor_path(region, make_request(pocket, **changes), no_tick, ratio)


def polar(points: np.ndarray, center: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    rays = points - center
    angles = np.unwrap(np.arctan2(rays[:, 1], rays[:, 0]))
    return angles, np.hypot(rays[:, 0], rays[:, 1])


@pytest.mark.parametrize("ratio", [0.3, 0.55, 0.7])
def test_spiral_is_archimedean_until_at_most_c_times_the_width(ratio):
    region, path = path_of(SQUARE, ratio)
    center = deepest_center(region)
    angles, radii = polar(path.passes[0].points, center)
    room = region.boundary.distance(Point(center))
    slopes = np.diff(radii) / np.diff(angles)
    even = np.abs(slopes - STEP / (2 * np.pi)) < 1e-6
    end = int(np.argmin(even))
    # the circles end on the x-axis, as near to C as whole turns to the wall allow
    assert abs(np.sin(angles[end])) < 1e-6
    assert ratio * room - 1.5 * STEP < radii[end] <= ratio * room + 1e-6


@pytest.mark.parametrize("pocket", [SQUARE, PENTAGON, CIRCLE])
def test_no_ray_is_divided_coarser_than_a_square_corner_of_contour_parallel_laps(pocket):
    region, path = path_of(pocket)
    center = deepest_center(region)
    angles, radii = polar(path.passes[0].points, center)
    assert (np.diff(angles) > -1e-6).all()
    turns = np.interp(angles[angles > angles[0] + 2 * np.pi] - 2 * np.pi, angles, radii)
    thickness = radii[angles > angles[0] + 2 * np.pi] - turns
    assert thickness.min() > 0
    assert thickness.max() < 1.02 * central.THICKEST * STEP


def test_corners_are_rounded_and_left_to_the_closing_lap():
    region, path = path_of(SQUARE)
    corner = np.array(region.bounds[2:])
    spiral, lap = path.passes[0].points, path.passes[1].points
    left = np.hypot(*(spiral - corner).T).min()
    assert 0.2 * STEP < left < 2.0 * STEP
    wall = shapely.points(shapely.get_coordinates(shapely.segmentize(region.boundary, 0.1)))
    assert shapely.distance(wall, LineString(lap)).max() < 0.01
    blunt = path_of(SQUARE, cutting=Cutting(STEP, finishing_lap=False))[1].passes[1].points
    assert np.hypot(*(blunt - corner).T).min() > 0.2 * STEP


def test_c_takes_no_longer_than_other_shares():
    slow = Machine("slow", (100.0,) * 3, (300.0,) * 3)
    _, path = path_of(PENTAGON, machine=slow)

    def seconds(points):
        return float(polyline_seconds(np.column_stack([points, 0 * points[:, 0]]), 50.0, slow))

    least = seconds(path.passes[0].points)
    for ratio in (0.3, 0.5, 0.8):
        other = path_of(PENTAGON, ratio, machine=slow)[1]
        assert least <= 1.01 * seconds(other.passes[0].points)


@pytest.mark.parametrize("pocket", [CIRCLE, SQUARE, box(0, 0, 80, 30)])
def test_everything_is_cleared_and_nothing_gouged(pocket):
    report = plan(make_request(pocket, strategy=Strategy.CENTRAL_SPIRAL)).report
    assert report.uncut_area < 1e-3
    assert report.gouge < 0.01
    assert report.link_hit == report.rapid_hit == 0.0


def test_the_report_tells_where_the_engagement_passes_the_limit():
    report = plan(make_request(SQUARE, strategy=Strategy.CENTRAL_SPIRAL)).report
    assert report.over_limit_share > 0
    assert any("the engagement reaches" in n.message for n in report.notices)


@settings(max_examples=25, deadline=None, suppress_health_check=list(HealthCheck))
@given(convex_pockets())
def test_any_convex_pocket_gets_a_spiral_inside_its_region(pocket):
    regions = center_regions(pocket, 3.0, 0.0)
    try:
        path = central.floor_path(regions[0], make_request(pocket), no_tick)
    except CutterDoesNotFitError:
        assert regions[0].buffer(-0.2).is_empty
        return
    assert [p.role for p in path.passes][:2] == [Role.CUT, Role.FINISH]
    assert regions[0].buffer(1e-6).covers(LineString(path.passes[0].points))
    assert LineString(path.passes[0].points).is_simple


@pytest.mark.parametrize(
    ("pocket", "said"),
    [(RING, "cannot go round islands.*X30.0 Y30.0"), (DUMBBELL, "whole wall can be seen")],
)
def test_pockets_beyond_it_are_refused_with_a_reason(pocket, said):
    with pytest.raises(NotYetError, match=said) as caught:
        path_of(pocket)
    assert caught.value.place is not None
    assert caught.value.hint
