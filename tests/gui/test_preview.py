# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview follows what is typed, touches nothing, and leaves nothing behind."""

import gc
import time

import FreeCADGui
import Part
import pytest
from conftest import add_job, floors
from FreeCAD import Vector
from pivy import coin
from snapshot import differences, snapshot
from window import (
    APPLY,
    CANCEL,
    OK,
    edit,
    is_panel_open,
    page,
    pixels_that_differ,
    press,
    press_toolbar_button,
    pump,
    screenshot,
    select,
    settle,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.planning import lanes
from freecad_spiralpocket.gui.preview.scene import NAME, DraftItem, PathItem


def preview():
    """Return the preview of the open panel."""
    return page().preview


def outlook():
    """Return what the open panel foresees."""
    return page().outlook


def items():
    """Return what the preview shows."""
    return list(preview().items.values())


def nodes(document, name=NAME):
    """Return how many previews hang in the 3D view of a document, or how many nodes of any name."""
    search = coin.SoSearchAction()
    if name:
        search.setName(name)
    else:
        search.setType(coin.SoNode.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(FreeCADGui.getDocument(document.Name).ActiveView.getSceneGraph())
    return search.getPaths().getLength()


@pytest.fixture(autouse=True)
def nothing_proved():
    """Forget what other tests had proved."""
    lanes.proved.clear()


def test_the_proved_path_is_drawn_without_a_recompute(opened):
    assert [type(i) for i in items()] == [PathItem]
    assert len(opened.Path.Commands) == 0
    assert "proved" in preview().box.status.text()


def test_a_change_is_drafted_first_and_proved_then(opened):
    widget("stepOverPercent").setValue(17)
    seen = []
    wait_for(lambda: seen.append(tuple(map(type, items()))) or outlook().is_settled, 60)
    order = [s for i, s in enumerate(seen) if i == 0 or s != seen[i - 1]]
    assert order[-2:] == [(DraftItem,), (PathItem,)]
    assert outlook().plans[0].request.cutting.stepover == pytest.approx(0.17 * 6)


def test_typing_fast_shows_the_last_value_only(opened):
    for percent in range(20, 40):
        widget("stepOverPercent").setValue(percent)
        pump(0.02)
    settle()
    assert [p.request.cutting.stepover for p in outlook().pockets] == [pytest.approx(0.39 * 6)]
    assert len(items()) == 1


def test_a_value_that_was_seen_before_is_drawn_at_once(opened):
    first = outlook().pockets[0].drawn
    widget("stepOverPercent").setValue(31)
    settle()
    widget("stepOverPercent").setValue(40)
    pump(0.1)
    assert outlook().pockets[0].drawn is first
    assert [type(i) for i in items()] == [PathItem]


def test_preview_touches_nothing(doc, opened):
    before = snapshot(doc)
    widget("stepOverPercent").setValue(33)
    settle()
    preview().box.slider.setValue(400)
    preview().box.quantity.setCurrentIndex(1)
    pump()
    changed = differences(before, snapshot(doc))
    assert set(changed) == {opened.Name}
    assert set(changed[opened.Name]) <= {"StepOver"}


def test_apply_takes_what_the_preview_has_proved(opened, monkeypatch):
    (plan,) = outlook().plans
    monkeypatch.setattr(lanes.proofs, "submit", None)  # nothing is planned anew
    press(APPLY)
    assert opened.Proxy.plans[0] is plan
    assert len(opened.Path.Commands) > 50


def test_the_operations_own_path_is_hidden_while_the_preview_shows(opened):
    press(APPLY)
    switch = opened.ViewObject.SwitchNode
    assert switch.whichChild.getValue() == coin.SO_SWITCH_NONE
    preview().box.live.setChecked(False)
    pump()
    assert switch.whichChild.getValue() == 0 and not items()
    preview().box.live.setChecked(True)
    settle()
    press(OK)
    assert switch.whichChild.getValue() == 0 and opened.ViewObject.Visibility


def test_what_cannot_be_cut_is_said_and_nothing_old_is_shown(job, opened):
    widget("stockToLeave").setProperty("rawValue", 50)
    settle()
    assert "does not fit" in preview().box.status.text()
    assert not items()
    widget("stockToLeave").setProperty("rawValue", 0)
    settle()
    assert [type(i) for i in items()] == [PathItem]


def test_the_slider_plays_the_cut(opened):
    box = preview().box
    whole = screenshot()
    box.slider.setValue(300)
    part = screenshot()
    assert pixels_that_differ(whole, part) > 500
    box.play.setChecked(True)
    pump(0.5)
    assert box.slider.value() > 300
    box.play.setChecked(False)
    box.slider.setValue(box.slider.maximum())
    assert pixels_that_differ(whole, screenshot()) < 50


def test_legend_bears_a_step_over_of_nothing(opened):
    opened.StepOver = 0
    wait_for(lambda: "never clears" in preview().box.status.text())
    preview().box.bar.grab()  # an error in painting fails the test


def test_colors_by_feed_differ(opened):
    by_engagement = screenshot()
    preview().box.quantity.setCurrentIndex(1)
    assert pixels_that_differ(by_engagement, screenshot()) > 500


@pytest.mark.parametrize("button", [OK, CANCEL])
def test_nothing_is_left_in_the_view(doc, opened, button):
    assert nodes(doc) == 1
    press(button)
    wait_for(lambda: not is_panel_open())
    assert nodes(doc) == 0


def test_dialog_that_others_close_takes_its_timers_along(doc, opened):
    widget("stepOverPercent").setValue(34)
    wait_for(lambda: not outlook().is_settled)
    FreeCADGui.Control.closeDialog()
    time.sleep(1)  # all are due now
    pump(0.3)
    assert not is_panel_open() and nodes(doc) == 0


def test_deleted_operation_takes_its_preview_along(doc, opened):
    doc.removeObject(opened.Name)
    wait_for(lambda: not is_panel_open())
    assert nodes(doc) == 0


@pytest.mark.slow
def test_many_openings_leave_nothing_behind(doc, opened):
    press(OK)
    edit(opened)
    press(CANCEL)
    before = nodes(doc, None)
    gc.collect()
    for _ in range(12):
        edit(opened)
        settle()
        press(CANCEL)
    assert nodes(doc) == 0
    assert nodes(doc, None) == before
    gc.collect()
    kept = [o for o in gc.get_objects() if isinstance(o, PathItem)]
    assert len(kept) <= 1


def test_tool_that_does_not_fit_is_said(job, opened):
    job.Tools.Group[0].Tool.Diameter = 80
    widget("stepOverPercent").setValue(29)
    settle()
    assert "80 mm" in preview().box.status.text()
    press(CANCEL)


def test_copies_are_proved_once_and_drawn_each(doc):
    solid = Part.makeBox(90, 50, 12, Vector(-5, -5, -12))
    for x in (0, 40):
        solid = solid.cut(Part.makeBox(34, 28, 6, Vector(x, 4, -6)))
    job = add_job(doc, solid, diameter=6.0)
    part = doc.getObject("Part")
    select(*((part, name) for name in floors(part, -6.0)))
    press_toolbar_button()
    settle()
    assert len(lanes.proved) == 1
    assert [type(i) for i in items()] == [PathItem, PathItem]
    one, other = outlook().plans
    apart = other.toolpath.points - one.toolpath.points
    assert abs(abs(apart[:, 0]) - 40).max() < 1e-6 and abs(apart[:, 1:]).max() < 1e-6
    press(OK)
    (made,) = job.Operations.Group
    assert len(lanes.proved) == 1
    for plan, seen in zip(made.Proxy.plans, (one, other), strict=True):
        assert abs(plan.toolpath.points - seen.toolpath.points).max() == 0
