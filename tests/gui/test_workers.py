# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work beside the window goes on when an interpreter is of no use or a process dies."""

import gc
import threading

import pytest
from PySide import QtCore
from window import pump, wait_for

from freecad_spiralpocket.beside import interpreters
from freecad_spiralpocket.beside.interpreters import Interpreters
from freecad_spiralpocket.beside.tasks import Drawn
from freecad_spiralpocket.engine.errors import SpiralPocketError
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, PocketRequest
from freecad_spiralpocket.gui.planning import workers
from freecad_spiralpocket.gui.planning.lane import Lane
from freecad_spiralpocket.gui.planning.workers import ProcessWorker, ThreadWorker


def square(side=30.0, stepover=2.4):
    """Return the request for a square pocket."""
    from shapely import box

    return PocketRequest(
        pocket=box(0, 0, side, side),
        tool_diameter=6.0,
        heights=Heights(8.0, 3.0, 0.0, -5.0, 6.0),
        feeds=Feeds(50.0, 12.5, 83.0, 83.0),
        cutting=Cutting(stepover=stepover),
    )


@pytest.fixture
def lane():
    """Return a lane with one worker."""
    made = Lane(1)
    yield made
    made.close()


def done(job):
    """Wait for a job."""
    wait_for(lambda: job.is_done, 60)
    return job


def worker(lane):
    """Return the lane's worker."""
    return lane._seats[0].worker


def test_process_plans(lane):
    job = done(lane.submit("plan", square()))
    assert isinstance(job.result, Drawn)
    assert isinstance(worker(lane), ProcessWorker)


def test_what_cannot_be_cut_comes_back_as_an_error(lane):
    job = done(lane.submit("plan", square(side=5.0)))
    assert isinstance(job.error, SpiralPocketError) and "does not fit" in str(job.error)
    assert job.error.place is not None


@pytest.mark.parametrize("useless", ["/bin/false", "/bin/cat", "/no/such/python"])
def test_useless_interpreter_is_left_out(lane, monkeypatch, useless):
    good = interpreters.likely()
    monkeypatch.setattr(Interpreters, "left", [useless, *good])
    job = lane.submit("draft", square())
    assert done(job).result is not None
    assert useless not in Interpreters.left


def test_other_libraries_are_refused(lane, monkeypatch):
    monkeypatch.setattr(workers, "versions", lambda: ("another",))
    monkeypatch.setattr(Interpreters, "left", interpreters.likely()[:1])
    assert done(lane.submit("draft", square())).result is not None
    assert isinstance(worker(lane), ThreadWorker)


def test_dead_process_is_told_and_replaced(lane):
    done(lane.submit("draft", square()))
    job = lane.submit("plan", square(side=150.0, stepover=0.2))
    pump(0.2)
    worker(lane)._process.kill()
    assert done(job).crash
    assert done(lane.submit("draft", square())).result is not None


def test_error_in_the_add_on_is_told(lane):
    job = done(lane.submit("plan", "no request"))
    assert "Traceback" in job.crash


def test_same_work_is_one_job_and_lives_as_long_as_someone_holds_it(lane):
    long = square(side=150.0, stepover=0.2)
    one, other = lane.submit("plan", long), lane.submit("plan", long)
    assert one is other
    lane.give_up(one)
    assert lane._seats[0].job is one
    lane.give_up(other)
    assert lane._seats[0].job is None
    assert done(lane.submit("draft", square())).result is not None


def test_thread_gives_up_and_does_the_next(lane, monkeypatch):
    monkeypatch.setattr(Interpreters, "left", [])
    lane.give_up(lane.submit("plan", square(side=150.0, stepover=0.2)))
    assert done(lane.submit("draft", square())).result is not None


def test_garbage_ends_in_the_windows_thread_while_a_thread_works(lane, monkeypatch):
    monkeypatch.setattr(Interpreters, "left", [])
    ends = []

    class Timer(QtCore.QTimer):
        def __del__(self):
            ends.append(threading.current_thread())

    job = lane.submit("plan", square(stepover=0.6))
    made = 0
    while not job.is_done:
        timer = Timer()
        timer.itself = timer  # a cycle, which only the garbage collection ends
        made += 1
        pump(0.001)
    wait_for(gc.isenabled)
    del timer
    gc.collect()
    assert len(ends) == made > 20
    assert set(ends) == {threading.main_thread()}


def test_lane_that_is_closed_while_a_thread_works_ends_its_timers_here(monkeypatch):
    monkeypatch.setattr(Interpreters, "left", [])
    made = Lane(1)
    made.submit("plan", square(stepover=0.3))
    pump(0.2)
    ends = []
    worker(made)._timer.destroyed.connect(lambda *_: ends.append(threading.current_thread()))
    made.close()
    del made
    wait_for(gc.isenabled, 60)
    gc.collect()
    pump()
    assert ends == [threading.main_thread()]
