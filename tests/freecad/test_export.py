# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripting interface writes: programs, and why none."""

import FreeCAD
import pytest
from sample_parts import QUICK, add_job, small_job, snapshot

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import SetupError


@pytest.mark.parametrize("post", ["linuxcnc", "grbl"])
def test_export_writes_and_returns_the_program(doc, tmp_path, post):
    job, part, face = small_job(doc)
    made = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    before = snapshot(doc)
    path = tmp_path / "part.nc"
    text = api.export(job, path, post, args="--no-comments --precision=4")
    assert path.read_text(encoding="utf-8") == text
    assert text.count("G3") == sum(c.Name == "G3" for c in made.Path.Commands)
    assert f"F{made.ToolController.HorizFeed.Value * 60:.0f}" in text
    assert snapshot(doc) == before


@pytest.mark.parametrize("post", ["nonsense", "os; import sys", ""])
def test_an_unknown_post_is_refused(doc, tmp_path, post):
    job, part, face = small_job(doc)
    api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    with pytest.raises(SetupError, match="no post-processor"):
        api.export(job, tmp_path / "part.nc", post)
    assert not (tmp_path / "part.nc").exists()


def test_a_file_that_cannot_be_written_is_named(doc, tmp_path):
    job, part, face = small_job(doc)
    api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    with pytest.raises(SetupError, match=r"Cannot write .*part\.nc"):
        api.export(job, tmp_path / "missing" / "part.nc")


def test_export_of_what_has_no_path_is_refused(doc, tmp_path):
    job, part, face = small_job(doc)
    op = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    job.Tools.Group[0].Tool.Diameter = 40
    doc.recompute()
    doc.recompute()
    with pytest.raises(SetupError, match="has no path. The 40 mm cutter does not fit"):
        api.export(job, tmp_path / "part.nc")
    op.Active = False
    doc.recompute()
    with pytest.raises(SetupError, match="No active operation"):
        api.export(job, tmp_path / "part.nc")
    assert not list(tmp_path.iterdir())


def test_export_computes_what_has_changed(doc, tmp_path):
    job, part, face = small_job(doc)
    op = api.add_spiral_pocket(job, [(part, [face])], FinalDepth=-4, **QUICK)
    op.FinalDepth = -3
    text = api.export(job, tmp_path / "part.nc", args="--no-comments")
    heights = [float(word[1:]) for word in text.split() if word.startswith("Z")]
    assert min(heights) == pytest.approx(-3)


def test_fixtures_come_into_one_program(doc, tmp_path):
    job, part, face = small_job(doc)
    api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    job.Fixtures, job.SplitOutput, job.OrderOutputBy = ["G54", "G55"], True, "Fixture"
    words = api.export(job, tmp_path / "part.nc", args="--no-comments").split()
    assert words.index("G54") < words.index("G55") < words.index("M2")
    assert words.count("M2") == 1 and job.SplitOutput


@pytest.mark.parametrize("args", ["--bogus", "--precision=x"])
def test_arguments_that_the_post_does_not_know_are_told(doc, tmp_path, args):
    job, part, face = small_job(doc)
    api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    with pytest.raises(SetupError, match="made no program"):
        api.export(job, tmp_path / "part.nc", args=args)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["HorizFeed", "VertFeed"])
def test_export_refuses_a_program_without_feeds(doc, tmp_path, name):
    job, part, face = small_job(doc)
    operation = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    setattr(operation.ToolController, name, 0)
    with pytest.raises(SetupError, match="without feeds"):
        api.export(job, tmp_path / "part.ngc")
    assert not (tmp_path / "part.ngc").exists()


def test_export_computes_what_tool_and_part_have_changed(doc, tmp_path):
    job, part, face = small_job(doc)
    operation = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    far = operation.Path.BoundBox.XMax
    operation.ToolController.Tool.Diameter = operation.OpToolDiameter.Value + 1
    api.export(job, tmp_path / "part.ngc")
    assert operation.Path.BoundBox.XMax == pytest.approx(far - 0.5, abs=0.05)
    longer = FreeCAD.Matrix()
    longer.scale(2, 1, 1)
    part.Shape = part.Shape.transformGeometry(longer)
    api.export(job, tmp_path / "part.ngc")
    assert operation.Path.BoundBox.XMax > 1.5 * far


def test_export_refuses_a_path_whose_depth_is_gone(doc, tmp_path):
    job, part, face = small_job(doc)
    operation = api.add_spiral_pocket(job, [(part, [face])], **QUICK)
    sheet = doc.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "=-3 mm")
    sheet.setAlias("A1", "depth")
    doc.recompute()
    operation.setExpression("FinalDepth", "Sheet.depth")
    doc.recompute()
    api.export(job, tmp_path / "deep.ngc")
    sheet.set("A1", "three")
    doc.recompute()
    with pytest.raises(SetupError, match="out of date"):
        api.export(job, tmp_path / "stale.ngc")
    assert not (tmp_path / "stale.ngc").exists()


def test_export_refuses_a_path_of_a_part_that_failed(doc, tmp_path):
    box = doc.addObject("Part::Box", "Block")
    box.Length, box.Width, box.Height = 80, 60, 20
    room = doc.addObject("Part::Box", "Room")
    room.Length, room.Width, room.Height = 40, 30, 20
    room.Placement.Base = (20, 15, 10)
    rounded = doc.addObject("Part::Fillet", "Rounded")
    rounded.Base = room
    rounded.Edges = [(n, 5.0, 5.0) for n in (1, 3, 5, 7)]
    part = doc.addObject("Part::Cut", "Part")
    part.Base, part.Tool = box, rounded
    doc.recompute()
    job = add_job(doc, part)
    api.add_spiral_pocket(job, [(part, api.floors(part))], **QUICK)
    api.export(job, tmp_path / "part.ngc")
    room.Length = 8
    doc.recompute()
    with pytest.raises(SetupError, match="Rounded could not be computed"):
        api.export(job, tmp_path / "stale.ngc")
