# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be posted: computed anew, and refused where it would not be what is meant."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from .engine.errors import SetupError
from .op import compat, request
from .op.lost import lost
from .op.operation import ObjectSpiralPocket


def check_post(post: str) -> None:
    """Raise `SetupError` if there is no such post-processor."""
    if not compat.has_post(post):
        raise SetupError(
            f"FreeCAD has no post-processor {post}.", "Choose one of its list, such as linuxcnc."
        )


def check_file(path: str | os.PathLike[str]) -> None:
    """Raise `SetupError` if the folder of a file to write is not there."""
    folder = Path(path).absolute().parent
    if not folder.is_dir():
        raise SetupError(
            f"Cannot write {path}: there is no folder {folder}.", "Make it, or choose another file."
        )


def refresh(job: Any) -> None:
    """Compute all of a job anew that may have changed.

    Stock, tools and parts touch no operation, and the document may have been changed where the
    add-on was not; a pocket that is as it was keeps its plan.
    """
    for obj in lost(job.Document):
        ObjectSpiralPocket.revive(obj)
    for obj in _ours(job):
        obj.touch()
    job.Document.recompute()


def check(job: Any) -> None:
    """Refuse to write a program that would do nothing, is out of date, or leaves a pocket out.

    Raises
    ------
    SetupError
    """
    active = _active(job)
    for op in active:
        failed = next((o for o in (op, *op.OutListRecursive) if not o.isValid()), None)
        if failed is not None:
            raise SetupError(
                f"{failed.Label} could not be computed: the path of {op.Label} may be out of date.",
                "FreeCAD's report view says why; mend it, or unset Active to do without "
                "the operation.",
            )
    for op in _ours(job):
        if not compat.has_motion(op.Path):
            why = next(iter(op.Notices), "It was not computed.")
            raise SetupError(
                f"{op.Label} has no path. {why}", "Mend it, or unset Active to do without it."
            )
        missing = request.missing_feeds(op.ToolController)
        if missing:
            raise SetupError(
                f"{op.ToolController.Label} has no {missing}; {op.Label} would be a program "
                "without feeds, which no machine runs as it is meant.",
                "Set the horizontal and vertical feed in the tool controller.",
            )
    if not any(compat.has_motion(op.Path) for op in active):
        raise SetupError(f"No active operation of {job.Label} has a path.", "Add one to the job.")


def _active(job: Any) -> list[Any]:
    return [op for op in job.Operations.Group if getattr(op, "Active", True)]


def _ours(job: Any) -> Iterator[Any]:
    """Yield the active spiral pockets of a job, those within dressups too."""
    for op in _active(job):
        for obj in (op, *op.OutListRecursive):
            if isinstance(getattr(obj, "Proxy", None), ObjectSpiralPocket) and obj.Active:
                yield obj
