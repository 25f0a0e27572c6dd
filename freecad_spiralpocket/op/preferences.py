# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user prefers for new operations in every job, kept in FreeCAD's own parameters.

Only what belongs to a workshop: its machine and the usual way to cut. For a new
operation the table's defaults come first, then these, then the presets of the
job's setup sheet. They hold without a window as well, as FreeCAD's own do; what a
script says itself goes before all of them.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD

GROUP = "User parameter:BaseApp/Preferences/Mod/SpiralPocket"
MACHINE_FOLDER = "MachineFolder"

#: The options that may be preferred.
NAMES = (
    "Strategy",
    "StepOver",
    "CutMode",
    "HelixAngle",
    "Machine",
    "FeedMode",
    "SlowdownPercent",
    "MaxFeedRatio",
    "LinkFeed",
    "Tolerance",
)


def read(name: str, default: Any) -> Any:
    """Return what is preferred for `name`: text, whole or other number, as `default` is."""
    group = FreeCAD.ParamGet(GROUP)
    if isinstance(default, str):
        return group.GetString(name, default)
    if isinstance(default, int):
        return group.GetInt(name, default)
    return group.GetFloat(name, default)


def write(name: str, value: Any, default: Any) -> None:
    """Keep what is preferred for `name`; a default is not kept, so that it follows releases."""
    group = FreeCAD.ParamGet(GROUP)
    kind = "String" if isinstance(default, str) else "Int" if isinstance(default, int) else "Float"
    if value == default:
        getattr(group, f"Rem{kind}")(name)
    else:
        getattr(group, f"Set{kind}")(name, value)


def machine_folder() -> Path | None:
    """Return the folder with the user's own machine files, None where there is none."""
    folder = read(MACHINE_FOLDER, "")
    return Path(folder) if folder and Path(folder).is_dir() else None
