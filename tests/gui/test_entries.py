# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is typed is taken as it is, or not at all and said so."""

import pytest
from conftest import DEPTH, add_job, floors, new_document, plate
from PySide import QtCore
from window import (
    CANCEL,
    enter,
    leave,
    panel,
    press,
    press_toolbar_button,
    pump,
    remarks,
    select,
    strike,
    type_into,
    widget,
)

from freecad_spiralpocket.op.properties import option_names

INCH = 25.4


@pytest.fixture(scope="module", params=["C", "de"])
def operation(request):
    """Return a new operation whose panel is open for all tests here; closed with Cancel.

    Decimals have a point, or a comma as in German.
    """
    before = QtCore.QLocale()
    QtCore.QLocale.setDefault(QtCore.QLocale(request.param))
    with new_document() as document:
        job = add_job(document, plate(), diameter=6.0)
        part = document.getObject("Part")
        select((part, floors(part, -DEPTH)[0]))
        press_toolbar_button()
        (made,) = job.Operations.Group
        made.UseStartPoint = True
        yield made
        press(CANCEL)
    QtCore.QLocale.setDefault(before)


def value_of(obj, name):
    """Return a property as a plain number."""
    value = getattr(obj, name)
    return tuple(value) if name == "StartPoint" else getattr(value, "Value", value)


def unfold(operation, box):
    """Let a box be used that belongs to a feed mode."""
    mode = {"slowdownPercent": "Linear slow-down", "maxFeedRatio": "Chip thickness"}
    operation.FeedMode = mode.get(box, "Constant")
    panel().operation_page.enable_fields()


def write_all(operation):
    """Have all fields written once more."""
    box = widget("coolantController")
    box.setCurrentIndex((box.currentIndex() + 1) % box.count())
    pump()


#: What is typed into which box, the property that changes, and its value then.
TYPED = [
    ("stepOver", "2.4", "StepOver", 40),
    ("stepOver", "2,4", "StepOver", 40),
    ("stepOver", "1.5 mm", "StepOver", 25),
    ("stepOver", "1,5 mm", "StepOver", 25),
    ("stepOverPercent", "33,3", "StepOver", 33),
    ("stepOverPercent", "12.5 %", "StepOver", 12),
    ("maxEngagement", "60,0", "StepOver", 25),
    ("stockToLeave", "0,125", "StockToLeave", 0.125),
    ("stockToLeave", "0.125", "StockToLeave", 0.125),
    ("zStockToLeave", "-0.015", "ZStockToLeave", -0.015),
    ("slotBite", "1/16 in", "SlotBite", INCH / 16),
    ("slotBite", "1 in + 2 mm", "SlotBite", INCH + 2),
    ("helixDiameterLimit", "2*3", "HelixDiameterLimit", 6),
    ("helixAngle", "2,5", "HelixAngle", 2.5),
    ("tolerance", "0.02", "Tolerance", 0.02),
    ("tolerance", "5 µm", "Tolerance", 0.005),
    ("linkFeed", "33,333", "LinkFeed", 33.333 * 60),
    ("startPointX", "20,125", "StartPoint", (20.125, 0, 0)),
    ("slowdownPercent", "62,0", "SlowdownPercent", 62),
    ("maxFeedRatio", "1,5", "MaxFeedRatio", 1.5),
]


@pytest.mark.parametrize(("box", "letters", "name", "value"), TYPED)
def test_what_is_typed_is_kept_exactly(operation, box, letters, name, value):
    unfold(operation, box)
    enter(widget("stepOverPercent"), "50")
    enter(widget(box), letters)
    assert value_of(operation, name) == pytest.approx(value, rel=1e-9)
    write_all(operation)
    assert value_of(operation, name) == pytest.approx(value, rel=1e-9)


def test_lengths_are_shown_in_millimeters(operation):
    mark = QtCore.QLocale().decimalPoint()
    enter(widget("tolerance"), "0.01")
    assert widget("tolerance").text() == f"0{mark}01 mm"
    enter(widget("stockToLeave"), "0.05")
    assert widget("stockToLeave").text() == f"0{mark}05 mm"
    enter(widget("stockToLeave"), "0.1")
    assert operation.StockToLeave.Value == pytest.approx(0.1)
    strike(widget("stockToLeave"), QtCore.Qt.Key_Up)
    assert operation.StockToLeave.Value > 0.1
    assert widget("stockToLeave").text().endswith(" mm")
    enter(widget("stockToLeave"), "0")


#: What cannot be taken.
REFUSED = [
    ("stepOver", "10"),
    ("stepOver", "0"),
    ("stepOver", "-1"),
    ("stepOver", "1.234,5"),
    ("stepOver", "1abc"),
    ("stepOver", "2 deg"),
    ("stepOver", ""),
    ("stepOverPercent", "500"),
    ("stepOverPercent", "0"),
    ("maxEngagement", "1000"),
    ("helixAngle", "100000"),
    ("tolerance", "-1"),
    ("slowdownPercent", "500"),
    ("maxFeedRatio", "20"),
    ("stockToLeave", "1e99"),
    ("stockToLeave", "-1e99"),
    ("slotBite", "1e99"),
]


@pytest.mark.parametrize(("box", "letters"), REFUSED)
def test_what_cannot_be_taken_leaves_the_value_and_is_told(operation, box, letters):
    unfold(operation, box)
    enter(widget("stepOverPercent"), "40")
    shown, before = widget(box).text(), [value_of(operation, name) for name in option_names()]
    type_into(widget(box), letters)
    if not letters:
        strike(widget(box), QtCore.Qt.Key_Backspace)
    leave(widget(box))
    assert [value_of(operation, name) for name in option_names()] == before
    assert widget(box).text() == shown
    told = widget("summary").text()
    assert f'"{letters}" is not taken' in told and "Type" in told and told in remarks()
    enter(widget("stepOverPercent"), "30")
    assert operation.StepOver == 30
    assert "not taken" not in widget("summary").text() + remarks()


def test_an_angle_whose_limits_are_refused_is_asked_for_between_them(operation):
    enter(widget("helixAngle"), "95")
    told = widget("summary").text().replace(",", ".")
    assert "Type more than 0.00° and less than 90.00°." in told
    enter(widget("helixAngle"), "5")


def turn_pages(operation):
    """Look at another page of the panel, and fold and unfold the advanced fields."""
    pages = panel().form[0]
    shown = pages.currentIndex()
    for index in (1, shown):
        pages.setCurrentIndex(index)
        pump()
    for unfolded in (False, True):
        widget("advanced").setChecked(unfolded)
        pump()
    write_all(operation)


#: What the boxes show rounded: box, what is typed, property.
LONG = [
    ("stockToLeave", "0.1234", "StockToLeave"),
    ("helixAngle", "3.1234", "HelixAngle"),
    ("slotBite", "0.396875", "SlotBite"),
    ("linkFeed", "33.3333", "LinkFeed"),
    ("startPointX", "20.1234", "StartPoint"),
]


@pytest.mark.parametrize(("box", "letters", "name"), LONG)
def test_what_was_typed_outlives_a_look_at_another_page(operation, box, letters, name):
    enter(widget("stepOverPercent"), "40")
    enter(widget(box), letters)
    value, shown = value_of(operation, name), widget(box).text()
    turn_pages(operation)
    assert value_of(operation, name) == value
    assert widget(box).text() == shown
    leave(widget(box))
    assert value_of(operation, name) == value
    assert "not taken" not in widget("summary").text()
    strike(widget(box), QtCore.Qt.Key_Up)
    assert value_of(operation, name) != value


def test_the_arrows_go_back_where_they_came_from(operation):
    enter(widget("stepOverPercent"), "40")
    for key, percent in ((QtCore.Qt.Key_Up, 45), (QtCore.Qt.Key_Down, 40)):
        strike(widget("stepOverPercent"), key)
        assert operation.StepOver == percent
