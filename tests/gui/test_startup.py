# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command is where users of CAM look for it, and nowhere else."""

import ast
from pathlib import Path

import FreeCADGui
from window import COMMAND, WORKBENCH, action, main_window, menus, pump, toolbar

from freecad_spiralpocket.gui import startup

LIGHT = {"FreeCAD", "FreeCADGui", "PySide"}


def test_button_is_in_the_toolbar_of_new_operations():
    button = action(toolbar())
    assert button.text() == "Spiral Pocket"
    assert not button.icon().isNull()
    assert toolbar().isVisible()


def test_entry_is_in_the_menu_of_cam():
    entries = [m for m in menus() if action(m) is not None]
    assert [m.title().replace("&", "") for m in entries] == [WORKBENCH.replace("Workbench", "")]


def test_command_is_not_in_other_workbenches():
    FreeCADGui.activateWorkbench("PartWorkbench")
    pump(0.3)
    bars = [b for b in main_window().findChildren(type(toolbar("View"))) if b.isVisible()]
    found = [b for b in [*bars, *menus()] if action(b) is not None]
    FreeCADGui.activateWorkbench(WORKBENCH)
    pump(0.3)
    assert not found
    assert action(toolbar()) is not None


def test_command_needs_a_job(doc):
    command = FreeCADGui.Command.get(COMMAND)
    assert not command.isActive()
    doc.addObject("Part::Box", "Jobless")
    assert not command.isActive()


def test_command_is_active_with_a_job(job):
    assert FreeCADGui.Command.get(COMMAND).isActive()


def test_startup_loads_neither_cam_nor_numerics():
    folder = Path(startup.__file__).parent
    for name in ("startup.py", "command.py", "adoption.py", "resources.py"):
        for node in ast.parse((folder / name).read_text(encoding="utf-8")).body:
            if isinstance(node, ast.Import):
                assert {a.name for a in node.names} <= LIGHT | {"sys"}
            elif isinstance(node, ast.ImportFrom):
                allowed = {"__future__", "pathlib", "typing", "adoption", "command", "resources"}
                assert node.module.split(".")[0] in LIGHT | allowed
