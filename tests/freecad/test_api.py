# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripting interface: values, models, tool controllers, floors."""

import math

import FreeCAD
import Part
import pytest
from FreeCAD import Vector
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
    snapshot,
)

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import SelectionError, SetupError, SpiralPocketError
from freecad_spiralpocket.op import compat

INCH = 25.4


def add_mill(job, diameter):
    """Return a second tool controller of `job`."""
    controller = compat.add_tool_controller(job, diameter)
    set_feeds(controller, 900)
    job.Document.recompute()
    return controller


def test_the_original_part_and_the_jobs_copy_mean_the_same(doc):
    job, part, face = small_job(doc)
    first = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    second = api.add_spiral_pocket(job, [(job.Model.Group[0], face)], **QUICK)
    assert first.Base[0][0] is second.Base[0][0] is job.Model.Group[0]
    assert gcode(first) == gcode(second)


def test_the_tip_of_a_body_means_the_body(doc):
    body = doc.addObject("PartDesign::Body", "Body")
    body.BaseFeature = add_part(doc, block(area(rectangle(24, 18, 4))))
    doc.recompute()
    foot = body.newObject("PartDesign::AdditiveBox", "Foot")
    foot.Placement.Base = Vector(0, 0, -DEPTH - 8)
    doc.recompute()
    assert body.Tip == foot
    job, floor = add_job(doc, body), faces_at(foot.Shape, -DEPTH)
    made = api.add_spiral_pocket(job, [(foot, floor)], **QUICK)
    assert made.Base[0][0] is job.Model.Group[0]
    before = next(o for o in body.Group if o != foot)
    with pytest.raises(SelectionError, match=f"Give {body.Label} with the names"):
        api.add_spiral_pocket(job, [(before, floor)], **QUICK)


def test_values_are_numbers_or_texts_with_units(doc):
    job, part, face = small_job(doc)
    made = api.add_spiral_pocket(
        job,
        [(part, [face])],
        StepOver=30.0,
        StockToLeave=0.3,
        ZStockToLeave="0.01 in",
        HelixAngle="3 deg",
        FinishingProfile=False,
        CutMode="Conventional",
        Comment="second side",
        **QUICK,
    )
    assert (made.StepOver, made.CutMode, made.FinishingProfile) == (30, "Conventional", False)
    assert made.StockToLeave.Value == pytest.approx(0.3)
    assert made.ZStockToLeave.Value == pytest.approx(0.01 * INCH)
    assert made.HelixAngle.Value == pytest.approx(3)
    assert made.Path.Commands[1].Name == "(second side)"


def test_depths_replace_their_expressions(doc):
    job, part, face = small_job(doc)
    made = api.add_spiral_pocket(job, [(part, [face])], FinalDepth="-4 mm", StepDown=2, **QUICK)
    assert "FinalDepth" not in dict(made.ExpressionEngine)
    assert "StartDepth" in dict(made.ExpressionEngine)
    cuts = {round(c.z, 3) for c in motion(made) if c.Name == "G1"}
    assert min(cuts) == -4 and -2 in cuts
    job.Document.recompute()
    assert made.FinalDepth.Value == -4


def test_the_first_operation_of_a_job_with_several_tool_controllers(doc):
    job, part, face = small_job(doc)
    wide = add_mill(job, 8)
    chosen = api.add_spiral_pocket(job, [(part, [face])], tool_controller=wide, **QUICK)
    assert chosen.ToolController is wide and chosen.OpToolDiameter.Value == 8
    follows = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    assert follows.ToolController is wide, "that of the last operation"


def test_without_a_word_the_first_tool_controller_is_used(doc):
    job, part, face = small_job(doc)
    add_mill(job, 8)
    assert api.add_spiral_pocket(job, [(part, [face])], **QUICK).OpToolDiameter.Value == 6


def test_a_job_in_a_document_that_is_not_active(doc):
    job, part, face = small_job(doc)
    other = FreeCAD.newDocument("Other")
    try:
        made = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
        assert made.Document is doc and made in job.Operations.Group
        assert FreeCAD.ActiveDocument is other and not other.Objects
    finally:
        FreeCAD.closeDocument(other.Name)


def test_two_jobs_in_one_document(doc):
    job, part, face = small_job(doc)
    second = add_job(doc, part, diameter=5)
    made = api.add_spiral_pocket(second, [(part, [face])], **QUICK)
    assert made in second.Operations.Group and made not in job.Operations.Group


def test_several_parts_and_faces_are_cut_in_the_order_given(doc):
    left = add_part(doc, block(area(circle(8)), area(rectangle(16, 16, 4, 20, -8))), "Left")
    right = add_part(doc, block(area(circle(8, 80, 0))), "Right")
    job = add_job(doc, left, right)
    names = faces_at(left.Shape, -DEPTH)
    made = api.add_spiral_pocket(
        job,
        [(right, faces_at(right.Shape, -DEPTH)), (left, list(reversed(names)))],
        **QUICK,
    )
    centers = [plan.request.pocket.centroid.x for plan in made.Proxy.plans]
    assert centers == pytest.approx([80, 28, 0], abs=0.1)
    assert len(made.SpiralCurve.Edges) == 3


def test_inactive_from_the_start(doc):
    job, part, face = small_job(doc)
    assert not motion(api.add_spiral_pocket(job, [(part, [face])], Active=False))


@pytest.mark.parametrize("of", ["nothing", "no names", "pair", "numbers"])
def test_floors_that_are_no_names_of_faces_are_told(doc, of):
    job, part, face = small_job(doc)
    base = {
        "nothing": [(None, [face])],
        "no names": [part],
        "pair": (part, [face]),
        "numbers": [(part, [11])],
    }[of]
    with pytest.raises(SelectionError, match="no part|not given as parts"):
        api.add_spiral_pocket(job, base, **QUICK)


def test_a_job_without_stock_or_tool_is_told(doc):
    job, part, face = small_job(doc)
    doc.removeObject(job.Tools.Group[0].Tool.Name)
    with pytest.raises(SetupError, match="has no tool"):
        api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    job, part, face = small_job(doc)
    doc.removeObject(job.Stock.Name)
    with pytest.raises(SetupError, match="has no stock"):
        api.add_spiral_pocket(job, [(part, [face])], **QUICK)


def test_a_floor_cut_by_seams_is_one_pocket(doc):
    whole = block(area(rectangle(24, 18, 4)))
    box = whole.BoundBox
    halves = [
        whole.common(
            Part.makeBox(box.XLength, box.YLength, box.ZLength, Vector(x, box.YMin, box.ZMin))
        )
        for x in (box.Center.x, box.Center.x - box.XLength)
    ]
    part = add_part(doc, halves[0].fuse(halves[1:]).Solids[0])
    faces = faces_at(part.Shape, -DEPTH)
    assert len(faces) == 2 and sorted(api.floors(part)) == sorted(faces)
    job = add_job(doc, part)
    op = api.add_spiral_pocket(job, [(part, faces)], **QUICK)
    assert len(op.Proxy.plans) == 1 and not any("open at a side" in n for n in op.Notices)
    assert op.Proxy.plans[0].request.pocket.area == pytest.approx(
        24 * 18 - 16 * (4 - math.pi), abs=0.2
    )
    # one half alone ends at the seam
    half = api.add_spiral_pocket(job, [(part, faces[:1])], **QUICK)
    assert any("open at a side" in notice for notice in half.Notices)
    assert any("The floor goes on" in notice for notice in half.Notices)
    assert not any("The floor goes on" in notice for notice in op.Notices)


def test_a_part_of_a_floor_without_walls_asks_for_all_of_it(doc):
    whole = block(area(rectangle(24, 18, 4)))
    box = whole.BoundBox
    middle = Part.makeBox(4, 4, box.ZLength, Vector(box.Center.x, box.Center.y, box.ZMin))
    part = add_part(doc, whole.cut(middle).fuse(whole.common(middle)).Solids[0])
    job = add_job(doc, part)
    inner = min(faces_at(part.Shape, -DEPTH), key=lambda name: part.Shape.getElement(name).Area)
    assert sorted(api.floors(part)) == sorted(faces_at(part.Shape, -DEPTH))
    with pytest.raises(SelectionError, match="no wall rises from it.*all faces that make"):
        api.add_spiral_pocket(job, [(part, [inner])], **QUICK)


def test_floors_are_found_the_highest_first(doc):
    part = add_part(doc, block(area(rectangle(40, 30, 4)), area(circle(9, 60, 20))))
    names = api.floors(part)
    assert len(names) == 2 and set(names) == set(faces_at(part.Shape, -DEPTH))
    op = api.add_spiral_pocket(add_job(doc, part), [(part, names)], **QUICK)
    assert len(op.Proxy.plans) == 2


@pytest.mark.parametrize("kind", ["App::Part", "App::Link"])
def test_floors_of_a_group_or_a_link_are_those_of_its_part(doc, kind):
    part = add_part(doc, block(area(rectangle(20, 20))))
    other = doc.addObject(kind, "Other")
    if kind == "App::Part":
        other.addObject(part)
    else:
        other.LinkedObject = part
    other.Placement.Base = Vector(0, 100, 0)
    doc.recompute()
    assert api.floors(other) == api.floors(part) != []
    assert api.floors(add_job(doc, other).Model.Group[0]) == api.floors(part)


@pytest.mark.parametrize("what", [None, "Part"])
def test_floors_of_what_is_no_part_are_refused(what):
    with pytest.raises(SelectionError, match="no part"):
        api.floors(what)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"base": "part"}, "not given as parts"),
        ({"tool_controller": "TC"}, "TC is not a tool controller"),
        ({"StepOver": float("nan")}, "StepOver is not a number"),
        ({"FinalDepth": float("nan")}, "FinalDepth is not a number"),
        ({"UseOutline": "no"}, "True or False"),
        ({"CoolantMode": "Water"}, "Choose one of: .*Flood"),
        ({"StockToLeave": "5 deg"}, "[^.!]\\. Give a number, in mm"),
        ({"HelixAngle": "5 mm"}, "[^.!]\\. Give a number, in degrees"),
    ],
)
def test_wrong_values_are_refused_in_words(doc, change, words):
    job, part, face = small_job(doc)
    before = snapshot(doc)
    asked = {"base": [(part, [face])], **QUICK, **change}
    if asked["base"] == "part":
        asked["base"] = part
    with pytest.raises(SpiralPocketError, match=words):
        api.add_spiral_pocket(job, **asked)
    assert snapshot(doc) == before


def test_a_step_over_may_be_a_text(doc):
    job, part, face = small_job(doc)
    assert api.add_spiral_pocket(job, [(part, [face])], StepOver="30", **QUICK).StepOver == 30


def test_only_jobs_are_exported_and_only_to_files(doc, tmp_path):
    job, part, face = small_job(doc)
    operation = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    for wrong in (operation, doc, None):
        with pytest.raises(SetupError, match="is not a CAM job"):
            api.export(wrong, tmp_path / "part.ngc")
        with pytest.raises(SetupError, match="is not a CAM job"):
            api.add_spiral_pocket(wrong, [(part, [face])])
    with pytest.raises(SetupError, match="no file"):
        api.export(job, None)
