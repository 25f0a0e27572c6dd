# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spiral Pocket for scripts, with or without FreeCAD's window.

    from freecad_spiralpocket import api

    names = api.floors(part)  # or such as ["Face12"]
    op = api.add_spiral_pocket(job, [(part, names)], StepOver=30, FinalDepth="-5 mm")
    gcode = api.export(job, "part.ngc", post="linuxcnc")

They raise the engine's errors (``freecad_spiralpocket.engine.errors``), whose text
is meant for the machinist, and leave the document as it was when they do.
"""

from __future__ import annotations

import difflib
import math
import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import FreeCAD

from . import posting
from .engine.errors import RequestError, SelectionError, SetupError
from .op import compat, operation, properties, selection
from .op.floors import find_floors

_NO_FLOORS = (
    "The floors are not given as parts with names of faces.",
    'Give a list such as [(part, ["Face12", "Face15"])].',
)

__all__ = ["add_spiral_pocket", "export", "floors"]


def floors(part: Any) -> list[str]:
    """Return the names of all faces of a part that are floors of pockets, the highest first.

    With walls all around; a floor that is open at a side has to be named. Of one that seams cut
    into several faces all are named, which an operation takes as one.

    Parameters
    ----------
    part : object
        A document object with a shape.

    Raises
    ------
    SelectionError
        If it has none.
    """
    if not hasattr(part, "Shape"):
        raise SelectionError(*_no_part(part))
    found = sorted(find_floors(part), key=lambda floor: -floor.z)
    return [name for floor in found for name in floor.names]


def add_spiral_pocket(
    job: Any,
    base: Iterable[tuple[Any, str | Sequence[str]]],
    tool_controller: Any = None,
    **values: Any,
) -> Any:
    """Add a Spiral Pocket operation to a job and recompute it.

    Parameters
    ----------
    job : object
        A CAM job of an open document.
    base : iterable of (model, names)
        The floors of the pockets: the part as the job refers to it or the original that was
        given to the job, of a body its tip too, and the name or names of faces, such as
        ``["Face12", "Face15"]``; of a hole through the part, any wall.
    tool_controller : object, optional
        One of the job's; without it that of the last operation, else the job's first.
    **values
        Properties by their FreeCAD names: numbers in mm, degrees or percent, or texts with a
        unit such as ``"0.5 in"``. An expression on the property is removed. How heavy the cut
        may be is said by ``StepOver`` (whole percent of the cutter's diameter) or exactly by
        ``MaxEngagement`` (degrees), which rules where it is not 0. ``StartPoint`` (x, y, z)
        counts with ``UseStartPoint=True``, for the pocket it lies in.

    Returns
    -------
    object
        The operation. Its ``Notices`` name the pockets that could not be cut, if others could.

    Raises
    ------
    SpiralPocketError
        If no pocket could be cut, or a property or value makes no sense; the document is as
        before.
    """
    _check_values(values)
    _check_job(job)
    if job.Stock is None:
        raise SetupError(f"{job.Label} has no stock.", "Set one up in the job's editor.")
    links = _links(job, base)
    controller = _tool_controller(job, tool_controller)
    with _unchanged_on_error(job):
        with compat.supplied_tool_controller(controller):
            op = operation.Create(operation.NAME, parentJob=job)
        op.ToolController = controller
        op.Base = links
        for name, value in values.items():
            _set(op, name, value)
        job.Document.recompute()
        _raise_failure(op)
    return op


def export(job: Any, path: str | os.PathLike[str], post: str = "linuxcnc", args: str = "") -> str:
    """Compute what has changed, and post-process all active operations of a job into one file.

    Parameters
    ----------
    job : object
        A CAM job; its own choice of post-processor and arguments is neither used nor changed.
    path : path-like
        File to write.
    post : str
        Name of a post-processor as in FreeCAD's list, such as ``"linuxcnc"`` or ``"grbl"``.
    args : str
        Arguments for the post-processor.

    Returns
    -------
    str
        The G-code that was written.

    Raises
    ------
    SetupError
        If an active spiral pocket has no path or no feeds, or none of the operations has a path;
        if there is no such post-processor, it fails or writes nothing; or if the file cannot be
        written.
    """
    _check_job(job)
    if not isinstance(path, str | os.PathLike):
        raise SetupError(f"{path} is no file to write.", "Give its path.")
    posting.check_post(str(post))
    posting.check_file(path)
    posting.refresh(job)
    posting.check(job)
    with compat.active_document(job.Document):
        try:
            gcode = compat.post_process(job, str(post), args or "")
        except RuntimeError as error:
            raise SetupError(
                f"The post-processor {post} made no program: {error}.", "Check its arguments."
            ) from error
    try:
        Path(path).write_text(gcode, encoding="utf-8")
    except OSError as error:
        raise SetupError(
            f"Cannot write {path}: {error.strerror}.", "Choose another file."
        ) from error
    return gcode


def _check_job(job: Any) -> None:
    """Refuse what is no job; a document has its Operations and Tools too, by their names."""
    is_object = isinstance(job, FreeCAD.DocumentObject)
    if not is_object or any(getattr(job, name, None) is None for name in ("Operations", "Tools")):
        raise SetupError(
            f"{getattr(job, 'Label', job)} is not a CAM job.",
            "Give a job of an open document; getObject finds it by its name, Job for instance.",
        )


def _check_values(values: dict[str, Any]) -> None:
    """Refuse unknown names, and what FreeCAD would silently change."""
    known = sorted([*properties.option_names(), *properties.INHERITED])
    for name, value in values.items():
        if isinstance(value, float) and math.isnan(value):
            raise RequestError(f"{name} is not a number.", "Leave it out for its default.")
        if name not in known:
            near = difflib.get_close_matches(name, [*known, "tool_controller"], 1)
            meant = f"Is it {near[0]}? " if near else ""
            raise RequestError(
                f"Spiral Pocket has no property {name}.", f"{meant}There are {', '.join(known)}."
            )
        allowed = properties.choices().get(name)
        if allowed and value not in allowed:
            raise RequestError(
                f"{name} cannot be {value}.", f"Choose one of: {', '.join(allowed)}."
            )
    stepover = values.get("StepOver", 1)
    try:
        percent = 0.0 if isinstance(stepover, bool) else float(stepover)
    except (TypeError, ValueError):
        percent = 0.0
    if not (1 <= percent <= 100 and percent == int(percent)):
        raise RequestError(
            f"StepOver cannot be {stepover}.",
            "Give a whole number from 1 to 100, percent of the cutter's diameter; or an angle to "
            "MaxEngagement.",
        )


def _links(
    job: Any, base: Iterable[tuple[Any, str | Sequence[str]]]
) -> list[tuple[Any, tuple[str, ...]]]:
    """Return `base` with the job's own copies in place of the original parts."""
    own = {m.Name: m for m in job.Model.Group}
    own |= {compat.original(job, m).Name: m for m in job.Model.Group}
    links = []
    if not isinstance(base, Iterable):
        raise SelectionError(*_NO_FLOORS)
    for pair in base:
        model, names = pair if isinstance(pair, tuple) and len(pair) == 2 else (pair, None)
        names = (names,) if isinstance(names, str) else names
        if not isinstance(names, Sequence) or not all(isinstance(name, str) for name in names):
            raise SelectionError(*_NO_FLOORS)
        if not hasattr(model, "Shape"):
            raise SelectionError(*_no_part(model))
        copy = _own_copy(job, model, own)
        selection.check_names(copy, names)
        links.append((copy, tuple(names)))
    if not any(names for _, names in links):
        raise SelectionError(
            "No floor is named.",
            "Name that of at least one pocket; api.floors only finds those with walls all around.",
        )
    return links


def _own_copy(job: Any, model: Any, own: dict[str, Any]) -> Any:
    """Return the job's copy of a part, also where the tip of that, the last feature, is given.

    A body's faces are those of its tip.
    """
    if model.Name in own:
        return own[model.Name]
    whole = model.getParentGeoFeatureGroup()
    if whole is None or whole.Name not in own:
        hint = "Add it to the job's model first."
    elif getattr(whole, "Tip", None) == model:
        return own[whole.Name]
    else:
        hint = f"Give {whole.Label} with the names that its faces have there."
    raise SelectionError(f"{model.Label} is not part of {job.Label}.", hint)


def _no_part(model: Any) -> tuple[str, str]:
    return (
        f"{model} is no part whose faces could be cut.",
        "Give an object of the document; getObject finds it by its name, not its label.",
    )


def _tool_controller(job: Any, wanted: Any) -> Any:
    """Return the tool controller to use."""
    controllers = job.Tools.Group
    if not controllers:
        raise SetupError(
            f"{job.Label} has no tool controller.", "Add one with an end mill to the job."
        )
    if wanted is None:
        used = [getattr(op, "ToolController", None) for op in job.Operations.Group]
        wanted = next((tc for tc in reversed(used) if tc in controllers), controllers[0])
    if wanted not in controllers:
        raise SetupError(
            f"{getattr(wanted, 'Label', wanted)} is not a tool controller of {job.Label}.",
            "Give one of the job's Tools, after adding it there.",
        )
    if wanted.Tool is None:
        raise SetupError(f"{wanted.Label} has no tool.", "Put an end mill into it.")
    return wanted


def _set(op: Any, name: str, value: Any) -> None:
    """Set a property; text may carry a unit."""
    if any(path == name for path, _ in op.ExpressionEngine):
        op.setExpression(name, None)
    if name == "StepOver":
        value = int(float(value))
    try:
        setattr(op, name, value)
    except (TypeError, ValueError, ArithmeticError, RuntimeError) as error:
        raise RequestError(
            f"{name} cannot be {value!r}: {compat.said_by(error)}.", _hint_for(op, name)
        ) from error
    _check_kept(op, name, value)


def _check_kept(op: Any, name: str, value: Any) -> None:
    """Refuse a number that FreeCAD has replaced by another one without a word."""
    kept = getattr(op, name)
    kept = getattr(kept, "Value", kept)
    if any(isinstance(one, bool) or not isinstance(one, float | int) for one in (value, kept)):
        return
    if value < 0 and kept == 0:
        raise RequestError(f"{name} cannot be {value!r}: it is negative.", "Give 0 or more.")
    if not math.isclose(value, kept, rel_tol=1e-6, abs_tol=1e-9) and math.isfinite(value):
        side = "more" if value < kept else "less"
        raise RequestError(f"{name} cannot be {value!r}.", f"Give {kept:g} or {side}.")


def _hint_for(op: Any, name: str) -> str:
    """Return what a property takes, told by its value."""
    now, choices = getattr(op, name), op.getEnumerationsOfProperty(name)
    if choices:
        return f"Choose one of: {', '.join(choices)}."
    if isinstance(now, bool):
        return "Give True or False."
    if isinstance(now, FreeCAD.Vector):
        return "Give three numbers, (x, y, z)."
    if isinstance(now, str):
        return "Give a text."
    if isinstance(now, float):
        return "Give a number, in mm/min." if name == "LinkFeed" else "Give a number."
    unit = "mm" if now.Unit == FreeCAD.Units.Length else "degrees"
    return f"Give a number, in {unit}, or a text with another unit of that kind."


def _raise_failure(op: Any) -> None:
    """Raise what kept the operation from making any path."""
    if not op.isValid():
        raise SetupError(
            "FreeCAD could not compute the operation.", "Its report view says what happened."
        )
    if op.Active and not op.Proxy.plans:
        if not op.Proxy.errors:
            raise SetupError(
                "FreeCAD did not compute the operation.",
                "Something that it depends on failed, the tool or the part for instance; the "
                "report view says what.",
            )
        raise op.Proxy.errors[0]


@contextmanager
def _unchanged_on_error(job: Any) -> Iterator[None]:
    """Make one undo step; on an error take everything back that was added to the document."""
    document = job.Document
    before, cycle_time = {o.Name for o in document.Objects}, job.CycleTime
    own_step = bool(document.UndoMode) and not document.HasPendingTransaction
    with compat.active_document(document):
        if own_step:
            document.openTransaction("Spiral Pocket")
        try:
            yield
        except BaseException:
            if own_step:
                document.abortTransaction()
            for name in {o.Name for o in document.Objects} - before:
                document.removeObject(name)
            job.CycleTime = cycle_time
            document.recompute()
            raise
        if own_step:
            document.commitTransaction()
