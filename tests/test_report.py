# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report page: its figures are those of the path, and it says what it lacks."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from freecad_spiralpocket import machines, report
from freecad_spiralpocket.engine.motion.force import MATERIALS, Cutter
from freecad_spiralpocket.engine.motion.timing import time_of
from freecad_spiralpocket.gcode import parse_program
from freecad_spiralpocket.study import Setup, Study

#: A slot, a second pass beside it by 2 mm, and a way back through cleared ground.
PROGRAM = """G21 G90 S12000 M3
G0 X0 Y0 Z5
G1 Z-2 F300
G1 X60 F1200
G1 Y-2
G1 X0
G1 Y0
G0 Z5
"""


@pytest.fixture
def program(tmp_path):
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM)
    return path


def study() -> Study:
    """Return the study of the program for a 6 mm cutter."""
    return Study(
        parse_program(PROGRAM),
        Setup(
            Cutter(6.0),
            machines.load("vmc"),
            next(iter(MATERIALS.values())),
            spindle_speed=200.0,
            axial_depth=2.0,
            engagement_limit=math.acos(1 - 2 / 3),
        ),
    )


def test_page_shows_figures_and_all_pictures(program):
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    assert report.main([str(program), "--tool", "6", "--stepover", "2"]) == 0
    page = program.with_suffix(".html").read_text()
    seconds = time_of(parse_program(PROGRAM), machines.load("vmc")).total
    assert f"<td>{seconds:.1f} s</td>" in page
    assert "<td>Engagement limit</td><td>70.5 deg</td>" in page
    assert len(re.findall(r'src="data:image/png;base64,iVBOR', page)) == 7


def test_study_finds_slot_and_side_cut():
    measured = study()
    engagement, at = measured.engagement, measured.stations
    slot = engagement.angles[(at > 10) & (at < 60)]
    np.testing.assert_allclose(slot, np.pi, atol=1e-6)
    # 7 mm down, 60 mm slot, 2 mm aside, then a cut 2 mm wide
    side = engagement.angles[(at > 80) & (at < 120)]
    np.testing.assert_allclose(side, math.acos(1 - 2 / 3), atol=0.01)
    assert measured.forces.mean[(at > 80) & (at < 120)].max() < measured.forces.mean.max()
    assert np.all(np.diff(measured.clock) >= 0)
    assert measured.removal.max() == pytest.approx(6.0 * 2.0 * 20.0)


@pytest.mark.parametrize(
    ("levels", "step"), [((-2,), 2.0), ((-2, -4), 2.0), ((-3, -6, -7), 3.0), ((-1, -4), 3.0)]
)
def test_depth_of_a_full_cut_is_how_far_levels_are_apart(levels, step):
    lap = "G1 X60 F1200\nG1 Y-2\nG1 X0\nG1 Y0\n"
    cuts = "".join(f"G1 Z{z} F300\n{lap}" for z in levels)
    # short loops on the way down, as a slot has, are no levels
    path = parse_program(f"G21 G90\nG0 X0 Y0 Z5\nG1 Z-0.5 F300\nG1 X20 F1200\nG1 X0\n{cuts}G0 Z5\n")
    assert report.step_down_of(path, 0.0) == pytest.approx(step)


def test_program_without_a_tool_asks_for_it(program, capsys):
    assert report.main([str(program)]) == 1
    assert "--tool" in capsys.readouterr().err


def test_missing_file_is_told(tmp_path, capsys):
    assert report.main([str(tmp_path / "none.nc"), "--tool", "6"]) == 1
    assert "There is no file" in capsys.readouterr().err


def test_program_above_the_stock_is_told(tmp_path, capsys):
    path = tmp_path / "air.nc"
    path.write_text("G0 X0 Y0 Z5\nG1 X10 F100\n")
    assert report.main([str(path), "--tool", "6"]) == 1
    assert "never goes below" in capsys.readouterr().err


def test_page_does_not_overwrite_the_program(program, capsys):
    assert report.main([str(program), "--tool", "6", "-o", str(program)]) == 1
    assert "overwrite the program" in capsys.readouterr().err
    assert program.read_text() == PROGRAM


def test_folder_of_machines_that_is_not_there_is_told(program, capsys):
    assert report.main([str(program), "--tool", "6", "--machines", "nowhere"]) == 1
    assert "no folder nowhere" in capsys.readouterr().err


@pytest.mark.parametrize(
    "arguments", [["--tool", "-3"], ["--flutes", "0"], ["--flutes", "1.5"], ["--stepover", "nan"]]
)
def test_a_size_is_a_number_above_0(program, capsys, arguments):
    with pytest.raises(SystemExit):
        report.main([str(program), "--tool", "6", *arguments])
    error = capsys.readouterr().err
    assert f"{arguments[1]} is not a" in error
