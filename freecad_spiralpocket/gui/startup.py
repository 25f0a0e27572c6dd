# SPDX-License-Identifier: LGPL-2.1-or-later
"""What happens when FreeCAD's window opens: icons, translations, the command in CAM.

FreeCAD starts slower with every add-on, so nothing here loads CAM, scipy or
shapely. CAM is registered by now but not loaded: since 1.0 a manipulator adds
the command to its toolbar and menu, on 0.20 we extend the workbench's own
`Initialize`.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from .adoption import Adopter
from .command import COMMAND, CommandSpiralPocket
from .resources import RESOURCES

TOOLBAR = "New Operations"
#: The workbench, which was Path in 0.20; its menu there, and since 1.0 the item of CAM's menu
#: that ours follows.
WORKBENCH, LEGACY_WORKBENCH = "CAMWorkbench", "PathWorkbench"
LEGACY_MENU, NEIGHBOR = "&Path", "CAM_Adaptive"


class Manipulator:
    """Adds the command to CAM's toolbar and menu (1.0 and later).

    FreeCAD asks at every change of workbench; where a name is missing nothing is added.
    """

    def modifyToolBars(self) -> list[dict[str, str]]:  # noqa: N802 - the name FreeCAD calls
        """Return what to add to the toolbars."""
        return [{"append": COMMAND, "toolBar": TOOLBAR}]

    def modifyMenuBar(self) -> list[dict[str, str]]:  # noqa: N802 - the name FreeCAD calls
        """Return what to add to the menus."""
        return [{"insert": COMMAND, "menuItem": NEIGHBOR, "after": ""}]


class PreferencePage:
    """Stands for the page of the preferences, which is loaded when FreeCAD asks for one."""

    def __new__(cls, *parent: Any) -> Any:
        """Return the real page."""
        from .preferencepage import PreferencePage

        return PreferencePage(*parent)


def is_legacy() -> bool:
    """Return whether CAM is still called Path, as in 0.20."""
    return WORKBENCH not in FreeCADGui.listWorkbenches()


def register_operation(workbench: str) -> None:
    """Make the operation known to the setup sheets when CAM is first used.

    Else the job editor would not offer its defaults, and a job template would lose them.
    """
    if workbench in (WORKBENCH, LEGACY_WORKBENCH):
        from ..op import operation  # noqa: F401 - registers itself


def start() -> None:
    """Make the command known to FreeCAD and put it where users look for it."""
    FreeCADGui.addIconPath(str(RESOURCES / "icons"))
    FreeCADGui.addLanguagePath(str(RESOURCES / "translations"))
    FreeCADGui.updateLocale()
    FreeCADGui.addCommand(COMMAND, CommandSpiralPocket())
    FreeCADGui.addPreferencePage(PreferencePage, "Path" if is_legacy() else "CAM")
    FreeCADGui.getMainWindow().workbenchActivated.connect(register_operation)
    FreeCAD.addDocumentObserver(Adopter())
    if hasattr(FreeCADGui, "addWorkbenchManipulator"):
        FreeCADGui.addWorkbenchManipulator(Manipulator())
    else:
        _extend_legacy_workbench()


def _extend_legacy_workbench() -> None:
    """Let the workbench of 0.20 append our command when it is first used."""
    workbench = FreeCADGui.listWorkbenches().get(LEGACY_WORKBENCH)
    if workbench is None:  # switched off or not installed
        return
    initialize = type(workbench).Initialize

    def initialize_with_ours(self: Any) -> None:
        initialize(self)
        self.appendToolbar(TOOLBAR, [COMMAND])
        self.appendMenu([LEGACY_MENU], [COMMAND])

    type(workbench).Initialize = initialize_with_ours
