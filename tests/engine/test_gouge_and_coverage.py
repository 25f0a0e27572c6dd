# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gouge and uncut area: closed forms, two slow oracles, and how long it takes."""

import math
import time

import numpy as np
import pytest
import shapely
from drawn import FEED, FLOOR, R, lines, started
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Bitmap, walk
from shapely import LineString, Point, Polygon, box

from freecad_spiralpocket.engine.contact.swept import cut_into_pieces
from freecad_spiralpocket.engine.proof.coverage import uncut_floor
from freecad_spiralpocket.engine.proof.gouge import gouge_depth
from freecad_spiralpocket.engine.toolpath import Role, Toolpath

SQUARE = box(0, 0, 40, 40)
ISLAND = Polygon(SQUARE.exterior.coords, [box(15, 15, 25, 25).exterior.coords[::-1]])


def zigzag(xs: tuple, ys: np.ndarray) -> Toolpath:
    """Return a path to and back between two x at the given y."""
    builder = started(xs[0], ys[0])
    for i, y in enumerate(ys):
        lines(builder, (xs[i % 2], y), (xs[1 - i % 2], y))
    return builder.build()


def gouge(pocket: Polygon, path: Toolpath, clearance: float = R):
    return gouge_depth(pocket, cut_into_pieces(path, R, 0.0, 5.0), clearance)


def uncut_area(pocket: Polygon, path: Toolpath, skin: float = 0.0) -> float:
    pieces = cut_into_pieces(path, R, 0.0, 5.0)
    return uncut_floor(pocket, pieces, FLOOR, R, skin).area


@pytest.mark.parametrize("past", [0.001, 0.05, 2.0, 4.5])
def test_line_past_the_wall_gouges_by_its_distance(past):
    path = lines(started(20, 20), (37 + past, 20), (20, 20)).build()
    depth, place = gouge(SQUARE, path)
    assert depth == pytest.approx(past, abs=1e-9)
    assert place == pytest.approx((37 + past, 20), abs=0.01)


def test_arc_bulging_past_the_wall_gouges_by_its_rise():
    # ends 1 mm off the wall's limit, rises 1.05 mm between
    rise, half = 1.05, 5.0
    radius = (half**2 + rise**2) / (2 * rise)
    builder = lines(started(20, 20), (36, 15))
    builder.arc((36, 25, FLOOR), (36 + rise - radius, 20), True, FEED, Role.CUT)
    assert gouge(SQUARE, builder.build())[0] == pytest.approx(0.05, abs=1e-9)


def test_arc_around_an_island_corner_touches_it_exactly():
    builder = lines(started(12, 20), (12, 15))
    builder.arc((15, 12, FLOOR), (15, 15), True, FEED, Role.CUT)
    assert gouge(ISLAND, builder.build())[0] == pytest.approx(0.0, abs=1e-9)
    assert gouge(ISLAND, builder.build(), R + 0.2)[0] == pytest.approx(0.2, abs=1e-9)


def test_path_across_an_island_gouges_by_radius_and_depth():
    path = lines(started(10, 20), (30, 20)).build()
    assert gouge(ISLAND, path)[0] == pytest.approx(R + 5.0, abs=0.1)


def test_rapids_gouge_below_the_top_only():
    builder = started(20, 20)
    builder.rapid(50.0, z=2.0)
    builder.rapid(50.0, x=60.0)
    assert gouge(SQUARE, builder.build())[0] == 0.0
    builder.rapid(50.0, z=-1.0)
    assert gouge(SQUARE, builder.build())[0] == pytest.approx(R + 20.0)


@settings(max_examples=50)
@given(
    st.lists(st.tuples(st.floats(2, 38), st.floats(2, 38)), min_size=2, max_size=8),
    st.floats(0.5, 60.0),
)
def test_gouge_agrees_with_densely_sampled_distances(points, bulge):
    builder = started(*points[0])
    for i, (x, y) in enumerate(points[1:]):
        here = builder.here[:2]
        chord = np.array([x, y]) - here
        half = np.linalg.norm(chord) / 2
        if i % 2 or half < 0.1:
            lines(builder, (x, y))
            continue
        normal = np.array([-chord[1], chord[0]]) / (2 * half)
        radius = half + bulge
        center = here + chord / 2 + normal * math.sqrt(radius**2 - half**2)
        builder.arc((x, y, FLOOR), center, True, FEED, Role.CUT)
    path = builder.build()
    dense = walk(path, 0.02)[0]
    below = shapely.points(dense[dense[:, 2] < 0.0, :2])
    distance = shapely.distance(below, ISLAND.boundary)
    worst = np.max(np.where(shapely.contains(ISLAND, below), R - distance, R + distance))
    assert gouge(ISLAND, path)[0] == pytest.approx(max(worst, 0.0), abs=0.02)


# Uncut area


def test_one_pass_leaves_the_sides_of_a_wide_slot():
    width, length = 2 * R + 1.0, 40.0
    pocket = LineString([(R, 0), (length - R, 0)]).buffer(R, quad_segs=64)
    sides = box(R, -width / 2, length - R, width / 2)
    path = lines(started(R, 0), (length - R, 0)).build()
    assert uncut_area(pocket.union(sides), path) == pytest.approx(1.0 * (length - 2 * R), rel=5e-3)


def test_skin_within_the_tolerance_does_not_count():
    pocket = box(0, -R - 0.05, 40, R + 0.05)
    path = lines(started(-R, 0), (40 + R, 0)).build()
    assert uncut_area(pocket, path, skin=0.04) == pytest.approx(2 * 0.01 * 40, rel=0.2)
    assert uncut_area(pocket, path, skin=0.06) == 0.0


def test_film_within_the_tolerance_between_two_passes_does_not_count():
    # on the wall the same would, for there a skin is off already
    half = R + 0.02
    pocket = box(-R, -R - half, 40 + R, R + half).buffer(-R).buffer(R, quad_segs=64)
    path = lines(started(0, -half), (40, -half), (40, half), (0, half), (0, -half)).build()
    assert uncut_area(pocket, path, skin=0.05) == 0.0
    assert uncut_area(pocket, path, skin=0.03) == pytest.approx(0.04 * (40 - 2 * R), rel=0.1)


def test_arcs_clear_what_they_sweep():
    ring = Point(0, 0).buffer(15.0, quad_segs=256).difference(Point(0, 0).buffer(5, quad_segs=256))
    builder = started(12, 0)
    for ccw in (True, False):
        x = builder.here[0]
        for _ in range(2):
            x = -x
            builder.arc((x, 0, FLOOR), (0, 0), ccw, FEED, Role.CUT)
        lines(builder, (8, 0))
    full = builder.build()
    assert uncut_area(ring, full, skin=0.002) == pytest.approx(0.0, abs=1e-3)
    outer = np.pi * (9**2 - 5**2)
    builder = started(12, 0)
    for x in (-12, 12):
        builder.arc((x, 0, FLOOR), (0, 0), True, FEED, Role.CUT)
    assert uncut_area(ring, builder.build()) == pytest.approx(outer, rel=1e-3)


def test_tight_arc_leaves_no_core():
    builder = started(2, 0)
    for x in (-2, 2):
        builder.arc((x, 0, FLOOR), (0, 0), True, FEED, Role.CUT)
    disc = Point(0, 0).buffer(5.0, quad_segs=128)
    assert uncut_area(disc, builder.build(), skin=0.002) == 0.0


def test_gap_between_laps_is_found():
    # 0.1 mm stands between passes that are 6.1 mm apart
    path = zigzag((-10.0, 50.0), np.array([3.0, 9.1]))
    assert uncut_area(box(0, 0.1, 40, 12), path) == pytest.approx(0.1 * 40, rel=1e-2)


def test_motion_above_the_floor_clears_nothing():
    builder = started(3, 20, z=-4.9)
    builder.line((37, 20, -4.9), FEED, Role.CUT)
    assert uncut_area(SQUARE, builder.build()) == pytest.approx(40 * 40, rel=1e-2)


@settings(max_examples=10)
@given(st.lists(st.tuples(st.floats(3, 37), st.floats(3, 37)), min_size=2, max_size=6))
def test_uncut_area_agrees_with_a_bitmap(points):
    path = lines(started(*points[0]), *points[1:]).build()
    pixel = 0.1
    stock = Bitmap((0, 0, 40, 40), pixel, 0.0)
    for center in walk(path, 0.05)[0]:
        if center[2] <= FLOOR + 1e-9:
            stock.cut(center, R)
    everywhere = np.ones(stock.heights.shape, bool)
    expected = stock.standing_area(FLOOR, everywhere)
    assert uncut_area(SQUARE, path) == pytest.approx(expected, abs=(20 + path.lengths.sum()) * 0.02)


def test_strokes_that_overlap_again_and_again_are_measured_soon():
    turned = np.linspace(0.0, 900 * math.pi, 450 * 24)
    loops = np.column_stack([8 + 0.007 * turned + 2 * np.cos(turned), 20 + 6 * np.sin(turned)])
    path = lines(started(8.0, 20.0), *loops.tolist()).build()
    begun = time.process_time()
    assert uncut_area(box(12, 13, 24, 27), path) == 0.0
    assert time.process_time() - begun < 2.0  # all at once they took 20 s
