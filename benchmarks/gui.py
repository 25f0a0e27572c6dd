# SPDX-License-Identifier: LGPL-2.1-or-later
# runs in: freecad
"""The window: how soon a change is drawn, how soon Stop stops, and all its checks.

    ./dev bench gui [--without-checks]

A change is drawn when every pocket has a draft or its plan in the 3D view and the
window is painted: from the new value in the panel's field to there. Changes follow one
another so fast that proofs of the last one are under way; every fourth one moves the
walls (stock to leave), so that nothing of the last draft can be used. The last line is
one JSON object.
"""

import json
import statistics
import sys
import time
from pathlib import Path

import FreeCAD
import FreeCADGui
import Part
import pytest
from FreeCAD import Vector
from PySide import QtCore, QtGui

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "gui"))

from conftest import add_job, floors, plate  # noqa: E402
from window import (  # noqa: E402
    APPLY,
    CANCEL,
    WORKBENCH,
    dialog,
    main_window,
    panel,
    press,
    press_toolbar_button,
    pump,
    select,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.planning import lanes  # noqa: E402

CHANGES, PAUSE = 20, 0.6  # -, s
STAGES = ("Laying", "Planning feeds", "Laying", "Planning feeds", "Laying")
#: So small a step-over that planning takes long, in percent.
LONG = 2
DEPTH = 5.0  # mm


def islands3():
    """Return a block with a pocket of 120 x 80 mm around three islands, its top at Z0."""
    pocket = Part.makeBox(120, 80, 10, Vector(0, 0, -DEPTH))
    upright = [e for e in pocket.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.9]
    pocket = pocket.makeFillet(6, upright)
    for island in (
        Part.makeCylinder(9, 10, Vector(28, 46, -DEPTH)),
        Part.makeCylinder(7, 10, Vector(92, 54, -DEPTH)),
        Part.makeBox(20, 16, 10, Vector(54, 16, -DEPTH)),
    ):
        pocket = pocket.cut(island)
    return Part.makeBox(140, 100, 12, Vector(-10, -10, -12)).cut(pocket)


PARTS = {
    "islands3": (islands3, 6.0, -DEPTH),
    "plate": (plate, 6.0, -6.0),
    "rib": (lambda: Part.read(str(ROOT / "examples" / "rib.step")), 12.0, 3.0),
}


class Window:
    """A panel open on all pockets of a part."""

    def __init__(self, name):
        make, diameter, z = PARTS[name]
        self.document = FreeCAD.newDocument(name)
        self.document.UndoMode = 1
        add_job(self.document, make(), diameter, feed=3000.0)
        part = self.document.getObject("Part")
        select(*((part, face) for face in floors(part, z)))
        press_toolbar_button()
        FreeCADGui.Selection.clearSelection()
        self.page = panel().operation_page
        wait_for(self.is_drawn, 120)

    def is_drawn(self):
        """Return whether all pockets of the newest request are in the 3D view."""
        outlook, preview = self.page.outlook, self.page.preview
        return (
            not outlook.is_behind
            and bool(outlook.pockets)
            and all(p in preview.items for p in outlook.pockets)
            and len(preview.items) == len(outlook.pockets)
        )

    def change(self, name, value):
        """Change a field; return how long it takes until that is drawn [s]."""
        begin = time.monotonic()
        field = widget(name)
        if isinstance(field, (QtGui.QSpinBox, QtGui.QDoubleSpinBox)):
            field.setValue(value)
        else:
            field.setProperty("rawValue", value)
        while not self.is_drawn():
            assert time.monotonic() < begin + 60
            pump(0.004)
        FreeCADGui.updateGui()
        return time.monotonic() - begin

    def close(self):
        """Close panel and document."""
        press(CANCEL)
        FreeCAD.closeDocument(self.document.Name)
        pump()


def latencies(name):
    """Return how long each change of a part takes to be drawn [s]."""
    begin = time.monotonic()
    window = Window(name)
    print(f"{name}: {len(window.page.outlook.pockets)} pockets, "
          f"first drawn after {time.monotonic() - begin:.2f} s, job included")  # fmt: skip
    found = []
    for i in range(CHANGES):
        if i % 4 == 3:
            found.append(window.change("stockToLeave", 0.1 + 0.01 * i))
        else:
            found.append(window.change("stepOverPercent", 22 + i))
        pump(PAUSE)
    window.close()
    print(f"{name}: changes drawn after " + ", ".join(f"{s:.2f}" for s in found) + " s")
    return found


class Stop:
    """Presses Stop in a stage, and remembers when."""

    def __init__(self, stage):
        self.stage, self.pressed = stage, None
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self.look)
        self.timer.start(10)

    def look(self):
        """Press the button once the stage shows."""
        shown = dialog("SpiralPocketProgress")
        if shown is not None and self.stage in shown.labelText():
            self.timer.stop()
            self.pressed = time.monotonic()
            shown.findChild(QtGui.QPushButton).click()


def stops():
    """Return how long each Stop takes until the recompute is over [s]."""
    window = Window("plate")
    widget("stepOverPercent").setValue(LONG)
    found = []
    for stage in STAGES:
        lanes.proved.clear()
        stop = Stop(stage)
        window.page.obj.touch()
        panel().compute()
        assert stop.pressed is not None, f"the stage {stage} was not seen"
        found.append(time.monotonic() - stop.pressed)
        assert window.page.obj.PathLength.Value == 0
        pump(0.5)
    widget("stepOverPercent").setValue(40)
    press(APPLY)
    assert len(window.page.obj.Path.Commands) > 50
    window.close()
    print("stopped after " + ", ".join(f"{s:.3f}" for s in found) + " s")
    return found


class Counter:
    """Counts pytest's checks."""

    run = failed = 0

    def pytest_runtest_logreport(self, report):
        """Count a check that ran, or failed before or after it did."""
        self.run += report.when == "call"
        self.failed += report.failed


def checks():
    """Run all tests of the window; return how many ran and how many failed."""
    counter = Counter()
    arguments = ["-q", "-p", "no:cacheprovider", "--rootdir", str(ROOT), str(ROOT / "tests/gui")]
    pytest.main(arguments, plugins=[counter])
    return counter.run, counter.failed


def main():
    """Measure and print."""
    main_window().resize(1280, 1000)
    FreeCADGui.activateWorkbench(WORKBENCH)
    pump(0.5)
    preview = {name: round(statistics.median(latencies(name)), 3) for name in ("islands3", "rib")}
    stop = round(statistics.median(stops()), 3)
    run, failed = (0, 0) if "--without-checks" in sys.argv else checks()
    print(json.dumps({"preview_s": preview, "stop_s": stop, "checks": run, "failed": failed}))


if __name__ == "__main__":
    main()
