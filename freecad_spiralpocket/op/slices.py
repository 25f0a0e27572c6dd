# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids cut by level planes, and what of them hangs over a place.

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
from ..engine.shapes.points import signed_area
from ..engine.shapes.region import polygons_of
from . import geometry
from .level import is_at_one_height, looks
from .triangles import SAG, is_patch, looking_down

#: Where triangles nearly meet they are joined on a grid so fine [mm].
GRID = 1e-7
#: Sections are taken this far above the height they are for [mm].
ABOVE = 1e-3
#: Now and then FreeCAD leaves a piece out, but not at all of these heights, over that; up to the
#: last just above where a wall comes out of the part's side.
TRIES = (1.0, 2.0, 0.5, 10.0)
#: FreeCAD's sections of curved faces are out by up to this [mm].
RIPPLE = 1e-4
#: A wall is vertical that leans by no more than this [rad].
LEANS = 1e-5
#: Normals are looked at in so many places each way.
PLACES = 9
#: Faces that become few triangles, since they bend one way at most.
BEND_ONCE = (Part.Plane, Part.Cylinder, Part.Cone, Part.SurfaceOfExtrusion)
#: All others are cut off so far around the area for which they are asked [mm].
ASIDE = 1.0
#: What is cut off and what stays may differ by so much from the whole face, over that.
SAME_AREA = 1e-3

UP = FreeCAD.Vector(0, 0, 1)

Pieces = list[geometry.Piece]


def over(faces: Iterable[Any], area: shapely.Geometry, z: float) -> Iterator[Any]:
    """Yield the faces that reach above `z` over the bounds of an area."""
    x0, y0, x1, y1 = area.bounds
    for face in faces:
        box = face.BoundBox
        beside = box.XMax < x0 or box.XMin > x1 or box.YMax < y0 or box.YMin > y1
        if box.ZMax > z + ABOVE and not beside:
            yield face


def section(
    faces: Iterable[Any], z: float, sag: float, within: Polygon | None = None
) -> list[np.ndarray]:
    """Return the closed rings in which a plane cuts faces, free ground on their left.

    Parameters
    ----------
    faces : iterable of Part.Face
    z : float
        Height of the plane [mm].
    sag : float
        Largest distance of the rings from the faces [mm].
    within : shapely.Polygon, optional
        Where no face is missing, so that no ring ends; everywhere if None.

    Raises
    ------
    GeometryError
        If a ring is not closed.
    """
    cut, place = list(faces), None
    for share in TRIES:
        rings, broken = _rings(cuts(cut, z + share * ABOVE, sag))
        place = _open_end(broken, within)
        if place is None:
            return [geometry.ring_points(ring) for ring in rings]
    raise GeometryError(
        f"The walls' outline at Z{z:g} is not closed at {{at}}.",
        "Repair the part (Part workbench, Check Geometry).",
        place,
    )


def cuts(faces: Iterable[Any], z: float, sag: float) -> list[Pieces]:
    """Return the edges in which the plane at `z` cuts faces, free ground on their left."""
    chains = []
    for face in faces:
        if face.BoundBox.ZMin < z < face.BoundBox.ZMax:
            try:
                edges = [e for wire in face.slice(UP, z) for e in wire.Edges]
                chains += [_sided(edge, face, sag) for edge in edges]
            except (Part.OCCError, RuntimeError) as error:
                place = face.CenterOfMass
                raise GeometryError(
                    f"The wall at {{at}} cannot be cut at Z{z:.2f}: {error}.",
                    "Repair the part (Part workbench, Check Geometry).",
                    (place.x, place.y),
                ) from error
    return chains


def solid_section(solid: Any, z: float, sag: float) -> shapely.Geometry:
    """Return what of a solid lies in a level plane."""
    areas = (p for ring in section(solid.Faces, z, sag) for p in polygons_in(ring))
    return reduce(shapely.symmetric_difference, areas, Polygon())


def overhang(face: Any, area: shapely.Geometry, z: float) -> np.ndarray:
    """Return what of a face looks down over the bounds of an area above `z`, and maybe more.

    Parameters
    ----------
    face : Part.Face
    area : shapely.Geometry
    z : float
        [mm]

    Returns
    -------
    ndarray of shape (n, 3, 3)
        Triangles by their corners [mm].
    """
    none = np.empty((0, 3, 3))
    if not looks_down(face):
        return none
    whole = isinstance(face.Surface, BEND_ONCE) or is_patch(face)
    parts = [face] if whole else _clipped(face, area.bounds, z)
    triangles = np.concatenate([none, *map(looking_down, filter(looks_down, parts))])
    x0, y0, x1, y1 = area.bounds
    low, high = triangles.min(axis=1), triangles.max(axis=1)
    beside = (high[:, 0] < x0) | (low[:, 0] > x1) | (high[:, 1] < y0) | (low[:, 1] > y1)
    return triangles[~beside & (high[:, 2] > z)]


def standing(solid: Any, area: shapely.Geometry, z: float, sag: float) -> shapely.Geometry:
    """Return the ground near an area on which, or under which, a solid is at `z` or higher."""
    faces = list(over(solid.Faces, area, z))
    if not faces:
        return Polygon()
    here = shapely.intersection(solid_section(solid, z, sag), shapely.box(*area.bounds))
    return shapely.union(here, shadow((overhang(face, area, z) for face in faces), z))


def shadow(faces: Iterable[np.ndarray], z: float) -> shapely.Geometry:
    """Return the ground under faces, given as triangles, as far as they are above `z`."""
    # what ends at that height, as the side of a part below an open slot, hangs over nothing
    corners = [piece[:, :, :2] for face in faces for piece in _above(face, z + ABOVE)]
    shadows = [shapely.convex_hull(shapely.multipoints(c)) for c in corners if len(c)]
    ground = _union(np.concatenate(shadows)) if shadows else Polygon()
    # a hair, so that what is vertical has an area and is no sliver
    return ground.buffer(SAG, quad_segs=2)


def _union(parts: np.ndarray) -> shapely.Geometry:
    """Return the union of polygons, lines and points.

    Of polygons whose edges nearly coincide, GEOS may leave one out without a word.
    """
    whole = shapely.union_all(parts)
    shapely.prepare(whole)
    middles = shapely.get_coordinates(shapely.centroid(parts))
    solid = shapely.area(parts) > 0
    if shapely.contains_xy(whole, middles)[solid].all():
        return whole
    return shapely.union_all(parts, grid_size=GRID)


def _clipped(face: Any, bounds: tuple[float, float, float, float], z: float) -> list[Any]:
    """Return the parts of a face in bounds (xmin, ymin, xmax, ymax) above `z`, and a little more.

    That is the whole face where FreeCAD loses something of it.
    """
    box = face.BoundBox
    x0, y0, x1, y1 = (b + ASIDE * sign for b, sign in zip(bounds, (-1, -1, 1, 1), strict=True))
    if x0 < box.XMin and y0 < box.YMin and x1 > box.XMax and y1 > box.YMax and z < box.ZMin:
        return [face]
    low = z - ASIDE
    corner = FreeCAD.Vector(x0, y0, low)
    block = Part.makeBox(x1 - x0, y1 - y0, max(box.ZMax - low, 0.0) + ASIDE, corner)
    inside, outside = face.common(block), face.cut(block)
    is_whole = abs(inside.Area + outside.Area - face.Area) <= SAME_AREA * face.Area
    return list(inside.Faces) if is_whole else [face]


def is_level(face: Any) -> bool:
    """Return whether a face is flat, level and looks up."""
    return is_at_one_height(face) and looks(face) > 0


def is_vertical(face: Any) -> bool:
    """Return whether a face is vertical everywhere."""
    surface = face.Surface
    if isinstance(surface, Part.Plane):
        return bool(abs(surface.Axis.z) < LEANS)
    return bool(np.abs(_normals(face)[:, 2]).max() < LEANS)


def looks_down(face: Any) -> bool:
    """Return whether a face looks down anywhere."""
    return bool(_normals(face)[:, 2].min() < -LEANS)


def place_on(face: Any) -> tuple[float, float]:
    """Return a place on a flat face, (x, y) [mm], well inside of it."""
    corners, triangles = face.tessellate(0.1)
    points = np.array([tuple(c)[:2] for c in corners])
    largest = max(
        (points[list(t)] for t in triangles), key=lambda t: abs(signed_area(t)), default=points
    )
    x, y = largest.mean(axis=0)
    return float(x), float(y)


def polygons_in(ring: np.ndarray) -> list[Polygon]:
    """Return a ring as a polygon; several or none where it touches itself."""
    if len(ring) < 3:
        return []
    return polygons_of(shapely.make_valid(Polygon(ring)))


def _normals(face: Any) -> np.ndarray:
    """Return the outward normals in a grid of places, shape (n, 3); one for a plane."""
    u0, u1, v0, v1 = face.ParameterRange
    if isinstance(face.Surface, Part.Plane):
        return np.array([tuple(face.normalAt((u0 + u1) / 2, (v0 + v1) / 2))])
    shares = (np.arange(PLACES) + 0.5) / PLACES
    us, vs = (a + (b - a) * shares for a, b in ((u0, u1), (v0, v1)))
    return np.array([tuple(face.normalAt(u, v)) for u in us for v in vs])


def _sided(edge: Any, face: Any, sag: float) -> Pieces:
    """Return an edge of a section as pieces with free ground on their left."""
    pieces = geometry.pieces_of(edge, sag, RIPPLE)
    t0, t1 = edge.ParameterRange
    middle = (t0 + t1) / 2
    tangent = edge.tangentAt(middle)
    normal = face.normalAt(*face.Surface.parameter(edge.valueAt(middle)))
    is_left = tangent.x * normal.y - tangent.y * normal.x > 0
    return pieces if is_left else geometry.turned(pieces)


def _rings(chains: list[Pieces]) -> tuple[list[Pieces], list[Pieces]]:
    """Return the closed rings that chains form head to tail, and what stays open."""
    starts = np.array([chain[0].start for chain in chains]).reshape(-1, 2)
    ends = np.array([chain[-1].end for chain in chains]).reshape(-1, 2)
    is_left = np.ones(len(chains), bool)
    rings: list[Pieces] = []
    broken: list[Pieces] = []
    for number in reversed(range(len(chains))):
        if not is_left[number]:
            continue
        ring = list(chains[number])
        is_left[number] = False
        while not _is_closed(ring):
            place, found = len(ring), _nearest(starts, ring[-1].end, is_left)
            if found is None:
                place, found = 0, _nearest(ends, ring[0].start, is_left)
            if found is None:
                break
            ring[place:place] = chains[found]
            is_left[found] = False
        (rings if _is_closed(ring) else broken).append(ring)
    return rings, broken


def _is_closed(ring: Pieces) -> bool:
    return len(ring) > 1 and _gap(ring[-1].end, ring[0].start) <= geometry.GAP


def _gap(one: np.ndarray, other: np.ndarray) -> float:
    return float(np.hypot(*(one - other)))


def _nearest(places: np.ndarray, end: np.ndarray, is_left: np.ndarray) -> int | None:
    """Return the number of the nearest place among those left that meets an end, None if none."""
    gaps = np.where(is_left, np.hypot(*(places - end).T), np.inf)
    nearest = int(np.argmin(gaps))
    return nearest if gaps[nearest] <= geometry.GAP else None


def _open_end(broken: list[Pieces], within: Polygon | None) -> tuple[float, float] | None:
    """Return where a chain that is not closed ends, (x, y), if all of it should be there."""
    for chain in broken:
        if len(chain) == 1 and _gap(chain[0].start, chain[0].end) <= geometry.GAP:
            continue  # a speck
        for x, y in (chain[-1].end, chain[0].start):
            if within is None or shapely.contains_xy(within, x, y):
                return float(x), float(y)
    return None


def _above(triangles: np.ndarray, z: float) -> list[np.ndarray]:
    """Return the parts of triangles above `z` by their corners, arrays of shape (n, k, 3)."""
    is_above = triangles[:, :, 2] >= z
    count = is_above.sum(axis=1)

    def cut(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        return a + (b - a) * ((z - a[:, 2]) / (b[:, 2] - a[:, 2]))[:, None]

    # the corner that is alone first, the others in their order
    tips = triangles[count == 1]
    first = np.argmax(is_above[count == 1], axis=1)
    a, b, c = (tips[np.arange(len(tips)), (first + i) % 3] for i in range(3))
    rest = triangles[count == 2]
    first = np.argmin(is_above[count == 2], axis=1)
    d, e, f = (rest[np.arange(len(rest)), (first + i) % 3] for i in range(3))
    return [
        triangles[count == 3],
        np.stack([a, cut(a, b), cut(a, c)], axis=1),
        np.stack([cut(d, e), e, f, cut(d, f)], axis=1),
    ]
