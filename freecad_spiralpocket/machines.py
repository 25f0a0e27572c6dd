# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine presets: data files that describe a machine tool, ours and the user's own.

A preset is a JSON file; its name without the ending is what the operation's `Machine`
property holds. Units stand in the keys. The engine knows only the `Machine` that comes out.
See resources/machines/vmc.json for an example and docs/machine-time.md for each key.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from .engine.errors import RequestError
from .engine.machine import CornerRule, Machine

#: Where the presets of the add-on are.
FOLDER = Path(__file__).resolve().parent.parent / "resources" / "machines"

_VALUE_KEYS = {
    CornerRule.BLENDING: "tolerance_mm",
    CornerRule.JUNCTION_DEVIATION: "deviation_mm",
    CornerRule.CORNER_SPEED: "speed_mm_per_s",
}
_OPTIONAL = {
    "path_speed_mm_per_min": ("path_speed", 1 / 60),
    "path_acceleration_mm_per_s2": ("path_acceleration", 1.0),
    "normal_acceleration_mm_per_s2": ("normal_acceleration", 1.0),
    "start_overhead_s": ("start_overhead", 1.0),
    "blocks_per_s": ("block_rate", 1.0),
}


def names(folder: str | Path | None = None) -> list[str]:
    """Return the names of all presets, those of `folder`, the user's own, first."""
    found: list[str] = []
    for place in _places(folder):
        found += sorted(f.stem for f in place.glob("*.json") if f.stem not in found)
    return found


def load(name: str, folder: str | Path | None = None) -> Machine:
    """Read the preset `name`; one in `folder` goes before ours of the same name.

    Raises
    ------
    RequestError
        If there is none, or if its file is broken; the hint names what to do.
    """
    for place in _places(folder):
        path = place / f"{name}.json"
        if path.is_file():
            return read(path)
    known = ", ".join(names(folder))
    raise RequestError(f"There is no machine '{name}'.", f"Choose one of: {known}.")


def read(path: str | Path) -> Machine:
    """Read the preset file at `path`.

    Raises
    ------
    RequestError
        If it is no preset.
    """
    path = Path(path)
    try:
        return _machine(json.loads(path.read_text(encoding="utf-8")), path.stem)
    except OSError as error:
        raise RequestError(
            f"The machine file {path.name} cannot be read: {error.strerror}."
        ) from error
    except KeyError as error:
        raise RequestError(
            f"The machine file {path.name} lacks {error}.", "Add it; vmc.json shows how."
        ) from error
    except (ValueError, TypeError, AttributeError) as error:
        raise RequestError(
            f"The machine file {path.name} is broken: {error}.", "Compare it with vmc.json."
        ) from error


def _places(folder: str | Path | None) -> list[Path]:
    """Return the folders to look in, the user's first."""
    return [FOLDER] if folder is None else [Path(folder), FOLDER]


def _machine(data: dict[str, Any], stem: str) -> Machine:
    """Return the machine that `data` describes."""
    corner = data["corner"]
    rule = CornerRule(corner["rule"])
    optional: dict[str, Any] = {
        field: float(data[key]) * unit
        for key, (field, unit) in _OPTIONAL.items()
        if data.get(key) is not None
    }
    if data.get("jerk_mm_per_s3") is not None:
        optional["jerk"] = _axes(data["jerk_mm_per_s3"])
    if data.get("look_ahead_blocks") is not None:
        optional["look_ahead"] = int(data["look_ahead_blocks"])
    return Machine(
        name=data.get("name", stem),
        speed=_axes(data["speed_mm_per_min"], 1 / 60),
        acceleration=_axes(data["acceleration_mm_per_s2"]),
        corner_rule=rule,
        corner_value=float(corner[_VALUE_KEYS[rule]]),
        **optional,
    )


def _axes(values: list[float], unit: float = 1.0) -> tuple[float, float, float]:
    """Return the three numbers of x, y and z."""
    x, y, z = (float(v) * unit for v in values)
    return x, y, z
