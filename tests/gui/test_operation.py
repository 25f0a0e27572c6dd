# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a selected face to a path and back, with the user's own buttons."""

import FreeCAD
import FreeCADGui
import pytest
from conftest import DEPTH, PathJobGui, floors, plate
from operations import cut_moves, only_operation
from PySide import QtGui
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
    screenshot,
    select,
    settle,
    wait_for,
    widget,
)

from freecad_spiralpocket.op import pockets


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


@pytest.mark.parametrize("is_applied", [False, True])
def test_cancel_takes_an_edit_back_although_something_was_renamed(doc, operation, is_applied):
    operation.setExpression("StockToLeave", "0.1 mm")
    doc.recompute()
    before = snapshot(doc)
    edit(operation)
    widget("stepOverPercent").setValue(30)
    doc.openTransaction("Rename")  # as the tree does
    doc.getObject("Part").Label = "Plate"
    doc.commitTransaction()
    operation.setExpression("StockToLeave", None)
    widget("stockToLeave").setProperty("rawValue", 0.3)
    widget("stepOverPercent").setValue(10)
    pump()
    if is_applied:
        press(APPLY)
        widget("stepOverPercent").setValue(40)
        pump()
    press(CANCEL)
    assert doc.getObject("Part").Label == "Plate"
    doc.getObject("Part").Label = "Part"
    assert not differences(before, snapshot(doc))
    assert "Touched" not in operation.State
    assert operation.StepOver == 40 and operation.Proxy.plans


def test_what_the_preview_has_read_off_the_part_is_not_read_again(job, floor, monkeypatch):
    select(floor)
    press_toolbar_button()
    settle()
    read = []
    monkeypatch.setattr(pockets.walls, "Walls", lambda *a, **k: read.append(a))
    press(OK)
    (operation,) = job.Operations.Group
    assert operation.Path.Length and not read and operation.Proxy.known is None


def test_opening_the_panel_leaves_nothing_to_compute(operation):
    before = operation.Proxy.plans
    edit(operation)
    assert "Touched" not in operation.State
    press(OK)
    assert operation.Proxy.plans is before


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
    settle()
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
