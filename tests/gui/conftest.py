# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the tests that run inside FreeCAD's window."""

import sys
import traceback
from contextlib import contextmanager

import FreeCAD
import FreeCADGui
import Part
import pytest
from FreeCAD import Vector
from operations import only_operation
from window import (
    IS_LEGACY,
    OK,
    WORKBENCH,
    is_panel_open,
    main_window,
    press,
    press_toolbar_button,
    pump,
    report_view,
    select,
    settle,
    wait_for,
)

from freecad_spiralpocket.gui.preview.live import LIVE
from freecad_spiralpocket.op import preferences

if IS_LEGACY:
    from PathScripts import PathJobGui
else:
    import Path.Main.Gui.Job as PathJobGui

DEPTH = 6.0

#: What 0.20 says whenever it opens a document with a job of its own.
HARMLESS = "setAttr failed"


@pytest.fixture(scope="session", autouse=True)
def workbench():
    """Bring the window to a known size and CAM to the front."""
    main_window().resize(1280, 1000)
    main_window().move(0, 0)
    FreeCADGui.activateWorkbench(WORKBENCH)
    pump(0.5)


@pytest.fixture(autouse=True)
def no_exceptions():
    """Fail a test in which something raised where only the Report view or stderr shows it."""
    raised = []
    hook, sys.excepthook = sys.excepthook, lambda *args: raised.append(args)
    before = len(report_view())
    yield
    pump()
    sys.excepthook = hook
    assert not raised, "".join(traceback.format_exception(*raised[0]))
    news = "\n".join(n for n in report_view()[before:].splitlines() if HARMLESS not in n)
    assert "Traceback" not in news and "<class '" not in news, news


@pytest.fixture(autouse=True)
def live():
    """Let *Live* be on in the next test's panel."""
    yield
    preferences.write(LIVE, True, True)


@contextmanager
def new_document():
    """Yield an empty document that is closed afterwards."""
    document = FreeCAD.newDocument("Test")
    document.UndoMode = 1
    name = document.Name
    yield document
    FreeCADGui.Control.closeDialog()
    pump()
    if name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)
    pump()


@pytest.fixture
def doc():
    """Return an empty document that is closed after the test."""
    with new_document() as document:
        yield document


def add_job(document, solid, diameter, feed=1500.0):
    """Return a job for `solid` with one end mill, made as its command makes it."""
    part = document.addObject("Part::Feature", "Part")
    part.Shape = solid
    document.recompute()
    job = PathJobGui.Create([part], None, False)
    job.Stock.ExtZpos = 0
    tool_controller = job.Tools.Group[0]
    tool_controller.Tool.Diameter = diameter
    tool_controller.Label = f"TC: {diameter:g} mm end mill"
    tool_controller.SpindleSpeed = 12000
    tool_controller.HorizFeed = feed / 60
    tool_controller.VertFeed = feed / 240
    tool_controller.HorizRapid = tool_controller.VertRapid = 5000 / 60
    document.recompute()
    document.recompute()  # the tool's own shape follows its diameter one step behind
    FreeCAD.closeActiveTransaction()
    view = FreeCADGui.getDocument(document.Name).ActiveView
    view.viewIsometric()
    view.fitAll()
    pump()
    return job


def floors(part, z):
    """Return the names of the faces at height `z` that look up."""
    return [
        f"Face{number}"
        for number, face in enumerate(part.Shape.Faces, start=1)
        if face.BoundBox.ZLength < 1e-6
        and abs(face.BoundBox.ZMin - z) < 1e-6
        and face.normalAt(0, 0).z > 0.9
    ]


def plate():
    """Return a plate with one rounded pocket of 28 x 20 mm, its top at Z0."""
    pocket = Part.makeBox(28, 20, 20, Vector(8, 6, -DEPTH))
    upright = [e for e in pocket.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.9]
    return Part.makeBox(44, 32, 12, Vector(0, 0, -12)).cut(pocket.makeFillet(6, upright))


@pytest.fixture
def job(doc):
    """Return a job for the plate with a 6 mm end mill."""
    return add_job(doc, plate(), diameter=6.0)


@pytest.fixture
def part(job):
    """Return the plate."""
    return job.Document.getObject("Part")


@pytest.fixture
def floor(part):
    """Return the floor of the plate's pocket as (object, face name)."""
    return part, floors(part, -DEPTH)[0]


@pytest.fixture
def opened(job, floor):
    """Return a new operation with its panel open and its path proved."""
    select(floor)
    press_toolbar_button()
    FreeCADGui.Selection.clearSelection()
    settle()
    return job.Operations.Group[0]


@pytest.fixture
def operation(job, floor):
    """Return an operation made with the panel, which is closed again."""
    select(floor)
    press_toolbar_button()
    press(OK)
    wait_for(lambda: not is_panel_open())
    return only_operation(job)
