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

from .adjacency import Adjacency, normal_of_plane, outer_wire
from .seams import face_at, inside

#: A face is level whose normal is upright but for this of its length.
LEVEL = 1e-6
#: The board is so much wider than the window all around, and so thick [mm].
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
    """

    z: float
    rim: Any


def window_of(adjacency: Adjacency, wall: Any) -> Window | None:
    """Return the window that a face of a solid is a wall of, None if it is of none."""
    number = adjacency.number(wall)
    if number is None or _looks(wall):
        return None
    found: dict[int, Window] = {}
    seen, todo = {number}, [number]
    while todo:
        own = todo.pop()
        for other in sorted(adjacency.around(own) - seen):
            face = adjacency.faces[other]
            looks = _looks(face)
            if looks == 0:
                seen.add(other)
                todo.append(other)
            elif looks < 0:
                rim = _shared_wire(face, adjacency.faces[own])
                if rim is None:  # the part's own outline
                    return None
                found[rim.hashCode()] = Window(face.BoundBox.ZMin, rim)
    return next(iter(found.values())) if len(found) == 1 else None


def with_board(solid: Any, window: Window) -> tuple[Any, Any] | None:
    """Return a solid with a board under a window, and the floor that it makes; None if it fails."""
    box, z = window.rim.BoundBox, window.z
    size = (box.XLength + 2 * MARGIN, box.YLength + 2 * MARGIN, THICKNESS)
    board = Part.makeBox(*size, Vector(box.XMin - MARGIN, box.YMin - MARGIN, z - THICKNESS))
    whole = solid.fuse(board)
    face = face_at(whole, z, inside(Part.Face(window.rim)))
    return (whole.Solids[0], face) if face is not None and whole.Solids else None


def _looks(face: Any) -> int:
    """Return 1 for a level face that looks up, -1 for one that looks down, 0 for any other."""
    normal = normal_of_plane(face)
    if normal is None or abs(normal.z) < 1 - LEVEL:
        return 0
    return 1 if normal.z > 0 else -1


def _shared_wire(face: Any, other: Any) -> Any:
    """Return the wire within the outline of a face that has edges of another; None if none has."""
    edges, outline = {edge.hashCode() for edge in other.Edges}, outer_wire(face)
    for wire in face.Wires:
        if edges & {edge.hashCode() for edge in wire.Edges}:
            return None if wire.isSame(outline) else wire
    return None
