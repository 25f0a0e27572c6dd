# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start FreeCAD's window on a screen of its own and wait for the tests inside.

``python3 gui_driver.py SECONDS LOG FREECAD SCRIPT`` starts Xvfb, then FreeCAD
with SCRIPT (`run_in_freecad.py`), whose exit code it hands on. FreeCAD's user
folder, ``$FREECAD_USER_HOME``, is first preset so that no start page and no
modal message stands in the way. Everything printed goes to LOG, and its end is
shown; a FreeCAD that hangs longer than SECONDS is ended.
"""

import os
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

TAIL = 200  # lines of the log that are shown

# Run by FreeCAD as it starts, before its window looks at these settings: no start page
# (0.20's needs a browser engine that refuses root), no modal message on missing speeds.
PRESET = """\
import FreeCAD

base = "User parameter:BaseApp/Preferences/"
FreeCAD.ParamGet(base + "General").SetString("AutoloadModule", "PartWorkbench")
for name in ("CAM", "Path"):
    FreeCAD.ParamGet(base + "Mod/" + name).SetBool("WarningSuppressVelocity", True)
"""


@contextmanager
def screen():
    """Start an X server without hardware; yield the name of its display."""
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1600x1200x24", "-nolisten", "tcp"],
        pass_fds=[writing],
        stderr=subprocess.DEVNULL,
    )
    os.close(writing)
    try:
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        if not number:
            sys.exit("Xvfb does not start. Install the packages xvfb and xkb-data.")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()


def run(seconds, log, command, display):
    """Run FreeCAD; return its exit code, or None when the time was up."""
    environment = dict(
        os.environ,
        DISPLAY=display,
        LANG="C.UTF-8",
        LIBGL_ALWAYS_SOFTWARE="1",
        QT_QPA_PLATFORM="xcb",
        QTWEBENGINE_DISABLE_SANDBOX="1",
    )
    with open(log, "w", encoding="utf-8") as output:
        try:
            return subprocess.run(
                command,
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                timeout=seconds,
                check=False,
            ).returncode
        except subprocess.TimeoutExpired:
            return None


def main():
    """Run the tests and show what they printed."""
    seconds, log, *command = sys.argv[1:]
    preset = Path(os.environ["FREECAD_USER_HOME"], "Mod", "test-preset")
    preset.mkdir(parents=True, exist_ok=True)
    (preset / "Init.py").write_text(PRESET, encoding="utf-8")
    with screen() as display:
        code = run(float(seconds), log, command, display)
    lines = Path(log).read_text(encoding="utf-8", errors="replace").splitlines()
    print("\n".join(lines[-TAIL:]))
    if code is None:
        sys.exit(f"FreeCAD's window hung: ended after {seconds} s. The whole log is {log}.")
    if code < 0:
        sys.exit(f"FreeCAD's window crashed with signal {-code}. The whole log is {log}.")
    sys.exit(code)


main()
