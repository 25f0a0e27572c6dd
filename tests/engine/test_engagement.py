# SPDX-License-Identifier: LGPL-2.1-or-later
"""Engagement: closed forms, two slow oracles, and what a measurement must not depend on."""

import math
from dataclasses import replace

import numpy as np
import pytest
from drawn import FEED, FLOOR, R, lines, started
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Bitmap, rim_engagement, walk

from freecad_spiralpocket.engine.contact.engagement import Engagement, along_path
from freecad_spiralpocket.engine.toolpath import Role, Toolpath, ToolpathBuilder


def circle(builder: ToolpathBuilder, radius: float, ccw: bool = True, z: float = FLOOR):
    """Add a full circle about the origin, from (radius, 0), as two arcs."""
    builder.arc((-radius, 0.0, z), (0.0, 0.0), ccw, FEED, Role.CUT)
    builder.arc((radius, 0.0, z), (0.0, 0.0), ccw, FEED, Role.CUT)


def measured(builder: ToolpathBuilder, **options) -> Engagement:
    return along_path(builder.build(), R, **{"axial_depth": -FLOOR, **options})


def on_move(engagement: Engagement, move: int, margin: float = 0.0) -> np.ndarray:
    """Return the angles on a move [deg], without its ends if a margin is given [mm]."""
    mine = engagement.moves == move
    along = np.cumsum(engagement.lengths * mine)
    inner = mine & (along > margin) & (along < along[-1] - margin)
    return np.degrees(engagement.angles[inner])


def last_move(builder: ToolpathBuilder) -> int:
    return len(builder.build()) - 1


def test_straight_slot_is_180_degrees():
    engagement = measured(lines(started(), (40.0, 0.0)))
    assert on_move(engagement, 2) == pytest.approx(180.0, abs=1e-6)
    assert engagement.radial_depths[engagement.moves == 2] == pytest.approx(2 * R, abs=1e-6)


@pytest.mark.parametrize("radius", [500.0, 5e3, 1e5])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_an_arc_that_hardly_bends_reads_like_a_line(radius, side):
    reach, sag = radius * math.sin(40.0 / radius), radius * (1 - math.cos(40.0 / radius))
    builder, arcs = started(), []
    for y in (0.0, 2.4):
        lines(builder, (0.0, y))
        end = (reach, y + side * sag, FLOOR)
        builder.arc(end, (0.0, y + side * radius), side > 0, FEED, Role.CUT)
        arcs.append(last_move(builder))
        lines(builder, end[:2], (0.0, y), z=1.0)
    engagement = measured(builder)
    slot, beside = (on_move(engagement, arc, margin=2 * R) for arc in arcs)
    assert slot == pytest.approx(180.0, abs=1e-3)
    assert beside == pytest.approx(math.degrees(math.acos(1 - 2.4 / R)), abs=0.5)


@pytest.mark.parametrize("stepover", [0.05, 0.6, 2.4, 3.0, 5.0, 5.99])
def test_parallel_pass_is_engaged_by_its_stepover(stepover):
    builder = lines(started(), (60.0, 0.0), (60.0, stepover), (0.0, stepover))
    engagement = measured(builder)
    back = last_move(builder)
    expected = math.degrees(math.acos(1 - stepover / R))
    assert on_move(engagement, back, margin=2 * R) == pytest.approx(expected, abs=1e-6)
    depths = engagement.radial_depths[engagement.moves == back]
    assert np.median(depths) == pytest.approx(stepover, abs=1e-9)


@pytest.mark.parametrize("ccw", [True, False])
@pytest.mark.parametrize(("radius", "step"), [(4.0, 1.0), (10.0, 2.4), (30.0, 0.3)])
def test_circle_growing_by_a_step_follows_the_cosine_rule(radius, step, ccw):
    builder = started(radius - step)
    circle(builder, radius - step, ccw)
    lines(builder, (radius, 0.0))
    circle(builder, radius, ccw)
    engagement = measured(builder)
    cosine = ((radius + R - step) ** 2 - radius**2 - R**2) / (2 * radius * R)
    second = on_move(engagement, last_move(builder), margin=0.5)
    # towards the end of the lap the cutter comes upon its beginning
    assert second.max() == pytest.approx(math.degrees(math.acos(cosine)), abs=1e-6)


@pytest.mark.parametrize("stepover", [0.3, 1.2, 2.4])
def test_chip_of_a_pass_is_the_sine_of_its_engagement_up_to_a_right_angle(stepover):
    path = lines(started(), (60.0, 0.0), (60.0, stepover), (0.0, stepover))
    engagement = measured(path)
    middle = (engagement.moves == last_move(path)) & (abs(engagement.points[:, 0] - 30) < 15)
    assert engagement.chips[middle] == pytest.approx(np.sin(engagement.angles[middle]))


def test_chip_of_a_rib_is_that_of_its_far_side():
    # a rib between y = 3 and y = 5 beside the slot is met from the slot at y = 8 on
    path = lines(started(), (60.0, 0.0), (60.0, 8.0), (0.0, 8.0), (0.0, 5.5), (60.0, 5.5))
    engagement = measured(path)
    middle = (engagement.moves == last_move(path)) & (abs(engagement.points[:, 0] - 30) < 15)
    near, far = math.acos(2.5 / R), math.acos(0.5 / R)
    assert engagement.angles[middle] == pytest.approx(far - near)
    assert engagement.chips[middle] == pytest.approx(math.sin(far))


def test_dust_makes_no_chip():
    # 0.002 mm stand ahead of the second pass, between it and the slot beside
    path = lines(started(), (60.0, 0.0), (60.0, 6.002), (0.0, 6.002), (0.0, 3.001), (60.0, 3.001))
    engagement = measured(path)
    middle = (engagement.moves == last_move(path)) & (abs(engagement.points[:, 0] - 30) < 15)
    assert 0 < engagement.angles[middle].max() < math.radians(1.0)
    assert engagement.chips[middle].max() == 0


def test_circle_inside_a_cleared_ring_follows_the_cosine_rule():
    radius, step = 12.0, 2.0
    builder = started(radius + step)
    circle(builder, radius + step)
    lines(builder, (radius, 0.0))
    circle(builder, radius, ccw=False)
    cosine = (radius**2 + R**2 - (radius + step - R) ** 2) / (2 * radius * R)
    angles = on_move(measured(builder), last_move(builder), margin=2.0)
    assert np.median(angles) == pytest.approx(math.degrees(math.acos(cosine)), abs=1e-6)


def test_second_time_around_is_in_the_air():
    builder = started(10.0)
    for _ in range(2):
        circle(builder, 10.0)
    engagement = measured(builder)
    assert on_move(engagement, last_move(builder)) == pytest.approx(0.0, abs=1e-3)


def test_tight_circle_sees_its_own_trail():
    # on a circle of half the cutter's radius the inner part of the rim's leading half runs
    # through ground that the cutter itself has cleared since the start of the turn
    builder = started(R / 2)
    circle(builder, R / 2)
    engagement = measured(builder)
    angles = on_move(engagement, last_move(builder))
    assert angles.max() < 170.0
    assert angles[0] > angles[-1]


def test_right_angle_turn_engages_the_new_leading_half_less_the_trail():
    # after a turn to the left by 90 degrees a quarter of the new leading half is behind
    builder = lines(started(), (20.0, 0.0), (20.0, 20.0))
    engagement = measured(builder)
    assert on_move(engagement, last_move(builder))[0] == pytest.approx(90.0, abs=0.1)


def test_polygon_of_arc_chords_reads_like_the_arc():
    fine = np.linspace(0.0, 2 * np.pi, 721)
    arcs, chords = started(8.0), started(8.0)
    for builder, smooth in ((arcs, True), (chords, False)):
        for radius in (8.0, 10.0):
            lines(builder, (radius, 0.0))
            if smooth:
                circle(builder, radius)
            else:
                ring = radius * np.column_stack([np.cos(fine), np.sin(fine)])
                lines(builder, *ring[1:])
    one, other = measured(arcs), measured(chords)
    assert np.average(one.angles, weights=one.lengths) == pytest.approx(
        np.average(other.angles, weights=other.lengths), abs=np.radians(0.3)
    )


def test_slot_opened_in_steps_counts_by_the_depth_that_stands():
    builder = started(z=-2.0)
    lines(builder, (40.0, 0.0), z=-2.0)
    builder.line((40.0, 0.0, -5.0), FEED, Role.ENTRY)
    lines(builder, (0.0, 0.0))
    engagement = measured(builder)
    assert on_move(engagement, 2) == pytest.approx(180.0 * 2 / 5, abs=1e-6)
    back = on_move(engagement, last_move(builder), margin=2.2 * R)
    assert back == pytest.approx(180.0 * 3 / 5, abs=1e-6)


def test_ground_cleared_above_the_axial_depth_does_not_count():
    def two_levels(second: float) -> ToolpathBuilder:
        builder = lines(started(), (40.0, 0.0))
        builder.rapid(50.0, z=2.0)
        builder.rapid(50.0, x=0.0)
        builder.line((0.0, 0.0, second), FEED, Role.ENTRY)
        return lines(builder, (40.0, 0.0), z=second)

    builder = two_levels(2 * FLOOR)
    assert on_move(measured(builder), last_move(builder)) == pytest.approx(180.0, abs=1e-6)
    builder = two_levels(1.5 * FLOOR)
    assert on_move(measured(builder), last_move(builder), margin=R) == pytest.approx(90.0, abs=1e-6)


@pytest.mark.parametrize("parts", [7, 40, 400])
def test_a_pass_over_a_ramp_reads_the_same_however_finely_that_is_cut_up(parts):
    def crossed(count: int) -> np.ndarray:
        builder = started(z=-0.5)
        for i in range(1, count + 1):
            builder.line((60.0 * i / count, 0.0, -0.5 - 4.0 * i / count), FEED, Role.ENTRY)
        return on_move(measured(lines(builder, (60.0, 3.0), (0.0, 3.0))), count + 3)

    # in steps of 1/32 of the axial depth
    assert crossed(parts) == pytest.approx(crossed(1), abs=180 / 32)


def test_repeated_level_reads_like_the_first():
    builder = started()
    for depth in (1, 2, 3):
        builder.line((0.0, 0.0, depth * FLOOR), FEED, Role.ENTRY)
        lines(builder, (30.0, 0.0), (30.0, 2.0), (1.0, 2.5), (0.0, 0.0), z=depth * FLOOR)
    engagement = measured(builder)
    z = engagement.points[:, 2]
    first, *others = (engagement.angles[np.isclose(z, d * FLOOR)] for d in (1, 2, 3))
    assert len(first) > 20
    for other in others:
        assert other == pytest.approx(first, abs=1e-9)


def test_rapids_clear_nothing():
    builder = started()
    builder.rapid(50.0, x=40.0)
    lines(builder, (0.0, 0.0))
    engagement = measured(builder)
    assert np.median(on_move(engagement, last_move(builder))) == pytest.approx(180.0, abs=1e-3)


def test_lengths_add_up_to_the_path():
    builder = lines(started(), (10.0, 0.0), (10.0, 7.0))
    builder.arc((10.0, 17.0, FLOOR), (10.0, 12.0), True, FEED, Role.CUT)
    engagement = measured(builder)
    assert engagement.lengths.sum() == pytest.approx(17.0 + 5 * np.pi, rel=1e-6)


def test_arrivals_in_the_solid_are_told():
    builder = lines(started(), (30.0, 0.0))
    for x, y in ((15.0, 0.0), (15.0, 40.0)):
        builder.rapid(50.0, z=2.0)
        builder.rapid(50.0, x, y)
        builder.line((x, y, FLOOR), FEED, Role.ENTRY)
        lines(builder, (x + 5, y))
    engagement = measured(builder)
    places = engagement.points[engagement.solid_arrivals, :2]
    assert places == pytest.approx(np.array([[0.0, 0.0], [15.0, 40.0]]), abs=1e-4)


@pytest.mark.parametrize("angle", [0.3, 2.0, 4.5])
def test_turned_moved_and_mirrored_paths_read_the_same(angle):
    builder = lines(started(), (20.0, 0.0), (20.0, 2.0))
    builder.arc((10.0, 12.0, FLOOR), (10.0, 2.0), True, FEED, Role.CUT)
    path = lines(builder, (0.0, 1.0)).build()
    plain = along_path(path, R, axial_depth=5.0)
    c, s = math.cos(angle), math.sin(angle)
    spin = np.array([[c, s], [-s, c]])

    def turned(p):
        return np.column_stack([p[:, :2] @ spin + (170.0, -90.0), p[:, 2:]])

    moved = replace(
        path,
        start=turned(path.start[None])[0],
        points=turned(path.points),
        centers=path.centers @ spin + (170.0, -90.0),
    )
    for other in (moved, path.mirrored()):
        assert along_path(other, R, axial_depth=5.0).angles == pytest.approx(plain.angles, abs=1e-6)


@pytest.mark.parametrize("name", ["cutter_radius", "axial_depth", "spacing"])
def test_nonsense_is_refused(name):
    options = {"cutter_radius": R, "axial_depth": 5.0, "spacing": 0.1, name: 0.0}
    with pytest.raises(ValueError, match=f"{name} must be positive"):
        along_path(started().build(), **options)


def test_path_without_cutting_has_no_samples():
    builder = ToolpathBuilder((0.0, 0.0, 5.0))
    builder.rapid(50.0, x=30.0)
    assert len(measured(builder).angles) == 0


COORDINATE = st.floats(-2.5 * R, 2.5 * R)


@st.composite
def toolpaths(draw, floors=(FLOOR,)) -> Toolpath:
    """Return tangled paths of lines and arcs of up to a full turn, within a few radii."""
    builder = started(draw(COORDINATE), draw(COORDINATE), draw(st.sampled_from(floors)))
    for _ in range(draw(st.integers(2, 7))):
        here = builder.here
        z = draw(st.sampled_from(floors))
        if draw(st.booleans()):
            builder.line((draw(COORDINATE), draw(COORDINATE), z), FEED, Role.CUT)
            continue
        bearing, radius = draw(st.floats(0.0, 6.28)), draw(st.floats(0.2, 4 * R))
        center = here[:2] + radius * np.array([math.cos(bearing), math.sin(bearing)])
        turn = bearing + math.pi + draw(st.floats(0.05, 6.2)) * draw(st.sampled_from((-1, 1)))
        end = center + radius * np.array([math.cos(turn), math.sin(turn)])
        ccw = draw(st.booleans())
        builder.arc((*end, here[2]), tuple(center), ccw, FEED, Role.CUT)
    return builder.build()


def differences(path: Toolpath, slow_angle, step: float) -> np.ndarray:
    """Return measured less slow angles [rad], `slow_angle(index in the walk, center)`.

    Not at the very start of moves: there the measurement is nearer than the oracle's step.
    """
    engagement = along_path(path, R, axial_depth=-FLOOR)
    points, _, moves = walk(path, step)
    off_start = np.linalg.norm(engagement.points - path.starts[engagement.moves], axis=1) > 2 * step
    chosen = np.flatnonzero(off_start)
    found = []
    for k in chosen[np.linspace(0, len(chosen) - 1, min(60, len(chosen))).astype(int)]:
        center = engagement.points[k]
        mine = np.flatnonzero(moves == engagement.moves[k])
        now = mine[np.argmin(np.linalg.norm(points[mine] - center, axis=1))]
        found.append(engagement.angles[k] - slow_angle(now, center))
    return np.array(found)


def looked_up(path: Toolpath) -> np.ndarray:
    """Return measured angles less those of looking up every rim point [deg]."""
    step = R / 100
    points, headings, _ = walk(path, step)

    def slow(now, center):
        return rim_engagement(points[:now], center, headings[now], R, -FLOOR)

    return np.degrees(differences(path, slow, step))


# Where the oracle's half degrees and steps are multiplied: rims that just touch.
TOUCHING = 0.05


@settings(max_examples=15)
@given(toolpaths())
def test_agrees_with_looking_up_every_rim_point(path):
    assert np.count_nonzero(np.abs(looked_up(path)) > 1.0) <= 1 + TOUCHING * 60


@settings(max_examples=15)
@given(toolpaths(floors=(FLOOR, 0.6 * FLOOR, 0.2 * FLOOR)))
def test_agrees_with_looking_up_heights(path):
    # ramps are steps of 1/32 of the axial depth, rounded: worth 6 degrees of a full slot
    assert np.count_nonzero(np.abs(looked_up(path)) > 7.0) <= 1 + TOUCHING * 60


@pytest.mark.slow
@settings(max_examples=10)
@given(toolpaths(floors=(FLOOR, 0.4 * FLOOR)))
def test_agrees_with_a_bitmap_of_the_stock(path):
    step, pixel = R / 60, R / 60
    points, headings, _ = walk(path, step)
    low, high = points.min(axis=0) - 2 * R, points.max(axis=0) + 2 * R
    stock = Bitmap((*low[:2], *high[:2]), pixel, 0.0)
    angles = np.zeros(len(points))
    for i, (center, heading) in enumerate(zip(points, headings, strict=True)):
        angles[i] = stock.engagement(center, heading, R, -FLOOR)
        if center[2] < 0:
            stock.cut(center, R)
    apart = np.degrees(differences(path, lambda now, _: angles[now], step))
    # a pixel is worth a degree where the rim crosses an edge and ten where it grazes one
    assert np.count_nonzero(np.abs(apart) > 12.0) <= 1 + TOUCHING * 60
