# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operation's view provider: its icon in the tree, its panel, what may be selected.

CAM's own view provider looks the selection rule up in a fixed list of
operations, builds icons from compiled resources and saves both names into the
document. Here they belong to the class and nothing is saved, so that a document
does not remember where the add-on was installed.
"""

from __future__ import annotations

import gc
from collections.abc import Callable
from typing import Any

import FreeCAD
import FreeCADGui

from ..engine.errors import SpiralPocketError
from ..op import presets
from ..op.compat import KeepsNothing, parent_job
from ..op.expressions import check_expressions
from ..op.operation import required_job
from .compat import INACTIVE_ICON, PathOpGui, PathSelection, PathUtils
from .panel.operation_page import OperationPage
from .panel.task_panel import TaskPanel, remove_left, take_back
from .planning import progress
from .qt.later import later
from .resources import ICON, RESOURCES
from .texts import messages

translate = FreeCAD.Qt.translate


class ViewProvider(KeepsNothing, PathOpGui.ViewProvider):
    """Proxy of the operation's view object."""

    OpIcon = str(RESOURCES / "icons" / f"{ICON}.svg")

    def __init__(self, vobj: Any, *, is_new: bool) -> None:
        self.deleteOnReject = is_new  # whether Cancel removes it, until the panel was open once
        self.attach(vobj)
        vobj.Proxy = self

    def attach(self, vobj: Any) -> None:
        """Take over the view object: when it is made and when it is restored."""
        super().attach(vobj)
        progress.install()

    def getIcon(self) -> str:  # noqa: N802 - the name FreeCAD calls
        """Return the icon in the tree."""
        return self.OpIcon if self.Object.Active else INACTIVE_ICON

    def setupContextMenu(self, vobj: Any, menu: Any) -> None:  # noqa: N802
        """Offer to edit, and to make the options those of new operations."""
        super().setupContextMenu(vobj, menu)
        if parent_job(vobj.Object) is not None:
            action = menu.addAction(translate("SpiralPocket", "Use as Default in This Job"))
            action.triggered.connect(self.keep_options)

    def keep_options(self, checked: bool = False) -> None:
        """Keep the options in the job's setup sheet, as one step to undo."""
        document = self.Object.Document
        document.openTransaction(translate("SpiralPocket", "Use as Default in This Job"))
        presets.keep(self.Object)
        document.commitTransaction()

    def getSelectionFactory(self) -> Callable[[], None]:  # noqa: N802 - the name FreeCAD calls
        """Return what restricts the selection while the panel is open: as for Pocket."""
        return PathSelection.pocketselect

    def setEdit(self, vobj: Any = None, mode: int = 0) -> bool:  # noqa: N802
        """Open the panel."""
        if mode != 0:
            return False
        obj = (vobj or self.vobj).Object
        is_left = take_back(obj)
        remove_left()  # before this panel begins a step to undo
        try:
            _require_job(obj)
            check_expressions(obj)  # FreeCAD's pages raise, and leave the rest of the panel empty
        except SpiralPocketError as error:
            messages.show(error)
            return False
        # What is left of earlier panels still names their widgets, which are gone; PySide would
        # take new widgets at the same addresses for them.
        gc.collect()
        page = OperationPage(obj, 0)
        page.setTitle(translate("SpiralPocket", "Spiral Pocket"))
        page.setIcon(self.OpIcon)
        is_new = self.deleteObjectsOnReject() or is_left
        self.deleteOnReject = False
        self.setupTaskPanel(TaskPanel(obj, is_new, page, self.getSelectionFactory()))
        return True

    def unsetEdit(self, vobj: Any, mode: int) -> None:  # noqa: N802 - the name FreeCAD calls
        """Close the panel when FreeCAD ends the editing: as Cancel, if the operation stays."""
        if self.panel is None:
            return
        if self.Object.Removing or self.Object.Document.Transacting:
            later(0, self.panel.abandon)
        else:
            self.panel.leave()

    def setupTaskPanel(self, panel: Any) -> None:  # noqa: N802 - the name FreeCAD calls
        """Show the panel; the job shows the model in its place, if it can."""
        self.panel = panel
        FreeCADGui.Control.closeDialog()
        FreeCADGui.Control.showDialog(panel)
        panel.setupUi()
        self._tell_job("setupEditVisibility", panel)

    def clearTaskPanel(self) -> None:  # noqa: N802 - the name FreeCAD calls
        """Forget the panel, which closes."""
        panel, self.panel = self.panel, None
        self._tell_job("resetEditVisibility", panel)

    def _tell_job(self, method: str, panel: TaskPanel) -> None:
        """Call a method of the job's view provider, if there is one.

        There is none in a document that was made without a window, and an Undo may have taken
        the job away together with the operation.
        """
        job = panel.document.getObject(panel.job_name)
        if job is not None and hasattr(job.ViewObject.Proxy, method):
            getattr(job.ViewObject.Proxy, method)(job)


def _require_job(obj: Any) -> None:
    """Raise if an operation is in no job, or in one without tools: FreeCAD's panel would fail."""
    job = required_job(obj)
    if obj.ToolController is None and not PathUtils.getToolControllers(obj):
        raise messages.no_tool_controller(job)
