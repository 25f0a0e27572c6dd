# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: every kind of file in, program, document, picture and report out."""

import json
import re
import sys

import FreeCAD
import Part
import pytest
from sample_parts import (
    DEPTH,
    add_job,
    add_part,
    area,
    block,
    circle,
    faces_at,
    rectangle,
    set_feeds,
)

from freecad_spiralpocket import cli
from freecad_spiralpocket.op import operation, part_files

SQUARE = [[0, 0], [24, 0], [24, 18], [0, 18]]
QUICK = ["--set", "Strategy=Linear Morph"]
PNG_SIGNATURE = b"\x89PNG"


@pytest.fixture(autouse=True)
def close_documents():
    """Close what the command line opens."""
    before = set(FreeCAD.listDocuments())
    yield
    for name in set(FreeCAD.listDocuments()) - before:
        FreeCAD.closeDocument(name)


@pytest.fixture
def one_pocket():
    """Return a block with one pocket."""
    return block(area(rectangle(24, 18, 4)))


@pytest.fixture
def two_pockets():
    """Return a block with two pockets."""
    return block(area(circle(8)), area(circle(9, 30, 0)))


def saved(shape, path):
    """Return `path` after writing `shape` to it in the format of its ending."""
    write = {".step": "exportStep", ".iges": "exportIges", ".brep": "exportBrep"}[path.suffix]
    getattr(shape, write)(str(path))
    return path


def call(*arguments):
    """Run the command line and return the operation."""
    return cli.run(cli.parser().parse_args([str(a) for a in arguments]))


@pytest.mark.parametrize("suffix", [".step", ".iges", ".brep"])
def test_a_shape_with_one_pocket_needs_no_face(one_pocket, tmp_path, capsys, suffix):
    part, program = saved(one_pocket, tmp_path / f"part{suffix}"), tmp_path / "part.nc"
    assert cli.main([str(part), "--tool", "6", "-o", str(program), *QUICK]) == 0
    assert "G3" in program.read_text(encoding="utf-8")
    report = capsys.readouterr().out.splitlines()
    for word in ("time", "length", "engagement", "uncut", "gouge"):
        assert sum(line.startswith(f"{word} ") for line in report) == 1


def test_an_outline_brings_its_tool_and_step(tmp_path):
    path = tmp_path / "pocket.json"
    hole = [[10, 6], [14, 6], [14, 12], [10, 12]]
    path.write_text(json.dumps({"outer": SQUARE, "holes": [hole], "tool": 3, "ae": 0.9}))
    op = call(path, "--depth", 2)
    assert (op.OpToolDiameter.Value, op.StepOver) == (3, 30)
    (plan,) = op.Proxy.plans
    assert plan.request.pocket.area == pytest.approx(24 * 18 - 24)
    assert (op.StartDepth.Value, op.FinalDepth.Value) == (0, -2)


def test_an_outline_with_islands_by_another_name_is_refused(tmp_path, capsys):
    corners = [[0, 0], [40, 0], [40, 30], [0, 30]]
    island = [[15, 12], [25, 12], [25, 18], [15, 18]]
    path = tmp_path / "outline.json"
    path.write_text(json.dumps({"outer": corners, "islands": [island], "name": "any"}))
    assert cli.main([str(path), "--tool", "6"]) == 1
    assert '"islands"' in capsys.readouterr().err
    path.write_text(json.dumps({"outer": corners, "holes": [island], "name": "any"}))
    assert cli.main([str(path), "--tool", "0.25 in", "--stepover", "30%"]) == 0


def test_an_outline_may_repeat_points_and_have_islands_at_its_wall(tmp_path):
    outer, hole = [[0, 0], *SQUARE, [0, 18]], [[20, 6], [30, 6], [30, 12], [20, 12], [20, 6]]
    path = tmp_path / "pocket.json"
    path.write_text(json.dumps({"outer": outer, "holes": [hole]}))
    (made,) = call(path, "--tool", 4).Proxy.plans
    assert made.request.pocket.area == pytest.approx(24 * 18 - 4 * 6)


def test_a_pocket_that_is_not_cut_shows_in_the_exit_code(tmp_path):
    pockets = block(area(rectangle(40, 30, 4)), area(rectangle(5, 5, 1, 60, 0)))
    path = saved(pockets, tmp_path / "two.brep")
    assert cli.main([str(path), "--face", "all", "--tool", "6"]) == 3


def test_pockets_that_are_not_cut_are_counted(tmp_path, capsys):
    pockets = block(area(rectangle(40, 30, 4)), area(rectangle(5, 5, 1, 60, 0)))
    call(saved(pockets, tmp_path / "two.brep"), "--face", "all", "--tool", 6)
    assert "not cut     1 of 2 pockets" in capsys.readouterr().out


@pytest.mark.parametrize("option", ["-o", "--png"])
def test_the_part_is_not_written_over(one_pocket, tmp_path, capsys, option):
    file = saved(one_pocket, tmp_path / "one.step")
    before = file.read_bytes()
    assert cli.main([str(file), "--tool", "6", option, str(file)]) == 1
    assert "the part itself" in capsys.readouterr().err
    assert file.read_bytes() == before


def test_a_terminal_shows_how_far_planning_is(one_pocket, tmp_path, capsys, monkeypatch):
    part = saved(one_pocket, tmp_path / "part.brep")
    call(part, "--tool", 6, *QUICK)
    assert "%" not in capsys.readouterr().err
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    call(part, "--tool", 6, *QUICK)
    assert re.search(r"\r +\d+ %  Laying", capsys.readouterr().err)
    assert operation.ObjectSpiralPocket.progress_factory is None


def test_a_start_point_is_three_numbers():
    assert cli.value_of("(7, 3.5, 0)") == cli.value_of("7,3.5,0") == (7.0, 3.5, 0.0)
    assert cli.value_of("3,5") == "3,5" and cli.value_of("1/16 in") == "1/16 in"


def test_several_pockets_are_listed(two_pockets, tmp_path, capsys):
    part = saved(two_pockets, tmp_path / "part.step")
    assert cli.main([str(part), "--tool", "6"]) == 1
    message = capsys.readouterr().err
    assert "has 2 pockets" in message and "--face all" in message
    assert all(f"--face {name} " in message for name in faces_at(two_pockets, -DEPTH))


def test_faces_are_chosen_by_name_or_all(two_pockets, tmp_path):
    part = saved(two_pockets, tmp_path / "part.brep")
    left, right = faces_at(two_pockets, -DEPTH)
    assert len(call(part, "--tool", 6, "--face", right, *QUICK).Proxy.plans) == 1
    both = call(part, "--tool", 6, "--face", left, "--face", right, *QUICK)
    every = call(part, "--tool", 6, "--face", "all", *QUICK)
    listed = call(part, "--tool", 6, "--face", f"{left.lower()},{right}", *QUICK)
    assert len(listed.Proxy.plans) == 2
    named_too = call(part, "--tool", 6, "--face", left, "--face", "all", *QUICK)
    assert len(both.Proxy.plans) == len(every.Proxy.plans) == len(named_too.Proxy.plans) == 2


def test_speeds_and_values_reach_the_operation(one_pocket, tmp_path):
    part = saved(one_pocket, tmp_path / "part.brep")
    speeds = ["--feed", 1800, "--plunge", 300, "--rapid", 6000, "--spindle", 9000]
    values = ["--set", "StockToLeave=0.5 mm", "--set", "HelixAngle=3"]
    flags = ["--set", "FinishingProfile=false", "--stepover", 25]
    op = call(part, "--tool", 6, *speeds, *values, *flags, *QUICK)
    controller = op.ToolController
    assert controller.HorizFeed.Value == pytest.approx(30)
    assert controller.VertFeed.Value == pytest.approx(5)
    assert controller.HorizRapid.Value == controller.VertRapid.Value == pytest.approx(100)
    assert controller.SpindleSpeed == 9000
    assert (op.StepOver, op.FinishingProfile) == (25, False)
    assert (op.StockToLeave.Value, op.HelixAngle.Value) == (0.5, 3)


def test_a_document_with_a_job_is_used_as_it_is(doc, one_pocket, tmp_path):
    part = add_part(doc, one_pocket)
    job = add_job(doc, part, diameter=5)
    set_feeds(job.Tools.Group[0], 1234)
    doc.saveAs(str(tmp_path / "job.FCStd"))
    op = call(tmp_path / "job.FCStd", "--fcstd", tmp_path / "out.FCStd", *QUICK)
    assert op.OpToolDiameter.Value == 5
    assert op.ToolController.HorizFeed.Value == pytest.approx(1234 / 60)
    assert (tmp_path / "out.FCStd").exists()


@pytest.mark.parametrize(("name", "code"), [("Part", 0), ("Other", 1)])
def test_a_part_of_the_job_is_chosen_by_its_name(doc, one_pocket, tmp_path, capsys, name, code):
    add_job(doc, add_part(doc, one_pocket), diameter=6.0)
    file = tmp_path / "job.FCStd"
    doc.saveAs(str(file))
    assert cli.main([str(file), "--part", name, *QUICK]) == code
    assert ("no part Other" in capsys.readouterr().err) == (code == 1)


def test_another_tool_is_added_to_the_job(doc, one_pocket, tmp_path):
    add_job(doc, add_part(doc, one_pocket), diameter=5)
    doc.saveAs(str(tmp_path / "job.FCStd"))
    op = call(tmp_path / "job.FCStd", "--tool", 8, *QUICK)
    assert op.OpToolDiameter.Value == 8 and op.ToolController.HorizFeed.Value > 0
    assert len(op.Proxy.job.Tools.Group) == 2


def test_a_document_with_several_parts_asks_which(doc, one_pocket, two_pockets, tmp_path, capsys):
    add_part(doc, one_pocket, "Plate")
    add_part(doc, two_pockets, "Frame")
    doc.recompute()
    doc.saveAs(str(tmp_path / "parts.FCStd"))
    assert cli.main([str(tmp_path / "parts.FCStd"), "--tool", "6"]) == 1
    assert "several parts: Plate, Frame" in capsys.readouterr().err
    op = call(tmp_path / "parts.FCStd", "--tool", 6, "--part", "Plate", *QUICK)
    assert op.Base[0][0].Objects[0].Label == "Plate"


def test_a_picture_and_another_post(one_pocket, tmp_path):
    part = saved(one_pocket, tmp_path / "part.brep")
    files = ["-o", tmp_path / "p.gcode", "--post", "grbl", "--png", tmp_path / "p.png"]
    call(part, "--tool", 6, *files, *QUICK)
    assert "(Begin preamble)" in (tmp_path / "p.gcode").read_text(encoding="utf-8")
    assert (tmp_path / "p.png").read_bytes().startswith(PNG_SIGNATURE)


def test_a_picture_without_matplotlib_is_refused(one_pocket, tmp_path, capsys, monkeypatch):
    part, picture = saved(one_pocket, tmp_path / "part.brep"), str(tmp_path / "p.png")
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    monkeypatch.setattr(cli.api, "add_spiral_pocket", None)
    assert cli.main([str(part), "--tool", "6", "--png", picture, *QUICK]) == 1
    assert "library matplotlib" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["-o", "--png", "--fcstd", "--post"])
def test_where_nothing_can_be_written_nothing_is_planned(
    one_pocket, tmp_path, capsys, monkeypatch, option
):
    part, folder = saved(one_pocket, tmp_path / "part.brep"), tmp_path / "missing"
    monkeypatch.setattr(cli.api, "add_spiral_pocket", None)
    asked = [option, str(folder / "file")]
    if option == "--post":
        asked = [option, "nosuch", "-o", str(tmp_path / "part.nc")]
    assert cli.main([str(part), "--tool", "6", *asked]) == 1
    words = "no post-processor nosuch" if option == "--post" else f"there is no folder {folder}"
    assert words in capsys.readouterr().err and not folder.exists()


def outline(*outer, hole=None):
    """Return an outline as JSON."""
    return json.dumps({"outer": outer, "holes": [] if hole is None else [hole]})


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("missing.step", None, "There is no file"),
        ("part.dwg", "", "of no known kind"),
        ("part.step", "nonsense", "cannot be read"),
        ("part.json", "{", "is not JSON"),
        ("part.json", "{}", "has no outline"),
        ("part.json", '{"outer": 5}', "has no outline"),
        ("part.json", '{"outer": [[0, 0], [9, "a"], [9, 9]]}', "outer of part.json is not"),
        ("part.json", '{"outer": [[0, 0], [NaN, 9], [9, 9]]}', "outer of part.json is not"),
        ("part.json", '{"outer": [[0, 0], [9, 0], [9, 9]], "holes": 5}', "holes of part.json is"),
        ("part.json", outline(*SQUARE, hole=[5, 5]), "holes[0] of part.json is not understood"),
        ("part.json", outline([0, 0], [30, 30], [30, 0], [0, 30]), "at X15.0 Y15.0"),
        (
            "part.json",
            outline([0, 0], [30, 0], [30, 30], [15, 0], [0, 30]),
            "touches itself at X15",
        ),
        ("part.json", outline([0, 0], [30, 0], [90, 0]), "outer of part.json has no area"),
        ("part.json", outline(*SQUARE, hole=[[3, 3], [6, 6], [6, 3], [3, 6]]), "holes[0] of"),
        ("part.json", outline(*SQUARE, hole=[[3, 3], [6, 6]]), "holes[0] of part.json has no area"),
        ("part.json", outline(*SQUARE, hole=[[30, 3], [36, 6], [36, 3]]), "lies outside of"),
        ("part.json", outline(*SQUARE, hole=[[-1, -1], [60, -1], [60, 60], [-1, 60]]), "nothing"),
        ("part.FCStd", "nonsense", "cannot be read"),
    ],
)
def test_a_file_that_is_no_part_is_named(tmp_path, capsys, monkeypatch, name, content, words):
    monkeypatch.setattr(cli.api, "add_spiral_pocket", None)
    path = tmp_path / name
    if content is not None:
        path.write_text(content)
    assert cli.main([str(path), "--tool", "6"]) == 1
    assert words in capsys.readouterr().err


@pytest.mark.parametrize("value", ["-5", "0", "nan", "fast"])
def test_a_speed_is_a_number_above_0(one_pocket, tmp_path, capsys, value):
    part = saved(one_pocket, tmp_path / "part.brep")
    with pytest.raises(SystemExit):
        cli.main([str(part), "--tool", "6", "--feed", value])
    assert f"{value} is not a number above 0" in capsys.readouterr().err


def test_speeds_that_are_set_stay(one_pocket, tmp_path):
    part = saved(one_pocket, tmp_path / "part.brep")
    controller = call(part, "--tool", 6, *QUICK).ToolController
    controller.HorizFeed, controller.VertFeed = 20.0, 0.0
    cli.set_speeds(controller, cli.parser().parse_args([str(part)]))
    assert controller.HorizFeed.Value == 20.0
    assert controller.VertFeed.Value == 20.0 * cli.PLUNGE_SHARE
    controller.HorizFeed, controller.VertFeed = 0.0, 3.0
    cli.set_speeds(controller, cli.parser().parse_args([str(part)]))
    assert controller.HorizFeed.Value == cli.FEED / 60 and controller.VertFeed.Value == 3.0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "There is no tool"),
        (["--tool", "30"], "30 mm cutter"),
        (["--tool", "6", "--set", "StepOver"], "has no value"),
        (["--tool", "6", "--set", "Stepover=4"], "no property Stepover"),
        (["--tool", "6", "--face", "Face1"], "Face1"),
        (["--tool", "6", "--face", "facet"], "no face Facet. Its faces are Face1 to Face"),
        (["--tool", "6", *QUICK, "--fcstd", "/proc/part.FCStd"], "Cannot write /proc"),
        (["--tool", "6", "--set", "StepOver=inf"], "StepOver cannot be inf"),
        (["--tool", "6", "--set", "UseStartPoint=perhaps"], "True or False"),
        (["--tool", "6", *QUICK, "--png", "part.xyz"], "Name a .png file"),
        (["--tool", "6", *QUICK, "--png", "part"], "Name a .png file"),
    ],
)
def test_what_cannot_be_cut_ends_with_a_sentence(one_pocket, tmp_path, capsys, arguments, words):
    part = saved(one_pocket, tmp_path / "part.brep")
    assert cli.main([str(part), *arguments]) == 1
    error = capsys.readouterr().err
    assert words in error and "Traceback" not in error


def test_faces_of_a_part_become_a_solid(one_pocket):
    loose = Part.Compound([face.copy() for face in one_pocket.Faces])
    sewn = part_files.solid(loose)
    assert sewn.Volume == pytest.approx(one_pocket.Volume)
    hull = Part.Compound(one_pocket.Faces[1:])
    assert not part_files.solid(hull).Solids
