# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that makes a spiral pocket from the selected faces.

Making the operation and everything done in the panel until OK is one
transaction, so that Cancel aborts it and one Undo takes it all back. FreeCAD
ties the two together by itself, as long as no transaction is open when the
command starts; CAM's own panels leave one open after Cancel.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
from PySide.QtCore import QT_TRANSLATE_NOOP

from .resources import ICON

COMMAND = "SpiralPocket_Create"


def has_job(document: Any) -> bool:
    """Return whether `document` holds a CAM job."""
    return any(
        hasattr(obj, "SetupSheet") and hasattr(obj, "Operations")
        for obj in document.findObjects("Path::Feature")
    )


class CommandSpiralPocket:
    """Makes the operation and opens its panel."""

    def GetResources(self) -> dict[str, str]:  # noqa: N802 - the name FreeCAD calls
        """Return icon and texts."""
        return {
            "Pixmap": ICON,
            "MenuText": QT_TRANSLATE_NOOP("SpiralPocket_Create", "Spiral Pocket"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "SpiralPocket_Create",
                "Clears the pockets above the selected floors with one smooth spiral each",
            ),
        }

    def IsActive(self) -> bool:  # noqa: N802 - the name FreeCAD calls
        """Return whether there is a job to put the operation into, and no panel open."""
        document = FreeCAD.ActiveDocument
        return document is not None and not FreeCADGui.Control.activeDialog() and has_job(document)

    def Activated(self) -> None:  # noqa: N802 - the name FreeCAD calls
        """Make the operation in the job that is meant, or asked for, and open the panel."""
        if FreeCAD.getActiveTransaction():
            FreeCAD.closeActiveTransaction()
            from .qt.later import later

            later(0, lambda: FreeCADGui.runCommand(COMMAND, 0))
            return
        from . import creation

        creation.create_in_chosen_job()
