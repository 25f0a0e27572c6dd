# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel around the pages: OK, Apply and Cancel.

FreeCAD's own panel commits before it recomputes, so that an Undo brings the
values back and not the path, and closes whatever comes of it. Here OK
recomputes within the transaction and, when there is no path, says why and stays
open; OK once more accepts that. Cancel aborts the transaction, which takes a new
operation away altogether.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from ..engine.errors import CancelledError
from . import messages
from .compat import PathOpGui


class TaskPanel(PathOpGui.TaskPanel):
    """The operation's task panel; FreeCAD calls its methods."""

    def __init__(self, obj: Any, is_new: bool, page: Any, selection_factory: Any) -> None:
        self.was_touched = "Touched" in obj.State
        self.operation_page = page
        super().__init__(obj, is_new, page, selection_factory)

    def accept(self, resetEdit: bool = True) -> Any:  # noqa: FBT001, FBT002, N803
        """Take the values over and close, if there is a path or the user knows there is none."""
        if self.isDirty() and not self.compute():
            return False
        closed = super().accept(resetEdit)
        _close_transaction(abort=False)
        return closed

    def reject(self, resetEdit: bool = True) -> bool:  # noqa: FBT001, FBT002, N803
        """Undo everything since the panel was opened, a new operation included, and close."""
        obj, document, name = self.obj, self.obj.Document, self.obj.Name
        self.preCleanup()
        document.abortTransaction()
        _close_transaction(abort=True)
        if document.getObject(name) is None:
            pass
        elif self.deleteOnReject:  # it was made in a transaction of its own
            self._remove(document, obj)
        elif not self.was_touched:
            obj.purgeTouched()  # values and path are as they were: nothing to compute
        self.cleanup(resetEdit)
        return True

    def clicked(self, button: Any) -> None:
        """Compute when Apply was pressed; OK and Cancel have methods of their own."""
        if button == QtGui.QDialogButtonBox.Apply:
            self.compute()

    def compute(self) -> bool:
        """Take the values over and make the path; return whether there is one.

        Shows the errors, except that the user pressed Stop.
        """
        self.panelGetFields()
        self.obj.Document.recompute()
        self.setClean()
        self.operation_page.show_result()
        errors = self.obj.Proxy.errors
        shown = [e for e in errors if not isinstance(e, CancelledError)]
        if shown:
            messages.show(*shown)
        return not errors

    def _remove(self, document: Any, obj: Any) -> None:
        document.openTransaction("Remove Spiral Pocket")
        obj.ViewObject.Proxy.onDelete(obj.ViewObject)
        document.removeObject(obj.Name)
        document.commitTransaction()


def _close_transaction(*, abort: bool) -> None:
    """Close what FreeCAD leaves open when nothing was changed within it."""
    if FreeCAD.getActiveTransaction():
        FreeCAD.closeActiveTransaction(abort)
