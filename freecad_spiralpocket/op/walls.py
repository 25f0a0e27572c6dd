# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the walls above a floor leave free at any height.

A flat cutter at a height needs the room that is free there and at every height above.
So the free area is the section of the walls at that height, less the shadow of all that
overhangs it. Only the walls that can be reached from the floor over common edges are
cut to find the outline; then whatever else of the solid stands inside it. Other solids of
the job that stand in the pocket or hang over it are kept off like its own islands.

What is free at a side without a wall ends at a fence along the floor's own edge, and what
open_sides.py adds lies beyond it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import shapely
from shapely import Polygon

from ..engine.shapes.points import signed_area
from ..engine.shapes.region import polygons_of
from . import geometry
from .adjacency import outer_wire
from .level import SAME_HEIGHT
from .open_sides import OpenSides, lines_of
from .selection import Floor
from .slices import (
    ABOVE,
    cuts,
    is_level,
    is_vertical,
    over,
    overhang,
    place_on,
    polygons_in,
    section,
    shadow,
    solid_section,
    standing,
)

#: Free ground that comes so far from the solid leads out of it [mm].
FENCE = 1.0
#: What a bridge leaves on its sides is taken for a pocket if it is wider than this [mm].
NARROWEST = 1.0
#: And is one polygon by ways this wide [mm], which no cutter can take.
HAIR = 1e-3


class Walls:
    """The walls that rise from one floor.

    Parameters
    ----------
    floor : Floor
    sag : float
        Largest distance of sections from the true walls [mm].
    use_outline : bool
        Leave out all islands.
    open_sides : OpenSides, optional
        What is added beyond the floor's open sides.
    others : sequence of Part.Solid
        That must not be cut either.

    Attributes
    ----------
    are_others_inside : bool
        Whether one of the others stands in the pocket or hangs over its floor.
    """

    def __init__(
        self,
        floor: Floor,
        sag: float,
        *,
        use_outline: bool = False,
        open_sides: OpenSides | None = None,
        others: Sequence[Any] = (),
    ) -> None:
        self._floor, self._sag, self._use_outline = floor, sag, use_outline
        self._adjacency = floor.adjacency
        self._outline = geometry.polygon(floor, sag, use_outline=use_outline)
        posts = [] if use_outline else list(self._in_holes())
        if posts:
            islands = _islands(section(posts, floor.z, sag, self._outline), self._outline)
            self._outline = polygons_of(shapely.difference(self._outline, islands))[0]
        self._free: dict[float, Polygon | None] = {}
        self._overhangs: dict[int, tuple[Polygon, np.ndarray]] = {}
        self._plain: dict[float, bool] = {}
        self._core: Polygon | None = None
        self._rooms: list[Polygon] = []
        self._hairs: list[Polygon] = []
        reached = list(self._reached(posts))
        self._around = [self._adjacency.faces[face] for face in reached]
        self._heights = [self._adjacency.heights(face) for face in reached]
        self._fence = _fence(floor, sag) if floor.open_edges else None
        self._open = open_sides
        self._others = others
        inside = shapely.intersection(self._others_at(floor.z, self._outline), self._outline)
        self.are_others_inside = not shapely.buffer(inside, -sag).is_empty
        self._widened = self._less_others_standing(self._outline)
        if open_sides is not None:
            self._widened = open_sides.widened(self._widened, floor.z)

    @property
    def outline(self) -> Polygon:
        """Return the floor's own outline, and what lies beyond its open sides."""
        return self._widened

    @property
    def beyond(self) -> shapely.Geometry | None:
        """Return what of the outline lies beyond the floor's open sides."""
        return None if self._open is None else shapely.difference(self._widened, self._outline)

    def are_plain(self, top: float) -> bool:
        """Return whether all walls are vertical and rise to Z `top`, or end together below it."""
        if self.are_others_inside:
            return False
        rim = min(top, max((high for _, high in self._heights), default=top))
        if rim not in self._plain:
            self._plain[rim] = all(
                (low > rim - SAME_HEIGHT and is_level(face)) or is_vertical(face)
                for face, (low, _) in zip(self._around, self._heights, strict=True)
            )
        return self._plain[rim]

    def free(self, z: float) -> Polygon | None:
        """Return what is free at Z `z` and above; None where no wall goes all around.

        Empty if everything is overhung.
        """
        if z not in self._free:
            self._free[z] = self._find_free(z)
        return self._free[z]

    def lacks_rooms(self, free: Polygon) -> bool:
        """Return whether a room beside a bridge is none of what is free higher up."""
        return any(shapely.intersection(r, free).area < r.area / 2 for r in self._rooms)

    def within(self, z: float, outline: Polygon) -> Polygon:
        """Return what is free at Z `z` and above, where no wall goes around.

        That is so beside a hole through a wall, and above the lowest place of the rim. What is
        free within an outline that has walls is taken, and what is free beside it, above a rib
        that ends at a wall, and does not lead out.
        """
        outside, free = self._not_solid(z)
        beside = shapely.difference(free, outline)
        beside = shapely.buffer(shapely.buffer(beside, -ABOVE), ABOVE, join_style="mitre")
        near = shapely.buffer(outline, 2 * ABOVE)
        parts = [
            part
            for part in polygons_of(beside)
            if part.intersects(near) and not part.intersects(outside.exterior)
        ]
        inside = shapely.intersection(free, outline)
        return self._uncovered(z, shapely.union_all([inside, *parts]), outline)

    def ground(self, z: float) -> shapely.Geometry:
        """Return all ground on which no solid of the part is at Z `z`, and some around it."""
        return self._not_solid(z)[1]

    def ledges(self, low: float, high: float) -> list[tuple[float, tuple[float, float]]]:
        """Return Z and a place (x, y) on each level face that looks up between two heights."""
        found = []
        solids = [self._floor.solid, *self._others]
        for face in (face for solid in solids for face in solid.Faces):
            z = face.BoundBox.ZMin
            if low + SAME_HEIGHT < z < high - SAME_HEIGHT and is_level(face):
                found.append((z, place_on(face)))
        return found

    def _in_holes(self) -> Iterator[Any]:
        """Yield the faces that rise past the floor within a hole in it, as those of a post do.

        Walls that rise from a part of the hole's rim are among them.
        """
        floor = self._floor
        # the walls on the rim itself may be a sag off
        holes = shapely.union_all(geometry.holes(floor, self._sag)).buffer(self._sag)
        if holes.is_empty:
            return
        shapely.prepare(holes)
        for face in over(floor.solid.Faces, holes, floor.z):
            box = face.BoundBox
            if not holes.intersects(shapely.box(box.XMin, box.YMin, box.XMax, box.YMax)):
                continue
            for chain in cuts([face], floor.z + ABOVE, self._sag):
                if shapely.intersects_xy(holes, [piece.start for piece in chain]).any():
                    yield face
                    break

    def _reached(self, posts: Sequence[Any]) -> Iterator[int]:
        """Yield the faces above the floor, from edge to edge; none beyond a level top.

        `posts` are faces that no edge of the floor leads to.
        """
        floor, adjacency = self._floor, self._adjacency
        wires = [w for w in floor.face.Wires if self._is_wall(w)]
        seen = {adjacency.number(floor.face)}
        front = [
            face
            for wire in wires
            for rises, faces in adjacency.along(floor.face, wire)
            if rises
            for face in faces
        ]
        front += [number for post in posts if (number := adjacency.number(post)) is not None]
        while front:
            face = front.pop()
            if face in seen:
                continue
            seen.add(face)
            low, high = adjacency.heights(face)
            if high < floor.z + SAME_HEIGHT:
                continue
            yield face
            is_flat = high - low <= SAME_HEIGHT and is_level(adjacency.faces[face])
            if not (is_flat and self._is_summit(face)):
                front += adjacency.around(face) - seen

    def _is_summit(self, face: int) -> bool:
        """Return whether nothing rises from a level face."""
        adjacency = self._adjacency
        z = adjacency.heights(face)[1] + SAME_HEIGHT
        if not any(adjacency.heights(f)[1] > z for f in adjacency.around(face)):
            return True
        flat = adjacency.faces[face]
        higher = (
            e for e in flat.Edges if any(adjacency.heights(f)[1] > z for f in adjacency.at(e))
        )
        return not any(adjacency.wall_rises(flat, e) for e in higher)

    def _is_wall(self, wire: Any) -> bool:
        return not self._use_outline or wire.isSame(outer_wire(self._floor.face))

    def _find_free(self, z: float) -> Polygon | None:
        inside = self._find_inside(z)
        if inside is None or inside.is_empty:
            return inside
        return inside if self._open is None else self._open.widened(inside, z)

    def _find_inside(self, z: float) -> Polygon | None:
        """Return what is free within the walls and the floor's edge at open sides.

        Where a bridge leaves several parts at the floor these are joined by hairs.
        """
        core = self._outline
        if z <= self._floor.z + SAME_HEIGHT:
            free: shapely.Geometry = self._outline
        else:
            if self._core is None:
                self._core = self._find_inside(self._floor.z) or self._outline
            core = self._core
            around = self._fenced(z, core) if self._fence is not None else self._walled(z, core)
            if around is None:
                return None
            free = around
        return self._uncovered(z, free, core)

    def _uncovered(self, z: float, free: shapely.Geometry, core: Polygon) -> Polygon:
        """Return what of free ground nothing hangs over, in one polygon."""
        above = (self._overhang(f, free) for f in over(self._floor.solid.Faces, free, z))
        free = shapely.difference(free, shadow(above, z))
        if self._use_outline:
            free = shapely.union_all([Polygon(part.exterior) for part in polygons_of(free)])
        if self._others and not free.is_empty:
            free = shapely.difference(free, self._others_at(z, free))
        parts = self._parts_at(core, free)
        if self._core is None and len(parts) > 1:
            self._rooms, self._hairs = parts, _hairs(parts)
        return next(iter(polygons_of(shapely.union_all([*parts, *self._hairs]))), Polygon())

    def _parts_at(self, core: Polygon, ground: shapely.Geometry) -> list[Polygon]:
        """Return the parts of ground that have some of `core`, the one with most of it first."""
        parts = [p for p in polygons_of(ground) if p.intersects(self._outline)]
        shares = [shapely.intersection(part, core) for part in parts]
        wide = [not shapely.buffer(share, -NARROWEST / 2).is_empty for share in shares]
        order = sorted(range(len(parts)), key=lambda i: -shares[i].area)
        return [parts[i] for n, i in enumerate(order) if n == 0 or wide[i]]

    def _walled(self, z: float, core: Polygon) -> shapely.Geometry | None:
        """Return what is free within the walls around `core`, None where they are not closed."""
        around = section(self._around, z, self._sag)
        outlines = [p for r in around if signed_area(r) > 0 for p in polygons_in(r)]
        outlines = self._parts_at(core, shapely.MultiPolygon(outlines))
        if not outlines:
            return None
        free = shapely.union_all(outlines)
        if self._use_outline:
            return free
        known = {face.hashCode() for face in self._around}
        faces = over(self._floor.solid.Faces, free, z)
        inside = (f for f in faces if f.hashCode() not in known)
        rings = [*around, *section(inside, z, self._sag, free)]
        return shapely.difference(free, _islands(rings, free))

    def _others_at(self, z: float, area: shapely.Geometry) -> shapely.Geometry:
        """Return the ground near an area on or under which other solids are at `z` or higher."""
        found = [standing(s, area, z, self._sag) for s in self._others if not area.is_empty]
        return shapely.union_all(found)

    def _less_others_standing(self, outline: Polygon) -> Polygon:
        """Return the floor's outline without what others stand on, as it is if they take it all."""
        if not self.are_others_inside:
            return outline
        z = self._floor.z
        feet = shapely.union_all([solid_section(s, z, self._sag) for s in self._others])
        return next(iter(polygons_of(shapely.difference(outline, feet))), outline)

    def _overhang(self, face: Any, free: shapely.Geometry) -> np.ndarray:
        """Return what of a face looks down over free ground, as triangles."""
        key, area = face.hashCode(), shapely.box(*free.bounds)
        if key in self._overhangs:
            known, triangles = self._overhangs[key]
            if known.covers(area):
                return triangles
            area = shapely.box(*shapely.total_bounds([known, area]))
        triangles = overhang(face, area, self._floor.z)
        self._overhangs[key] = area, triangles
        return triangles

    def _not_solid(self, z: float) -> tuple[Polygon, shapely.Geometry]:
        """Return a box around the solid, and what of that is no solid at Z `z`."""
        box = self._floor.solid.BoundBox
        outside = shapely.box(box.XMin, box.YMin, box.XMax, box.YMax).buffer(FENCE)
        solid = solid_section(self._floor.solid, z, self._sag)
        return outside, shapely.difference(outside, solid)

    def _fenced(self, z: float, core: Polygon) -> shapely.Geometry | None:
        """Return what is free up to the fence at the floor's open sides, None if it leaks."""
        outside, free = self._not_solid(z)
        # beyond the ends of an open side the fence runs on to the first wall
        fence = shapely.difference(self._fence, self._outline.buffer(-ABOVE))
        posts = shapely.intersection(fence, free).buffer(ABOVE)
        posts = [p for p in shapely.get_parts(posts) if p.intersects(self._outline)]
        parts = self._parts_at(core, shapely.difference(free, shapely.union_all(posts)))
        inside = shapely.union_all(parts)
        return None if inside.intersects(outside.exterior) else inside


def _islands(rings: list[np.ndarray], free: shapely.Geometry) -> shapely.Geometry:
    """Return what stands within the rings of a section that may be islands in free ground.

    The part's own outside is such a ring too, and all around the pocket.
    """
    inside = [p for r in rings if signed_area(r) < 0 for p in polygons_in(r)]
    return shapely.union_all([p for p in inside if p.area < free.area])


def _hairs(parts: Sequence[Polygon]) -> list[Polygon]:
    """Return the shortest ways that join parts, each to those before it."""
    hairs = []
    for n, part in enumerate(parts[1:], start=1):
        way = shapely.shortest_line(shapely.union_all(parts[:n]), part)
        hairs.append(shapely.buffer(way, HAIR / 2, cap_style="square"))
    return hairs


def _fence(floor: Floor, sag: float) -> shapely.Geometry:
    """Return the open sides of a floor as lines, run on straight beyond their ends."""
    reach = 2 * floor.solid.BoundBox.DiagonalLength
    fences = []
    for pieces in lines_of(floor, sag):
        first, last = pieces[0], pieces[-1]
        before, after = first.start - reach * first.heading, last.end + reach * last.arrival
        corners = [piece.start for piece in pieces]
        fences.append(shapely.linestrings([before, *corners, last.end, after]))
    return shapely.union_all(fences)
