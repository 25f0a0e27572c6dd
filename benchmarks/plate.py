# SPDX-License-Identifier: LGPL-2.1-or-later
"""The heated plate as HQS24 solves it: linear elements on an unstructured mesh, raw contours.

Only for comparison: the product solves it on a grid (engine/heat/poisson.py).
"""

from __future__ import annotations

import math

import numpy as np
import shapely
from matplotlib.figure import Figure
from matplotlib.tri import Triangulation
from scipy.sparse import coo_array
from scipy.sparse.linalg import spsolve
from scipy.spatial import Delaunay
from shapely import Polygon
from shapely.geometry.polygon import orient

#: About as many nodes as the paper's.
NODES = 12_000
#: Nodes are moved at random by up to this share of their distance.
JITTER = 0.25
SEED = 24


def mesh(region: Polygon) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return nodes (n, 2), triangles (t, 3) and which nodes are on the wall."""
    pitch = math.sqrt(region.area / NODES * 2 / math.sqrt(3))
    rings = (region.exterior, *region.interiors)
    wall = []
    for ring in rings:
        count = math.ceil(ring.length / pitch)
        at = np.arange(count) * ring.length / count
        wall.append(shapely.get_coordinates(shapely.line_interpolate_point(ring, at)))
    x0, y0, x1, y1 = region.bounds
    rows = np.arange(y0, y1, pitch * math.sqrt(3) / 2)
    columns = np.arange(x0, x1 + pitch, pitch)
    x, y = np.meshgrid(columns, rows)
    x = x + (np.arange(len(rows))[:, None] % 2) * pitch / 2
    inner = np.column_stack([x.ravel(), y.ravel()])
    random = np.random.default_rng(SEED)
    inner = inner + pitch * JITTER * (2 * random.random(inner.shape) - 1)
    room = region.buffer(-0.6 * pitch)
    inner = inner[shapely.contains_xy(room, inner[:, 0], inner[:, 1])]
    nodes = np.vstack([*wall, inner])
    triangles = Delaunay(nodes).simplices
    middle = nodes[triangles].mean(axis=1)
    triangles = triangles[shapely.contains_xy(region, middle[:, 0], middle[:, 1])]
    return nodes, triangles, np.arange(len(nodes)) < sum(len(w) for w in wall)


def temperatures(nodes: np.ndarray, triangles: np.ndarray, wall: np.ndarray) -> np.ndarray:
    """Return the solution of ``-div(grad T) = 1``, T = 0 on the wall, with linear elements."""
    a, b, c = (nodes[triangles[:, i]] for i in range(3))
    area = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    edges = np.stack([c - b, a - c, b - a], axis=1)
    local = np.einsum("tic,tjc->tij", edges, edges) / (4 * np.abs(area))[:, None, None]
    count = len(nodes)
    rows, columns = np.repeat(triangles, 3, axis=1).ravel(), np.tile(triangles, 3).ravel()
    matrix = coo_array((local.ravel(), (rows, columns)), shape=(count, count)).tocsr()
    load = np.bincount(triangles.ravel(), np.repeat(np.abs(area) / 3, 3), count)
    free = np.flatnonzero(~wall)
    found = np.zeros(count)
    found[free] = spsolve(matrix[free][:, free].tocsc(), load[free])
    return found


class PlateContours:
    """Contours of linear elements in a region without islands, as `contourpy` gives them."""

    def __init__(self, region: Polygon) -> None:
        nodes, triangles, wall = mesh(region)
        self.count = len(nodes)
        self._values = temperatures(nodes, triangles, wall)
        self._mesh = Triangulation(*nodes.T, triangles)
        self._axes = Figure().add_subplot()

    def lines(self, level: float) -> list[np.ndarray]:
        """Return the closed contours at a level, counter-clockwise, as they come."""
        drawn = self._axes.tricontour(self._mesh, self._values, levels=[level])
        found = [np.asarray(s) for s in drawn.allsegs[0] if len(s) > 3]
        drawn.remove()
        return [np.asarray(orient(Polygon(ring)).exterior.coords) for ring in found]
