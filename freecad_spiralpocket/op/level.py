# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which faces are level, which way they look, and which heights are the same."""

from __future__ import annotations

from typing import Any

import Part

#: Heights closer than this are the same [mm].
SAME_HEIGHT = 1e-4
#: A floor may be out of level by this much [rad]: drawings are exact, IGES files are not.
LEVEL_TOLERANCE = 1e-4


def normal_of_plane(face: Any) -> Any:
    """Return the outward normal of a flat face, None for a curved one."""
    if not isinstance(face.Surface, Part.Plane) and face.findPlane() is None:
        return None
    u0, u1, v0, v1 = face.ParameterRange
    return face.normalAt((u0 + u1) / 2, (v0 + v1) / 2)


def looks(face: Any) -> int:
    """Return 1 for a level face that looks up, -1 for one that looks down, 0 for any other."""
    normal = normal_of_plane(face)
    if normal is None or abs(normal.z) < 1 - LEVEL_TOLERANCE**2 / 2:
        return 0
    return 1 if normal.z > 0 else -1


def is_at_one_height(face: Any) -> bool:
    """Return whether all of a face is at one height."""
    return bool(face.BoundBox.ZLength < SAME_HEIGHT)
