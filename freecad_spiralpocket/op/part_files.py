# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a file to a part in a document: STEP, IGES, BREP, FreeCAD, or a pocket's outline.

An outline is a JSON file with `outer`, a list of points [mm], and `holes`, a list
of such lists, the islands; it becomes a block with that pocket, whose top is at Z0.
It may name a cutter diameter `tool` and a largest radial depth of cut `ae`.
"""

from __future__ import annotations

import json
import math
import re
from itertools import pairwise
from pathlib import Path
from typing import Any

import FreeCAD
import Part
import shapely
from FreeCAD import Vector
from shapely import Polygon

from ..engine.errors import SetupError
from .compat import PathJob, original
from .solids import closed

SHAPE_SUFFIXES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
#: What an outline may hold in lists.
SHAPES = ("outer", "holes")
#: Points closer than this are one [mm].
SAME = 1e-9
#: Material around and below the pocket of an outline [mm].
MARGIN = 15.0
BELOW = 5.0


def load(path: Path, depth: float) -> tuple[Any, dict[str, float]]:
    """Open a part file in a document.

    Parameters
    ----------
    path : Path
    depth : float
        Of the pocket, where the file is only an outline [mm].

    Returns
    -------
    document : object
    values : dict
        `tool` and `ae`, where an outline names them [mm].

    Raises
    ------
    SetupError
        If the file cannot be read.
    """
    kind = path.suffix.lower()
    if not path.is_file():
        raise SetupError(f"There is no file {path}.", "Check its name.")
    if kind == ".fcstd":
        try:
            return FreeCAD.openDocument(str(path)), {}
        except (OSError, RuntimeError) as error:
            raise SetupError(f"{path.name} cannot be read.", "Save the document again.") from error
    if kind == ".json":
        outline = _outline(path)
        try:
            values = {k: float(outline[k]) for k in ("tool", "ae") if k in outline}
            _check_rings(path.name, outline["outer"], outline.get("holes", []))
            shape = block(outline["outer"], outline.get("holes", []), depth)
        except (TypeError, ValueError, IndexError, Part.OCCError) as error:
            raise SetupError(
                f"{path.name} has no outline: {error}.",
                'It needs "outer": [[x, y], ...], numbers of millimeters.',
            ) from error
        return _document(path, shape), values
    if kind not in SHAPE_SUFFIXES:
        raise SetupError(
            f"{path.name} is of no known kind.", "Give a STEP, IGES, BREP, FCStd or JSON file."
        )
    try:
        shape = Part.read(str(path))
    except (Part.OCCError, OSError, RuntimeError) as error:
        raise SetupError(f"{path.name} cannot be read.", "Export the part again.") from error
    return _document(path, solid(shape)), {}


def block(outer: Any, holes: Any, depth: float) -> Any:
    """Return a block whose top is at Z0 with a pocket `depth` deep."""
    floor = Part.Face(_wire(outer))
    for hole in holes:  # whichever way round it runs
        floor = floor.cut(Part.Face(_wire(hole)))
    box = floor.BoundBox
    corner = Vector(box.XMin - MARGIN, box.YMin - MARGIN, -depth - BELOW)
    size = (box.XLength + 2 * MARGIN, box.YLength + 2 * MARGIN, depth + BELOW)
    floor.translate(Vector(0, 0, -depth))
    return Part.makeBox(*size, corner).cut(floor.extrude(Vector(0, 0, depth + 1)))


def solid(shape: Any) -> Any:
    """Return `shape`, sewn to solids if it consists of faces only, as IGES files do."""
    found = [] if shape.Solids else closed(shape)
    return Part.Compound(found) if found else shape


def find_job(document: Any) -> Any:
    """Return the only job of `document`, None if there is none.

    Raises
    ------
    SetupError
        If there are several.
    """
    jobs = [o for o in document.Objects if isinstance(getattr(o, "Proxy", 0), PathJob.ObjectJob)]
    if len(jobs) > 1:
        names = ", ".join(j.Label for j in jobs)
        raise SetupError(f"The file has several jobs: {names}.", "Leave one in it.")
    return jobs[0] if jobs else None


def find_part(document: Any, name: str | None) -> Any:
    """Return the solid part called `name`, or the only one.

    Raises
    ------
    SetupError
        If there is none, or the choice is not clear.
    """
    parts = [
        o for o in document.RootObjects if getattr(o, "Shape", None) is not None and o.Shape.Solids
    ]
    if name is not None:
        parts = [o for o in parts if name in (o.Name, o.Label)]
    if not parts:
        what = "no solid part" if name is None else f"no solid part {name}"
        raise SetupError(f"The file has {what}.", "Open it in FreeCAD and check it.")
    if len(parts) > 1:
        raise SetupError(
            f"The file has several parts: {', '.join(o.Label for o in parts)}.",
            "Choose one with --part.",
        )
    return parts[0]


def find_model(job: Any, name: str | None) -> Any:
    """Return the part called `name` of those that a job has, or its first.

    Raises
    ------
    SetupError
        If it has none, or none of that name.
    """
    models = list(job.Model.Group)
    if name is not None:
        models = [m for m in models if name in _names(m) | _names(original(job, m))]
    if not models:
        what = "no model" if name is None else f"no part {name}"
        raise SetupError(f"{job.Label} has {what}.", "Open the file in FreeCAD and check it.")
    return models[0]


def _names(part: Any) -> set[str]:
    return {part.Name, part.Label}


def _document(path: Path, shape: Any) -> Any:
    document = FreeCAD.newDocument(path.stem)
    part = document.addObject("Part::Feature", path.stem)
    part.Label = path.stem
    part.Shape = shape
    document.recompute()
    return document


def _outline(path: Path) -> dict[str, Any]:
    try:
        outline = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise SetupError(f"{path.name} is not JSON: {error}.", "Write it again.") from error
    outer = outline.get("outer") if isinstance(outline, dict) else None
    if not isinstance(outer, list) or len(outer) < 3:
        raise SetupError(
            f"{path.name} has no outline.", 'It needs "outer": [[x, y], ...], three points or more.'
        )
    for key, value in outline.items():
        if isinstance(value, list) and key not in SHAPES:  # perhaps islands, to be cut away
            raise SetupError(
                f'{path.name} has "{key}", which is not understood.',
                'Outlines are "outer", a list of points, and "holes", a list of such lists.',
            )
    return outline


def _check_rings(name: str, outer: Any, holes: Any) -> None:
    """Check that the rings of an outline are such, and each hole an island in it.

    Raises
    ------
    SetupError
    """
    pocket = _area(name, "outer", outer)
    if not isinstance(holes, list):
        raise SetupError(*_no_ring(name, "holes"))
    for i, hole in enumerate(holes):
        island = _area(name, f"holes[{i}]", hole)
        if not island.intersection(Polygon(outer)).area:
            x, y = hole[0]
            raise SetupError(
                f"holes[{i}] of {name}, at X{x:.1f} Y{y:.1f}, lies outside of outer.",
                "Move that island into the pocket, or leave it out.",
            )
        pocket = pocket.difference(island)
    if not pocket.area:
        raise SetupError(
            f"The islands of {name} leave nothing of its pocket.", "Look at its holes."
        )


def _no_ring(name: str, ring: str) -> tuple[str, str]:
    return (
        f"{ring} of {name} is not understood.",
        '"outer" is a list of points [x, y], numbers of millimeters; "holes" a list of such lists.',
    )


def _area(name: str, ring: str, points: Any) -> Polygon:
    """Return what a ring of an outline encloses."""
    try:
        corners = [(float(x), float(y)) for x, y in points]
    except (TypeError, ValueError):
        raise SetupError(*_no_ring(name, ring)) from None
    if not all(math.isfinite(value) for corner in corners for value in corner):
        raise SetupError(*_no_ring(name, ring))
    area = Polygon(corners) if len(corners) > 2 else Polygon()
    if not shapely.convex_hull(area).area:
        raise SetupError(
            f"{ring} of {name} has no area: its points lie on one line.",
            "Give the corners of the ring one after the other.",
        )
    if not area.is_valid:
        x, y = re.findall(r"[-+\d.e]+", shapely.is_valid_reason(area))[-2:]
        raise SetupError(
            f"{ring} of {name} crosses or touches itself at X{float(x):.1f} Y{float(y):.1f}.",
            "Give the corners of the ring one after the other.",
        )
    return area


def _wire(points: Any) -> Any:
    corners = [Vector(x, y, 0) for x, y in points]
    corners = [p for before, p in pairwise([corners[-1], *corners]) if (p - before).Length > SAME]
    return Part.makePolygon([*corners, corners[0]])
