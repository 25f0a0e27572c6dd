# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the engine does itself because scipy loads slowly: the same as scipy does."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from scipy import ndimage
from scipy.interpolate import BSpline
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra, minimum_spanning_tree
from scipy.spatial import cKDTree
from shapely import LineString, MultiPoint, Point

from freecad_spiralpocket.engine.links.routing import clamped_spline
from freecad_spiralpocket.engine.numerics.distinct import (
    are_among,
    distinct,
    distinct_pairs,
    distinct_places,
)
from freecad_spiralpocket.engine.numerics.filters import (
    dilated,
    evened,
    highest,
    lowest,
    patches_of,
)
from freecad_spiralpocket.engine.numerics.graphs import (
    delaunay_triangles,
    shortest_paths,
    spanning_tree,
)
from freecad_spiralpocket.engine.numerics.nearest import nearest
from freecad_spiralpocket.engine.numerics.ragged import rows_of
from freecad_spiralpocket.engine.shapes.polyline import located_nearby
from freecad_spiralpocket.engine.shapes.shaping import simplified_region

RANDOM = np.random.default_rng(7)


@pytest.mark.parametrize("count", [5, 40, 700])
@pytest.mark.parametrize("sigma", [0.1, 1.7, 9.0])
@pytest.mark.parametrize(("closed", "mode"), [(True, "wrap"), (False, "nearest")])
def test_evened_is_a_gaussian_filter(count, sigma, closed, mode):
    values = RANDOM.normal(size=(count, 2))
    expected = ndimage.gaussian_filter1d(values, sigma, axis=0, mode=mode)
    np.testing.assert_allclose(evened(values, sigma, closed=closed), expected, atol=1e-12)
    np.testing.assert_allclose(evened(values[:, 0], sigma, closed=closed), expected[:, 0])


def test_rows_follow_each_other():
    row, place = rows_of(np.array([2, 0, 3, 1]))
    assert row.tolist() == [0, 0, 2, 2, 2, 3]
    assert place.tolist() == [0, 1, 0, 1, 2, 0]
    assert all(len(part) == 0 for part in rows_of(np.zeros(0, np.intp)))


@pytest.mark.parametrize("count", [5, 200])
@pytest.mark.parametrize("width", [3, 13])
def test_highest_and_lowest(count, width):
    values = RANDOM.normal(size=count)
    for closed, mode in ((True, "wrap"), (False, "nearest")):
        most = ndimage.maximum_filter1d(values, width, mode=mode)
        np.testing.assert_array_equal(highest(values, width, closed=closed), most)
        least = ndimage.minimum_filter1d(values, width, mode=mode)
        np.testing.assert_array_equal(lowest(values, width, closed=closed), least)


def test_dilated_adds_four_neighbors():
    mask = RANDOM.random((40, 30)) < 0.1
    np.testing.assert_array_equal(dilated(mask), ndimage.binary_dilation(mask))


@pytest.mark.parametrize("share", [0.0, 0.2, 0.4, 0.6, 1.0])
def test_patches_are_those_that_hang_together(share):
    for rows, columns in ((1, 1), (1, 9), (9, 1), (40, 30), (60, 61)):
        mask = RANDOM.random((rows, columns)) < share
        patches = patches_of(mask)
        expected, count = ndimage.label(mask, np.ones((3, 3)))
        np.testing.assert_array_equal(patches >= 0, mask)
        pairs = {*zip(patches[mask].tolist(), expected[mask].tolist(), strict=True)}
        assert len(pairs) == count == len({patch for patch, _ in pairs})


@pytest.mark.parametrize("points", [1, 2, 300])
@pytest.mark.parametrize("spread", [0.0, 1.0, 200.0])
@pytest.mark.parametrize("within", [np.inf, 3.0])
def test_nearest_point(points, spread, within):
    turn = np.linspace(0.0, 20.0, points)
    curve = np.column_stack([30 * np.cos(turn) + turn, 25 * np.sin(turn)])
    places = curve[RANDOM.integers(0, points, 500)] + spread * RANDOM.normal(size=(500, 2))
    distances, index = nearest(curve, places, within)
    expected, _ = cKDTree(curve).query(places, distance_upper_bound=within)
    near = np.isfinite(expected)
    np.testing.assert_array_equal(np.isfinite(distances), near)
    np.testing.assert_allclose(distances[near], expected[near], atol=1e-12)
    apart = np.hypot(*(curve[index[near]] - places[near]).T)
    np.testing.assert_allclose(apart, expected[near], atol=1e-12)


def network():
    nodes = RANDOM.random((60, 2))
    edges = np.unique(np.sort(RANDOM.integers(0, 60, (150, 2)), axis=1), axis=0)
    edges = edges[edges[:, 0] != edges[:, 1]]
    return edges, np.hypot(*(nodes[edges[:, 0]] - nodes[edges[:, 1]]).T)


def test_shortest_paths():
    edges, lengths = network()
    graph = coo_array((lengths, edges.T), shape=(60, 60)).tocsr()
    distances, before = shortest_paths(edges, lengths, 3)
    expected = dijkstra(graph, directed=False, indices=3)[: len(distances)]
    np.testing.assert_allclose(distances, expected)
    for node in np.flatnonzero(np.isfinite(distances) & (distances > 0)):
        step = [i for i, edge in enumerate(edges) if set(edge) == {node, before[node]}]
        assert np.isclose(distances[node], distances[before[node]] + lengths[step[0]])


def test_spanning_tree_is_the_shortest():
    edges, lengths = network()
    tree = spanning_tree(60, edges, lengths)
    graph = coo_array((lengths, edges.T), shape=(60, 60)).tocsr()
    expected = minimum_spanning_tree(graph)
    of = {tuple(edge): length for edge, length in zip(edges.tolist(), lengths, strict=True)}
    assert len(tree) == expected.nnz
    assert np.isclose(sum(of[tuple(edge)] for edge in tree.tolist()), expected.sum())


def test_no_point_is_inside_the_circle_of_a_delaunay_triangle():
    points = RANDOM.random((80, 2))
    triangles = delaunay_triangles(points)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    for ring in zip(a, b, c, strict=True):
        matrix = 2 * np.array([ring[1] - ring[0], ring[2] - ring[0]])
        right = [ring[1] @ ring[1] - ring[0] @ ring[0], ring[2] @ ring[2] - ring[0] @ ring[0]]
        center = np.linalg.solve(matrix, right)
        radius = np.hypot(*(ring[0] - center))
        assert (np.hypot(*(points - center).T) > radius - 1e-9).all()
    ab, ac = b - a, c - a
    areas = np.abs(ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0]) / 2
    assert np.isclose(areas.sum(), MultiPoint(points).convex_hull.area)


@pytest.mark.parametrize("chords", [3, 60, 900])
@pytest.mark.parametrize("apart", [0.0, 2.4, 40.0])
def test_locate_is_the_nearest_place_on_a_line(chords, apart):
    turn = np.linspace(0.0, 2 * np.pi, chords + 1)
    line = LineString(50 * np.column_stack([np.cos(turn), np.sin(turn)]))
    along = np.linspace(1.0, 1.6, 211)
    points = (50 - apart) * np.column_stack([np.cos(along), np.sin(along)])
    points = points + 0.01 * RANDOM.normal(size=points.shape)
    expected = shapely.line_locate_point(line, shapely.points(points))
    np.testing.assert_allclose(located_nearby(line, points), expected, atol=1e-9)


@pytest.mark.parametrize("count", [2, 3, 4, 9])
def test_clamped_spline(count):
    controls = RANDOM.normal(size=(count, 2))
    degree = min(3, count - 1)
    inner = np.linspace(0, 1, count - degree + 1)
    knots = np.concatenate([np.zeros(degree), inner, np.ones(degree)])
    expected = BSpline(knots, controls, degree)(np.linspace(0, 1, 50))
    np.testing.assert_allclose(clamped_spline(controls, 50), expected, atol=1e-12)
    some = clamped_spline(controls, 50, 12)
    np.testing.assert_array_equal(some, clamped_spline(controls, 50)[[0, 12, 24, 36, 48, 49]])


@pytest.mark.parametrize("count", [0, 1, 200])
def test_distinct_values_and_which_are_among_them(count):
    values = np.random.default_rng(count).integers(0, 90, count)
    assert np.array_equal(distinct(values), np.unique(values))
    assert np.array_equal(distinct(values / 7), np.unique(values / 7))
    for chosen in (values[::5], values[:0]):
        assert np.array_equal(are_among(values, chosen), np.isin(values, chosen))
    pairs = np.column_stack([values, values[::-1] // 9])
    assert np.array_equal(distinct_pairs(pairs), np.unique(pairs, axis=0))


def test_distinct_places_are_those_of_rows():
    points = np.random.default_rng(4).integers(-3, 3, (60, 2)) / 3
    first, place = distinct_places(points)
    wanted = np.unique(points, axis=0, return_index=True, return_inverse=True)
    assert np.array_equal(first, wanted[1])
    assert np.array_equal(place, wanted[2].ravel())


def test_simplified_region_is_that_of_all_rings_at_once():
    ring = Point(0, 0).buffer(30, quad_segs=300)
    # the first point in the middle of a side, which is left out
    square = shapely.Polygon([(5, 0), (10, 0), (10, 10), (0, 10), (0, 0)])
    for region in (ring, ring.difference(square), square.difference(Point(5, 5).buffer(2))):
        slim = simplified_region(region, 0.002)
        assert shapely.equals_exact(slim, shapely.simplify(region, 0.002))
        assert shapely.get_num_coordinates(slim) < shapely.get_num_coordinates(region)


def test_simplified_region_stays_one_where_rings_would_cross():
    # a hole that comes nearer to the rim than the tolerance
    rim = shapely.Polygon([(0, 0), (5, -0.09), (10, 0), (10, 10), (0, 10)])
    region = rim.difference(shapely.Polygon([(4, 2), (5, -0.06), (6, 2)]))
    slim = simplified_region(region, 0.1)
    assert slim.is_valid
    assert len(slim.interiors) == 1
    assert simplified_region(shapely.Polygon(), 0.1).is_empty
