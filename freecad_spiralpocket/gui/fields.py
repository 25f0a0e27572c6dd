# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ties a widget of the panel to a property of the operation, both ways.

Each field knows how to show the property, how to write it back (only if it
differs, as every assignment marks the operation changed) and which signals say
that the user changed it. Tooltips are the properties' own documentation.
"""

from __future__ import annotations

from typing import Any, Protocol

import FreeCAD
from PySide import QtCore

from .compat import PathGuiUtil, check_box_signal, show_value

translate = FreeCAD.Qt.translate


class Field(Protocol):
    """What the panel asks of a field."""

    name: str

    def show(self) -> None:
        """Show the property's value in the widget, without any signal."""

    def write(self) -> None:
        """Write the widget's value to the property."""

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""


class _Bound:
    """A widget, an operation and the name of a property of it."""

    def __init__(self, widget: Any, obj: Any, name: str) -> None:
        self.widget, self.obj, self.name = widget, obj, name
        widget.setToolTip(translate("App::Property", obj.getDocumentationOfProperty(name)))

    def show(self) -> None:
        """Show the property's value, without any signal."""
        blocker = QtCore.QSignalBlocker(self.widget)
        self._show()
        blocker.unblock()

    def _set(self, value: Any) -> None:
        if getattr(self.obj, self.name) != value:
            setattr(self.obj, self.name, value)


class Choice(_Bound):
    """An enumeration in a combo box; the text is translated, the data is not."""

    def __init__(self, widget: Any, obj: Any, name: str) -> None:
        super().__init__(widget, obj, name)
        for value in obj.getEnumerationsOfProperty(name):
            text = value.replace("_", " ")
            widget.addItem(translate("SpiralPocket", text[:1].upper() + text[1:]), value)

    def _show(self) -> None:
        self.widget.setCurrentIndex(self.widget.findData(getattr(self.obj, self.name)))

    def write(self) -> None:
        """Write the selected value."""
        self._set(self.widget.currentData())

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return [self.widget.currentIndexChanged]


class Number(_Bound):
    """A percentage or another plain number in a spin box."""

    def _show(self) -> None:
        self.widget.setValue(getattr(self.obj, self.name))

    def write(self) -> None:
        """Write the number."""
        self._set(self.widget.value())

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return [self.widget.valueChanged]


class Check(_Bound):
    """Yes or no in a check box."""

    def _show(self) -> None:
        self.widget.setChecked(getattr(self.obj, self.name))

    def write(self) -> None:
        """Write the state."""
        self._set(self.widget.isChecked())

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return [check_box_signal(self.widget)]


class Quantity(_Bound):
    """A length or an angle in a ``Gui::QuantitySpinBox``, with its unit and expression."""

    def __init__(self, widget: Any, obj: Any, name: str) -> None:
        super().__init__(widget, obj, name)
        self._binding = PathGuiUtil.QuantitySpinBox(widget, obj, name)

    def _show(self) -> None:
        show_value(self._binding)

    def write(self) -> None:
        """Write the value, or what its expression gives."""
        self._binding.updateProperty()

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return [self.widget.valueChanged, self.widget.editingFinished]
