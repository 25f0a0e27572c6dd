# SPDX-License-Identifier: LGPL-2.1-or-later
"""Air: ground that is free before any motion, beside the stock and where it was cleared before.

What was cleared before may differ from level to level: `Stock` has a layer for each.
Where the cutter's rim crosses the edge of the stock it passes from one to the other; between two
crossings all of it is in the stock or all of it in the air. The crossings are exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from ..levels import Level
from ..model import Floats
from ..shapes.points import cross
from ..shapes.shaping import Region, edges_of
from .swept import SAME_HEIGHT

#: Centers that are compared with all edges at once.
PORTION = 20_000


@dataclass(frozen=True, slots=True, eq=False)
class Stock:
    """Where material stands before the first move.

    Attributes
    ----------
    bottoms : ndarray of shape (n,)
        Z of the layers, highest first [mm]. Each goes up to the one above it, the highest for ever;
        below the lowest it is as in that.
    regions : tuple of shapely.Polygon, MultiPolygon or None, n of them
        What stands in each; None: all.
    """

    bottoms: Floats
    regions: tuple[Region | None, ...]

    @classmethod
    def of(cls, region: Region | None) -> Stock:
        """Return stock that is the same at all heights; None: it is everywhere."""
        return cls(np.array([-np.inf]), (region,))

    @classmethod
    def at_levels(cls, levels: Sequence[Level]) -> Stock:
        """Return the stock that stands at levels, highest first; those alike are one layer."""
        below = [*levels[1:], None]
        last = [
            a for a, b in zip(levels, below, strict=True) if b is None or a.stock is not b.stock
        ]
        return cls(np.array([each.bottom for each in last]), tuple(each.stock for each in last))

    def layers(self, heights: Floats) -> NDArray[np.intp]:
        """Return the numbers of the layers in which heights lie, shape (k,) [mm]."""
        above = np.searchsorted(-self.bottoms, -(heights + SAME_HEIGHT))
        return np.minimum(above, len(self.regions) - 1)

    def at(self, height: float) -> Region | None:
        """Return what stands at a height [mm]."""
        return self.regions[self.layers(np.array([height]))[0]]

    def in_air(
        self, points: Floats, headings: Floats, r: float
    ) -> tuple[NDArray[np.int64], Floats, Floats]:
        """Return the rim intervals outside of the stock at the height of each center.

        Parameters and what is returned are those of `intervals_in_air`; `points` are of shape
        (k, 3) [mm].
        """
        layers = self.layers(points[:, 2])
        found = [(np.zeros(0, np.int64), np.zeros(0), np.zeros(0))]
        for number, region in enumerate(self.regions):
            here = np.flatnonzero(layers == number)
            if region is not None and len(here):
                rims, low, high = intervals_in_air(points[here, :2], headings[here], region, r)
                found.append((here[rims], low, high))
        rims, low, high = (np.concatenate(parts) for parts in zip(*found, strict=True))
        return rims, low, high


#: There is stock wherever nothing was cut.
EVERYWHERE = Stock.of(None)


def intervals_in_air(
    centers: Floats, headings: Floats, stock: Region, r: float
) -> tuple[NDArray[np.int64], Floats, Floats]:
    """Return the rim intervals outside of the stock.

    Parameters
    ----------
    centers : ndarray of shape (k, 2)
        Cutter centers [mm].
    headings : ndarray of shape (k,)
        Directions of travel there [rad].
    stock : shapely.Polygon or MultiPolygon
    r : float
        Cutter radius [mm].

    Returns
    -------
    rims : ndarray of int, shape (m,)
        Number of the center.
    low, high : ndarray of shape (m,)
        From the heading [rad].
    """
    starts, ends = edges_of(stock)
    tree = shapely.STRtree(shapely.linestrings(np.stack([starts, ends], axis=1)))
    shapely.prepare(stock)
    found = []
    for first in range(0, len(centers), PORTION):
        here = centers[first : first + PORTION]
        rim, edge = tree.query(shapely.points(here), predicate="dwithin", distance=r)
        which, angle = _crossings(here[rim], starts[edge], ends[edge], r)
        rim = rim[which]
        # rims that cross no edge are one interval all around
        whole = np.setdiff1d(np.arange(len(here)), rim)
        rim, angle = np.concatenate([rim, whole]), np.concatenate([angle, np.zeros(len(whole))])
        order = np.lexsort((angle, rim))
        rim, low = rim[order], angle[order]
        last = np.append(rim[1:] != rim[:-1], True)
        begins = np.flatnonzero(np.append(True, last[:-1]))
        high = np.append(low[1:], 0.0)
        high[last] = low[begins] + 2 * np.pi
        middle = (low + high) / 2
        places = here[rim] + r * np.column_stack([np.cos(middle), np.sin(middle)])
        free = (high > low) & ~shapely.contains_xy(stock, places)
        rim = first + rim[free]
        found.append((rim, low[free] - headings[rim], high[free] - headings[rim]))
    if not found:
        return np.zeros(0, np.int64), np.zeros(0), np.zeros(0)
    rims, low, high = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return rims, low, high


def _crossings(
    centers: Floats, starts: Floats, ends: Floats, r: float
) -> tuple[NDArray[np.int64], Floats]:
    """Return where circles cross lines: the number of the pair, and at which angle [rad]."""
    ahead, off = ends - starts, starts - centers
    square = (ahead**2).sum(axis=1)
    middle = -(ahead * off).sum(axis=1) / square
    # twice the triangle of center and line, over its length, is the distance of the line
    half = np.sqrt(np.maximum(r**2 - cross(ahead, off) ** 2 / square, 0.0) / square)
    pairs, angles = [], []
    for share in (middle - half, middle + half):
        on = np.flatnonzero((share >= 0) & (share <= 1) & (half > 0))
        place = off[on] + share[on, None] * ahead[on]
        pairs.append(on)
        angles.append(np.arctan2(place[:, 1], place[:, 0]))
    return np.concatenate(pairs), np.concatenate(angles)


def are_in_stock(points: Floats, stock: Region | None) -> NDArray[np.bool_]:
    """Return which points, shape (n, 2) [mm], lie in the stock; None: it is everywhere."""
    if stock is None:
        return np.ones(len(points), dtype=bool)
    return np.asarray(shapely.contains_xy(stock, points))
