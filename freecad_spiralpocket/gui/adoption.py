# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gives operations a panel and an icon that were made without a window, or by a script.

FreeCAD saves view providers only where there is a window, so a document from
the command line opens without. A FreeCAD without the add-on saves neither these
nor the operations' own proxies: then the operations are taken over again.
Loads nothing until there is such an operation.
"""

from __future__ import annotations

import sys
from typing import Any

import FreeCAD

translate = FreeCAD.Qt.translate

OPERATION_MODULE = "freecad_spiralpocket.op.operation"


class Adopter:
    """A document observer; FreeCAD calls its methods."""

    def slotActivateDocument(self, document: Any) -> None:  # noqa: N802
        """Look at a document that was opened, which ends with this."""
        if not document.Restoring:
            revive(document)
            adopt(document)

    def slotRecomputedDocument(self, document: Any) -> None:  # noqa: N802
        """Look at a document to which a script may have added operations."""
        adopt(document)


def revive(document: Any) -> None:
    """Take over what was saved without the add-on; only a document that opens has such."""
    from ..op.lost import lost  # not at FreeCAD's start

    found = lost(document)
    if not found:
        return
    from ..op.operation import ObjectSpiralPocket

    for obj in found:
        ObjectSpiralPocket.revive(obj)
        told = translate(
            "SpiralPocket",
            "{} was saved by a FreeCAD without Spiral Pocket; its path may be older than the "
            "part. Recompute the document.",
        )
        FreeCAD.Console.PrintWarning(told.format(obj.Label) + "\n")


def adopt(document: Any) -> None:
    """Give a view provider to every spiral pocket in `document` that has none."""
    module = sys.modules.get(OPERATION_MODULE)
    if module is None:  # then there is no operation of ours in any document
        return
    orphans = [
        obj.ViewObject
        for obj in document.findObjects("Path::Feature")
        if isinstance(getattr(obj, "Proxy", None), module.ObjectSpiralPocket)
        and obj.ViewObject is not None
        and not hasattr(obj.ViewObject.Proxy, "setEdit")  # None or a number
    ]
    if orphans:
        from .viewprovider import ViewProvider

        for view_object in orphans:
            ViewProvider(view_object, is_new=False)
