# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sharp corners of the wall, into which a slot's last loop runs out.

Its other loops round them, as a machine would stop in each at every level. What stays there is
thin: the last loop takes it along where it turns, as any pass along a wall does. A stroke of its
own into each corner would cut no less, and need a link.
"""

from __future__ import annotations

import numpy as np
import shapely
from shapely import Polygon

from ..model import Floats
from ..numerics.distinct import distinct
from ..shapes.points import distances_along
from ..shapes.polyline import closed_line, located, points_at
from ..shapes.shaping import oriented

#: What is nearer to the wall runs along it [mm].
ON_WALL = 1e-3
#: Corners are rounded by at least the first and at most the second [mm].
SHALLOWEST, DEEPEST = 0.003, 0.5
#: A way through a corner is no farther from the way that rounds it, point by point [mm]. What is
#: is no corner, but the mouth of a channel.
BESIDE = 1.0


def run_into_corners(ring: Floats, region: Polygon) -> tuple[Floats, Floats] | None:
    """Return a ring along the wall, and beside it the same run out into the corners it rounds.

    None where it rounds none.

    Parameters
    ----------
    ring : ndarray of shape (n, 2)
        Counter-clockwise, begins on the wall, its first point is not repeated [mm].
    region : shapely.Polygon
        The cutter-center region.

    Returns
    -------
    ring, wall : ndarray of shape (m, 2)
        Point beside point: the same ring with more points, and what runs into the corners [mm].
    """
    wall = closed_line(shapely.get_coordinates(oriented(region).exterior)[:-1])
    off = shapely.distance(wall, shapely.points(ring))
    away = off > ON_WALL
    if away[0] or off.max() <= SHALLOWEST:
        return None
    edges = np.flatnonzero(np.diff(np.append(away, False)))
    firsts, lasts = edges[::2], (edges[1::2] + 1) % len(ring)
    begins, ends = located(wall, ring[firsts]), located(wall, ring[lasts])
    corners = distances_along(shapely.get_coordinates(wall))
    closed = np.vstack([ring, ring[:1]])
    rings, walls, done = [], [], 0
    for first, last, begin, end in zip(firsts, lasts, begins, ends, strict=True):
        rounded = closed[first : (last or len(ring)) + 1]
        along, through = distances_along(rounded), (end - begin) % wall.length
        depth = off[first + 1 : last or len(ring)].max()
        if not SHALLOWEST < depth <= DEEPEST:
            continue
        turns = (corners - begin) % wall.length / through
        share = distinct(np.round(np.concatenate([along / along[-1], turns]), 9))
        share = share[(share > 0) & (share < 1)]
        short = points_at(shapely.LineString(rounded), share * along[-1])
        long = points_at(wall, (begin + share * through) % wall.length)
        if np.hypot(*(long - short).T).max() > BESIDE:
            continue
        rings += [ring[done : first + 1], short]
        walls += [ring[done : first + 1], long]
        done = last or len(ring)
    if not rings:
        return None
    return np.vstack([*rings, ring[done:]]), np.vstack([*walls, ring[done:]])
