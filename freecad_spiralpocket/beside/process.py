# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process beside FreeCAD in which pockets are planned; run as a script, not imported.

Standard input brings pickled records one after the other: first FreeCAD's `sys.path`,
then ``(task, argument)`` pairs, each after the last one's end; None in between gives the
running task up. Standard output takes messages (messages.py): ``("ready", versions)`` at
the start, then for each task ``("progress", fraction, stage)`` any number of times and at
last ``("done", result)``, ``("error", error)`` with what the machinist is told, or
``("crash", traceback)``. It ends with its input; to stop it at once, kill it.
"""

import os
import pickle
import queue
import sys
import threading
import time
import traceback

PATIENCE = 5  # lower priority by so much, where the system knows that
UPDATE_EVERY = 0.05  # s, at most this often progress within a stage is told


def receive(inbox):
    """Put all records into a queue; end the process with its input."""
    try:
        while True:
            inbox.put(pickle.load(sys.stdin.buffer))
    except EOFError:
        os._exit(0)


def main():
    """Do tasks until there are no more."""
    if sys.argv[1:] == ["--patient"] and hasattr(os, "nice"):
        os.nice(PATIENCE)
    outbox = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever a library prints goes to stderr
    sys.path[:] = pickle.load(sys.stdin.buffer)
    from freecad_spiralpocket.beside.interpreters import versions
    from freecad_spiralpocket.beside.messages import framed
    from freecad_spiralpocket.beside.tasks import Tasks
    from freecad_spiralpocket.engine.errors import SpiralPocketError

    def send(*message):
        outbox.write(framed(*message))
        outbox.flush()

    tasks = Tasks()
    send("ready", versions())
    # only now: reading a task imports what is in it, and two threads that import the same
    # library at once find it half there
    inbox = queue.Queue()
    threading.Thread(target=receive, args=(inbox,), daemon=True).start()
    told, last = 0.0, ""

    def progress(fraction, stage):
        nonlocal told, last
        if stage != last or time.monotonic() - told > UPDATE_EVERY:
            send("progress", fraction, stage)
            told, last = time.monotonic(), stage
        return not inbox.empty()

    while True:
        record = inbox.get()
        if record is None:
            continue  # it came after the task's end
        name, argument = record
        try:
            send("done", tasks[name](argument, progress))
        except SpiralPocketError as error:
            send("error", error)
        except Exception:
            send("crash", traceback.format_exc())


try:
    main()
except (EOFError, BrokenPipeError, KeyboardInterrupt):
    os._exit(0)
