# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every difference between the windows of FreeCAD 0.20, 1.0 and 1.1 that the panel meets.

The workbench "Path" of 0.20 (modules ``PathScripts.Path*``) is "CAM" since 1.0
(package ``Path``). Importing this module loads CAM's panel code, so `startup`
and `command` do without it.
"""

from __future__ import annotations

from typing import Any

import FreeCADGui
from PathScripts import PathUtils
from PySide import QtCore, QtGui

from ..op.compat import IS_LEGACY, STALE_ELEMENT_ERRORS, PathOp
from .names import renamed

if IS_LEGACY:
    from PathScripts import PathOpGui, PathSelection
else:
    import Path.Op.Gui.Base as PathOpGui
    import Path.Op.Gui.Selection as PathSelection

__all__ = [
    "INACTIVE_ICON",
    "NO_TOOL_CONTROLLER_ERRORS",
    "PathOpGui",
    "PathSelection",
    "PathUtils",
    "bear_lost_selection",
    "check_box_signal",
    "freecad_icon",
    "has_tool_controller_editor",
    "load_form",
    "run_dialog",
]


def freecad_icon(name: str) -> str:
    """Return the file name of one of CAM's own icons."""
    return f":/icons/{'Path' if IS_LEGACY else 'CAM'}_{name}.svg"


#: FreeCAD's icon for an operation that is switched off.
INACTIVE_ICON = freecad_icon("OpActive")

#: So many forms are made at most until PySide names all their widgets rightly.
FORMS = 5

#: What making an operation raises when the job has no tool controller, or none was chosen.
NO_TOOL_CONTROLLER_ERRORS = (PathUtils.PathNoTCExistsException, PathOp.PathNoTCException)


def bear_lost_selection(page: Any) -> None:
    """Let FreeCAD's page for depths bear a face that is selected still, but gone from its part.

    It raises at the face's height, and leaves the panel without what comes after that.
    """
    height_of = getattr(page, "selectionZLevel", None)
    if height_of is None:
        return

    def height_if_there(selected: Any) -> float | None:
        try:
            return height_of(selected)
        except STALE_ELEMENT_ERRORS:
            return None

    page.selectionZLevel = height_if_there


def check_box_signal(box: Any) -> Any:
    """Return the signal of a check box whose state changed (renamed in Qt 6.7)."""
    return box.checkStateChanged if hasattr(box, "checkStateChanged") else box.stateChanged


def has_tool_controller_editor() -> bool:
    """Return whether the panel can unfold the tool controller's own editor (1.1 and later)."""
    return hasattr(PathOpGui.TaskPanelPage, "updateToolControllerEditorVisibility")


def load_form(path: Any) -> Any:
    """Return the widgets of a form, each of its attributes the widget of that name.

    PySide may take a new widget for what was at the same address before, as the table of a job
    editor that FreeCAD never gave up: then another form is made, at other addresses.
    """
    forms: list[Any] = []  # kept until then
    while len(forms) < FORMS:
        forms.append(renamed(FreeCADGui.PySideUic.loadUi(str(path))))
        if all(map(_is_what_it_seems, vars(forms[-1]).values())):
            break
    return forms[-1]


def _is_what_it_seems(named: Any) -> bool:
    """Return whether Python takes a Qt object for the nearest class that it knows."""
    kind = named.metaObject() if isinstance(named, QtCore.QObject) else None
    while kind is not None and kind.className() != type(named).__name__:
        # the last widget there may have been of a class that this one's class inherits
        if hasattr(QtGui, kind.className()):
            return False
        kind = kind.superClass()
    return kind is not None


def run_dialog(dialog: QtGui.QDialog) -> int:
    """Show a modal dialog and return its result (``exec`` is a keyword's ghost in Qt 5)."""
    run = getattr(dialog, "exec", None) or dialog.exec_
    return run()
