# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the walls above a floor leave free at any height.

A flat cutter at a height needs the room that is free there and at every height above.
So the free area is the section of the walls at that height, less the shadow of all that
overhangs it. Only the walls that can be reached from the floor over common edges are
cut to find the outline; then whatever else of the solid stands inside it.

Each line of a section knows its free side from the outward normal of its face, so rings
need no sorting: where free ground lies inside it is an outline, else an island. FreeCAD's
sections exactly in the plane of a face are not reliable, so they are taken a hair above.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import reduce
from typing import Any

import FreeCAD
import numpy as np
import Part
import shapely
from shapely import Polygon

from ..engine.errors import GeometryError
from ..engine.region import polygons_of
from . import geometry
from .selection import SAME_HEIGHT, Floor, wall_rises

#: Sections are taken this far above the height they are for [mm].
ABOVE = 1e-3
#: FreeCAD's sections of curved faces are out by up to this [mm].
RIPPLE = 1e-4
#: Free ground that comes so far from the solid leads out of it [mm].
FENCE = 1.0
#: A part of a normal up to this is none; a plane from a file may be out by so much [rad].
LEVEL = 1e-5
#: Normals are looked at in so many places each way.
PLACES = 9
#: Overhanging faces become triangles this far off at most [mm].
SHADOW_SAG = 2e-3


UP = FreeCAD.Vector(0, 0, 1)


class Walls:
    """The walls that rise from one floor.

    Parameters
    ----------
    floor : Floor
    sag : float
        Largest distance of sections from the true walls [mm].
    use_outline : bool
        Leave out all islands.
    """

    def __init__(
        self,
        floor: Floor,
        sag: float,
        *,
        use_outline: bool = False,
    ) -> None:
        self._floor, self._sag, self._use_outline = floor, sag, use_outline
        self._neighbors = floor.neighbors
        self._outline = geometry.polygon(floor, sag, use_outline=use_outline)
        self._free: dict[float, Polygon | None] = {}
        self._down: dict[int, bool] = {}
        self._plain: dict[float, bool] = {}
        self._around = list(self._reached())
        self._fence = _fence(floor, sag) if floor.open_edges else None

    @property
    def outline(self) -> Polygon:
        """Return the floor's own outline."""
        return self._outline

    def are_plain(self, top: float) -> bool:
        """Return whether all walls are vertical and rise to Z `top`, or end together below it."""
        heights = [self._neighbors.heights(face) for face in self._around]
        rim = min(top, max((high for _, high in heights), default=top))
        if rim not in self._plain:
            self._plain[rim] = all(
                (low > rim - SAME_HEIGHT and is_level(face)) or is_vertical(face)
                for face, (low, _) in zip(self._around, heights, strict=True)
            )
        return self._plain[rim]

    def free(self, z: float) -> Polygon | None:
        """Return what is free at Z `z` and above; None where no wall goes all around.

        Empty if everything is overhung.
        """
        if z not in self._free:
            self._free[z] = self._find_free(z)
        return self._free[z]

    def ledges(self, low: float, high: float) -> list[tuple[float, tuple[float, float]]]:
        """Return Z and a place (x, y) on each level face that looks up between two heights."""
        found = []
        for face in self._floor.solid.Faces:
            z = face.BoundBox.ZMin
            if low + SAME_HEIGHT < z < high - SAME_HEIGHT and is_level(face):
                found.append((z, place_on(face)))
        return found

    def _reached(self) -> Iterator[Any]:
        """Yield the faces above the floor, from edge to edge; none beyond a level top."""
        floor = self._floor
        wires = [w for w in floor.face.Wires if self._is_wall(w)]
        seen = {floor.face.hashCode()}
        front = [
            face
            for wire in wires
            for edge in wire.Edges
            if wall_rises(floor.neighbors, floor.face, edge)
            for face in self._neighbors.at(edge)
        ]
        while front:
            face = front.pop()
            key = face.hashCode()
            if key in seen:
                continue
            seen.add(key)
            low, high = self._neighbors.heights(face)
            if high < floor.z + SAME_HEIGHT:
                continue
            yield face
            if high - low <= SAME_HEIGHT and is_level(face) and self._is_summit(face):
                continue
            front += self._neighbors.around(face)

    def _is_summit(self, face: Any) -> bool:
        """Return whether nothing rises from a level face."""
        z = self._neighbors.heights(face)[1] + SAME_HEIGHT
        if not any(self._neighbors.heights(f)[1] > z for f in self._neighbors.around(face)):
            return True
        higher = (
            e
            for e in face.Edges
            if any(self._neighbors.heights(f)[1] > z for f in self._neighbors.at(e))
        )
        return not any(wall_rises(self._neighbors, face, e) for e in higher)

    def _is_wall(self, wire: Any) -> bool:
        return not self._use_outline or wire.isSame(self._floor.face.OuterWire)

    def _find_free(self, z: float) -> Polygon | None:
        if z <= self._floor.z + SAME_HEIGHT:
            free = self._outline
        elif self._fence is not None:
            inside = self._fenced(z)
            if inside is None:
                return None
            free = inside
        else:
            around = self._section(self._around, z)
            outlines = [p for r in around if _area(r) > 0 for p in _polygons(r)]
            outlines = [p for p in outlines if p.intersects(self._outline)]
            if not outlines:
                return None
            free = max(outlines, key=lambda p: p.intersection(self._outline).area)
            if not self._use_outline:
                known = {face.hashCode() for face in self._around}
                inside = (f for f in self._over(free, z) if f.hashCode() not in known)
                islands = [r for r in (*around, *self._section(inside, z)) if _area(r) < 0]
                solid = shapely.union_all([p for r in islands for p in _polygons(r)])
                free = shapely.difference(free, solid)
        free = shapely.difference(free, self._shadow(free, z))
        parts = [p for p in polygons_of(free) if p.intersects(self._outline)]
        if not parts:
            return Polygon()
        return Polygon(parts[0].exterior) if self._use_outline else parts[0]

    def _fenced(self, z: float) -> Polygon | None:
        """Return what is free up to the fence at the floor's open sides, None if it leaks."""
        rings = self._section(self._floor.solid.Faces, z)
        areas = (p for r in rings for p in _polygons(r))
        solid = reduce(shapely.symmetric_difference, areas, Polygon())
        box = self._floor.solid.BoundBox
        outside = shapely.box(box.XMin, box.YMin, box.XMax, box.YMax).buffer(FENCE)
        free = shapely.difference(outside, solid)
        # beyond the ends of an open side the fence runs on to the first wall
        fence = shapely.difference(self._fence, self._outline.buffer(-ABOVE))
        posts = shapely.intersection(fence, free).buffer(ABOVE)
        posts = [p for p in shapely.get_parts(posts) if p.intersects(self._outline)]
        parts = polygons_of(shapely.difference(free, shapely.union_all(posts)))
        inside = max(parts, key=lambda p: p.intersection(self._outline).area)
        return None if inside.intersects(outside.exterior) else inside

    def _over(self, area: Polygon, z: float) -> Iterator[Any]:
        """Yield the faces that reach above `z` over the bounds of an area."""
        x0, y0, x1, y1 = area.bounds
        for face in self._floor.solid.Faces:
            box = face.BoundBox
            beside = box.XMax < x0 or box.XMin > x1 or box.YMax < y0 or box.YMin > y1
            if box.ZMax > z + ABOVE and not beside:
                yield face

    def _section(self, faces: Iterable[Any], z: float) -> list[np.ndarray]:
        """Return the closed rings in which a plane cuts faces, free ground on their left."""
        chains = []
        for face in faces:
            box = face.BoundBox
            if box.ZMin < z + ABOVE < box.ZMax:
                try:
                    edges = [e for wire in face.slice(UP, z + ABOVE) for e in wire.Edges]
                    chains += [_sided(edge, face, self._sag) for edge in edges]
                except (Part.OCCError, RuntimeError) as error:
                    place = face.CenterOfMass
                    raise GeometryError(
                        f"The wall at {{at}} cannot be cut at Z{z:g}: {error}.",
                        "Repair the part (Part workbench, Check Geometry).",
                        (place.x, place.y),
                    ) from error
        return [geometry.ring_points(ring) for ring in _rings(chains)]

    def _looks_down(self, face: Any) -> bool:
        key = face.hashCode()
        if key not in self._down:
            self._down[key] = looks_down(face)
        return self._down[key]

    def _shadow(self, area: Polygon, z: float) -> shapely.Geometry:
        """Return what overhangs an area above `z`."""
        triangles = []
        for face in self._over(area, z):
            if self._looks_down(face):
                corners, index = face.tessellate(SHADOW_SAG)
                points = np.array([tuple(c) for c in corners])
                triangles += [_above(points[list(i)], z) for i in index]
        shadows = [shapely.MultiPoint(t[:, :2]).convex_hull for t in triangles if len(t) > 2]
        # a hair, so that what is vertical has an area and is no sliver
        return shapely.union_all(shadows).buffer(SHADOW_SAG, quad_segs=2)


def _fence(floor: Floor, sag: float) -> shapely.Geometry:
    """Return the open sides of a floor as lines, run on straight beyond their ends."""
    lines = []
    for edge in floor.face.OuterWire.Edges:
        if not wall_rises(floor.neighbors, floor.face, edge):
            pieces = geometry.pieces_of(edge, sag)
            first, last = pieces[0], pieces[-1]
            reach = 2 * floor.solid.BoundBox.DiagonalLength
            corners = [piece.start for piece in pieces] + [last.end]
            before, after = first.start - reach * first.heading, last.end + reach * last.arrival
            lines.append(shapely.linestrings([before, *corners, after]))
    return shapely.union_all(lines)


def is_level(face: Any) -> bool:
    """Return whether a face is flat, level and looks up."""
    if face.BoundBox.ZLength > SAME_HEIGHT:
        return False
    return bool(_normals(face)[:, 2].min() > 1 - LEVEL)


def is_vertical(face: Any) -> bool:
    """Return whether a face is vertical everywhere."""
    return bool(np.abs(_normals(face)[:, 2]).max() < LEVEL)


def looks_down(face: Any) -> bool:
    """Return whether a face looks down anywhere."""
    return bool(_normals(face)[:, 2].min() < -LEVEL)


def place_on(face: Any) -> tuple[float, float]:
    """Return a place on a flat face, (x, y) [mm], well inside of it."""
    corners, triangles = face.tessellate(0.1)
    points = np.array([tuple(c)[:2] for c in corners])
    largest = max((points[list(t)] for t in triangles), key=lambda t: abs(_area(t)), default=points)
    x, y = largest.mean(axis=0)
    return float(x), float(y)


def _normals(face: Any) -> np.ndarray:
    """Return the outward normals in a grid of places, shape (n, 3); one for a plane."""
    u0, u1, v0, v1 = face.ParameterRange
    if isinstance(face.Surface, Part.Plane):
        return np.array([tuple(face.normalAt((u0 + u1) / 2, (v0 + v1) / 2))])
    shares = (np.arange(PLACES) + 0.5) / PLACES
    us, vs = (a + (b - a) * shares for a, b in ((u0, u1), (v0, v1)))
    return np.array([tuple(face.normalAt(u, v)) for u in us for v in vs])


def _sided(edge: Any, face: Any, sag: float) -> list[geometry.Piece]:
    """Return an edge of a section as pieces with free ground on their left."""
    pieces = geometry.pieces_of(edge, sag, RIPPLE)
    t0, t1 = edge.ParameterRange
    middle = (t0 + t1) / 2
    tangent = edge.tangentAt(middle)
    normal = face.normalAt(*face.Surface.parameter(edge.valueAt(middle)))
    is_left = tangent.x * normal.y - tangent.y * normal.x > 0
    return pieces if is_left else geometry.turned(pieces)


def _rings(chains: list[list[geometry.Piece]]) -> list[list[geometry.Piece]]:
    """Return the closed rings that chains form head to tail."""
    left, rings = list(chains), []
    while left:
        ring = list(left.pop())
        while np.linalg.norm(ring[-1].end - ring[0].start) > geometry.GAP or len(ring) == 1:
            gaps = [float(np.linalg.norm(c[0].start - ring[-1].end)) for c in left]
            nearest = int(np.argmin(gaps)) if gaps else -1
            if nearest < 0 or gaps[nearest] > geometry.GAP:
                break
            ring += left.pop(nearest)
        else:
            rings.append(ring)
    return rings


def _polygons(ring: np.ndarray) -> list[Polygon]:
    """Return a ring as a polygon; several or none where it touches itself."""
    if len(ring) < 3:
        return []
    return polygons_of(shapely.make_valid(Polygon(ring)))


def _area(ring: np.ndarray) -> float:
    """Return the signed area of a ring, shape (n, 2) [mm2]."""
    x, y = ring.T
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2


def _above(triangle: np.ndarray, z: float) -> np.ndarray:
    """Return the corners of the part of a triangle above `z`, shape (n, 3)."""
    corners = []
    for a, b in zip(triangle, np.roll(triangle, -1, axis=0), strict=True):
        if a[2] >= z:
            corners.append(a)
        if (a[2] - z) * (b[2] - z) < 0:
            corners.append(a + (b - a) * (z - a[2]) / (b[2] - a[2]))
    return np.array(corners).reshape(-1, 3)
