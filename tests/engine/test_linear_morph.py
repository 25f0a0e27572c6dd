# SPDX-License-Identifier: LGPL-2.1-or-later
"""Linear morph: what LM15 promises, and what a pocket needs."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, given, settings
from scipy.interpolate import BSpline
from shapely import LineString, Point, Polygon
from shapes import (
    CIRCLE,
    DUMBBELL,
    L_SHAPE,
    PENTAGON,
    RING,
    SQUARE,
    TEE,
    TRIANGLE,
    convex_pockets,
    crossed_bars,
    no_tick,
)
from shapes import request as make_request

from freecad_spiralpocket.engine.errors import CutterDoesNotFitError, NotYetError
from freecad_spiralpocket.engine.floor import Slot
from freecad_spiralpocket.engine.laps import linear_morph
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.shapes.splines import periodic_cubic, spiral_beziers

PAPER = [pytest.param(p, id=n) for n, p in zip("345", (TRIANGLE, SQUARE, PENTAGON), strict=True)]

BRANCHED = [pytest.param(p, id=n) for n, p in (("L", L_SHAPE), ("neck", DUMBBELL), ("T", TEE))]

#: Branches meet in a room so wide that a slot about them leaves a post.
TAILS = shapely.union_all(
    [Polygon([(0, 0), (168, 0), (168, 36), (0, 36)])]
    + [
        Polygon([(x - 7.5, 35), (x + 7.5, 35), (x + 13.2, 62), (x - 13.2, 62)])
        for x in (19.2, 50.4, 81.6, 112.8, 144.0)
    ]
)


def spiral_of(pocket: Polygon, **changes):
    request = make_request(pocket, **changes)
    region = center_regions(pocket, 3.0, 0.0)[0]
    return region, linear_morph.floor_path(region, request, no_tick)


def closed_spline(breaks: np.ndarray, controls: np.ndarray) -> BSpline:
    knots = np.concatenate([breaks[-4:-1] - 1, breaks, breaks[1:4] + 1])
    return BSpline(knots, controls[np.arange(len(controls) + 3) % len(controls)], 3)


@pytest.mark.parametrize("pocket", [*PAPER, *BRANCHED])
def test_spiral_is_equation_3_exactly(pocket):
    region, path = spiral_of(pocket)
    morph = linear_morph.morph_of(region, make_request(pocket))
    turns, _ = spiral_beziers(morph.breaks, morph.inner, morph.outer, 2.4)
    u = np.linspace(0, 1, 10_000)[:-1]
    d_in, d_out = (closed_spline(morph.breaks, c) for c in (morph.inner, morph.outer))
    lap = (u * turns) % 1.0
    expected = (1 - u)[:, None] * d_in(lap) + u[:, None] * d_out(lap)
    curve = path.curve
    spiral = BSpline(curve.knots, curve.control_points, curve.degree)(u)
    assert np.abs(spiral - expected).max() < 1e-9


@pytest.mark.parametrize("pocket", [*PAPER, *BRANCHED])
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


@settings(max_examples=20, deadline=None, suppress_health_check=list(HealthCheck))
@given(crossed_bars())
def test_any_branched_pocket_is_cleared_by_nested_laps_or_refused_with_a_place(pocket):
    region = center_regions(pocket, 3.0, 0.0)[0]
    try:
        path = linear_morph.floor_path(region, make_request(pocket), no_tick)
    except NotYetError as error:
        refused_at = error.place
    else:
        refused_at = None
    if refused_at is not None:
        assert region.distance(Point(refused_at)) < 0.1
        return
    spiral, lap = (LineString(part.points) for part in path.passes[:2])
    assert region.buffer(1e-6).covers(spiral)
    assert spiral.is_simple
    cleared = shapely.union_all([g.buffer(3.0) for g in (*_opened(path), spiral, lap)])
    assert region.buffer(2.99).difference(cleared).area < 0.05


def _opened(path) -> list:
    """Return what the entry follows."""
    if isinstance(path.entry, Slot):
        return [LineString(np.vstack([path.entry.ring, path.entry.ring[:1]]))]
    return [Point(path.entry.center).buffer(path.entry.radius)]


def test_islands_are_refused_with_a_reason():
    with pytest.raises(NotYetError, match=r"cannot go round islands.*X30.0 Y30.0") as caught:
        spiral_of(RING)
    assert caught.value.hint


@pytest.mark.parametrize("pocket", [*BRANCHED, pytest.param(TAILS, id="tails")])
def test_slender_inner_curve_is_opened_as_a_slot_along_the_axis(pocket):
    region, path = spiral_of(pocket)
    assert isinstance(path.entry, Slot)
    assert path.entry.bite < 2.0
    ring = Polygon(path.entry.ring)
    assert region.contains(ring)
    # the spiral goes on where the slot ends, and the slot leaves no post
    np.testing.assert_allclose(path.passes[0].points[0], path.entry.ring[0], atol=1e-9)
    assert ring.difference(ring.exterior.buffer(3.0)).area < 1e-3


def test_laps_that_would_cross_themselves_are_found_at_their_place():
    angles = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    circle = np.column_stack([np.cos(angles), np.sin(angles)])
    breaks, outer = periodic_cubic(20 * circle)
    assert linear_morph.fold(breaks, 3 * circle, outer) is None
    folded = outer.copy()
    folded[5:8] = folded[5:8][::-1]  # the wall runs back a little there
    place = linear_morph.fold(breaks, 3 * circle, folded)
    assert np.hypot(*(place - outer[6])) < 5.0 or np.hypot(*(place - 3 * circle[6])) < 5.0


def test_pocket_whose_laps_would_cross_themselves_is_refused(monkeypatch):
    monkeypatch.setattr(linear_morph, "fold", lambda *curves: np.array([11.0, 22.0]))
    with pytest.raises(NotYetError, match=r"cross themselves at X11.0 Y22.0"):
        spiral_of(L_SHAPE)


def test_spline_through_a_wall_keeps_its_points():
    points = np.array(SQUARE.exterior.coords)[:-1:3]
    breaks, controls = periodic_cubic(points)
    np.testing.assert_allclose(closed_spline(breaks, controls)(breaks[:-1]), points, atol=1e-9)
