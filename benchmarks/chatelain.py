# SPDX-License-Identifier: LGPL-2.1-or-later
"""CS08's table 2: measured times of a square and of a circle as long, and how close we come.

Chatelain, Roy, Mayer 2008, table 2: Huron mill, Siemens 840D, dry run.
"""

from __future__ import annotations

import json
import math

from freecad_spiralpocket import machines
from freecad_spiralpocket.engine.machine import Machine
from freecad_spiralpocket.engine.motion.timing import time_of
from freecad_spiralpocket.engine.toolpath import Role, Toolpath, ToolpathBuilder

INCH = 25.4

#: Feed [inch/min], side of the square [inch], seconds for the square and for the circle.
TABLE_2 = (
    (200, 0.5, 0.82, 0.79),
    (200, 1.0, 1.44, 1.41),
    (200, 2.0, 2.62, 2.59),
    (200, 4.0, 5.04, 4.99),
    (200, 6.0, 7.44, 7.40),
    (300, 0.5, 0.75, 0.60),
    (300, 1.0, 1.16, 1.00),
    (300, 2.0, 1.96, 1.81),
    (300, 4.0, 3.55, 3.41),
    (300, 6.0, 5.15, 5.00),
    (400, 0.5, 0.74, 0.52),
    (400, 1.0, 1.08, 0.81),
    (400, 2.0, 1.63, 1.41),
    (400, 4.0, 2.88, 2.66),
    (400, 6.0, 4.04, 3.82),
)


def square(side: float, feed: float) -> Toolpath:
    """Return the contour of a square [mm], [mm/s]."""
    builder = ToolpathBuilder((0, 0, 0))
    for x, y in ((side, 0), (side, side), (0, side), (0, 0)):
        builder.line((x, y, 0), feed, Role.CUT)
    return builder.build()


def circle(radius: float, feed: float) -> Toolpath:
    """Return a full circle [mm], [mm/s]."""
    builder = ToolpathBuilder((radius, 0, 0))
    for x in (-radius, radius):
        builder.arc((x, 0, 0), (0, 0), True, feed, Role.CUT)
    return builder.build()


def residuals(machine: Machine) -> list[float]:
    """Return our time less the measured one, of the 30 times [s]."""
    found = []
    for inches_per_minute, inches, of_square, of_circle in TABLE_2:
        feed, side = inches_per_minute * INCH / 60, inches * INCH
        found.append(time_of(square(side, feed), machine).total - of_square)
        found.append(time_of(circle(2 * side / math.pi, feed), machine).total - of_circle)
    return found


def root_mean_square(values: list[float]) -> float:
    """Return the root of the mean square."""
    return math.sqrt(sum(v * v for v in values) / len(values))


def main() -> None:
    """Print the table next to ours; the last line is one JSON object."""
    found = residuals(machines.load("huron_840d"))
    print("feed, side    square: measured, ours    circle: measured, ours   [in/min, in, s]")
    for row, (of_square, of_circle) in zip(
        TABLE_2, zip(found[::2], found[1::2], strict=True), strict=True
    ):
        feed, side, square_, circle_ = row
        print(
            f"{feed:4} {side:5.1f} {square_:14.2f} {square_ + of_square:9.3f}"
            f" {circle_:15.2f} {circle_ + of_circle:9.3f}"
        )
    print(json.dumps({"cs08_rms_s": round(root_mean_square(found), 4)}))


if __name__ == "__main__":
    main()
