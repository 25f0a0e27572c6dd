# SPDX-License-Identifier: LGPL-2.1-or-later
"""The last loop of a slot along the wall runs into sharp corners; no stroke is left for them."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import Point, Polygon, box
from shapely.affinity import rotate
from shapes import DUMBBELL, L_SHAPE, SQUARE, lifts, regular, request

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.floor import Descent, Slot
from freecad_spiralpocket.engine.growth import corners
from freecad_spiralpocket.engine.model import Heights
from freecad_spiralpocket.engine.opening import open_sides
from freecad_spiralpocket.engine.opening.outline import outline_of
from freecad_spiralpocket.engine.opening.sharp_corners import run_into_corners
from freecad_spiralpocket.engine.opening.slot import slot_path
from freecad_spiralpocket.engine.shapes.polyline import closed_line

R = 3.0
SHARP = {
    "rectangle": box(0, 0, 60, 40),
    "turned": rotate(box(0, 0, 60, 40), 33),
    "L": L_SHAPE,
    "hexagon": regular(6, 30),
    "triangle": regular(3, 35),
    "dumbbell": DUMBBELL,
}


def region_of(pocket: Polygon) -> Polygon:
    return pocket.buffer(-R, quad_segs=64)


def ring_in(region: Polygon) -> np.ndarray:
    """Return the rounded ring, counter-clockwise, beginning in the middle of its longest side."""
    points = shapely.get_coordinates(outline_of(region, R).ring)[:0:-1]
    after = np.roll(points, -1, axis=0)
    longest = int(np.hypot(*(after - points).T).argmax())
    middle = (points[longest] + after[longest]) / 2
    return np.vstack([middle, np.roll(points, -longest - 1, axis=0)])


@pytest.mark.parametrize("name", SHARP)
def test_wall_is_the_region_itself_and_the_ring_the_same(name):
    region = region_of(SHARP[name])
    rounded = ring_in(region)
    ring, wall = run_into_corners(rounded, region)
    assert ring.shape == wall.shape
    assert Polygon(wall).symmetric_difference(Polygon(region.exterior)).area < 1e-3
    assert closed_line(ring).hausdorff_distance(closed_line(rounded)) < 1e-9
    # point beside point
    assert np.hypot(*(wall - ring).T).max() < 0.5
    # each corner is one of its points: the cutter turns there and nowhere beside it
    for corner in region.simplify(1e-3).exterior.coords:
        assert np.hypot(*(wall - corner).T).min() < 2e-3


def test_nothing_to_run_into_where_corners_are_rounded():
    region = region_of(SQUARE)
    assert run_into_corners(ring_in(region), region) is None


def test_mouths_of_channels_are_no_corners():
    region = box(0, 0, 40, 20).union(box(19.9, 19, 20.1, 45))
    past = [(10, 0), (40, 0), (40, 20), (20.1, 20), (20, 20), (19.9, 20), (0, 20), (0, 0)]
    assert run_into_corners(np.array(past, dtype=float), region) is None


@pytest.mark.parametrize("depth", [1.0, 4.0])
def test_only_the_last_loop_runs_into_the_corners(depth):
    region = region_of(box(0, 0, 60, 40))
    ring, wall = run_into_corners(ring_in(region), region)
    path = slot_path(Slot(ring, 1.0, wall=wall), Descent(0.0, -depth, math.radians(5)))
    for corner in region.exterior.coords[:-1]:
        at = path[np.hypot(*(path[:, :2] - corner).T) < 1e-9]
        assert len(at) == 1
        assert at[0, 2] == pytest.approx(-depth)
    steps = np.hypot(*np.diff(path[:, :2], axis=0).T)
    assert steps.max() < 60  # nowhere does it jump from one line to the other
    assert shapely.LineString(path[:, :2]).hausdorff_distance(region.exterior) < 0.5


@pytest.mark.parametrize("name", SHARP)
@pytest.mark.parametrize("deep", [False, True], ids=["thin", "deep"])
def test_sharp_pockets_need_no_strokes_in_their_corners(name, deep, monkeypatch):
    every = open_sides.candidates
    monkeypatch.setattr(
        open_sides, "candidates", lambda *a: [s for s in every(*a) if s.name == "outline"]
    )
    asked: list[float] = []
    finish = corners._corner_step

    def counted(piece, *rest):
        asked.append(piece.area)
        return finish(piece, *rest)

    monkeypatch.setattr(corners, "_corner_step", counted)
    heights = Heights(8.0, 3.0, 0.0, -6.0 if deep else -2.0, 7.0)
    made = plan(request(SHARP[name], heights=heights))
    report = made.report
    assert report.uncut_area < 0.01
    assert report.gouge <= 0.01
    assert report.rapid_hit == 0 and report.link_hit == 0
    assert report.engagement_p99 <= report.engagement_limit + math.radians(9)
    assert report.over_limit_share <= 0.003
    assert lifts(made) == 1
    assert not asked


@settings(max_examples=15, deadline=None)
@given(n=st.integers(3, 8), turn=st.floats(0, 6.28), size=st.floats(15, 40), x=st.floats(-200, 200))
def test_any_convex_pocket(n, turn, size, x):
    region = region_of(regular(n, size, turn, (x, 0.0)))
    made = run_into_corners(ring_in(region), region)
    if made is None:
        return
    ring, wall = made
    assert Polygon(wall).is_valid
    assert region.buffer(1e-6).covers(closed_line(wall))
    assert Polygon(wall).buffer(2e-3).covers(Polygon(ring))


def test_corner_of_a_round_pocket_with_one():
    drop = Point(0, 0).buffer(20, quad_segs=64).union(Polygon([(0, 20), (20, 0), (20, 20)]))
    report = plan(request(drop)).report
    assert report.uncut_area < 0.01 and report.gouge <= 0.01
