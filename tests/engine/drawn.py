# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths drawn by hand for tests of what is measured: a 6 mm cutter, 5 mm deep, at 10 mm/s."""

from __future__ import annotations

from freecad_spiralpocket.engine.toolpath import Role, ToolpathBuilder

R = 3.0
FLOOR = -5.0
FEED = 10.0


def started(x: float = 0.0, y: float = 0.0, z: float = FLOOR) -> ToolpathBuilder:
    """Return a builder whose cutter has been fed straight down to (x, y, z)."""
    builder = ToolpathBuilder((x, y, 5.0))
    builder.rapid(50.0, z=1.0)
    builder.line((x, y, z), FEED, Role.ENTRY)
    return builder


def lines(
    builder: ToolpathBuilder, *points: tuple, z: float = FLOOR, role: Role = Role.CUT
) -> ToolpathBuilder:
    """Add lines through points (x, y) at height z."""
    for x, y in points:
        builder.line((x, y, z), FEED, role)
    return builder
