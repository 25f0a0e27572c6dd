# SPDX-License-Identifier: LGPL-2.1-or-later
"""The medial axis of a region, and the part of it that a slot should open.

The axis comes from the Voronoi diagram of boundary samples. It is peeled from
its tips inwards for as long as fronts that start at the remaining tip reach
everything peeled off within about as many steps as they need to the farthest
wall anyway: `reach`, the distance from the tip to the farthest place it serves,
stays below a share of the largest clearance. What remains is a point for a
compact region, a path for a long one, a tree for a branched one.
"""

from __future__ import annotations

import heapq
import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeAlias

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from ..model import Floats
from ..numerics.distinct import distinct_places
from ..numerics.graphs import delaunay_triangles, shortest_paths
from ..numerics.nearest import nearest
from .points import circumcenters
from .polyline import ring_samples
from .region import rings_of

#: Pairs of node indices.
Edges: TypeAlias = list[tuple[int, int]]

#: Boundary samples are this far apart at least and at most [mm], and about this many.
SAMPLE_MIN, SAMPLE_MAX, SAMPLES = 0.3, 2.0, 700
#: No more than about this many where narrow channels need more.
MOST = 6000
#: Each ring has so many at least.
FEWEST = 12
#: Corners of Voronoi cells closer than this are one [mm].
SAME_CORNER = 1e-6
#: A Voronoi edge belongs to the axis if the two samples that it parts are farther apart, along the
#: boundary, than this share of the clearance: blunter corners have no branch.
SPREAD = 0.6


@dataclass(frozen=True, slots=True, eq=False)
class Skeleton:
    """A graph in the plane.

    Attributes
    ----------
    nodes : ndarray of shape (n, 2)
        [mm]
    clearance : ndarray of shape (n,)
        Distance of each node to the boundary [mm].
    edges : ndarray of int, shape (m, 2)
    walls : ndarray of shape (m, 2, 2)
        The two places on the boundary that are nearest to each edge, one on either side [mm].
    """

    nodes: Floats
    clearance: Floats
    edges: NDArray[np.intp]
    walls: Floats

    @property
    def lengths(self) -> Floats:
        """Return the length of each edge, shape (m,) [mm]."""
        return np.hypot(*(self.nodes[self.edges[:, 0]] - self.nodes[self.edges[:, 1]]).T)


def medial_axis(region: Polygon, channel: float | None = None) -> Skeleton:
    """Return the medial axis of a region, without the branches to blunt corners.

    O(n log n) in the number of boundary samples.

    Parameters
    ----------
    region : shapely.Polygon
    channel : float, optional
        Channels of this length [mm] or more, all together, have an axis all along however narrow
        they are: their walls are sampled as finely.
    """
    spacing = float(np.clip(region.length / SAMPLES, SAMPLE_MIN, SAMPLE_MAX))
    axis, widths = _sampled_axis(region, spacing, channel)
    if channel is None or len(widths) < channel / spacing:
        return axis
    count = math.ceil(channel / spacing)
    finer = max(float(np.partition(widths, count - 1)[count - 1]), region.length / MOST)
    return _sampled_axis(region, finer, channel)[0] if finer < spacing else axis


def _sampled_axis(
    region: Polygon, spacing: float, channel: float | None
) -> tuple[Skeleton, Floats]:
    """Return the axis from samples so far apart, and about how wide channels are that it crosses.

    All in mm. No channel is where the way along the wall from one side to the other is shorter
    than twice its length; without one there are no widths.
    """
    rings = [ring_samples(r, spacing, FEWEST) for r in rings_of(region)]
    samples = np.vstack(rings)
    vertices, ridges, pairs = _voronoi(samples)
    inside = shapely.contains_xy(region, vertices[:, 0], vertices[:, 1])
    middle = vertices[ridges].mean(axis=1)
    clearance = np.hypot(*(middle - samples[pairs[:, 0]]).T)
    apart = _boundary_distances(rings, pairs) * spacing
    keep = inside[ridges].all(axis=1) & (apart > np.maximum(SPREAD * clearance, 1.5 * spacing))
    edges = ridges[keep]
    used, edges = np.unique(edges, return_inverse=True)
    nodes = vertices[used]
    axis = Skeleton(
        nodes,
        shapely.distance(region.boundary, shapely.points(nodes)),
        edges.reshape(-1, 2),
        samples[pairs[keep]],
    )
    across = pairs[apart >= (np.inf if channel is None else 2 * channel)]
    return axis, np.hypot(*(samples[across[:, 0]] - samples[across[:, 1]]).T)


def _voronoi(samples: Floats) -> tuple[Floats, NDArray[np.intp], NDArray[np.intp]]:
    """Return the Voronoi diagram of points, without the edges that go to infinity.

    Returns
    -------
    corners : ndarray of shape (v, 2)
    edges : ndarray of int, shape (e, 2)
        Of two corners each.
    pairs : ndarray of int, shape (e, 2)
        The two samples that each edge parts.
    """
    triangles = delaunay_triangles(samples)
    sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    order = np.lexsort(sides.T)
    twice = np.flatnonzero((np.diff(sides[order], axis=0) == 0).all(axis=1))
    pairs = sides[order[twice]]
    edges = np.column_stack([order[twice], order[twice + 1]]) // 3
    # three samples in line have their center far outside
    centers = circumcenters(*(samples[triangles[:, i]] for i in range(3)))
    # samples on one circle share their corner
    first, corner = distinct_places(np.round(centers / SAME_CORNER))
    edges = corner[edges]
    real = edges[:, 0] != edges[:, 1]
    return centers[first], edges[real], pairs[real]


def _boundary_distances(rings: list[Floats], pairs: NDArray[np.intp]) -> Floats:
    """Return how many samples apart the two of each pair are along the boundary, shape (m,)."""
    counts = np.array([len(r) for r in rings])
    ring = np.repeat(np.arange(len(rings)), counts)
    around = counts[ring[pairs[:, 0]]]
    steps = np.abs(pairs[:, 0] - pairs[:, 1])
    same = ring[pairs[:, 0]] == ring[pairs[:, 1]]
    return np.where(same, np.minimum(steps, around - steps), np.inf)


def peel(axis: Skeleton, share: float) -> Edges:
    """Peel the axis from its tips and return the edges that remain.

    Parameters
    ----------
    axis : Skeleton
    share : float
        Tips are peeled while their reach is below this share of the largest clearance.

    Returns
    -------
    list of (int, int)
        Node indices; empty for a compact region.
    """
    neighbors: dict[int, dict[int, float]] = {}
    for a, b in axis.edges.tolist():
        length = float(np.hypot(*(axis.nodes[a] - axis.nodes[b])))
        neighbors.setdefault(a, {})[b] = length
        neighbors.setdefault(b, {})[a] = length
    reach = axis.clearance.copy()
    limit = share * float(axis.clearance.max(initial=0.0))
    tips = [(reach[n], n) for n, near in neighbors.items() if len(near) == 1]
    heapq.heapify(tips)
    while tips:
        _, tip = heapq.heappop(tips)
        if len(neighbors.get(tip, ())) != 1:
            continue
        ((inner, length),) = neighbors[tip].items()
        if reach[tip] + length > limit:
            continue
        reach[inner] = max(reach[inner], reach[tip] + length)
        del neighbors[tip], neighbors[inner][tip]
        if len(neighbors[inner]) == 1:
            heapq.heappush(tips, (reach[inner], inner))
    return [(a, b) for a, near in neighbors.items() for b in near if a < b]


def without_spurs(axis: Skeleton, edges: Edges, share: float) -> Edges:
    """Return the edges without the branches that end short of the junction they leave.

    Those are the forks into the corners of a blunt end. The shortest goes first, because what
    was a junction may be a bend afterwards.

    Parameters
    ----------
    axis : Skeleton
    edges : list of (int, int)
    share : float
        Shortest branch that stays, over the clearance of its junction.
    """
    neighbors = neighbors_of(edges)
    while spurs := spurs_of(axis, neighbors, share):
        for a, b in pairwise(spurs[0]):
            neighbors[a].discard(b)
            neighbors[b].discard(a)
    return [(a, b) for a, near in neighbors.items() for b in near if a < b]


def neighbors_of(edges: Edges) -> dict[int, set[int]]:
    """Return the nodes beside each node."""
    neighbors: dict[int, set[int]] = {}
    for a, b in edges:
        neighbors.setdefault(a, set()).add(b)
        neighbors.setdefault(b, set()).add(a)
    return neighbors


def spurs_of(axis: Skeleton, neighbors: dict[int, set[int]], share: float) -> list[list[int]]:
    """Return the nodes of the branches that end short of their junction, the shortest first.

    Each from its tip; `neighbors` are those of all nodes, `share` is as in `without_spurs`.
    """
    spurs = []
    for tip in (node for node, near in neighbors.items() if len(near) == 1):
        branch = [tip, *neighbors[tip]]
        while len(neighbors[branch[-1]]) == 2:
            (ahead,) = neighbors[branch[-1]] - {branch[-2]}
            branch.append(ahead)
        length = float(np.hypot(*np.diff(axis.nodes[branch], axis=0).T).sum())
        if len(neighbors[branch[-1]]) > 2 and length < share * axis.clearance[branch[-1]]:
            spurs.append((length, branch))
    return [branch for _, branch in sorted(spurs, key=lambda spur: spur[0])]


def longest_path(axis: Skeleton, edges: Edges) -> Floats:
    """Return the longest shortest path along `edges`, shape (k, 2) [mm]; empty if there is none."""
    return axis.nodes[longest_route(axis, np.array(edges, np.intp).reshape(-1, 2))]


def longest_edges(axis: Skeleton, edges: Edges) -> Edges:
    """Return the edges of the longest shortest path along `edges`."""
    route = longest_route(axis, np.array(edges, np.intp).reshape(-1, 2))
    return list(pairwise(route.tolist()))


def longest_route(axis: Skeleton, edges: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return the nodes along the longest shortest path; empty if there are no edges.

    Parameters
    ----------
    axis : Skeleton
    edges : ndarray of int, shape (m, 2)
        Connected.
    """
    if len(edges) == 0:
        return np.empty(0, np.intp)
    used, index, lengths = _graph(axis, edges)

    def farthest(start: int) -> tuple[int, NDArray[np.intp]]:
        distances, before = shortest_paths(index, lengths, start)
        distances[~np.isfinite(distances)] = -1.0
        return int(np.argmax(distances)), before

    one, _ = farthest(0)
    other, before = farthest(one)
    path = [other]
    while path[-1] != one:
        path.append(int(before[path[-1]]))
    return np.asarray(used[path])


def distances_from(axis: Skeleton, edges: Edges, place: Floats) -> tuple[Floats, Floats]:
    """Return the nodes of `edges` and how far each is along them from the one nearest to `place`.

    Returns
    -------
    nodes : ndarray of shape (n, 2)
    distances : ndarray of shape (n,)
        [mm]
    """
    used, index, lengths = _graph(axis, np.array(edges, np.intp).reshape(-1, 2))
    nodes = axis.nodes[used]
    start = int(nearest(nodes, np.array(place).reshape(1, 2))[1][0])
    return nodes, shortest_paths(index, lengths, start)[0]


def _graph(
    axis: Skeleton, edges: NDArray[np.intp]
) -> tuple[NDArray[np.intp], NDArray[np.intp], Floats]:
    """Return the indices of the nodes of `edges`, shape (n,), the edges between these, lengths."""
    used, index = np.unique(edges, return_inverse=True)
    index = index.reshape(-1, 2)
    nodes = axis.nodes[used]
    return used, index, np.hypot(*(nodes[index[:, 0]] - nodes[index[:, 1]]).T)
