# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process beside FreeCAD in which pockets are planned; run as a script, not imported.

Standard input brings pickled records one after the other: first FreeCAD's `sys.path`,
then ``(task, argument)`` pairs. Standard output takes messages, each a length of eight
bytes and a pickle: ``("ready", versions)`` at the start, then for each task
``("progress", fraction, stage)`` any number of times and at last ``("done", result)``,
``("error", error)`` with what the machinist is told, or ``("crash", traceback)``. It ends
with its input; to stop it, kill it.
"""

import os
import pickle
import struct
import sys
import time
import traceback

UPDATE_EVERY = 0.05  # s, at most this often progress is told


def main():
    """Do tasks until there are no more."""
    inbox = sys.stdin.buffer
    outbox = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever a library prints goes to stderr

    def send(*message):
        data = pickle.dumps(message, pickle.HIGHEST_PROTOCOL)
        outbox.write(struct.pack("<Q", len(data)) + data)
        outbox.flush()

    sys.path[:] = pickle.load(inbox)
    from freecad_spiralpocket.engine.errors import SpiralPocketError
    from freecad_spiralpocket.gui.tasks import Tasks, versions

    tasks = Tasks()
    send("ready", versions())
    told = 0.0

    def progress(fraction, stage):
        nonlocal told
        if time.monotonic() - told > UPDATE_EVERY:
            send("progress", fraction, stage)
            told = time.monotonic()
        return False

    while True:
        name, argument = pickle.load(inbox)
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
