# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the centers of spirals hang together, and in which order they are visited.

Pieces of the medial axis are joined one after the other by the shortest way along
the axis to any that is joined already. That makes a tree: opened as one slot it
leads from every center to every other, and its branches are the connected pairs of
[EAS07, section 5]. The order is a shortest walk over that graph, by a beam search.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from ..shapes.skeleton import Skeleton

#: So many of the shortest unfinished orders are kept.
BEAM = 64


@dataclass(frozen=True, slots=True, eq=False)
class Joint:
    """A way along the axis between two pieces.

    Attributes
    ----------
    one, other : int
        Of which pieces.
    nodes : ndarray of int
        Of the axis.
    length : float
        [mm]
    """

    one: int
    other: int
    nodes: NDArray[np.intp]
    length: float


def joined(axis: Skeleton, pieces: Sequence[NDArray[np.intp]]) -> list[Joint]:
    """Return the ways that join pieces to a tree; pieces that the axis does not reach are left out.

    Parameters
    ----------
    axis : Skeleton
    pieces : sequence of ndarray of int
        Nodes of each.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    n = len(axis.nodes)
    lengths = np.maximum(axis.lengths, 1e-9)
    graph = coo_array((lengths, tuple(axis.edges.T)), shape=(n, n)).tocsr()
    owner = np.full(n, -1)
    owner[pieces[0]] = 0
    waiting = set(range(1, len(pieces)))
    joints = []
    while waiting:
        distance, before, _ = dijkstra(
            graph,
            directed=False,
            indices=np.flatnonzero(owner >= 0),
            return_predecessors=True,
            min_only=True,
        )
        nearest, piece = min((float(distance[pieces[i]].min()), i) for i in waiting)
        waiting.remove(piece)
        if not np.isfinite(nearest):
            continue
        route = [int(pieces[piece][int(np.argmin(distance[pieces[piece]]))])]
        while before[route[-1]] >= 0:
            route.append(int(before[route[-1]]))
        joints.append(Joint(int(owner[route[-1]]), piece, np.array(route), nearest))
        owner[route] = np.where(owner[route] >= 0, owner[route], piece)
        owner[pieces[piece]] = piece
    return joints


def walk_over(
    joints: Sequence[Joint], visited: Sequence[int], middles: Floats, axis: Skeleton
) -> list[int]:
    """Return the order of a shortest walk over the tree that visits some of its pieces.

    Parameters
    ----------
    joints : sequence of Joint
    visited : sequence of int
        The pieces to visit, at least one.
    middles : ndarray of shape (n, 2)
        A middle of each piece: the way across a piece counts from there, and from joint to
        joint, as the crow flies [mm].
    axis : Skeleton
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import shortest_path

    n = len(middles)
    gates = np.array([axis.nodes[j.nodes[i]] for j in joints for i in (-1, 0)]).reshape(-1, 2)
    places = np.vstack([middles, gates])
    piece = np.array([*range(n), *(p for j in joints for p in (j.one, j.other))])
    a, b = np.nonzero(np.triu(piece[:, None] == piece[None, :], 1))
    cost = np.hypot(*(places[a] - places[b]).T) + 1e-9
    across = n + 2 * np.arange(len(joints))
    a, b = np.concatenate([a, across]), np.concatenate([b, across + 1])
    cost = np.concatenate([cost, [j.length for j in joints]])
    graph = coo_array((cost, (a, b)), shape=(len(places),) * 2).tocsr()
    apart = shortest_path(graph, directed=False)
    beam: list[tuple[float, tuple[int, ...]]] = [(0.0, (i,)) for i in visited]
    for _ in range(len(visited) - 1):
        longer = [
            (length + float(apart[order[-1], i]), (*order, i))
            for length, order in beam
            for i in visited
            if i not in order
        ]
        beam = sorted(longer)[:BEAM]
    return list(beam[0][1])
