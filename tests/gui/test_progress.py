# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work shows a dialog whose Stop leaves an empty path, never a stale one."""

import pytest
from conftest import add_job, plate
from PySide import QtCore, QtGui
from window import (
    APPLY,
    CANCEL,
    OK,
    answered,
    dialog,
    edit,
    is_panel_open,
    panel,
    panel_button,
    press,
    press_toolbar_button,
    pump,
    select,
    settle,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.planning import lane, lanes, workers
from freecad_spiralpocket.gui.planning.progress import progress_dialog

NAME = "SpiralPocketProgress"
#: So small a step-over that a stage of the plate's pocket goes on for long after the dialog is up,
#: in percent.
LONG = {"Laying": 1, "Planning feeds": 2}


@pytest.fixture
def job(doc):
    """Return a job for the plate with a 4 mm end mill, whose laps take longer to lay."""
    return add_job(doc, plate(), diameter=4.0)


class Stop:
    """Presses Stop once the dialog shows a stage, and keeps what it said."""

    def __init__(self, stage):
        self.stage = stage
        self.label = ""
        self.is_modal = False
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self.look)
        self.timer.start(20)

    def look(self):
        shown = dialog(NAME)
        if shown is not None and self.stage in shown.labelText():
            self.timer.stop()
            self.label = shown.labelText()
            self.is_modal = shown.windowModality() == QtCore.Qt.ApplicationModal
            shown.findChild(QtGui.QPushButton).click()


def busy():
    """Return the jobs that are waiting or under way."""
    running = [s.job for s in lanes.proofs._seats if s.job is not None]
    return running + lanes.proofs._waiting


@pytest.fixture(params=["process", "thread"])
def worker(request, monkeypatch):
    """Plan in a process, and where there is none."""
    if request.param == "thread":
        monkeypatch.setattr(workers.Interpreters, "left", [])
    monkeypatch.setattr(lanes, "proofs", lane.Lane(1))
    monkeypatch.setattr(lanes, "proved", {})
    yield request.param
    lanes.proofs.close()


@pytest.mark.parametrize("stage", ["Laying", "Planning feeds"])
def test_stop_leaves_an_empty_path_and_the_panel_open(job, floor, worker, stage):
    select(floor)
    press_toolbar_button()
    press(APPLY)
    (operation,) = job.Operations.Group
    assert len(operation.Path.Commands) > 50
    widget("stepOverPercent").setValue(LONG[stage])
    stop = Stop(stage)
    with answered() as answer:
        press(APPLY)
    assert stop.is_modal and operation.Label in stop.label
    assert not answer.texts
    assert [c.Name[0] for c in operation.Path.Commands] == ["("]
    assert operation.PathLength.Value == 0
    assert dialog(NAME) is None
    pump(1.0)  # the preview does not go on by itself
    assert panel().operation_page.outlook.is_stopped and not busy()
    widget("stepOverPercent").setValue(45)
    press(APPLY)
    assert len(operation.Path.Commands) > 50
    press(CANCEL)


@pytest.mark.parametrize("worker", ["process"], indirect=True)
def test_stop_is_told_and_the_next_value_planned(job, floor, worker):
    select(floor)
    press_toolbar_button()
    press(APPLY)
    page, (operation,) = panel().operation_page, job.Operations.Group
    wait_for(lambda: page.outlook.is_settled)
    widget("stepOverPercent").setValue(LONG["Laying"])
    stop = Stop("Laying")
    press(OK)
    assert stop.label and is_panel_open()
    wait_for(lambda: page.outlook.is_settled)
    assert "Stopped" in widget("summary").text() and widget("summary").isEnabled()
    assert not page.result_box.texts
    assert panel_button(APPLY).isEnabled()
    widget("stepOverPercent").setValue(45)
    press(OK)
    assert not is_panel_open()
    assert len(operation.Path.Commands) > 50


@pytest.mark.parametrize("worker", ["process"], indirect=True)
def test_ok_after_stop_plans_the_same_again(job, floor, worker):
    select(floor)
    press_toolbar_button()
    (operation,) = job.Operations.Group
    widget("stepOverPercent").setValue(LONG["Laying"])
    for _ in range(2):
        stop = Stop("Laying")
        press(OK)
        assert stop.label and is_panel_open()
        assert operation.Proxy.errors
    press(CANCEL)


@pytest.mark.parametrize("worker", ["process"], indirect=True)
def test_cancel_after_stop_leaves_the_path_as_before(job, floor, worker):
    select(floor)
    press_toolbar_button()
    press(OK)
    (operation,) = job.Operations.Group
    before, plans = operation.Path.toGCode(), operation.Proxy.plans
    edit(operation)
    widget("stepOverPercent").setValue(LONG["Laying"])
    stop = Stop("Laying")
    press(APPLY)
    assert stop.label and operation.Path.Length == 0
    press(CANCEL)
    assert operation.Path.toGCode() == before and len(before) > 1000
    assert operation.Proxy.plans == plans and not operation.Proxy.errors
    edit(operation)
    settle()
    assert "Stopped" not in widget("summary").text()
    press(CANCEL)


def test_path_is_the_same_wherever_it_is_planned(job, floor, monkeypatch):
    paths = []
    for planner in ("window", "process", "thread"):
        if planner == "window":
            monkeypatch.setattr(
                "freecad_spiralpocket.op.operation.ObjectSpiralPocket.planner", None
            )
        else:
            monkeypatch.undo()
            monkeypatch.setattr(lanes, "proofs", lane.Lane(1))
            monkeypatch.setattr(lanes, "proved", {})
            if planner == "thread":
                monkeypatch.setattr(workers.Interpreters, "left", [])
        select(floor)
        press_toolbar_button()
        press(APPLY)
        (operation,) = job.Operations.Group
        paths.append(operation.Path.toGCode().partition("\n")[2])  # without its name
        press(CANCEL)
        lanes.proofs.close()
    assert len(paths[0]) > 1000
    assert paths[0] == paths[1] == paths[2]


def test_the_window_has_a_process_to_plan_in(job, floor):
    lanes.proofs.warm_up()
    select(floor)
    press_toolbar_button()
    press(APPLY)
    assert workers.Interpreters.best() is not None
    press(CANCEL)


def test_short_work_shows_no_dialog():
    with progress_dialog("Pocket") as progress:
        for done in (0.0, 0.5, 1.0):
            assert not progress(done, "Cutting")
        assert dialog(NAME) is None
