# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors as a machinist reads them; the document is as before, and nothing stale is posted."""

import importlib
import sys

import Part
import pytest
from sample_parts import (
    DEPTH,
    QUICK,
    add_job,
    add_part,
    area,
    block,
    circle,
    faces_at,
    motion,
    rectangle,
    small_job,
    snapshot,
    vertical_face,
)

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import (
    CancelledError,
    CutterDoesNotFitError,
    NotYetError,
    RequestError,
    SelectionError,
    SetupError,
    SpiralPocketError,
)
from freecad_spiralpocket.engine.laps import automatic
from freecad_spiralpocket.op import compat, operation


@pytest.fixture
def setting(doc):
    """Return a job with a part, the part and the name of its floor."""
    return small_job(doc)


@pytest.fixture
def op(setting):
    """Return an operation with a path."""
    job, part, face = setting
    return api.add_spiral_pocket(job, [(part, [face])], **QUICK)


def refused(job, base, error, words, **values):
    """Check that the operation is refused, and that the document is as before."""
    before = snapshot(job.Document)
    with pytest.raises(error, match=words) as caught:
        api.add_spiral_pocket(job, base, **values)
    assert snapshot(job.Document) == before
    assert caught.value.hint.endswith(".")


def failed(op, error, words):
    """Check that a recompute leaves a comment in place of the path, and the reason."""
    op.Document.recompute()
    assert not motion(op)
    assert any("no path" in c.Name for c in op.Path.Commands)
    assert op.MachiningTime == 0 and op.SpiralCurve.isNull() and op.CycleTime == "00:00:00"
    assert any(isinstance(e, error) for e in op.Proxy.errors)
    assert words in " ".join(op.Notices)


def test_a_cutter_wider_than_the_pocket(doc):
    job, part, face = small_job(doc, diameter=20)
    refused(job, [(part, [face])], CutterDoesNotFitError, "20 mm cutter")


def test_no_face_selected(setting):
    job, part, _ = setting
    refused(job, [], SelectionError, "No floor is named")
    refused(job, [(part, [])], SelectionError, "No floor is named")


def test_a_vertical_face(setting):
    job, part, _ = setting
    refused(job, [(part, [vertical_face(part.Shape)])], SelectionError, "is a wall, not a floor")


def test_a_face_without_walls(setting):
    job, part, _ = setting
    refused(job, [(part, faces_at(part.Shape, 0))], SelectionError, "no wall rises from it")


def test_an_open_shell(doc):
    solid = block(area(rectangle(24, 18, 4)))
    top = faces_at(solid, 0)[0]
    rest = [f for n, f in enumerate(solid.Faces, 1) if f"Face{n}" != top]
    part = add_part(doc, Part.makeShell(rest))
    job = add_job(doc, part)
    floor = faces_at(part.Shape, -DEPTH)
    refused(job, [(part, floor)], SelectionError, "open shell, not a closed solid")


def test_a_part_that_is_not_in_the_job(setting):
    job, _, face = setting
    other = add_part(job.Document, block(area(circle(10))), "Other")
    job.Document.recompute()
    refused(job, [(other, [face])], SelectionError, "Other is not part of Job")


def test_depths_upside_down(setting):
    job, part, face = setting
    base = [(part, [face])]
    refused(job, base, RequestError, "upside down", StartDepth=-8, FinalDepth=-6)


@pytest.mark.parametrize("stepover", [0, -5, 101, 33.5])
def test_a_step_over_that_cannot_be(setting, stepover):
    job, part, face = setting
    refused(
        job, [(part, [face])], RequestError, f"StepOver cannot be {stepover}", StepOver=stepover
    )


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("Tolerance", 0, "tolerance"),
        ("StepDown", 0, "step down"),
        ("StepDown", 1e-6, "more than 500 levels"),
        ("SlotBite", 1e-5, "more than 500 levels"),
        ("SlotBite", -1, "SlotBite cannot be -1: it is negative"),
        ("SlowdownPercent", 1000, "SlowdownPercent cannot be 1000. Give 100 or less"),
        ("StepOver", True, "StepOver cannot be True"),
        ("HelixAngle", "steep", "HelixAngle cannot be 'steep': [^{}]*$"),
        ("HelixAngle", 0, "helix angle"),
        ("HelixAngle", 0.01, "more than 500 times on its way down"),
        ("FinishDepth", 50, "finish depth"),
        ("SafeHeight", -1, "heights"),
        ("ZStockToLeave", 9, "nothing is left to cut"),
    ],
)
def test_a_value_that_makes_no_sense(setting, name, value, words):
    job, part, face = setting
    refused(job, [(part, [face])], RequestError, words, **{name: value})


def test_a_step_over_with_thousands_of_laps_is_refused_before_they_grow(setting, monkeypatch):
    job, part, face = setting
    monkeypatch.setattr(automatic, "levels_from", None)
    refused(job, [(part, [face])], NotYetError, "step-overs wide", MaxEngagement=0.5)


def test_step_over_zero_in_the_panel(op):
    op.StepOver = 0
    failed(op, RequestError, "step-over of 0")


def test_no_tool_controller_in_the_job(setting):
    job, part, face = setting
    job.Tools.Group = []
    job.Document.recompute()
    refused(job, [(part, [face])], SetupError, "has no tool controller")


def test_no_tool_controller_left(op):
    op.ToolController = None
    failed(op, SetupError, "has no tool controller")


def test_tool_number_zero(op):
    op.ToolController.ToolNumber = 0
    failed(op, SetupError, "has tool number 0")


def test_a_drill_cannot_clear_a_pocket(op, monkeypatch):
    monkeypatch.setattr(operation, "tool_shape", lambda tool: "drill")
    op.touch()
    failed(op, SetupError, "is not an end mill")
    assert not op.Proxy.isToolSupported(op, op.ToolController.Tool)


@pytest.mark.parametrize("library", ["shapely", "scipy"])
def test_a_library_is_missing(op, monkeypatch, library):
    monkeypatch.setitem(sys.modules, library, None)
    op.touch()
    failed(op, SetupError, f"needs the Python library {library}")


def test_documents_can_be_opened_without_the_libraries(monkeypatch):
    ours = [name for name in sys.modules if name.startswith("freecad_spiralpocket")]
    registered = dict(compat.PathSetupSheet._RegisteredOps)
    monkeypatch.setattr(compat.PathSetupSheet, "_RegisteredOps", registered)
    blocked = [name for name in sys.modules if name.split(".")[0] in ("shapely", "scipy")]
    for name in ours:
        monkeypatch.delitem(sys.modules, name)
    for name in [*blocked, "shapely", "scipy"]:
        monkeypatch.setitem(sys.modules, name, None)
    loaded = importlib.import_module("freecad_spiralpocket.op.operation")
    assert loaded is not operation and loaded.ObjectSpiralPocket.plans == ()


def test_a_library_is_missing_for_a_script(setting, monkeypatch):
    job, part, face = setting
    monkeypatch.setitem(sys.modules, "shapely", None)
    refused(job, [(part, [face])], SetupError, "needs the Python library shapely")


def test_unknown_names_and_choices_are_listed(setting):
    job, part, face = setting
    base = [(part, [face])]
    refused(job, base, RequestError, "no property Stepover.*Is it StepOver", Stepover=30)
    refused(job, base, RequestError, "Is it tool_controller", ToolController=None)
    refused(job, base, RequestError, "Choose one of: Climb, Conventional", CutMode="Up")
    refused(job, base, RequestError, "StockToLeave cannot be 'much'", StockToLeave="much")
    refused(job, base, RequestError, "HelixAngle cannot be '3 mm'", HelixAngle="3 mm")


def test_an_operation_outside_of_any_job(op, monkeypatch):
    logged = []
    monkeypatch.setattr(operation.PathLog, "error", logged.append)
    op.Proxy.job.Operations.Group = []
    op.touch()
    op.Document.recompute()
    assert not motion(op) and "is not in a job" in op.Notices[0]
    assert [text.count(op.Label) for text in logged] == [1]


def test_an_operation_of_a_job_that_another_version_has_saved(op):
    job = op.Proxy.job
    job.Proxy = None  # as where its module is not there
    op.touch()
    op.Document.recompute()
    assert not motion(op)
    assert job.Label in op.Notices[0] and "another version" in op.Notices[0]


def test_a_face_that_vanished(op):
    op.Document.getObject("Part").Shape = Part.makeBox(40, 40, 10)
    failed(op, SelectionError, "")
    assert op.Base, "the selection stays, so that the user sees what is missing"


def test_one_bad_pocket_does_not_spoil_the_others(doc):
    part = add_part(doc, block(area(circle(8)), area(circle(2, 20, 0)), area(circle(8, 40, 0))))
    job = add_job(doc, part)
    faces = faces_at(part.Shape, -DEPTH)
    made = api.add_spiral_pocket(job, [(part, [*faces, faces_at(part.Shape, 0)[0]])], **QUICK)
    assert len(made.Proxy.plans) == 2
    assert {round(c.x / 20) for c in motion(made) if c.Name == "G1"} == {0, 2}
    small, top = made.Notices[:2]
    assert faces[1] in small and "6 mm cutter" in small and "not cut" in small
    assert "no wall rises" in top
    assert len(made.Proxy.errors) == 2


def test_the_same_trouble_in_all_pockets_is_told_once(doc):
    part = add_part(doc, block(area(circle(8)), area(circle(8, 20, 0))))
    job = add_job(doc, part)
    with pytest.raises(RequestError, match="step down of 0") as caught:
        api.add_spiral_pocket(job, [(part, faces_at(part.Shape, -DEPTH))], StepDown=0)
    assert "Face" not in str(caught.value)


def test_an_error_heals_when_its_cause_is_gone(op):
    op.ToolController.Tool.Diameter = 30
    failed(op, CutterDoesNotFitError, "30 mm cutter")
    op.ToolController.Tool.Diameter = 6
    op.Document.recompute()
    assert motion(op) and not op.Proxy.errors and "30 mm" not in " ".join(op.Notices)


def test_stop_leaves_no_path(op, monkeypatch):
    from contextlib import nullcontext

    def factory(label):
        return nullcontext(lambda done, stage: done > 0)

    monkeypatch.setattr(operation.ObjectSpiralPocket, "progress_factory", factory)
    op.StepOver = 30
    failed(op, CancelledError, "Stopped")
    assert op.isValid()


def test_an_unforeseen_error_leaves_no_stale_path(op, monkeypatch):
    from freecad_spiralpocket.beside import crew

    def broken(request, progress):
        raise ZeroDivisionError("a bug")

    monkeypatch.setattr(crew, "plan", broken)
    op.StepOver = 30
    op.Document.recompute()
    assert not op.isValid() and not motion(op) and op.CycleTime == "00:00:00"


def test_an_unforeseen_error_is_told_to_scripts(setting, monkeypatch):
    from freecad_spiralpocket.beside import crew

    def broken(request, progress):
        raise ZeroDivisionError("a bug")

    monkeypatch.setattr(crew, "plan", broken)
    job, part, face = setting
    refused(job, [(part, [face])], SetupError, "could not compute")


def test_a_failed_call_leaves_no_undo_step(doc):
    job, part, face = small_job(doc, diameter=20)
    doc.UndoMode = 1
    refused(job, [(part, [face])], SpiralPocketError, "cutter")
    assert doc.UndoCount == 0


def test_a_failed_call_inside_the_callers_undo_step_keeps_that_open(doc):
    job, part, face = small_job(doc, diameter=20)
    doc.UndoMode = 1
    doc.openTransaction("of the caller")
    part.Label = "Changed"
    refused(job, [(part, [face])], SpiralPocketError, "cutter")
    assert doc.HasPendingTransaction and part.Label == "Changed"
    doc.abortTransaction()


@pytest.mark.parametrize("above", [3.0, 0.5])
def test_a_floor_above_the_stock_is_told_as_that(doc, above):
    job, part, floor = small_job(doc)
    job.Stock.ExtZpos = -6.0 - above  # as where the model was moved and the stock was not
    doc.recompute()
    with pytest.raises(SetupError, match=f"lies {above:g} mm above the stock"):
        api.add_spiral_pocket(job, [(part, [floor])])
