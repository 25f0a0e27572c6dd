# SPDX-License-Identifier: LGPL-2.1-or-later
"""The papers' measures on paths whose values are known."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pytest

from freecad_spiralpocket.engine.machine import Machine
from freecad_spiralpocket.engine.motion.analysis import (
    absolute_curvature,
    feed_direction,
    sample_times,
    time_ratio,
    weighted_quantiles,
)
from freecad_spiralpocket.engine.motion.timing import time_of
from freecad_spiralpocket.engine.toolpath import Role, Toolpath, ToolpathBuilder

FEED = 50.0
MACHINE = Machine("test", (1000.0,) * 3, (1000.0,) * 3)


def polyline(points) -> Toolpath:
    """Return a path of lines in the plane."""
    builder = ToolpathBuilder((*points[0], 0.0))
    for point in points[1:]:
        builder.line((*point, 0.0), FEED, Role.CUT)
    return builder.build()


def archimedean(turns: float, pitch: float, n: int) -> np.ndarray:
    """Return points on a spiral, (n, 2)."""
    angle = np.linspace(2 * np.pi, 2 * np.pi * (turns + 1), n)
    radius = pitch * angle / (2 * np.pi)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])


def test_feed_direction_of_a_spiral_grows_by_two_pi_each_turn():
    stations, directions = feed_direction(polyline(archimedean(5, 2.0, 4000)))
    assert np.all(np.diff(directions) > -1e-9)
    assert directions[-1] - directions[0] == pytest.approx(5 * 2 * np.pi, abs=0.2)
    assert stations[0] == 0.0
    assert np.all(np.diff(stations) >= 0)


def test_feed_direction_counts_half_turn_arcs_the_way_they_go():
    builder = ToolpathBuilder((10, 0, 0))
    for x in (-10, 10, -10):
        builder.arc((x, 0, 0), (0, 0), False, FEED, Role.CUT)
    _, directions = feed_direction(builder.build())
    assert directions[-1] - directions[0] == pytest.approx(-3 * np.pi)


def test_feed_direction_of_a_zigzag_has_steps():
    path = polyline([(0, 0), (10, 0), (10, 2), (0, 2)])
    stations, directions = feed_direction(path, by_turns=False)
    np.testing.assert_allclose(stations, [0, 10, 10, 12, 12, 22])
    np.testing.assert_allclose(directions, np.repeat([0, np.pi / 2, np.pi], 2))


def test_moves_straight_down_have_no_direction():
    builder = ToolpathBuilder((0, 0, 0))
    builder.line((0, 0, -5), FEED, Role.ENTRY)
    builder.line((8, 0, -5), FEED, Role.CUT)
    stations, directions = feed_direction(builder.build())
    np.testing.assert_allclose(stations, [5, 13])
    np.testing.assert_allclose(directions, 0)


def test_time_ratio_is_one_at_constant_speed_and_falls_with_corners():
    straight = polyline([(0, 0), (1000, 0)])
    zigzag = polyline([(x, y) for x in range(50) for y in ((0, 4) if x % 2 else (4, 0))])
    assert time_ratio(straight, time_of(straight, MACHINE)) == pytest.approx(1.0, abs=0.01)
    assert time_ratio(zigzag, time_of(zigzag, MACHINE)) < 0.8


def test_time_ratio_leaves_rapids_out():
    builder = ToolpathBuilder((0, 0, 5))
    builder.rapid(10.0, x=500.0)
    builder.line((500, 100, 5), FEED, Role.CUT)
    path = builder.build()
    assert 0.9 < time_ratio(path, time_of(path, MACHINE)) <= 1.0


def test_curvature_of_chords_and_arcs_is_that_of_the_circle():
    angle = np.linspace(0, 2 * np.pi, 400)
    chords = polyline(np.column_stack([8 * np.cos(angle), 8 * np.sin(angle)]))
    curvature, lengths = absolute_curvature(chords)
    np.testing.assert_allclose(curvature, 1 / 8, rtol=1e-9)
    assert lengths.sum() == pytest.approx(16 * np.pi, rel=0.01)
    builder = ToolpathBuilder((8, 0, 0))
    builder.arc((-8, 0, 0), (0, 0), True, FEED, Role.CUT)
    curvature, lengths = absolute_curvature(builder.build())
    assert (curvature[0], lengths[0]) == pytest.approx((1 / 8, 8 * np.pi))


def test_curvature_of_a_spiral_converges_to_the_analytic_one():
    pitch = 2.0
    errors = []
    for n in (500, 1000, 2000):
        points = archimedean(3, pitch, n)
        curvature, _ = absolute_curvature(polyline(points))
        radius, a = np.hypot(*points[1:-1].T), pitch / (2 * np.pi)
        exact = (radius**2 + 2 * a**2) / (radius**2 + a**2) ** 1.5
        errors.append(np.abs(curvature / exact - 1).max())
    assert errors[1] < errors[0] / 3.5
    assert errors[2] < errors[1] / 3.5


def test_quantiles_go_by_length():
    cut = weighted_quantiles(
        np.array([0.1, 1.0, 0.5]), np.array([94.0, 2.0, 4.0]), [0.9, 0.95, 0.99]
    )
    np.testing.assert_allclose(cut, [0.1, 0.5, 1.0])


def test_sample_times_add_up_to_the_time_of_the_path():
    class Samples(NamedTuple):
        points: np.ndarray
        angles: np.ndarray
        lengths: np.ndarray
        moves: np.ndarray

    path = polyline([(0, 0), (40, 0), (40, 30)])
    motion = time_of(path, MACHINE)
    x = np.arange(0.25, 40, 0.5)
    points = np.column_stack([x, 0 * x, 0 * x])
    moves = np.zeros(len(x), int)
    samples = Samples(points, 0 * x, np.full(len(x), 0.5), moves)
    times = sample_times(path, samples, motion)
    assert times.sum() == pytest.approx(motion.times[0])
    # starting from rest takes longer than cruising
    assert times[0] == pytest.approx(math.sqrt(2 * 0.5 / 1000.0))
    assert times[20] == pytest.approx(0.5 / FEED)
