# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result box tells the figures of the path on show, and brings one to what it remarks."""

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import pytest
from conftest import DEPTH, add_job, floors, plate
from FreeCAD import Vector
from pivy import coin
from PySide import QtCore, QtGui
from window import (
    APPLY,
    CANCEL,
    OK,
    answered,
    edit,
    is_panel_open,
    page,
    panel,
    pixels_that_differ,
    press,
    press_toolbar_button,
    pump,
    remarks,
    screenshot,
    select,
    settle,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.planning import lanes
from freecad_spiralpocket.gui.texts.measures import duration
from freecad_spiralpocket.op import compat
from freecad_spiralpocket.op import remarks as op_remarks


def state():
    """Return what the box says of its figures."""
    return page().result_box._state.text()


def test_figures_are_there_before_and_after_apply(opened):
    before = page().result_box.texts
    assert "makes this path" in state()
    press(APPLY)
    settle()
    assert "has this path" in state()
    assert page().result_box.texts == before
    assert duration(opened.MachiningTime) in before.values()
    assert opened.PathLength.UserString in before.values()
    engagement = next(v for k, v in before.items() if k == "Largest engagement")
    assert engagement.startswith(f"{opened.LargestEngagement.Value:.0f}°")


def test_freecads_estimate_is_its_own(opened):
    press(APPLY)
    settle()
    tool = opened.ToolController
    seconds = opened.Path.getCycleTime(
        tool.HorizFeed.Value, tool.VertFeed.Value, tool.HorizRapid.Value, tool.VertRapid.Value
    )
    shown = page().result_box.texts["FreeCAD's estimate"]
    assert abs(int(shown.split()[0]) - seconds) < 2


def test_a_change_greys_the_figures_until_they_hold_again(opened):
    pump(0.3)  # it has got its height by then
    before, height = page().result_box.texts, page().result_box.box.height()
    widget("stepOverPercent").setValue(23)  # which no other test has planned
    assert not page().result_box.body.isEnabled()
    wait_for(lambda: page().outlook.pockets[0].drawn is None)
    assert not page().result_box.body.isEnabled()
    assert page().result_box.texts == before and page().result_box.box.height() == height
    settle()
    assert page().result_box.body.isEnabled()
    assert page().result_box.texts != before
    assert "makes this path" in state()


def test_reopened_panel_shows_the_figures(opened):
    press(APPLY)
    settle()
    texts = page().result_box.texts
    panel().accept()
    wait_for(lambda: not FreeCADGui.Control.activeDialog())
    edit(opened)
    settle()
    assert page().result_box.texts == texts
    assert "has this path" in state()
    press(CANCEL)


@pytest.fixture
def narrow(doc):
    """Return a job for a plate whose pocket has a room behind a neck too narrow for the cutter."""
    rooms = [Part.makeBox(30, 24, 9, Vector(*at, -DEPTH)) for at in ((6, 6), (42, 6))]
    neck = Part.makeBox(20, 4, 9, Vector(30, 16, -DEPTH))
    pocket = rooms[0].fuse(rooms[1]).fuse(neck).removeSplitter()
    job = add_job(doc, Part.makeBox(78, 36, 12, Vector(0, 0, -12)).cut(pocket), 6.0)
    return job, doc.getObject("Part")


def test_click_on_a_remark_brings_the_view_to_its_place(narrow):
    _, part = narrow
    select((part, floors(part, -DEPTH)[0]))
    press_toolbar_button()
    FreeCADGui.Selection.clearSelection()
    settle()
    box = page().result_box
    places = [i for i, r in enumerate(box._remarks) if r.place is not None]
    assert places and "neck" in box._remarks[places[0]].text
    before = screenshot()
    box.list.itemClicked.emit(box.list.item(places[0]))
    assert pixels_that_differ(before, screenshot()) > 1000
    camera = FreeCADGui.getDocument(part.Document.Name).ActiveView.getCameraNode()
    ahead = np.array(camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1)).getValue())
    eye = np.array(camera.position.getValue().getValue())
    away = np.array(box._remarks[places[0]].place) - eye
    assert np.linalg.norm(np.cross(away, ahead)) < 0.1
    press(CANCEL)


def test_first_line_says_how_far_the_planning_is(job, floor, monkeypatch):
    monkeypatch.setattr(lanes, "proved", {})
    select(floor)
    press_toolbar_button()
    widget("stepOverPercent").setValue(4)
    seen = []
    wait_for(lambda: seen.append(widget("summary").text()) or page().outlook.is_settled, 60)
    shares = [int(t.split()[1]) for t in seen if t.startswith("Planning: ")]
    assert len(set(shares)) > 1 and shares == sorted(shares)
    assert "limit" in widget("summary").text()
    press(CANCEL)


def test_what_changes_no_path_is_told_as_well(opened):
    press(OK)
    edit(opened)
    settle()
    opened.StartPoint = (1000, 1000, 0)
    widget("useStartPoint").setChecked(True)
    settle()
    assert "has this path" in state()
    assert "start point" in remarks() and "remarks: 1" in widget("summary").text()
    press(OK)
    edit(opened)
    settle()
    assert "start point" in remarks()
    widget("useStartPoint").setChecked(False)
    settle()
    assert "start point" not in remarks()
    press(CANCEL)


def test_rounded_tool_is_told_before_it_cuts(job, floor, monkeypatch):
    shape = compat.tool_shape(job.Tools.Group[0].Tool)
    monkeypatch.setattr(op_remarks, "ROUND_TOOLS", (shape,))
    select(floor)
    press_toolbar_button()
    settle()
    assert "not flat" in remarks()
    press(CANCEL)


def test_first_line_says_that_live_is_off(opened):
    page().preview.box.live.setChecked(False)
    pump()
    assert "Live" in widget("summary").text() and not page().result_box.texts
    press(APPLY)
    pump()
    assert "has this path" in state() and "limit" in widget("summary").text()
    assert duration(opened.MachiningTime) in page().result_box.texts.values()
    widget("useStartPoint").setChecked(True)
    pump()
    assert "Live" in widget("summary").text() and not page().result_box.texts
    press(APPLY)
    pump()
    assert "start point" in remarks()
    press(CANCEL)


def test_live_stays_off_in_the_next_panel_until_it_is_switched_on(opened):
    page().preview.box.live.setChecked(False)
    press(OK)
    edit(opened)
    assert not page().preview.box.live.isChecked()
    pump(0.5)
    assert "has this path" in state() and not page().outlook.pockets
    widget("stepOverPercent").setValue(30)
    pump(0.5)
    assert "Live" in state() and not page().outlook.pockets
    page().preview.box.live.setChecked(True)
    settle()
    assert page().outlook.plans
    press(CANCEL)
    edit(opened)
    assert page().preview.box.live.isChecked()
    press(CANCEL)


def test_error_is_told_while_live_is_off(opened):
    page().preview.box.live.setChecked(False)
    widget("helixAngle").setProperty("rawValue", 0.0)
    with answered() as answer:
        press(APPLY)
    assert len(answer.texts) == 1
    assert "helix angle" in widget("summary").text() and "helix angle" in remarks()
    press(CANCEL)


def test_first_line_tells_the_error_before_any_notice(opened):
    opened.setExpression("FinalDepth", None)
    opened.FinalDepth = -8.0
    settle()
    assert "below the selected floor" in remarks()
    widget("helixAngle").setProperty("rawValue", 0.0)
    settle()
    assert "below the selected floor" in remarks()
    assert "helix angle" in widget("summary").text()
    press(CANCEL)


def test_figures_of_the_last_path_are_gone_while_an_error_is_shown(opened):
    figures, seen = page().result_box.figures, []

    def look():
        if QtGui.QApplication.activeModalWidget() is not None:
            seen.append(figures.isVisible())

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(10)
    widget("helixAngle").setProperty("rawValue", 0.0)
    with answered():
        press(OK)
    timer.stop()
    assert seen and not seen[-1]
    press(CANCEL)


def test_a_change_of_the_tool_is_planned(opened):
    press(APPLY)
    settle()
    before, tool = page().result_box.texts, opened.ToolController
    tool.HorizFeed = 40.0
    wait_for(lambda: "makes this path" in state())
    settle()
    assert page().result_box.texts != before
    tool.SpindleSpeed = 0
    wait_for(lambda: "spindle speed" in remarks())
    tool.Tool.Diameter = 8.0
    assert widget("stepOver").property("rawValue") == pytest.approx(3.2)
    settle()
    assert page().outlook.pockets[0].request.tool_diameter == 8.0
    press(CANCEL)


def test_a_change_of_the_part_is_planned(doc, job, part, opened):
    before = page().outlook.pockets[0].request.pocket.bounds
    aside = FreeCAD.Matrix()
    aside.move(Vector(1, 0, 0))
    part.Shape = plate().transformShape(aside, True)
    doc.recompute()
    settle()
    after = page().outlook.pockets[0].request.pocket.bounds
    assert after[0] == pytest.approx(before[0] + 1)
    press(CANCEL)


def test_panel_of_an_inactive_operation_says_so(opened):
    press(OK)
    opened.Active = False
    opened.Document.recompute()
    edit(opened)
    settle()
    assert "Active" in widget("summary").text()
    assert page().preview.box.status.text() == widget("summary").text() == state()
    press(CANCEL)


def test_no_face_no_path(job):
    select()
    press_toolbar_button()
    settle()
    assert "no path" in state().lower()
    assert any("No face" in r.text for r in page().result_box._remarks)
    press(CANCEL)


def test_pocket_that_cannot_be_cut_leaves_the_result_of_the_others(doc):
    pockets = [Part.makeBox(*size, 9, Vector(*at, -DEPTH)) for size, at in
               (((30, 24), (6, 6)), ((4, 24), (42, 6)))]  # fmt: skip
    solid = Part.makeBox(60, 36, 12, Vector(0, 0, -12)).cut(pockets[0]).cut(pockets[1])
    job = add_job(doc, solid, 6.0)
    part = doc.getObject("Part")
    select(*((part, name) for name in floors(part, -DEPTH)))
    press_toolbar_button()
    FreeCADGui.Selection.clearSelection()
    settle()
    assert "makes this path" in state() and "does not fit" in remarks()
    narrow = next(n for n in floors(part, -DEPTH) if part.getSubObject(n).BoundBox.XMin > 40)
    for told in (remarks(), page().preview.box.status.text()):
        assert f"Part, {narrow}: " in told
    assert "limit" in widget("summary").text() and "not cut: 1" in widget("summary").text()
    assert "does not fit" in page().preview.box.status.text()
    assert page().preview.box.slider.isEnabled()
    with answered() as answer:
        press(APPLY)
    settle()
    assert len(answer.texts) == 1 and "OK once more" in answer.texts[0]
    (operation,) = job.Operations.Group
    assert "has this path" in state() and "not cut: 1" in widget("summary").text()
    assert duration(operation.MachiningTime) in page().result_box.texts.values()
    page().plots.button.setChecked(True)
    assert page().plots.dock._curves.clock[-1] == pytest.approx(operation.MachiningTime)
    press(OK)
    edit(operation)
    with answered() as answer:
        press(OK)
    assert not is_panel_open() and not answer.texts  # nothing has changed since it was accepted


def test_result_player_plots_and_operation_tell_the_same_time(doc):
    pockets = [Part.makeBox(20, 20, 9, Vector(x, 8, -DEPTH)) for x in (6, 430)]
    solid = Part.makeBox(456, 36, 12, Vector(0, 0, -12)).cut(pockets[0]).cut(pockets[1])
    job = add_job(doc, solid, 6.0)
    job.Tools.Group[0].setExpression("HorizRapid", None)
    job.Tools.Group[0].HorizRapid = 20
    part = doc.getObject("Part")
    select(*((part, name) for name in floors(part, -DEPTH)))
    press_toolbar_button()
    FreeCADGui.Selection.clearSelection()
    settle()
    time = widget("summary").text().split(";")[0]
    box = page().preview.box
    assert time == box.clock.text() == page().result_box.texts["Time on Hobby router"]
    box.play.setChecked(True)  # which draws the cutter between the pockets as well
    wait_for(lambda: not box.play.isChecked(), 30)
    page().plots.button.setChecked(True)
    end = page().plots.dock._curves.clock[-1]
    press(OK)
    (operation,) = job.Operations.Group
    assert end == pytest.approx(operation.MachiningTime) and duration(end) == time


def test_player_tells_no_time_without_feeds(job, floor):
    job.Tools.Group[0].HorizFeed = 0
    select(floor)
    press_toolbar_button()
    FreeCADGui.Selection.clearSelection()
    settle()
    box = page().preview.box
    assert box.slider.isEnabled() and box.clock.text() == ""
    box.slider.setValue(400)
    assert box.clock.text() == ""
    press(CANCEL)
