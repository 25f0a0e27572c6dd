# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces as triangles that look down, for what hangs over a place.

OCC takes ten seconds and longer for a torus no larger than an O-ring's groove. A face turned about
an axis that fills its range of parameters, as nearly all of them do, is divided here.
"""

from __future__ import annotations

import math
from typing import Any

import FreeCAD
import numpy as np
import Part

from ..engine.model import Floats

#: Triangles are this far off the face at most [mm].
SAG = 5e-3
#: A part of a triangle's normal up to this may be none of its face's.
HARDLY_UP = 0.1
#: Twice the area of triangles that are none, as at the pole of a ball [mm2].
NONE = 1e-12
#: Surfaces turned about an axis that bend both ways.
TURNED = (Part.Toroid, Part.Sphere, Part.SurfaceOfRevolution)
#: Edges at the end of a range of parameters are so near to it [rad or mm], looked at in so many
#: places.
AT_END, PLACES = 1e-6, 5
#: Lines to tell how finely a face is divided, points on each, and most steps.
LINES, PROBES, MOST = 9, 33, 400


def looking_down(face: Any) -> Floats:
    """Return what of a face looks down, or hardly up, as triangles, shape (n, 3, 3) [mm]."""
    if is_patch(face):
        triangles = _divided(face)
    else:
        corners, index = face.tessellate(SAG)
        points = np.array([tuple(c) for c in corners]).reshape(-1, 3)
        triangles = points[np.array(index, int).reshape(-1, 3)]
    a, b, c = np.moveaxis(triangles, 1, 0)
    normals = np.cross(b - a, c - a)
    sizes = np.linalg.norm(normals, axis=1)
    if not sizes.any():
        return triangles
    # all triangles of a face run the same way round, whichever that is
    largest = int(np.argmax(sizes))
    middle = FreeCAD.Vector(*triangles[largest].mean(axis=0))
    outward = np.array(tuple(face.normalAt(*face.Surface.parameter(middle))))
    upward = normals[:, 2] * np.sign(normals[largest] @ outward)
    return triangles[(upward <= HARDLY_UP * sizes) & (sizes > NONE)]


def is_patch(face: Any) -> bool:
    """Return whether a face is turned about an axis and fills its range of parameters."""
    surface = face.Surface
    if not isinstance(surface, TURNED):
        return False
    ends = np.array(face.ParameterRange).reshape(2, 2)
    periods = [2 * math.pi, 2 * math.pi if isinstance(surface, Part.Toroid) else math.inf]
    for edge in face.Edges:
        if edge.Degenerated:
            continue
        for t in np.linspace(*edge.ParameterRange, PLACES):
            place = surface.parameter(edge.valueAt(float(t)))
            off = np.abs(np.array(place)[:, None] - ends)
            if (
                min(off.min(), *(abs(p - o).min() for p, o in zip(periods, off, strict=True)))
                > AT_END
            ):
                return False
    return True


def _divided(face: Any) -> Floats:
    """Return a patch as triangles, shape (n, 3, 3) [mm]."""
    u0, u1, v0, v1 = face.ParameterRange
    along = _grid(face, np.linspace(u0, u1, PROBES), np.linspace(v0, v1, LINES))
    across = _grid(face, np.linspace(u0, u1, LINES), np.linspace(v0, v1, PROBES))
    us = np.linspace(u0, u1, _steps(along) + 1)
    vs = np.linspace(v0, v1, _steps(across.transpose(1, 0, 2)) + 1)
    points = _grid(face, us, vs)
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    halves = (np.stack(corners, axis=2) for corners in ((a, b, c), (a, c, d)))
    return np.concatenate([half.reshape(-1, 3, 3) for half in halves])


def _grid(face: Any, us: Floats, vs: Floats) -> Floats:
    """Return the points of a face's surface at all pairs of parameters, (len(us), len(vs), 3)."""
    value = face.Surface.value
    return np.array([[tuple(value(u, v)) for v in vs] for u in us])


def _steps(lines: Floats) -> int:
    """Return in how many steps lines, shape (n, k, 3) along the first axis, keep the sag."""
    bend = np.linalg.norm(np.diff(lines, 2, axis=0), axis=2).max(initial=0.0)
    steps = (len(lines) - 1) * math.sqrt(bend / 8 / (SAG / 2))
    return min(max(math.ceil(steps), 1), MOST)
