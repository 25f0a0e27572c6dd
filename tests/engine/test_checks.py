# SPDX-License-Identifier: LGPL-2.1-or-later
"""What makes no sense is refused at the engine's door, before any work."""

from __future__ import annotations

import math
import re

import pytest
from shapely import MultiPolygon, Polygon, box
from shapes import HEIGHTS, request

from freecad_spiralpocket.engine.checks import MOST_LEVELS, check_request
from freecad_spiralpocket.engine.errors import GeometryError, RequestError
from freecad_spiralpocket.engine.model import Entry, Section
from freecad_spiralpocket.engine.opening.entry import NARROWEST, WIDEST

ROOM = box(0, 0, 40, 40)


def helical(diameter: float, angle: float, limit: float = 0.0):
    """Return a request for 5 mm of depth in one level, its ramp at an angle [rad]."""
    entry = Entry(helix_angle=angle, max_diameter=limit)
    return request(ROOM, tool_diameter=diameter, tolerance=1e-3, entry=entry)


@pytest.mark.parametrize("limit", [0.0, 0.5])
@pytest.mark.parametrize("diameter", [3.0, 6.0, 20.0])
def test_a_helix_angle_is_refused_from_too_many_turns_on(diameter, limit):
    depth = HEIGHTS.start_depth - HEIGHTS.final_depth
    widest = WIDEST * diameter if limit == 0 else max(limit, NARROWEST * diameter)

    def angle(turns: float) -> float:
        return math.atan(depth / turns / (math.pi * widest))

    check_request(helical(diameter, angle(0.99 * MOST_LEVELS), limit))
    with pytest.raises(RequestError, match="more than 500 times") as caught:
        check_request(helical(diameter, angle(1.01 * MOST_LEVELS), limit))
    told = float(re.search(r"above ([\d.e-]+) degrees", caught.value.hint)[1])
    check_request(helical(diameter, math.radians(1.1 * told), limit))


BOW_TIE = Polygon([(-10, -10), (50, 50), (50, -10), (-10, 50)])
NOWHERE = Polygon([(0, 0), (math.inf, 1), (5, 5)])


@pytest.mark.parametrize("ground", [BOW_TIE, MultiPolygon([BOW_TIE]), NOWHERE])
@pytest.mark.parametrize("field", ["stock", "beyond", "mouth"])
def test_a_broken_outline_is_refused_whatever_it_is_of(ground, field):
    changes = {field: ground}
    if field == "mouth":
        changes = {"sections": (Section(HEIGHTS.final_depth, ROOM, ground),)}
    with pytest.raises(GeometryError, match=r"outline of .*(broken|infinity)") as caught:
        check_request(request(ROOM, **changes))
    assert caught.value.hint


@pytest.mark.parametrize("field", ["stock", "beyond"])
@pytest.mark.parametrize("ground", [Polygon(), MultiPolygon(), box(-5, -5, 45, 45)])
def test_there_need_not_be_any_stock_or_open_side(ground, field):
    check_request(request(ROOM, **{field: ground}))
