# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads a milling program back into a `Toolpath`, to measure what was posted.

Understands what posts write for 2.5D milling: G0 to G3 in the XY plane with I and J or R,
absolute or incremental, millimeters or inches, modal words, comments. It does not know
subprograms, variables, cutter compensation and canned cycles, and says so. Ways in the
machine's own coordinates (G28, G30, G53) are left out: where they lead is not in the program.
"""

from __future__ import annotations

import math
import re

import numpy as np

from .engine.errors import RequestError
from .engine.toolpath import Kind, Role, Toolpath, ToolpathBuilder

#: Programs do not say how fast rapids are [mm/s].
RAPID = 5000 / 60
#: R may be less than half the way to the arc's end by this, from rounded words [mm].
SHORT = 0.005

_COMMENT = re.compile(r"\([^)]*\)|;.*")
_WORD = re.compile(r"([A-Z])\s*([-+]?(?:\d+\.?\d*|\.\d+))")
_SUBPROGRAMS = {("M", 97.0), ("M", 98.0)}
_MACHINE_G = {28, 30, 53}
_IGNORED_G = {4, 17, 28, 30, 40, 43, 49, 53, 54, 55, 56, 57, 58, 59, 61, 61.1, 64, 80, 94, 98, 99}


def parse_program(text: str, rapid: float = RAPID, feed: float = 0.0) -> Toolpath:
    """Return the moves of a program.

    The path begins at the end of the first motion, since nobody knows where the machine
    stood before. Moves are `Role.AIR` as rapids, `Role.ENTRY` where they sink, else
    `Role.CUT`; arcs of more than half a turn are split. Rapids get the rate `rapid` [mm/s], and
    cuts before any F word `feed`; 0 where that is an error.

    Raises
    ------
    RequestError
        If a line cannot be understood.
    """
    reader = _Reader(rapid, feed)
    for number, raw in enumerate(text.splitlines(), 1):
        line = _COMMENT.sub("", raw).upper().strip()
        if not line or line[0] in "%/":
            continue
        try:
            reader.take(_words(line))
        except _NotUnderstoodError as error:
            raise RequestError(
                f"Line {number} of the program: {error}.", f"It reads: {raw}"
            ) from None
    if reader.builder is None:
        raise RequestError("The program holds no motion.")
    return reader.builder.build()


class _NotUnderstoodError(Exception):
    """A word that the reader does not know."""


def _words(line: str) -> list[tuple[str, float]]:
    """Return the letters and numbers of a line."""
    rest = _WORD.sub("", line).strip()
    if rest:
        raise _NotUnderstoodError(f"{rest.split()[0]} is not understood")
    words = [(letter, float(value)) for letter, value in _WORD.findall(line)]
    for word in words:
        if word in _SUBPROGRAMS:
            raise _NotUnderstoodError(f"subprograms (M{word[1]:g}) are not understood")
    return words


def _no_ways(words: list[tuple[str, float]]) -> str:
    """Return which of X, Y and Z lead nowhere in this line."""
    codes = {value for letter, value in words if letter == "G"}
    if codes & _MACHINE_G:
        return "XYZ"
    # how long to dwell is P or X
    return "X" if 4 in codes and all(letter != "P" for letter, _ in words) else ""


class _Reader:
    """Modal state of the interpreter."""

    def __init__(self, rapid: float, feed: float) -> None:
        self.rapid = rapid
        self.builder: ToolpathBuilder | None = None
        self.here = np.zeros(3)
        self.motion = 0
        self.unit = 1.0
        self.incremental = False
        self.absolute_centers = False
        self.feed = feed

    def take(self, words: list[tuple[str, float]]) -> None:
        """Carry out one line."""
        values: dict[str, float] = {}
        no_ways = _no_ways(words)
        words = [(letter, value) for letter, value in words if letter not in no_ways]
        for letter, value in words:
            if letter == "G":
                self._set_mode(value)
            else:
                values[letter] = value
        if "F" in values:
            self.feed = values["F"] * self.unit / 60
        places = "XYZIJ" if self.motion >= 2 else "XYZ"
        if any(letter in values for letter in places):
            self._move(values)

    def _set_mode(self, code: float) -> None:
        """Change the modal state."""
        if code in (0, 1, 2, 3):
            self.motion = int(code)
        elif code in (20, 21):
            self.unit = 25.4 if code == 20 else 1.0
        elif code in (90, 91):
            self.incremental = code == 91
        elif code in (90.1, 91.1):
            self.absolute_centers = code == 90.1
        elif code not in _IGNORED_G:
            raise _NotUnderstoodError(f"G{code:g} is not understood")

    def _move(self, values: dict[str, float]) -> None:
        """Append the motion to the end point in `values`."""
        target = self.here.copy()
        for axis, letter in enumerate("XYZ"):
            if letter in values:
                base = self.here[axis] if self.incremental else 0.0
                target[axis] = base + values[letter] * self.unit
        if self.builder is None:
            self.builder = ToolpathBuilder(target)
        elif self.motion == 0:
            self.builder.rapid(self.rapid, *target)
        elif self.feed <= 0:
            raise _NotUnderstoodError("a feed move before any F word")
        elif self.motion == 1:
            self.builder.line(target, self.feed, self._role(target))
        else:
            self._arc(target, values)
        self.here = target

    def _role(self, target: np.ndarray) -> Role:
        """Return what a feed move to `target` seems to be for."""
        return Role.ENTRY if target[2] < self.here[2] - 1e-6 else Role.CUT

    def _arc(self, target: np.ndarray, values: dict[str, float]) -> None:
        """Append an arc as pieces of at most half a turn."""
        assert self.builder is not None
        ccw = self.motion == Kind.ARC_CCW
        center = self._center(target, values, ccw)
        a, b = self.here[:2] - center, target[:2] - center
        sweep = (math.atan2(b[1], b[0]) - math.atan2(a[1], a[0])) * (1 if ccw else -1)
        sweep %= 2 * math.pi
        if sweep < 1e-9:
            sweep = 2 * math.pi
        pieces = math.ceil(sweep / math.pi - 1e-6)
        role = self._role(target)
        for k in range(1, pieces + 1):
            angle = math.atan2(a[1], a[0]) + (1 if ccw else -1) * sweep * k / pieces
            radius = math.hypot(*a) + (math.hypot(*b) - math.hypot(*a)) * k / pieces
            z = self.here[2] + (target[2] - self.here[2]) * k / pieces
            end = (*(center + radius * np.array([math.cos(angle), math.sin(angle)])), z)
            self.builder.arc(target if k == pieces else end, center, ccw, self.feed, role)

    def _center(self, target: np.ndarray, values: dict[str, float], ccw: bool) -> np.ndarray:
        """Return the center of an arc, from I and J or from R."""
        if "R" in values:
            chord = target[:2] - self.here[:2]
            length, radius = math.hypot(*chord), values["R"] * self.unit
            if length == 0:
                raise _NotUnderstoodError("an arc with R that ends where it begins")
            if abs(radius) < length / 2 - SHORT:
                raise _NotUnderstoodError(
                    f"an arc of R{values['R']:g} does not reach its end, {length / self.unit:g} "
                    "away"
                )
            height = math.sqrt(max(0.0, radius**2 - length**2 / 4))
            side = (1 if ccw else -1) * (1 if radius > 0 else -1)
            normal = np.array([-chord[1], chord[0]]) / length
            return self.here[:2] + chord / 2 + side * height * normal
        offset = np.array([values.get("I", 0.0), values.get("J", 0.0)]) * self.unit
        return offset if self.absolute_centers else self.here[:2] + offset
