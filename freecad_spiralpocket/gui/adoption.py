# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gives operations a panel and an icon that were made without a window, or by a script.

FreeCAD saves view providers only where there is a window, so a document from
the command line opens without. Loads nothing until there is such an operation.
"""

from __future__ import annotations

import sys
from typing import Any

OPERATION_MODULE = "freecad_spiralpocket.op.operation"


class Adopter:
    """A document observer; FreeCAD calls its methods."""

    def slotActivateDocument(self, document: Any) -> None:  # noqa: N802
        """Look at a document that was opened, which ends with this."""
        if not document.Restoring:
            adopt(document)

    def slotRecomputedDocument(self, document: Any) -> None:  # noqa: N802
        """Look at a document to which a script may have added operations."""
        adopt(document)


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
