# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strategies side by side: each is planned, one is picked, and closing ends the work."""

import FreeCADGui
import Part
import pytest
from conftest import DEPTH, add_job, floors
from FreeCAD import Vector
from PySide import QtCore
from snapshot import differences, snapshot
from window import (
    APPLY,
    CANCEL,
    OK,
    answered,
    dialog,
    edit,
    is_panel_open,
    page,
    press,
    press_toolbar_button,
    pump,
    remarks,
    select,
    settle,
    wait_for,
    widget,
)

from freecad_spiralpocket.engine.model import Strategy
from freecad_spiralpocket.gui.compare import window
from freecad_spiralpocket.gui.compare.picture import picture_of
from freecad_spiralpocket.gui.planning import lanes
from freecad_spiralpocket.gui.preview.colors import Scale
from freecad_spiralpocket.gui.qt.theme import theme

NAME = "SpiralPocketCompare"


def cards():
    """Return the cards of the open comparison."""
    return page().compare.window.cards


@pytest.fixture
def compared(opened):
    """Return the same with the comparison open and through."""
    page().compare.button.click()
    wait_for(lambda: all(c.text.text() for c in cards()), 120)
    return opened


def test_all_strategies_and_freecads_own_are_there(compared):
    assert len(cards()) == len(Strategy) + 1
    assert "Adaptive" in cards()[-1].name
    for card in cards():
        assert card.seconds > 0 and card.picture.pixmap() is not None
    assert sum("★" in c._title.text() for c in cards()) == 1
    assert not cards()[-1].button.isEnabled()
    press(CANCEL)
    assert dialog(NAME) is None


@pytest.fixture
def low_boss(doc):
    """Return a job for a round pocket with a boss in it that is lower than the rim."""
    pocket = Part.makeCylinder(22, 20, Vector(26, 26, -DEPTH))
    boss = Part.makeCylinder(4, 3, Vector(34, 29, -DEPTH))
    solid = Part.makeBox(52, 52, 12, Vector(0, 0, -12)).cut(pocket).fuse(boss).removeSplitter()
    return add_job(doc, solid, 6.0)


def test_what_leaves_the_floor_uncut_has_no_star_and_is_told_when_taken(low_boss):
    part = low_boss.Document.getObject("Part")
    select((part, floors(part, -DEPTH)[0]))
    press_toolbar_button()
    FreeCADGui.Selection.clearSelection()
    page().compare.button.click()
    wait_for(lambda: all(c.text.text() for c in cards()), 120)
    central = next(c for c in cards() if c.name == Strategy.CENTRAL_SPIRAL.value)
    assert central.seconds == min(c.seconds for c in cards())
    assert "★" not in central._title.text()
    assert "mm²</span>" in central.text.text()  # in red
    automatic = cards()[0]
    assert "<span" not in automatic.text.text() and ">0 mm²<" in automatic.text.text()
    stars = [c for c in cards() if "★" in c._title.text()]
    assert len(stars) == 1 and stars[0].is_sound

    central.button.click()
    settle()
    uncut = page().result_box.texts["Left uncut in reach"]
    assert f"{uncut} uncut</span>" in page().form.summary.text()
    assert "Nothing is cut below Z-3." in remarks()
    with answered() as answer:
        press(OK)
    assert is_panel_open() and len(answer.texts) == 1
    assert f"{uncut} of the floor stay uncut." in answer.texts[0]
    with answered() as answer:
        press(OK)
    assert not is_panel_open() and not answer.texts
    (operation,) = low_boss.Operations.Group
    edit(operation)
    with answered() as answer:
        press(OK)
    assert not is_panel_open() and not answer.texts


def test_window_is_no_larger_than_the_screen(opened, monkeypatch):
    monkeypatch.setattr(window, "screen_size", lambda: QtCore.QSize(700, 500))
    page().compare.button.click()
    shown = page().compare.window.dialog
    pump()
    assert shown.width() <= 684 and shown.height() <= 452
    press(CANCEL)


def test_no_star_where_none_is_sound(compared):
    for card in cards():
        card.is_sound = False
    page().compare.window._mark_fastest()
    assert not any("★" in c._title.text() for c in cards())
    press(CANCEL)


def test_pictures_are_as_fine_as_the_screen(opened):
    wait_for(lambda: page().outlook.drawn, 60)
    scale, size = Scale("engagement", 180.0), QtCore.QSize(100, 80)
    picture = picture_of(page().outlook.drawn[0], scale, size, theme(), 1.5)
    assert (picture.width(), picture.height()) == (150, 120)
    assert picture.devicePixelRatio() == 1.5
    shown = picture.toImage()
    background = theme().background.name()
    columns = [x for x in range(150) if shown.pixelColor(x, 60).name() != background]
    assert abs(min(columns) + max(columns) - 149) <= 3 and max(columns) - min(columns) > 120
    press(CANCEL)


def test_comparing_touches_nothing(doc, opened):
    before = snapshot(doc)
    page().compare.button.click()
    wait_for(lambda: all(c.text.text() for c in cards()), 120)
    assert not differences(before, snapshot(doc))
    press(CANCEL)


def test_picked_strategy_is_set_and_its_path_is_known(compared):
    at = next(i for i, s in enumerate(Strategy) if s is Strategy.LINEAR_MORPH)
    seconds = cards()[at].seconds
    cards()[at].button.click()
    settle()
    assert compared.Strategy == Strategy.LINEAR_MORPH.value
    assert widget("strategy").currentData() == Strategy.LINEAR_MORPH.value
    (plan,) = page().outlook.plans
    assert plan.report.time == seconds
    press(APPLY)
    assert compared.MachiningTime == pytest.approx(seconds)
    press(CANCEL)


def test_closing_ends_the_work(opened):
    lanes.proved.clear()
    page().compare.button.click()
    jobs = [c.job for c in cards() if c.job is not None]
    assert len(jobs) == len(Strategy) + 1
    page().compare.window.dialog.reject()
    pump()
    assert not lanes.proofs._waiting
    assert not any(s.job in jobs for s in lanes.proofs._seats if s.job is not None)
    press(CANCEL)


def test_comparison_follows_a_change(compared):
    first = cards()[0].seconds
    widget("stepOverPercent").setValue(25)
    settle()
    wait_for(lambda: all(c.text.text() for c in cards()), 120)
    assert cards()[0].seconds > first
    press(CANCEL)


def test_errors_are_told_in_the_panels_words(opened):
    widget("helixAngle").setProperty("rawValue", 0.0)
    settle()
    page().compare.button.click()
    wait_for(lambda: all(c.text.text() for c in cards()), 120)
    assert '"Helix ramp angle"' in cards()[0].text.text()
    press(CANCEL)


def test_pockets_are_named_as_in_the_remarks(doc):
    solid = Part.makeBox(70, 32, 12, Vector(0, 0, -12))
    for x in (4, 38):
        solid = solid.cut(Part.makeBox(28, 20, 20, Vector(x, 6, -DEPTH)))
    add_job(doc, solid, 6.0)
    part = doc.getObject("Part")
    faces = floors(part, -DEPTH)
    select(*((part, face) for face in faces))
    press_toolbar_button()
    settle()
    page().compare.button.click()
    choice = page().compare.window.pocket
    assert choice.isVisible() and choice.count() == 2
    for number, face in enumerate(faces):
        assert f"({part.Label}, {face})" in choice.itemText(number)
    press(CANCEL)


def test_comparison_of_nothing_says_so(opened):
    page().preview.box.live.setChecked(False)
    page().compare.button.click()
    window = page().compare.window
    assert not cards() and not window.pocket.isVisible()
    assert "No pocket" in window.heading.text()
    page().preview.box.live.setChecked(True)
    wait_for(lambda: len(cards()) == len(Strategy) + 1)
    assert "No pocket" not in window.heading.text()
    press(CANCEL)
