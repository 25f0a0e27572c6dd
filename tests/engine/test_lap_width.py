# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laps a little wider than the step-over, where that saves a pass and only there."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import Point, Polygon, box
from shapes import request, rounded

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.growth import lap_width
from freecad_spiralpocket.engine.growth.front_rules import MEETING, FrontRules
from freecad_spiralpocket.engine.growth.lap_width import STRETCH, best_width, widened
from freecad_spiralpocket.engine.model import Heights

R, STEPOVER = 3.0, 2.4
RULES = FrontRules(R, float(np.arccos(1 - STEPOVER / R)), 4.0, 4.2)
GROUND = box(-200, -200, 200, 200)
#: With laps of exactly the step-over a thin rib stays in its middle.
LONG = rounded(box(0, 0, 150, 35), 4.0)


def around(stock: Polygon) -> Polygon:
    """Return where the center has been that stands so far off stock that this is left."""
    hole = stock.buffer(R - lap_width.IDLE, quad_segs=32)
    return Polygon(GROUND.exterior, [hole.exterior])


@given(st.integers(2, 9), st.floats(-0.3, 0.3))
def test_thin_last_pass_is_saved_where_laps_may_be_so_wide(passes, more):
    """Whatever is a little wider than some whole passes is cut by these."""
    width = (passes + more) * STEPOVER
    found = best_width(around(box(-100, 0, 100, width)), GROUND, RULES).stepover
    assert STEPOVER - 1e-9 <= found <= STRETCH * STEPOVER + 1e-9
    needed = width / passes
    if more <= 0:
        assert found == pytest.approx(STEPOVER)
    elif STEPOVER * 1.001 < needed < 0.999 * STRETCH * STEPOVER:
        assert needed - 1e-6 <= found < needed + 0.011 * STEPOVER
    elif needed > STRETCH * STEPOVER:
        assert found == pytest.approx(STEPOVER)


@pytest.mark.parametrize("stock", [Point(0, 0).buffer(30), Point(0, 0).buffer(1.3), Polygon()])
def test_where_no_pass_is_saved_laps_are_as_wide_as_the_step_over(stock):
    assert best_width(around(stock), GROUND, RULES) == RULES


def test_laps_are_never_so_wide_that_stock_stays_where_they_meet():
    widest = MEETING * R
    rules = FrontRules(R, float(np.arccos(1 - widest / R)), 4.0, 4.2)
    assert best_width(around(box(-100, 0, 100, 4.1 * widest)), GROUND, rules) == rules


def test_islands_are_no_stock():
    """Around what stays there is no last pass."""
    island = box(-100, 0, 100, 2.05 * STEPOVER)
    ground = Polygon(GROUND.exterior, [island.exterior])
    visited = Polygon(GROUND.exterior, [island.buffer(5).exterior])
    assert best_width(visited, ground, RULES) == RULES


def test_widened_rules_have_that_step_over():
    assert widened(RULES, 1.03).stepover == pytest.approx(1.03 * STEPOVER)


def test_pocket_with_a_pass_less_is_cut_sooner_whole_and_as_gently(monkeypatch):
    asked = request(LONG, heights=Heights(8.0, 3.0, 1.0, -5.0, 7.0))
    wide = plan(asked).report
    monkeypatch.setattr(lap_width, "WORTH", np.inf)
    plain = plan(asked).report
    assert wide.time < 0.98 * plain.time
    assert wide.uncut.area == plain.uncut.area == 0
    assert wide.over_limit_share == 0
    assert wide.engagement_p99 < wide.engagement_limit + np.radians(6)
