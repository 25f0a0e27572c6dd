# SPDX-License-Identifier: LGPL-2.1-or-later
"""The last levels of fronts: corners, and what lies beyond channels that no front enters."""

from itertools import pairwise

import pytest
import shapely
from shapely import Point, Polygon, box
from shapely.affinity import rotate
from shapes import request

from freecad_spiralpocket.engine.growth.corners import levels_from
from freecad_spiralpocket.engine.growth.front_rules import rules_of
from freecad_spiralpocket.engine.model import Cutting
from freecad_spiralpocket.engine.shapes.shaping import oriented

R = 3.0
CENTER = (0.0, 0.0)
RING = Point(CENTER).buffer(30, quad_segs=64) - Point(CENTER).buffer(24, quad_segs=64)


def spokes(count: int, width: float) -> Polygon:
    """Return channels from the ring inwards, `width` wide for the cutter's center."""
    bar = box(0, -width / 2, 25, width / 2)
    return shapely.union_all([rotate(bar, 360 * i / count, CENTER) for i in range(count)])


@pytest.mark.parametrize(
    ("count", "width", "stepover"), [(1, 0.06, 2.4), (7, 0.02, 2.4), (7, 0.06, 1.2), (7, 0.3, 2.4)]
)
def test_room_beyond_channels_is_cut_lap_by_lap(count, width, stepover):
    room = Point(CENTER).buffer(9, quad_segs=64)
    omega = oriented(shapely.union_all([RING, room, spokes(count, width)]))
    rules = rules_of(request(box(0, 0, 1, 1), cutting=Cutting(stepover)))
    levels = [front for front, _ in levels_from(oriented(RING), omega, rules)]
    assert shapely.difference(omega, levels[-1]).area < 0.05
    for before, front in pairwise(levels):
        new = shapely.difference(front, before)
        assert shapely.difference(new, shapely.buffer(before, R)).area < 0.01


def test_levels_have_no_more_points_the_longer_a_channel_is():
    arc = Point(CENTER).buffer(25.03, quad_segs=64) - Point(CENTER).buffer(24.97, quad_segs=64)
    channel = arc - box(-30, -30, 0, 0)
    omega = oriented(shapely.union_all([box(-30, -10, -20, 0), channel]))
    rules = rules_of(request(box(0, 0, 1, 1), cutting=Cutting(2.4)))
    levels = [front for front, _ in levels_from(oriented(box(-30, -10, -20, -1)), omega, rules)]
    points = [len(shapely.get_coordinates(front)) for front in levels]
    assert len(points) > 40 and levels[-1].area == pytest.approx(omega.area, abs=0.1)
    assert max(points) < 2 * len(shapely.get_coordinates(omega))
