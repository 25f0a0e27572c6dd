# SPDX-License-Identifier: LGPL-2.1-or-later
"""From what the user selected to floors of pockets, or a sentence that says why not.

A floor is a flat, level face of a solid that looks up and has a wall rising from
its outline, or an island standing on it (adjacency.py), or is lower than the solid is
elsewhere; that of a window is laid under it (windows.py).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from ..engine.errors import SelectionError, SetupError
from . import seams, windows
from .adjacency import Adjacency, outer_wire
from .compat import STALE_ELEMENT_ERRORS, PathUtil
from .known import Known
from .level import LEVEL_TOLERANCE, SAME_HEIGHT, is_at_one_height, looks, normal_of_plane
from .solids import solids_of

#: Copies of a solid may differ by so much, over its volume.
SAME_VOLUME = 1e-6

_PICK_A_FLOOR = (
    "Select the floor of the pocket, a flat level face with walls around it, or a wall of a hole "
    "through the part that ends at one level face below."
)
#: Where seams part a floor.
PICK_ALL = "Select all faces that make the floor, or refine the part."


@dataclass(frozen=True)
class Floor:
    """The floor of a pocket.

    Attributes
    ----------
    model : object
        FreeCAD's document object, as the operation refers to it.
    name : str
        Of the face, such as "Face12", or of the faces that make it.
    face, solid : Part.Face, Part.Solid
    z : float
        Height of the floor [mm].
    open_edges : int
        How many edges of the outline have no wall.
    goes_on : bool
        Whether another face of the solid carries it on beyond its outline.
    adjacency : Adjacency
        Of the solid.
    part : Part.Solid
        The part's own solid, where that has no board under a window.
    """

    model: Any
    name: str
    face: Any
    solid: Any
    z: float
    open_edges: int
    goes_on: bool
    adjacency: Adjacency
    part: Any

    @property
    def is_window(self) -> bool:
        """Return whether it is a board under a window."""
        return not self.part.isSame(self.solid)

    @property
    def names(self) -> list[str]:
        """Return the name of each face that makes it."""
        return self.name.split(", ")

    @property
    def label(self) -> str:
        """Return what the user calls it, such as "Rib, Face12"."""
        return label(self.model, self.name)


def label(model: Any, name: str) -> str:
    """Return what the user calls a face: by the part, where `model` is the job's copy of it."""
    return f"{_name_of(model)}, {name.replace('?', '')}"


def _name_of(model: Any) -> str:
    part = next(iter(getattr(model, "Objects", ())), model)
    return str(part.Label)


def selected(base: list[tuple[Any, Any]]) -> list[tuple[Any, str]]:
    """Return the pairs of model and element name in FreeCAD's list `base`, each once.

    Raises
    ------
    SelectionError
        If there are none.
    """
    pairs: dict[tuple[str, str], tuple[Any, str]] = {}
    for model, names in base or []:
        for name in [names] if isinstance(names, str) else names:
            if name:
                pairs.setdefault((model.Name, name), (model, name))
    if not pairs:
        raise SelectionError("No face is selected.", _PICK_A_FLOOR)
    return list(pairs.values())


def floor(
    model: Any,
    names: str | Sequence[str],
    known: Known | None = None,
    shape: Any = None,
) -> Floor:
    """Return the floor that one face of `model` is, or several that meet.

    Parameters
    ----------
    model : object
    names : str or sequence of str
    known : Known, optional
        Is added to.
    shape : object, optional
        The model's, fetched before: that of a link or a group is another one each time.

    Raises
    ------
    SelectionError
        If it is no face, not there, or not the floor of a pocket in a closed solid.
    """
    names = [names] if isinstance(names, str) else names
    known = known or Known()
    where = label(model, ", ".join(names))
    shape = model.Shape if shape is None else shape
    faces = [_element(shape, label(model, name), name) for name in names]
    if any(face.ShapeType != "Face" for face in faces):
        raise SelectionError(f"{where} is not a face.", _PICK_A_FLOOR)
    if not is_at_one_height(faces[0]):
        window = _window(model, names[0], shape, faces[0], known)
        if window is not None:
            return window
    for face in faces:
        _check_level(face, where)
    solid, adjacency = _solid_of(shape, faces[0], where, known)
    faces = [adjacency.same_as(face) or face for face in faces]
    face = faces[0]
    if looks(face) < 0:
        raise SelectionError(
            f"{where} looks down.", "Select the floor of the pocket, or turn the part over."
        )
    if len(faces) > 1:
        whole = seams.joined(solid, faces)
        if whole is None:
            raise SelectionError(
                f"{where} meet, but do not make one floor.",
                "Refine the part (Part workbench, Refine Shape), or select one of them.",
            )
        solid, face = whole
        adjacency = Adjacency(solid)
    around = adjacency.along(face, outer_wire(face))
    z = face.BoundBox.ZMin
    walled = sum(rises for rises, _ in around)
    goes_on = any(adjacency.goes_on(face, z, faces) for _, faces in around)
    is_top = z > solid.BoundBox.ZMax - SAME_HEIGHT
    has_walls = any(r for wire in face.Wires for r, _ in adjacency.along(face, wire))
    if not walled and not has_walls and (is_top or goes_on):
        raise SelectionError(
            f"{where} is not the floor of a pocket: no wall rises from it.",
            PICK_ALL if goes_on else _PICK_A_FLOOR,
        )
    open_edges = len(around) - walled
    # without seams it is another solid, of the same part
    return Floor(model, ", ".join(names), face, solid, z, open_edges, goes_on, adjacency, solid)


def _window(model: Any, name: str, shape: Any, wall: Any, known: Known) -> Floor | None:
    """Return the floor under the window that a face is a wall of, None if it is of none."""
    through = _windows_of(shape, wall, label(model, name), known)
    window = through.of(wall)
    found = None if window is None else through.floor_of(window)
    if window is None or found is None:
        return None
    solid, face, around = found
    return Floor(model, name, face, solid, window.z, 0, False, around, through.solid)


def _windows_of(shape: Any, wall: Any, where: str, known: Known) -> windows.Windows:
    """Return the windows of the solid that a face bounds."""
    solid, adjacency = _solid_of(shape, wall, where, known)
    key = solid.hashCode()
    if key not in known.windows:
        known.windows[key] = windows.Windows(solid, adjacency)
    return known.windows[key]


def heights(base: list[tuple[Any, Any]], known: Known | None = None) -> list[float]:
    """Return the heights of the level faces in FreeCAD's list `base` [mm], and of windows.

    Without the rest. `known` is added to.
    """
    result: list[float] = []
    known = known or Known()
    for model, names in base or []:
        for name in [names] if isinstance(names, str) else names:
            try:
                face = model.Shape.getElement(name)
            except STALE_ELEMENT_ERRORS:
                continue
            if is_at_one_height(face):
                result.append(face.BoundBox.ZMin)
                continue
            if face.ShapeType != "Face":
                continue
            try:
                window = _windows_of(model.Shape, face, name, known).of(face)
            except SelectionError:
                continue
            result += [] if window is None else [window.z]
    return result


def depth_limits(base: list[tuple[Any, Any]], stock: Any) -> dict[str, float]:
    """Return what FreeCAD's expressions for depths and heights start from [mm].

    Parameters
    ----------
    base : list
        FreeCAD's list of faces; the deepest level one counts.
    stock : object
        Bounding box of the stock.
    """
    levels = heights(base)
    floor = min(levels, default=stock.ZMin)
    top = max([stock.ZMax, *levels])
    return {
        "OpStockZMin": stock.ZMin,
        "OpStockZMax": stock.ZMax,
        "OpFinalDepth": floor,
        "OpStartDepth": top if top > floor else floor + 1.0,
    }


def check_stock(floor: Floor, stock: Any) -> None:
    """Check that a floor is not above the stock, given as its bounding box.

    Raises
    ------
    SetupError
    """
    above = floor.z - stock.ZMax
    if above > SAME_HEIGHT:
        raise SetupError(
            f"The selected floor lies {above:.3g} mm above the stock.",
            "Look whether the stock is where it should be.",
        )


def are_at_one_place(floor: Floor, other: Floor) -> bool:
    """Return whether two floors are the same ground."""
    return bool(
        abs(floor.z - other.z) < SAME_HEIGHT
        and floor.face.CenterOfMass.isEqual(other.face.CenterOfMass, SAME_HEIGHT)
    )


def others(floor: Floor, solids: Iterable[Any]) -> list[Any]:
    """Return which of a job's solids are others than the floor's and may reach over it."""
    # the box of a solid takes as long as those of all of its faces
    solids = [solid for solid in solids if not solid.isSame(floor.part)]
    if not solids:
        return []
    own = floor.part.BoundBox
    found = []
    for solid in solids:
        box = solid.BoundBox
        beside = box.XMax < own.XMin or box.XMin > own.XMax
        beside = beside or box.YMax < own.YMin or box.YMin > own.YMax
        if not beside and box.ZMax > floor.z + SAME_HEIGHT and not _are_same(solid, floor.part):
            found.append(solid)
    return found


def _are_same(one: Any, other: Any) -> bool:
    """Return whether two solids are copies of each other, maybe without seams."""
    a, b = one.BoundBox, other.BoundBox
    if not all(
        abs(getattr(a, name) - getattr(b, name)) < SAME_HEIGHT
        for name in ("XMin", "XMax", "YMin", "YMax", "ZMin", "ZMax")
    ):
        return False
    return bool(abs(one.Volume - other.Volume) <= SAME_VOLUME * abs(other.Volume))


def check_names(part: Any, names: Sequence[str]) -> None:
    """Refuse names that a part has nothing by.

    Raises
    ------
    SelectionError
    """
    for name in names:
        try:
            part.Shape.getElement(name)
        except STALE_ELEMENT_ERRORS as error:
            raise SelectionError(
                f"{_name_of(part)} has no face {name}.",
                f"Its faces are Face1 to Face{len(part.Shape.Faces)}.",
            ) from error


def _element(shape: Any, where: str, name: str) -> Any:
    """Return the sub-shape `name`, which FreeCAD marks with "?" when it lost it."""
    try:
        return shape.getElement(name)
    except STALE_ELEMENT_ERRORS as error:
        raise SelectionError(
            f"{where} is not there any more: the model has changed.",
            "Remove it from the base geometry and select the floor of the pocket again.",
        ) from error


def _check_level(face: Any, where: str) -> None:
    normal = normal_of_plane(face)
    if normal is None:
        raise SelectionError(f"{where} is not flat.", _PICK_A_FLOOR)
    if abs(normal.z) < LEVEL_TOLERANCE:
        raise SelectionError(f"{where} is vertical: it is a wall, not a floor.", _PICK_A_FLOOR)
    if not looks(face):
        raise SelectionError(f"{where} is not level.", _PICK_A_FLOOR)


def _solid_of(shape: Any, face: Any, where: str, known: Known) -> tuple[Any, Adjacency]:
    """Return the closed solid that a level face bounds, and its adjacency."""
    solids = solids_of(shape, known)
    for find in (Adjacency.number, Adjacency.same_as):  # sewing makes new faces
        for solid in solids:
            key = solid.hashCode()
            if key not in known.adjacency:
                known.adjacency[key] = Adjacency(solid)
            if find(known.adjacency[key], face) is not None and all(
                shell.isClosed() for shell in solid.Shells
            ):
                return solid, known.adjacency[key]
    raise SelectionError(
        f"The part with {where} is an open shell, not a closed solid.",
        "Close it first (Part workbench, Check Geometry and Convert to Solid).",
    )


def in_model(job: Any, base: Any, name: str) -> tuple[Any, str]:
    """Return the job's model and its name for a face of a part within it, else both as given.

    Parameters
    ----------
    job : object
    base : object
        The part that was clicked on, which may be one of several in the model's original.
    name : str
    """
    whole = PathUtil.getPublicObject(base)
    if job is None or whole == base or not name.startswith("Face"):
        return base, name
    originals = [(job.Proxy.baseObject(job, model), model) for model in job.Model.Group]
    for original, model in originals:
        if original == base:
            return model, name
    face = base.Shape.getElement(name)
    placed = base.getGlobalPlacement().multiply(base.Placement.inverse())
    centers = [face.CenterOfMass, placed.multVec(face.CenterOfMass)]
    for original, model in originals:
        if original != whole:
            continue
        for number, other in enumerate(model.Shape.Faces, 1):
            is_there = any(other.CenterOfMass.isEqual(c, SAME_HEIGHT) for c in centers)
            if is_there and abs(other.Area - face.Area) <= SAME_HEIGHT * face.Area:
                return model, f"Face{number}"
    return base, name
