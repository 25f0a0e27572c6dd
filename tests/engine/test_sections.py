# SPDX-License-Identifier: LGPL-2.1-or-later
"""Levels with sections of their own: which rooms there are, and what the proof says of them."""

import dataclasses
import math

import numpy as np
import pytest
from oracle import walk
from shapely import Point, Polygon, box
from shapes import HEIGHTS, rounded
from shapes import request as request_of

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.errors import GeometryError, RequestError
from freecad_spiralpocket.engine.levels import floors, levels_of
from freecad_spiralpocket.engine.model import CutMode, Heights, Section, Strategy
from freecad_spiralpocket.engine.proof.verify import prove
from freecad_spiralpocket.engine.proof.wall_steps import largest_step, step_of
from freecad_spiralpocket.engine.rooms import rooms_of

R = 3.0
SLOPE = math.tan(math.radians(20))


def funnel(floor: Polygon, levels=(-2.0, -4.0, -6.0), slope: float = SLOPE, **changes):
    """Return a request for a pocket on `floor` that widens upwards by `slope`."""
    wide = [floor.buffer((z - levels[-1]) * slope, join_style="mitre") for z in (0.0, *levels)]
    sections = tuple(
        Section(z, pocket, mouth) for z, pocket, mouth in zip(levels, wide[1:], wide, strict=False)
    )
    heights = Heights(8.0, 3.0, 0.0, levels[-1], 2.5)
    return request_of(sections[-1].pocket, sections=sections, heights=heights, **changes)


def test_levels_end_on_ledges_and_begin_anew_below():
    heights = Heights(8, 3, 0.0, -10.0, 4.0)
    assert floors(heights, 0.0, [-5.0]) == pytest.approx([-4, -5, -9, -10])
    assert floors(heights, 0.0, [-4.0, 2.0, -12.0]) == floors(heights)


def test_a_finish_depth_keeps_ledges_above_and_in_it():
    heights = Heights(8, 3, 0.0, -10.0, 4.0, 2.0)
    assert floors(heights, 0.0, [-9.0]) == pytest.approx([-4, -8, -9, -10])


def test_vertical_walls_have_one_outline_at_all_levels():
    request = request_of(box(0, 0, 40, 30), heights=dataclasses.replace(HEIGHTS, step_down=2.0))
    levels = levels_of(request)
    assert [level.bottom for level in levels] == [-2.0, -4.0, -5.0]
    assert all(level.pocket is request.pocket for level in levels)
    assert largest_step(levels, 0.0).width == 0.0


def test_a_room_that_splits_is_cut_branch_by_branch():
    wide, left, right = box(0, 0, 60, 20), box(0, 0, 20, 20), box(40, 0, 60, 20)
    both = left.union(right).union(box(15, 8, 45, 12))  # too narrow for the cutter
    request = request_of(
        both, sections=(Section(-2, wide), Section(-4, both), Section(-5, both)), heights=HEIGHTS
    )
    rooms, _ = rooms_of(levels_of(request), R, 0.0)
    assert [room.level.bottom for room in rooms] == [-2, -4, -5, -4, -5]
    first, *below = rooms
    assert [room.above for room in below] == [first, rooms[1], first, rooms[3]]


def test_below_the_depth_that_the_cutter_fits_it_stays_uncut_and_that_is_told():
    made = plan(funnel(box(0, 0, 30, 5), slope=1.0, strategy=Strategy.AUTOMATIC))
    assert made.toolpath.points[:, 2].min() == -4.0
    assert any("Below Z-4 " in notice.message for notice in made.report.notices)


@pytest.mark.parametrize("mode", CutMode)
@pytest.mark.parametrize("strategy", [Strategy.AUTOMATIC, Strategy.LINEAR_MORPH])
def test_every_level_keeps_to_its_own_walls(strategy, mode):
    request = funnel(rounded(box(0, 0, 40, 26), 4.0), strategy=strategy)
    request = dataclasses.replace(
        request, cutting=dataclasses.replace(request.cutting, cut_mode=mode)
    )
    made = plan(request)
    centers = walk(made.toolpath, 0.5)[0]
    for top, section in zip((0.0, -2.0, -4.0), request.sections, strict=True):
        layer = centers[(centers[:, 2] < top - 0.01) & (centers[:, 2] > section.z - 0.01)]
        assert len(layer) > 100
        away = np.array([section.pocket.boundary.distance(Point(p)) for p in layer[:, :2]])
        assert away.min() > R - 0.01
    report = made.report
    assert report.gouge <= request.tolerance and report.uncut_area < 0.01
    assert report.rapid_hit == report.link_hit == 0.0


def test_an_island_that_rises_on_the_way_down_is_gone_round():
    pocket = rounded(box(0, 0, 50, 40), 4.0)
    deep = pocket.difference(Point(25, 20).buffer(6))
    request = request_of(
        deep,
        sections=(Section(-2.0, pocket), Section(-5.0, deep)),
        heights=HEIGHTS,
        strategy=Strategy.AUTOMATIC,
    )
    made = plan(request)
    points = walk(made.toolpath, 0.2)[0]
    near = np.hypot(*(points[:, :2] - (25, 20)).T) < 6 + R - 0.02
    assert points[near, 2].min() == pytest.approx(-2.0)
    assert made.report.uncut_area < 0.01 and made.report.gouge <= request.tolerance


def test_the_proof_judges_each_level_by_its_own_wall():
    request = funnel(rounded(box(0, 0, 40, 26), 4.0), strategy=Strategy.LINEAR_MORPH)
    made = plan(request)
    deep = made.toolpath.points[:, 2] > -4.5
    shifted = made.toolpath.points - np.where(deep[:, None], (0, 0, 2.0), 0)
    sunk = dataclasses.replace(made.toolpath, points=shifted)
    report = prove(request, sunk)
    assert report.gouge == pytest.approx(2 * SLOPE, abs=0.05)


def test_a_level_left_out_is_uncut():
    request = funnel(rounded(box(0, 0, 40, 26), 4.0), strategy=Strategy.LINEAR_MORPH)
    lowest = dataclasses.replace(request, sections=())
    report = prove(request, plan(lowest).toolpath)
    ring = request.sections[0].pocket.area - request.pocket.area
    assert report.uncut_area == pytest.approx(ring, rel=0.1)


def test_the_step_is_what_the_mouth_has_more():
    floor = box(0, 0, 20, 20)
    level = levels_of(funnel(floor, levels=(-2.0,)))[0]
    step = step_of(level)
    assert step.height == 2.0
    assert step.width == pytest.approx(math.sqrt(2) * 2 * SLOPE)


def test_the_step_on_a_low_island_reaches_to_its_middle():
    square = box(0, 0, 40, 40)
    pocket = square.difference(Point(20, 20).buffer(6, quad_segs=64))
    request = request_of(pocket, sections=(Section(-5.0, pocket, square),), heights=HEIGHTS)
    assert step_of(levels_of(request)[0]).width == pytest.approx(6.0, abs=0.02)


def test_steps_halve_with_the_step_down():
    floor = rounded(box(0, 0, 40, 30), 5.0)
    widths = [
        largest_step(levels_of(funnel(floor, levels)), 0.0).width
        for levels in ((-2.0, -4.0), (-1.0, -2.0, -3.0, -4.0))
    ]
    assert widths[0] == pytest.approx(2 * widths[1], rel=1e-6)


def test_sections_are_checked():
    good = funnel(box(0, 0, 40, 30))
    for sections, error, words in (
        (good.sections[::-1], RequestError, "step down"),
        (good.sections[:-1], GeometryError, "not the pocket's floor"),
        (
            (dataclasses.replace(good.sections[0], pocket=good.pocket), *good.sections[1:]),
            GeometryError,
            "under a wall",
        ),
    ):
        with pytest.raises(error, match=words):
            plan(dataclasses.replace(good, sections=sections))
