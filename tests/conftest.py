# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all tests share: which of them this Python can run, and where output goes.

tests/freecad needs FreeCAD, tests/gui its window; plain Python runs the others.
`./dev test` starts each folder where it belongs.
"""

import os
import sys
from pathlib import Path

import pytest

if "FreeCAD" not in sys.modules:
    from hypothesis import settings

    settings.register_profile("repeatable", derandomize=True, deadline=None)
    settings.load_profile("repeatable")

collect_ignore = [] if "FreeCAD" in sys.modules else ["freecad", "gui"]


@pytest.fixture(scope="session")
def out_dir(tmp_path_factory):
    """Return the folder for files that outlive the run: $SPIRALPOCKET_OUT, else a temporary one."""
    name = os.environ.get("SPIRALPOCKET_OUT")
    folder = Path(name) if name else tmp_path_factory.mktemp("out")
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@pytest.fixture
def parameters():
    """Return FreeCAD's parameters that hold the preferences, emptied before and after."""
    import FreeCAD

    from freecad_spiralpocket.op import preferences

    group = FreeCAD.ParamGet(preferences.GROUP)
    group.Clear()
    yield group
    group.Clear()


def pytest_terminal_summary(terminalreporter):
    """Show the figures that tests recorded; write the numbers that `./dev test` adds up."""
    stats = terminalreporter.stats
    for report in stats.get("passed", []):
        for name, value in report.user_properties:
            terminalreporter.write_line(f"{report.nodeid}: {name} {value}")
    if "SPIRALPOCKET_RESULTS" in os.environ:
        groups = (("passed", "xpassed"), ("failed", "error"), ("skipped", "xfailed"))
        numbers = [sum(len(stats.get(name, [])) for name in group) for group in groups]
        Path(os.environ["SPIRALPOCKET_RESULTS"]).write_text("{} {} {}\n".format(*numbers))
