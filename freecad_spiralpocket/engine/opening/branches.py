# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines that a groove runs along: branches of the peeled axis, lengthened at their tips.

The axis is peeled until it has no forks into corners. Fronts about the thin end of a
slot gain less with each lap than those at its sides; so the ends go on straight to
where both reach their walls at about the same time.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import shapely
from shapely import LineString, Polygon

from ..model import Floats
from ..numerics.filters import evened
from ..numerics.nearest import nearest
from ..shapes.points import unit
from ..shapes.polyline import points_at
from ..shapes.shaping import closing_of, grow_coarsely, largest
from ..shapes.skeleton import Edges, Skeleton, distances_from

#: A groove ends so far from the wall ahead, over the distance of the walls at its sides.
TIP = 0.65
#: Radius of the ring's reentrant curves over half its width.
ROUNDING = 3.0
#: Distance of samples along branches [mm].
SAMPLING = 0.5
#: Lines as short against the width of their smoothing are straight: a wider one only takes long.
WIDEST = 30.0


def lengthened(
    axis: Skeleton, edges: Edges, region: Polygon, smoothing: float
) -> tuple[list[Floats], Floats]:
    """Return the branches that `edges` make, smooth and lengthened, and the tips.

    Parameters
    ----------
    axis : Skeleton
    edges : list of (int, int)
        Of a tree.
    region : shapely.Polygon
        The cutter-center region.
    smoothing : float
        Width of the smoothing along the branches [mm].

    Returns
    -------
    branches : list of ndarray of shape (n, 2)
    tips : ndarray of shape (k, 2)
        Their loose ends.
    """
    pieces = shapely.multilinestrings([axis.nodes[list(edge)] for edge in edges])
    merged = shapely.get_parts(shapely.line_merge(pieces))
    ends = [line.coords[i] for line in merged for i in (0, -1)]
    branches, tips = [], []
    for line in merged:
        points = smoothed(line, smoothing)
        for i in (0, -1):
            if ends.count(line.coords[i]) == 1:
                points = _gone_on(points[::-1] if i == 0 else points, region)
                tips.append(points[-1])
                points = points[::-1] if i == 0 else points
        branches.append(points)
    return branches, np.array(tips)


def smoothed(line: LineString, width: float) -> Floats:
    """Return a line with its bends smoothed and its ends where they were, shape (n, 2) [mm].

    `width` is that of the bell curve by which its points are evened out [mm].
    """
    count = max(4, int(line.length / SAMPLING))
    points = points_at(line, np.linspace(0, line.length, count))
    smooth = evened(points, count * width / max(line.length, width / WIDEST))
    smooth[0], smooth[-1] = points[0], points[-1]
    return shapely.get_coordinates(shapely.simplify(LineString(smooth), 0.01))


def _gone_on(points: Floats, region: Polygon) -> Floats:
    """Return a line gone on straight beyond its last point towards the wall."""
    line, end = LineString(points), points[-1]
    width = region.boundary.distance(shapely.Point(end))
    ahead = unit(end - points_at(line, np.array(max(0.0, line.length - width))))
    ray = LineString([end, end + 4 * width * ahead])
    wall = shapely.intersection(region.boundary, ray)
    if wall.is_empty:
        return points
    go = wall.distance(shapely.Point(end)) - TIP * width
    return np.vstack([points, end + go * ahead]) if go > 0 else points


def slim_ring(branches: list[Floats], half: float, region: Polygon) -> Polygon:
    """Return the region within `half` [mm] of the branches, its reentrant corners rounded."""
    shape = shapely.union_all([grow_coarsely(LineString(b), half) for b in branches])
    q = ROUNDING * half
    shape = closing_of(shape, q)
    return largest(shapely.intersection(shape, region))


def feet_between(
    ring: LineString, tips: list[float], axis: Skeleton, edges: Edges
) -> tuple[list[float], float]:
    """Return where between successive tips the ring is nearest to its beginning, along the tree.

    Parameters
    ----------
    ring : LineString
        Closed, from the first tip on.
    tips : list of float
        The others, in order along it [mm].

    Returns
    -------
    feet : list of float
        One between each two of `tips` [mm].
    trunk : float
        How far the nearest of them is from the first tip; without any, the other tip [mm].
    """
    nodes, distances = distances_from(axis, edges, np.array(ring.coords[0]))
    feet, trunk = [], tips[0]
    for a, b in pairwise(tips):
        s = np.linspace(a, b, max(3, int((b - a) / SAMPLING)))
        near = distances[nearest(nodes, points_at(ring, s))[1]]
        low = np.flatnonzero(near <= near.min() + 1e-9)
        feet.append(float(s[low[len(low) // 2]]))
        trunk = min(trunk, float(near.min()))
    return feet, trunk
