# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do inside FreeCAD what ``python ARGUMENTS...`` does outside.

FreeCAD runs this file as a script, in the console or in the window; the
arguments come in ``$SPIRALPOCKET_RUN``, each ended by the unit separator:
``-m pytest ...``, ``-c code`` or ``file ...``. Left to itself FreeCAD ends with 0 when a
script raises, and the console runs such a script twice; so this one never
raises and always leaves the process itself, with the exit code Python would
have given.
"""

import os
import runpy
import sys
import traceback
from pathlib import Path

import FreeCAD

WINDOW_DELAY = 1500  # ms from start-up to the run: the workbenches are loaded by then


def run(arguments):
    """Run the program, with `sys.argv` as it expects it.

    FreeCAD's own `__main__` stays what it is: the commands of its menus run there.
    """
    if arguments[0] == "-m":
        sys.argv = arguments[1:]
        runpy.run_module(arguments[1], run_name="__main__")
        return
    sys.argv = arguments
    if arguments[0] == "-c":
        name, source = "<command>", arguments[1]
    else:
        name = arguments[0]
        source = Path(name).read_text(encoding="utf-8")
        sys.path.insert(0, str(Path(name).parent))
    exec(compile(source, name, "exec"), {"__name__": "__main__", "__file__": name})


def exit_code(arguments):
    """Run the program and return the exit code that Python would end with."""
    try:
        run(arguments)
    except SystemExit as stop:
        if isinstance(stop.code, str):
            print(stop.code, file=sys.stderr)
        return stop.code if isinstance(stop.code, int) else int(stop.code is not None)
    except BaseException:
        traceback.print_exc()
        return 1
    return 0


def run_and_leave():
    """Run what ``$SPIRALPOCKET_RUN`` holds and end FreeCAD."""
    if "SPIRALPOCKET_STDOUT" in os.environ:  # apart from FreeCAD's banner and progress figures
        sys.stdout = os.fdopen(int(os.environ["SPIRALPOCKET_STDOUT"]), "w", buffering=1)
    elif FreeCAD.GuiUp:  # whose standard streams lead to the report view
        sys.stdout = os.fdopen(os.dup(1), "w", buffering=1)
        sys.stderr = os.fdopen(os.dup(2), "w", buffering=1)
    code = exit_code(os.environ["SPIRALPOCKET_RUN"].split("\x1f")[:-1])
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


if FreeCAD.GuiUp:
    from PySide import QtCore

    QtCore.QTimer.singleShot(WINDOW_DELAY, run_and_leave)
else:
    run_and_leave()
