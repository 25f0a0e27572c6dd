# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each field of the page shows its property and writes it."""

import math

import FreeCADGui
import pytest
from conftest import DEPTH, add_job, floors, new_document, plate
from PySide import QtGui
from window import (
    APPLY,
    CANCEL,
    main_window,
    panel,
    press,
    press_toolbar_button,
    pump,
    select,
    settle,
    widget,
)

from freecad_spiralpocket.engine.model import Strategy
from freecad_spiralpocket.gui.fields.field import Check, Choice, LinkFeed, Number, Quantity
from freecad_spiralpocket.gui.panel.operation_page import FIELDS
from freecad_spiralpocket.gui.texts.choices import STRATEGY_NOTES
from freecad_spiralpocket.op.properties import option_names

#: What the user enters into each simple field, and what the property is then if not the same.
ENTRIES = {
    "Strategy": "Linear Morph",
    "CutMode": "Conventional",
    "StockToLeave": 0.25,
    "ZStockToLeave": 0.5,
    "HelixAngle": 3.0,
    "HelixDiameterLimit": 7.0,
    "Machine": "vmc",
    "FeedMode": "Chip thickness",
    "SlowdownPercent": 60,
    "MaxFeedRatio": 1.5,
    "FinishingProfile": False,
    "UseOutline": True,
    "Tolerance": 0.02,
    "LinkFeed": 50.0,
    "SlotBite": 0.5,
    "ExtendOpenSides": False,
    "UseRestMachining": True,
}
#: The boxes round to hundredths of a millimeter; as a share of the cutter's diameter.
ROUNDED = 0.005 / 6.0 * 1.01
LINK_FEED = 3000.0  # mm/min: 50 mm/s


@pytest.fixture(scope="module")
def operation():
    """Return a new operation whose panel is open for all tests here; closed with Cancel."""
    with new_document() as document:
        job = add_job(document, plate(), diameter=6.0)
        part = document.getObject("Part")
        select((part, floors(part, -DEPTH)[0]))
        press_toolbar_button()
        yield job.Operations.Group[0]
        press(CANCEL)


def enter(box, kind, value):
    """Enter a value as the widget itself would on a user's action."""
    if kind is Choice:
        box.setCurrentIndex(box.findData(value))
    elif kind is Check:
        box.setChecked(value)
    elif kind is Number:
        box.setValue(value)
    else:
        box.setProperty("rawValue", value)
    pump()


def shown(box, kind):
    """Return the value that the widget shows."""
    if kind is Choice:
        return box.currentData()
    if kind is Check:
        return box.isChecked()
    return box.value() if kind is Number else box.property("rawValue")


def value_of(obj, name):
    value = getattr(obj, name)
    return getattr(value, "Value", value)


def test_every_option_has_a_field(operation):
    names = [name for field in panel().operation_page.fields for name in field.names]
    assert set(option_names()) == set(names) & set(option_names())
    assert len(names) == len(set(names))


@pytest.mark.parametrize(("box", "name", "kind"), FIELDS, ids=[name for _, name, _ in FIELDS])
def test_field_shows_and_writes_its_property(operation, box, name, kind):
    box, before, entry = widget(box), value_of(operation, name), ENTRIES[name]
    first = shown(box, kind)
    assert box.toolTip()
    enter(box, kind, entry)
    expected = LINK_FEED if name == "LinkFeed" else entry
    assert value_of(operation, name) == pytest.approx(expected) != before
    enter(box, kind, first)
    assert value_of(operation, name) == pytest.approx(before)


#: What is typed into which box of the step-over, and StepOver and MaxEngagement after it.
STEP_OVERS = [
    ("stepOverPercent", "value", 25.0, 25, 0.0),
    ("stepOverPercent", "value", 33.3, 33, 70.49),
    ("stepOver", "rawValue", 3.0, 50, 0.0),
    ("stepOver", "rawValue", 1.0, 17, 48.19),
    ("maxEngagement", "rawValue", 60.0, 25, 0.0),
    ("maxEngagement", "rawValue", 80.0, 41, 80.0),
]


@pytest.mark.parametrize(("box", "way", "value", "percent", "angle"), STEP_OVERS)
def test_step_over_is_typed_in_any_of_three_boxes(operation, box, way, value, percent, angle):
    before = operation.StepOver
    widget(box).setProperty(way, value)
    pump()
    assert operation.StepOver == percent
    assert operation.MaxEngagement.Value == pytest.approx(angle, abs=0.005)
    share = widget("stepOver").property("rawValue") / operation.OpToolDiameter.Value
    assert widget("stepOverPercent").value() == pytest.approx(100 * share, abs=0.051)
    cosine = math.cos(math.radians(widget("maxEngagement").property("rawValue")))
    assert (1 - cosine) / 2 == pytest.approx(share, abs=ROUNDED)
    widget("stepOverPercent").setValue(before)
    pump()
    assert (operation.StepOver, operation.MaxEngagement.Value) == (before, 0)


def test_everything_that_can_be_entered_has_a_tooltip(operation):
    page = panel().operation_page
    for box in (page.form, page.preview.box, page.result_box.box):
        for kind in (QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QAbstractButton, QtGui.QSlider):
            for each in box.findChildren(kind):
                if each.isVisible():
                    assert each.toolTip(), (each.objectName(), kind)
    for name in ("toolController", "strategy", "stepOver", "machine", "linkFeed", "startPointX"):
        assert widget(f"{name}Label").toolTip() == widget(name).toolTip()


def test_a_step_over_of_nothing_is_not_taken(operation):
    widget("stepOver").setProperty("rawValue", 0.0)
    pump()
    assert operation.StepOver == 40 and operation.MaxEngagement == 0
    widget("stepOver").editingFinished.emit()
    assert widget("stepOver").property("rawValue") == pytest.approx(2.4)


def test_step_over_follows_the_cutter(operation):
    tool = operation.ToolController.Tool
    widget("maxEngagement").setProperty("rawValue", 75.0)
    pump()
    before, tool.Diameter = tool.Diameter, 10.0
    operation.OpToolDiameter = 10.0
    assert widget("maxEngagement").property("rawValue") == pytest.approx(75.0)
    assert widget("stepOver").property("rawValue") == pytest.approx(3.706, abs=5e-3)
    tool.Diameter = before
    operation.OpToolDiameter = before
    widget("stepOverPercent").setValue(40)


def test_expression_rules_the_step_over(operation):
    operation.setExpression("MaxEngagement", "30 deg * 2")
    pump()
    assert widget("stepOverPercent").value() == 25
    assert not widget("stepOverPercent").isEnabled()
    assert widget("maxEngagement").isReadOnly()
    text = dict(operation.ExpressionEngine)["MaxEngagement"]  # 0.20 leaves spaces out
    for box in ("stepOverPercent", "stepOver", "maxEngagement"):
        assert widget(box).toolTip().endswith(f"\nSet by the expression {text}")
    operation.setExpression("MaxEngagement", None)
    pump()
    assert widget("stepOverPercent").isEnabled()
    assert "expression" not in widget("stepOverPercent").toolTip()
    operation.MaxEngagement = 0


@pytest.mark.parametrize(
    ("box", "kind", "name", "text", "value"),
    [
        ("strategy", Choice, "Strategy", "2", "Extended Archimedean"),
        ("useOutline", Check, "UseOutline", "1", True),
        ("slowdownPercent", Number, "SlowdownPercent", "60", 60),
        ("linkFeed", LinkFeed, "LinkFeed", "600", 10.0),
        ("useStartPoint", Check, "UseStartPoint", "1", True),
        ("startPointX", Quantity, "StartPoint.x", "9", 9.0),
    ],
)
def test_what_an_expression_rules_cannot_be_entered(operation, box, kind, name, text, value):
    operation.FeedMode, operation.UseStartPoint = "Linear slow-down", True
    whole = name.partition(".")[0]
    before = getattr(operation, whole)
    assert widget(box).isEnabled()
    operation.setExpression(name, text)
    assert not widget(box).isEnabled()
    operation.recompute()
    assert shown(widget(box), kind) == pytest.approx(value)
    assert f"expression {text}" in widget(box).toolTip()
    operation.setExpression(name, None)
    assert widget(box).isEnabled()
    setattr(operation, whole, before)
    operation.FeedMode, operation.UseStartPoint = "Constant", False


def test_start_point_is_written(operation):
    widget("useStartPoint").setChecked(True)
    widget("startPointX").setProperty("rawValue", 12.5)
    widget("startPointY").setProperty("rawValue", 8.0)
    pump()
    assert operation.UseStartPoint and tuple(operation.StartPoint) == (12.5, 8.0, 0)
    widget("useStartPoint").setChecked(False)
    pump()
    assert not operation.UseStartPoint and not widget("startPointX").isEnabled()


def test_start_point_is_taken_from_a_click(operation):
    FreeCADGui.Selection.clearSelection()
    pump()
    assert not widget("pickStartPoint").isEnabled()
    model, (face,) = operation.Base[0]
    FreeCADGui.Selection.addSelection(model, face)  # without a click on it
    pump()
    assert not widget("pickStartPoint").isEnabled()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(model, face, 20.0, 15.0, -DEPTH)
    pump()
    widget("pickStartPoint").click()
    pump()
    assert operation.UseStartPoint and tuple(operation.StartPoint)[:2] == (20.0, 15.0)
    operation.UseStartPoint = False
    FreeCADGui.Selection.clearSelection()


def test_every_strategy_says_what_it_is_for(operation):
    for strategy in Strategy:
        enter(widget("strategy"), Choice, strategy.value)
        assert widget("strategyNote").text() == STRATEGY_NOTES[strategy.value]
        closes = strategy not in (Strategy.AUTOMATIC, Strategy.EXTENDED_ARCHIMEDEAN)
        assert widget("finishingProfile").isEnabled() == closes
    enter(widget("strategy"), Choice, Strategy.AUTOMATIC.value)


def test_fields_of_the_other_feed_modes_are_grey(operation):
    for mode, enabled in (
        ("Chip thickness", "maxFeedRatio"),
        ("Linear slow-down", "slowdownPercent"),
    ):
        enter(widget("feedMode"), Choice, mode)
        names = ("maxFeedRatio", "slowdownPercent")
        assert [n for n in names if widget(n).isEnabled()] == [enabled]
        assert [n for n in names if widget(n).isVisible()] == [enabled]
    enter(widget("feedMode"), Choice, "Constant")


def test_advanced_fields_unfold(operation):
    widget("advanced").setChecked(False)
    pump()
    assert not widget("slotBite").isVisible()
    widget("advanced").setChecked(True)
    pump()
    assert widget("slotBite").isVisible()


def test_field_shows_what_was_changed_elsewhere(operation):
    operation.StepOver = 31
    operation.StockToLeave = 0.4
    assert widget("stepOverPercent").value() == 31
    assert widget("stockToLeave").property("rawValue") == pytest.approx(0.4)


def test_expression_is_evaluated_and_kept(operation):
    operation.setExpression("StockToLeave", "0.1 mm * 3")
    press(APPLY)
    assert widget("stockToLeave").property("rawValue") == pytest.approx(0.3)
    assert operation.StockToLeave.Value == pytest.approx(0.3)
    assert "StockToLeave" in dict(operation.ExpressionEngine)
    operation.setExpression("StockToLeave", None)


def test_freecads_own_pages_keep_their_titles(operation):
    box, *_ = panel().form
    titles = [box.itemText(i) for i in range(box.count())]
    assert titles == ["Base Geometry", "Depths", "Heights", "Operation"]
    assert box.windowTitle() == "Spiral Pocket"


def test_boxes_are_no_wider_than_the_page(operation):
    settle()
    widest = panel().operation_page.form.minimumSizeHint().width()
    assert all(box.minimumSizeHint().width() <= widest for box in panel().form[1:])


def test_dock_is_as_wide_as_the_panel(operation):
    (area,) = (
        a
        for dock in main_window().findChildren(QtGui.QDockWidget)
        for a in dock.findChildren(QtGui.QScrollArea)
        if a.isAncestorOf(panel().operation_page.form) and a.widget().isAncestorOf(panel().form[0])
    )
    assert area.widget().width() <= area.viewport().width()


def test_tool_controller_and_coolant_are_written(operation):
    widget("coolantController").setCurrentIndex(widget("coolantController").findText("Flood"))
    pump()
    assert operation.CoolantMode == "Flood"
    assert widget("toolController").currentText() == operation.ToolController.Label


def test_tool_can_be_changed_in_the_panel(operation):
    editor = widget("editToolController")
    if not editor.isVisible():
        pytest.skip("this FreeCAD has no tool controller editor in the panel")
    editor.setChecked(True)
    pump(0.3)
    assert panel().operation_page.tcEditor.controller.isVisible()
