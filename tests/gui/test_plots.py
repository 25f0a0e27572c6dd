# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plots follow the path on show, and the mouse finds the place on the part."""

import sys

import numpy as np
import pytest
from PySide import QtGui
from window import (
    CANCEL,
    answered,
    main_window,
    page,
    pixels_that_differ,
    press,
    pump,
    screenshot,
    settle,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.plots import button as plot_button
from freecad_spiralpocket.gui.plots import dock as plot_dock
from freecad_spiralpocket.gui.plots.curves import curves_of
from freecad_spiralpocket.gui.plots.dock import NAME
from freecad_spiralpocket.op.results import machining_time


def docks():
    """Return the docks with plots."""
    return main_window().findChildren(QtGui.QDockWidget, NAME)


def test_plots_of_the_same_path_are_reckoned_once(opened, monkeypatch):
    made = []
    monkeypatch.setattr(plot_button, "curves_of", lambda *a: made.append(a) or curves_of(*a))
    for wanted in (True, False, True):
        page().plots.button.setChecked(wanted)
        pump()
    assert len(made) == 1 and page().plots.dock._curves is not None
    opened.ToolController.SpindleSpeed = 9000
    wait_for(lambda: len(made) == 2)
    press(CANCEL)


def test_curves_are_the_plans(opened):
    (drawn,) = [p.drawn for p in page().outlook.pockets]
    curves = curves_of([drawn, drawn], opened.ToolController)
    assert curves.clock[-1] == pytest.approx(machining_time([drawn.plan, drawn.plan]))
    assert (np.diff(curves.clock) >= 0).all()
    assert np.nanmax(curves.engagement) <= 180 and np.nanmax(curves.force) > 1
    assert (np.isnan(curves.engagement) == np.isnan(curves.force)).all()
    assert np.nanmedian(curves.feed) == pytest.approx(1500)
    assert 1400 < curves.velocity.max() < 5001
    opened.ToolController.SpindleSpeed = 0
    assert curves_of([drawn], opened.ToolController).force is None
    press(CANCEL)


def test_hovering_puts_the_cutter_on_the_part(opened):
    pytest.importorskip("matplotlib")
    page().plots.button.setChecked(True)
    pump(0.5)
    dock = page().plots.dock
    assert len(docks()) == 1 and len(dock._figure.axes) == 4
    before = screenshot()
    dock.point_at(dock._curves.clock[-1] / 2)
    assert pixels_that_differ(before, screenshot()) > 200
    dock.point_at(None)
    assert pixels_that_differ(before, screenshot()) < 50
    press(CANCEL)
    pump()
    assert not docks()


def test_plots_follow_a_change(opened):
    pytest.importorskip("matplotlib")
    page().plots.button.setChecked(True)
    first = page().plots.dock._curves
    widget("stepOverPercent").setValue(30)
    settle()
    assert page().plots.dock._curves.clock[-1] > first.clock[-1]
    page().plots.button.setChecked(False)
    pump()
    assert not docks()
    press(CANCEL)


def test_texts_may_be_chinese(opened, monkeypatch):
    pytest.importorskip("matplotlib")
    families = plot_dock.chinese_fonts()  # none where no such font is installed
    assert isinstance(families, list) and all(isinstance(family, str) for family in families)
    monkeypatch.setattr(plot_dock, "chinese_fonts", lambda: ["Not There", "DejaVu Serif"])
    page().plots.button.setChecked(True)
    axes = page().plots.dock._figure.axes[0]
    for text in (axes.title, axes._left_title, page().plots.dock._note):
        assert text.get_fontfamily()[-1] == "DejaVu Serif"
        assert "Not There" not in text.get_fontfamily()
    press(CANCEL)


def test_missing_matplotlib_is_said(opened, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.backends.backend_qtagg", None)
    with answered() as answer:
        page().plots.button.setChecked(True)
    assert len(answer.texts) == 1 and "matplotlib" in answer.texts[0]
    assert not page().plots.button.isChecked() and not docks()
    press(CANCEL)


def test_plots_without_a_path_say_so(opened):
    pytest.importorskip("matplotlib")
    page().plots.button.setChecked(True)
    dock = page().plots.dock
    widget("helixAngle").setProperty("rawValue", 0.0)
    settle()
    assert not dock._figure.axes and "No path" in dock._figure.texts[0].get_text()
    widget("helixAngle").setProperty("rawValue", 5.0)
    settle()
    assert len(dock._figure.axes) == 4 and not dock._figure.texts
    press(CANCEL)


def test_plots_stay_until_there_are_others(opened):
    pytest.importorskip("matplotlib")
    page().plots.button.setChecked(True)
    widget("stepOverPercent").setValue(7)
    seen = []
    dock = page().plots.dock
    wait_for(lambda: seen.append(dock._curves) or page().outlook.is_settled, 60)
    assert all(curves is not None for curves in seen)
    press(CANCEL)


def test_forces_follow_the_spindle_speed(opened):
    pytest.importorskip("matplotlib")
    page().plots.button.setChecked(True)
    force = np.nanmax(page().plots.dock._curves.force)
    opened.ToolController.SpindleSpeed = 6000
    wait_for(lambda: np.nanmax(page().plots.dock._curves.force) > force)
    press(CANCEL)
