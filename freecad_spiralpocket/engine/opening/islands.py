# SPDX-License-Identifier: LGPL-2.1-or-later
"""Islands that a slot goes round: the bridges that join them, and their notches."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from ..growth.walls import are_near_walls
from ..numerics.distinct import distinct_pairs
from ..numerics.graphs import delaunay_triangles, spanning_tree
from ..shapes.points import unit
from ..shapes.shaping import CRACK, Region, closing_of, grow_coarsely, largest, thick_parts

#: Notches that a ring round islands leaves deeper than this over R are taken into it, with the
#: first of these roundings that leaves no more than that [mm]; seams are closed by so much [mm].
NOTCH, NOTCH_ROUNDINGS, NOTCH_SLACK, SEAM = 0.15, (0.15, 0.05, 0.02, 0.005, 0.0005), 0.002, 1e-4


def into_notches(
    visited: Polygon,
    shape: Polygon,
    region: Polygon,
    corridors: list[Polygon],
    rounding: float,
    radius: float,
) -> Polygon:
    """Return the ground that a ring round islands encloses, without their notches.

    What a wide curve leaves in a notch would be cut by the full width of the cutter at the full
    depth. The ring goes into it instead, by the widest curve that finishes it.

    Parameters
    ----------
    visited : shapely.Polygon
        What the ring encloses; its reentrant curves have the radius `rounding` [mm].
    shape : shapely.Polygon
        The islands joined by the `corridors`.
    region : shapely.Polygon
        The cutter-center region.
    corridors : list of shapely.Polygon
    rounding, radius : float
        [mm]; `radius` is the cutter's.
    """
    left = thick_parts(shapely.difference(visited, shape))
    left = left[~shapely.dwithin(left, shapely.union_all(corridors), CRACK)]
    deep = left[_are_deep(left, visited, NOTCH * radius)]
    for finer in (r for r in radius * np.array(NOTCH_ROUNDINGS) if r < rounding):
        if len(deep) == 0:
            break
        there = grow_coarsely(shapely.union_all(deep), CRACK)
        outside = shapely.difference(there, _closed_islands(region, finer))
        visited = shapely.difference(visited, outside)
        visited = Polygon(largest(closing_of(visited, SEAM)).exterior)
        here = shapely.intersection(visited, there)
        left = shapely.get_parts(shapely.difference(here, _islands_of(region)))
        deep = left[_are_deep(left, visited, NOTCH_SLACK)]
    return visited


@lru_cache(maxsize=1)
def _islands_of(region: Polygon) -> Region:
    """Return the islands of a cutter-center region, a little wider."""
    return shapely.union_all([grow_coarsely(Polygon(r), NOTCH_SLACK) for r in region.interiors])


@lru_cache(maxsize=len(NOTCH_ROUNDINGS))
def _closed_islands(region: Polygon, radius: float) -> Region:
    """Return the islands without what no disc of a radius reaches [mm]."""
    return closing_of(_islands_of(region), radius)


def _are_deep(pieces: NDArray[np.object_], visited: Polygon, depth: float) -> NDArray[np.bool_]:
    """Return which pieces of ground reach farther than `depth` from the ring around it [mm]."""
    points, piece = shapely.get_coordinates(pieces, return_index=True)
    near = are_near_walls(Polygon(visited.exterior), points, depth)
    deep = np.zeros(len(pieces), bool)
    deep[piece[~near]] = True
    return deep


def bridges_between(islands: list[Polygon]) -> list[LineString]:
    """Return the shortest lines that join all islands, as a minimum spanning tree."""
    if len(islands) < 2:
        return []
    shapes = np.array(islands, dtype=object)
    pairs = _neighbors(islands)
    tree = spanning_tree(len(islands), pairs, shapely.distance(*shapes[pairs.T]))
    lines = []
    for a, b in tree.tolist():
        line = shapely.shortest_line(islands[a], islands[b])
        # a little into both islands, so that the corridor meets their walls
        begin, end = shapely.get_coordinates(line)
        ahead = unit(end - begin)
        lines.append(LineString([begin - ahead, end + ahead]))
    return lines


def _neighbors(islands: list[Polygon]) -> NDArray[np.intp]:
    """Return the pairs of islands, shape (m, 2), that see each other; O(n log n)."""
    spacing = 0.5 * float(np.sqrt(min(i.area for i in islands)))
    rings = [shapely.get_coordinates(i.exterior.segmentize(spacing))[:-1] for i in islands]
    owner = np.repeat(np.arange(len(rings)), [len(r) for r in rings])
    sides = delaunay_triangles(np.vstack(rings))[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    pairs = np.sort(owner[sides], axis=1)
    return distinct_pairs(pairs[pairs[:, 0] != pairs[:, 1]])
