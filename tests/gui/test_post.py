# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the selected floor to a program on disk, with FreeCAD's own Post Process."""

import FreeCADGui
from window import IS_LEGACY, OK, is_panel_open, press, press_toolbar_button, select, wait_for

POST = "Path_Post" if IS_LEGACY else "CAM_Post"


def test_a_selected_floor_becomes_a_program(job, floor, tmp_path):
    program = tmp_path / "plate.ngc"
    job.PostProcessor = "linuxcnc"
    job.PostProcessorArgs = "--no-show-editor --precision=4"
    job.PostProcessorOutputFile = str(program)
    select(floor)
    press_toolbar_button()
    press(OK)
    wait_for(lambda: not is_panel_open())
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(job)
    FreeCADGui.runCommand(POST)
    wait_for(program.exists)
    moves = program.read_text(encoding="utf-8").split()
    assert moves.count("G2") + moves.count("G3") > 20
    assert f"Z{floor[0].Shape.getElement(floor[1]).BoundBox.ZMin:.4f}" in moves
