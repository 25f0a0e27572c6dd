# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the engine's toolpath to FreeCAD's commands.

Only G0, G1, G2 and G3 with every coordinate written out, arcs by their center and
never more than half a turn: all that FreeCAD's display, dressups, simulators and
posts understand alike. Coordinates are rounded; a move that goes nowhere once a
post has rounded it to three decimals is left out. Controllers take an arc that ends
where it begins, as rounded by whatever post, for a full circle: short arcs are lines.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
import Path

from ..engine.toolpath import Kind, Toolpath

#: Decimals of coordinates in mm: dressups join the path to one wire, for which a helical arc must
#: end within 1e-7 mm of where the next move begins. Posts round for themselves.
DECIMALS = 9
#: What is less below zero is zero: posts print up to four decimals of it [mm].
ZERO = 5e-5
#: Decimals that posts write by default.
POST_DECIMALS = 3
#: The ends of an arc farther apart than the first stay apart in four decimals of an inch; farther
#: than the second in three. Short of that it is a line if it is as flat as this [mm].
SHORT, SHORTISH, FLAT = 0.004, 0.04, 0.001
#: FreeCAD's dressups take an arc for half a turn where the area that its two radii span is less
#: than this [mm2]; those that turn less than the second [rad] are written as lines, each of which
#: turns by no more than the third, and is no farther off than the last [mm].
SPANNED, HALF, TURN, OFF = 0.006, 3.0, 0.26, 0.0003

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
    here = [_rounded(c) for c in toolpath.start.tolist()]
    points = [[_rounded(c) for c in point] for point in toolpath.points.tolist()]
    posted, seen = (np.round(p, POST_DECIMALS).tolist() for p in (points, here))
    commands = [
        Path.Command("G0", {"Z": here[2]}),
        Path.Command("G0", dict(zip("XYZ", here, strict=True))),
    ]
    moves = zip(
        toolpath.kinds.tolist(), toolpath.centers.tolist(), toolpath.feeds.tolist(), strict=True
    )
    for (kind, center, feed), there, target in zip(moves, points, posted, strict=True):
        if target == seen:
            continue
        ends, words = [there], {"F": feed} if with_feeds and kind != Kind.RAPID else {}
        if kind >= Kind.ARC_CW and _is_line(here, there, center):
            kind = Kind.LINE
        elif kind >= Kind.ARC_CW and _is_misread(here, there, center):
            kind, ends = Kind.LINE, _chords(here, there, center)
        if kind >= Kind.ARC_CW:
            words["I"], words["J"] = (_rounded(c - h) for c, h in zip(center, here, strict=False))
        for end in ends:
            place = dict(zip("XYZ", end, strict=True))
            commands.append(Path.Command(_NAMES[kind], place | words))
        here, seen = there, target
    return commands


def _is_line(begin: Sequence[float], end: Sequence[float], center: Sequence[float]) -> bool:
    """Return whether an arc of at most half a turn is better written as a line."""
    chord, radius = math.dist(begin[:2], end[:2]), math.dist(end[:2], center)
    if chord < SHORT:
        return True
    height = radius - math.sqrt(max(0.0, radius**2 - chord**2 / 4))
    return chord < SHORTISH and height < FLAT


def _is_misread(begin: Sequence[float], end: Sequence[float], center: Sequence[float]) -> bool:
    """Return whether FreeCAD takes an arc of less than half a turn for one, twice as long."""
    (ax, ay), (bx, by) = ((p[0] - center[0], p[1] - center[1]) for p in (begin, end))
    return abs(ax * by - ay * bx) < SPANNED and abs(_turn(begin, end, center)) < HALF


def _turn(begin: Sequence[float], end: Sequence[float], center: Sequence[float]) -> float:
    """Return by how much an arc of at most half a turn turns, counter-clockwise [rad]."""
    first, last = (math.atan2(p[1] - center[1], p[0] - center[0]) for p in (begin, end))
    return math.remainder(last - first, math.tau)


def _chords(
    begin: Sequence[float], end: Sequence[float], center: Sequence[float]
) -> list[list[float]]:
    """Return where lines along an arc end."""
    turn = _turn(begin, end, center)
    count = math.ceil(abs(turn) / min(TURN, math.sqrt(8 * OFF / math.dist(begin[:2], center))))
    x, y = (b - c for b, c in zip(begin, center, strict=False))
    ends = []
    for i in range(1, count):
        share = i / count
        cos, sin = math.cos(share * turn), math.sin(share * turn)
        z = begin[2] + share * (end[2] - begin[2])
        place = center[0] + x * cos - y * sin, center[1] + x * sin + y * cos, z
        ends.append([_rounded(value) for value in place])
    return [*ends, list(end)]


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
    """Return `value` rounded, zero where it is less only by rounding: posts print that as -0.000.

    One by one: numpy takes as long for one number as a command.
    """
    rounded = round(value, DECIMALS)
    return 0.0 if -ZERO < rounded <= 0 else rounded


def _is_same_rapid(commands: list[Any], command: Any) -> bool:
    """Return whether the rapid `command` goes where the last of `commands` already is."""
    if command.Name != "G0":
        return False
    last = commands[-1].Parameters
    return all(last.get(k) == v for k, v in command.Parameters.items())


def _only_rises(before: Any, last: Any) -> bool:
    a, b = before.Parameters, last.Parameters
    return last.Name == "G0" and all(a.get(k) == b.get(k) for k in "XY")
