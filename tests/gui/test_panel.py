# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each field of the page shows its property and writes it."""

import pytest
from conftest import DEPTH, add_job, floors, new_document, plate
from window import APPLY, CANCEL, panel, press, press_toolbar_button, pump, select, widget

from freecad_spiralpocket.gui.fields import Check, Choice, Number, Quantity
from freecad_spiralpocket.gui.panel import FIELDS
from freecad_spiralpocket.op.properties import option_names

#: What the user enters, and what the property is then; for fields with one value more than now.
ENTRIES = {
    "StepOver": (33, 33),
    "CutMode": ("Conventional", "Conventional"),
    "StockToLeave": (0.25, 0.25),
    "ZStockToLeave": (0.5, 0.5),
    "Machine": ("vmc", "vmc"),
    "FeedMode": ("Chip thickness", "Chip thickness"),
    "SlowdownPercent": (60, 60),
    "MaxFeedRatio": (1.5, 1.5),
    "LinkFeed": (4000.0, 4000.0),
    "SlotBite": (0.5, 0.5),
    "HelixAngle": (3.0, 3.0),
    "HelixDiameterLimit": (7.0, 7.0),
    "Tolerance": (0.02, 0.02),
    "FinishingProfile": (False, False),
    "UseOutline": (True, True),
}


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
    read = {
        Choice: lambda: box.currentData(),
        Check: lambda: box.isChecked(),
        Number: lambda: box.value(),
        Quantity: lambda: box.property("rawValue"),
    }
    return read[kind]()


def value_of(obj, name):
    value = getattr(obj, name)
    return getattr(value, "Value", value)


def test_every_option_has_a_field():
    assert sorted(name for _, name, _ in FIELDS) == sorted(option_names())


@pytest.mark.parametrize(("box", "name", "kind"), FIELDS, ids=[name for _, name, _ in FIELDS])
def test_field_shows_and_writes_its_property(operation, box, name, kind):
    box, before = widget(box), value_of(operation, name)
    assert shown(box, kind) == pytest.approx(before)
    assert box.toolTip()
    for entry, expected in (ENTRIES.get(name, (before, before)), (before, before)):
        enter(box, kind, entry)
        assert value_of(operation, name) == pytest.approx(expected)


def test_fields_of_the_other_feed_modes_are_grey(operation):
    for mode, enabled in (
        ("Chip thickness", "maxFeedRatio"),
        ("Linear slow-down", "slowdownPercent"),
    ):
        enter(widget("feedMode"), Choice, mode)
        names = ("maxFeedRatio", "slowdownPercent")
        assert [n for n in names if widget(n).isEnabled()] == [enabled]


def test_advanced_fields_unfold(operation):
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
    box = panel().form
    titles = [box.itemText(i) for i in range(box.count())]
    assert titles == ["Base Geometry", "Depths", "Heights", "Operation"]
    assert box.windowTitle() == "Spiral Pocket"


def test_tool_controller_and_coolant_are_written(operation):
    widget("coolantController").setCurrentIndex(widget("coolantController").findText("Flood"))
    pump()
    assert operation.CoolantMode == "Flood"
    assert widget("toolController").currentText() == operation.ToolController.Label


def test_result_is_shown_after_apply_and_greyed_when_out_of_date(operation):
    press(APPLY)
    text = widget("result").text()
    assert all(word in text for word in ("Time", " s,", "engagement", "mm², gouge 0.000 mm"))
    assert widget("result").isEnabled()
    widget("stepOverPercent").setValue(35)
    assert not widget("result").isEnabled()


def test_tool_can_be_changed_in_the_panel(operation):
    editor = widget("editToolController")
    if not editor.isVisible():
        pytest.skip("this FreeCAD has no tool controller editor in the panel")
    editor.setChecked(True)
    pump(0.3)
    assert panel().operation_page.tcEditor.controller.isVisible()
