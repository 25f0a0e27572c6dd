# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pocket's section at each level, where its walls are not vertical.

After Chatelain et al. 2008 [CS08], section 3.2: the levels cut the part, each section is
a pocket of its own. The levels end on flat ledges and on tops of low islands too, so that
these are cleared to their own height. A ledge that is selected as a floor itself is left
to that pocket, and this one goes no wider above it. Above the rim, where no wall goes
around any more, a level has the shape of the rim.

Vertical walls, which most pockets have, are found out at once and give no sections.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import shapely
from FreeCAD import Vector
from shapely import Point, Polygon

from ..engine.checks import NESTED
from ..engine.errors import CutterDoesNotFitError, GeometryError
from ..engine.levels import floors
from ..engine.model import PocketRequest, Section
from ..engine.shapes.region import grow, polygons_of
from .belonging import Belonging
from .level import SAME_HEIGHT
from .selection import Floor
from .slices import ABOVE, place_on
from .walls import Walls

#: The height of a rim on a top that is not level is found as well as this [mm].
RIM = 0.02
#: A ledge of which no piece is cleared by more than this share gets no level.
REACHED = 0.5
#: Sections that differ by no more than this many sags are one.
ALIKE = 2.0


def fitted(
    wanted: PocketRequest, floor: Floor, walls: Walls, others: Sequence[Floor], sag: float
) -> PocketRequest:
    """Return a request with the sections of the walls, the same if these are vertical.

    Parameters
    ----------
    wanted : PocketRequest
        With the floor's outline.
    floor : Floor
    walls : Walls
        Of that floor.
    others : sequence of Floor
        That are selected too.
    sag : float
        How far sections may be off [mm].

    Raises
    ------
    CutterDoesNotFitError
        If the part overhangs the whole floor.
    """
    heights = wanted.heights
    if not (heights.step_down > 0 and heights.start_depth > wanted.floor):
        return wanted  # the engine says what is wrong with that
    if walls.are_plain(heights.start_depth):
        return wanted
    shapes = _Shapes(floor, walls, others, heights.start_depth)
    if not shapes.at(wanted.floor).area:
        raise _overhung(floor, walls)
    low, stock = max(floor.z, wanted.floor), wanted.cutting.floor_stock
    inset = wanted.cutter_radius + wanted.cutting.stock_to_leave
    ledges = [z + stock for z in shapes.ledges(low, inset)]
    tops = [heights.start_depth, *floors(heights, stock, ledges)]
    sections = shapes.sections(tops, {z: z - stock for z in ledges}, ALIKE * sag, inset)
    if any(s.pocket.is_empty for s in sections):  # of a floor as narrow as a hair
        raise _overhung(floor, walls)
    pocket = sections[-1].pocket
    if all(s.pocket is pocket and s.mouth is None for s in sections):
        sections = ()
    return replace(wanted, pocket=pocket, sections=sections)


def _overhung(floor: Floor, walls: Walls) -> CutterDoesNotFitError:
    center = floor.face.CenterOfMass
    if walls.are_others_inside:
        return CutterDoesNotFitError(
            "Another part of the job covers the whole floor; no cutter gets there from above.",
            "Take that part out of the job's model.",
            (center.x, center.y),
        )
    return CutterDoesNotFitError(
        "The part overhangs the whole floor; no cutter gets there from above.",
        "Turn the part over, or machine it from another side.",
        (center.x, center.y),
    )


class _Shapes:
    """What a pocket is at each height."""

    def __init__(self, floor: Floor, walls: Walls, others: Sequence[Floor], top: float) -> None:
        self._floor, self._walls = floor, walls
        self._flats = sorted(walls.ledges(floor.z, top + ABOVE), reverse=True)
        self._rim = float("inf")
        self._open_from = dict.fromkeys((False, True), self._rim)
        self._beside: dict[float, Polygon] = {}
        faces = [(o.z, o.face) for o in others if o.part.isSame(floor.part)]
        self._places = [Point(place_on(face)) for _, face in faces]
        for z, place in self._flats:
            taken = any(abs(oz - z) < SAME_HEIGHT and _has(face, place, z) for oz, face in faces)
            if taken and self._widens(z, place):
                self._rim = min(self._rim, z)

    def at(self, z: float) -> Polygon:
        """Return the pocket at Z `z`."""
        try:
            return self._at(z)
        except GeometryError:
            # just above where a wall comes out of the part's side FreeCAD leaves pieces out;
            # what is free a little lower is free here
            return self._at(z - RIM)

    def _at(self, z: float) -> Polygon:
        if z >= self._rim - ABOVE:
            z = self._rim - 2 * ABOVE
        free = self._walled(z)
        if free is not None:
            return free
        if z not in self._beside:
            below = self._below(z, whole=False)
            self._beside[z] = self._walls.within(z, Polygon(below.exterior))
        return self._beside[z]

    def _walled(self, z: float) -> Polygon | None:
        """Return the pocket at Z `z`, None where no wall goes around.

        Rooms beside a bridge whose own walls do not are as below.
        """
        free = self._walls.free(z)
        if free is None or not self._walls.lacks_rooms(free):
            return free
        if z not in self._beside:
            below = self._below(z, whole=True)
            rooms = self._walls.within(z, Polygon(below.exterior))
            self._beside[z] = polygons_of(shapely.union(free, rooms))[0]
        return self._beside[z]

    def _below(self, z: float, *, whole: bool) -> Polygon:
        """Return the pocket below Z `z`, as high as its walls go around, or `whole` around it."""
        for height in (flat - 2 * ABOVE for flat, _ in self._flats if flat - ABOVE < z):
            if self._goes_around(height, whole=whole):
                break
        else:
            height = self._at_rim(z, whole=whole)
        free = self._walled(height)
        return self._walls.outline if free is None else free

    def _at_rim(self, z: float, *, whole: bool) -> float:
        """Return Z of the pocket's rim, where the walls do not go around at Z `z` any more."""
        low, high = self._floor.z, min(z, self._open_from[whole])
        while high - low > RIM:
            middle = (low + high) / 2
            if self._goes_around(middle, whole=whole):
                low = middle
            else:
                high = middle
        self._open_from[whole] = high
        return low

    def _goes_around(self, z: float, *, whole: bool) -> bool:
        """Return whether walls go around at Z `z`, around all rooms if `whole`.

        Not where their outline cannot be told.
        """
        try:
            free = self._walls.free(z)
        except GeometryError:
            return False
        return free is not None and not (whole and self._walls.lacks_rooms(free))

    def ledges(self, low: float, inset: float) -> list[float]:
        """Return the Z of level faces above `low` on which the pocket widens, highest first.

        Not of those that a cutter whose center stays off the walls by `inset` hardly gets to, as in
        notches narrower than it: a level for each would take time and clear nothing.
        """
        found: list[float] = []
        for z, place in self._flats:
            is_new = not found or found[-1] - z > SAME_HEIGHT
            is_between = low + SAME_HEIGHT < z < self._rim - SAME_HEIGHT
            if is_new and is_between and self._widens(z, place) and self._is_reached(z, inset):
                found.append(z)
        return found

    def _is_reached(self, z: float, inset: float) -> bool:
        """Return whether a cutter clears most of any ledge at Z `z`."""
        whole, below = self.at(z), self.at(z - 2 * ABOVE)
        cleared = grow(grow(whole, -inset), inset)
        wider = polygons_of(shapely.difference(whole, below))
        return any(
            shapely.intersection(piece, cleared).area > REACHED * piece.area for piece in wider
        )

    def sections(
        self, tops: Sequence[float], ledges: Mapping[float, float], alike: float, inset: float
    ) -> tuple[Section, ...]:
        """Return the sections at all levels, those alike with one and the same polygon.

        Parameters
        ----------
        tops : sequence of float
            Z of the top of each level, and of the floor [mm].
        ledges : mapping
            Z of the ledge for each level that ends on one.
        alike : float
            How far alike sections may differ [mm].
        inset : float
            How far the cutter's center stays off the walls [mm].
        """
        levels = tops[1:]
        shapes = _nested([self.at(z) for z in levels])
        mouths = self._belonging(shapes, tops, ledges, inset)
        for i in range(len(levels) - 2, -1, -1):
            if _are_alike(shapes[i], shapes[i + 1], alike):
                shapes[i] = shapes[i + 1]  # the lower one lies within the upper one
        return tuple(
            Section(z, shape, None if _are_alike(shape, mouth, alike) else mouth)
            for z, shape, mouth in zip(levels, shapes, mouths, strict=True)
        )

    def _belonging(
        self,
        shapes: list[Polygon],
        tops: Sequence[float],
        ledges: Mapping[float, float],
        inset: float,
    ) -> list[Polygon]:
        """Leave out of the levels' shapes what is none of the pocket; return the levels' mouths."""
        own, found = Belonging(shapes[-1], inset), {}
        part = self._floor.solid.BoundBox.ZMax
        for i in range(len(shapes) - 1, -1, -1):
            shapes[i] = own.of(shapes[i])
            top, bottom = tops[i : i + 2]
            just_below = ledges.get(top, top) - 2 * ABOVE
            if i == 0 or top in ledges or top > part:
                # what is left above the part is no step on its walls
                found[i] = own.reached(self.at(max(min(just_below, part - 2 * ABOVE), bottom)))
            if i > 0 and own.may_have_more(shapes[i - 1]):
                ground = self._walls.ground(just_below if top in ledges else bottom)
                own.leave_out(ground, shapes[i - 1], self._places)
        mouths = [found[i] if i in found else shapes[i - 1] for i in range(len(shapes))]
        levels = zip(mouths, shapes, tops[1:], strict=True)
        return [self._without_selected(*level) for level in levels]

    def _without_selected(self, mouth: Polygon, own: Polygon, bottom: float) -> Polygon:
        """Return a level's mouth without what other selected pockets clear down to its bottom."""
        if not any(mouth.contains(place) for place in self._places):
            return mouth
        ground = polygons_of(shapely.intersection(self._walls.ground(bottom), mouth))
        others = [piece for piece in ground if not piece.intersects(own)]
        cleared = [p for p in others if any(p.contains(place) for place in self._places)]
        rest = polygons_of(shapely.difference(mouth, shapely.union_all(cleared)))
        return next((piece for piece in rest if piece.intersects(own)), mouth)

    def _widens(self, z: float, place: tuple[float, float]) -> bool:
        """Return whether a place is in the pocket just above Z `z`, but not just below."""
        point = Point(place)
        return self.at(z).contains(point) and not self.at(z - 2 * ABOVE).contains(point)


def _has(face: Any, place: tuple[float, float], z: float) -> bool:
    return bool(face.isInside(Vector(*place, z), SAME_HEIGHT, True))


def _nested(shapes: Sequence[Polygon]) -> list[Polygon]:
    """Return sections, highest first, none beyond the one above: nothing gets there from above."""
    found: list[Polygon] = []
    for shape in shapes:
        if found and not shapely.buffer(found[-1], NESTED / 2).covers(shape):
            inside = polygons_of(shapely.intersection(shape, found[-1]))
            shape = inside[0] if inside else Polygon()
        found.append(shape)
    return found


def _are_alike(one: Polygon, other: Polygon, distance: float) -> bool:
    if one is other:
        return True
    return bool(
        shapely.buffer(one, distance).covers(other) and shapely.buffer(other, distance).covers(one)
    )
