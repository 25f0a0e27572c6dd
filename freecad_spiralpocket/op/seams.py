# SPDX-License-Identifier: LGPL-2.1-or-later
"""Floors that seams cut into several faces, as joined or imprinted solids have them.

Selected faces of one height that meet at an edge are one floor. FreeCAD's own refinement takes the
seams out of the solid; only what was selected is joined.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from .compat import STALE_ELEMENT_ERRORS
from .level import SAME_HEIGHT, is_at_one_height

#: The joined face may differ by so much from the sum of its parts, over that.
SAME_AREA = 1e-6


def groups(selected: Sequence[tuple[Any, str]]) -> list[tuple[Any, tuple[str, ...]]]:
    """Return pairs of model and names of faces, those together that meet at one height."""
    if len(selected) == 1:
        return [(model, (name,)) for model, name in selected]
    edges = [_level_edges(_face(model, name)) for model, name in selected]
    together = _together([(model, own) for (model, _), own in zip(selected, edges, strict=True)])
    return [(selected[which[0]][0], tuple(selected[i][1] for i in which)) for which in together]


def meeting(faces: Sequence[tuple[str, Any]]) -> list[tuple[str, ...]]:
    """Return the names of one shape's faces, those together that meet at one height."""
    together = _together([(None, _level_edges(face)) for _, face in faces])
    return [tuple(faces[i][0] for i in which) for which in together]


def _together(level: Sequence[tuple[Any, set[tuple[int, int]]]]) -> list[list[int]]:
    """Return the numbers of pairs of model and edges, those together that share an edge."""
    found: list[tuple[Any, list[int], set[tuple[int, int]]]] = []
    for number, (model, edges) in enumerate(level):
        numbers = [number]
        for other in [o for o in found if o[0] is model and o[2] & edges]:
            numbers, edges = [*other[1], *numbers], other[2] | edges
            found.remove(other)
        found.append((model, numbers, edges))
    return [numbers for _, numbers, _ in found]


def joined(solid: Any, faces: Sequence[Any]) -> tuple[Any, Any] | None:
    """Return a solid without seams and the face of it that some faces make, None if none does."""
    whole = solid.removeSplitter()
    area, z = sum(face.Area for face in faces), faces[0].BoundBox.ZMin
    face = face_at(whole, z, inside(faces[0]))
    if face is None or abs(face.Area - area) >= SAME_AREA * area:
        return None
    return (whole.Solids[0], face) if whole.Solids else None


def face_at(shape: Any, z: float, place: Any) -> Any:
    """Return the level face of a shape at Z `z` in which a place is, None if there is none."""
    for face in shape.Faces:
        if (
            is_at_one_height(face)
            and abs(face.BoundBox.ZMin - z) < SAME_HEIGHT
            and face.isInside(place, SAME_HEIGHT, True)
        ):
            return face
    return None


def _face(model: Any, name: str) -> Any:
    """Return a model's element, None if it is not there."""
    try:
        return model.Shape.getElement(name)
    except STALE_ELEMENT_ERRORS:
        return None


def _level_edges(face: Any) -> set[tuple[int, int]]:
    """Return the edges of a level face, each with the face's height in tenths of a micrometer."""
    if face is None or face.ShapeType != "Face" or not is_at_one_height(face):
        return set()
    z = round(face.BoundBox.ZMin / SAME_HEIGHT)
    return {(edge.hashCode(), z) for edge in face.Edges}


def inside(face: Any) -> Any:
    """Return a point inside a flat face, the middle of one of its triangles."""
    points, triangles = face.tessellate(0.1)
    a, b, c = (points[i] for i in triangles[0])
    return (a + b + c) * (1 / 3)
