# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the cutter goes down when a start point is asked for, by strategy and cut mode."""

import math

import pytest
from shapely import box
from shapes import DUMBBELL, L_SHAPE, PENTAGON, request, rounded

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.model import CutMode, Cutting, Heights, Strategy


def way_down(pocket, strategy, asked, mode=CutMode.CLIMB):
    """Return how far from the start point the cutter goes down, and the plan."""
    cutting = Cutting(stepover=2.4, cut_mode=mode)
    made = plan(request(pocket, strategy=strategy, start_point=asked, cutting=cutting))
    path = made.toolpath
    first = path.starts[path.points[:, 2] < 0][0]
    assert made.report.uncut_area < 0.01
    assert made.report.gouge < 0.01
    assert made.report.link_hit < 0.1
    return math.hypot(*(first[:2] - asked)), made


def told(made) -> list[str]:
    return [n.message for n in made.report.notices if "from the start point" in n.message]


@pytest.mark.parametrize("mode", CutMode)
@pytest.mark.parametrize("asked", [(33.0, 3.0), (-33.0, 3.0)])
@pytest.mark.parametrize(
    "strategy",
    [
        Strategy.AUTOMATIC,
        Strategy.LINEAR_MORPH,
        Strategy.EXTENDED_ARCHIMEDEAN,
        Strategy.ISOTHERM,
    ],
)
def test_the_room_that_is_asked_for_is_entered_first(strategy, asked, mode):
    off, made = way_down(DUMBBELL, strategy, asked, mode)
    assert off < 2 * made.request.tool_diameter
    assert bool(told(made)) == (off > made.request.tool_diameter)


@pytest.mark.parametrize("strategy", Strategy)
def test_a_start_far_off_is_told_where_a_method_begins_in_the_middle(strategy):
    off, made = way_down(PENTAGON, strategy, (0.0, 22.0))
    if strategy is Strategy.AUTOMATIC:
        assert not told(made)
    else:
        assert off > made.request.tool_diameter
        assert len(told(made)) == 1
        assert strategy.value in told(made)[0]


@pytest.mark.parametrize("width", [6.05, 6.1, 6.2])
def test_a_channel_without_room_for_a_helix_is_entered_by_a_slot(width):
    channel = box(0, 0, 60, width)
    for asked in ((30.0, 3.0), (2.0, 3.0)):
        made = plan(request(channel, strategy=Strategy.AUTOMATIC, start_point=asked))
        path = made.toolpath
        first = path.starts[path.points[:, 2] < 0][0]
        off = math.hypot(*(first[:2] - asked))
        assert made.report.uncut_area < 0.2 and made.report.gouge < 0.01
        assert bool(told(made)) == (off > made.request.tool_diameter)
        if asked[0] > 6.0:  # along the wall a slot may begin anywhere, at the ends it may not
            assert off < 6.0


@pytest.mark.parametrize("strategy", [Strategy.LINEAR_MORPH, Strategy.EXTENDED_ARCHIMEDEAN])
def test_a_slot_begins_beside_the_start_point(strategy):
    for asked in ((60.0, 15.0), (15.0, 60.0)):
        off, _ = way_down(L_SHAPE, strategy, asked)
        assert off < 6.0


@pytest.mark.parametrize("asked", [(70.0, 4.0), (60.0, 26.0), (120.0, 4.0)])
def test_a_slot_with_stairs_begins_beside_the_start_point(asked):
    heights = Heights(8.0, 3.0, 1.0, -5.0, 7.0)
    made = plan(request(rounded(box(0, 0, 150, 30), 4.0), start_point=asked, heights=heights))
    assert math.hypot(*(made.toolpath.start[:2] - asked)) < 6.0
    # nor is the slot given up for it
    assert made.report.time < 60


@pytest.mark.parametrize("mode", CutMode)
@pytest.mark.parametrize(
    "pocket", [L_SHAPE, box(0, 0, 120, 50), box(0, 0, 70, 60) - box(30, 25, 45, 40)]
)
def test_a_start_point_in_a_corner_costs_no_more_than_another_round(pocket, mode):
    cutting = Cutting(stepover=1.2, cut_mode=mode)
    freely = plan(request(pocket, cutting=cutting))
    round_it = pocket.exterior.length / freely.request.feeds.horizontal
    for corner in list(pocket.exterior.coords)[:-1]:
        made = plan(request(pocket, cutting=cutting, start_point=corner))
        assert made.report.uncut_area < 0.01 and made.report.gouge < 0.01
        assert not told(made)
        assert made.report.time < freely.report.time + round_it
