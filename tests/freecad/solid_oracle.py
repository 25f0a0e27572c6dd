# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands of an operation do to a solid, in three dimensions.

A slow second opinion on the engine's proof, which sees sections only. The solid
becomes triangles, the path a cutter that stands in many places along FreeCAD's commands.
A flat cutter gouges where anything of the solid stands above its end: under an overhang
too. What is left of the stock is a raster of heights.
"""

import math

import numpy as np
import shapely
from scipy import ndimage

#: The solid's triangles are off by this at most [mm].
SAG = 0.004


class Surface:
    """The highest points of a solid.

    Parameters
    ----------
    triangles : ndarray of shape (n, 3, 3)
        [mm]
    """

    def __init__(self, triangles):
        a, b, c = np.moveaxis(triangles, 1, 0)
        self._twice = _cross((b - a)[:, :2], (c - a)[:, :2])
        flat = np.abs(self._twice) > 1e-9
        self._triangles, self._twice = triangles[flat], self._twice[flat]
        low, high = self._triangles.min(axis=1), self._triangles.max(axis=1)
        self._tree = shapely.STRtree(shapely.box(*low[:, :2].T, *high[:, :2].T))

    @classmethod
    def of(cls, shape):
        """Return the surface of a `Part.Shape`."""
        corners, index = shape.tessellate(SAG)
        return cls(np.array([tuple(c) for c in corners])[np.array(index)])

    def above(self, z):
        """Return what is not wholly at or below Z `z`: there many triangles lie side by side."""
        return Surface(self._triangles[self._triangles[:, :, 2].max(axis=1) > z])

    def heights(self, points):
        """Return the highest Z of the solid at each of `points`, (n, 2); -inf beside it."""
        top = np.full(len(points), -np.inf)
        for start in range(0, len(points), 200_000):
            part = points[start : start + 200_000]
            row, tri = self._tree.query(shapely.points(part))
            a, b, c = np.moveaxis(self._triangles[tri], 1, 0)
            p = part[row]
            u = _cross((b - a)[:, :2], p - a[:, :2]) / self._twice[tri]
            v = _cross(p - a[:, :2], (c - a)[:, :2]) / self._twice[tri]
            hit = (u > -1e-9) & (v > -1e-9) & (u + v < 1 + 1e-9)
            z = a[:, 2] + v * (b - a)[:, 2] + u * (c - a)[:, 2]
            np.maximum.at(top, row[hit] + start, z[hit])
        return top


def places(commands, step):
    """Return cutter positions (n, 3) along commands, `step` [mm] apart, from the first XY on."""
    here, points = None, []
    for command in commands:
        words = command.Parameters
        if command.Name.startswith("(") or not {"X", "Y", "Z"} <= set(words):
            continue
        there = np.array([words["X"], words["Y"], words["Z"]])
        if here is None:
            here = there
        spoke, sweep = None, 0.0
        if command.Name in ("G2", "G3"):
            center = here[:2] + np.array([words["I"], words["J"]])
            spoke = here[:2] - center
            turn = math.atan2(*(there[:2] - center)[::-1]) - math.atan2(*spoke[::-1])
            sweep = turn % (2 * math.pi)
            sweep = sweep if command.Name == "G3" else sweep - 2 * math.pi
        length = np.linalg.norm(there - here) if spoke is None else abs(sweep) * np.hypot(*spoke)
        share = np.linspace(0, 1, max(2, math.ceil(length / step) + 1))[1:, None]
        line = here + share * (there - here)
        if spoke is not None:
            turns = math.atan2(*spoke[::-1]) + share[:, 0] * sweep
            line[:, :2] = center + np.hypot(*spoke) * np.c_[np.cos(turns), np.sin(turns)]
        points.append(line)
        here = there
    return np.concatenate(points)


def gouges(surface, centers, radius, depth):
    """Return the centers (n, 3) from which the cutter reaches deeper than `depth` into the solid.

    Looked at in points on the edge of the cutter's end, less `depth` all around.
    """
    turns = np.arange(0, 2 * math.pi, math.pi / 20)
    spokes = np.c_[np.cos(turns), np.sin(turns)]
    rim = centers[:, None, :2] + (radius - depth) * spokes
    high = surface.above(centers[:, 2].min() + depth)
    top = high.heights(rim.reshape(-1, 2)).reshape(len(centers), -1).max(axis=1)
    return centers[top > centers[:, 2] + depth]


class Stock:
    """Stock over a solid as a raster of heights, cut from the top.

    Parameters
    ----------
    surface : Surface
    bounds : tuple of float
        xmin, ymin, xmax, ymax [mm].
    pixel, top : float
        [mm]
    """

    def __init__(self, surface, bounds, pixel, top=0.0):
        self.pixel = pixel
        self.x = np.arange(bounds[0], bounds[2], pixel) + pixel / 2
        self.y = np.arange(bounds[1], bounds[3], pixel) + pixel / 2
        grid = np.stack(np.meshgrid(self.x, self.y), axis=-1)
        self.part = surface.heights(grid.reshape(-1, 2)).reshape(grid.shape[:2])
        self.heights = np.full(self.part.shape, float(top))

    def cut(self, centers, radius):
        """Cut with a flat cutter at `centers`, (n, 3) [mm]."""
        for x, y, z in centers:
            i = slice(*np.searchsorted(self.x, (x - radius, x + radius)))
            j = slice(*np.searchsorted(self.y, (y - radius, y + radius)))
            under = (self.x[None, i] - x) ** 2 + (self.y[j, None] - y) ** 2 <= radius**2
            part = self.heights[j, i]
            part[under & (part > z)] = z

    @property
    def left(self):
        """Return how high stock stands above the solid, in each pixel [mm]."""
        return self.heights - self.part

    def width_left(self, z):
        """Return how far stock at Z `z` reaches from ground that is cut lower [mm]."""
        standing = (self.heights > z) & (self.part < z)
        distance = ndimage.distance_transform_edt(self.heights > z) * self.pixel
        return float(distance[standing].max(initial=0.0))


def _cross(a, b):
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
