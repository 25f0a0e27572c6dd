# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fronts keep the engagement as they grow, and leave neither cusps nor slim tips."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from shapely import Point, Polygon, box
from shapely.geometry.polygon import orient

from freecad_spiralpocket.engine.growth.front_rules import FrontRules, engagement_step
from freecad_spiralpocket.engine.growth.fronts import advance


@pytest.mark.parametrize("curvature", [0.0, 0.05, 0.2, 0.5])
def test_step_keeps_the_engagement_of_a_growing_disc(curvature):
    rules = FrontRules(3.0, math.radians(70), 4.0, 4.0)
    step = float(engagement_step(np.array([curvature]), rules)[0])
    if curvature == 0:
        assert step == pytest.approx(rules.stepover, rel=1e-3)
        return
    old = 1 / curvature
    edge, center = old + 3.0, old + step
    # the rim leaves the cleared disc where its distance to the middle is the edge's radius
    cosine = (edge**2 - center**2 - 9.0) / (2 * center * 3.0)
    assert math.acos(cosine) == pytest.approx(math.radians(70), abs=1e-9)


def front_of_two_discs(radius: float, apart: float, bar: Polygon) -> Polygon:
    """Return the front after discs side by side [mm], and a bar that joins them."""
    rules = FrontRules(3.0, math.acos(1 - 2.4 / 3.0), 1.33 * 3.0, 1.75 * 2.4)
    discs = [Point(x, 0).buffer(radius, quad_segs=64) for x in (0, apart)]
    visited = orient(shapely.union_all([*discs, bar]))
    return advance(visited, box(-3 * radius, -3 * radius, 6 * radius, 3 * radius), rules)


def sharpest_turn(front: Polygon) -> float:
    """Return by how much the rings of a region turn at most at a point [rad]."""
    sharpest = 0.0
    for ring in (front.exterior, *front.interiors):
        points = np.array(ring.coords)[:-1]
        steps = np.diff(np.vstack([points[-1:], points, points[:1]]), axis=0)
        headings = np.arctan2(*steps.T[::-1])
        turns = (np.diff(headings) + math.pi) % (2 * math.pi) - math.pi
        sharpest = max(sharpest, np.abs(turns).max())
    return sharpest


@pytest.mark.parametrize("width", [45.9, 46.0, 46.1, 52.0])
def test_a_front_that_closes_a_channel_has_no_cusp(width):
    # two discs and what joins them: the fronts between come nearer and nearer to each other
    front = front_of_two_discs(20, width, box(0, -18, width, -8))
    assert sharpest_turn(front) < math.radians(20)


@pytest.mark.parametrize("gap", [2.0, 3.0, 3.5, 4.0, 4.3])
def test_fronts_that_meet_leave_no_slim_tip(gap):
    front = front_of_two_discs(40, 80 + gap, box(0, -40, 80 + gap, -32))
    assert len(front.interiors) == 1
    assert sharpest_turn(front) < math.radians(20)
