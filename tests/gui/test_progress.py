# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work shows a dialog whose Stop leaves an empty path, never a stale one."""

import time

import pytest
from PySide import QtCore, QtGui
from window import APPLY, CANCEL, answered, dialog, press, press_toolbar_button, select, widget

from freecad_spiralpocket.engine.errors import CancelledError
from freecad_spiralpocket.gui.progress import progress_dialog
from freecad_spiralpocket.op import pockets

NAME = "SpiralPocketProgress"


def slow_plan(request, progress):
    """Stand in for the planner: work for 10 s unless stopped."""
    for step in range(500):
        if progress(step / 500, "Cutting"):
            raise CancelledError("Stopped.")
        time.sleep(0.02)
    pytest.fail("nobody stopped it")


class Stop:
    """Presses Stop once the dialog shows, and keeps what it said."""

    def __init__(self):
        self.label = ""
        self.is_modal = False
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self.look)
        self.timer.start(50)

    def look(self):
        shown = dialog(NAME)
        if shown is not None and "Cutting" in shown.labelText():
            self.timer.stop()
            self.label = shown.labelText()
            self.is_modal = shown.windowModality() == QtCore.Qt.ApplicationModal
            shown.findChild(QtGui.QPushButton).click()


def test_stop_leaves_an_empty_path_and_the_panel_open(job, floor, monkeypatch):
    select(floor)
    press_toolbar_button()
    press(APPLY)
    (operation,) = job.Operations.Group
    assert len(operation.Path.Commands) > 100
    monkeypatch.setattr(pockets, "plan_pocket", slow_plan)
    widget("stepOverPercent").setValue(15)
    stop = Stop()
    with answered() as answer:
        press(APPLY)
    assert stop.is_modal and operation.Label in stop.label
    assert not answer.texts
    assert [c.Name[0] for c in operation.Path.Commands] == ["("]
    assert operation.PathLength.Value == 0
    assert dialog(NAME) is None
    assert "Time" not in widget("result").text()
    press(CANCEL)


def test_short_work_shows_no_dialog():
    with progress_dialog("Pocket") as progress:
        for done in (0.0, 0.5, 1.0):
            assert not progress(done, "Cutting")
        assert dialog(NAME) is None
