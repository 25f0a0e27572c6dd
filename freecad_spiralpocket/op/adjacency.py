# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of a solid about a level one: which meet it, and where walls rise from it.

Whether a wall rises or falls from an edge shows in the outward normal of the face on the edge's
other side: it leans over the floor where the wall rises and away from it where the wall falls. At a
fillet both are tangent, so there the height of the fillet's face decides. Heights decide as well
where all of the neighbor lies on one side of the floor; bounding boxes alone would be wrong: an
L-shaped side face of a boss is higher than the floor around it, and lower.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import Part

from .level import SAME_HEIGHT

# found on a shape, not on its type, a method or property takes FreeCAD up to fifteen times as long
_CODE = Part.Shape.hashCode
_COUNT = Part.Shape.countSubElements
_OUTER_WIRE = Part.Face.OuterWire.__get__
_ORDERED_EDGES = Part.Wire.OrderedEdges.__get__
_BOX = Part.Shape.BoundBox.__get__
#: Smaller parts of a normal are taken as tangent.
_TANGENT = 1e-3
#: Step from an edge into the floor [mm].
_ASIDE = 1e-3


class Adjacency:
    """The faces of a solid by number: which of them meet, and how high each reaches.

    FreeCAD makes the edges of a face, and computes its box, anew whenever it is asked: with
    thousands of walls that takes longer than the rest.

    Attributes
    ----------
    faces : list of Part.Face
    """

    def __init__(self, solid: Any) -> None:
        self.faces: list[Any] = solid.Faces
        self._numbers = {code: i for i, code in enumerate(map(_CODE, self.faces))}
        self._at: dict[int, list[int]] = {}
        self._edges: list[list[int]] = []
        self._heights: dict[int, tuple[float, float]] = {}
        self._rims: dict[tuple[int | None, int], list[tuple[bool, list[int]]]] = {}
        for i, face in enumerate(self.faces):
            # the edges of wires in their order come sooner than those of faces, an only wire sooner
            # as the outer one
            wires = [_OUTER_WIRE(face)] if _COUNT(face, "Wire") == 1 else face.Wires
            edges = [code for wire in wires for code in map(_CODE, _ORDERED_EDGES(wire))]
            self._edges.append(edges)
            for edge in edges:
                self._at.setdefault(edge, []).append(i)

    def number(self, face: Any) -> int | None:
        """Return the number of a face, None if it is another solid's."""
        return self._numbers.get(_CODE(face))

    def same_as(self, face: Any) -> Any:
        """Return the face of the solid at the place of a level face, None if there is none."""
        number = self.number(face)
        if number is not None:
            return self.faces[number]
        z, center, area = face.BoundBox.ZMin, face.CenterOfMass, face.Area
        for number, other in enumerate(self.faces):
            low, high = self.heights(number)
            if (
                max(abs(low - z), abs(high - z)) < SAME_HEIGHT
                and other.CenterOfMass.isEqual(center, SAME_HEIGHT)
                and abs(other.Area - area) <= SAME_HEIGHT * area
            ):
                return other
        return None

    def at(self, edge: Any) -> list[int]:
        """Return the faces at an edge."""
        return self._at.get(_CODE(edge), [])

    def around(self, face: int) -> set[int]:
        """Return the faces at the edges of a face, itself among them."""
        return {other for edge in self._edges[face] for other in self._at[edge]}

    def along(self, face: Any, wire: Any) -> list[tuple[bool, list[int]]]:
        """Return for each edge of a level face's wire whether a wall rises, and the faces there."""
        key = self.number(face), _CODE(wire)
        if key not in self._rims:
            edges = _ORDERED_EDGES(wire)
            self._rims[key] = [(self.wall_rises(face, edge), self.at(edge)) for edge in edges]
        return self._rims[key]

    def wall_rises(self, face: Any, edge: Any) -> bool:
        """Return whether material rises from an edge of a level face."""
        own = self.number(face)
        other = next((number for number in self.at(edge) if number != own), None)
        return other is not None and _rises_along(self, own, face, other, edge)

    def goes_on(self, face: Any, z: float, faces: Sequence[int]) -> bool:
        """Return whether of the faces at an edge of a level one another is level at Z `z`."""
        own = self.number(face)
        others = (self.heights(number) for number in faces if number != own)
        return any(max(abs(low - z), abs(high - z)) < SAME_HEIGHT for low, high in others)

    def heights(self, face: int) -> tuple[float, float]:
        """Return Z of the lowest and of the highest point of a face [mm]."""
        if face not in self._heights:
            box = _BOX(self.faces[face])
            self._heights[face] = box.ZMin, box.ZMax
        return self._heights[face]


def _rises_along(adjacency: Adjacency, own: int | None, face: Any, other: int, edge: Any) -> bool:
    """Return whether the face of number `other` rises from `edge` of the level one `own`."""
    z, (low, high) = adjacency.heights(own)[0], adjacency.heights(other)
    above, below = high > z + SAME_HEIGHT, low < z - SAME_HEIGHT
    if above != below:
        return bool(above)
    t0, t1 = edge.ParameterRange
    t = (t0 + t1) / 2
    point = edge.valueAt(t)
    inward = FreeCAD.Vector(0, 0, 1).cross(edge.tangentAt(t))
    if inward.Length < _TANGENT:
        return bool(above)
    inward.normalize()
    if not face.isInside(point + inward * _ASIDE, _ASIDE / 10, True):
        inward = inward * -1
    neighbor = adjacency.faces[other]
    lean = neighbor.normalAt(*neighbor.Surface.parameter(point)).dot(inward)
    if abs(lean) > _TANGENT:
        return lean > 0
    return bool(above)


def outer_wire(face: Any) -> Any:
    """Return the wire around a flat face.

    FreeCAD 0.20 mistakes one for it that lies inside and touches it.
    """
    if face.countSubElements("Wire") == 1:
        return face.OuterWire
    return max(face.Wires, key=lambda wire: wire.BoundBox.DiagonalLength)
