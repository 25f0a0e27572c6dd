# SPDX-License-Identifier: LGPL-2.1-or-later
"""Step-over in three boxes at once: percent of the cutter, length, engagement angle.

Whichever the user types into, the others follow by the cosine law. A whole
percentage is kept in `StepOver`, as FreeCAD's own operations do; anything else
exactly in `MaxEngagement`, with `StepOver` the nearest percentage. So the
engagement stays what it was when another cutter is chosen.
"""

from __future__ import annotations

import math
from typing import Any

import FreeCAD

from ...engine.stepover import engagement_angle, radial_depth
from .entries import PERCENT, Entry, Scale, lengths
from .field import expression, set_property, silent, tooltip

translate = FreeCAD.Qt.translate

#: A share of the diameter this near to a whole percentage is that percentage.
WHOLE = 1e-6
#: The largest step-over may be the least bit longer than the cutter is wide, by rounding.
ROUNDED_UP = 1 + 1e-9


class StepOverField:
    """The boxes `stepOverPercent`, `stepOver` and `maxEngagement` of the form."""

    names = ("StepOver", "MaxEngagement", "ToolController", "OpToolDiameter")

    def __init__(self, form: Any, obj: Any) -> None:
        self.obj = obj
        angles = Scale.of(obj.MaxEngagement)
        self.entries = self.percent, self.length, self.angle = [
            Entry(box, obj, self.names[:2], scale, is_exact=False, is_positive=is_positive)
            for box, scale, is_positive in (
                (form.stepOverPercent, PERCENT, False),
                (form.stepOver, lengths(), True),
                (form.maxEngagement, angles, True),
            )
        ]
        self.angle.box.setProperty("binding", f"{obj.Name}.MaxEngagement")  # for expressions
        self._tips = (
            translate("App::Property", obj.getDocumentationOfProperty("StepOver")),
            translate("SpiralPocket", "The same step-over as a length, for this cutter"),
            translate(
                "SpiralPocket",
                "The engagement angle of a straight cut at this step-over: 90° at half the "
                "cutter's diameter, 180° in a full slot",
            ),
        )
        self._tell_ruling()

    def show(self) -> None:
        """Show the step-over in all boxes, without any signal."""
        self._show(skip=None)

    def write(self) -> None:
        """Write what was entered into one of the boxes, and show it in the others."""
        if self._is_ruled():
            return
        for entry in self.entries:
            value = entry.entered()
            if value is not None:
                self._keep(min(1.0, self._share(entry, value)))
            if value is not None or entry.is_refused:
                self._show(skip=entry)

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return [signal for entry in self.entries for signal in entry.signals()]

    def _show(self, skip: Any) -> None:
        ruled, diameter, angle = self._is_ruled(), _tool_diameter(self.obj), self._engagement()
        share = radial_depth(angle, 0.5)
        if skip is not self.length:
            with silent(self.length.box):
                self.length.box.setProperty("maximum", diameter * ROUNDED_UP)
        values = (100 * share, share * diameter, math.degrees(angle))
        for entry, value in zip(self.entries, values, strict=True):
            if entry is not skip:
                entry.show(value)
        self.percent.box.setEnabled(not ruled)
        self.length.box.setEnabled(not ruled and diameter > 0)
        self.angle.box.setReadOnly(ruled)
        self._tell_ruling()

    def _is_ruled(self) -> bool:
        """Return whether an expression says what the step-over is."""
        return self._ruling() is not None

    def _ruling(self) -> str | None:
        """Return the expression that does, or None."""
        found = (expression(self.obj, name) for name in ("MaxEngagement", "StepOver"))
        return next(filter(None, found), None)

    def _tell_ruling(self) -> None:
        for entry, tip in zip(self.entries, self._tips, strict=True):
            entry.box.setToolTip(tooltip(tip, self._ruling()))

    def _engagement(self) -> float:
        """Return the engagement angle of a straight cut [rad]."""
        text = expression(self.obj, "MaxEngagement")
        angle = self.obj.evalExpression(text) if text else self.obj.MaxEngagement
        degrees = float(getattr(angle, "Value", angle))
        if degrees > 0:
            return math.radians(min(degrees, 180.0))
        return engagement_angle(self.obj.StepOver / 100, 0.5)

    def _share(self, entry: Entry, value: float) -> float:
        """Return what stands in a box as a share of the cutter's diameter."""
        if entry is self.percent:
            return value / 100
        if entry is self.length:
            return value / _tool_diameter(self.obj)
        return radial_depth(math.radians(value), 0.5)

    def _keep(self, share: float) -> None:
        percent = min(100, max(1, round(100 * share)))
        is_whole = abs(100 * share - percent) < 100 * WHOLE
        set_property(self.obj, "StepOver", percent)
        angle = 0.0 if is_whole else math.degrees(engagement_angle(share, 0.5))
        set_property(self.obj, "MaxEngagement", angle)


def _tool_diameter(obj: Any) -> float:
    """Return the diameter of the cutter that is chosen [mm]; the operation's own lags behind."""
    tool = getattr(obj.ToolController, "Tool", None)
    return float(tool.Diameter if tool else obj.OpToolDiameter)
