# SPDX-License-Identifier: LGPL-2.1-or-later
"""Windows: holes through a part, which have no floor. They are told by any wall of theirs.

A board is laid under the part, as a machinist does. Its top in the window is the floor: all else
is as in any pocket. All faces of a hole that are not level belong together; where they end at a
level face that looks down, within its outline, the hole goes through.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import Part
from FreeCAD import Vector

from .adjacency import Adjacency, outer_wire
from .level import looks
from .seams import face_at, inside

#: The board is so much wider than the face around the window, and so thick [mm].
MARGIN, THICKNESS = 1.0, 1.0


@dataclass(frozen=True)
class Window:
    """A hole through a part.

    Attributes
    ----------
    z : float
        Height of its lower end [mm].
    rim : Part.Wire
        Its edge there.
    under : int
        Number of the level face around it there, which looks down.
    """

    z: float
    rim: Any
    under: int


class Windows:
    """The windows of a solid, each looked for once.

    All that end at one face have one board under them: with dozens of holes a boolean operation for
    each takes longer than all else.

    Parameters
    ----------
    solid : Part.Solid
    adjacency : Adjacency
        Of the solid.
    """

    def __init__(self, solid: Any, adjacency: Adjacency) -> None:
        self.solid, self._adjacency = solid, adjacency
        self._found: dict[int, Window | None] = {}
        self._boarded: dict[int, tuple[Any, Adjacency] | None] = {}
        self._floors: dict[int, Any] = {}

    def of(self, wall: Any) -> Window | None:
        """Return the window that a face of the solid is a wall of, None if it is of none."""
        number = self._adjacency.number(wall)
        if number is None or looks(wall):
            return None
        if number not in self._found:
            walls, window = self._followed(number)
            self._found |= dict.fromkeys(walls, window)
        return self._found[number]

    def floor_of(self, window: Window) -> tuple[Any, Any, Adjacency] | None:
        """Return the solid with a board under a window, the floor on that, and the adjacency.

        None if it fails.
        """
        if window.under not in self._boarded:
            self._boarded[window.under] = self._with_board(window)
        boarded, rim = self._boarded[window.under], window.rim.hashCode()
        if boarded is None:
            return None
        whole, adjacency = boarded
        if rim not in self._floors:
            self._floors[rim] = face_at(whole, window.z, inside(Part.Face(window.rim)))
        face = self._floors[rim]
        return None if face is None else (whole, face, adjacency)

    def _followed(self, wall: int) -> tuple[set[int], Window | None]:
        """Return the walls that belong together with one, and the window that they make."""
        adjacency = self._adjacency
        found: dict[int, Window] = {}
        seen, todo = {wall}, [wall]
        while todo:
            own = todo.pop()
            for other in sorted(adjacency.around(own) - seen):
                face = adjacency.faces[other]
                way = looks(face)
                if way == 0:
                    seen.add(other)
                    todo.append(other)
                elif way < 0:
                    rim = _shared_wire(face, adjacency.faces[own])
                    if rim is None:  # the part's own outline
                        return seen, None
                    found[rim.hashCode()] = Window(face.BoundBox.ZMin, rim, other)
        return seen, next(iter(found.values())) if len(found) == 1 else None

    def _with_board(self, window: Window) -> tuple[Any, Adjacency] | None:
        """Return the solid with a board under the face around a window, None if it fails."""
        box, z = self._adjacency.faces[window.under].BoundBox, window.z
        size = (box.XLength + 2 * MARGIN, box.YLength + 2 * MARGIN, THICKNESS)
        board = Part.makeBox(*size, Vector(box.XMin - MARGIN, box.YMin - MARGIN, z - THICKNESS))
        solids = self.solid.fuse(board).Solids
        return (solids[0], Adjacency(solids[0])) if solids else None


def _shared_wire(face: Any, other: Any) -> Any:
    """Return the wire within the outline of a face that has edges of another; None if none has."""
    edges, outline = {edge.hashCode() for edge in other.Edges}, outer_wire(face)
    for wire in face.Wires:
        if edges & {edge.hashCode() for edge in wire.Edges}:
            return None if wire.isSame(outline) else wire
    return None
