# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which points are near the walls of a region, asked again and again by growing fronts."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from ..model import Floats
from ..shapes.shaping import edges_of


def are_near_walls(region: Polygon, points: Floats, distance: float) -> NDArray[np.bool_]:
    """Return which points, shape (n, 2), are within `distance` of a region's boundary [mm].

    Meant for distances that are short against the chords of the boundary.
    """
    near = np.zeros(len(points), bool)
    hits = _tree(region).query(shapely.points(points), predicate="dwithin", distance=distance)
    near[hits[0]] = True
    return near


@lru_cache(maxsize=4)
def _tree(region: Polygon) -> shapely.STRtree:
    """Return a tree of the edges of a region."""
    return shapely.STRtree(shapely.linestrings(np.stack(edges_of(region), axis=1)))
