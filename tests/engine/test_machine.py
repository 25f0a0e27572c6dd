# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine time: closed forms, published measurements, independent planners, invariants."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from jerk_oracle import fastest_time

from benchmarks.chatelain import residuals, root_mean_square
from freecad_spiralpocket import machines
from freecad_spiralpocket.engine.machine import CornerRule, Machine
from freecad_spiralpocket.engine.motion.timing import polyline_seconds, time_of
from freecad_spiralpocket.engine.toolpath import Role, Toolpath, ToolpathBuilder

ACCELERATION, JERK = 1000.0, 20000.0
#: Of times that are closed forms [relative].
EXACT = 1e-9
#: Of jerk-limited times, which come from repeated passes [relative].
SETTLED = 1e-3


def machine(acceleration: float = ACCELERATION, **changes) -> Machine:
    """Return a machine with equal axes."""
    values = {"speed": (1000.0,) * 3, "acceleration": (acceleration,) * 3} | changes
    return Machine("test", path_acceleration=acceleration, **values)


def jerky(acceleration: float = ACCELERATION, jerk: float = JERK, **changes) -> Machine:
    """Return a machine with jerk limits."""
    return machine(acceleration, jerk=(jerk,) * 3, **changes)


def straight(*lengths: float, feed: float) -> Toolpath:
    """Return moves along x."""
    builder = ToolpathBuilder((0, 0, 0))
    for x in np.cumsum(lengths):
        builder.line((x, 0, 0), feed, Role.CUT)
    return builder.build()


def circle(radius: float, feed: float) -> Toolpath:
    """Return a full circle."""
    builder = ToolpathBuilder((radius, 0, 0))
    builder.arc((-radius, 0, 0), (0, 0), True, feed, Role.CUT)
    builder.arc((radius, 0, 0), (0, 0), True, feed, Role.CUT)
    return builder.build()


def corner(angle: float, leg: float, feed: float) -> Toolpath:
    """Return two moves of length `leg` with a turn by `angle`."""
    builder = ToolpathBuilder((-leg, 0, 0))
    builder.line((0, 0, 0), feed, Role.CUT)
    builder.line((leg * math.cos(angle), leg * math.sin(angle), 0), feed, Role.CUT)
    return builder.build()


def chords_of_circle(radius: float, chord: float, turns: float = 1.0) -> np.ndarray:
    """Return points on a circle, (n, 3)."""
    angles = np.arange(0.0, turns * 2 * np.pi, chord / radius)
    return np.column_stack([radius * np.cos(angles), radius * np.sin(angles), 0 * angles])


# --- straight moves -----------------------------------------------------------------------


def test_long_move_is_a_trapezoid():
    length, feed = 100.0, 50.0
    time = time_of(straight(length, feed=feed), machine()).total
    assert time == pytest.approx(length / feed + feed / ACCELERATION, rel=EXACT)


def test_short_move_is_a_triangle():
    length = 1.0
    time = time_of(straight(length, feed=900.0), machine()).total
    assert time == pytest.approx(2 * math.sqrt(length / ACCELERATION), rel=EXACT)


def test_jerk_limited_move_reaches_full_acceleration():
    length, feed = 200.0, 100.0  # feed * jerk > acceleration^2
    time = time_of(straight(length, feed=feed), jerky()).total
    expected = length / feed + feed / ACCELERATION + ACCELERATION / JERK
    assert time == pytest.approx(expected, rel=SETTLED)


def test_jerk_limited_move_that_never_reaches_full_acceleration():
    length, feed = 200.0, 20.0
    time = time_of(straight(length, feed=feed), jerky()).total
    assert time == pytest.approx(length / feed + 2 * math.sqrt(feed / JERK), rel=SETTLED)


def test_shortest_jerk_limited_move_is_four_phases_of_jerk():
    length = 0.5
    time = time_of(straight(length, feed=900.0), jerky()).total
    assert time == pytest.approx(4 * (length / (2 * JERK)) ** (1 / 3), rel=SETTLED)


def test_start_overhead_counts_once():
    path = straight(10.0, 10.0, feed=20.0)
    difference = time_of(path, machine(start_overhead=0.5)).total - time_of(path, machine()).total
    assert difference == pytest.approx(0.5)


def test_rapids_run_at_the_rate_of_the_machine():
    builder = ToolpathBuilder((0, 0, 0))
    builder.rapid(1.0, x=300.0)
    limited = machine(speed=(200.0, 100.0, 50.0))
    time = time_of(builder.build(), limited).total
    assert time == pytest.approx(300.0 / 200.0 + 200.0 / ACCELERATION, rel=EXACT)


def test_slow_axis_limits_a_vertical_move():
    builder = ToolpathBuilder((0, 0, 10))
    builder.line((0, 0, 0), 900.0, Role.ENTRY)
    slow = Machine("slow z", (100.0, 100.0, 5.0), (1000.0, 1000.0, 10.0))
    assert time_of(builder.build(), slow).total == pytest.approx(10 / 5 + 5 / 10, rel=EXACT)


# --- bends --------------------------------------------------------------------------------


@pytest.mark.parametrize("radius", [2.0, 10.0])
def test_circle_runs_at_its_centripetal_speed(radius):
    motion = time_of(circle(radius, 900.0), machine())
    assert motion.speeds.max() == pytest.approx(math.sqrt(ACCELERATION * radius), rel=EXACT)


@pytest.mark.parametrize("angle", [0.3, math.pi / 2, 2.5])
def test_corner_is_blended_within_the_tolerance(angle):
    tolerance, feed = 0.02, 100.0
    motion = time_of(corner(angle, 50.0, feed), machine(corner_value=tolerance))
    # the arc whose middle is `tolerance` away from the corner
    radius = tolerance * math.cos(angle / 2) / (1 - math.cos(angle / 2))
    expected = min(feed, math.sqrt(ACCELERATION * radius))
    assert motion.speed_at(50.0) == pytest.approx(expected, rel=EXACT)


def test_reversal_is_a_stop():
    assert time_of(corner(math.pi, 10.0, 50.0), machine()).speed_at(10.0) < 1e-6


def test_corner_split_by_a_tiny_move_is_driven_as_one_corner():
    points = np.array([[-30, 0, 0], [0, 0, 0], [0.0005, 0.0005, 0], [0, 30, 0]], float)
    points[3] = points[2] + [0, 30, 0]
    split = polyline_seconds(points, 50.0, machine())
    whole = time_of(corner(math.pi / 2, 30.0, 50.0), machine()).total
    assert split == pytest.approx(whole, rel=1e-3)


@pytest.mark.parametrize("chord", [0.02, 0.1, 0.4])
def test_chords_of_a_circle_are_driven_as_the_circle(chord):
    radius = 5.0  # chord error of 0.4 mm chords is 0.004 mm, below the tolerance
    points = chords_of_circle(radius, chord, turns=3)
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    time = polyline_seconds(points, 900.0, machine())
    speed = math.sqrt(ACCELERATION * radius)
    assert time == pytest.approx(length / speed + speed / ACCELERATION, rel=0.02)


def test_chords_longer_than_the_tolerance_allows_are_corners():
    radius, chord, deviation = 5.0, 1.0, 0.01
    error = chord**2 / (8 * radius)
    points = chords_of_circle(radius, chord, turns=3)
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    time = polyline_seconds(points, 900.0, machine(corner_value=deviation))
    at_corners = math.sqrt(ACCELERATION * radius * deviation / error)
    assert length / time < math.sqrt(at_corners**2 + ACCELERATION * chord)
    assert length / time > 0.9 * at_corners


def test_junction_deviation_is_grbls():
    rule = {"corner_rule": CornerRule.JUNCTION_DEVIATION, "corner_value": 0.01}
    angle = 0.5
    motion = time_of(corner(angle, 50.0, 400.0), machine(**rule))
    sine = math.sin((math.pi - angle) / 2)  # GRBL's angle is the inner one
    expected = math.sqrt(ACCELERATION * 0.01 * sine / (1 - sine))
    assert motion.speed_at(50.0) == pytest.approx(expected, rel=EXACT)


def test_jerk_limits_a_circle():
    radius = 1.0
    motion = time_of(circle(radius, 900.0), jerky())
    assert motion.speeds.max() == pytest.approx((JERK * radius**2) ** (1 / 3), rel=EXACT)


def test_jerk_limited_line_into_arc_slows_where_the_curvature_jumps():
    builder = ToolpathBuilder((-40, 0, 0))
    builder.line((0, 0, 0), 100.0, Role.CUT)
    builder.arc((0, 20, 0), (0, 10), True, 100.0, Role.CUT)
    motion = time_of(builder.build(), jerky(corner_value=0.01))
    # normal acceleration builds up in v^2 c / J and shifts the path by (v^2 c)^3 / (24 J^2)
    shift = (motion.speed_at(40.0) ** 2 / 10.0) ** 3 / (24 * JERK**2)
    assert shift == pytest.approx(0.01, rel=1e-6)


# --- the control --------------------------------------------------------------------------


def test_look_ahead_must_be_able_to_stop():
    chord, blocks = 0.1, 15
    path = straight(*[chord] * 2000, feed=900.0)
    motion = time_of(path, machine(500.0, look_ahead=blocks))
    slowest, fastest = (math.sqrt(2 * 500.0 * n * chord) for n in (blocks - 1, blocks + 1))
    assert slowest < motion.speeds.max() < fastest


def test_block_rate_limits_short_blocks():
    path = straight(*[0.05] * 4000, feed=900.0)
    motion = time_of(path, machine(block_rate=400.0))
    assert motion.speeds.max() == pytest.approx(400.0 * 0.05, rel=1e-6)


# --- published measurements ---------------------------------------------------------------


def test_thirty_measured_times_come_out_with_one_machine():
    found = root_mean_square(residuals(machines.load("huron_840d")))
    assert found <= 0.03  # [CS08] table 2, seconds


def test_stop_on_the_mikron_loses_what_its_jerk_says():
    feed = 10_000 / 60
    builder = ToolpathBuilder((0, 0, 0))
    builder.line((500, 0, 0), feed, Role.CUT)
    time = time_of(builder.build(), machines.load("ucp710")).total
    assert time - 500 / feed == pytest.approx(0.37, abs=0.01)  # [HQS24] table 2, from its limits


@pytest.mark.parametrize(
    ("radius", "meters_per_minute"), [(2, 1.6), (5, 3.0), (10, 4.8), (20, 7.6)]
)
def test_circles_on_the_mikron(radius, meters_per_minute):
    motion = time_of(circle(radius, 10_000 / 60), machines.load("ucp710"))
    assert motion.speeds.max() * 0.06 == pytest.approx(meters_per_minute, abs=0.05)


# --- independent planners -----------------------------------------------------------------


@pytest.mark.parametrize("length", [0.1, 1.0, 10.0, 100.0])
@pytest.mark.parametrize("feed", [5.0, 50.0, 200.0])
def test_single_move_agrees_with_ruckig(length, feed):
    ruckig = pytest.importorskip("ruckig", reason="ruckig is not installed")
    task = ruckig.InputParameter(1)
    task.current_position, task.target_position = [0.0], [length]
    task.max_velocity, task.max_acceleration, task.max_jerk = [feed], [ACCELERATION], [JERK]
    trajectory = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(task, trajectory)
    ours = time_of(straight(length, feed=feed), jerky()).total
    assert ours == pytest.approx(trajectory.duration, rel=SETTLED)


@pytest.mark.parametrize(("entry", "leave"), [(10.0, 60.0), (80.0, 5.0), (40.0, 40.0)])
def test_move_between_speeds_agrees_with_ruckig(entry, leave):
    ruckig = pytest.importorskip("ruckig", reason="ruckig is not installed")
    length, feed = 60.0, 100.0
    task = ruckig.InputParameter(1)
    task.current_position, task.target_position = [0.0], [length]
    task.current_velocity, task.target_velocity = [entry], [leave]
    task.max_velocity, task.max_acceleration, task.max_jerk = [feed], [ACCELERATION], [JERK]
    trajectory = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(task, trajectory)
    points = np.array([[0, 0, 0], [length, 0, 0]], float)
    ours = polyline_seconds(points, feed, jerky(), entry, leave)
    assert ours == pytest.approx(trajectory.duration, rel=SETTLED)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_jerk_limited_rows_of_blocks_are_close_to_the_optimum(seed):
    rng = np.random.default_rng(seed)
    lengths = rng.uniform(2, 30, 5) if seed % 2 else rng.uniform(0.5, 6, 16)
    feeds = rng.uniform(20, 150, len(lengths))
    acceleration, jerk = (2500.0, 5000.0) if seed % 3 else (500.0, 20000.0)
    points = np.zeros((len(lengths) + 1, 3))
    points[1:, 0] = np.cumsum(lengths)
    ours = polyline_seconds(points, feeds, jerky(acceleration, jerk), 20.0, 20.0)
    best = fastest_time(feeds, lengths, 20.0, acceleration, jerk)
    assert -0.01 < ours / best - 1 < 0.05


# --- invariants ---------------------------------------------------------------------------

coordinates = st.floats(-50, 50)
corners = st.lists(st.tuples(coordinates, coordinates), min_size=2, max_size=12)
feeds = st.floats(1, 300)
tools = st.sampled_from(
    [machine(), jerky(), machine(corner_rule=CornerRule.CORNER_SPEED, corner_value=5.0)]
)


def as_path(xy: list[tuple[float, float]]) -> np.ndarray:
    """Return points (n, 3)."""
    return np.column_stack([np.array(xy, float), np.zeros(len(xy))])


@settings(deadline=None, max_examples=60)
@given(corners, feeds, tools)
def test_time_is_never_below_length_over_feed(xy, feed, tool):
    points = as_path(xy)
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    assert polyline_seconds(points, feed, tool) >= length / feed * (1 - EXACT)


@settings(deadline=None, max_examples=60)
@given(corners, feeds, st.floats(100, 5000), st.floats(1, 4))
def test_more_acceleration_is_never_slower(xy, feed, acceleration, factor):
    points = as_path(xy)
    slow = polyline_seconds(points, feed, machine(acceleration))
    assert polyline_seconds(points, feed, machine(acceleration * factor)) <= slow * (1 + EXACT)


@settings(deadline=None, max_examples=60)
@given(corners, feeds, st.floats(0.02, 0.98), tools)
def test_splitting_straight_moves_changes_nothing(xy, feed, share, tool):
    points = as_path(xy)
    keep = np.r_[True, np.linalg.norm(np.diff(points, axis=0), axis=1) > 1e-3]
    points = points[keep]
    if len(points) < 2:
        return
    # at a corner only the straight part counts for the blending, so split the outer moves
    extra = points[0] + share * (points[1] - points[0])
    split = np.vstack([points[:1], extra, points[1:]])
    both = polyline_seconds(points, feed, tool), polyline_seconds(split, feed, tool)
    straight_only = polyline_seconds(points[:2], feed, tool)
    assert polyline_seconds(split[:3], feed, tool) == pytest.approx(straight_only, rel=SETTLED)
    assert both[1] >= both[0] * (1 - SETTLED)


@settings(deadline=None, max_examples=40)
@given(corners, feeds, tools)
def test_profile_adds_up_to_the_time_and_keeps_the_limits(xy, feed, tool):
    builder = ToolpathBuilder((0, 0, 0))
    for x, y in xy:
        builder.line((x, y, 0), feed, Role.CUT)
    path = builder.build()
    motion = time_of(path, tool)
    assert motion.times.sum() == pytest.approx(motion.total)
    steps, v = np.diff(motion.distances), motion.speeds
    moving = steps > 1e-9
    times = 2 * steps[moving] / (v[1:] + v[:-1])[moving]
    assert times.sum() == pytest.approx(motion.total, rel=1e-6)
    assert v.max(initial=0.0) <= feed * (1 + EXACT)
    rates = np.abs(np.diff(v**2))[moving] / (2 * steps[moving])
    assert rates.max(initial=0.0) <= ACCELERATION * (1 + 1e-4)


def test_many_polylines_at_once_are_timed_as_one_by_one():
    rng = np.random.default_rng(7)
    points = rng.uniform(-20, 20, (5, 9, 3))
    for tool in (machine(), jerky()):
        together = polyline_seconds(points, 80.0, tool, 10.0, 5.0)
        alone = [polyline_seconds(p, 80.0, tool, 10.0, 5.0) for p in points]
        np.testing.assert_allclose(together, alone, rtol=SETTLED)


def test_toolpath_and_polyline_agree():
    points = chords_of_circle(8.0, 0.7)
    builder = ToolpathBuilder(points[0])
    for point in points[1:]:
        builder.line(point, 60.0, Role.CUT)
    assert polyline_seconds(points, 60.0, jerky()) == time_of(builder.build(), jerky()).total


def test_moves_that_go_nowhere_take_no_time():
    points = np.array([[0, 0, 0], [0, 0, 0], [10, 0, 0], [10, 0, 0], [10, 0, 0], [20, 0, 0]], float)
    once = polyline_seconds(points[[0, 2, 5]], 50.0, machine())
    assert polyline_seconds(points, 50.0, machine()) == pytest.approx(once, rel=EXACT)


def test_empty_toolpath_takes_no_time():
    assert time_of(ToolpathBuilder((0, 0, 0)).build(), machine()).total == 0.0


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("speed", (1.0, 0.0, 1.0)),
        ("jerk", (-1.0,) * 3),
        ("block_rate", 0.0),
        ("look_ahead", -1),
        ("corner_value", 0.0),
        ("normal_acceleration", -1.0),
        ("acceleration", (1.0, 1.0)),
    ],
)
def test_limits_that_make_no_sense_are_refused(field, value):
    with pytest.raises(ValueError, match=field):
        Machine("bad", **{"speed": (1.0,) * 3, "acceleration": (1.0,) * 3} | {field: value})
