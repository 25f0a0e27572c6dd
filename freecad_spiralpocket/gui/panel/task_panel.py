# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel around the pages: OK, Apply, Cancel, and Undo while it is open.

FreeCAD's own panel commits before it recomputes, so that an Undo brings the values back
and not the path, and closes whatever comes of it. Here OK recomputes within the
transaction and, when there is no path or one that leaves much of the floor, says so and
stays open; OK once more accepts that, or plans again if it was stopped. Cancel aborts the
transaction, which takes a new operation away altogether. An Undo or Redo, or deleting the
operation, closes the panel without touching the document; FreeCAD's own panels abort a
transaction in the middle of the Undo then, which crashes it. It closes like that as well
when another command takes the dialog away (``FreeCADGui.Control.closeDialog()``), which
tells nobody.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ...engine.errors import CancelledError, SpiralPocketError
from ...op.compat import parent_job
from ..compat import PathOpGui, PathSelection, bear_lost_selection
from ..fields.rounded import write_no_rounded_depths
from ..planning.outlook import was_stopped
from ..qt.later import later
from ..qt.names import forget_namesakes, renamed, rightly_named
from ..result.figures import left_out
from ..texts import messages
from ..texts.measures import area
from .room import make_room
from .values import Values

translate = FreeCAD.Qt.translate

AFTER_LAYOUT = 10  # ms: 0 would come among the events that lay the widgets out


class TaskPanel(PathOpGui.TaskPanel):
    """The operation's task panel; FreeCAD calls its methods."""

    def __init__(self, obj: Any, is_new: bool, page: Any, selection_factory: Any) -> None:
        self.document, self.name = obj.Document, obj.Name
        self.document_name = obj.Document.Name
        self.job_name = parent_job(obj).Name
        self.view_provider = obj.ViewObject.Proxy
        self.operation_page = page
        self.touched = _touched(obj.Document)
        self.values = Values(obj)
        self.outcome = obj.Proxy.plans, obj.Proxy.errors  # which no transaction brings back
        self.is_open = self.has_lost_widgets = False
        with rightly_named():
            super().__init__(obj, is_new, page, selection_factory)
        self.transaction = FreeCAD.getActiveTransaction()
        for each in self.featurePages:
            bear_lost_selection(each)
            if each is not page:
                write_no_rounded_depths(each)
        pages = self.form if isinstance(self.form, list) else [self.form]
        # boxes of their own, so that they stay in sight whatever is scrolled in the pages
        self.form = [*pages, *page.boxes]
        forget_namesakes()

    def setupUi(self) -> None:  # noqa: N802 - the name FreeCAD calls
        """Write what expressions give, and fill the pages.

        That touches the operation also where it changes nothing. One without a path stays so: OK
        tells why there is none, whatever came between.
        """
        obj, self.obj = self.obj, _WithWholeProperties(self.obj)
        try:
            super().setupUi()
        finally:
            self.obj = obj
        if obj.Path.Length and obj not in self.touched and self.values.are_kept:
            obj.purgeTouched()

    def modifyStandardButtons(self, buttonBox: Any) -> None:  # noqa: N802, N803
        """Take the buttons over."""
        super().modifyStandardButtons(renamed(buttonBox))

    def open(self) -> None:
        """Watch the selection and the document."""
        super().open()
        self.is_open = True
        FreeCAD.addDocumentObserver(self)
        self.operation_page.form.destroyed.connect(self._lose_widgets)
        later(AFTER_LAYOUT, self._make_room)

    def accept(self, resetEdit: bool = True) -> Any:  # noqa: N803
        """Take the values over and close, if there is a path or the user knows there is none.

        Stays open as well when what was typed last could not be taken.
        """
        if self._was_refused():
            return False
        is_due = self.isDirty() or "Touched" in self.obj.State or was_stopped(self.obj)
        if is_due and not self.compute():
            return False
        closed = super().accept(resetEdit)
        _close_transaction(abort=False)
        return closed

    def reject(self, resetEdit: bool = True) -> bool:  # noqa: N803
        """Undo everything since the panel was opened, a new operation included, and close.

        What was done before something else in the document, as a new name in the tree, is no longer
        in the panel's transaction: the operation's values are brought back here then.
        """
        self.preCleanup()
        proxy = self.obj.Proxy  # which may be out of reach in a moment
        is_own = FreeCAD.getActiveTransaction() == self.transaction
        self.document.abortTransaction()
        _close_transaction(abort=True)
        proxy.plans, proxy.errors = self.outcome
        if not is_own and not self.deleteOnReject:
            self.values.bring_back()
        for obj in (_touched(self.document) if is_own else {self.obj}) - self.touched:
            obj.purgeTouched()  # values and path are as they were: nothing to compute
        if self.deleteOnReject:
            self.remove()  # it was made in a transaction of its own
        self.cleanup(resetEdit)
        return True

    def leave(self) -> None:
        """Close as Cancel does, as FreeCAD ends the editing.

        FreeCAD keeps what was done, and goes on with the operation: a new one is removed when that
        is over, unless the document is closed.
        """
        if not self.deleteOnReject:
            self.reject(False)
            return
        self.preCleanup()
        self.panelCleanup()
        FreeCADGui.Control.closeDialog()
        LEFT.append(self)
        later(0, remove_left)

    def clicked(self, button: Any) -> None:
        """Compute when Apply was pressed; OK and Cancel have methods of their own."""
        if button == QtGui.QDialogButtonBox.Apply:
            self.compute()

    def compute(self) -> bool:
        """Take the values over and make the path; return whether there is one of all pockets.

        Shows the errors, except that the user pressed Stop, and what stays uncut.
        """
        self.panelGetFields()
        if was_stopped(self.obj):
            self.obj.touch()
        self.obj.Proxy.known = self.operation_page.outlook.known
        try:
            self.document.recompute()
        finally:
            self.obj.Proxy.known = None
        self.setClean()
        if was_stopped(self.obj):
            self.isdirty = True  # so that Apply can be pressed again
            self.pageDirtyChanged(None)
        self.operation_page.show_outcome()
        errors = self.obj.Proxy.errors or self._unexpected_errors()
        shown = [e for e in errors if not isinstance(e, CancelledError)]
        if shown:
            kept = translate("SpiralPocket", "OK once more keeps what was made without that.")
            messages.show(*shown, more=kept if self.obj.Proxy.plans else "")
        return not errors and not self._told_left_out()

    def _told_left_out(self) -> bool:
        """Tell how much of the floor stays uncut, if whole parts do; return whether they do."""
        left = left_out(self.obj.Proxy.plans)
        if left:
            told = translate("SpiralPocket", "{} of the floor stay uncut.").format(area(left))
            hint = translate("SpiralPocket", "The remarks in the result box say why.")
            kept = translate("SpiralPocket", "OK once more keeps this path.")
            messages.show(SpiralPocketError(told, hint), more=kept)
        return bool(left)

    def panelCleanup(self) -> None:  # noqa: N802 - the name FreeCAD calls
        """Stop watching the document; part of every way to close."""
        self.is_open = False
        FreeCAD.removeDocumentObserver(self)
        self.operation_page.close()
        forget_namesakes()  # of what the boxes have made since
        super().panelCleanup()

    def abandon(self) -> None:
        """Close without touching the operation, which may be gone."""
        if not self.is_open:
            return
        PathSelection.clear()
        FreeCADGui.Selection.removeObserver(self)
        for page in self.featurePages:
            page.onDirtyChanged(None)
        self.panelCleanup()
        if not self.has_lost_widgets:
            FreeCADGui.Control.closeDialog()
        if not self.has_document:
            return
        self.view_provider.clearTaskPanel()
        FreeCADGui.getDocument(self.document.Name).resetEdit()
        _close_transaction(abort=False)

    def slotChangedObject(self, changed: Any, name: str) -> None:  # noqa: N802 - as above
        """Follow the tool, which has an editor in the panel since 1.1."""
        if self._has_operation() and not self.document.Transacting:
            self.operation_page.update_tool(changed)

    def slotDeletedObject(self, deleted: Any) -> None:  # noqa: N802 - as above
        """Take a tool controller off the list, unless the operation goes with it."""
        job = parent_job(self.obj) if self._has_operation() else None
        if job is not None and deleted in job.Tools.Group:
            self.operation_page.drop_tool_controller(deleted)

    def slotRecomputedDocument(self, document: Any) -> None:  # noqa: N802 - as above
        """Follow part, stock and earlier operations."""
        if document == self.document and self.is_open:
            self.operation_page.look_again()

    def slotUndoDocument(self, document: Any) -> None:  # noqa: N802 - the name FreeCAD calls
        """Close, once the Undo is through."""
        if document == self.document:
            later(0, self.abandon)

    slotRedoDocument = slotUndoDocument  # noqa: N815 - the name FreeCAD calls

    @property
    def has_document(self) -> bool:
        """Return whether the document is open still."""
        return FreeCAD.listDocuments().get(self.document_name) == self.document

    def _has_operation(self) -> bool:
        """Return whether the panel is open and its operation neither gone nor going."""
        obj = self.document.getObject(self.name) if self.is_open else None
        return obj is not None and not obj.Removing

    def _was_refused(self) -> bool:
        """Say so if something was typed that cannot be taken, once."""
        self.operation_page.tidy()
        refusals, self.operation_page.refusals = self.operation_page.refusals, ()
        if refusals:
            messages.show(*map(SpiralPocketError, refusals))
        return bool(refusals)

    def _make_room(self) -> None:
        if self.is_open and self.form:  # FreeCAD takes that away as it closes a panel
            form = self.operation_page.form
            if make_room(self.form[0], form, form.advancedFrame):
                later(AFTER_LAYOUT, self._make_room)

    def _lose_widgets(self, *_: Any) -> None:
        """Close, as the widgets are gone, if nobody has told us to."""
        self.has_lost_widgets = True
        if self.is_open:
            self.operation_page.close()  # at once: a timer of the preview may be due
            later(0, self.abandon)

    def _unexpected_errors(self) -> list[SpiralPocketError]:
        """Return what to say when the recompute failed in a way that nobody foresaw."""
        if self.obj.isValid():
            return []
        return [
            SpiralPocketError(
                translate("SpiralPocket", "An error in the add-on: the path was not computed."),
                translate("SpiralPocket", "Please report it with the text in the Report view."),
            )
        ]

    def remove(self) -> None:
        """Remove the operation, as one step to undo or as part of the one that is under way."""
        if not self.has_document or self.document.getObject(self.name) is None:
            return
        is_alone = FreeCAD.getActiveTransaction() is None
        if is_alone:
            self.document.openTransaction(translate("SpiralPocket", "Remove Spiral Pocket"))
        self.view_provider.onDelete(self.obj.ViewObject)
        self.document.removeObject(self.name)
        if is_alone:
            self.document.commitTransaction()


#: Panels that FreeCAD has closed while their operations were new.
LEFT: list[TaskPanel] = []


def take_back(obj: Any) -> bool:
    """Keep a new operation that FreeCAD has left to edit it at once again; return whether it has.

    As by a double click while its panel is open.
    """
    panel = next((panel for panel in LEFT if panel.obj == obj), None)
    if panel is not None:
        LEFT.remove(panel)
    return panel is not None


def remove_left() -> None:
    """Remove the new operations that FreeCAD has left."""
    while LEFT:
        LEFT.pop().remove()


class _WithWholeProperties:
    """Stands in for an operation without the expressions of parts of properties.

    FreeCAD takes their paths (StartPoint.x) for names of properties.
    """

    def __init__(self, obj: Any) -> None:
        self._obj = obj
        self.ExpressionEngine = [each for each in obj.ExpressionEngine if hasattr(obj, each[0])]

    def __getattr__(self, name: str) -> Any:
        """Return what the operation has."""
        return getattr(self._obj, name)


def _touched(document: Any) -> set[Any]:
    """Return the objects that the next recompute would compute."""
    return {obj for obj in document.Objects if "Touched" in obj.State}


def _close_transaction(*, abort: bool) -> None:
    """Close what FreeCAD leaves open when nothing was changed within it."""
    if FreeCAD.getActiveTransaction():
        FreeCAD.closeActiveTransaction(abort)
