# SPDX-License-Identifier: LGPL-2.1-or-later
"""Linear morph: what LM15 promises, and what a pocket needs."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from scipy.interpolate import BSpline
from shapely import LineString, Polygon
from shapes import CIRCLE, DUMBBELL, L_SHAPE, PENTAGON, RING, SQUARE, TRIANGLE, convex_pockets
from shapes import request as make_request

from freecad_spiralpocket.engine.errors import CutterDoesNotFitError, NotYetError
from freecad_spiralpocket.engine.laps import linear_morph
from freecad_spiralpocket.engine.region import center_regions
from freecad_spiralpocket.engine.splines import periodic_cubic

PAPER = [pytest.param(p, id=n) for n, p in zip("345", (TRIANGLE, SQUARE, PENTAGON), strict=True)]


def no_tick(done: float) -> None:
    """Never cancel."""


def spiral_of(pocket: Polygon, **changes):
    request = make_request(pocket, **changes)
    region = center_regions(pocket, 3.0, 0.0)[0]
    return region, linear_morph.floor_path(region, request, no_tick)


def closed_spline(breaks: np.ndarray, controls: np.ndarray) -> BSpline:
    knots = np.concatenate([breaks[-4:-1] - 1, breaks, breaks[1:4] + 1])
    return BSpline(knots, controls[np.arange(len(controls) + 3) % len(controls)], 3)


@pytest.mark.parametrize("pocket", PAPER)
def test_spiral_is_equation_3_exactly(pocket):
    region = center_regions(pocket, 3.0, 0.0)[0]
    center = np.array(region.centroid.coords[0])
    breaks, outer = linear_morph.wall_spline(region, center, 2.4)
    rays = outer - center
    inner = center + 2.8 * rays / np.linalg.norm(rays, axis=1)[:, None]
    turns, beziers = linear_morph.spiral_beziers(breaks, inner, outer, 2.4)
    all_breaks = np.append(((np.arange(turns)[:, None] + breaks[:-1]) / turns).ravel(), 1.0)
    curve = linear_morph.join_c2(beziers, all_breaks)
    u = np.linspace(0, 1, 10_000)[:-1]
    d_in, d_out = closed_spline(breaks, inner), closed_spline(breaks, outer)
    lap = (u * turns) % 1.0
    expected = (1 - u)[:, None] * d_in(lap) + u[:, None] * d_out(lap)
    spiral = BSpline(curve.knots, curve.control_points, curve.degree)(u)
    assert np.abs(spiral - expected).max() < 1e-9


@pytest.mark.parametrize("pocket", PAPER)
def test_spiral_is_c2(pocket):
    _, path = spiral_of(pocket)
    curve = path.curve
    spline = BSpline(curve.knots, curve.control_points, curve.degree)
    interior = np.unique(curve.knots)[1:-1]
    step = np.diff(np.unique(curve.knots)).min() * 1e-6
    for order in (1, 2):
        derivative = spline.derivative(order)
        before, after = derivative(interior - step), derivative(interior + step)
        scale = np.abs(after).max()
        assert np.abs(after - before).max() < 1e-4 * scale


def test_circle_gives_the_archimedean_spiral():
    _, path = spiral_of(CIRCLE)
    center = np.array([10.0, 5.0])
    rays = path.passes[0].points - center
    radius = np.hypot(rays[:, 0], rays[:, 1])
    turned = np.concatenate(
        [[0.0], np.cumsum(np.mod(np.diff(np.arctan2(rays[:, 1], rays[:, 0])), 2 * np.pi))]
    )
    expected = radius[0] + (radius[-1] - radius[0]) * turned / turned[-1]
    assert np.abs(radius - expected).max() < 0.02
    step = (radius[-1] - radius[0]) / (turned[-1] / (2 * np.pi))
    assert step <= 2.4


@settings(max_examples=25, deadline=None, suppress_health_check=list(HealthCheck))
@given(convex_pockets())
def test_any_convex_pocket_gets_nested_laps_inside_its_region(pocket):
    regions = center_regions(pocket, 3.0, 0.0)
    try:
        path = linear_morph.floor_path(regions[0], make_request(pocket), no_tick)
    except CutterDoesNotFitError:
        assert regions[0].buffer(-0.2).is_empty
        return
    assert regions[0].buffer(1e-6).covers(LineString(path.passes[0].points))
    assert LineString(path.passes[0].points).is_simple
    assert regions[0].buffer(0.01).covers(LineString(path.passes[1].points))


@pytest.mark.parametrize(
    ("pocket", "said"),
    [(RING, "cannot go round islands.*X30.0 Y30.0"), (DUMBBELL, "whole wall can be seen")],
)
def test_pockets_beyond_it_are_refused_with_a_reason(pocket, said):
    with pytest.raises(NotYetError, match=said) as caught:
        spiral_of(pocket)
    assert caught.value.hint


def test_star_shaped_pocket_is_cut_from_where_its_wall_is_seen():
    region, path = spiral_of(L_SHAPE)
    assert region.covers(LineString(path.passes[0].points))


def test_spline_through_a_wall_keeps_its_points():
    points = np.array(SQUARE.exterior.coords)[:-1:3]
    breaks, controls = periodic_cubic(points)
    np.testing.assert_allclose(closed_spline(breaks, controls)(breaks[:-1]), points, atol=1e-9)
