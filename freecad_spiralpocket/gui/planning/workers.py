# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work beside the window, one job at a time: in a process, else in a thread.

A process can be ended at any moment, in the middle of a proof too, and leaves all of
FreeCAD's own Python to the window; so Stop and a newer value work at once. It is asked to
give up first, as a new one takes a second to start, and killed if it does not. It runs the
Python interpreter that FreeCAD carries, with FreeCAD's own search path, and is used only
if it has the same libraries in the same versions: the path must not depend on where it
was planned. Where there is no such interpreter a thread does the same, stopped at the
next question for progress.
"""

from __future__ import annotations

import gc
import pickle
import queue
import sys
import threading
import traceback
from collections.abc import Callable
from typing import Any

from PySide import QtCore

from ...beside.interpreters import SCRIPT, Interpreters, versions
from ...beside.messages import Mailbox, Message
from ...beside.tasks import Tasks
from ...engine.model import Progress
from ..qt.later import later

#: Is told "progress", "done", "error", "crash" as in `beside.process`; ("gone", text) when a
#: process ended by itself, ("unusable",) when it cannot work at all.
Listener = Callable[[Message], None]

PATIENT = "--patient"
POLL_EVERY = 20  # ms, how often a thread's messages are looked for
COLLECT_EVERY = 100  # ms, how often garbage is collected while a thread works


class ProcessWorker:
    """A process that does one job after the other.

    Parameters
    ----------
    python : str
        The interpreter.
    listener : callable
        Called in the window's thread.
    is_patient : bool
        Whether it leaves the cores to others that have something to do.
    """

    def __init__(self, python: str, listener: Listener, is_patient: bool = False) -> None:
        self.python = python
        self._listener = listener
        self._is_ready = False
        self._mailbox = Mailbox()
        self._process = QtCore.QProcess()
        self._process.readyReadStandardOutput.connect(self._read)
        self._process.finished.connect(self._end)
        self._process.errorOccurred.connect(self._fail)
        self._process.start(python, ["-u", str(SCRIPT), *([PATIENT] if is_patient else [])])
        self._send([p for p in sys.path if isinstance(p, str)])

    def start(self, task: str, argument: Any) -> None:
        """Begin a job; there must be none."""
        self._send((task, argument))

    def wait(self, milliseconds: int) -> None:
        """Wait for a message without letting the window do anything else."""
        self._process.waitForReadyRead(milliseconds)

    def give_up(self) -> None:
        """Ask to give the job up; it is over with its last message all the same."""
        self._send(None)

    def stop(self) -> None:
        """End the process and whatever it does."""
        process, self._listener = self._process, lambda message: None
        process.kill()
        process.waitForFinished(100)
        # this may be called from one of its own signals, in which it must not be destroyed
        later(1000, lambda: process)

    def _send(self, record: Any) -> None:
        self._process.write(pickle.dumps(record, pickle.HIGHEST_PROTOCOL))

    def _read(self) -> None:
        self._mailbox.put(self._process.readAllStandardOutput().data())
        try:
            while (message := self._mailbox.take()) is not None:
                self._tell(message)
        except ValueError:
            self._listener(("unusable",))

    def _tell(self, message: Message) -> None:
        if message[0] == "ready":
            self._is_ready = message[1] == versions()
            message = ("unusable",)
            if self._is_ready:
                return
        self._listener(message)

    def _end(self, *_: Any) -> None:
        errors = self._process.readAllStandardError().data().decode(errors="replace")
        self._listener(("gone", errors) if self._is_ready else ("unusable",))

    def _fail(self, error: Any) -> None:
        if error == QtCore.QProcess.FailedToStart:
            self._listener(("unusable",))


class Collector:
    """Keeps Python's garbage collection in the window's thread while others work.

    Python collects garbage in whatever thread happens to allocate, and closed panels leave
    widgets and timers in it: Qt may crash when these end outside the window's thread.
    """

    def __init__(self) -> None:
        self._threads: list[threading.Thread] = []
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._collect)

    def watch(self, thread: threading.Thread) -> None:
        """Collect here until a thread is over, which is about to begin."""
        gc.disable()
        self._threads.append(thread)
        self._timer.start(COLLECT_EVERY)

    def _collect(self) -> None:
        self._threads = [t for t in self._threads if t.is_alive()]
        if self._threads:
            gc.collect(0)
        else:
            self._timer.stop()
            gc.enable()


class ThreadWorker:
    """A thread for each job, with the same face as `ProcessWorker`."""

    _collector: Collector | None = None

    def __init__(self, listener: Listener) -> None:
        self._listener = listener
        self._tasks = Tasks()
        self._stopped = threading.Event()
        self._messages: queue.Queue[Message] = queue.Queue()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._deliver)

    def start(self, task: str, argument: Any) -> None:
        """Begin a job; there must be none."""
        self._stopped.clear()
        cls = type(self)
        cls._collector = cls._collector or Collector()
        # the thread may outlive this worker, whose timer must not end in it: it has no name for it
        thread = threading.Thread(
            target=_work,
            args=(self._tasks[task], argument, self._messages, self._stopped),
            daemon=True,
        )
        cls._collector.watch(thread)
        thread.start()
        self._timer.start(POLL_EVERY)

    def wait(self, milliseconds: int) -> None:
        """Wait for a message without letting the window do anything else."""
        try:
            self._hand_on(self._messages.get(timeout=milliseconds / 1000))
        except queue.Empty:
            return
        self._deliver()

    def give_up(self) -> None:
        """Ask to give the job up; it is over with its last message all the same."""
        self._stopped.set()

    def stop(self) -> None:
        """Forget the job; its thread ends at its next question for progress."""
        self._stopped.set()
        self._timer.stop()
        self._listener = lambda message: None

    def _deliver(self) -> None:
        while not self._messages.empty():
            self._hand_on(self._messages.get())

    def _hand_on(self, message: Message) -> None:
        if message[0] != "progress":
            self._timer.stop()
        self._listener(message)


def _work(
    task: Callable[[Any, Progress], Any],
    argument: Any,
    messages: queue.Queue[Message],
    stopped: threading.Event,
) -> None:
    """Do a job in a thread of its own."""
    from ...engine.errors import SpiralPocketError

    def progress(fraction: float, stage: str) -> bool:
        messages.put(("progress", fraction, stage))
        return stopped.is_set()

    try:
        messages.put(("done", task(argument, progress)))
    except SpiralPocketError as error:
        messages.put(("error", error))
    except Exception:
        messages.put(("crash", traceback.format_exc()))


def make_worker(listener: Listener, is_patient: bool = False) -> ProcessWorker | ThreadWorker:
    """Return a worker: a process if there is an interpreter for it, else a thread."""
    python = Interpreters.best()
    if python is None:
        return ThreadWorker(listener)
    return ProcessWorker(python, listener, is_patient)
