# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is planned in several processes comes out as it does one by one, whatever fails."""

import os
import signal
import sys
import threading
import time
from dataclasses import fields, replace
from pathlib import Path

import pytest
from shapely import box

sys.path.insert(0, str(Path(__file__).parent / "engine"))
from shapes import request

from freecad_spiralpocket.beside import crew, tasks
from freecad_spiralpocket.beside.crew import plan_together
from freecad_spiralpocket.beside.interpreters import Interpreters
from freecad_spiralpocket.beside.messages import Mailbox, framed
from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.errors import CancelledError, SpiralPocketError
from freecad_spiralpocket.engine.model import Cutting, Heights, Section, Strategy


def rectangle(width, height=20.0, stepover=2.4):
    """Return the request for a rectangular pocket."""
    cutting = Cutting(stepover=stepover)
    return request(box(0, 0, width, height), cutting=cutting, strategy=Strategy.LINEAR_MORPH)


MANY = [rectangle(16.0 + i) for i in range(4)]


@pytest.fixture(autouse=True)
def this_python(monkeypatch):
    """Let the processes run the interpreter of the tests."""
    monkeypatch.setattr(Interpreters, "left", [sys.executable])


@pytest.fixture(scope="module")
def alone():
    """Return the paths planned here one by one."""
    return [paths_of(plan(request)) for request in MANY]


def paths_of(plan):
    """Return all numbers of a plan's path, in bytes: where there is none, there is nan."""
    path = plan.toolpath
    return [getattr(path, f.name).tobytes() for f in fields(path)]


class Watched:
    """Counts what helpers begin and have planned; may do something as they begin one."""

    def __init__(self, monkeypatch, meddle=lambda process: None):
        self.begun = self.planned = 0
        self._until = time.monotonic() + 60
        original = crew._Helper._has_done

        def has_done(helper, process, number):
            self.begun += 1
            meddle(process)
            done = original(helper, process, number)
            self.planned += done
            return done

        monkeypatch.setattr(crew._Helper, "_has_done", has_done)

    def progress(self, fraction, stage):
        """Wait, as the pockets are small, for a helper to have begun one; a minute in all."""
        assert 0.0 <= fraction <= 1.0
        while "Laying" in stage and not self.begun and time.monotonic() < self._until:
            time.sleep(0.01)
        return False


def test_the_same_paths_in_the_same_order(alone, monkeypatch):
    watched = Watched(monkeypatch)
    plans = plan_together(MANY, watched.progress, helpers=2)
    assert watched.planned > 0
    assert [p.request for p in plans] == MANY
    assert [paths_of(p) for p in plans] == alone


def test_curves_come_back(monkeypatch):
    watched = Watched(monkeypatch)
    _, made = plan_together(MANY[:2], watched.progress, helpers=1)
    assert watched.planned == 1
    assert len(made.curves) == len(plan(MANY[1]).curves) > 0


def test_what_cannot_be_cut_comes_back(monkeypatch):
    watched = Watched(monkeypatch)
    _, error = plan_together([MANY[0], rectangle(5.0)], watched.progress, helpers=1)
    assert watched.planned == 1
    assert isinstance(error, SpiralPocketError) and "does not fit" in str(error)
    assert error.place is not None


def test_pocket_of_a_process_that_ends_is_planned_here(alone, monkeypatch):
    watched = Watched(monkeypatch, lambda p: (os.kill(p.pid, signal.SIGKILL), p.wait()))
    plans = plan_together(MANY, watched.progress, helpers=2)
    assert watched.planned == 0
    assert [paths_of(p) for p in plans] == alone


def test_pocket_of_a_helper_that_fails_is_planned_here(alone, monkeypatch):
    receive, heard = crew._received, []

    def only_once(process, mailbox):
        heard.append(process)
        if len(heard) > 1:
            raise MemoryError
        return receive(process, mailbox)

    monkeypatch.setattr(threading, "excepthook", lambda _: None)
    monkeypatch.setattr(crew, "_received", only_once)
    watched = Watched(monkeypatch)
    plans = plan_together(MANY, watched.progress, helpers=1)
    assert watched.begun == 1 and watched.planned == 0
    assert [paths_of(p) for p in plans] == alone


@pytest.mark.parametrize("useless", ["/bin/false", "/bin/cat", "/no/such/python"])
def test_useless_interpreter_is_left_out(useless, monkeypatch):
    monkeypatch.setattr(Interpreters, "left", [useless, sys.executable])
    watched = Watched(monkeypatch)
    plan_together(MANY, watched.progress, helpers=1)
    assert watched.planned > 0 and Interpreters.left == [sys.executable]


def test_other_libraries_are_refused(monkeypatch):
    monkeypatch.setattr(crew, "versions", lambda: ("another",))
    watched = Watched(monkeypatch)
    assert len(plan_together(MANY, helpers=1)) == len(MANY)
    assert watched.begun == 0 and not Interpreters.left


def test_stopping_ends_the_processes(monkeypatch):
    processes = []
    Watched(monkeypatch, processes.append)
    long = [rectangle(150.0, 150.0, 0.2)] * 3

    def progress(fraction, stage):
        time.sleep(0.02)
        return len(processes) == 2

    with pytest.raises(CancelledError):
        plan_together(long, progress, helpers=2)
    assert len(processes) == 2
    for process in processes:
        assert process.wait(5) is not None


def test_error_in_the_add_on_is_raised_here(monkeypatch):
    watched = Watched(monkeypatch)
    broken = [MANY[0], "no request", "no request"]
    with pytest.raises(AttributeError):
        plan_together(broken, watched.progress, helpers=1)
    assert watched.begun == 1


def test_one_pocket_needs_no_process(monkeypatch):
    monkeypatch.setattr(crew, "_Helper", None)
    assert len(plan_together(MANY[:1])) == 1


def drafted(widest=26.0):
    """Return the request for a pocket of three levels with other walls each."""
    outlines = [box(0, 0, widest - 2 * i, 20 - 2 * i) for i in range(3)]
    sections = tuple(Section(-2.0 * (i + 1), outline) for i, outline in enumerate(outlines))
    heights = Heights(8.0, 3.0, 0.0, -6.0, 2.0)
    made = request(outlines[-1], sections=sections, heights=heights)
    return replace(made, strategy=Strategy.LINEAR_MORPH)


def test_levels_of_one_pocket_come_out_as_one_by_one(monkeypatch):
    watched = Watched(monkeypatch)
    (made,) = plan_together([drafted()], watched.progress, helpers=2)
    assert watched.planned > 0
    one_by_one = plan(drafted())
    assert paths_of(made) == paths_of(one_by_one)
    assert made.report.notices == one_by_one.report.notices


def test_levels_that_cannot_be_cut_come_back(monkeypatch):
    wide, narrow = box(0, 0, 30, 20), box(0, 0, 30, 6.02)
    heights = Heights(8.0, 3.0, 0.0, -4.0, 2.0)
    made = request(narrow, sections=(Section(-2.0, wide), Section(-4.0, narrow)), heights=heights)
    made = replace(made, strategy=Strategy.CENTRAL_SPIRAL)
    watched = Watched(monkeypatch)
    (planned,) = plan_together([made], watched.progress, helpers=1)
    assert watched.planned == 1
    assert planned.toolpath.points[:, 2].min() == -2.0
    assert planned.report.notices == plan(made).report.notices != ()


def test_the_window_s_plans_have_their_levels_laid_at_once(monkeypatch):
    monkeypatch.setattr(tasks, "cores", lambda: 4)
    watched = Watched(monkeypatch)
    drawn = tasks.Tasks().plan(drafted(), watched.progress)
    assert watched.planned > 0
    assert paths_of(drawn.plan) == paths_of(plan(drafted()))


def test_stopping_ends_the_processes_of_levels(monkeypatch):
    processes = []
    Watched(monkeypatch, processes.append)
    fine = drafted(150.0)
    fine = replace(fine, cutting=Cutting(0.05))

    def progress(fraction, stage):
        time.sleep(0.02)
        return bool(processes)

    with pytest.raises(CancelledError):
        plan_together([fine], progress, helpers=1)
    (process,) = processes
    assert process.wait(5) is not None


def test_messages_come_in_pieces():
    sent = framed("ready", ("1", "2")) + framed("progress", 0.5, "Laying")
    mailbox, taken = Mailbox(), []
    for byte in sent:
        mailbox.put(bytes([byte]))
        message = mailbox.take()
        taken += [] if message is None else [message]
    assert taken == [("ready", ("1", "2")), ("progress", 0.5, "Laying")]


def test_what_is_no_message_is_refused():
    mailbox = Mailbox()
    mailbox.put(b"Segmentation fault")
    with pytest.raises(ValueError, match="no message"):
        mailbox.take()
