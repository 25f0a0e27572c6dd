# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel speaks the user's unit."""

import FreeCAD
import pytest
from window import CANCEL, press, press_toolbar_button, pump, select, widget

INCHES = 3  # FreeCAD's number for inches with decimals


def test_length_is_shown_in_the_users_unit(job, floor):
    FreeCAD.Units.setSchema(INCHES)
    if hasattr(job.Document, "UnitSystem"):  # since 1.0 documents have a unit system of their own
        systems = job.Document.getEnumerationsOfProperty("UnitSystem")
        job.Document.UnitSystem = systems[INCHES]
    try:
        select(floor)
        press_toolbar_button()
        box = widget("helixDiameterLimit")
        box.setProperty("rawValue", 25.4)
        pump()
        assert box.property("text").replace('"', "in").split() == ["1.00", "in"]
        assert job.Operations.Group[0].HelixDiameterLimit.Value == pytest.approx(25.4)
        press(CANCEL)
    finally:
        FreeCAD.Units.setSchema(0)
