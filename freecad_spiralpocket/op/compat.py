# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every difference between FreeCAD 0.20, 1.0 and 1.1 that the operation meets.

1.0 turned the workbench "Path" (modules ``PathScripts.Path*``) into "CAM"
(package ``Path``); 1.1 turned tools into assets. The aliases at the top have the
same interface everywhere, the functions below do the same thing everywhere.
Nothing else in `op`, `api` and `cli` asks for a version (but `adjacency.outer_wire` minds what 0.20
mistakes).
"""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import FreeCAD
import Part
from PathScripts import PathUtils

from .expressions import as_number

try:
    import Path.Base.SetupSheet as PathSetupSheet
    import Path.Base.Util as PathUtil
    import Path.Log as PathLog
    import Path.Main.Job as PathJob
    import Path.Op.Base as PathOp
    import Path.Preferences as PathPreferences
    import Path.Tool.Controller as PathToolController

    IS_LEGACY = False
except ImportError:
    from PathScripts import (
        PathJob,
        PathLog,
        PathOp,
        PathPreferences,
        PathSetupSheet,
        PathToolController,
        PathUtil,
    )

    IS_LEGACY = True

__all__ = [
    "IS_LEGACY",
    "STALE_ELEMENT_ERRORS",
    "KeepsNothing",
    "PathJob",
    "PathLog",
    "PathOp",
    "PathSetupSheet",
    "PathToolController",
    "PathUtil",
    "PathUtils",
    "active_document",
    "add_tool_controller",
    "evaluate_constants",
    "has_motion",
    "has_post",
    "operation_property",
    "parent_job",
    "post_process",
    "said_by",
    "set_end_mill",
    "spindle_start",
    "supplied_tool_controller",
    "tool_name",
    "tool_shape",
    "unreadable_job",
]

#: What ``Shape.getElement`` raises for a face that is not there (any more), and what an empty
#: shape in the place of one raises.
STALE_ELEMENT_ERRORS = (FreeCAD.Base.FreeCADError, Part.OCCError, ValueError, IndexError)

#: A post must not open its editor window.
_QUIET = "--no-show-editor"
#: No program is shorter.
LEAST_LINES = 3
#: Commands that move the cutter.
MOTION = ("G0", "G1", "G2", "G3", "G00", "G01", "G02", "G03", "G81", "G82", "G83", "G73", "G85")
#: What tool bits of the same form are called, by the names of legacy tools.
LEGACY_SHAPES = {
    "ballendmill": "ballend",
    "centerdrill": "drill",
    "chamfermill": "chamfer",
    "cornerround": "radius",
    "counterbore": "drill",
    "countersink": "chamfer",
    "engraver": "vbit",
    "slotcutter": "slittingsaw",
}


class KeepsNothing:
    """Base of proxies of which nothing is saved; it goes before FreeCAD's own."""

    def dumps(self) -> None:
        """Save nothing (1.0 and later)."""

    def loads(self, state: Any) -> None:
        """Restore nothing (1.0 and later)."""

    def __getstate__(self) -> None:
        """Save nothing (0.20)."""

    def __setstate__(self, state: Any) -> None:
        """Restore nothing (0.20)."""


def said_by(error: Exception) -> str:
    """Return what FreeCAD says of an error; 0.20 puts that into a dictionary."""
    said = error.args[0] if error.args else ""
    if isinstance(said, dict):
        said = said.get("sErrMsg") or "it is of another kind"
    return str(said).rstrip(".!")


def parent_job(obj: Any) -> Any:
    """Return the job that `obj` belongs to, or None."""
    return PathUtils.findParentJob(obj)


def unreadable_job(obj: Any) -> Any:
    """Return the job of `obj` if this FreeCAD cannot read it, else None.

    The jobs of 0.20 are in modules that 1.0 and later lack, and the other way round.
    """
    holders = [holder for group in obj.InList for holder in group.InList]
    lost = (h for h in holders if hasattr(h, "Operations") and getattr(h, "Proxy", h) is None)
    return next(lost, None)


def operation_property(operation: Any, name: str) -> Any:
    """Return a property of an operation, or of the one that a dressup dresses; None without."""
    return PathUtil.opProperty(operation, name)


def original(job: Any, model: Any) -> Any:
    """Return the part of which a model of the job is a copy, or the model if that is gone."""
    try:
        return job.Proxy.baseObject(job, model)
    except IndexError:
        return model


def tool_shape(tool: Any) -> str:
    """Return the name of the tool's shape in lower case without separators, "" if unknown.

    "endmill", "ballend", "bullnose", "vbit", "drill", ...: up to 1.0 the tool bit
    carries it as `ShapeName`, from 1.1 on as `ShapeType`; the legacy tools of 0.18, which 0.20
    still offers, as `ToolType`, by names of their own.
    """
    for name in ("ShapeType", "ShapeName", "ToolType"):
        if hasattr(tool, name):
            shape = "".join(c for c in str(getattr(tool, name)).lower() if c.isalnum())
            return LEGACY_SHAPES.get(shape, shape) if name == "ToolType" else shape
    return ""


def flat_end(tool: Any) -> float:
    """Return the diameter of a bull-nose tool's flat end [mm], 0 if it is not known.

    Shapes have the corner's radius since 1.1, before that the flat end's.
    """
    for name in ("CornerRadius", "TorusRadius"):
        if hasattr(tool, name):
            return max(0.0, float(tool.Diameter) - 2 * float(getattr(tool, name)))
    return 2 * float(getattr(tool, "FlatRadius", 0.0))


def tool_name(tool: Any) -> str:
    """Return what the user calls a tool; the legacy tools of 0.20 have no label."""
    return str(tool.Label if hasattr(tool, "Label") else tool.Name)


def spindle_start(tool_controller: Any) -> str | None:
    """Return what starts the spindle, "M3" or "M4", "" if nothing does; None if not known yet.

    Up to 1.0 the tool controller says the direction, from 1.1 on the tool.
    """
    if "Touched" in tool_controller.State:
        return None
    names = {command.Name for command in tool_controller.Path.Commands}
    return next((name for name in ("M3", "M4") if name in names), "")


class _Chosen:
    """Stands in for the dialog that asks the user for a tool controller."""

    def __init__(self, tool_controller: Any) -> None:
        self._tool_controller = tool_controller

    def selectedToolController(self) -> Any:  # noqa: N802 - the name FreeCAD calls
        return self._tool_controller

    def chooseToolController(self, controllers: Sequence[Any]) -> Any:  # noqa: N802
        return self._tool_controller


@contextmanager
def supplied_tool_controller(tool_controller: Any) -> Iterator[None]:
    """Answer FreeCAD's question for a tool controller with `tool_controller`.

    The first operation of a job with several tool controllers asks for one and,
    without a window, raises UnboundLocalError in all versions.
    """
    before = PathUtils.UserInput
    PathUtils.UserInput = _Chosen(tool_controller)
    try:
        yield
    finally:
        PathUtils.UserInput = before


@contextmanager
def active_document(document: Any) -> Iterator[None]:
    """Make `document` the active one for a while: CAM looks for jobs only there."""
    before = FreeCAD.ActiveDocument
    FreeCAD.setActiveDocument(document.Name)
    try:
        yield
    finally:
        if before is not None and before.Name in FreeCAD.listDocuments():
            FreeCAD.setActiveDocument(before.Name)


def add_tool_controller(job: Any, diameter: float) -> Any:
    """Add a tool controller with an end mill of `diameter` [mm] to `job` and return it."""
    number = 1 + max((tc.ToolNumber for tc in job.Tools.Group), default=0)
    with active_document(job.Document):
        tool_controller = PathToolController.Create(toolNumber=number)
        job.Proxy.addToolController(tool_controller)
    set_end_mill(tool_controller, diameter)
    return tool_controller


def set_end_mill(tool_controller: Any, diameter: float) -> None:
    """Make the end mill of a new tool controller `diameter` [mm] wide and name both after it."""
    tool_controller.Tool.Diameter = diameter
    tool_controller.Tool.Label = f"{diameter:g} mm end mill"
    tool_controller.Label = f"TC: {diameter:g} mm end mill"


def has_post(post: str) -> bool:
    """Return whether there is a post-processor of this name."""
    folders = [*PathPreferences.searchPathsPost(), *sys.path]
    files = (os.path.join(folder, f"{post}_post.py") for folder in folders)
    return post.isidentifier() and any(map(os.path.isfile, files))


def post_process(job: Any, post: str, args: str) -> str:
    """Return the G-code of all active operations of `job` by the post-processor `post`.

    Raises
    ------
    RuntimeError
        If the post-processor failed, or wrote no program.
    """
    words = args if _QUIET in args else f"{args} {_QUIET}".strip()
    try:
        with _kept(job, "SplitOutput", False):  # else each piece would end the program
            sections = _export_legacy(job, post, words) if IS_LEGACY else _export(job, post, words)
    except SystemExit as error:  # argparse, which has told on the console what it dislikes
        raise RuntimeError("it does not know its arguments") from error
    except Exception as error:
        raise RuntimeError(f"{type(error).__name__}, {error}") from error
    text = "\n".join(s for s in sections if s)
    if len(text.split("\n")) < LEAST_LINES:
        raise RuntimeError("it wrote nothing")
    return text


def has_motion(path: Any) -> bool:
    """Return whether a path moves anything."""
    return any(c.Name in MOTION for c in path.Commands)


@contextmanager
def _kept(obj: Any, name: str, value: Any) -> Iterator[None]:
    """Set a property for a while, and leave no trace of that."""
    before, was_touched = getattr(obj, name), "Touched" in obj.State
    setattr(obj, name, value)
    try:
        yield
    finally:
        setattr(obj, name, before)
        if not was_touched:
            obj.purgeTouched()


@contextmanager
def _folder_for_a_while() -> Iterator[str]:
    """Work in a folder that is removed in the end."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield folder
        finally:
            os.chdir(before)


def _export(job: Any, post: str, args: str) -> list[str]:
    """Post with the factory of 1.0 and later, which takes its arguments from the job.

    It has scripts write to "-"; to some that is a file like any other.
    """
    from Path.Post.Processor import PostProcessorFactory

    with _kept(job, "PostProcessorArgs", args):
        processor = PostProcessorFactory.get_post_processor(job, post)
        if processor is None:
            raise ImportError(post)
        with _folder_for_a_while() as folder:
            return _written(processor, folder)


def _written(processor: Any, folder: str) -> list[str]:
    """Return what a post returns, or has written in the working folder."""
    sections = [gcode for _, gcode in processor.export() or []]
    file = os.path.join(folder, "-")
    if any(sections) or not os.path.isfile(file):
        return sections
    with open(file, encoding="utf-8") as written:
        return [written.read()]


def _export_legacy(job: Any, post: str, args: str) -> list[str]:
    """Post with 0.20, through a file: some of its posts return nothing."""
    from PathScripts.PathPost import CommandPathPost
    from PathScripts.PathPostProcessor import PostProcessor

    search_path = sys.path
    try:
        processor = PostProcessor.load(post)
    finally:
        sys.path = search_path
    texts = []
    with tempfile.TemporaryDirectory() as folder:
        for number, objects in enumerate(CommandPathPost().buildPostList(job)):
            name = os.path.join(folder, f"{number}.nc")
            processor.export(objects, name, args)
            with open(name, encoding="utf-8") as file:
                texts.append(file.read())
    return texts


def evaluate_constants(obj: Any, names: Sequence[str]) -> None:
    """Write what the expressions of these properties give.

    0.20 leaves an expression that names no other property (``0.1 mm * 3``) out of its
    evaluation where there are others that do, as every operation's depths.
    """
    if not IS_LEGACY:
        return
    for name, text in obj.ExpressionEngine:
        if name in names:
            old, new = (
                getattr(v, "Value", v) for v in (getattr(obj, name), obj.evalExpression(text))
            )
            if new != old:
                setattr(obj, name, as_number(old, new) if isinstance(old, (int, float)) else new)
