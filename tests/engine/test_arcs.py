# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines and arcs fitted to polylines keep to them, in as few pieces as they allow."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import LineString

from freecad_spiralpocket.engine.shapes.arcs import fit_arcs

TOLERANCE = 0.004


def sampled(points, pieces, count=40):
    """Return points along every piece, and assert that they meet."""
    here, at = points[0], []
    for end, center, ccw in zip(pieces.ends, pieces.centers, pieces.ccw, strict=True):
        there = points[end]
        u = np.linspace(0, 1, count)[:, None]
        if np.isnan(center[0]):
            at.append(here + u * (there - here))
        else:
            a, b = here - center, there - center
            assert np.hypot(*a) == pytest.approx(np.hypot(*b), abs=1e-6)
            turn = np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b)
            turn += 2 * np.pi * ((turn < 0) & ccw) - 2 * np.pi * ((turn > 0) & ~ccw)
            phi = np.arctan2(a[1], a[0]) + u[:, 0] * turn
            at.append(center + np.hypot(*a) * np.column_stack([np.cos(phi), np.sin(phi)]))
        here = there
    return np.vstack(at)


def deviation(points, pieces):
    return LineString(points).hausdorff_distance(LineString(sampled(points, pieces)))


def test_straight_line_is_one_piece():
    points = np.column_stack([np.linspace(0, 50, 101), np.linspace(0, 20, 101)])
    pieces = fit_arcs(points, TOLERANCE)
    assert len(pieces.ends) == 1 and np.isnan(pieces.centers).all()


@pytest.mark.parametrize("turn", [1.0, -2.5])
def test_arc_is_one_piece_about_its_center(turn):
    phi = np.linspace(0, turn, 129)
    points = np.array([3.0, 4.0]) + 7 * np.column_stack([np.cos(phi), np.sin(phi)])
    pieces = fit_arcs(points, TOLERANCE)
    assert len(pieces.ends) == 1
    assert np.allclose(pieces.centers[0], (3, 4), atol=1e-6)
    assert pieces.ccw[0] == (turn > 0)


def test_spiral_takes_far_fewer_pieces_than_points():
    phi = np.linspace(0, 40, 4000)
    points = (1 + 0.4 * phi)[:, None] * np.column_stack([np.cos(phi), np.sin(phi)])
    pieces = fit_arcs(points, TOLERANCE)
    assert len(pieces.ends) < 200
    assert deviation(points, pieces) <= 2 * TOLERANCE


def test_corner_stays_a_corner():
    points = np.array([(0, 0), (5, 0), (10, 0), (10, 5), (10, 10)], float)
    pieces = fit_arcs(points, TOLERANCE)
    assert pieces.ends.tolist() == [2, 4]


def test_way_back_is_no_arc():
    points = np.array([(0, 0), (10, 0), (0.001, 0)], float)
    assert fit_arcs(points, TOLERANCE).ends.tolist() == [1, 2]


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.tuples(st.floats(-0.4, 0.4), st.floats(0.05, 2.0)), min_size=2, max_size=80),
)
def test_pieces_keep_to_any_polyline(steps):
    turn, length = np.array(steps).T
    heading = np.cumsum(turn)
    moves = length[:, None] * np.column_stack([np.cos(heading), np.sin(heading)])
    points = np.vstack([[0, 0], np.cumsum(moves, axis=0)])
    pieces = fit_arcs(points, TOLERANCE)
    assert pieces.ends[-1] == len(points) - 1 and (np.diff(pieces.ends) > 0).all()
    # tested at points and middles of chords; between them an arc strays hardly farther
    assert deviation(points, pieces) <= 1.5 * TOLERANCE


def test_polylines_are_fitted_together_as_apart():
    phi = np.linspace(0, 3, 60)[:, None]
    arc = 8 * np.column_stack([np.cos(phi), np.sin(phi)])
    zigzag = np.array([(0, 0), (5, 0), (10, 0), (10, 5), (10, 10)], float)
    both = fit_arcs(np.vstack([zigzag, arc, zigzag]), TOLERANCE, np.array([0, 5, 65]))
    apart = [fit_arcs(points, TOLERANCE) for points in (zigzag, arc)]
    ends = [apart[0].ends, 5 + apart[1].ends, 65 + apart[0].ends]
    assert both.ends.tolist() == np.concatenate(ends).tolist()
    centers = [apart[0].centers, apart[1].centers, apart[0].centers]
    np.testing.assert_allclose(both.centers, np.vstack(centers), atol=1e-9)
