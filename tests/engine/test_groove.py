# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grooves: every place is opened level by level, and never more than one bite at once."""

import math
import tracemalloc

import numpy as np
import pytest
import shapely
from shapely import LineString, Polygon

from freecad_spiralpocket.engine.floor import Descent, Groove
from freecad_spiralpocket.engine.opening.branches import (
    feet_between,
    lengthened,
    slim_ring,
    smoothed,
)
from freecad_spiralpocket.engine.opening.groove import groove_levels, groove_path
from freecad_spiralpocket.engine.shapes.polyline import between, points_at
from freecad_spiralpocket.engine.shapes.skeleton import medial_axis, peel, without_spurs

R = 3.0
ANGLE = math.radians(5)
CHANNEL = Polygon([(0, 0), (90, 0), (90, 14), (0, 14)])
SHORT = Polygon([(0, 0), (19, 0), (19, 9), (0, 9)])
FORK = Polygon(
    [(0, 0), (90, 0), (90, 14), (52, 14), (52, 60), (38, 60), (38, 14), (0, 14)]
)  # a T upside down


def groove_in(region, bite=1.8):
    axis = medial_axis(region)
    edges = without_spurs(axis, peel(axis, 0.8), 1.6)
    branches, tips = lengthened(axis, edges, region, R)
    visited = slim_ring(branches, 0.48, region)
    rim = LineString(visited.exterior.coords)
    points = between(rim, rim.project(shapely.Point(tips[0])), rim.length)[:-1]
    ring = LineString(np.vstack([points, points[:1]]))
    others = sorted(ring.project(shapely.Point(t)) for t in tips[1:])
    feet, trunk = feet_between(ring, others, axis, edges)
    return Groove(points, tuple(others), tuple(feet), trunk, bite), visited


def deepest_bite(path, cell=0.25):
    """Return the largest height that stood under the cutter's center at any place of the path."""
    d = np.hypot(*np.diff(path[:, :2], axis=0).T)
    s = np.concatenate([[0], np.cumsum(d)])
    at = np.arange(0, s[-1], 0.1)
    x, y, z = (np.interp(at, s, path[:, i]) for i in range(3))
    low = path[:, :2].min(axis=0) - R
    shape = tuple(((path[:, :2].max(axis=0) + R - low) / cell).astype(int) + 2)
    floor = np.zeros(shape)
    gx, gy = np.meshgrid(
        *(low[i] + cell * (np.arange(shape[i]) + 0.5) for i in (0, 1)), indexing="ij"
    )
    bite = 0.0
    for px, py, pz in zip(x, y, z, strict=True):
        i, j = int((px - low[0]) / cell), int((py - low[1]) / cell)
        bite = max(bite, floor[i, j] - pz)
        a = slice(max(0, i - 13), i + 14), slice(max(0, j - 13), j + 14)
        under = np.hypot(gx[a] - px, gy[a] - py) <= R - cell
        floor[a] = np.where(under, np.minimum(floor[a], pz), floor[a])
    return bite


@pytest.mark.parametrize("region", [CHANNEL, FORK], ids=["channel", "fork"])
@pytest.mark.parametrize("depth", [1.0, 3.0, 5.0, 6.0])
def test_no_place_is_cut_deeper_than_the_bite_at_once(region, depth):
    groove, _ = groove_in(region)
    path = groove_path(groove, Descent(0.0, -depth, ANGLE))
    assert deepest_bite(path) <= groove.bite + 0.1


@pytest.mark.parametrize("region", [CHANNEL, FORK], ids=["channel", "fork"])
@pytest.mark.parametrize("depth", [1.0, 5.0, 6.0])
def test_whole_groove_is_at_the_bottom_at_the_end(region, depth):
    groove, visited = groove_in(region)
    path = groove_path(groove, Descent(0.0, -depth, ANGLE))
    level = path[:, 2] < -depth + 1e-9
    both = level[1:] & level[:-1]
    lines = shapely.linestrings(np.stack([path[:-1, :2][both], path[1:, :2][both]], axis=1))
    swept = shapely.union_all(lines).buffer(R)
    assert visited.difference(swept).area < 1e-3
    assert np.allclose(path[-1], (*groove.ring[0], -depth), atol=1e-6)


@pytest.mark.parametrize("region", [SHORT, CHANNEL, FORK], ids=["short", "channel", "fork"])
def test_ramps_are_no_steeper_than_asked(region):
    groove, _ = groove_in(region)
    path = groove_path(groove, Descent(0.0, -6.0, ANGLE))
    step = np.diff(path, axis=0)
    down = -step[:, 2]
    assert (down <= math.tan(ANGLE) * np.hypot(step[:, 0], step[:, 1]) + 1e-9).all()


def test_tree_takes_an_even_number_of_levels_and_a_line_as_few_as_it_needs():
    line, _ = groove_in(CHANNEL)
    tree, _ = groove_in(FORK)
    assert len(line.tips) == 1 and len(tree.tips) == 2 and len(tree.feet) == 1
    assert groove_levels(line, 5.0) == 3
    assert groove_levels(tree, 5.0) == 4


def test_foot_lies_at_the_junction():
    tree, _ = groove_in(FORK)
    ring = LineString(np.vstack([tree.ring, tree.ring[:1]]))
    foot = points_at(ring, np.array(tree.feet[0]))
    assert np.hypot(*(foot - (45, 7))) < 3.0


@pytest.mark.parametrize("region", [SHORT, FORK], ids=["short", "fork"])
def test_loops_at_the_tips_stay_in_the_groove(region):
    groove, visited = groove_in(region)
    path = groove_path(groove, Descent(0.0, -6.0, ANGLE))
    assert visited.buffer(0.05).covers(LineString(path[:, :2]))


def test_a_line_that_is_short_against_its_smoothing_takes_no_more_room_than_others():
    tracemalloc.start()
    points = smoothed(LineString([(0.0, 0.0), (1e-4, 0.0)]), R)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < 1e6
    assert points[[0, -1]].tolist() == [[0.0, 0.0], [1e-4, 0.0]]
