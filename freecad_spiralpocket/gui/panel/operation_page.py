# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page "Operation" of the task panel; FreeCAD supplies the other pages.

Changing a field writes its property and computes nothing: that is for Apply
and OK. Order and wording follow FreeCAD 1.1's pages of Adaptive and Pocket.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
from PySide import QtCore, QtGui

from ...engine.model import FeedMode, Strategy
from ...op.compat import parent_job, supplied_tool_controller
from ...op.properties import INHERITED, TABLE, option_names
from ..compat import (
    PathOpGui,
    PathUtils,
    fill_tool_controllers,
    has_tool_controller_editor,
    tool_controller_editor,
)
from ..fields.field import Between, Check, Choice, Field, LinkFeed, Number, Quantity, silent
from ..fields.rounded import write_no_rounded_feeds
from ..fields.start_point import StartPointField
from ..fields.step_over import StepOverField
from ..qt.later import later
from ..qt.names import load_form, rightly_named
from ..resources import RESOURCES
from ..texts.choices import strategy_note
from .base_page import BaseGeometryPage
from .extras import FACTORIES, Extra

translate = FreeCAD.Qt.translate

FORM = RESOURCES / "panels" / "SpiralPocket.ui"

#: Widget, property and kind of field, in the order of the page.
FIELDS = (
    ("strategy", "Strategy", Choice),
    ("cutMode", "CutMode", Choice),
    ("stockToLeave", "StockToLeave", Quantity),
    ("zStockToLeave", "ZStockToLeave", Quantity),
    ("helixAngle", "HelixAngle", Between),
    ("helixDiameterLimit", "HelixDiameterLimit", Quantity),
    ("machine", "Machine", Choice),
    ("feedMode", "FeedMode", Choice),
    ("slowdownPercent", "SlowdownPercent", Number),
    ("maxFeedRatio", "MaxFeedRatio", Number),
    ("finishingProfile", "FinishingProfile", Check),
    ("useOutline", "UseOutline", Check),
    ("tolerance", "Tolerance", Quantity),
    ("linkFeed", "LinkFeed", LinkFeed),
    ("slotBite", "SlotBite", Quantity),
    ("extendOpenSides", "ExtendOpenSides", Check),
    ("useRestMachining", "UseRestMachining", Check),
)
#: What is folded away; the panel unfolds it where one of these is not the default.
ADVANCED = (
    "Tolerance",
    "LinkFeed",
    "SlotBite",
    "ExtendOpenSides",
    "UseRestMachining",
    "UseStartPoint",
)

#: Every property on which the path depends, of ours and of FreeCAD's own pages.
INPUTS = {*option_names(), *INHERITED, "Base", "ToolController", "OpToolDiameter"}


#: What of a tool controller and of its tool path, time, forces and remarks depend on; versions of
#: FreeCAD and kinds of tools lack some.
OF_CONTROLLER = (
    *("Label", "ToolNumber", "HorizFeed", "VertFeed", "HorizRapid", "VertRapid"),
    *("SpindleSpeed", "SpindleDir"),
)
OF_TOOL = (
    *("Label", "Diameter", "CuttingEdgeHeight", "Flutes", "ShapeType", "ShapeName", "ToolType"),
    "SpindleDirection",
)


#: Least width of a box to type into, in the font's height; a row that is wider is wrapped.
SPIN_BOX = 7.0


class OperationPage(PathOpGui.TaskPanelPage):
    """The operation's own page; FreeCAD calls its methods."""

    fields: Sequence[Field] = ()
    extras: Sequence[Extra] = ()
    boxes: Sequence[Any] = ()  # of the extras, to be shown below the pages
    is_writing = False
    was_written = was_changed = False  # while writing: any property, one the path depends on
    is_closed = False
    refusals: Sequence[str] = ()  # what to say of what was typed in vain
    tool: tuple[str, ...] = ()  # as it was last looked at

    def getForm(self) -> Any:  # noqa: N802 - the name FreeCAD calls
        """Return the page's widgets."""
        form = load_form(FORM)
        if not has_tool_controller_editor():
            form.editToolController.hide()
        form.advancedFrame.hide()
        for box in form.findChildren(QtGui.QAbstractSpinBox):
            box.setMinimumWidth(int(SPIN_BOX * box.fontMetrics().height()))
        let_long_choices_wrap(form)
        return form

    def taskPanelBaseGeometryPage(self, obj: Any, features: int) -> Any:  # noqa: N802
        """Return the page of the selected faces."""
        return BaseGeometryPage(obj, features)

    def initPage(self, obj: Any) -> None:  # noqa: N802 - the name FreeCAD calls
        """Tie the widgets to the properties."""
        self.start_point = StartPointField(self.form, obj)
        self.step_over = StepOverField(self.form, obj)
        self.fields = [
            self.step_over,
            *(kind(getattr(self.form, widget), obj, name) for widget, name, kind in FIELDS),
            self.start_point,
        ]
        for label in self.form.findChildren(QtGui.QLabel):
            if label.buddy() is not None:
                label.setToolTip(label.buddy().toolTip())
        self.form.advanced.setChecked(is_advanced(obj))
        self.tool = tool_of(obj)
        self.extras = [make(self) for make in FACTORIES]
        self.boxes = [box for box in [extra.widget() for extra in self.extras] if box is not None]

    def setupToolController(self, *obj_and_combo: Any) -> None:  # noqa: N802
        """Fill the list of tool controllers; 1.1 makes an editor for the chosen one each time.

        Where the operation's own was deleted the first is chosen: 1.1 fails where the user, asked
        for one, chooses none. Where its tool cannot clear a pocket it is not in the list.
        """
        first = next(iter(PathUtils.getToolControllers(self.obj)), None)
        with rightly_named(), supplied_tool_controller(first):
            super().setupToolController(*obj_and_combo)
        if editor := tool_controller_editor(self):
            write_no_rounded_feeds(editor)
        combo, controller = self.form.toolController, self.obj.ToolController
        if controller is None or combo.currentText() != controller.Label:
            with silent(combo):
                combo.setCurrentIndex(-1)

    def resetToolController(self, job: Any, tc: Any) -> None:  # noqa: N802
        """Take a tool controller that was just added, if that was to the operation's own job."""
        if job == parent_job(self.obj):
            super().resetToolController(job, tc)

    def updateToolController(self, obj: Any, combo: Any) -> None:  # noqa: N802
        """Write the chosen tool controller; none is chosen after it was deleted."""
        if combo.currentIndex() >= 0:
            super().updateToolController(obj, combo)

    def tcComboChanged(self, newIndex: int) -> None:  # noqa: N802, N803
        """Take the chosen tool controller, or a copy or a new one (1.1).

        None is chosen after it was deleted, and there is nothing to copy.
        """
        combo = self.form.toolController
        others = [tc.Label for tc in PathUtils.getToolControllers(self.obj)]
        is_copy = newIndex < combo.count() - 1 and combo.itemText(newIndex) not in others
        if newIndex >= 0 and not (is_copy and self.obj.ToolController is None):
            super().tcComboChanged(newIndex)

    def getSignalsForUpdate(self, obj: Any) -> list[Any]:  # noqa: N802
        """Return the signals on which the fields are written."""
        own = [self.form.toolController, self.form.coolantController]
        signals = [box.currentIndexChanged for box in own]
        return signals + [signal for field in self.fields for signal in field.signals()]

    def registerSignalHandlers(self, obj: Any) -> None:  # noqa: N802
        """Let what was typed be looked at when a box is left."""
        for field in self.fields:
            for entry in field.entries:
                entry.box.editingFinished.connect(self.tidy)

    def tidy(self) -> None:
        """Show what stays of what was typed; the operation may be gone, and the box be left."""
        if self.is_closed:
            return
        left = [f for f in self.fields if any(e.is_typing or e.is_refused for e in f.entries)]
        refused = [(e.box, *e.refusal()) for f in left for e in f.entries if e.is_refused]
        for field in left:
            field.show()
        if left:
            self.refusals = [self._refusal(*each) for each in refused]
            self.outlook.tell()

    def _refusal(self, box: Any, typed: str, advice: str) -> str:
        """Return what to say of what was typed in vain, now that the box shows what stays."""
        label = getattr(self.form, f"{box.objectName()}Label").text()
        said = translate("SpiralPocket", '{}: "{}" is not taken, {} stays.')
        return f"{said.format(label, typed, box.text())} {advice}"

    def pageGetFields(self) -> None:  # noqa: N802 - the name FreeCAD calls
        """Write all fields, unless the panel closes and a box loses its focus by that.

        There is something to apply only if that changed something: boxes tell of changes also
        where they but round what they show.
        """
        if self.is_closed:
            return
        self.getFields(self.obj)
        if self.was_written:
            self.setDirty()

    def getFields(self, obj: Any) -> None:  # noqa: N802 - the name FreeCAD calls
        """Write all fields to the properties."""
        self.is_writing, self.was_written, self.was_changed = True, False, False
        try:
            self.updateToolController(obj, self.form.toolController)
            self.updateCoolant(obj, self.form.coolantController)
            for field in self.fields:
                field.write()
        finally:
            self.is_writing = False
        self.enable_fields()
        if self.was_changed:
            self.tell_changed()

    def setFields(self, obj: Any) -> None:  # noqa: N802 - the name FreeCAD calls
        """Show all properties."""
        self.setupToolController(obj, self.form.toolController)
        self.setupCoolant(obj, self.form.coolantController)
        self.show_outcome()

    def enable_fields(self) -> None:
        """Show what the strategy is for, and only the fields that it and the feed mode use."""
        form, strategy, mode = self.form, self.obj.Strategy, self.obj.FeedMode
        form.strategyNote.setText(strategy_note(strategy))
        form.strategyNote.setVisible(bool(form.strategyNote.text()))
        ruled = {path for path, _ in self.obj.ExpressionEngine}
        is_used = Strategy(strategy).has_closing_lap
        form.finishingProfile.setEnabled(is_used and "FinishingProfile" not in ruled)
        slowed = FeedMode.LINEAR_SLOWDOWN
        for name, box, label, its_mode in (
            ("SlowdownPercent", form.slowdownPercent, form.slowdownPercentLabel, slowed),
            ("MaxFeedRatio", form.maxFeedRatio, form.maxFeedRatioLabel, FeedMode.CHIP_THICKNESS),
        ):
            is_used = mode == its_mode.value
            box.setEnabled(is_used and name not in ruled)
            box.setVisible(is_used)
            label.setVisible(is_used)

    def updateData(self, obj: Any, prop: str) -> None:  # noqa: N802 - the name FreeCAD calls
        """Show a property that was changed elsewhere, not while it is being typed here."""
        if self.is_writing:
            self.was_written = True
            self.was_changed |= prop in INPUTS
            return
        for field in self.fields:
            if prop in field.names or prop == "ExpressionEngine":
                field.show()
                self.enable_fields()
        if prop in INPUTS or prop == "ExpressionEngine":
            self.tell_changed()

    def update_tool(self, changed: Any) -> None:
        """Follow a change of the tool controller or of its tool, in its editor or elsewhere."""
        controller = self.obj.ToolController
        if changed not in (controller, getattr(controller, "Tool", None)):
            return
        tool = tool_of(self.obj)
        if tool != self.tool:  # the editor writes everything with every key stroke
            self.tool = tool
            if not self.is_writing:
                self.step_over.show()
                later(0, self.show_tool_controller)  # the editor may be writing
            self.tell_changed()

    def show_tool_controller(self) -> None:
        """Show a label, feeds and speed that were changed elsewhere, lest they are written back."""
        if self.is_closed or self.obj.ToolController is None:
            return
        fill_tool_controllers(self)
        if editor := tool_controller_editor(self):
            editor.updateUi()

    def drop_tool_controller(self, controller: Any) -> None:
        """Take one that is deleted off the list; if it was chosen, none is."""
        combo, blocker = self.form.toolController, QtCore.QSignalBlocker(self.form.toolController)
        is_chosen = controller == self.obj.ToolController
        combo.removeItem(combo.findText(controller.Label))
        if is_chosen:
            combo.setCurrentIndex(-1)
            if editor := tool_controller_editor(self):
                editor.controller.hide()
                editor.updateToolController = lambda: None  # there is nothing to write to
        blocker.unblock()

    def look_again(self) -> None:
        """Look whether a recompute has changed part, stock or earlier operations."""
        for extra in self.extras:
            extra.changed()

    def updateSelection(self, obj: Any, sel: Any) -> None:  # noqa: N802
        """Let the start point be taken from what was clicked."""
        self.start_point.enable_button(sel)

    def tell_changed(self) -> None:
        """Tell the extras that the path is out of date."""
        self.refusals = ()
        for extra in self.extras:
            extra.changed()

    def show_outcome(self) -> None:
        """Show what the last recompute brought: results, and values from expressions."""
        for field in self.fields:
            field.show()
        self.enable_fields()
        for extra in self.extras:
            extra.computed()

    def close(self) -> None:
        """Close the extras; part of every way to close the panel."""
        self.is_closed = True
        extras, self.extras = self.extras, ()
        for extra in extras:
            extra.close()


def let_long_choices_wrap(form: Any) -> None:
    """Let the rows of lists be wrapped before a list is narrower than its longest choice.

    Qt wraps a row by the width of its own label, and puts the list beside the widest one.
    """
    labels = [each for each in form.findChildren(QtGui.QLabel) if each.buddy() is not None]
    for own in labels:
        if isinstance(own.buddy(), QtGui.QComboBox):
            beside = [each for each in labels if each.parent() is own.parent()]
            own.setMinimumWidth(max(each.sizeHint().width() for each in beside))


def tool_of(obj: Any) -> tuple[str, ...]:
    """Return all of the operation's tool that the path depends on."""
    controller = obj.ToolController
    tool = getattr(controller, "Tool", None)
    return tuple(
        str(getattr(holder, name, None))
        for holder, names in ((controller, OF_CONTROLLER), (tool, OF_TOOL))
        for name in names
    )


def is_advanced(obj: Any) -> bool:
    """Return whether an option that is folded away is not as it is by default."""
    defaults = {p.name: p.default for p in TABLE}
    values = {name: getattr(obj, name) for name in ADVANCED}
    return any(getattr(v, "Value", v) != defaults[name] for name, v in values.items())
