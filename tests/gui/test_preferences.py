# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of the preferences keeps defaults; the job editor knows the operation's presets."""

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui
from window import (
    OK,
    edit,
    is_panel_open,
    press,
    press_toolbar_button,
    pump,
    select,
    type_into,
)

from freecad_spiralpocket.gui.preferencepage import WIDGETS, PreferencePage
from freecad_spiralpocket.op import operation, preferences, presets, properties
from freecad_spiralpocket.op.compat import PathSetupSheet

OTHERS = {
    "Strategy": "Linear Morph",
    "StepOver": 25,
    "CutMode": "Conventional",
    "HelixAngle": 3.0,
    "Machine": "vmc",
    "FeedMode": "Chip thickness",
    "SlowdownPercent": 60,
    "MaxFeedRatio": 1.5,
    "LinkFeed": 3000.0,
    "Tolerance": 0.02,
}
DEFAULTS = {p.name: p.default for p in properties.TABLE}


@pytest.fixture
def page(parameters):
    """Return the page as FreeCAD opens it."""
    page = PreferencePage()
    page.loadSettings()
    return page


def kept():
    """Return what is preferred."""
    return {name: preferences.read(name, DEFAULTS[name]) for name in preferences.NAMES}


def enter(box, name, value):
    """Enter a value into a widget of the page."""
    if isinstance(box, QtGui.QComboBox):
        box.setCurrentIndex(box.findData(value))
    elif isinstance(box, (QtGui.QSpinBox, QtGui.QDoubleSpinBox)):
        box.setValue(value)
    else:
        box.setProperty("rawValue", value / 60 if name == "LinkFeed" else value)


def test_page_shows_defaults_and_keeps_none_of_them(page, parameters):
    page.saveSettings()
    assert not parameters.GetContents()


def test_page_keeps_what_is_entered_and_shows_it_again(page, tmp_path):
    for name, widget in WIDGETS.items():
        enter(getattr(page.form, widget), name, OTHERS[name])
    page.form.machineFolder.setProperty("fileName", str(tmp_path))
    page.saveSettings()
    assert kept() == pytest.approx(OTHERS)
    assert preferences.machine_folder() == tmp_path
    again = PreferencePage()
    again.loadSettings()
    again.saveSettings()
    assert kept() == pytest.approx(OTHERS)


def test_every_widget_has_a_tooltip(page):
    assert all(getattr(page.form, widget).toolTip() for widget in WIDGETS.values())
    assert "mm/min" not in page.form.linkFeed.toolTip()  # the box is in the user's unit


def test_operation_is_registered_with_the_workbench():
    pump()
    assert operation.NAME in PathSetupSheet._RegisteredOps


def test_job_editor_opens_with_the_operations_defaults(doc, job, floor):
    select(floor)
    press_toolbar_button()
    press(OK)
    (made,) = job.Operations.Group
    presets.keep(made)
    edit(job)
    assert is_panel_open()
    FreeCADGui.Control.closeDialog()
    pump(0.3)


def test_inches_are_kept_as_they_are_typed(parameters):
    FreeCAD.Units.setSchema(3)
    try:
        page = PreferencePage()
        page.loadSettings()
        page.form.show()
        assert page.form.tolerance.text() == "0.000393701 in"
        page.saveSettings()
        assert not parameters.GetContents()
        type_into(page.form.tolerance, "0.0004")
        page.saveSettings()
        assert kept()["Tolerance"] == pytest.approx(0.01016)
        type_into(page.form.tolerance, "-1")
        page.saveSettings()
        assert kept()["Tolerance"] == pytest.approx(0.01016)
        page.form.close()
    finally:
        FreeCAD.Units.setSchema(0)
