# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a selected face to a path and back, with the user's own buttons."""

import gc
import re
import zipfile

import FreeCAD
import FreeCADGui
import pytest
from conftest import DEPTH, PathJobGui, floors, plate
from PySide import QtCore, QtGui
from snapshot import differences, snapshot
from window import (
    APPLY,
    CANCEL,
    OK,
    edit,
    is_panel_open,
    panel,
    panel_button,
    pixels_that_differ,
    press,
    press_toolbar_button,
    pump,
    report_view,
    screenshot,
    select,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.qt.names import shiboken


def only_operation(job):
    """Return the job's one operation."""
    (operation,) = job.Operations.Group
    return operation


def cut_moves(operation):
    """Return the number of feed moves in the operation's path."""
    return sum(c.Name in ("G1", "G2", "G3") for c in operation.Path.Commands)


@pytest.fixture
def operation(job, floor):
    """Return an operation made with the panel, which is closed again."""
    select(floor)
    press_toolbar_button()
    press(OK)
    wait_for(lambda: not is_panel_open())
    return only_operation(job)


def test_new_operation_takes_the_selected_face(job, floor):
    select(floor)
    press_toolbar_button()
    operation = only_operation(job)
    assert is_panel_open()
    assert [(model.Name, faces) for model, faces in operation.Base] == [
        (job.Model.Group[0].Name, (floor[1],))
    ]
    press(CANCEL)


def test_new_operation_takes_the_selected_faces_of_several_parts(doc):
    parts = [doc.addObject("Part::Feature", name) for name in ("One", "Two")]
    for x, part in zip((0, 60), parts, strict=True):
        part.Shape = plate().translated(FreeCAD.Vector(x, 0, 0))
    doc.recompute()
    job = PathJobGui.Create(parts, None, False)
    FreeCAD.closeActiveTransaction()
    names = [floors(part, -DEPTH)[0] for part in parts]
    select((parts[0], "Edge1"), *zip(parts, names, strict=True))
    press_toolbar_button()
    (operation,) = job.Operations.Group
    models = job.Model.Group
    assert operation.Base == [(m, (n,)) for m, n in zip(models, names, strict=True)]
    press(CANCEL)


def test_ok_makes_a_path_with_the_value_from_the_panel(job, floor):
    select(floor)
    press_toolbar_button()
    widget("stepOverPercent").setValue(25)
    press(OK)
    operation = only_operation(job)
    assert not is_panel_open()
    assert operation.StepOver == 25
    assert cut_moves(operation) > 50
    assert operation.isValid() and "Touched" not in operation.State


def test_path_is_visible(operation):
    shown = screenshot()
    operation.ViewObject.Visibility = False
    hidden = screenshot()
    assert pixels_that_differ(shown, hidden) > 1000


def test_one_undo_removes_a_new_operation_and_redo_brings_it_back(doc, job, floor):
    before, steps = snapshot(doc), doc.UndoCount
    select(floor)
    press_toolbar_button()
    widget("stockToLeave").setProperty("rawValue", 0.5)
    press(OK)
    after = snapshot(doc)
    assert doc.UndoCount == steps + 1
    FreeCADGui.runCommand("Std_Undo", 0)
    pump()
    assert not differences(before, snapshot(doc))
    FreeCADGui.runCommand("Std_Redo", 0)
    pump()
    assert snapshot(doc).keys() == after.keys()
    assert only_operation(job).StockToLeave.Value == 0.5
    assert cut_moves(only_operation(job)) > 50


@pytest.mark.parametrize("computed", [False, True], ids=["at once", "after Apply"])
def test_cancel_removes_a_new_operation(doc, job, floor, computed):
    before, steps = snapshot(doc), doc.UndoCount
    select(floor)
    press_toolbar_button()
    widget("stepOverPercent").setValue(20)
    if computed:
        press(APPLY)
        assert cut_moves(only_operation(job)) > 50
    press(CANCEL)
    assert not is_panel_open()
    assert not differences(before, snapshot(doc))
    assert doc.UndoCount == steps
    assert not doc.HasPendingTransaction and FreeCAD.getActiveTransaction() is None


def test_new_operation_is_one_undo_step_also_after_a_cancelled_one(doc, job, floor):
    steps = doc.UndoCount
    for button in (CANCEL, OK, CANCEL):
        select(floor)
        press_toolbar_button()
        press(button)
    assert doc.UndoCount == steps + 1
    doc.undo()
    assert not job.Operations.Group


def test_new_operation_is_one_undo_step_when_a_transaction_was_left_open(doc, job, floor):
    steps = doc.UndoCount
    FreeCAD.setActiveTransaction("Left open")
    select(floor)
    press_toolbar_button()
    wait_for(is_panel_open)
    press(OK)
    assert doc.UndoCount == steps + 1


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


def test_cancelled_edit_restores_values_and_path_without_recompute(doc, operation):
    before, plans = snapshot(doc), operation.Proxy.plans
    edit(operation)
    assert widget("stepOverPercent").value() == operation.StepOver
    widget("stepOverPercent").setValue(15)
    widget("useOutline").setChecked(True)
    press(APPLY)
    assert operation.StepOver == 15
    press(CANCEL)
    assert not differences(before, snapshot(doc))
    assert operation.Proxy.plans is plans  # a recompute makes another list


def test_one_undo_restores_values_and_path_of_an_edit(doc, operation):
    before, steps = snapshot(doc)[operation.Name], doc.UndoCount
    edit(operation)
    widget("stepOverPercent").setValue(15)
    press(OK)
    assert doc.UndoCount == steps + 1
    assert operation.Path.toGCode() != before["Path"]
    doc.undo()
    assert operation.StepOver != 15
    assert operation.Path.toGCode() == before["Path"]


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


def test_operation_can_be_edited_with_an_expression_for_a_part_of_a_property(operation):
    operation.UseStartPoint = True
    operation.setExpression("StartPoint.x", "OpToolDiameter * 3")
    operation.Document.recompute()
    edit(operation)
    assert not widget("startPointX").isEnabled() and widget("toolController").currentText()
    widget("startPointY").setProperty("rawValue", 12.0)
    press(OK)
    assert not is_panel_open()
    assert tuple(operation.StartPoint) == (18.0, 12.0, 0.0)


@pytest.mark.parametrize(
    ("name", "value"), [("HelixAngle", 95.0), ("Tolerance", 0.0), ("LinkFeed", -10.0)]
)
def test_value_that_is_out_of_range_stays_and_is_told(operation, name, value):
    setattr(operation, name, value)
    operation.Document.recompute()
    edit(operation)
    wait_for(lambda: panel().operation_page.outlook.is_settled)
    kept = getattr(operation, name)
    assert getattr(kept, "Value", kept) == value
    assert panel().operation_page.outlook.plans == []
    press(CANCEL)


def test_apply_is_enabled_by_a_change_only(operation):
    edit(operation)
    assert not panel_button(APPLY).isEnabled()
    widget("stepOverPercent").setValue(22)
    assert panel_button(APPLY).isEnabled()
    press(APPLY)
    assert not panel_button(APPLY).isEnabled()
    press(CANCEL)


def test_operation_can_be_edited_after_reopening(operation, tmp_path):
    operation.Label = "Reopened"
    file = tmp_path / "job.FCStd"
    operation.Document.saveAs(str(file))
    FreeCAD.closeDocument(operation.Document.Name)
    document = FreeCAD.openDocument(str(file))
    pump(0.3)
    try:
        (reopened,) = document.getObjectsByLabel("Reopened")
        edit(reopened)
        widget("stepOverPercent").setValue(12)
        press(OK)
        assert reopened.StepOver == 12
        assert cut_moves(reopened) > 50
        assert reopened.ViewObject.Proxy.getIcon().endswith("SpiralPocket.svg")
    finally:
        FreeCAD.closeDocument(document.Name)


def test_panel_knows_the_path_of_a_document_that_was_opened(doc, operation, tmp_path):
    file = str(tmp_path / "job.FCStd")
    doc.saveAs(file)
    FreeCAD.closeDocument(doc.Name)
    again = FreeCAD.openDocument(file)
    edit(again.getObject("SpiralPocket"))
    page = panel().operation_page
    wait_for(lambda: page.outlook.is_settled, 60)
    assert "has this path" in page.result_box._state.text()
    widget("stepOverPercent").setValue(21)
    wait_for(lambda: page.outlook.is_settled, 60)
    assert "makes this path" in page.result_box._state.text()
    press(CANCEL)
    FreeCAD.closeDocument(again.Name)


def test_operation_that_was_saved_without_the_addon_comes_back(operation, tmp_path):
    file, before = tmp_path / "job.FCStd", operation.Path.toGCode()
    operation.Label = "Reopened"
    operation.Proxy = operation.ViewObject.Proxy = None  # as FreeCAD has it then
    operation.Document.saveAs(str(file))
    FreeCAD.closeDocument(operation.Document.Name)
    said = len(report_view())
    document = FreeCAD.openDocument(str(file))
    pump(0.3)
    try:
        (reopened,) = document.getObjectsByLabel("Reopened")
        assert report_view()[said:].count("Reopened") == 1
        assert reopened.Path.toGCode() == before
        document.recompute()
        path = before.replace("SpiralPocket", "Reopened")  # it begins with its label
        assert reopened.Proxy.plans and reopened.Path.toGCode() == path
        edit(reopened)
        widget("stepOverPercent").setValue(12)
        press(OK)
        assert reopened.StepOver == 12 and cut_moves(reopened) > 50
    finally:
        FreeCAD.closeDocument(document.Name)


def test_document_does_not_name_the_addons_folder(operation, tmp_path):
    file = tmp_path / "job.FCStd"
    operation.Document.saveAs(str(file))
    with zipfile.ZipFile(file) as archive:
        texts = [archive.read(name) for name in archive.namelist() if name.endswith(".xml")]
    assert not any(b"SpiralPocket.svg" in text for text in texts)


def test_documents_name_the_modules_that_they_always_did(operation, tmp_path):
    """A module of another name would leave operations that are saved without proxies."""
    file = tmp_path / "job.FCStd"
    operation.Document.saveAs(str(file))
    with zipfile.ZipFile(file) as archive:
        texts = [archive.read(name).decode() for name in ("Document.xml", "GuiDocument.xml")]
    named = [set(re.findall(r'module="(freecad_spiralpocket[^"]*)"', text)) for text in texts]
    assert named == [
        {"freecad_spiralpocket.op.operation"},
        {"freecad_spiralpocket.gui.viewprovider"},
    ]


@pytest.mark.parametrize("proxy", [None, 1])
def test_operation_without_view_provider_gets_one(operation, proxy):
    operation.ViewObject.Proxy = proxy
    operation.touch()
    operation.Document.recompute()
    edit(operation)
    assert widget("stepOverPercent").value() == operation.StepOver
    press(CANCEL)
    assert operation.Document.getObject("SpiralPocket") is not None


def test_context_menu_keeps_the_options_for_the_job(doc, job, operation):
    operation.StepOver, operation.UseOutline = 27, True
    menu = QtGui.QMenu()
    operation.ViewObject.Proxy.setupContextMenu(operation.ViewObject, menu)
    assert [action.text() for action in menu.actions()] == ["Edit", "Use as Default in This Job"]
    steps = doc.UndoCount
    menu.actions()[-1].trigger()
    assert doc.UndoCount == steps + 1
    sheet = job.SetupSheet
    assert (sheet.SpiralPocketStepOver, sheet.SpiralPocketUseOutline) == (27, True)
    doc.undo()
    assert "SpiralPocketStepOver" not in sheet.PropertiesList


def test_copy_is_cut_like_the_original(doc, job, operation):
    operation.StepOver = 30
    doc.recompute()
    copy = doc.copyObject(operation, False)
    job.Proxy.addOperation(copy)
    doc.recompute()
    assert copy.StepOver == 30 and cut_moves(copy) == cut_moves(operation)
    edit(copy)
    widget("stepOverPercent").setValue(20)
    press(OK)
    assert (operation.StepOver, copy.StepOver) == (30, 20)
    assert copy.Path.toGCode() != operation.Path.toGCode()
