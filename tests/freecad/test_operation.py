# SPDX-License-Identifier: LGPL-2.1-or-later
"""The life of an operation: recompute, save and reopen, copy, switch off, undo."""

from itertools import pairwise
from types import SimpleNamespace

import FreeCAD
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
    gcode,
    motion,
    rectangle,
    set_feeds,
    small_job,
)

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.toolpath import Kind
from freecad_spiralpocket.op import operation, properties, remarks
from freecad_spiralpocket.op.compat import IS_LEGACY, parent_job

if IS_LEGACY:
    from PathScripts import PathGeom
else:
    import Path.Geom as PathGeom

#: How far a pole of the exact curve may lie from where the document keeps it [mm].
SAVED = 1e-6
#: Area that may stand after any strategy [mm2].
UNCUT = 0.01


@pytest.fixture
def op(doc):
    """Return an operation with a path, by the strategy that has an exact curve."""
    job, part, face = small_job(doc)
    return api.add_spiral_pocket(job, [(part, [face])], **QUICK)


@pytest.mark.parametrize("strategy", properties.choices()["Strategy"])
def test_every_strategy_clears_the_pocket(doc, strategy):
    job, part, face = small_job(doc)
    made = api.add_spiral_pocket(job, [(part, [face])], Strategy=strategy)
    assert motion(made) and not made.Proxy.errors
    assert made.UncutArea < UNCUT and made.Gouge.Value <= made.Tolerance.Value


def test_the_path_uses_only_what_all_posts_understand(op):
    commands = motion(op)
    assert {c.Name for c in commands} <= {"G0", "G1", "G2", "G3"}
    lift, *moves, last = commands
    assert (lift.Name, set(lift.Parameters)) == (last.Name, set(last.Parameters)) == ("G0", {"Z"})
    assert all({"X", "Y", "Z"} <= set(c.Parameters) for c in moves)
    assert all({"I", "J"} <= set(c.Parameters) for c in moves if c.Name in ("G2", "G3"))
    assert all(c.Parameters["F"] > 0 for c in moves if c.Name != "G0")


@pytest.mark.parametrize("strategy", ["Automatic", "Linear Morph"])
def test_the_path_joins_to_one_wire(doc, strategy):
    """Dressups do that: the end of a helical arc must be where the next move begins."""
    job, part, face = small_job(doc)
    made = api.add_spiral_pocket(job, [(part, [face])], Strategy=strategy)
    wire, *_ = PathGeom.wireForPath(made.Path)
    assert wire.isValid() and len(wire.Edges) >= len(motion(made)) - 2


def test_no_move_of_the_path_goes_nowhere(op):
    places = [tuple(round(v, 3) for v in (c.x, c.y, c.z)) for c in motion(op)[1:-1]]
    assert all(a != b for a, b in pairwise(places))


def test_the_path_reaches_the_floor_and_ends_at_clearance(op):
    heights = [c.Parameters["Z"] for c in motion(op)]
    assert min(heights) == pytest.approx(-DEPTH)
    assert heights[0] == heights[-1] == max(heights) == op.ClearanceHeight.Value


@pytest.mark.parametrize(
    ("name", "expression", "value"),
    [
        ("StockToLeave", "0.1 mm * 3", 0.3),
        ("SlowdownPercent", "50 + 5", 55),
        ("StepOver", "30", 30),
    ],
)
def test_constant_expression_holds_after_a_recompute(op, name, expression, value):
    op.setExpression(name, expression)
    op.Document.recompute()
    found = getattr(op, name)
    assert getattr(found, "Value", found) == pytest.approx(value)
    assert dict(op.ExpressionEngine)[name]
    assert "Touched" not in op.State


def test_results_hold_what_was_measured(op):
    (plan,) = op.Proxy.plans
    assert 0 < op.LargestEngagement.Value <= 180
    assert op.UncutArea == pytest.approx(plan.report.uncut_area)
    assert op.Gouge.Value <= op.Tolerance.Value
    assert op.PathLength.Value == pytest.approx(plan.report.cut_length)
    assert op.MachiningTime == pytest.approx(plan.report.time)
    minutes, seconds = divmod(round(op.MachiningTime), 60)
    assert op.CycleTime == parent_job(op).CycleTime == f"00:{minutes:02d}:{seconds:02d}"


@pytest.mark.parametrize("suffix", ["step", "iges"])
def test_the_exact_curve_is_attached_and_can_be_exported(op, tmp_path, suffix):
    (edge,), ((curve,),) = op.SpiralCurve.Edges, [p.curves for p in op.Proxy.plans]
    assert edge.Curve.TypeId == "Part::GeomBSplineCurve"
    assert edge.Curve.Degree == curve.degree
    assert [v.Z for v in edge.Vertexes] == pytest.approx([-DEPTH, -DEPTH])
    path = str(tmp_path / f"spiral.{suffix}")
    getattr(op.SpiralCurve, f"export{suffix.title()}")(path)
    (read,) = Part.read(path).Edges
    poles = zip(read.Curve.getPoles(), curve.control_points, strict=True)
    assert max(abs(p.x - x) + abs(p.y - y) for p, (x, y) in poles) < SAVED


def test_a_changed_property_makes_a_new_path(op):
    before = gcode(op)
    op.StepOver = 25
    op.Document.recompute()
    assert gcode(op) != before
    op.StepOver = 40
    op.Document.recompute()
    assert gcode(op) == before


def arc_lengths(op) -> list[float]:
    """Return the length of all arcs that turn left, and of those that turn right [mm]."""
    (path,) = [plan.toolpath for plan in op.Proxy.plans]
    return [path.lengths[path.kinds == kind].sum() for kind in (Kind.ARC_CCW, Kind.ARC_CW)]


def test_conventional_milling_turns_the_path_around(op):
    names, before = [c.Name for c in motion(op)], arc_lengths(op)
    op.CutMode = "Conventional"
    op.Document.recompute()
    turned = [c.Name for c in motion(op)]
    # the helix: the first arcs of the path
    assert next(n for n in names if n in ("G2", "G3")) == "G3"
    assert next(n for n in turned if n in ("G2", "G3")) == "G2"
    # changes of feed may split arcs elsewhere
    assert arc_lengths(op)[::-1] == pytest.approx(before, rel=0.02)


def test_a_changed_tool_makes_a_new_path(op):
    before = gcode(op)
    op.ToolController.Tool.Diameter = 5
    op.Document.recompute()
    assert gcode(op) != before and op.OpToolDiameter.Value == 5


def test_a_changed_model_makes_a_new_path(op):
    before = gcode(op)
    part = op.Document.getObject("Part")
    part.Shape = block(area(rectangle(30, 18, 4)))
    op.Document.recompute()
    assert motion(op) and gcode(op) != before


def test_what_does_not_touch_the_path_plans_nothing(op, monkeypatch):
    from freecad_spiralpocket.beside import crew

    def refuse(request, progress):
        raise AssertionError("planned again")

    monkeypatch.setattr(crew, "plan", refuse)
    before = gcode(op)
    op.CoolantMode, op.Comment = "Flood", "deep"
    op.Document.recompute()
    assert gcode(op) == before and op.isValid()


@pytest.mark.parametrize(("name", "off", "on"), [("Active", False, True), ("Tolerance", 0, 0.01)])
def test_after_a_recompute_without_a_path_nothing_is_planned_again(op, name, off, on):
    (plan,) = op.Proxy.plans
    for value in (off, on):
        setattr(op, name, value)
        op.Document.recompute()
    assert op.Proxy.plans[0] is plan


def test_coolant_is_left_to_the_post(op):
    op.CoolantMode = "Flood"
    op.Document.recompute()
    assert not {c.Name for c in motion(op)} & {"M7", "M8", "M9", "M07", "M08", "M09"}
    assert "M8" in api.export(parent_job(op), "/dev/null").split()


def test_switched_off_it_has_no_motion_and_no_results(op):
    op.Active = False
    op.Document.recompute()
    assert not motion(op)
    assert op.MachiningTime == 0 and op.SpiralCurve.isNull()
    op.Active = True
    op.Document.recompute()
    assert motion(op)


def test_levels_follow_step_down_and_finish_depth(op):
    op.setExpression("StepDown", None)
    op.StepDown, op.FinishDepth = 3, 0.5
    op.Document.recompute()
    cuts = {round(c.z, 3) for c in motion(op) if c.Name == "G1" and c.z < 0}
    assert cuts == {-3.0, -5.5, -6.0}


def test_each_floor_is_cut_at_its_own_depth(doc):
    shape = block(area(rectangle(24, 18, 4)), area(rectangle(1, 1, 0, 60, 0)))
    shape = shape.cut(Part.makeCylinder(8, 10, FreeCAD.Vector(45, 9, -3)))
    part = add_part(doc, shape)
    job = add_job(doc, part)
    names = [faces_at(shape, -DEPTH)[0], faces_at(shape, -3)[0]]
    made = api.add_spiral_pocket(job, [(part, names)], **QUICK)
    assert made.FinalDepth.Value == pytest.approx(-DEPTH)
    floors = [p.request.heights.final_depth for p in made.Proxy.plans]
    assert floors == pytest.approx([-DEPTH, -3])
    made.setExpression("FinalDepth", None)
    made.FinalDepth = -2
    doc.recompute()
    assert [p.request.heights.final_depth for p in made.Proxy.plans] == pytest.approx([-2, -2])


def test_saved_and_reopened_it_is_the_same_and_recomputes(op, tmp_path):
    path = str(tmp_path / "saved.FCStd")
    op.StepOver, op.StockToLeave = 33, 0.2
    op.Document.recompute()
    before, name = gcode(op), op.Name
    op.Document.saveAs(path)
    FreeCAD.closeDocument(op.Document.Name)
    document = FreeCAD.openDocument(path)
    try:
        again = document.getObject(name)
        assert type(again.Proxy) is operation.ObjectSpiralPocket
        assert (again.StepOver, again.StockToLeave.Value) == (33, 0.2)
        assert again.Proxy.errors == () and again.Proxy.plans == ()
        assert not again.SpiralCurve.isNull() and again.MachiningTime > 0
        assert "Hidden" in again.getEditorMode("SchemaVersion")
        assert "ReadOnly" in again.getEditorMode("Gouge")
        again.touch()
        document.recompute()
        assert gcode(again) == before
    finally:
        FreeCAD.closeDocument(document.Name)


def test_a_copy_in_the_job_has_the_same_path(op):
    job = parent_job(op)
    copy = op.Document.copyObject(op, False)
    job.Proxy.addOperation(copy)
    copy.touch()
    op.Document.recompute()
    assert copy.Proxy is not op.Proxy
    assert gcode(copy) == gcode(op)


def test_undo_removes_the_operation_and_redo_brings_it_back(doc):
    job, part, face = small_job(doc)
    doc.UndoMode = 1
    made = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    name, path = made.Name, gcode(made)
    doc.undo()
    assert doc.getObject(name) is None and not job.Operations.Group
    doc.redo()
    assert gcode(doc.getObject(name)) == path


def test_without_feeds_there_is_a_path_but_no_feed_and_a_notice(op):
    set_feeds(op.ToolController, 0)
    op.Document.recompute()
    assert motion(op) and not any("F" in c.Parameters for c in motion(op))
    assert op.MachiningTime == 0
    assert any("no feeds" in notice for notice in op.Notices)


@pytest.mark.parametrize(("name", "told"), [("HorizFeed", "horizontal"), ("VertFeed", "vertical")])
def test_a_feed_that_is_missing_is_named(op, name, told):
    setattr(op.ToolController, name, 0)
    op.Document.recompute()
    assert any(f"has no {told} feed" in notice for notice in op.Notices)


def test_a_round_nosed_tool_is_used_with_a_notice(op, monkeypatch):
    monkeypatch.setattr(remarks, "tool_shape", lambda tool: "ballend")
    op.touch()
    op.Document.recompute()
    assert motion(op) and any("not flat" in notice for notice in op.Notices)


@pytest.mark.parametrize(
    ("has", "told"),
    [
        ({"CornerRadius": 1.0}, "its corner, 1 mm"),
        ({"FlatRadius": 2.0}, "its corner, 1 mm"),
        ({"CornerRadius": 2.5}, "ridges"),  # flat over 1 mm, steps of 2.4
        ({}, "ridges"),
    ],
)
def test_a_bull_nose_leaves_ridges_where_steps_are_wider_than_its_flat_end(has, told):
    tool = SimpleNamespace(ShapeType="Bullnose", Label="Bull", Diameter=6.0, **has)
    controller = SimpleNamespace(
        Proxy=SimpleNamespace(getTool=lambda _: tool), SpindleSpeed=1000, State=["Touched"]
    )
    (notice,) = remarks.tool(controller, 5.0, 5.0, 2.4)
    assert told in str(notice)


def test_progress_covers_all_pockets_and_is_opened_once(doc, monkeypatch):
    from contextlib import contextmanager

    seen, labels = [], []

    @contextmanager
    def factory(label):
        labels.append(label)
        yield lambda done, stage: seen.append((done, stage)) and False

    monkeypatch.setattr(operation.ObjectSpiralPocket, "progress_factory", factory)
    part = add_part(doc, block(area(circle(8)), area(circle(9, 30, 0))))
    job = add_job(doc, part)
    made = api.add_spiral_pocket(job, [(part, faces_at(part.Shape, -DEPTH))], **QUICK)
    fractions = [done for done, _ in seen]
    assert labels == [made.Label]
    assert fractions == sorted(fractions) and (fractions[0], fractions[-1]) == (0, 1)
    assert seen[-1][1].startswith("Pocket 2 of 2")


def test_face_of_a_part_in_an_assembly_is_the_one_that_was_clicked(doc):
    assembly = doc.addObject("App::Part", "Assembly")
    parts = [add_part(doc, block(area(rectangle(24, 18, 4))), name) for name in ("One", "Two")]
    parts[1].Placement.Base.x = 100
    for part in parts:
        assembly.addObject(part)
    doc.recompute()
    job = add_job(doc, assembly)
    op = operation.Create("SpiralPocket", parentJob=job)
    (name,) = faces_at(parts[1].Shape, -DEPTH)
    op.Proxy.addBase(op, parts[1], name)
    ((model, (found,)),) = op.Base
    center = model.Shape.getElement(found).CenterOfMass
    assert model == job.Model.Group[0]
    assert center.isEqual(parts[1].Shape.getElement(name).CenterOfMass, 1e-6)
