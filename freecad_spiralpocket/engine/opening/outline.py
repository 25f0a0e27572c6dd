# SPDX-License-Identifier: LGPL-2.1-or-later
"""Once round the wall: the stock within is then peeled from outside inwards.

The slot's one side is the finished wall, cut climb. What is left is a plug that stands free all
around. Fronts about it are closed laps down to its middle: no corner is left, nothing is
linked; and because the stock bends away from the cutter, the step may even exceed the
step-over at the same engagement.

For the fronts everything outside of the wall counts as visited, so that the wall is no
boundary of the region to grow in. Sharp corners are rounded; the slot's last loop runs out
into them (sharp_corners.py).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from ..model import Floats
from ..shapes.region import polygons_of
from ..shapes.shaping import CRACK, Region, are_within, grow_coarsely, largest, oriented, rim_points

#: The slot rounds the wall's corners with at least the first of these radii, over R: wider ones
#: spare a machine little, and leave the last loop longer peaks. With the next where one leaves more
#: than `ACUTE` [mm]: the full width of the cutter goes into that, at the full depth. What is left
#: of no more than `CRUMB` is nothing [mm].
ROUNDINGS = (0.02, 0.005, 0.002)
CRUMB, ACUTE = 0.005, 0.5
#: Width of the ground that the slot opens for the cutter's center [mm]: where its two sides just
#: meet, as in a neck of twice the cutter's width, no film is left for a lap, and a thicker one is.
WIDTH = 0.006
#: How far the ground outside of the wall reaches, over R: farther than any fillet or closing.
MARGIN = 4.0


@dataclass(frozen=True, slots=True, eq=False)
class Outline:
    """What a slot along the wall opens.

    Attributes
    ----------
    ring : LineString
        Closed, clockwise [mm].
    visited : shapely.Polygon
        All but the plugs.
    omega : shapely.Polygon
        The cutter-center region and all that lies outside of its wall.
    within : shapely.Polygon
        The cutter-center region, its corners rounded as the slot does.
    """

    ring: LineString
    visited: Polygon
    omega: Polygon
    within: Polygon


def outline_of(region: Polygon, radius: float) -> Outline | None:
    """Return what a slot along the outer wall opens; None where it would not reach round.

    Parameters
    ----------
    region : shapely.Polygon
        The cutter-center region.
    radius : float
        R [mm].
    """
    filled = Polygon(region.exterior)
    parts = polygons_of(_rounded(filled, radius))
    if len(parts) != 1 or parts[0].interiors:
        return None
    within = shapely.intersection(parts[0], region)
    if not isinstance(within, Polygon) or len(within.interiors) != len(region.interiors):
        return None
    plugs = grow_coarsely(parts[0], -WIDTH)
    opened = shapely.difference(filled, plugs)
    if any(opened.intersects(Polygon(island)) for island in region.interiors):
        return None  # between an island and the wall there is no room for it
    around = shapely.box(*region.bounds).buffer(MARGIN * radius, join_style="mitre")
    visited = oriented(largest(shapely.difference(around, plugs)))
    omega = oriented(
        Polygon(around.exterior, [shapely.get_coordinates(r) for r in region.interiors])
    )
    ring = LineString(shapely.get_coordinates(oriented(parts[0]).exterior)[::-1])
    return Outline(ring, visited, omega, oriented(within))


def _rounded(filled: Polygon, radius: float) -> Region:
    """Return a region without its sharp corners."""

    def opened(share: float) -> Region:
        core = grow_coarsely(filled, -share * radius)
        return shapely.intersection(grow_coarsely(core, share * radius), filled)

    widest, *finer = ROUNDINGS
    shape = opened(widest)
    left = shapely.get_parts(shapely.difference(filled, shape))
    deep = _depths(left, shape)
    for share in finer:
        must = (deep > ACUTE) | _are_between(left, shape)
        if not must.any():
            break
        shape = _finer(shape, opened(share), left[must])
        left = shapely.get_parts(shapely.difference(filled, shape))
        deep = _depths(left, shape)
    return shape


def _finer(shape: Region, fine: Region, corners: NDArray[np.object_]) -> Region:
    """Return a shape with some of its corners as in the finer one."""
    there = grow_coarsely(shapely.union_all(corners), CRACK)
    return shapely.union(shape, shapely.intersection(fine, there))


def _are_between(pieces: NDArray[np.object_], region: Region) -> NDArray[np.bool_]:
    """Return which pieces lie between two parts of a region, as a channel between rooms does."""
    parts = np.array(polygons_of(region), dtype=object)
    if len(parts) < 2:
        return np.zeros(len(pieces), dtype=bool)
    return np.asarray(shapely.dwithin(parts[:, None], pieces, CRACK).sum(axis=0) > 1)


def _depths(pieces: NDArray[np.object_], region: Region) -> Floats:
    """Return how far pieces reach beyond a region [mm].

    Nothing if it is less than `CRUMB`, infinite if the region is empty.
    """
    # a channel between two rooms has no corners but at its mouths
    points, piece = rim_points(pieces, ACUTE)
    off = np.full(len(points), np.inf)
    if not region.is_empty:
        near = are_within(region, points, CRUMB)
        off[near] = 0.0
        off[~near] = shapely.distance(region, shapely.points(points[~near]))
    depths = np.zeros(len(pieces))
    np.maximum.at(depths, piece, off)
    return depths
