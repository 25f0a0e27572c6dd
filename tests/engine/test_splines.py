# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines against scipy's evaluation and closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import BSpline

from freecad_spiralpocket.engine.shapes.splines import (
    join_c2,
    multiply_linear,
    periodic_beziers,
    periodic_cubic,
    sample_beziers,
)

RNG = np.random.default_rng(7)


def closed_points(n: int = 12) -> np.ndarray:
    angles = np.sort(RNG.uniform(0, 2 * np.pi, n))
    radii = RNG.uniform(15, 25, n)
    return np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])


def bernstein(beziers: np.ndarray, piece: int, t: np.ndarray) -> np.ndarray:
    from math import comb

    d = beziers.shape[1] - 1
    basis = np.stack([comb(d, k) * t**k * (1 - t) ** (d - k) for k in range(d + 1)], axis=1)
    return basis @ beziers[piece]


def test_periodic_cubic_interpolates_and_closes_with_c2():
    points = closed_points()
    breaks, controls = periodic_cubic(points)
    beziers = periodic_beziers(breaks, controls)
    np.testing.assert_allclose(beziers[:, 0], points, atol=1e-9)
    h = np.diff(breaks)[:, None]
    first_out = 3 * (beziers[:, 3] - beziers[:, 2]) / h
    first_in = 3 * (beziers[:, 1] - beziers[:, 0]) / h
    second_out = 6 * (beziers[:, 3] - 2 * beziers[:, 2] + beziers[:, 1]) / h**2
    second_in = 6 * (beziers[:, 2] - 2 * beziers[:, 1] + beziers[:, 0]) / h**2
    np.testing.assert_allclose(beziers[:, 3], np.roll(points, -1, axis=0), atol=1e-9)
    np.testing.assert_allclose(first_out, np.roll(first_in, -1, axis=0), rtol=1e-7, atol=1e-5)
    np.testing.assert_allclose(second_out, np.roll(second_in, -1, axis=0), rtol=1e-6, atol=1e-3)


def test_multiply_linear_is_the_pointwise_product():
    beziers = RNG.normal(size=(3, 4, 2))
    start, end = RNG.normal(size=3), RNG.normal(size=3)
    product = multiply_linear(beziers, start, end)
    t = np.linspace(0, 1, 7)
    for i in range(3):
        factor = (start[i] + (end[i] - start[i]) * t)[:, None]
        np.testing.assert_allclose(
            bernstein(product, i, t), factor * bernstein(beziers, i, t), atol=1e-12
        )


def test_join_c2_keeps_the_curve_with_double_knots():
    breaks, controls = periodic_cubic(closed_points())
    cubic = periodic_beziers(breaks, controls)
    quartic = multiply_linear(cubic, 1 - breaks[:-1] / 2, 1 - breaks[1:] / 2)
    curve = join_c2(quartic, breaks)
    assert len(curve.knots) == len(curve.control_points) + curve.degree + 1
    spline = BSpline(curve.knots, curve.control_points, curve.degree)
    t = np.linspace(0, 1, 20)
    for i in range(len(quartic)):
        u = breaks[i] + t * (breaks[i + 1] - breaks[i])
        np.testing.assert_allclose(spline(u), bernstein(quartic, i, t), atol=1e-10)


@pytest.mark.parametrize("tolerance", [0.1, 0.01, 0.001])
def test_sampling_keeps_within_the_tolerance(tolerance):
    from shapely import LineString, Point

    breaks, controls = periodic_cubic(closed_points())
    beziers = periodic_beziers(breaks, controls)
    line = LineString(sample_beziers(beziers, tolerance))
    t = np.linspace(0, 1, 50)
    worst = max(
        line.distance(Point(p)) for i in range(len(beziers)) for p in bernstein(beziers, i, t)
    )
    assert worst <= tolerance
