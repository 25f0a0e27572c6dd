# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page "Operation" of the task panel; FreeCAD supplies the other pages.

Changing a field writes its property and computes nothing: that is for Apply
and OK. Order and wording follow FreeCAD 1.1's pages of Adaptive and Pocket.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCADGui

from ..engine.model import FeedMode
from ..op.properties import INHERITED
from .compat import PathOpGui, has_tool_controller_editor
from .extras import FACTORIES, Extra
from .fields import Check, Choice, Field, Number, Quantity
from .resulttext import result_text
from .startup import RESOURCES

FORM = RESOURCES / "panels" / "SpiralPocket.ui"

#: Widget, property and kind of field, in the order of the page.
FIELDS = (
    ("strategy", "Strategy", Choice),
    ("stepOverPercent", "StepOver", Number),
    ("cutMode", "CutMode", Choice),
    ("stockToLeave", "StockToLeave", Quantity),
    ("zStockToLeave", "ZStockToLeave", Quantity),
    ("helixAngle", "HelixAngle", Quantity),
    ("helixDiameterLimit", "HelixDiameterLimit", Quantity),
    ("machine", "Machine", Choice),
    ("feedMode", "FeedMode", Choice),
    ("tolerance", "Tolerance", Quantity),
    ("finishingProfile", "FinishingProfile", Check),
    ("useOutline", "UseOutline", Check),
    ("slowdownPercent", "SlowdownPercent", Number),
    ("maxFeedRatio", "MaxFeedRatio", Number),
    ("linkFeed", "LinkFeed", Number),
    ("slotBite", "SlotBite", Quantity),
)

#: Every property on which the path depends, of ours and of FreeCAD's own pages.
INPUTS = {name for _, name, _ in FIELDS} | {*INHERITED, "Base", "ToolController"}


class OperationPage(PathOpGui.TaskPanelPage):
    """The operation's own page; FreeCAD calls its methods."""

    fields: Sequence[Field] = ()
    extras: Sequence[Extra] = ()
    tool_editors: Sequence[Any] = ()
    is_writing = False
    was_changed = False  # while writing

    def getForm(self) -> Any:  # noqa: N802 - the name FreeCAD calls
        """Return the page's widgets."""
        form = FreeCADGui.PySideUic.loadUi(str(FORM))
        if not has_tool_controller_editor():
            form.editToolController.hide()
        form.advancedFrame.hide()
        return form

    def initPage(self, obj: Any) -> None:  # noqa: N802 - the name FreeCAD calls
        """Tie the widgets to the properties."""
        self.fields = [kind(getattr(self.form, widget), obj, name) for widget, name, kind in FIELDS]
        self.extras = [make(self) for make in FACTORIES]
        for extra in self.extras:
            widget = extra.widget()
            if widget is not None:
                self.form.extrasLayout.addWidget(widget)

    def setupToolController(self, *obj_and_combo: Any) -> None:  # noqa: N802
        """Fill the list of tool controllers; 1.1 makes an editor for the chosen one each time."""
        super().setupToolController(*obj_and_combo)
        if getattr(self, "tcEditor", None):
            self.tool_editors = [*self.tool_editors, self.tcEditor.controller]

    def getSignalsForUpdate(self, obj: Any) -> list[Any]:  # noqa: N802
        """Return the signals on which the fields are written."""
        own = [self.form.toolController, self.form.coolantController]
        signals = [box.currentIndexChanged for box in own]
        return signals + [signal for field in self.fields for signal in field.signals()]

    def getFields(self, obj: Any) -> None:  # noqa: N802 - the name FreeCAD calls
        """Write all fields to the properties."""
        self.is_writing, self.was_changed = True, False
        try:
            self.updateToolController(obj, self.form.toolController)
            self.updateCoolant(obj, self.form.coolantController)
            for field in self.fields:
                field.write()
        finally:
            self.is_writing = False
        self.enable_fields()
        self.form.result.setEnabled(False)  # out of date until the next recompute
        if self.was_changed:
            self.tell_changed()

    def setFields(self, obj: Any) -> None:  # noqa: N802 - the name FreeCAD calls
        """Show all properties."""
        self.setupToolController(obj, self.form.toolController)
        self.setupCoolant(obj, self.form.coolantController)
        self.show_outcome()

    def enable_fields(self) -> None:
        """Grey the fields that the feed mode does not use."""
        mode = self.obj.FeedMode
        self.form.slowdownPercent.setEnabled(mode == FeedMode.LINEAR_SLOWDOWN.value)
        self.form.maxFeedRatio.setEnabled(mode == FeedMode.CHIP_THICKNESS.value)

    def updateData(self, obj: Any, prop: str) -> None:  # noqa: N802 - the name FreeCAD calls
        """Show a property that was changed elsewhere, not while it is being typed here."""
        if self.is_writing:
            self.was_changed |= prop in INPUTS
            return
        for field in self.fields:
            if field.name == prop:
                field.show()
        if prop in INPUTS:
            self.tell_changed()

    def tell_changed(self) -> None:
        """Tell the extras that the path is out of date."""
        for extra in self.extras:
            extra.changed()

    def show_outcome(self) -> None:
        """Show what the last recompute brought: results, and values from expressions."""
        for field in self.fields:
            field.show()
        self.enable_fields()
        self.form.result.setText(result_text(self.obj))
        self.form.result.setEnabled(True)
        for extra in self.extras:
            extra.computed()

    def close_extras(self) -> None:
        """Close the extras; part of every way to close the panel."""
        extras, self.extras = self.extras, ()
        for extra in extras:
            extra.close()
