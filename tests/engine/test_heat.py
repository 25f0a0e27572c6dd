# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heat and its isotherms: the field against closed forms, the refit, turns and kinks."""

from __future__ import annotations

import math

import numpy as np
import pytest
from heated import turning
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline
from shapely import LineString, Point, Polygon

from freecad_spiralpocket.engine.heat.hermite_quartic import ClosedFit, ClosedQuartic
from freecad_spiralpocket.engine.heat.isotherms import mover
from freecad_spiralpocket.engine.heat.kinks import softened
from freecad_spiralpocket.engine.heat.poisson import solve
from freecad_spiralpocket.engine.heat.turns import EASE, Ring, match, rise, turn


def ring_temperature(r: np.ndarray, inner: float, outer: float) -> np.ndarray:
    """Return the closed form in an annulus."""
    free = (outer**2 - r**2) / 4
    return free + (inner**2 - outer**2) / 4 * np.log(r / outer) / np.log(inner / outer)


def errors(region: Polygon, center, exact, spacings) -> list[float]:
    found = []
    for spacing in spacings:
        field = solve(region, spacing)
        x, y = np.meshgrid(*field.xy)
        r = np.hypot(x - center[0], y - center[1])
        found.append(float(np.abs(field.values - exact(r))[field.inside].max()))
    return found


def test_field_in_a_disc_is_exact():
    disc = Point(0.3, 0.2).buffer(10, quad_segs=2000)
    assert errors(disc, (0.3, 0.2), lambda r: (100 - r**2) / 4, [0.7])[0] < 1e-4


def test_field_in_an_annulus_converges_with_second_order():
    center = (0.3, 0.2)
    annulus = Point(center).buffer(10, quad_segs=2000)
    annulus = annulus.difference(Point(center).buffer(3, quad_segs=2000))
    coarse, middle, fine = errors(
        annulus, center, lambda r: ring_temperature(r, 3, 10), [0.5, 0.25, 0.125]
    )
    assert coarse / middle > 3.4
    assert middle / fine > 3.4
    assert fine < 1e-3


def test_points_move_along_gradient_lines_to_the_isotherm_asked_for():
    disc = Point(0, 0).buffer(20, quad_segs=500)
    field = solve(disc, 0.4)
    angles = np.linspace(0, 2 * np.pi, 40)
    spokes = np.column_stack([np.cos(angles), np.sin(angles)])
    moved = mover(field)(18 * spokes, (400 - 18**2) / 4, (400 - 15**2) / 4)
    np.testing.assert_allclose(moved, 15 * spokes, atol=0.02)


def wavy(phase: float, waves: int, depth: float) -> np.ndarray:
    t = np.linspace(0, 2 * np.pi, 600, endpoint=False)
    r = 1 + depth * np.cos(waves * t + phase)
    return np.column_stack([40 * r * np.cos(t), 25 * r * np.sin(t)])


@settings(max_examples=20, deadline=None)
@given(st.floats(0, 6.28), st.integers(2, 5), st.floats(0, 0.25), st.sampled_from([0.5, 0.1, 0.02]))
def test_refitted_curve_keeps_the_bound_and_is_c2_all_round(phase, waves, depth, deviation):
    points = wavy(phase, waves, depth)
    curve = ClosedFit(points).within(deviation)
    ring = LineString(curve.sample(0.05))
    assert max(ring.distance(Point(p)) for p in points[::7]) <= 1.01 * deviation + 1e-4
    spline, breaks, eps = spline_of(curve), curve.breaks[:-1], 1e-8
    for order in (0, 1, 2):
        before, after = spline(breaks - eps, order), spline(breaks + eps, order)
        assert np.abs(after - before).max() < 1e-4 * (1 + np.abs(after).max())


def spline_of(curve: ClosedQuartic) -> BSpline:
    """Return a curve as scipy's B-spline: periodic, each knot twice."""
    ends = np.concatenate([curve.breaks[-3:-1] - 1.0, curve.breaks, curve.breaks[1:3] + 1.0])
    knots = np.repeat(ends, 2)
    index = np.arange(len(knots) - 5) % len(curve.controls)
    return BSpline(knots, curve.controls[index], 4, extrapolate="periodic")


def hermite_form(curve: ClosedQuartic) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return points and tangents at the breaks, and the bulge w of each patch.

    On a patch, with u from 0 to 1 and tangents times its span, the curve is the cubic Hermite
    curve plus ``u^2 (1 - u)^2 w``.
    """
    spline, spans = spline_of(curve), np.diff(curve.breaks)[:, None]
    points, tangents = spline(curve.breaks), spline(curve.breaks, 1)
    middle = spline((curve.breaks[:-1] + curve.breaks[1:]) / 2)
    cubic = (points[:-1] + points[1:]) / 2 + spans * (tangents[:-1] - tangents[1:]) / 8
    return points, tangents, 16.0 * (middle - cubic)


def test_patches_are_those_of_the_paper():
    curve = ClosedFit(wavy(0.4, 3, 0.2)).within(0.1)
    points, tangents, bulges = hermite_form(curve)
    u = np.linspace(0, 1, 9)[:, None]
    for i, span in enumerate(np.diff(curve.breaks)):
        p0, p1 = points[i], points[i + 1]
        t0, t1 = span * tangents[i], span * tangents[i + 1]
        # alpha and beta of HQS24 eq. 6, from w = alpha (P0 - P1) + beta (T0 - T1)
        alpha, beta = np.linalg.solve(np.column_stack([p0 - p1, t0 - t1]), bulges[i])
        a0 = 1 + (alpha - 3) * u**2 + 2 * (1 - alpha) * u**3 + alpha * u**4
        b0 = u + (beta - 2) * u**2 + (1 - 2 * beta) * u**3 + beta * u**4
        b1 = -(beta + 1) * u**2 + (2 * beta + 1) * u**3 - beta * u**4
        paper = a0 * p0 + (1 - a0) * p1 + b0 * t0 + b1 * t1
        ours = spline_of(curve)(curve.breaks[i] + span * u[:, 0])
        np.testing.assert_allclose(paper, ours, atol=1e-8)


def test_fewer_patches_for_a_wider_bound():
    counts = [len(ClosedFit(wavy(0, 4, 0.2)).within(d).breaks) for d in (1.0, 0.3, 0.1, 0.03)]
    assert counts == sorted(counts)
    assert counts[0] < 20


def test_turns_join_with_equal_tangent_and_curvature():
    u = np.array([0.0, 1.0])
    h = 1e-4
    assert (rise(u) == u).all()
    np.testing.assert_allclose([rise(np.array(h)), 1 - rise(np.array(1 - h))], 0, atol=h**2)
    np.testing.assert_allclose(
        rise(u * (1 - 2 * EASE) + EASE), [EASE / 2 / (1 - EASE)] * 1 + [1 - EASE / 2 / (1 - EASE)]
    )


def test_turn_between_circles_is_one_even_turn_of_a_spiral():
    angles = np.linspace(0, 2 * np.pi, 400)
    spokes = np.column_stack([np.cos(angles), np.sin(angles)])
    inner, outer = Ring.of(10 * spokes), Ring.of(12 * spokes)
    places = np.arange(100) * outer.length / 100
    matched = match(inner, outer, places, outer.at(places) * 10 / 12)
    points, _ = turn(inner, outer, matched, 3.0, 0.25)
    radii = np.hypot(*points.T)
    assert radii[0] == pytest.approx(10, abs=1e-2)
    assert radii[-1] == pytest.approx(12, abs=1e-2)
    assert (np.diff(radii) > -1e-3).all()
    np.testing.assert_allclose(points[0] / radii[0], points[-1] / radii[-1], atol=1e-2)


def test_partners_of_a_slim_ring_are_on_its_own_leg():
    line = LineString([(0, 0), (20, 0), (20, 15)])
    inner, outer = (Ring.of(np.array(line.buffer(off).exterior.coords)[::-1]) for off in (0.1, 1.0))
    places = np.linspace(0.0, outer.length, 200, endpoint=False)
    points, ahead = outer.at(places), outer.ahead(places)
    # what leads to the ring leads a little too far now and then
    far = np.where(np.arange(200) % 7 == 3, 1.2, 0.9)
    matched = match(inner, outer, places, points + far[:, None] * ahead @ [[0, 1], [-1, 0]])
    off = inner.at(matched.inner) - outer.at(matched.outer)
    assert np.hypot(*off.T).max() < 1.5


def test_field_about_a_hot_disc_is_exact():
    center, inner, outer, heat = (0.3, 0.2), 3.0, 10.0, 40.0
    disc, hot = (Point(center).buffer(r, quad_segs=2000) for r in (outer, inner))
    field = solve(disc, 0.125, hot, heat)
    x, y = np.meshgrid(*field.xy)
    r = np.hypot(x - center[0], y - center[1])
    exact = ring_temperature(r, inner, outer) + heat * np.log(r / outer) / np.log(inner / outer)
    assert np.abs(field.values - exact)[field.inside].max() < 1e-2


@settings(max_examples=30, deadline=None)
@given(st.floats(20, 170), st.floats(0.02, 1.0))
def test_a_kink_is_spread_and_no_point_moved_too_far(corner, most):
    s = np.arange(0, 12, 0.2)[:, None]
    ahead = np.array([math.cos(math.radians(corner)), math.sin(math.radians(corner))])
    path = np.vstack([np.array([-12, 0]) + s * [1, 0], s * ahead, [12 * ahead]])
    soft = softened(path, 3.0, most)
    np.testing.assert_array_equal(soft[[0, -1]], path[[0, -1]])
    line = LineString(path)
    assert max(line.distance(Point(p)) for p in soft) <= most
    if most > 0.6:  # room enough for the widest
        assert turning(soft).max() < corner / 2


def test_a_path_without_kinks_stays_as_it_is():
    angles = np.linspace(0, 6, 400)
    arc = 5 * np.column_stack([np.cos(angles), np.sin(angles)])
    np.testing.assert_array_equal(softened(arc, 3.0, 0.3), arc)
