# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel follows what becomes of the job's tool controllers elsewhere."""

import pytest
from conftest import add_job, plate
from window import (
    CANCEL,
    OK,
    answered,
    edit,
    is_panel_open,
    panel,
    press,
    press_toolbar_button,
    pump,
    remarks,
    select,
    wait_for,
    widget,
)

from freecad_spiralpocket.op.compat import add_tool_controller


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
