# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the cutter's edge passes the wall: exact distances of lines and arcs to the outline.

Only pieces of motion that come nearer to the wall than the cutter's radius are
looked at, each against every edge of the outline within that distance. A cutter
center outside the pocket has passed the wall by its radius and its distance.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from .model import Floats
from .swept import Pieces

#: Places on a piece that crosses the wall where its distance is taken.
PLACES = 65


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
    place = pieces.starts.copy()
    every = np.arange(len(pieces))
    ends = shapely.contains_xy(pocket, pieces.ends) & shapely.contains_xy(pocket, pieces.starts)
    for i in np.flatnonzero(~ends | (distance == 0.0)):
        points = pieces.positions(np.full(PLACES, every[i]), np.linspace(0.0, 1.0, PLACES))
        outside = shapely.distance(shapely.points(points), pocket)
        worst = int(np.argmax(outside))
        distance[i], place[i] = -outside[worst], points[worst]
    worst = int(np.argmin(distance))
    depth = max(0.0, clearance - float(distance[worst]))
    return depth, (float(place[worst, 0]), float(place[worst, 1])) if depth > 0 else None


def wall_distances(pocket: Polygon, pieces: Pieces, limit: float) -> Floats:
    """Return the distance of each piece to the outline, shape (n,) [mm]; `limit` where farther."""
    a, b = _edges(pocket)
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


def _edges(pocket: Polygon) -> tuple[Floats, Floats]:
    rings = [shapely.get_coordinates(r) for r in (pocket.exterior, *pocket.interiors)]
    a = np.concatenate([r[:-1] for r in rings])
    b = np.concatenate([r[1:] for r in rings])
    return a, b


def point_to_segment(p: Floats, a: Floats, b: Floats) -> Floats:
    """Return distances of points to segments, all of shape (k, 2) [mm]."""
    d = b - a
    square = np.maximum((d * d).sum(axis=1), 1e-30)
    t = np.clip(((p - a) * d).sum(axis=1) / square, 0.0, 1.0)
    return np.hypot(*(p - a - t[:, None] * d).T)


def segment_to_segment(a: Floats, b: Floats, c: Floats, d: Floats) -> Floats:
    """Return distances of segments ab to segments cd, 0 where they cross [mm]."""
    ends = np.minimum.reduce(
        [
            point_to_segment(a, c, d),
            point_to_segment(b, c, d),
            point_to_segment(c, a, b),
            point_to_segment(d, a, b),
        ]
    )
    crossing = (_side(a, b, c) * _side(a, b, d) < 0) & (_side(c, d, a) * _side(c, d, b) < 0)
    return np.where(crossing, 0.0, ends)


def _side(a: Floats, b: Floats, p: Floats) -> Floats:
    u, v = b - a, p - a
    return u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]


def arc_to_segment(pieces: Pieces, index: NDArray[np.int64], a: Floats, b: Floats) -> Floats:
    """Return distances of circular pieces to segments ab, 0 where they cross [mm]."""
    m, rho = pieces.centers[index], pieces.radii[index]
    ends = np.minimum.reduce(
        [
            point_to_segment(pieces.starts[index], a, b),
            point_to_segment(pieces.ends[index], a, b),
            point_to_arc(pieces, index, a),
            point_to_arc(pieces, index, b),
        ]
    )
    d = b - a
    square = np.maximum((d * d).sum(axis=1), 1e-30)
    t = ((m - a) * d).sum(axis=1) / square
    foot = a + t[:, None] * d
    off = np.hypot(*(foot - m).T)
    beside = (t >= 0) & (t <= 1) & _faces(pieces, index, foot)
    ends = np.where(beside, np.minimum(ends, np.abs(off - rho)), ends)
    half = np.sqrt(np.maximum(rho * rho - off * off, 0.0)) / np.sqrt(square)
    for crossing in (t - half, t + half):
        hit = a + crossing[:, None] * d
        meets = (off <= rho) & (crossing >= 0) & (crossing <= 1) & _faces(pieces, index, hit)
        ends = np.where(meets, 0.0, ends)
    return ends


def point_to_arc(pieces: Pieces, index: NDArray[np.int64], p: Floats) -> Floats:
    """Return distances of points, shape (k, 2), to circular pieces [mm]."""
    ends = np.minimum(
        np.hypot(*(p - pieces.starts[index]).T), np.hypot(*(p - pieces.ends[index]).T)
    )
    off = np.abs(np.hypot(*(p - pieces.centers[index]).T) - pieces.radii[index])
    return np.where(_faces(pieces, index, p), np.minimum(off, ends), ends)


def _faces(pieces: Pieces, index: NDArray[np.int64], p: Floats) -> NDArray[np.bool_]:
    """Return which points lie in the sector of their circular piece."""
    v = p - pieces.centers[index]
    sweep = pieces.sweeps[index]
    turn = np.mod((np.arctan2(v[:, 1], v[:, 0]) - pieces.angles[index]) * np.sign(sweep), 2 * np.pi)
    return turn <= np.abs(sweep)
