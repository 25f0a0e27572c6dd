# SPDX-License-Identifier: LGPL-2.1-or-later
"""The start point in the panel: a check box, two coordinates, and a click on the part."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import FreeCADGui

from ..compat import check_box_signal
from .entries import Entry, lengths
from .field import expression, set_property, silent, tooltip

translate = FreeCAD.Qt.translate


class StartPointField:
    """The widgets `useStartPoint`, `startPointX`, `startPointY` and `pickStartPoint`."""

    names = ("UseStartPoint", "StartPoint")

    def __init__(self, form: Any, obj: Any) -> None:
        self.obj, self.check, self.button = obj, form.useStartPoint, form.pickStartPoint
        self._entries = {
            axis: Entry(box, obj, ("StartPoint",), lengths())
            for axis, box in (("x", form.startPointX), ("y", form.startPointY))
        }
        self.entries = tuple(self._entries.values())
        self._tip = translate("App::Property", obj.getDocumentationOfProperty("StartPoint"))
        self._tell_ruling()
        self.button.clicked.connect(self.take_picked)
        self.enable_button(FreeCADGui.Selection.getSelectionEx())

    def show(self) -> None:
        """Show the point, without any signal."""
        with silent(self.check):
            self.check.setChecked(self.obj.UseStartPoint)
        self.check.setEnabled(expression(self.obj, "UseStartPoint") is None)
        for axis, entry in self._entries.items():
            entry.show(getattr(self.obj.StartPoint, axis))
        self._enable()
        self._tell_ruling()

    def write(self) -> None:
        """Write the point, as far as something else was entered and no expression rules it."""
        if self.check.isEnabled():
            set_property(self.obj, "UseStartPoint", self.check.isChecked())
        for axis, entry in self._entries.items():
            value = entry.entered()
            if value is not None and not self._is_ruled(axis):
                point = FreeCAD.Vector(self.obj.StartPoint)
                setattr(point, axis, value)
                set_property(self.obj, "StartPoint", point)
        self._enable()

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        typed = [signal for entry in self.entries for signal in entry.signals()]
        return [check_box_signal(self.check), *typed]

    def enable_button(self, selection: Sequence[Any]) -> None:
        """Let the button be pressed where a place was clicked."""
        self.button.setEnabled(_picked(selection) is not None)

    def take_picked(self) -> None:
        """Take the place that was clicked on the part."""
        place = _picked(FreeCADGui.Selection.getSelectionEx())
        if place is not None:
            self.check.setChecked(True)
            for axis, entry in self._entries.items():
                entry.enter(getattr(place, axis))

    def _enable(self) -> None:
        for axis, entry in self._entries.items():
            entry.box.setEnabled(self.obj.UseStartPoint and not self._is_ruled(axis))

    def _is_ruled(self, axis: str) -> bool:
        """Return whether an expression says what a coordinate is."""
        return expression(self.obj, f"StartPoint.{axis}") is not None

    def _tell_ruling(self) -> None:
        self.check.setToolTip(tooltip(self._tip, expression(self.obj, "UseStartPoint")))
        for axis, entry in self._entries.items():
            ruling = expression(self.obj, f"StartPoint.{axis}")
            entry.box.setToolTip(tooltip(self._tip, ruling))


def _picked(selection: Sequence[Any]) -> Any:
    """Return the place that was clicked last, or None.

    FreeCAD gives the origin where none was, as for what is selected in the tree.
    """
    points = [point for part in selection for point in part.PickedPoints if point.Length > 0]
    return points[-1] if points else None
