# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong is said once, with a way out, and the document is as before."""

import sys

import FreeCAD
import Part
import pytest
from conftest import plate
from snapshot import differences, snapshot
from window import (
    APPLY,
    CANCEL,
    OK,
    answered,
    edit,
    is_panel_open,
    press,
    press_toolbar_button,
    remarks,
    select,
    wait_for,
    widget,
)


def test_without_a_face_the_panel_opens_and_ok_says_so(doc, job):
    before = snapshot(doc)
    select()
    press_toolbar_button()
    assert is_panel_open()
    with answered() as answer:
        press(OK)
    assert len(answer.texts) == 1 and "face" in answer.texts[0]
    assert is_panel_open()
    press(CANCEL)
    assert not differences(before, snapshot(doc))


def test_wall_is_refused(doc, job, part):
    before = snapshot(doc)
    wall = next(
        f"Face{n}" for n, f in enumerate(part.Shape.Faces, 1) if abs(f.normalAt(0, 0).z) < 1e-6
    )
    select((part, wall))
    press_toolbar_button()
    with answered() as answer:
        press(OK)
    assert len(answer.texts) == 1 and wall in answer.texts[0]
    press(CANCEL)
    assert not differences(before, snapshot(doc))


def test_ok_once_more_keeps_an_operation_without_a_path(job, floor):
    select(floor)
    press_toolbar_button()
    job.Tools.Group[0].Tool.Diameter = 80
    with answered() as answer:
        press(OK)
        press(OK)
    assert len(answer.texts) == 1 and "80 mm" in answer.texts[0]
    assert not is_panel_open()
    (operation,) = job.Operations.Group
    assert not any(c.Name in ("G1", "G2", "G3") for c in operation.Path.Commands)


def test_error_stands_in_the_panel_and_goes_when_mended(job, floor):
    select(floor)
    press_toolbar_button()
    diameter = job.Tools.Group[0].Tool
    diameter.Diameter = 80
    with answered() as answer:
        press(APPLY)
    assert "80 mm" in remarks()
    diameter.Diameter = 6
    press(OK)
    assert len(answer.texts) == 1
    assert not is_panel_open()


def test_recompute_of_a_closed_operation_shows_no_message(doc, job, floor):
    select(floor)
    press_toolbar_button()
    press(OK)
    with answered() as answer:
        job.Tools.Group[0].Tool.Diameter = 80
        doc.recompute()
    (operation,) = job.Operations.Group
    assert operation.Proxy.errors
    assert not answer.texts


def test_job_without_tool_controller(doc, job, floor):
    for tool_controller in job.Tools.Group:
        doc.removeObject(tool_controller.Name)
    doc.recompute()
    before, steps = snapshot(doc), doc.UndoCount
    select(floor)
    with answered() as answer:
        press_toolbar_button()
    assert len(answer.texts) == 1 and "tool controller" in answer.texts[0]
    assert not is_panel_open()
    assert not differences(before, snapshot(doc))
    assert doc.UndoCount == steps
    assert FreeCAD.getActiveTransaction() is None


@pytest.mark.parametrize("library", ["shapely", "scipy"])
def test_missing_library_is_named(doc, job, floor, monkeypatch, library):
    before = snapshot(doc)
    monkeypatch.setitem(sys.modules, library, None)
    select(floor)
    with answered() as answer:
        press_toolbar_button()
    assert len(answer.texts) == 1 and library in answer.texts[0]
    assert not is_panel_open()
    assert not differences(before, snapshot(doc))


def test_operation_of_a_job_without_tools_cannot_be_edited(doc, job, floor):
    select(floor)
    press_toolbar_button()
    press(OK)
    (operation,) = job.Operations.Group
    doc.removeObject(job.Tools.Group[0].Name)
    doc.recompute()
    with answered() as answer:
        edit(operation)
    assert len(answer.texts) == 1 and "tool controller" in answer.texts[0]
    assert not is_panel_open()


def test_face_that_the_part_has_lost_is_named_while_it_is_selected(doc, job, part, floor):
    select(floor)
    press_toolbar_button()
    press(OK)
    (operation,) = job.Operations.Group
    select(floor)
    part.Shape = Part.makeBox(44, 32, 12, FreeCAD.Vector(0, 0, -12))
    doc.recompute()
    edit(operation)
    with answered() as answer:
        press(OK)
    assert len(answer.texts) == 1 and floor[1] in answer.texts[0]
    part.Shape = plate()
    doc.recompute()
    press(OK)
    assert not is_panel_open() and operation.Path.Length > 0


def test_operation_outside_a_job_cannot_be_edited(job, floor):
    select(floor)
    press_toolbar_button()
    press(OK)
    (operation,) = job.Operations.Group
    job.Operations.Group = []
    with answered() as answer:
        edit(operation)
    assert len(answer.texts) == 1 and "job" in answer.texts[0]
    assert not is_panel_open()


def test_stock_that_was_deleted_is_missed_in_words(doc, job, floor):
    select(floor)
    press_toolbar_button()
    press(OK)
    (operation,) = job.Operations.Group
    doc.removeObject(job.Stock.Name)
    doc.recompute()
    edit(operation)
    wait_for(lambda: "has no stock" in widget("summary").text())
    operation.Base = operation.Base  # FreeCAD looks for the depths then
    with answered() as answer:
        press(OK)
    assert len(answer.texts) == 1 and "has no stock" in answer.texts[0]
    press(CANCEL)


@pytest.mark.parametrize("name", ["StockToLeave", "StepDown", "SlowdownPercent"])
def test_operation_with_a_broken_expression_cannot_be_edited(doc, job, floor, name):
    select(floor)
    press_toolbar_button()
    press(OK)
    (operation,) = job.Operations.Group
    other = doc.addObject("App::FeaturePython", "Other")
    other.addProperty("App::PropertyFloat", "Size")
    operation.setExpression(name, "Other.Size")
    other.removeProperty("Size")
    with answered() as answer:
        edit(operation)
    assert len(answer.texts) == 1 and "Other.Size" in answer.texts[0]
    assert not is_panel_open()
