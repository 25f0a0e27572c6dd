# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operation's view provider: its icon in the tree, its panel, what may be selected.

CAM's own view provider looks the selection rule up in a fixed list of
operations, builds icons from compiled resources and saves both names into the
document. Here they belong to the class and nothing is saved, so that a document
does not remember where the add-on was installed.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from . import progress
from .command import ICON
from .compat import INACTIVE_ICON, PathOpGui, PathSelection
from .panel import OperationPage
from .startup import RESOURCES
from .taskpanel import TaskPanel


class ViewProvider(PathOpGui.ViewProvider):
    """Proxy of the operation's view object."""

    OpName = "Spiral Pocket"
    OpIcon = str(RESOURCES / "icons" / f"{ICON}.svg")

    def __init__(self, vobj: Any) -> None:
        self.deleteOnReject = True  # until the panel was open once
        vobj.Proxy = self

    def attach(self, vobj: Any) -> None:
        """Take over the view object: when it is made and when it is restored."""
        super().attach(vobj)
        progress.install()

    def getIcon(self) -> str:  # noqa: N802 - the name FreeCAD calls
        """Return the icon in the tree."""
        return self.OpIcon if self.Object.Active else INACTIVE_ICON

    def getSelectionFactory(self) -> Callable[[], None]:  # noqa: N802 - the name FreeCAD calls
        """Return what restricts the selection while the panel is open: as for Pocket."""
        return PathSelection.pocketselect

    def setEdit(self, vobj: Any = None, mode: int = 0) -> bool:  # noqa: N802
        """Open the panel."""
        if mode != 0:
            return False
        obj = (vobj or self.vobj).Object
        page = OperationPage(obj, 0)
        page.setTitle(self.OpName)
        page.setIcon(self.OpIcon)
        is_new = self.deleteObjectsOnReject()
        self.deleteOnReject = False
        self.setupTaskPanel(TaskPanel(obj, is_new, page, self.getSelectionFactory()))
        return True

    # --- nothing of the proxy is saved

    def dumps(self) -> None:
        """Save nothing (1.0 and later)."""

    def loads(self, state: Any) -> None:
        """Restore nothing (1.0 and later)."""

    def __getstate__(self) -> None:
        """Save nothing (0.20)."""

    def __setstate__(self, state: Any) -> None:
        """Restore nothing (0.20)."""
