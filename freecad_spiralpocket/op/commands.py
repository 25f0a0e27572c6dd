# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the engine's toolpath to FreeCAD's commands.

Only G0, G1, G2 and G3 with every coordinate written out, arcs by their center and
never more than half a turn: all that FreeCAD's display, dressups, simulators and
posts understand alike. Coordinates are rounded; a move that goes nowhere once a
post has rounded it to three decimals is left out, since controllers take an arc
that ends where it begins for a full circle.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import Path

from ..engine.toolpath import Kind, Toolpath

#: Decimals of coordinates in mm: ten times finer than posts write, FreeCAD saves six.
DECIMALS = 4
#: Decimals that posts write by default.
POST_DECIMALS = 3

_NAMES = {Kind.RAPID: "G0", Kind.LINE: "G1", Kind.ARC_CW: "G2", Kind.ARC_CCW: "G3"}


def comment(text: str) -> Any:
    """Return a comment; parentheses and what a controller might choke on are replaced."""
    plain = text.replace("(", "[").replace(")", "]").replace(";", ",")
    words = " ".join(plain.encode("ascii", "replace").decode().split())
    return Path.Command(f"({words})")


def from_toolpath(toolpath: Toolpath, *, with_feeds: bool = True) -> list[Any]:
    """Return the commands for `toolpath`, from a lift to where it starts to its end.

    Parameters
    ----------
    toolpath : Toolpath
    with_feeds : bool
        Write F words [mm/s] on cutting moves; without them the machine stops and asks.
    """
    x, y, z = (_rounded(v) for v in toolpath.start)
    commands = [Path.Command("G0", {"Z": z}), Path.Command("G0", {"X": x, "Y": y, "Z": z})]
    here = (x, y, z)
    rows = zip(toolpath.kinds, toolpath.points, toolpath.centers, toolpath.feeds, strict=True)
    for kind, point, center, feed in rows:
        there = tuple(_rounded(v) for v in point)
        if _as_posted(there) == _as_posted(here):
            continue
        words = dict(zip("XYZ", there, strict=True))
        if kind >= Kind.ARC_CW and _as_posted(there[:2]) == _as_posted(here[:2]):
            kind = Kind.LINE  # nothing of the arc is left but its height
        if kind >= Kind.ARC_CW:
            words["I"] = _rounded(center[0] - here[0])
            words["J"] = _rounded(center[1] - here[1])
        if with_feeds and kind != Kind.RAPID:
            words["F"] = float(feed)
        commands.append(Path.Command(_NAMES[Kind(kind)], words))
        here = there
    return commands


def join(parts: Iterable[list[Any]]) -> list[Any]:
    """Return the commands of several pockets as one list without repeated rapids."""
    result: list[Any] = []
    for part in parts:
        for command in part:
            if not (result and _is_same_rapid(result, command)):
                result.append(command)
    return result


def without_last_lift(commands: list[Any]) -> list[Any]:
    """Return `commands` without the rapids straight up at the end, which FreeCAD adds itself."""
    end = len(commands)
    while end > 1 and _only_rises(commands[end - 2], commands[end - 1]):
        end -= 1
    return commands[:end]


def _rounded(value: float) -> float:
    """Return `value` rounded, never as the negative zero that posts print as -0.000."""
    return round(float(value), DECIMALS) + 0.0


def _as_posted(point: tuple[float, ...]) -> tuple[float, ...]:
    return tuple(np.round(point, POST_DECIMALS))


def _is_same_rapid(commands: list[Any], command: Any) -> bool:
    """Return whether the rapid `command` goes where the last of `commands` already is."""
    last = commands[-1].Parameters
    words = command.Parameters
    return command.Name == "G0" and all(last.get(k) == v for k, v in words.items())


def _only_rises(before: Any, last: Any) -> bool:
    a, b = before.Parameters, last.Parameters
    return last.Name == "G0" and all(a.get(k) == b.get(k) for k in "XY")
