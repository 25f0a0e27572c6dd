# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of an operation in a few lines, as they stand in the panel."""

from __future__ import annotations

import math
from html import escape
from typing import Any

import FreeCAD

from ..op.request import engagement_limit

translate = FreeCAD.Qt.translate


def result_text(obj: Any) -> str:
    """Return time, length, engagement, uncut area, gouge and notices as rich text.

    Without a path it is the reason, or what to do.
    """
    if obj.PathLength.Value <= 0:
        reasons = obj.Notices or [translate("SpiralPocket", "Apply computes the path.")]
        return "<br>".join(map(escape, reasons))
    lines = [
        translate("SpiralPocket", "Time {}, cutting length {}").format(
            duration(obj.MachiningTime), obj.PathLength.UserString
        ),
        translate("SpiralPocket", "Largest engagement {:.0f}°, {:.0f}° on a straight cut").format(
            obj.LargestEngagement.Value, math.degrees(engagement_limit(obj))
        ),
        translate("SpiralPocket", "Uncut {}, gouge {}").format(
            small(obj.UncutArea, power=2), small(obj.Gouge.Value)
        ),
    ]
    lines += [f"⚠ {notice}" for notice in obj.Notices]
    return "<br>".join(map(escape, lines))


def small(value: float, power: int = 1) -> str:
    """Return a length [mm] or, with power 2, an area in the unit the user has for a part's size.

    FreeCAD's own text would turn a gouge of nothing but rounding into nanometers.
    """
    _, factor, unit = FreeCAD.Units.Quantity(10.0, FreeCAD.Units.Length).getUserPreferred()
    digits = 3 if factor < 20 else 4
    unit = "in" if unit == '"' else unit
    return f"{value / factor**power:.{digits}f} {unit}{'²' if power == 2 else ''}"


def duration(seconds: float) -> str:
    """Return e.g. ``1 h 02 min``, ``3 min 05 s``, ``12 s``; unknown for 0."""
    whole = round(seconds)
    if not seconds:
        return translate("SpiralPocket", "unknown")
    if whole >= 3600:
        return f"{whole // 3600} h {whole // 60 % 60:02d} min"
    if whole >= 60:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole} s"
