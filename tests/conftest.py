# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all tests share: which of them this Python can run, and where output goes.

tests/freecad needs FreeCAD, tests/gui its window; plain Python runs the others.
`./dev test` starts each folder where it belongs.
"""

import os
import sys
from pathlib import Path

import pytest

collect_ignore = [] if "FreeCAD" in sys.modules else ["freecad", "gui"]


@pytest.fixture(scope="session")
def out_dir(tmp_path_factory):
    """Return the folder for files that outlive the run: $SPIRALPOCKET_OUT, else a temporary one."""
    name = os.environ.get("SPIRALPOCKET_OUT")
    folder = Path(name) if name else tmp_path_factory.mktemp("out")
    folder.mkdir(parents=True, exist_ok=True)
    return folder
