# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations that are saved, opened again, or copied."""

import re
import zipfile

import FreeCAD
import pytest
from operations import cut_moves
from window import (
    CANCEL,
    OK,
    edit,
    panel,
    press,
    pump,
    report_view,
    wait_for,
    widget,
)


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
