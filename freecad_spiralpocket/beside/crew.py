# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets, or the levels of one pocket, planned at once: here and in processes beside FreeCAD.

This process never waits for another to start: it plans one after the other, and whoever
else is ready takes the next one. So a few small pockets are done before a process is
there, many take a share of the time, and where there is no interpreter for one nothing is
lost. A process that ends too early or fails puts its job back, and it is done here.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from shapely import Polygon

from ..engine import plan
from ..engine.errors import CancelledError, SpiralPocketError, report_progress
from ..engine.floor import FloorPath
from ..engine.floor_paths import floor_path
from ..engine.model import Plan, PocketRequest, Progress, Tick
from .interpreters import SCRIPT, Interpreters, cores, versions
from .messages import Mailbox, Message
from .progress import stage_among

#: Processes beside this one: a core each, but some memory too.
HELPERS = min(7, cores() - 1)
PIECE = 1 << 16  # bytes read at once
WAIT = 0.05  # s, how often this process asks whether to stop while it waits for others


def plan_together(
    requests: Sequence[PocketRequest], progress: Progress | None = None, helpers: int = HELPERS
) -> list[Plan | SpiralPocketError]:
    """Return a plan for each request, or what is the matter with it; the same as one by one.

    Of a single pocket the levels are laid at once, where their walls differ.

    Parameters
    ----------
    requests : sequence of PocketRequest
    progress : callable, optional
    helpers : int
        Processes to start at most.

    Raises
    ------
    CancelledError
        If `progress` says so; the processes are ended.
    """
    if len(requests) == 1:
        return [_planned(requests[0], progress, helpers)]
    work = _Work([("packed_plan", request) for request in requests])

    def here(number: int) -> Plan | SpiralPocketError:
        return _planned(requests[number], work.progress_of(number, progress), 0)

    return work.outcome(here, lambda: report_progress(progress, *work.how_far("")), helpers)


def lay_together(
    asked: Sequence[tuple[Polygon, PocketRequest]], tick: Tick, helpers: int = HELPERS
) -> list[FloorPath | SpiralPocketError]:
    """Return the path of each region or what is the matter with it; a `FloorPaths`.

    Parameters
    ----------
    asked : sequence of tuple
        Each region and its request.
    tick : callable
    helpers : int
        Processes to start at most.

    Raises
    ------
    CancelledError
        If `tick` does; the processes are ended.
    """
    work = _Work([("packed_floor_path", each) for each in asked])

    def here(number: int) -> FloorPath | SpiralPocketError:
        def tick_one(done: float) -> None:
            work.advance(number, done)
            tick(work.share)

        return floor_path(*asked[number], tick_one)

    return work.outcome(here, lambda: tick(work.share), helpers)


def _planned(
    request: PocketRequest, progress: Progress | None, helpers: int
) -> Plan | SpiralPocketError:
    """Return a pocket's plan, or what is the matter with it."""
    try:
        return plan(request, progress, partial(lay_together, helpers=helpers))
    except CancelledError:
        raise
    except SpiralPocketError as error:
        return error


class _Work:
    """The jobs: which wait, which are being done, and what has come of them.

    Parameters
    ----------
    jobs : sequence of tuple
        The task that a process is asked for, and its argument.
    """

    def __init__(self, jobs: Sequence[tuple[str, Any]]) -> None:
        self.jobs = jobs
        self._outcomes: list[Any] = [None] * len(jobs)
        self._waiting = list(range(len(jobs)))
        self._fractions = [0.0] * len(jobs)
        self._changed = threading.Condition()

    def outcome(
        self, here: Callable[[int], Any], ask: Callable[[], None], helpers: int
    ) -> list[Any]:
        """Return what comes of all jobs.

        Parameters
        ----------
        here : callable
            Does a job in this process, by its number.
        ask : callable
            Called now and then while this process waits for others; raises if all is to stop.
        helpers : int
            Processes to start at most.
        """
        count = min(helpers, len(self.jobs) - 1)
        # asked here: two threads that import the same library at once may find it half there
        alike = versions() if count > 0 else ()
        crew = [_Helper(self, alike) for _ in range(count)]
        try:
            for helper in crew:
                helper.start()
            while not self._is_done:
                number = self.take()
                if number is None:
                    self._wait(WAIT)
                    ask()
                else:
                    self.finish(number, here(number))
        finally:
            for helper in crew:
                helper.stop()
        return [pickle.loads(o) if isinstance(o, bytes) else o for o in self._outcomes]

    @property
    def _is_done(self) -> bool:
        """Return whether all have come to something."""
        with self._changed:
            return all(outcome is not None for outcome in self._outcomes)

    def take(self) -> int | None:
        """Return the next one that nobody does, None if there is none."""
        with self._changed:
            return self._waiting.pop(0) if self._waiting else None

    def put_back(self, number: int) -> None:
        """Let somebody else do one."""
        with self._changed:
            self._waiting.insert(0, number)
            self._fractions[number] = 0.0
            self._changed.notify_all()

    def finish(self, number: int, outcome: Any) -> None:
        """Note what has come of one, perhaps pickled."""
        with self._changed:
            self._outcomes[number] = outcome
            self._fractions[number] = 1.0
            self._changed.notify_all()

    def advance(self, number: int, fraction: float) -> None:
        """Note how far one is."""
        self._fractions[number] = fraction

    def _wait(self, seconds: float) -> None:
        """Wait until one is done or put back, at most so long."""
        with self._changed:
            if not self._waiting and any(outcome is None for outcome in self._outcomes):
                self._changed.wait(seconds)

    @property
    def share(self) -> float:
        """Return the share of all that is done."""
        return sum(self._fractions) / len(self.jobs)

    def how_far(self, stage: str) -> tuple[float, str]:
        """Return the share of all that is done, and the stage with the number of the pocket."""
        done = sum(outcome is not None for outcome in self._outcomes)
        return self.share, stage_among(done, len(self.jobs), stage)

    def progress_of(self, number: int, progress: Progress | None) -> Progress | None:
        """Return the progress of one of them as a part of the whole."""
        if progress is None:
            return None

        def tell(fraction: float, stage: str) -> bool:
            self.advance(number, fraction)
            return progress(*self.how_far(stage))

        return tell


class _Helper(threading.Thread):
    """A process that does what waits, one job after the other, and the thread that leads it."""

    def __init__(self, work: _Work, versions: tuple[str, ...]) -> None:
        super().__init__(daemon=True)
        self._work, self._versions = work, versions
        self._process: subprocess.Popen[bytes] | None = None
        self._mailbox = Mailbox()
        self._is_stopped = False

    def run(self) -> None:
        """Lead a process of the first interpreter that is of use, until nothing waits."""
        while not self._is_stopped:
            python = Interpreters.best()
            if python is None or self._has_led(python):
                return
            if not self._is_stopped:
                Interpreters.refuse(python)

    def stop(self) -> None:
        """End the process and whatever it does."""
        self._is_stopped = True
        if self._process is not None:
            self._process.kill()

    def _has_led(self, python: str) -> bool:
        """Let a process work until nothing waits; return whether the interpreter is of use."""
        try:
            process = subprocess.Popen(
                [python, "-u", str(SCRIPT)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            )
        except OSError:
            return False
        self._process, self._mailbox = process, Mailbox()
        try:
            if self._is_stopped or not self._is_ready(process):
                return False
            while (number := self._work.take()) is not None and self._has_done(process, number):
                continue
            return True
        finally:
            process.kill()
            process.communicate()

    def _is_ready(self, process: subprocess.Popen[bytes]) -> bool:
        """Return whether a process works at all, and as this one does."""
        _send(process, [p for p in sys.path if isinstance(p, str)])
        return _received(process, self._mailbox) == ("ready", self._versions)

    def _has_done(self, process: subprocess.Popen[bytes], number: int) -> bool:
        """Have a job done; return whether that went well, else it is put back."""
        outcome = None
        try:
            _send(process, self._work.jobs[number])
            outcome = self._outcome(process, number)
        finally:
            if outcome is None:
                self._work.put_back(number)
        if outcome is not None:
            self._work.finish(number, outcome)
        return outcome is not None

    def _outcome(
        self, process: subprocess.Popen[bytes], number: int
    ) -> bytes | SpiralPocketError | None:
        """Wait for the outcome; None if the process is gone or has come upon an error in itself."""
        while (message := _received(process, self._mailbox)) is not None:
            kind, *content = message
            if kind == "progress":
                self._work.advance(number, content[0])
            else:
                return content[0] if kind in ("done", "error") else None
        return None


def _send(process: subprocess.Popen[bytes], record: Any) -> None:
    """Write a record; a process that is gone is found out when it does not answer."""
    assert process.stdin is not None
    with contextlib.suppress(OSError):
        process.stdin.write(pickle.dumps(record, pickle.HIGHEST_PROTOCOL))
        process.stdin.flush()


def _received(process: subprocess.Popen[bytes], mailbox: Mailbox) -> Message | None:
    """Wait for the next message; None if the process is gone, or what it sends is none of ours."""
    assert process.stdout is not None
    with contextlib.suppress(ValueError):
        while (message := mailbox.take()) is None:
            piece = os.read(process.stdout.fileno(), PIECE)
            if not piece:
                return None
            mailbox.put(piece)
        return message
    return None
