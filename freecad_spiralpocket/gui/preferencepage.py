# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page "Spiral Pocket" of FreeCAD's preferences, among those of CAM.

FreeCAD makes the page when the dialog opens and calls `loadSettings` and
`saveSettings`. What stands there are the defaults of new operations.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from ..op import preferences, properties
from .fields.entries import Entry, Scale, lengths, speeds
from .fields.field import MINUTE, link_feed_tip
from .qt.names import load_form
from .resources import RESOURCES
from .texts.choices import choice_text

translate = FreeCAD.Qt.translate

FORM = RESOURCES / "panels" / "Preferences.ui"

#: The widget of each preferred option.
WIDGETS = {name: name[0].lower() + name[1:] for name in preferences.NAMES}
#: Boxes of plain numbers; the others hold quantities.
_PLAIN = (QtGui.QSpinBox, QtGui.QDoubleSpinBox)


class PreferencePage:
    """The page; FreeCAD calls its methods."""

    def __init__(self, parent: Any = None) -> None:
        self.form = load_form(FORM)
        rows = {p.name: p for p in properties.TABLE}
        self.boxes = [(rows[name], getattr(self.form, box)) for name, box in WIDGETS.items()]
        for row, box in self.boxes:
            box.setToolTip(translate("App::Property", row.tooltip))
            for value in row.choices:
                box.addItem(choice_text(row.name, value), value)
        self.form.linkFeed.setToolTip(link_feed_tip())
        scales = (
            ("helixAngle", Scale.of(FreeCAD.Units.Quantity("1 deg"))),
            ("tolerance", lengths()),
            ("linkFeed", speeds()),
        )
        self.entries = {b: Entry(getattr(self.form, b), _Nothing, (), s) for b, s in scales}
        self.shown: dict[str, float] = {}

    def loadSettings(self) -> None:  # noqa: N802 - the name FreeCAD calls
        """Show what is kept."""
        for row, box in self.boxes:
            value = preferences.read(row.name, row.default)
            if row.choices:
                box.setCurrentIndex(max(0, box.findData(value)))
            elif isinstance(box, _PLAIN):
                box.setValue(value)
            else:
                self._show(box.objectName(), value / _factor(row.name))
        folder = preferences.read(preferences.MACHINE_FOLDER, "")
        self.form.machineFolder.setProperty("fileName", folder)

    def saveSettings(self) -> None:  # noqa: N802 - the name FreeCAD calls
        """Keep what is shown."""
        for row, box in self.boxes:
            if row.choices:
                value = box.currentData()
            elif isinstance(box, _PLAIN):
                value = box.value()
            else:
                entered = self.entries[box.objectName()].entered()
                if entered is not None:
                    self._show(box.objectName(), entered)
                value = round(self.shown[box.objectName()] * _factor(row.name), 9)
            preferences.write(row.name, value, row.default)
        folder = self.form.machineFolder.property("fileName")
        preferences.write(preferences.MACHINE_FOLDER, folder, "")

    def _show(self, box: str, value: float) -> None:
        self.entries[box].show(value)
        self.shown[box] = value


class _Nothing:
    """Stands for an operation where there is none: formulas have no properties to name."""

    @staticmethod
    def evalExpression(text: str) -> Any:  # noqa: N802 - the name FreeCAD calls
        """Raise what FreeCAD does where a text is no expression."""
        raise ValueError(text)


def _factor(name: str) -> float:
    """Return how many of the property's units are one of the box's."""
    return MINUTE if name == "LinkFeed" else 1.0
