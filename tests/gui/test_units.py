# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel speaks the user's unit, and is used from the keyboard."""

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from window import (
    APPLY,
    CANCEL,
    OK,
    answered,
    edit,
    enter,
    is_panel_open,
    panel,
    panel_button,
    press,
    press_toolbar_button,
    pump,
    select,
    set_units,
    settle,
    type_into,
    widget,
)

from freecad_spiralpocket.gui.compat import has_tool_controller_editor
from freecad_spiralpocket.gui.texts.localized import in_panel

INCHES = 3  # FreeCAD's number for inches with decimals
METERS, CENTIMETERS, INCH_FRACTIONS, FEET = 1, 4, 5, 7

#: The fields in the order in which the Tab key reaches them.
TAB_ORDER = [
    "toolController",
    "coolantController",
    "editToolController",
    "strategy",
    "stepOverPercent",
    "stepOver",
    "maxEngagement",
    "cutMode",
    "stockToLeave",
    "zStockToLeave",
    "helixAngle",
    "helixDiameterLimit",
    "machine",
    "feedMode",
    "slowdownPercent",
    "maxFeedRatio",
    "finishingProfile",
    "useOutline",
    "advanced",
    "tolerance",
    "linkFeed",
    "slotBite",
    "extendOpenSides",
    "useRestMachining",
    "useStartPoint",
    "startPointX",
    "startPointY",
    "pickStartPoint",
]


@pytest.fixture
def inches(job):
    """Let the user work in inches."""
    set_units(job.Document, INCHES)
    yield
    FreeCAD.Units.setSchema(0)


@pytest.fixture(params=[METERS, INCHES, CENTIMETERS, INCH_FRACTIONS, FEET])
def units(request, job):
    """Let the user work in units of which FreeCAD's two decimals are coarse."""
    set_units(job.Document, request.param)
    yield
    FreeCAD.Units.setSchema(0)


@pytest.fixture
def operation(job, floor):
    """Return a new operation whose panel is open; closed with Cancel."""
    select(floor)
    press_toolbar_button()
    yield job.Operations.Group[0]
    if is_panel_open():
        press(CANCEL)


def text(box):
    """Return what a box shows, as number and unit."""
    return box.text().replace('"', " in").split()


def test_length_is_shown_in_the_users_unit(inches, operation):
    box = widget("helixDiameterLimit")
    box.setProperty("rawValue", 25.4)
    pump()
    assert text(box) == ["1.00", "in"]
    assert operation.HelixDiameterLimit.Value == pytest.approx(25.4)


def test_what_the_boxes_round_away_is_not_written(inches, operation):
    assert text(widget("stepOver"))[0] == "0.09449"
    operation.StockToLeave = 0.1234
    widget("helixAngle").setProperty("rawValue", 4.0)
    pump()
    assert operation.HelixAngle.Value == 4
    assert operation.Tolerance.Value == pytest.approx(0.01)
    assert operation.StockToLeave.Value == pytest.approx(0.1234)
    assert (operation.StepOver, operation.MaxEngagement.Value) == (40, 0)


def shown_texts():
    """Return what all boxes show by their names."""
    entries = [e for field in panel().operation_page.fields for e in field.entries]
    return {e.box.objectName(): e.box.text() for e in entries}


def test_a_look_at_other_pages_changes_nothing(units, operation):
    widget("advanced").setChecked(True)
    pump()
    before = shown_texts()
    pages = panel().form[0]
    for index in (0, pages.count() - 1, 1, pages.count() - 1):
        pages.setCurrentIndex(index)
        pump()
    assert shown_texts() == before
    assert operation.Tolerance.Value == pytest.approx(0.01)
    with answered() as answer:
        press(OK)
    assert not answer.texts and not is_panel_open()


def test_feeds_of_the_tool_controller_stay_as_they_are(units, job, floor):
    (controller,) = job.Tools.Group
    controller.HorizFeed = controller.VertFeed = 25.004
    select(floor)
    press_toolbar_button()
    settle()
    with answered():
        press(OK)
    assert (controller.HorizFeed.Value, controller.VertFeed.Value) == (25.004, 25.004)


@pytest.mark.skipif(not has_tool_controller_editor(), reason="the panel has no such editor")
def test_feed_that_is_typed_in_the_editor_is_taken_alone(units, operation):
    controller = operation.ToolController
    controller.VertFeed = 25.004
    widget("editToolController").setChecked(True)
    pump()
    box = panel().operation_page.tcEditor.horizFeed.widget
    box.setProperty("rawValue", 40.0)
    pump()
    with answered():
        press(OK)
    assert controller.HorizFeed.Value == pytest.approx(40, rel=0.2)  # rounded by FreeCAD
    assert controller.HorizFeed.Value != 25
    assert controller.VertFeed.Value == 25.004


def test_nothing_is_to_be_applied_before_a_change(units, operation):
    operation.StockToLeave = 0.1234
    press(OK)
    edit(operation)
    widget("advanced").setChecked(True)
    pump()
    assert not panel_button(APPLY).isEnabled()
    widget("coolantController").setCurrentIndex(1)
    assert panel_button(APPLY).isEnabled()


def test_depths_stay_as_they_are(units, operation):
    for name in ("FinalDepth", "StepDown", "SafeHeight"):
        operation.setExpression(name, None)
    operation.FinalDepth, operation.StepDown, operation.SafeHeight = -5.004, 2.0637, 3.004
    pump()
    pages = panel().form[0]
    for index in (1, 2, pages.count() - 1):
        pages.setCurrentIndex(index)
        pump()
    with answered():
        press(OK)
    assert (operation.FinalDepth.Value, operation.StepDown.Value) == (-5.004, 2.0637)
    assert operation.SafeHeight.Value == 3.004


@pytest.mark.parametrize(
    ("told", "shown"),
    [
        ("A cutter below 5.87 mm reaches it.", "A cutter below 0.2311 in reaches it."),
        (
            "0.01 mm is usual. 645 mm2 of the floor stay uncut, the largest part at X12.7 Y-25.4.",
            "0.0004 in is usual. 0.9998 in² of the floor stay uncut, the largest part at "
            "X0.500 Y-1.000.",
        ),
        ("At Z-3 the pocket reaches under a wall.", "At Z-0.118 the pocket reaches under a wall."),
        ("3 mm/min are slow.", "3 mm/min are slow."),
    ],
)
def test_remarks_tell_lengths_in_the_users_unit(inches, told, shown):
    assert in_panel(told) == shown
    FreeCAD.Units.setSchema(0)
    assert in_panel(told) == told


def test_feed_of_links_is_shown_in_the_users_unit(inches, operation):
    operation.LinkFeed = 2540.0
    assert text(widget("linkFeed")) == ["100.00", "in/min"]
    assert operation.LinkFeed == 2540.0


@pytest.mark.parametrize("letters", ["0.005", "0.0625", "0.012"])
def test_inches_are_kept_as_they_are_typed(inches, operation, letters):
    widget("useStartPoint").setChecked(True)
    for box in ("stockToLeave", "startPointX"):
        enter(widget(box), letters)
        assert text(widget(box)) == [letters, "in"]
    widget("finishingProfile").setChecked(False)  # writes all fields once more
    assert operation.StockToLeave.Value == pytest.approx(25.4 * float(letters), rel=1e-9)
    assert operation.StartPoint.x == pytest.approx(25.4 * float(letters), rel=1e-9)


def test_ok_does_not_close_over_what_was_not_taken(operation):
    type_into(widget("stepOver"), "10")
    with answered() as answer:
        press(OK)
    assert is_panel_open() and len(answer.texts) == 1
    assert "6.00 mm" in answer.texts[0]
    press(OK)
    assert not is_panel_open() and operation.StepOver == 40


def test_advice_reads_well_in_inches(inches, operation):
    type_into(widget("stockToLeave"), "much")
    with answered() as answer:
        press(OK)
    assert len(answer.texts) == 1 and 'where no unit is typed, it is "in".' in answer.texts[0]


def test_inches_can_be_typed_where_millimeters_are_shown(operation):
    type_into(widget("stepOver"), "0.06 in")
    assert operation.MaxEngagement.Value == pytest.approx(60.53, abs=0.01)
    assert operation.StepOver == 25
    type_into(widget("maxEngagement"), "60")
    assert (operation.StepOver, operation.MaxEngagement.Value) == (25, 0)
    assert widget("stepOver").property("rawValue") == pytest.approx(1.5)


def test_a_percentage_is_taken_while_it_is_typed(operation):
    type_into(widget("stepOverPercent"), "33")
    assert operation.StepOver == 33
    assert widget("maxEngagement").property("rawValue") == pytest.approx(70.12, abs=0.01)


def test_the_tab_key_follows_the_page(operation):
    form, found = panel().operation_page.form, []
    box = form.toolController
    while form.isAncestorOf(box) and len(found) < len(TAB_ORDER):
        if box.objectName() in TAB_ORDER:
            found.append(box.objectName())
        box = box.nextInFocusChain()
    assert found == TAB_ORDER


def test_feeds_are_told_in_the_users_unit(inches, operation):
    settle()
    box = panel().operation_page.preview.box
    box.quantity.setCurrentIndex(1)
    assert box.quantity.currentText() == "Feed [in/min]"
    assert box.bar.toolTip() == "0 - 59 in/min"  # 1500 mm/min
    pytest.importorskip("matplotlib")
    panel().operation_page.plots.button.setChecked(True)
    axes = panel().operation_page.plots.dock._figure.axes
    assert axes[2].get_title(loc="left") == "Programmed feed [in/min]"
    assert 58 < np.nanmax(axes[2].lines[0].get_ydata()) < 60


def test_picked_start_point_keeps_its_decimals(inches, operation):
    model, (face,) = operation.Base[0]
    FreeCADGui.Selection.addSelection(model, face, 20.123, 15.001, -6.0)
    pump()
    widget("pickStartPoint").click()
    pump()
    assert operation.UseStartPoint
    assert tuple(operation.StartPoint) == pytest.approx((20.123, 15.001, 0), abs=1e-4)
    assert text(widget("startPointX")) == ["0.792244", "in"]
    FreeCADGui.Selection.clearSelection()
