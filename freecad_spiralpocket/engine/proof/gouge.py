# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the cutter's edge passes the wall: exact distances of lines and arcs to the outline.

Only pieces of motion that come nearer to the wall than the cutter's radius are
looked at, each against every edge of the outline within that distance. A cutter
center outside the pocket has passed the wall by its radius and its distance.
"""

from __future__ import annotations

import numpy as np
import shapely
from shapely import Polygon

from ..contact.distances import arc_to_segment, segment_to_segment
from ..contact.swept import Pieces
from ..model import Floats
from ..shapes.shaping import edges_of

#: A piece that crosses the wall is looked at in this many places, then closer around the worst.
PLACES, ROUNDS = 33, 3


def gouge_depth(
    pocket: Polygon, pieces: Pieces, clearance: float
) -> tuple[float, tuple[float, float] | None]:
    """Return how far the cutter cuts into the wall at most, and where.

    Parameters
    ----------
    pocket : shapely.Polygon
        Islands as holes [mm].
    pieces : Pieces
    clearance : float
        Smallest distance of the cutter center to the wall: radius and stock to leave [mm].

    Returns
    -------
    depth : float
        [mm], 0 or more.
    place : tuple of float or None
        Cutter center (x, y) [mm].
    """
    if len(pieces) == 0:
        return 0.0, None
    distance = wall_distances(pocket, pieces, max(clearance, 0.0))
    outside = ~(
        shapely.contains_xy(pocket, pieces.starts) & shapely.contains_xy(pocket, pieces.ends)
    )
    for i in np.flatnonzero(outside | (distance == 0.0)):
        distance[i] = _deepest(pocket, pieces, int(i))[0]
    worst = int(np.argmin(distance))
    depth = max(0.0, clearance - float(distance[worst]))
    return depth, _deepest(pocket, pieces, worst)[1] if depth > 0 else None


def _deepest(pocket: Polygon, pieces: Pieces, i: int) -> tuple[float, tuple[float, float]]:
    """Return least signed distance to the wall along a piece, negative outside, and where."""
    low, high = 0.0, 1.0
    for _ in range(ROUNDS):
        fractions = np.linspace(low, high, PLACES)
        points = pieces.positions(np.full(PLACES, i), fractions)
        there = shapely.points(points)
        beyond = shapely.distance(there, pocket)
        inside = shapely.distance(there, pocket.boundary)
        signed = np.where(beyond > 0, -beyond, inside)
        best = int(np.argmin(signed))
        low, high = fractions[max(best - 1, 0)], fractions[min(best + 1, PLACES - 1)]
    x, y = points[best]
    return float(signed[best]), (float(x), float(y))


def wall_distances(pocket: Polygon, pieces: Pieces, limit: float) -> Floats:
    """Return the distance of each piece to the outline, shape (n,) [mm]; `limit` where farther."""
    a, b = edges_of(pocket)
    box = pieces.bounds
    tree = shapely.STRtree(shapely.box(*np.minimum(a, b).T, *np.maximum(a, b).T))
    grown = shapely.box(*(box[:, :2] - limit).T, *(box[:, 2:] + limit).T)
    piece, edge = tree.query(grown)
    found = np.where(
        pieces.is_arc[piece],
        arc_to_segment(pieces, piece, a[edge], b[edge]),
        segment_to_segment(pieces.starts[piece], pieces.ends[piece], a[edge], b[edge]),
    )
    distance = np.full(len(pieces), limit)
    np.minimum.at(distance, piece, found)
    return distance
