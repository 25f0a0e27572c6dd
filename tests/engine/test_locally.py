# SPDX-License-Identifier: LGPL-2.1-or-later
"""Growing only around the rooms that are left comes to the same as moving the whole front."""

from functools import partial
from itertools import pairwise

import pytest
import shapely
from shapely import LineString, Point, Polygon, box
from shapes import request

from freecad_spiralpocket.engine.growth.front_rules import rules_of
from freecad_spiralpocket.engine.growth.fronts import advance, fronts_from, rooms_left
from freecad_spiralpocket.engine.growth.locally import grown_locally
from freecad_spiralpocket.engine.model import Cutting
from freecad_spiralpocket.engine.shapes.shaping import oriented

NECK = LineString([(38, 18), (62, 22)]).buffer(1.0)
ROOMS = {
    "beyond a neck": box(60, 0, 100, 40),
    "round an island": box(60, 0, 100, 40) - Point(82, 20).buffer(7),
    "two at once": box(60, 0, 100, 40) | box(-60, 5, -20, 30) | box(-21, 15, 1, 17),
}


def visited_of(omega: Polygon) -> Polygon:
    """Return the room in the middle and a part of each of those beyond a neck."""
    middle = shapely.union_all([box(0, 0, 40, 40), NECK, box(-21, 15, 1, 17)])
    begun = shapely.union_all([Point(62, 22).buffer(14), Point(-24, 16).buffer(10)])
    return oriented(shapely.intersection(shapely.union(middle, begun), omega))


@pytest.mark.parametrize("stepover", [0.9, 2.4])
@pytest.mark.parametrize("name", ROOMS)
def test_a_step_is_the_same(name, stepover):
    omega = oriented(shapely.union_all([box(0, 0, 40, 40), NECK, ROOMS[name]]))
    visited = visited_of(omega)
    rules = rules_of(request(box(0, 0, 1, 1), cutting=Cutting(stepover)))
    rooms = rooms_left(visited, omega, rules)
    assert len(rooms) == (2 if name == "two at once" else 1)
    step = partial(advance, rules=rules)
    whole = step(visited, omega)
    here = grown_locally(step, visited, omega, rooms, 6 * rules.cutter_radius)
    assert whole.area - visited.area > 5 * stepover
    assert shapely.symmetric_difference(whole, here).area < 0.02 * (whole.area - visited.area)
    assert here.contains(visited.buffer(-0.01)) and omega.buffer(0.01).contains(here)


def test_all_rooms_are_visited_in_the_end():
    bars = [box(30 * i, 0, 30 * i + 20, 20) for i in range(5)]
    necks = [box(30 * i + 19, 9.5, 30 * i + 31, 10.5) for i in range(4)]
    omega = oriented(shapely.union_all([*bars, *necks]))
    rules = rules_of(request(box(0, 0, 1, 1), cutting=Cutting(2.4)))
    fronts = list(fronts_from(oriented(Point(70, 10).buffer(3)), omega, rules))
    assert not rooms_left(fronts[-1], omega, rules)
    for before, front in pairwise(fronts):
        assert front.buffer(0.01).contains(before)
