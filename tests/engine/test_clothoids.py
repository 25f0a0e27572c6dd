# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clothoids: their curvature is what they say, and they meet what they join."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import fresnel
from shapely import LineString

from freecad_spiralpocket.engine.middle_line.clothoids import (
    begin,
    half_corner,
    tangent_share,
    through,
)


def end_of(path) -> np.ndarray:
    return path.points_at(np.array([path.length]))[0]


def curvature_by_differences(path, s: np.ndarray, step: float = 1e-3) -> np.ndarray:
    """Return the curvature that three neighboring points show."""
    a, b, c = (path.points_at(s + d) for d in (-step, 0.0, step))
    u, v, w = b - a, c - b, c - a
    area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    return 2 * area / (np.hypot(*u.T) * np.hypot(*v.T) * np.hypot(*w.T))


def test_single_clothoid_is_fresnels_integral():
    # unit speed with curvature pi s: x = C(s), y = S(s)
    path = begin(np.zeros(2), 0.0).then(2.0, 2.0 * math.pi)
    s = np.linspace(0.0, 2.0, 50)
    sines, cosines = fresnel(s)
    np.testing.assert_allclose(path.points_at(s), np.column_stack([cosines, sines]), atol=1e-12)


def test_constant_curvature_is_a_circle():
    path = begin(np.array([3.0, 1.0]), 0.0, 0.5).then(4 * math.pi, 0.5)
    points = path.points_at(np.linspace(0, path.length, 40))
    np.testing.assert_allclose(np.hypot(*(points - [3.0, 3.0]).T), 2.0, atol=1e-12)
    np.testing.assert_allclose(points[-1], [3.0, 1.0], atol=1e-12)


@settings(max_examples=50, deadline=None)
@given(st.floats(-2.6, 2.6), st.floats(0.2, 5.0))
def test_bi_clothoid_turns_a_corner_from_ray_to_ray(turn, tangent):
    before, after = 6.0, 7.0
    corner = np.array([before, 0.0])
    ahead = np.array([math.cos(turn), math.sin(turn)])
    polyline = np.vstack([np.zeros(2), corner, corner + after * ahead])
    path = through(begin(np.zeros(2), 0.0), polyline, [tangent])
    np.testing.assert_allclose(end_of(path), polyline[-1], atol=1e-9)
    assert path.heading_at(np.array([path.length]))[0] == pytest.approx(turn, abs=1e-9)
    assert path.curvature_at(np.array([0.0, path.length])).tolist() == [0.0, 0.0]


@settings(max_examples=25, deadline=None)
@given(
    st.lists(
        st.tuples(st.floats(0.3, 4.0), st.floats(-1.0, 1.0)),
        min_size=1,
        max_size=5,
    )
)
def test_points_have_the_curvature_that_is_asked(pieces):
    path = begin(np.array([5.0, -2.0]), 0.7, 0.3)
    for length, curvature in pieces:
        path = path.then(length, curvature)
    inner = np.concatenate([np.linspace(a + 0.01, b - 0.01, 9) for a, b in pairwise(path.joints)])
    np.testing.assert_allclose(
        curvature_by_differences(path, inner), path.curvature_at(inner), atol=1e-5
    )


def test_a_path_run_backwards_goes_the_same_way():
    there = begin(np.zeros(2), 0.2, 0.4).then(2.0, -0.3).then(1.0, 0.0)
    back = begin(end_of(there), there.heading_at(np.array([3.0]))[0] + math.pi, 0.0)
    back = back.then(1.0, 0.3).then(2.0, -0.4)
    np.testing.assert_allclose(end_of(back), [0.0, 0.0], atol=1e-12)
    # forth and then back is the whole way there
    stub = begin(there.start, there.heading, 0.4)
    again = stub.then_back(back)
    np.testing.assert_allclose(again.lengths, there.lengths)
    np.testing.assert_allclose(again.curvatures, there.curvatures)


@pytest.mark.parametrize("tolerance", [0.05, 0.005])
def test_chords_keep_within_the_tolerance(tolerance):
    path = begin(np.zeros(2), 0.0).then(5.0, 1.5).then(5.0, -0.5)
    chords = path.sampled(tolerance)
    fine = path.points_at(np.linspace(0, path.length, 5000))
    assert shapely.distance(shapely.points(fine), LineString(chords)).max() <= 1.05 * tolerance


def test_half_a_corner_ends_in_the_middle_of_the_turn():
    turn = np.array([0.5, 1.5])
    x, y = half_corner(turn, np.array([1.0]))
    # by symmetry the middle lies on the corner's bisector
    share = tangent_share(turn)
    np.testing.assert_allclose(y[:, 0], (share - x[:, 0]) / np.tan(turn / 2), atol=1e-12)
