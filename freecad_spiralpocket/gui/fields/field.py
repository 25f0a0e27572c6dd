# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ties a widget of the panel to a property of the operation, both ways.

Each field knows how to show the property, how to write it back (only if it
differs, as every assignment marks the operation changed) and which signals say
that the user changed it. Tooltips are the properties' own documentation.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from typing import Any, Protocol

import FreeCAD
from PySide import QtCore

from ..compat import check_box_signal
from ..texts.choices import choice_text
from .entries import PERCENT, PLAIN, Entry, Scale, lengths, speeds

translate = FreeCAD.Qt.translate

#: Seconds of a minute: the property holds mm/min, FreeCAD's boxes mm/s.
MINUTE = 60.0


class Field(Protocol):
    """What the panel asks of a field.

    Attributes
    ----------
    names : tuple of str
        The properties that it shows.
    entries : sequence of Entry
        What it has of boxes to type into.
    """

    names: tuple[str, ...]
    entries: Sequence[Entry]

    def show(self) -> None:
        """Show the property's value in the widget, without any signal."""

    def write(self) -> None:
        """Write the widget's value to the property."""

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""


@contextmanager
def silent(*widgets: Any) -> Iterator[None]:
    """Keep back the signals of widgets whose values are not the user's doing."""
    with ExitStack() as stack:
        for widget in widgets:
            blocker = QtCore.QSignalBlocker(widget)
            stack.callback(blocker.unblock)
        yield


def set_property(obj: Any, name: str, value: Any) -> None:
    """Set a property, only where it differs: every assignment marks the operation changed."""
    old = getattr(obj, name)
    if getattr(old, "Value", old) != value:
        setattr(obj, name, value)


def expression(obj: Any, name: str) -> str | None:
    """Return the expression that rules a property, or None."""
    return next((text for path, text in obj.ExpressionEngine if path.lstrip(".") == name), None)


def tooltip(tip: str, ruling: str | None) -> str:
    """Return a tooltip that says as well which expression rules the value, if one does."""
    if ruling is None:
        return tip
    return f"{tip}\n" + translate("SpiralPocket", "Set by the expression {}").format(ruling)


class _Bound:
    """A widget, an operation and the name of a property of it."""

    entries: Sequence[Entry] = ()

    def __init__(self, widget: Any, obj: Any, name: str) -> None:
        self.widget, self.obj, self.name = widget, obj, name
        self.names = (name,)
        self.tip = translate("App::Property", obj.getDocumentationOfProperty(name))
        widget.setToolTip(self.tip)

    @property
    def is_ruled(self) -> bool:
        """Return whether an expression says what the value is."""
        return expression(self.obj, self.name) is not None

    def show(self) -> None:
        """Show the property's value, without any signal."""
        with silent(self.widget):
            self._show()
        self.widget.setToolTip(tooltip(self.tip, expression(self.obj, self.name)))


class Choice(_Bound):
    """An enumeration in a combo box; the text is translated, the data is not."""

    def __init__(self, widget: Any, obj: Any, name: str) -> None:
        super().__init__(widget, obj, name)
        for value in obj.getEnumerationsOfProperty(name):
            widget.addItem(choice_text(name, value), value)

    def _show(self) -> None:
        self.widget.setCurrentIndex(self.widget.findData(getattr(self.obj, self.name)))
        self.widget.setEnabled(not self.is_ruled)

    def write(self) -> None:
        """Write the selected value."""
        if not self.is_ruled:
            set_property(self.obj, self.name, self.widget.currentData())

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return [self.widget.currentIndexChanged]


class Number(_Bound):
    """A percentage or another plain number in a spin box."""

    def __init__(self, widget: Any, obj: Any, name: str) -> None:
        super().__init__(widget, obj, name)
        scale = PERCENT if widget.suffix() else PLAIN
        self._entry = Entry(widget, obj, self.names, scale)
        self.entries = (self._entry,)

    def _show(self) -> None:
        self._entry.show(getattr(self.obj, self.name))
        self.widget.setEnabled(not self.is_ruled)

    def write(self) -> None:
        """Write the number, a whole one where the property is."""
        value = self._entry.entered()
        if value is not None and not self.is_ruled:
            is_whole = isinstance(getattr(self.obj, self.name), int)
            set_property(self.obj, self.name, round(value) if is_whole else value)

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return self._entry.signals()


class Check(_Bound):
    """Yes or no in a check box."""

    def _show(self) -> None:
        self.widget.setChecked(getattr(self.obj, self.name))
        self.widget.setEnabled(not self.is_ruled)

    def write(self) -> None:
        """Write the state."""
        if not self.is_ruled:
            set_property(self.obj, self.name, self.widget.isChecked())

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return [check_box_signal(self.widget)]


class Quantity(_Bound):
    """A length or an angle in a ``Gui::QuantitySpinBox``, with its unit and expression."""

    takes_ends = True

    def __init__(self, widget: Any, obj: Any, name: str) -> None:
        super().__init__(widget, obj, name)
        value = getattr(obj, name)
        is_length = value.Unit == FreeCAD.Units.Length
        scale = lengths() if is_length else Scale.of(value)
        self._entry = Entry(widget, obj, self.names, scale, takes_ends=self.takes_ends)
        self.entries = (self._entry,)
        widget.setProperty("binding", f"{obj.Name}.{name}")  # for expressions

    def _show(self) -> None:
        text = expression(self.obj, self.name)
        value = self.obj.evalExpression(text) if text else getattr(self.obj, self.name)
        self._entry.show(getattr(value, "Value", value))
        self.widget.setReadOnly(bool(text))

    def write(self) -> None:
        """Write the value, if another one was entered."""
        value = self._entry.entered()
        if value is not None and not self.is_ruled:
            set_property(self.obj, self.name, value)
            if not self._entry.is_typing:
                self._show()  # the arrows count in the box's unit

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return self._entry.signals()


class Between(Quantity):
    """One that must be between the limits of its box; the engine says so at an end."""

    takes_ends = False


def link_feed_tip() -> str:
    """Return the tooltip of a box for the feed of links, which is not in the property's mm/min."""
    return translate(
        "SpiralPocket",
        "Feed of moves at depth through cleared ground, 0 for the horizontal rapid rate",
    )


class LinkFeed(_Bound):
    """The feed of links in FreeCAD's unit for speeds; the property is a plain number in mm/min.

    A property of FreeCAD's type for speeds breaks the editor of every job.
    """

    def __init__(self, widget: Any, obj: Any, name: str) -> None:
        super().__init__(widget, obj, name)
        self.tip = link_feed_tip()
        widget.setToolTip(self.tip)
        self._entry = Entry(widget, obj, self.names, speeds())
        self.entries = (self._entry,)

    def _show(self) -> None:
        self._entry.show(getattr(self.obj, self.name) / MINUTE)
        self.widget.setEnabled(not self.is_ruled)

    def write(self) -> None:
        """Write the feed, if another one was entered."""
        value = self._entry.entered()
        if value is not None and not self.is_ruled:
            set_property(self.obj, self.name, value * MINUTE)

    def signals(self) -> list[Any]:
        """Return the signals that tell of a change by the user."""
        return self._entry.signals()
