# SPDX-License-Identifier: LGPL-2.1-or-later
"""Joints: pieces of the medial axis are joined by the shortest ways and visited on a short walk."""

from __future__ import annotations

import itertools

import numpy as np

from freecad_spiralpocket.engine.middle_line.joints import joined, walk_over
from freecad_spiralpocket.engine.shapes.skeleton import Skeleton


def row(count: int) -> Skeleton:
    """Return an axis of nodes 1 mm apart along X."""
    nodes = np.column_stack([np.arange(count, dtype=float), np.zeros(count)])
    edges = np.column_stack([np.arange(count - 1), np.arange(1, count)])
    return Skeleton(nodes, np.ones(count), edges, np.zeros((count - 1, 2, 2)))


def test_pieces_in_a_row_are_joined_to_their_neighbors():
    pieces = [np.array([5, 6]), np.array([0, 1, 2]), np.array([10, 11])]
    joints = joined(row(12), pieces)
    assert sorted((j.one, j.other) for j in joints) == [(0, 1), (0, 2)]
    assert sorted(j.length for j in joints) == [3.0, 4.0]
    for joint in joints:
        assert joint.nodes[0] in pieces[joint.other]
        assert joint.nodes[-1] in pieces[joint.one]


def test_piece_that_the_axis_does_not_reach_is_left_out():
    axis = row(8)
    broken = Skeleton(axis.nodes, axis.clearance, np.delete(axis.edges, 3, axis=0), axis.walls)
    assert joined(broken, [np.array([0]), np.array([7])]) == []


def test_walk_is_the_shortest_of_all_orders():
    axis = row(60)
    starts = [30, 2, 50, 12, 40]
    pieces = [np.arange(s, s + 4) for s in starts]
    middles = np.array([axis.nodes[p].mean(axis=0) for p in pieces])
    found = walk_over(joined(axis, pieces), range(5), middles, axis)

    def length(order) -> float:
        return float(np.abs(np.diff(middles[list(order), 0])).sum())

    assert length(found) == min(length(order) for order in itertools.permutations(range(5)))


def test_single_piece_is_its_own_walk():
    assert walk_over([], [0], np.zeros((1, 2)), row(3)) == [0]
