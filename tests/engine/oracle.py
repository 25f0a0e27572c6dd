# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slow second oracles of what a path cuts: no intervals, no polygons, no search trees.

`Bitmap` simulates the stock as heights of pixels, as the cutter comes by in small
steps. `rim_engagement` looks up every rim point among all earlier cutter positions.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_spiralpocket.engine.toolpath import Kind, Toolpath


def walk(path: Toolpath, step: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return cutter centers (n, 3) along all moves, headings (n,) and the move of each (n,)."""
    points, headings, moves = [], [], []
    starts, sweeps = path.starts, path.sweeps
    for i, kind in enumerate(path.kinds):
        a, b = starts[i], path.points[i]
        n = max(2, math.ceil(path.lengths[i] / step))
        f = np.arange(1, n + 1) / n
        xyz = a + f[:, None] * (b - a)
        heading = np.full(n, math.atan2(b[1] - a[1], b[0] - a[0]))
        if kind >= Kind.ARC_CW:
            spoke = a[:2] - path.centers[i]
            turn = math.atan2(spoke[1], spoke[0]) + f * sweeps[i]
            around = np.column_stack([np.cos(turn), np.sin(turn)])
            xyz[:, :2] = path.centers[i] + math.hypot(*spoke) * around
            heading = turn + math.copysign(math.pi / 2, sweeps[i])
        points.append(xyz)
        headings.append(heading)
        moves.append(np.full(n, i))
    return np.concatenate(points), np.concatenate(headings), np.concatenate(moves)


def rim_engagement(
    earlier: np.ndarray,
    center: np.ndarray,
    heading: float,
    radius: float,
    axial_depth: float,
    rims: int = 360,
) -> float:
    """Return the engagement angle [rad] after the cutter was at `earlier` (n, 3) positions.

    The stock's top is at Z 0; rim points count by the share of the axial depth that stands.
    """
    turn = heading + (np.arange(rims) + 0.5) * math.pi / rims - math.pi / 2
    rim = center[:2] + radius * np.column_stack([np.cos(turn), np.sin(turn)])
    near = earlier[np.hypot(*(earlier - center).T[:2]) <= 2 * radius]
    offset = rim[:, None, :] - near[None, :, :2]
    covered = np.hypot(offset[:, :, 0], offset[:, :, 1]) <= radius + 1e-7
    height = np.where(covered, near[None, :, 2], 0.0).min(axis=1, initial=0.0)
    return math.pi * float(np.mean(np.clip((height - center[2]) / axial_depth, 0.0, 1.0)))


class Bitmap:
    """Stock as a grid of heights, solid beyond its edges.

    Parameters
    ----------
    bounds : tuple of float
        xmin, ymin, xmax, ymax [mm].
    pixel : float
        [mm]
    top : float
        Height of the stock [mm].
    """

    def __init__(self, bounds: tuple, pixel: float, top: float) -> None:
        self.pixel, self.top = pixel, top
        self.x = np.arange(bounds[0], bounds[2], pixel) + pixel / 2
        self.y = np.arange(bounds[1], bounds[3], pixel) + pixel / 2
        self.heights = np.full((len(self.y), len(self.x)), top)

    def cut(self, center: np.ndarray, radius: float) -> None:
        """Lower all pixels under the cutter at `center` (x, y, z)."""
        i = slice(*np.searchsorted(self.x, (center[0] - radius, center[0] + radius)))
        j = slice(*np.searchsorted(self.y, (center[1] - radius, center[1] + radius)))
        inside = (self.x[None, i] - center[0]) ** 2 + (self.y[j, None] - center[1]) ** 2
        part = self.heights[j, i]
        part[(inside <= radius * radius) & (part > center[2])] = center[2]

    def engagement(
        self, center: np.ndarray, heading: float, radius: float, axial_depth: float
    ) -> float:
        """Return the engagement [rad] with the stock as it is: rim points weighted by height."""
        turn = heading + (np.arange(360) + 0.5) * math.pi / 360 - math.pi / 2
        # just outside the rim: the pixels under it have been cut on the way here
        reach = radius + 0.75 * self.pixel
        i = np.searchsorted(self.x, center[0] + reach * np.cos(turn) - self.pixel / 2)
        j = np.searchsorted(self.y, center[1] + reach * np.sin(turn) - self.pixel / 2)
        share = (self.heights[j, i] - center[2]) / axial_depth
        return math.pi * float(np.mean(np.clip(share, 0.0, 1.0)))

    def standing_area(self, floor: float, inside: np.ndarray) -> float:
        """Return the area [mm2] above `floor` of the pixels chosen by a mask."""
        return float(np.sum(inside & (self.heights > floor + 1e-6))) * self.pixel**2
