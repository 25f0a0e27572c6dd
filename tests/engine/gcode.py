# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads G0 to G3 (mm, absolute, XY plane, I and J from the start) into a Toolpath; tests only."""

import math
import re

import numpy as np

from freecad_spiralpocket.engine.toolpath import Kind, Role, Toolpath, ToolpathBuilder

WORD = re.compile(r"([A-Z])\s*(-?\d*\.?\d+)")
RAPID = 5000.0 / 60  # mm/s


def read_program(text: str) -> Toolpath:
    """Return the motion of a program; what descends first is its entry."""
    builder, mode, feed, here = None, 0, 0.0, {}
    for line in text.splitlines():
        words = WORD.findall(re.sub(r"\(.*?\)|;.*", "", line))
        for letter, number in words:
            if letter == "G" and float(number) in (0, 1, 2, 3):
                mode = int(float(number))
        values = {letter: float(number) for letter, number in words}
        feed = values.get("F", feed * 60) / 60
        if not {"X", "Y", "Z"} & values.keys() or 43 in (values.get("G"), values.get("H")):
            continue
        start = dict(here)
        here.update({axis: values[axis] for axis in "XYZ" if axis in values})
        if builder is not None:
            _move(builder, mode, start, here, values, feed)
        elif len(here) == 3:  # no motion before the first place is known in full
            builder = ToolpathBuilder([here[axis] for axis in "XYZ"])
    assert builder is not None, "no motion"
    return builder.build()


def _move(builder, mode, start, end, values, feed):
    point = [end[axis] for axis in "XYZ"]
    if mode == Kind.RAPID:
        builder.rapid(RAPID, *point)
    elif mode == Kind.LINE:
        builder.line(point, feed, Role.CUT)
    else:
        center = np.array([start["X"] + values.get("I", 0.0), start["Y"] + values.get("J", 0.0)])
        ccw = mode == Kind.ARC_CCW
        first = math.atan2(start["Y"] - center[1], start["X"] - center[0])
        last = math.atan2(end["Y"] - center[1], end["X"] - center[0])
        sweep = (last - first) % (2 * math.pi) if ccw else -((first - last) % (2 * math.pi))
        if abs(sweep) < 1e-9:
            sweep = 2 * math.pi if ccw else -2 * math.pi
        radius = math.hypot(start["X"] - center[0], start["Y"] - center[1])
        parts = math.ceil(abs(sweep) / math.pi - 1e-9)
        for k in range(1, parts):
            turn = first + sweep * k / parts
            z = start["Z"] + (end["Z"] - start["Z"]) * k / parts
            middle = center + radius * np.array([math.cos(turn), math.sin(turn)])
            builder.arc((*middle, z), center, ccw, feed, Role.CUT)
        builder.arc(point, center, ccw, feed, Role.CUT)
