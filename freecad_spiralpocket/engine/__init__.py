# SPDX-License-Identifier: LGPL-2.1-or-later
"""The engine: from a pocket's outline to a proved toolpath.

Pure functions over numpy arrays and shapely polygons: no FreeCAD, no Qt, no
files, no state but caches. ``plan(request)`` is the whole of it; the records are in
`model`, the errors in `errors`. Names are loaded on first use, so that
`errors` and `model` can be imported where scipy or shapely is missing, and
FreeCAD's start is not slowed down.

Its packages import from those before them only: `numerics`, `shapes`, `motion`, `contact`,
`proof`, `growth`, `opening`, `links`, `heat`, `middle_line`, `laps`.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

_HOMES = {"plan": "planner", "PocketRequest": "model", "Plan": "model", "Report": "model"}

__all__ = ["Plan", "PocketRequest", "Report", "plan"]


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(f".{_HOMES[name]}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
