# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rounding a front's reentrant kinks."""

from __future__ import annotations

import math

import pytest
import shapely
from shapely import Polygon, box
from shapely.geometry.polygon import orient
from shapes import SQUARE, regular
from shapes import request as make_request

from freecad_spiralpocket.engine.growth import closings
from freecad_spiralpocket.engine.growth.front_rules import rules_of

AROUND = box(-60, -60, 60, 60)
BELOW = box(-60, -60, 60, -10)
TRIANGLE = regular(3, 30.0, math.pi / 2)


def rounded_plug() -> Polygon:
    """Return what is left within the next front about a triangle, a step-over farther in [mm]."""
    rules = rules_of(make_request(SQUARE))
    visited = orient(AROUND.difference(TRIANGLE.buffer(-2.0).buffer(2.0)))
    plug = regular(3, 30.0 - 2 * rules.stepover, math.pi / 2)
    front = closings.without_kinks(AROUND.difference(plug), visited, AROUND, rules)
    return AROUND.difference(front)


@pytest.mark.parametrize("width", [1e-7, 1e-5, 1e-4])
def test_corners_that_hang_together_by_hairs_are_rounded_as_those_that_do_not(width, monkeypatch):
    apart, closing_of = rounded_plug(), closings.closing_of

    def with_hairs(shape, radius):
        # along one side, between two of the corners
        hairs = shapely.buffer(shape, width, join_style="mitre").intersection(BELOW)
        return shapely.union(closing_of(shape, radius), hairs)

    monkeypatch.setattr(closings, "closing_of", with_hairs)
    assert rounded_plug().symmetric_difference(apart).area < 0.1
