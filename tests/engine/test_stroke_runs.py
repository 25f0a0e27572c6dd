# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed laps that are cut as one spiral."""

from __future__ import annotations

import numpy as np
import pytest
from shapely import Point, Polygon, box
from shapely.geometry.polygon import orient
from shapes import L_SHAPE, request

from freecad_spiralpocket.engine.growth.front_rules import rules_of
from freecad_spiralpocket.engine.growth.fronts import fronts_from
from freecad_spiralpocket.engine.growth.stroke_runs import first_laps, followed, runs_of
from freecad_spiralpocket.engine.growth.strokes import strokes_of
from freecad_spiralpocket.engine.model import Strategy
from freecad_spiralpocket.engine.opening.slot_ends import ended_at, well_ended
from freecad_spiralpocket.engine.opening.starts import candidates
from freecad_spiralpocket.engine.shapes.polyline import closed_line, points_at

R, STEPOVER = 3.0, 2.4
AROUND = box(-60, -60, 60, 60)


def about(x0: float, y0: float, x1: float, y1: float) -> Polygon:
    """Return all that was visited about a plug."""
    plug = box(x0, y0, x1, y1).buffer(-1.0).buffer(1.0)
    return orient(Polygon(AROUND.exterior, [plug.exterior]))


def ring_points(x0: float, y0: float, x1: float, y1: float) -> np.ndarray:
    """Return the corners of a rectangle, as a plug's laps go round it."""
    return np.array([(x0, y0), (x0, y1), (x1, y1), (x1, y0)], dtype=float)


def test_spiral_begins_where_all_of_its_laps_follow_each_other():
    # the last plug is near the one before it on the left only
    fronts = [about(-30, -15, 30, 15), about(-28, -13, 28, 13), about(-26, -11, -5, 11)]
    far = box(-59, -59, 59, 59).exterior
    (run,) = runs_of(strokes_of(fronts), fronts, far, R, STEPOVER)
    assert run.strokes == (0, 1)
    own = run.starts[: len(run.starts) - run.spare]
    assert own[:, 0].max() < 20


def test_followed_laps_are_those_that_are_near_enough():
    laps = [closed_line(ring_points(*r)) for r in [(-28, -13, 28, 13), (-26, -11, -5, 11)]]
    ring = closed_line(ring_points(-30, -15, 30, 15))
    places = np.arange(0.0, ring.length, 1.0)
    counts = followed(ring, places, laps, R, STEPOVER)
    x = points_at(ring, places)[:, 0]
    assert (counts >= 1).all()
    assert (counts[x < -10] == 2).any() and (counts[x > 25] == 1).all()


@pytest.mark.parametrize("stairs", [True, False])
def test_slot_ends_where_its_laps_follow_each_other(stairs):
    asked = request(L_SHAPE, strategy=Strategy.AUTOMATIC)
    region = orient(L_SHAPE.buffer(-R, quad_segs=32))
    (start,) = [s for s in candidates(region, asked) if s.name == "outline"]
    if not stairs:
        start = start.plain or start
    fronts = list(fronts_from(start.visited, start.omega, rules_of(asked)))
    strokes = strokes_of(fronts)
    stepover = asked.cutting.stepover

    def count(other):
        laps = first_laps(strokes, other.ring, R, stepover)
        return followed(other.ring, np.zeros(1), laps, R, stepover)[0], len(laps)

    # wherever it ended before
    for at in (0.1, 0.4, 0.7):
        place = points_at(start.ring, np.array([at * start.ring.length]))[0]
        moved = ended_at(start, place)
        best = well_ended(moved, strokes, asked)
        for other in (moved, best):
            assert Polygon(other.entry.ring).symmetric_difference(
                Polygon(start.entry.ring)
            ).area == pytest.approx(0.0, abs=1e-6)
            assert other.ring.length == pytest.approx(start.ring.length)
            assert tuple(other.ring.coords[0]) == pytest.approx(
                tuple((other.entry.ring if not stairs else other.entry.stairs.inner)[0])
            )
        assert moved.ring.distance(Point(place)) < 1e-6
        assert np.hypot(*(np.array(moved.ring.coords[0]) - place)) < 1e-6
        assert count(best)[0] >= count(moved)[0]
