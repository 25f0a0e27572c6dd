# SPDX-License-Identifier: LGPL-2.1-or-later
"""Air beside the stock: ground that is free before any motion.

The stock's outline is convex, so what lies outside of it is a union of half planes, one beyond
each of its sides. Each takes one interval of the cutter's rim, known in closed form.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon
from shapely.geometry.polygon import orient

from .model import Floats

#: Samples that are compared with all sides at once.
PORTION = 20_000


def intervals_in_air(
    centers: Floats, headings: Floats, stock: Polygon, r: float
) -> tuple[NDArray[np.int64], Floats, Floats]:
    """Return the rim intervals outside of the stock.

    Parameters
    ----------
    centers : ndarray of shape (k, 2)
        Cutter centers [mm].
    headings : ndarray of shape (k,)
        Directions of travel there [rad].
    stock : shapely.Polygon
        Convex.
    r : float
        Cutter radius [mm].

    Returns
    -------
    rims : ndarray of int, shape (m,)
        Number of the center.
    low, high : ndarray of shape (m,)
        From the heading [rad].
    """
    corners = shapely.get_coordinates(orient(stock).exterior)
    side = np.diff(corners, axis=0)
    proper = np.hypot(*side.T) > 0
    side, corners = side[proper], corners[:-1][proper]
    bearing = np.arctan2(-side[:, 0], side[:, 1])  # to the right of a side is outside
    outward = np.column_stack([np.cos(bearing), np.sin(bearing)])
    offset = (outward * corners).sum(axis=1)
    found = []
    for first in range(0, len(centers), PORTION):
        inside = (offset - centers[first : first + PORTION] @ outward.T) / r
        rim, which = np.nonzero(inside < 1)
        half = np.arccos(np.clip(inside[rim, which], -1.0, 1.0))
        middle = bearing[which] - headings[first + rim]
        found.append((first + rim, middle - half, middle + half))
    if not found:
        return np.zeros(0, np.int64), np.zeros(0), np.zeros(0)
    rims, low, high = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return rims, low, high


def are_in_stock(points: Floats, stock: Polygon | None) -> NDArray[np.bool_]:
    """Return which points, shape (n, 2) [mm], lie in the stock; None: it is everywhere."""
    if stock is None:
        return np.ones(len(points), dtype=bool)
    return np.asarray(shapely.contains_xy(stock, points))
