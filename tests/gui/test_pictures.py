# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sample rib in the window: its path is drawn, and pictures of it are kept to be looked at."""

from pathlib import Path

import FreeCADGui
import Part
import pytest
from conftest import add_job, floors
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
