# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel follows what becomes of the job's tool controllers elsewhere."""

import pytest
from conftest import add_job, plate
from PathScripts import PathUtils
from window import (
    APPLY,
    CANCEL,
    OK,
    answered,
    edit,
    is_panel_open,
    panel,
    panel_button,
    press,
    press_toolbar_button,
    pump,
    remarks,
    select,
    settle,
    wait_for,
    widget,
)

from freecad_spiralpocket.op.compat import IS_LEGACY, PathToolController, add_tool_controller

if IS_LEGACY:
    from PathScripts import PathToolBit
else:
    try:
        from Path.Tool.toolbit import ToolBit

        PathToolBit = None
    except ImportError:  # 1.0
        import Path.Tool.Bit as PathToolBit


def add_drill(job):
    """Add a tool controller with a drill to a job."""
    if PathToolBit:
        drill = PathToolBit.Factory.Create("Drill", PathToolBit.findToolShape("drill.fcstd"))
    else:
        drill = ToolBit.from_shape_id("drill.fcstd").attach_to_doc(doc=job.Document)
    controller = PathToolController.Create("TC: drill", tool=drill, toolNumber=7)
    job.Proxy.addToolController(controller)
    job.Document.recompute()
    return controller


@pytest.fixture
def operation(job, floor):
    """Return a new operation whose panel is open; the panel is closed with Cancel."""
    select(floor)
    press_toolbar_button()
    (operation,) = job.Operations.Group
    yield operation
    if is_panel_open():
        press(CANCEL)


def test_feed_and_name_that_are_changed_elsewhere_stay(operation):
    controller = operation.ToolController
    controller.HorizFeed, controller.SpindleSpeed, controller.Label = 50, 5000, "Another"
    pump()
    widget("stepOverPercent").setValue(20.0)
    pump()
    assert operation.ToolController == controller
    assert widget("toolController").currentText() == "Another"
    assert (controller.HorizFeed.Value, controller.SpindleSpeed) == (50, 5000)
    assert controller.Label == "Another"


def test_path_for_another_cutter_is_the_one_that_was_shown(job, operation):
    """The expression for the step down brings more decimals than FreeCAD's box shows."""
    controller = operation.ToolController
    controller.Tool.Diameter = 4.1234
    pump()
    widget("stepOverPercent").setValue(20.0)
    settle()
    shown = panel().operation_page.outlook.plans
    press(APPLY)
    assert operation.StepDown.Value == 4.1234
    assert shown and list(operation.Proxy.plans) == shown
    press(OK)
    assert "Touched" not in operation.State
    edit(operation)
    assert not panel_button(APPLY).isEnabled()


def test_deleted_tool_controller_is_missed_in_words(doc, operation):
    doc.removeObject(operation.ToolController.Name)
    pump()
    assert widget("toolController").currentText() == ""
    wait_for(lambda: "tool controller" in remarks())
    with answered() as answer:
        press(OK)
    assert len(answer.texts) == 1 and "tool controller" in answer.texts[0]
    assert is_panel_open()


def test_another_is_chosen_after_one_was_deleted(doc, job, operation):
    first = operation.ToolController
    second = add_tool_controller(job, 4.0)
    second.HorizFeed, second.VertFeed = 20, 5
    operation.ToolController = second
    panel().operation_page.show_tool_controller()
    doc.removeObject(second.Name)
    pump()
    assert operation.ToolController is None
    box = widget("toolController")
    assert box.currentIndex() == -1
    box.setCurrentIndex(box.findText(first.Label))
    pump()
    assert operation.ToolController == first
    press(OK)
    assert not is_panel_open() and operation.Path.Length > 0


def test_tool_controller_of_another_job_is_not_taken(doc, job, operation):
    press(OK)
    controller, another_job = operation.ToolController, add_job(doc, plate(), diameter=4.0)
    edit(operation)
    add_tool_controller(another_job, 3.0)
    assert operation.ToolController == controller


def test_job_with_a_drill_only_is_told_to_lack_an_end_mill(doc, job, floor):
    add_drill(job)
    doc.removeObject(job.Tools.Group[0].Name)
    before, steps = doc.Objects, doc.UndoCount
    select(floor)
    with answered() as answer:
        press_toolbar_button()
    assert len(answer.texts) == 1 and "end mill" in answer.texts[0]
    assert not is_panel_open()
    assert doc.Objects == before and doc.UndoCount == steps


def test_nothing_else_is_shown_for_a_tool_that_cannot_clear_a_pocket(doc, job, operation):
    press(OK)
    first, operation.ToolController = operation.ToolController, add_drill(job)
    doc.removeObject(first.Name)
    doc.recompute()
    edit(operation)
    assert widget("toolController").currentText() == ""
    wait_for(lambda: "end mill" in remarks())
    added = add_tool_controller(job, 4.0)
    added.HorizFeed, added.VertFeed = 20, 5
    panel().operation_page.show_tool_controller()
    box = widget("toolController")
    box.setCurrentIndex(box.findText(added.Label))
    pump()
    assert operation.ToolController == added


def test_first_is_chosen_unasked_after_the_operations_own_was_deleted(
    doc, job, operation, monkeypatch
):
    asked = []
    monkeypatch.setattr(PathUtils.UserInput, "chooseToolController", asked.append)
    press(OK)
    second = add_tool_controller(job, 4.0)
    add_tool_controller(job, 5.0)
    doc.removeObject(operation.ToolController.Name)
    doc.recompute()
    edit(operation)
    assert widget("toolController").currentText() == second.Label
    assert operation.ToolController == second and not asked


def test_operation_without_any_tool_to_choose_cannot_be_edited(doc, job, operation):
    press(OK)
    add_drill(job)
    doc.removeObject(operation.ToolController.Name)
    doc.recompute()
    with answered() as answer:
        edit(operation)
    assert len(answer.texts) == 1 and "end mill" in answer.texts[0]
    assert not is_panel_open()
