# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the pocket's outline to the regions where the cutter's center may be.

The cutter-center region is the pocket shrunk by the cutter radius and the
stock to leave. Necks that the cutter cannot pass break it into several (see necks.py).
"""

from __future__ import annotations

import math

import shapely
from shapely import LinearRing, MultiPolygon, Polygon
from shapely.geometry.polygon import orient

from ..errors import CutterDoesNotFitError

#: Largest distance between a buffer's polygon and its true arcs [mm]; around cutter-center regions
#: of small cutters over R.
BUFFER_SAG, FINE_SAG = 0.001, 1 / 3000
#: Pockets and channels wider than the cutter by less than twice this are too narrow for it, over R.
HAIR = 0.0025
#: A pocket is as wide as the cutter that lacks no more than this [mm]: walls of chords are nearer.
SNUG = 0.01
#: A pocket is a round hole whose area is no more than this, over that of the widest disc in it.
ROUND = 1.05
#: Chords of circles that are larger than any part are no shorter [rad]: rounding would make them 0.
LEAST_STEP = 1e-4
#: What is fitted to a wall keeps off it by this [mm].
INSET = 0.01


def quad_segments(radius: float, sag: float = BUFFER_SAG) -> int:
    """Return how many chords a quarter circle needs to keep within `sag`.

    Parameters
    ----------
    radius, sag : float
        [mm]
    """
    step = 2 * math.acos(max(-1.0, 1.0 - sag / max(abs(radius), sag)))
    return max(8, math.ceil(math.pi / 2 / max(step, LEAST_STEP)))


def grow(
    shape: Polygon | MultiPolygon, distance: float, sag: float = BUFFER_SAG
) -> Polygon | MultiPolygon:
    """Return `shape` grown by `distance` [mm] (shrunk if negative), arcs within `sag` [mm].

    For what decides where walls are; fronts are grown by `shaping.grow_coarsely`.
    """
    return shapely.buffer(shape, distance, quad_segs=quad_segments(distance, sag))


def rounded_inside(region: Polygon, fillet: float, inset: float) -> list[Polygon]:
    """Return what lies farther inside of a region than `inset`, convex corners rounded.

    Parameters
    ----------
    region : shapely.Polygon
    fillet : float
        Radius of its corners [mm].
    inset : float
        [mm]

    Returns
    -------
    list of shapely.Polygon
        Several where that breaks the region at necks, largest first.
    """
    return polygons_of(grow(grow(region, -fillet - inset), fillet))


def polygons_of(shape: shapely.Geometry) -> list[Polygon]:
    """Return the polygons in `shape`, counter-clockwise, largest first (ties: lower left)."""
    if isinstance(shape, Polygon):
        return [] if shape.is_empty else [orient(shape)]
    parts = shapely.get_parts(shapely.get_parts(shape))  # a collection may hold several at once
    parts = [g for g in parts if isinstance(g, Polygon) and not g.is_empty]
    return [orient(p) for p in sorted(parts, key=lambda p: (-p.area, p.bounds))]


def rings_of(shape: Polygon) -> tuple[LinearRing, ...]:
    """Return all rings of a polygon, the outer one first."""
    return (shape.exterior, *shape.interiors)


def widest_disc(shape: Polygon, tolerance: float = 0.01) -> tuple[tuple[float, float], float]:
    """Return center and radius [mm] of the largest disc inside `shape`."""
    line = shapely.maximum_inscribed_circle(shape, tolerance=tolerance)
    (x, y), _ = line.coords
    return (x, y), float(line.length)


def center_regions(pocket: Polygon, cutter_radius: float, stock: float) -> list[Polygon]:
    """Return where the cutter's center may be: polygons, counter-clockwise, largest first.

    Parameters
    ----------
    pocket : shapely.Polygon
    cutter_radius : float
        R [mm].
    stock : float
        Stock to leave on the walls [mm].

    Raises
    ------
    CutterDoesNotFitError
        If there is no such place.
    """
    inset = cutter_radius + stock
    regions = polygons_of(grow(pocket, -inset, min(BUFFER_SAG, FINE_SAG * cutter_radius)))
    parts = [part for region in regions for part in without_hairs(region, cutter_radius)]
    if not parts:
        raise _too_narrow(pocket, cutter_radius, stock)
    return parts


def _too_narrow(pocket: Polygon, cutter_radius: float, stock: float) -> CutterDoesNotFitError:
    """Return what is to be told of a pocket that has no place for the cutter's center."""
    place, radius = widest_disc(pocket)
    left = f" with {stock:g} mm of stock to leave" if stock else ""
    if radius > cutter_radius + stock - SNUG:
        is_hole = pocket.area < ROUND * math.pi * radius**2
        return CutterDoesNotFitError(
            f"The pocket is no wider than the {2 * cutter_radius:g} mm cutter{left}, at {{at}}.",
            "Take a smaller cutter; a hole as wide as the cutter is one for FreeCAD's Drilling."
            if is_hole
            else "Take a smaller cutter; a slot as wide as the cutter is one for FreeCAD's Slot.",
            place,
        )
    return CutterDoesNotFitError(
        f"The {2 * cutter_radius:g} mm cutter does not fit the pocket{left}: it is "
        f"{round(2 * radius, 2):g} mm wide at its widest, at {{at}}.",
        f"Take a cutter below {round(2 * (radius - stock), 2):g} mm."
        if radius > stock
        else "Lower StockToLeave.",
        place,
    )


def without_hairs(region: Polygon, radius: float) -> list[Polygon]:
    """Return a cutter-center region without channels as wide as the cutter and no more.

    There is no way to enter these, and what hangs together by one alone is cut room by room.
    Nothing is left of one that is such a channel.

    Parameters
    ----------
    region : shapely.Polygon
    radius : float
        R [mm].
    """
    half = HAIR * radius
    cores = polygons_of(grow(region, -half))
    if not cores:
        return []
    if len(cores) == 1 and len(cores[0].interiors) == len(region.interiors):
        return [region]
    left = shapely.difference(region, grow(MultiPolygon(cores), 1.001 * half))
    # corners are no longer than they are wide
    hairs = [p for p in polygons_of(left) if shapely.minimum_bounding_radius(p) > radius / 2]
    if not hairs:
        return [region]
    return polygons_of(shapely.difference(region, grow(MultiPolygon(hairs), 0.1 * half)))
