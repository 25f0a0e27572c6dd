# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed laps that are cut as one spiral."""

from __future__ import annotations

from shapely import Polygon, box
from shapely.geometry.polygon import orient

from freecad_spiralpocket.engine.growth.stroke_runs import runs_of
from freecad_spiralpocket.engine.growth.strokes import strokes_of

R, STEPOVER = 3.0, 2.4
AROUND = box(-60, -60, 60, 60)


def about(x0: float, y0: float, x1: float, y1: float) -> Polygon:
    """Return all that was visited about a plug."""
    plug = box(x0, y0, x1, y1).buffer(-1.0).buffer(1.0)
    return orient(Polygon(AROUND.exterior, [plug.exterior]))


def test_spiral_begins_where_all_of_its_laps_follow_each_other():
    # the last plug is near the one before it on the left only
    fronts = [about(-30, -15, 30, 15), about(-28, -13, 28, 13), about(-26, -11, -5, 11)]
    far = box(-59, -59, 59, 59).exterior
    (run,) = runs_of(strokes_of(fronts), fronts, far, R, STEPOVER)
    assert run.strokes == (0, 1)
    own = run.starts[: len(run.starts) - run.spare]
    assert own[:, 0].max() < 15
