# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations that cut a rest are computed again when those before them change.

What others leave is no link in the document, and cannot be one: where an operation stands in the
job counts too. Without this a rest would be cut that is none any more: links at depth, and ways
straight down, through stock that is taken for cleared.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import FreeCAD

from .compat import parent_job

#: Properties of operations, or of the group that they are in, that matter to those behind them.
_TELLING = ("Path", "Active", "Group")


def standing_before(obj: Any) -> Iterator[tuple[Any, tuple[str, ...]]]:
    """Yield the operations of the job that stand before one, and the names of all in each.

    A dressup stands for the operation in it. Without a job there are no such operations.
    """
    job = parent_job(obj)
    for operation in job.Operations.Group if job is not None else ():
        names = (operation.Name, *(o.Name for o in operation.OutListRecursive))
        if obj.Name in names:
            return
        yield operation, names


def names_before(obj: Any) -> tuple[str, ...]:
    """Return the names of all in the operations of the job that stand before one."""
    return tuple(name for _, names in standing_before(obj) for name in names)


class RestWatch:
    """Touches operations that cut a rest; an observer of all documents.

    Parameters
    ----------
    kind : type
        The proxy of our operations. `before` of each are the names that were before it when it was
        computed, None if that is not known.
    """

    def __init__(self, kind: type) -> None:
        self._kind = kind

    def slotChangedObject(self, changed: Any, name: str) -> None:  # noqa: N802 - FreeCAD's name
        """Touch what stands behind an operation whose path changes, or in another place now."""
        if name not in _TELLING or FreeCAD.isRestoring():
            return
        for obj in changed.Document.Objects:
            proxy = getattr(obj, "Proxy", None)
            if not isinstance(proxy, self._kind) or obj is changed:
                continue
            if getattr(obj, "UseRestMachining", False) and self._matters(changed, name, obj):
                obj.touch()

    def _matters(self, changed: Any, name: str, obj: Any) -> bool:
        before = names_before(obj)
        if name == "Group":
            return before != obj.Proxy.before
        return changed.Name in before
