# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is added to a floor beyond its open sides, so that the cutter clears it to its very edge.

Its center may go straight out of each open side: by a hair, or where the stock ends near by as far
as to come down and turn in the air beside it. It keeps off everything that stands beside the floor:
the part itself, and all other parts of the job.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import Part
import shapely
from shapely import LineString, MultiPoint, Polygon

from ..engine.shapes.region import grow, polygons_of
from . import geometry
from .adjacency import outer_wire
from .selection import Floor
from .slices import standing

#: The center goes so far beyond the stock, over R: down there in the air, with some room.
BEYOND = 2.0
#: And so far beyond an open side where the stock reaches farther than the cutter's diameter, over
#: R: the first that clears as much of the floor as the last; walls that end aslant may take that.
OVER = (0.1, 0.4, 0.7, 1.0)
#: What is thinner than twice this is left by rounding alone [mm].
HAIR = 0.005
#: It keeps off the part there by this more than by the wall [mm].
APART = 0.003
#: What is added overlaps the floor by this [mm].
OVERLAP = 0.001
#: Outlines of curved stock are off by up to this [mm].
STOCK_SAG = 0.01


class OpenSides:
    """The open sides of one floor.

    Parameters
    ----------
    floor : Floor
    sag : float
        Largest distance of sections from the true walls [mm].
    solids : sequence of Part.Solid
        All that must not be cut.
    stock : shapely.Polygon
        Outline of the stock.
    cutter_radius, stock_to_leave : float
        [mm]

    Attributes
    ----------
    stock : shapely.Polygon
    """

    def __init__(
        self,
        floor: Floor,
        sag: float,
        *,
        solids: Sequence[Any],
        stock: Polygon,
        cutter_radius: float,
        stock_to_leave: float,
    ) -> None:
        self.stock = stock
        self._sag, self._solids, self._inset = sag, solids, cutter_radius + stock_to_leave
        pieces = lines_of(floor, sag)
        lines = [shapely.linestrings([p.start for p in c] + [c[-1].end]) for c in pieces]
        self._edge = shapely.union_all(lines)
        sides = shapely.line_merge(self._edge) if len(lines) > 1 else self._edge
        straight = [LineString([c.coords[0], c.coords[-1]]) for c in shapely.get_parts(sides)]
        self._before = shapely.union_all(
            shapely.buffer(straight, 2 * self._inset, cap_style="flat")
        )
        outline = Polygon(geometry.polygon(floor, sag).exterior)
        *less, most = (_strips(sides, stock, cutter_radius, share) for share in OVER)
        self._around = shapely.buffer(most, 2 * self._inset)
        self._standing: dict[float, shapely.Geometry] = {}
        self._kept_off: dict[float, shapely.Geometry] = {}
        cleared = self._cleared(outline, most, floor.z)
        self._strips = most
        for strips in less:
            lost = shapely.difference(cleared, self._cleared(outline, strips, floor.z))
            if shapely.buffer(lost, -HAIR).is_empty:
                self._strips = strips
                break

    def widened(self, free: Polygon, z: float) -> Polygon:
        """Return what is free inside of the floor's edge at Z `z`, and what is beyond it."""
        filled = Polygon(free.exterior)
        ways = self._ways(filled, self._strips, z)
        beyond = shapely.difference(grow(ways, self._inset), filled)
        near = shapely.buffer(self._edge, OVERLAP)
        parts = [p for p in polygons_of(beyond) if p.intersects(near)]
        if not parts:
            return self._as_wide_as_its_mouth(free, z)
        return polygons_of(shapely.union_all([free, *(p.buffer(OVERLAP) for p in parts)]))[0]

    def _as_wide_as_its_mouth(self, free: Polygon, z: float) -> Polygon:
        """Return what is free with what is before its sides, where the cutter fits neither.

        How wide the pocket is told to be then does not depend on how long its floor is.
        """
        before = shapely.difference(self._before, self._standing_at(z))
        wider = polygons_of(shapely.union_all([free, before]))[0]
        return wider if grow(wider, -self._inset - APART).is_empty else free

    def _standing_at(self, z: float) -> shapely.Geometry:
        """Return what stands around the open sides at Z `z`."""
        if z not in self._standing:
            found = [standing(solid, self._around, z, self._sag) for solid in self._solids]
            self._standing[z] = shapely.union_all(found)
        return self._standing[z]

    def _cleared(self, outline: Polygon, strips: shapely.Geometry, z: float) -> shapely.Geometry:
        """Return what of the floor is cleared from beyond its edge."""
        return shapely.intersection(grow(self._ways(outline, strips, z), self._inset), outline)

    def _ways(self, filled: Polygon, strips: shapely.Geometry, z: float) -> shapely.Geometry:
        """Return where the center may be in strips and beside them in the floor."""
        if z not in self._kept_off:
            self._kept_off[z] = grow(self._standing_at(z), self._inset + APART)
        inside = shapely.intersection(filled, shapely.buffer(self._edge, self._inset))
        centers = shapely.difference(shapely.union(strips, inside), self._kept_off[z])
        near = shapely.buffer(self._edge, OVERLAP)
        return shapely.union_all([p for p in polygons_of(centers) if p.intersects(near)])


def lines_of(floor: Floor, sag: float) -> list[list[geometry.Piece]]:
    """Return the edges of a floor from which no wall rises, each as pieces from end to end."""
    return [
        geometry.pieces_of(edge, sag)
        for edge in outer_wire(floor.face).Edges
        if not floor.adjacency.wall_rises(floor.face, edge)
    ]


def outline_of_stock(shape: Any) -> Polygon:
    """Return the convex outline of a job's stock, seen from above."""
    corners, _ = shape.tessellate(STOCK_SAG)
    hull = MultiPoint(np.array([tuple(c)[:2] for c in corners])).convex_hull
    is_flat = all(isinstance(face.Surface, Part.Plane) for face in shape.Faces)
    return hull if is_flat else shapely.buffer(hull, STOCK_SAG, join_style="mitre")


def _strips(
    sides: shapely.Geometry, stock: Polygon, radius: float, share: float
) -> shapely.Geometry:
    """Return where the center may go beyond open sides; `share` of R where stock goes on there."""
    solid = grow(stock, radius + APART)
    strips = []
    for line in shapely.get_parts(sides):
        margin = _margin(line, stock)
        far = margin + BEYOND * radius if margin <= 2 * radius else share * radius
        strips.append(shapely.buffer(line, far, cap_style="flat", join_style="mitre"))
        # in the air there is room to turn to both sides
        wide = shapely.buffer(line, far, cap_style="square", join_style="mitre")
        strips.append(shapely.difference(wide, solid))
    return shapely.union_all(strips)


def _margin(line: shapely.LineString, stock: Polygon) -> float:
    """Return how much stock there is beyond an open side at most [mm]."""
    places = shapely.points(shapely.get_coordinates(shapely.segmentize(line, 1.0)))
    inside = shapely.contains(stock, places)
    return float(shapely.distance(stock.exterior, places[inside]).max(initial=0.0))
