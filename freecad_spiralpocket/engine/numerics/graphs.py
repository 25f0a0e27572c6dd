# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shortest paths and spanning trees of graphs, and triangles between points."""

from __future__ import annotations

import heapq

import numpy as np
import shapely
from numpy.typing import NDArray

from ..model import Floats
from .distinct import distinct_places


def shortest_paths(
    edges: NDArray[np.intp], lengths: Floats, source: int
) -> tuple[Floats, NDArray[np.intp]]:
    """Return how far each node is from `source`, and the node before it on the way.

    Parameters
    ----------
    edges : ndarray of int, shape (m, 2)
        Nodes are numbered from 0 on.
    lengths : ndarray of shape (m,)
        0 or more.

    Returns
    -------
    distances : ndarray of shape (n,)
        Infinite where no way leads.
    before : ndarray of int, shape (n,)
        -1 at the source and where no way leads.

    Notes
    -----
    O(m log n).
    """
    count = int(edges.max(initial=source)) + 1
    neighbors: list[list[tuple[int, float]]] = [[] for _ in range(count)]
    for (a, b), length in zip(edges.tolist(), lengths.tolist(), strict=True):
        neighbors[a].append((b, length))
        neighbors[b].append((a, length))
    distances, before = [np.inf] * count, [-1] * count
    distances[source] = 0.0
    heap = [(0.0, source)]
    while heap:
        gone, node = heapq.heappop(heap)
        if gone > distances[node]:
            continue
        for other, length in neighbors[node]:
            if gone + length < distances[other]:
                distances[other], before[other] = gone + length, node
                heapq.heappush(heap, (gone + length, other))
    return np.array(distances), np.array(before, np.intp)


def spanning_tree(count: int, edges: NDArray[np.intp], lengths: Floats) -> NDArray[np.intp]:
    """Return the edges of the shortest tree (of several, the forest) that spans `count` nodes.

    Parameters
    ----------
    count : int
        Nodes are numbered from 0.
    edges : ndarray of int, shape (m, 2)
        The nodes that each joins.
    lengths : ndarray of shape (m,)
        Of edges, of any sign; equal to 1e-6 are ties, which the first wins.

    Returns
    -------
    ndarray of int, shape (k, 2)
        Some of `edges`, in their order.
    """
    root = list(range(count))
    taken = []
    for i in np.argsort(lengths.round(6), kind="stable").tolist():
        a, b = (root_of(root, int(node)) for node in edges[i])
        if a != b:
            root[a] = b
            taken.append(i)
    return edges[np.sort(np.array(taken, np.intp))]


def root_of(parents: list[int] | dict[int, int], node: int) -> int:
    """Return the root of the tree that a node is in; what is passed comes nearer to it.

    `parents` has the parent of each node, roots being their own.
    """
    while parents[node] != node:
        parents[node] = node = parents[parents[node]]
    return node


def delaunay_triangles(points: Floats) -> NDArray[np.intp]:
    """Return the triangles of a Delaunay triangulation, shape (m, 3), as indices of points.

    Of points at the same place only the first is used; there are none if all are in line.
    """
    try:
        parts = shapely.delaunay_triangles(shapely.multipoints(points))
    except shapely.GEOSException:
        # GEOS now and then does not find its way; Qhull always does, but takes long to load
        from scipy.spatial import Delaunay

        return Delaunay(points).simplices.astype(np.intp)
    corners = shapely.get_coordinates(shapely.get_parts(parts)).reshape(-1, 4, 2)[:, :3]
    first, same = distinct_places(np.vstack([points, corners.reshape(-1, 2)]))
    return first[same[len(points) :]].reshape(-1, 3)
