# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of the selected faces: FreeCAD's own, which takes those of one part only."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..compat import PathOpGui


class BaseGeometryPage(PathOpGui.TaskPanelBaseGeometryPage):
    """The page "Base Geometry"; FreeCAD calls its methods."""

    def selectionSupportedAsBaseGeometry(  # noqa: N802
        self,
        selection: Sequence[Any],
        ignoreErrors: bool,  # noqa: N803
    ) -> bool:
        """Return whether there is a face among what is selected."""
        return bool(self._faces(selection))

    def addBaseGeometry(self, selection: Sequence[Any]) -> bool:  # noqa: N802
        """Add all selected faces; return whether there were any."""
        faces = self._faces(selection)
        for part, name in faces:
            self.obj.Proxy.addBase(self.obj, part, name)
        return bool(faces)

    def _faces(self, selection: Sequence[Any]) -> list[tuple[Any, str]]:
        """Return part and name of each face that is selected in the operation's document."""
        return [
            (each.Object, name)
            for each in selection
            for name in each.SubElementNames
            if name.startswith("Face") and each.Object.Document == self.obj.Document
        ]
