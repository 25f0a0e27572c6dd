# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sample rib in the window: its path is drawn, and pictures of it are kept to be looked at."""

from pathlib import Path

import FreeCADGui
import numpy as np
import Part
import pytest
from conftest import add_job, floors
from PySide import QtCore, QtGui
from window import (
    APPLY,
    OK,
    VERSION,
    is_panel_open,
    pixels_that_differ,
    press,
    press_toolbar_button,
    pump,
    screenshot,
    select,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.compat import freecad_icon
from freecad_spiralpocket.gui.preview import colors
from freecad_spiralpocket.gui.qt.theme import theme

RIB = Path(__file__).resolve().parents[2] / "examples" / "rib.step"
FLOOR = 3.0  # mm, height of the pockets' floors


@pytest.mark.slow
def test_rib_is_machined_in_the_window(doc, out_dir):
    job = add_job(doc, Part.read(str(RIB)), diameter=12.0, feed=3000.0)
    part = doc.getObject("Part")
    select(*((part, name) for name in floors(part, FLOOR)))
    press_toolbar_button()
    FreeCADGui.Selection.clearSelection()
    job.Stock.ViewObject.Visibility = False
    widget("stepOverPercent").setValue(35)
    FreeCADGui.getDocument(doc.Name).ActiveView.fitAll()
    bare = screenshot()
    press(APPLY)
    machined = screenshot()
    machined.save(str(out_dir / f"panel-{VERSION}.png"))
    assert pixels_that_differ(bare, machined) > 5000
    press(OK)
    wait_for(lambda: not is_panel_open())
    (operation,) = job.Operations.Group
    assert len(operation.Base[0][1]) == 9
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    view.viewTop()
    view.fitAll()
    pump(0.5)
    screenshot().save(str(out_dir / f"path-{VERSION}.png"))


def contrast(one, other):
    """Return the contrast ratio of two colors as in WCAG 2, 1 to 21."""

    def luminance(color):
        parts = np.array([color.redF(), color.greenF(), color.blueF()])
        linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
        return float(linear @ (0.2126, 0.7152, 0.0722)) + 0.05

    low, high = sorted((luminance(one), luminance(other)))
    return high / low


@pytest.mark.parametrize("color", ["#202020", "#f0f0f0"])
def test_what_paints_itself_wears_the_theme(color):
    application = QtGui.QApplication.instance()
    before = application.styleSheet()
    text = "#f0f0f0" if color < "#8" else "#101010"
    application.setStyleSheet(f"QWidget {{background-color: {color}; color: {text}}}")
    try:
        worn = theme()
    finally:
        application.setStyleSheet(before)
    assert (worn.background.name(), worn.text.name()) == (color, text)


def test_paths_stand_out_from_a_part_in_any_theme():
    part = QtGui.QColor(204, 204, 204)
    for color in (colors.ENTRY, colors.LINK, colors.DRAFT, *colors.SCALE[[0, -1]]):
        shown = QtGui.QColor.fromRgbF(*(float(c) for c in color))
        assert contrast(shown, part) > 1.4


@pytest.mark.parametrize("name", ["Simulator", "Inspect", "OpActive"])
def test_freecads_icons_are_there(name):
    assert QtCore.QFile.exists(freecad_icon(name))
