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

from ..engine.stepover import engagement_angle, radial_depth
from .fields import expression, set_property, silent

translate = FreeCAD.Qt.translate

#: A share of the diameter this near to a whole percentage is that percentage.
WHOLE = 1e-6


class StepOverField:
    """The boxes `stepOverPercent`, `stepOver` and `maxEngagement` of the form."""

    names = ("StepOver", "MaxEngagement", "ToolController", "OpToolDiameter")

    def __init__(self, form: Any, obj: Any) -> None:
        self.obj = obj
        self.percent, self.length, self.angle = self.boxes = (
            form.stepOverPercent,
            form.stepOver,
            form.maxEngagement,
        )
        self._shown = dict.fromkeys(self.boxes, "")
        self.length.setProperty("unit", obj.OpToolDiameter.getUserPreferred()[2])
        self.angle.setProperty("unit", obj.MaxEngagement.getUserPreferred()[2])
        self.angle.setProperty("binding", f"{obj.Name}.MaxEngagement")  # for expressions
        tips = (
            translate("App::Property", obj.getDocumentationOfProperty("StepOver")),
            translate("SpiralPocket", "The same step-over as a length, for this cutter"),
            translate(
                "SpiralPocket",
                "The engagement angle of a straight cut at this step-over: 90° at half the "
                "cutter's diameter, 180° in a full slot",
            ),
        )
        for box, tip in zip(self.boxes, tips, strict=True):
            box.setToolTip(tip)

    def show(self) -> None:
        """Show the step-over in all boxes, without any signal."""
        self._show(skip=None)

    def write(self) -> None:
        """Write what was typed into one of the boxes, and show it in the others."""
        if self._is_ruled():
            return
        for typed in [box for box, text in self._shown.items() if box.text() != text]:
            share = self._share_in(typed)
            if 0 < share <= 1 + WHOLE:  # else half typed
                self._keep(min(1.0, share))
                self._shown[typed] = typed.text()
                self._show(skip=typed)
                return

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return [self.percent.valueChanged, self.length.valueChanged, self.angle.valueChanged]

    def _show(self, skip: Any) -> None:
        ruled, diameter, angle = self._is_ruled(), _tool_diameter(self.obj), self._engagement()
        share = radial_depth(angle, 0.5)
        with silent(*self._shown):
            if skip is not self.percent:
                self.percent.setValue(100 * share)
            if skip is not self.length:
                self.length.setProperty("rawValue", share * diameter)
            if skip is not self.angle:
                self.angle.setProperty("rawValue", math.degrees(angle))
        self.percent.setEnabled(not ruled)
        self.length.setEnabled(not ruled and diameter > 0)
        self.angle.setReadOnly(ruled)
        for box in self._shown:
            if box is not skip:
                self._shown[box] = box.text()

    def _is_ruled(self) -> bool:
        """Return whether an expression says what the step-over is."""
        return any(expression(self.obj, name) for name in ("StepOver", "MaxEngagement"))

    def _engagement(self) -> float:
        """Return the engagement angle of a straight cut [rad]."""
        text = expression(self.obj, "MaxEngagement")
        angle = self.obj.evalExpression(text) if text else self.obj.MaxEngagement
        degrees = float(getattr(angle, "Value", angle))
        if degrees > 0:
            return math.radians(min(degrees, 180.0))
        return engagement_angle(self.obj.StepOver / 100, 0.5)

    def _share_in(self, box: Any) -> float:
        """Return the step-over that stands in a box, as a share of the cutter's diameter."""
        if box is self.percent:
            return float(box.value()) / 100
        value = box.property("rawValue")
        if box is self.length:
            return float(value / _tool_diameter(self.obj))
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
