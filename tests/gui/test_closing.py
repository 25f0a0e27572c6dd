# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel closes whoever closes it, and leaves nothing behind."""

import gc
import time

import FreeCAD
import FreeCADGui
import pytest
from operations import cut_moves, only_operation
from PySide import QtCore, QtGui
from snapshot import differences, snapshot
from window import (
    CANCEL,
    OK,
    edit,
    is_panel_open,
    panel,
    press,
    press_toolbar_button,
    pump,
    select,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.panel.task_panel import AFTER_LAYOUT
from freecad_spiralpocket.gui.qt.names import shiboken


def test_undo_with_the_panel_open_closes_it(doc, job, floor):
    before = snapshot(doc)
    select(floor)
    press_toolbar_button()
    FreeCADGui.runCommand("Std_Undo", 0)
    wait_for(lambda: not is_panel_open())
    assert not differences(before, snapshot(doc))


@pytest.fixture
def deletions():
    """Return what is deleted, one after the other: names of objects, and of documents."""
    seen = []

    class Watch:
        def slotDeletedObject(self, obj):  # noqa: N802 - the name FreeCAD calls
            seen.append(obj.Name)

        def slotDeletedDocument(self, document):  # noqa: N802 - the name FreeCAD calls
            seen.append(document.Name)

    watch = Watch()
    FreeCAD.addDocumentObserver(watch)
    yield seen
    FreeCAD.removeDocumentObserver(watch)


def test_new_operation_stays_until_its_document_is_closed(doc, job, floor, deletions):
    """FreeCAD goes on with the operation whose editing it ends, and crashes where it is gone."""
    select(floor)
    press_toolbar_button()
    name, operation = doc.Name, only_operation(job).Name
    del deletions[:]
    FreeCAD.closeDocument(name)
    assert operation not in deletions[: deletions.index(name)]
    pump(0.3)
    assert not is_panel_open() and FreeCAD.getActiveTransaction() is None


def test_new_operation_goes_after_freecad_has_ended_its_editing(doc, job, floor):
    before = doc.Objects
    select(floor)
    press_toolbar_button()
    FreeCADGui.getDocument(doc.Name).resetEdit()
    assert len(job.Operations.Group) == 1 and not is_panel_open()
    pump()
    assert doc.Objects == before and not job.Operations.Group
    assert FreeCAD.getActiveTransaction() is None


def test_new_operation_goes_when_another_is_edited(doc, job, operation, floor):
    select(floor)
    press_toolbar_button()
    edit(operation)
    assert job.Operations.Group == [operation]
    widget("stepOverPercent").setValue(15)
    press(CANCEL)
    assert job.Operations.Group == [operation] and operation.StepOver != 15


@pytest.mark.parametrize("button", [OK, CANCEL])
def test_new_operation_stays_when_it_is_edited_again_at_once(doc, job, floor, button):
    before = doc.Objects
    select(floor)
    press_toolbar_button()
    edit(only_operation(job))
    assert is_panel_open() and len(job.Operations.Group) == 1
    widget("stepOverPercent").setValue(33)
    press(button)
    wait_for(lambda: not is_panel_open())
    if button == OK:
        made = only_operation(job)
        assert made.StepOver == 33 and cut_moves(made)
    else:
        assert doc.Objects == before
    assert FreeCAD.getActiveTransaction() is None


def test_deleting_the_operation_with_the_panel_open_closes_it(doc, job, operation):
    edit(operation)
    doc.removeObject(operation.Name)
    wait_for(lambda: not is_panel_open())
    assert not job.Operations.Group


def test_deleting_the_job_with_the_panel_open_closes_it(doc, job, operation):
    edit(operation)
    job.ViewObject.Proxy.onDelete(job.ViewObject)
    doc.removeObject(job.Name)
    pump()
    assert not is_panel_open()
    assert [o.Label for o in doc.Objects] == ["Part"]


def test_panel_closes_without_work_when_nothing_was_changed(operation):
    (plan,) = operation.Proxy.plans
    edit(operation)
    press(OK)
    assert not is_panel_open()
    assert operation.Proxy.plans[0] is plan
    assert FreeCAD.getActiveTransaction() is None


def test_closed_panel_leaves_no_name_for_its_buttons(operation):
    edit(operation)
    buttons = panel().buttonBox
    assert shiboken.isValid(buttons)
    press(CANCEL)
    assert not shiboken.isValid(buttons)


def names_of_what_is_gone():
    """Return the names of widgets that Python still takes for alive, though they are not."""
    gc.disable()  # PySide 2 crashes if widgets are collected while it lists them
    try:
        alive = {shiboken.getCppPointer(w)[0] for w in QtGui.QApplication.allWidgets()}
        named = [o for o in shiboken.getAllValidWrappers() if isinstance(o, QtGui.QWidget)]
        return {id(o) for o in named if shiboken.getCppPointer(o)[0] not in alive}
    finally:
        gc.enable()


@pytest.mark.parametrize(
    "close",
    [lambda: press(OK), lambda: press(CANCEL), FreeCADGui.Control.closeDialog],
    ids=["OK", "Cancel", "by others"],
)
def test_closed_panel_leaves_no_names_for_what_is_gone(operation, close):
    """PySide takes new timers and widgets at the same addresses for them, and aborts."""
    before = names_of_what_is_gone()
    for _ in range(2):
        edit(operation)
        forms = [page.form for page in panel().featurePages]
        named = [o for f in forms for o in vars(f).values() if isinstance(o, QtCore.QObject)]
        named += [*forms, *panel().form, panel().buttonBox]
        assert any(isinstance(o, QtGui.QLayout) for o in named)
        close()
        wait_for(lambda: not is_panel_open())
        pump(0.2)
        assert not any(map(shiboken.isValid, named))
    assert not names_of_what_is_gone() - before
    assert operation.ViewObject.Proxy.panel is None
    assert FreeCAD.getActiveTransaction() is None


def test_panel_that_others_close_as_it_is_laid_out_goes_quietly(operation):
    FreeCADGui.getDocument(operation.Document.Name).setEdit(operation.ViewObject, 0)
    time.sleep(2 * AFTER_LAYOUT / 1000)  # its timer is due before anything else
    FreeCADGui.Control.closeDialog()
    pump(0.3)
    assert not is_panel_open()
