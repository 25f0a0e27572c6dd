# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows an error as the machinist reads it: what is the matter, and the way out."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ...engine.errors import SetupError, SpiralPocketError
from ..compat import run_dialog
from .localized import in_panel

translate = FreeCAD.Qt.translate


def show(*errors: SpiralPocketError, more: str = "") -> None:
    """Show one box for all `errors`, and `more` below them, and wait until it is closed."""
    box = QtGui.QMessageBox(FreeCADGui.getMainWindow())
    box.setObjectName("SpiralPocketMessage")
    box.setIcon(QtGui.QMessageBox.Warning)
    box.setWindowTitle(translate("SpiralPocket", "Spiral Pocket"))
    box.setText("\n\n".join(in_panel(error.message) for error in errors))
    hints = dict.fromkeys(in_panel(e.hint) for e in errors if e.hint)
    box.setInformativeText("\n".join([*hints, *([more] if more else [])]))
    box.setStandardButtons(QtGui.QMessageBox.Ok)
    run_dialog(box)


def no_tool_controller(job: Any) -> SetupError:
    """Return what to say where there is none that FreeCAD's panel could show."""
    return SetupError(
        translate("SpiralPocket", "{} has no tool controller that can clear a pocket.").format(
            job.Label
        ),
        translate("SpiralPocket", "Add one with an end mill to the job, then try again."),
    )
