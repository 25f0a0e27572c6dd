# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lane: jobs that wait for the next free worker, are shared, and can be taken back.

Whoever asks for the same work gets the same job, so that OK goes on with the proof
that the preview has begun. A running job that nobody holds any more is given up; a
worker that does not answer to that is ended and another one started. Workers end after
a while without work.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore

from ...beside.interpreters import Interpreters
from ...engine.errors import SpiralPocketError
from .workers import Message, ProcessWorker, make_worker

PATIENCE = 1000  # ms until a worker that should give up is ended: a new one takes as long to start
IDLE = 120_000  # ms without work after which the workers end


class Job:
    """A task that waits, runs or is done.

    Attributes
    ----------
    fraction, stage : float, str
        How far it is.
    is_done : bool
    result : object
        What came of it; None if `error` or `crash` is set.
    error : SpiralPocketError or None
    crash : str
        The traceback of an error in the add-on.
    listeners : list of callable
        Called with the job when it has gone on, and when it is done.
    """

    def __init__(self, task: str, argument: Any) -> None:
        self.task, self.argument = task, argument
        self.holders = 0
        self.fraction, self.stage = 0.0, ""
        self.is_done = False
        self.result: Any = None
        self.error: SpiralPocketError | None = None
        self.crash = ""
        self.listeners: list[Callable[[Job], None]] = []

    def tell(self) -> None:
        """Call the listeners."""
        for listener in list(self.listeners):
            listener(self)


class _Seat:
    """A worker and the job it does."""

    def __init__(self, lane: Lane) -> None:
        self._lane = lane
        self.job: Job | None = None
        self._is_giving_up = False
        self._patience = QtCore.QTimer()
        self._patience.setSingleShot(True)
        self._patience.timeout.connect(self._renew_and_go_on)
        self.worker = make_worker(self._hear, self._lane.is_patient)

    @property
    def is_free(self) -> bool:
        """Return whether it can begin a job."""
        return self.job is None and not self._is_giving_up

    def start(self, job: Job) -> None:
        """Begin a job."""
        self.job = job
        self.worker.start(job.task, job.argument)

    def give_up(self) -> None:
        """Give the job up, and be free soon."""
        self.job, self._is_giving_up = None, True
        self.worker.give_up()
        self._patience.start(PATIENCE)

    def wait(self, milliseconds: int) -> None:
        """Wait a moment for the worker; its timer does not run while the window is kept waiting."""
        self.worker.wait(milliseconds)
        if self._patience.isActive() and self._patience.remainingTime() <= 0:
            self._renew_and_go_on()

    def renew(self) -> None:
        """End the worker with what it does and make another."""
        self.job = None
        self._rest()
        self.worker.stop()
        self.worker = make_worker(self._hear, self._lane.is_patient)

    def _rest(self) -> None:
        self._is_giving_up = False
        self._patience.stop()

    def _renew_and_go_on(self) -> None:
        self.renew()
        self._lane.go_on()

    def _hear(self, message: Message) -> None:
        kind, *content = message
        job = self.job
        if kind == "unusable":
            if isinstance(self.worker, ProcessWorker):
                Interpreters.refuse(self.worker.python)
            self.renew()
            if job is not None:
                self.start(job)
        elif kind == "gone" and job is None:
            self._rest()
            self._lane.leave(self)
        elif self._is_giving_up:
            if kind != "progress":
                self._rest()
                self._lane.go_on()
        elif job is not None and kind == "progress":
            job.fraction, job.stage = content
            job.tell()
        elif job is not None:
            if kind == "gone":
                self.renew()
            self.job = None
            job.is_done, job.fraction = True, 1.0
            if kind == "done":
                (job.result,) = content
            elif kind == "error":
                (job.error,) = content
            else:
                job.crash = content[0] or "The process that planned the path ended by itself."
            job.tell()
            self._lane.go_on()


class Lane:
    """Up to `size` workers and the jobs for them; patient ones leave the cores to others."""

    def __init__(self, size: int, is_patient: bool = False) -> None:
        self._size, self.is_patient = size, is_patient
        self._waiting: list[Job] = []
        self._seats: list[_Seat] = []
        self._idle = QtCore.QTimer()
        self._idle.setSingleShot(True)
        self._idle.timeout.connect(self.close)
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.close)

    def warm_up(self) -> None:
        """Start a worker, so that the first job need not wait for it."""
        if not self._seats:
            self._seats.append(_Seat(self))
        self._idle.start(IDLE)

    def submit(self, task: str, argument: Any) -> Job:
        """Return the job for a task, which the caller holds until it is done or given up."""
        jobs = [*self._waiting, *(s.job for s in self._seats if s.job is not None)]
        same = (j for j in jobs if j.task == task and j.argument == argument)
        job = next(same, None)
        if job is None:
            job = Job(task, argument)
            self._waiting.append(job)
        job.holders += 1
        self.go_on()
        return job

    def give_up(self, job: Job) -> None:
        """Take a job back; it ends if nobody else holds it."""
        job.holders -= 1
        if job.holders > 0 or job.is_done:
            return
        if job in self._waiting:
            self._waiting.remove(job)
        for seat in self._seats:
            if seat.job is job:
                seat.give_up()
        self.go_on()

    def wait(self, milliseconds: int) -> None:
        """Wait a moment for the running jobs without letting the window do anything else."""
        for seat in [s for s in self._seats if not s.is_free]:
            seat.wait(milliseconds)

    def go_on(self) -> None:
        """Give waiting jobs to free workers."""
        while self._waiting:
            seat = next((s for s in self._seats if s.is_free), None)
            if seat is None and len(self._seats) < self._size:
                seat = _Seat(self)
                self._seats.append(seat)
            if seat is None:
                break
            seat.start(self._waiting.pop(0))
        if any(s.job for s in self._seats):
            self._idle.stop()
        else:
            self._idle.start(IDLE)

    def leave(self, seat: _Seat) -> None:
        """Forget a worker that is gone."""
        if seat in self._seats:
            self._seats.remove(seat)

    def close(self) -> None:
        """End all workers; the next job starts new ones."""
        seats, self._seats = self._seats, []
        for seat in seats:
            seat.worker.stop()
