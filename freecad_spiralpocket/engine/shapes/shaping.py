# SPDX-License-Identifier: LGPL-2.1-or-later
"""Growing, shrinking and joining regions, within a few thousandths of a millimeter; edges."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache, partial
from typing import TypeAlias

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPolygon, Polygon

from ..model import Floats
from .points import cross
from .region import polygons_of, rings_of

#: What growing and shrinking return.
Region: TypeAlias = Polygon | MultiPolygon

#: Points of a cutter-center region that matter less than this are left out [mm].
SLIM = 0.001
#: Cracks where shapes are joined are narrower than twice this [mm].
CRACK = 0.01
#: What is thinner than twice this is a hairline [mm].
HAIRLINE = 2e-4
#: A shorter turn back in a ring is no whisker worth removing [mm].
LONG = 0.05
#: Left-over pieces of less area are not worth a stroke [mm2].
SLIVER = 1e-3


def grow_coarsely(shape: Region, distance: float) -> Region:
    """Return a valid region grown by a distance [mm] (shrunk if negative), arcs within 0.004 mm.

    For fronts and starts, which take dozens each; what decides where walls are is grown four times
    as finely by `region.grow`.
    """
    step = 2 * np.arccos(1 - min(0.5, 0.004 / max(abs(distance), 1e-6)))
    grown = shapely.buffer(shape, distance, quad_segs=max(4, int(np.ceil(np.pi / 2 / step))))
    # once in a great while two of its parts overlap, which nothing after it bears
    if isinstance(grown, Polygon) or grown.is_valid:
        return grown
    return MultiPolygon(polygons_of(shapely.make_valid(grown)))


def opening_of(shape: Region, radius: float) -> Region:
    """Return what discs of a radius [mm] reach within a region: no convex corner is sharper."""
    return grow_coarsely(grow_coarsely(shape, -radius), radius)


def closing_of(shape: Region, radius: float) -> Region:
    """Return all but what such discs reach outside of a region: no reentrant corner is sharper."""
    return grow_coarsely(grow_coarsely(shape, radius), -radius)


def clipped(shape: Region, bounds: tuple[float, float, float, float]) -> Region:
    """Return what lies in a box, given by its least and largest x and y as in `shape.bounds`."""
    try:
        return shapely.clip_by_rect(shape, *bounds)
    except shapely.GEOSException:  # where the box just touches the shape
        return shapely.intersection(shape, shapely.box(*bounds))


def are_within(shape: Region, points: Floats, distance: float) -> NDArray[np.bool_]:
    """Return which points, shape (n, 2), are within a distance of a region [mm].

    The same region is asked again and again, about hundreds of points: looking them up in the grown
    region takes a fifth of the time of measuring each.
    """
    if len(points) == 0:
        return np.zeros(0, bool)
    return np.asarray(shapely.contains_xy(grow_prepared(shape, distance), points))


@lru_cache(maxsize=16)
def grow_prepared(shape: Region, distance: float) -> Region:
    """Return a region grown as by `grow_coarsely`, prepared for being asked again and again."""
    wider = grow_coarsely(shape, distance)
    shapely.prepare(wider)
    return wider


def drawn_inside(points: Floats, shape: Region, slack: float) -> Floats:
    """Return points, those farther outside of a region than `slack` drawn in to there.

    Parameters
    ----------
    points : ndarray of shape (n, 2)
        [mm]
    shape : shapely.Polygon or MultiPolygon
    slack : float
        [mm]

    Returns
    -------
    ndarray of shape (n, 2)
    """
    out = np.flatnonzero(~are_within(shape, points, slack))
    if len(out) == 0:
        return points
    ways = shapely.shortest_line(shapely.points(points[out]), shape)
    edge = shapely.get_coordinates(ways).reshape(-1, 2, 2)[:, 1]
    aside = points[out] - edge
    drawn = points.copy()
    drawn[out] = edge + aside * (slack / np.hypot(*aside.T))[:, None]
    return drawn


def holes_of(shape: Region) -> int:
    """Return how many holes a region has."""
    # a part is a copy
    parts = shape if isinstance(shape, Polygon) else shapely.get_parts(shape)
    return int(np.sum(shapely.get_num_interior_rings(parts)))


def simplified_region(shape: Polygon, tolerance: float) -> Polygon:
    """Return a region without the points that matter less than a tolerance [mm].

    Ring by ring, which takes a tenth of the time of seeing to it that no two come to cross; that
    is only done where they do.
    """
    slim = [_simplified_ring(ring, tolerance) for ring in shapely.get_rings(shape)]
    if min(map(len, slim), default=0) > 3:
        region = Polygon(slim[0], slim[1:])
        if region.is_valid:
            return region
    return shapely.simplify(shape, tolerance)


def _simplified_ring(ring: shapely.LinearRing, tolerance: float) -> Floats:
    """Return the points of a ring, shape (n, 2), without those that matter less [mm].

    Where its first point is left out it begins at the last that is not, as in a whole region.
    """
    slim = shapely.simplify(ring, tolerance, preserve_topology=False)
    points = shapely.get_coordinates(slim)
    if len(points) and (points[0] != shapely.get_coordinates(ring)[0]).any():
        points = np.vstack([points[-2:-1], points[:-1]])
    return points


def slim_region(region: Polygon) -> Polygon:
    """Return a cutter-center region as strategies take it: without needless points, `oriented`."""
    return oriented(shapely.simplify(region, SLIM))


def welded(shapes: Sequence[Region]) -> Region:
    """Return the union, without the cracks that stay where edges are nearly the same."""
    return closing_of(shapely.union_all(shapes), CRACK)


def largest(shape: Region) -> Polygon:
    """Return the largest polygon of a region, counter-clockwise."""
    return oriented(shape) if isinstance(shape, Polygon) else polygons_of(shape)[0]


def thick_parts(shape: Region) -> NDArray[np.object_]:
    """Return the pieces of a region, without what is as thin as a hair.

    Rounding of numbers leaves hairlines along walls, which would join all corners to a frame.
    """
    if not isinstance(shape, Polygon | MultiPolygon):  # lines among it
        shape = MultiPolygon(polygons_of(shape))
    # points closer together than the hairline cost a hundred times as long
    return sizable_parts(_without_hairs(shapely.simplify(shape, HAIRLINE / 10)))


def sizable_parts(shape: Region) -> NDArray[np.object_]:
    """Return the pieces of a region that are worth a stroke, or a look."""
    parts = shapely.get_parts(shape)
    return parts[shapely.area(parts) > SLIVER]


def _without_hairs(shape: Region) -> Region:
    mitred = partial(shapely.buffer, join_style="mitre")
    return mitred(mitred(shape, -HAIRLINE), HAIRLINE)


def without_whiskers(shape: Polygon) -> Polygon:
    """Return a region without parts as thin as a hair, the same if its rings have no turn back.

    Along a wall an intersection may leave a whisker of no width, millimeters long.
    """
    for ring in rings_of(shape):
        ahead = np.diff(shapely.get_coordinates(ring), axis=0)
        onward = np.roll(ahead, -1, axis=0)
        lengths = np.hypot(*ahead.T), np.hypot(*onward.T)
        across = np.abs(cross(ahead, onward))
        back = (ahead * onward).sum(axis=1) < 0
        # how far apart both ways are where the shorter one ends
        if (
            back & (across < HAIRLINE * np.maximum(*lengths)) & (np.minimum(*lengths) > LONG)
        ).any():
            return largest(_without_hairs(shape))
    return shape


def rim_points(
    shapes: Region | NDArray[np.object_], spacing: float
) -> tuple[Floats, NDArray[np.intp]]:
    """Return points along the rims of regions, no farther apart [mm], and which region each is of.

    Made denser as an area, a region would lose what hangs on it by a hairline.
    """
    parts, shape = shapely.get_parts(np.atleast_1d(shapes), return_index=True)
    rings, part = shapely.get_rings(parts, return_index=True)
    points, ring = shapely.get_coordinates(shapely.segmentize(rings, spacing), return_index=True)
    return points, shape[part[ring]]


def edges_of(shape: Region) -> tuple[Floats, Floats]:
    """Return where the edges of a region begin and end, shape (n, 2) each [mm]."""
    rings = [ring for p in shapely.get_parts(shape) for ring in rings_of(p)]
    points, ring = shapely.get_coordinates(rings, return_index=True)
    proper = (ring[1:] == ring[:-1]) & (points[1:] != points[:-1]).any(axis=1)
    return points[:-1][proper], points[1:][proper]


def oriented(shape: Polygon) -> Polygon:
    """Return `shape` with its exterior counter-clockwise and its interiors clockwise."""
    return shapely.geometry.polygon.orient(shape)
