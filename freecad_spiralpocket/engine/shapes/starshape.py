# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the whole wall can be seen from: the kernel of a polygon, and its deepest place.

The kernel is the intersection of the half planes left of all edges. In a
convex region it is the region itself, and its deepest point the innermost
point. Where a whole segment is equally deep, as in a rectangle, the middle
of it is taken.
"""

from __future__ import annotations

import numpy as np
from shapely import Polygon

from ..model import Floats

#: The middle is sought among the places at least this deep, over the deepest.
NEARLY_DEEPEST = 0.98
#: Edges may be off straight by this much and still count as seen [mm].
SLACK = 1e-3


def deepest_center(region: Polygon) -> Floats | None:
    """Return the place from which the wall is seen best, shape (2,) [mm]; None if there is none.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise, without islands.
    """
    from scipy.optimize import linprog

    ring = np.array(region.exterior.coords)
    edges = np.diff(ring, axis=0)
    length = np.hypot(edges[:, 0], edges[:, 1])
    edges, ring, length = edges[length > 0], ring[:-1][length > 0], length[length > 0]
    outward = np.column_stack([edges[:, 1], -edges[:, 0]]) / length[:, None]
    offsets = (outward * ring).sum(axis=1) + SLACK
    # Chebyshev center: the largest disc left of all edges
    solution = linprog(
        [0.0, 0.0, -1.0],
        A_ub=np.column_stack([outward, np.ones(len(outward))]),
        b_ub=offsets,
        bounds=[(None, None), (None, None), (0, None)],
        method="highs",
    )
    if not solution.success or solution.x[2] <= 2 * SLACK:
        return None
    center, depth = solution.x[:2], solution.x[2]
    return _middle_of_deepest(outward, offsets - NEARLY_DEEPEST * depth, center)


def _middle_of_deepest(outward: Floats, offsets: Floats, inside: Floats) -> Floats:
    """Return the centroid of the intersection of half planes ``outward . p <= offsets``."""
    from scipy.spatial import ConvexHull, HalfspaceIntersection

    corners = HalfspaceIntersection(np.column_stack([outward, -offsets]), inside).intersections
    hull = corners[ConvexHull(corners).vertices]
    return np.array(Polygon(hull).centroid.coords[0])
