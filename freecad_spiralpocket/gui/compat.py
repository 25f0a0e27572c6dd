# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every difference between the windows of FreeCAD 0.20, 1.0 and 1.1 that the panel meets.

The workbench "Path" of 0.20 (modules ``PathScripts.Path*``) is "CAM" since 1.0
(package ``Path``). Importing this module loads CAM's panel code, so `startup`
and `command` do without it.
"""

from __future__ import annotations

from typing import Any

from PathScripts import PathUtils
from PySide import QtCore, QtGui

from ..op.compat import IS_LEGACY, STALE_ELEMENT_ERRORS

if IS_LEGACY:
    from PathScripts import PathOpGui, PathSelection
else:
    import Path.Op.Gui.Base as PathOpGui
    import Path.Op.Gui.Selection as PathSelection

__all__ = [
    "INACTIVE_ICON",
    "TASK_DOCKS",
    "PathOpGui",
    "PathSelection",
    "PathUtils",
    "bear_lost_selection",
    "check_box_signal",
    "chinese_fonts",
    "fill_tool_controllers",
    "freecad_icon",
    "has_tool_controller_editor",
    "run_dialog",
    "tool_controller_editor",
]

#: The dock that holds task panels, since 1.0 and before.
TASK_DOCKS = ("Tasks", "Combo View")


def freecad_icon(name: str) -> str:
    """Return the file name of one of CAM's own icons."""
    return f":/icons/{'Path' if IS_LEGACY else 'CAM'}_{name}.svg"


#: FreeCAD's icon for an operation that is switched off.
INACTIVE_ICON = freecad_icon("OpActive")


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


def chinese_fonts() -> list[str]:
    """Return the families of fonts that have Chinese letters."""
    is_old = QtCore.qVersion().startswith("5")
    database = QtGui.QFontDatabase() if is_old else QtGui.QFontDatabase
    return [str(f) for f in database.families(QtGui.QFontDatabase.SimplifiedChinese)]


def check_box_signal(box: Any) -> Any:
    """Return the signal of a check box whose state changed (renamed in Qt 6.7)."""
    return box.checkStateChanged if hasattr(box, "checkStateChanged") else box.stateChanged


def has_tool_controller_editor() -> bool:
    """Return whether the panel can unfold the tool controller's own editor (1.1 and later)."""
    return hasattr(PathOpGui.TaskPanelPage, "updateToolControllerEditorVisibility")


def tool_controller_editor(page: Any) -> Any:
    """Return the editor that a page has for the chosen tool controller, None without."""
    return getattr(page, "tcEditor", None) or None


def fill_tool_controllers(page: Any) -> None:
    """Fill a page's list of tool controllers anew (1.1 has a method of its own for that)."""
    if hasattr(page, "resetTCCombo"):
        page.resetTCCombo()
    else:
        page.setupToolController(page.obj, page.form.toolController)


def run_dialog(dialog: QtGui.QDialog) -> int:
    """Show a modal dialog and return its result (``exec`` is a keyword's ghost in Qt 5)."""
    run = getattr(dialog, "exec", None) or dialog.exec_
    return run()
