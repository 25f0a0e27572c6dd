# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is typed into a spin box, read here and not by the box.

FreeCAD's and Qt's boxes take the first digits of what they cannot take whole, drop the
decimal mark of another language ("2,4" is 24), read a plain number in whatever unit just
stands there (micrometers), and round to the decimals that they show. Here a number may have
either mark, is in the user's own unit unless another one is typed, and is taken as it is or
not at all: until the box is left nothing half typed is held against the user, then the value
from before stays and the panel says why. And FreeCAD's boxes round what they hold whenever their
page is shown, which is no entry of the user's.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import FreeCAD
from PySide import QtCore, QtGui

from ..qt.names import renamed

translate = FreeCAD.Qt.translate

#: What FreeCAD raises where a text is no quantity or no expression.
UNREADABLE = (RuntimeError, ValueError, ArithmeticError, TypeError, AttributeError, NameError)
#: Digits that a value is shown with where FreeCAD's decimals hide some, and decimals at most.
DIGITS, MOST_DECIMALS = 6, 9
#: How much FreeCAD's decimals may hide, as a share, where the exact value stands in another box.
ROUNDED = 0.005
#: What a box needs beside its text, for arrows and the sign of expressions, in the font's height.
AROUND = 3.5
#: A larger length, speed or angle (mm, mm/s, deg) is a slip of the hand, whatever the box allows.
MOST = 1e6


@dataclass(frozen=True)
class Scale:
    """In what a box counts.

    Attributes
    ----------
    unit : str
        What a plain number is in, "" for nothing.
    factor : float
        How many of FreeCAD's own units (mm, deg, mm/s) that is.
    kind : FreeCAD.Units.Unit or None
        None for a plain number.
    """

    unit: str
    factor: float = 1.0
    kind: Any = None

    @classmethod
    def of(cls, example: Any) -> Scale:
        """Return the unit that the user has for quantities like this one."""
        _, factor, unit = example.getUserPreferred()
        return cls(unit, float(factor), example.Unit)

    def read(self, text: str, obj: Any) -> float | None:
        """Return the value of a number with or without a unit, or of a formula; None for neither.

        FreeCAD's parser of quantities knows ``1/16 in``, that of expressions properties.
        """
        if self.kind is None and self.unit:
            text = text.replace(self.unit, "")
        readers = [obj.evalExpression]
        if any(letter.isdigit() for letter in text):
            readers.insert(0, FreeCAD.Units.Quantity)
        for reader in readers if text.strip() else ():
            try:
                value = FreeCAD.Units.Quantity(reader(text.strip()))
            except UNREADABLE:
                continue
            if value.Unit == FreeCAD.Units.Unit():
                value = value.Value * self.factor
            elif value.Unit == self.kind:
                value = value.Value
            else:
                continue
            if math.isfinite(value):
                return float(value)
        return None

    def text(self, value: float, digits: int = DIGITS) -> str:
        """Return a value in the user's unit, with the decimals that it has, two at least."""
        number = value / self.factor
        size = math.floor(math.log10(abs(number))) if number else 0
        decimals = min(MOST_DECIMALS, max(2, digits - 1 - size))
        locale = QtCore.QLocale()
        locale.setNumberOptions(QtCore.QLocale.OmitGroupSeparator)
        text = locale.toString(number, "f", decimals)
        while decimals > 2 and text.endswith("0"):
            text, decimals = text[:-1], decimals - 1
        return f"{text}{'' if self.unit in ('', '°') else ' '}{self.unit}"


PERCENT, PLAIN = Scale("%"), Scale("")


def lengths() -> Scale:
    """Return the user's unit for a part's size."""
    return Scale.of(FreeCAD.Units.Quantity(10.0, FreeCAD.Units.Length))


def speeds() -> Scale:
    """Return the user's unit for feeds."""
    return Scale.of(FreeCAD.Units.Quantity("1 m/s"))


class Entry:
    """A spin box and what the user types into it.

    Parameters
    ----------
    box : QAbstractSpinBox
        Gets the unit of the scale; its minimum and maximum are the limits.
    obj : object
        The operation.
    names : sequence of str
        The properties that what is typed changes.
    scale : Scale
    is_exact : bool
        Whether decimals that FreeCAD rounds away are shown.
    is_positive : bool
        Whether 0 is too little.
    takes_ends : bool
        Whether to advise the limits themselves.

    Attributes
    ----------
    is_refused : bool
        Whether what was entered last cannot be taken.
    """

    def __init__(
        self,
        box: Any,
        obj: Any,
        names: Sequence[str],
        scale: Scale,
        *,
        is_exact: bool = True,
        is_positive: bool = False,
        takes_ends: bool = True,
    ) -> None:
        self.box, self._obj, self._names, self.scale = box, obj, names, scale
        self._is_exact, self._is_positive, self._takes_ends = is_exact, is_positive, takes_ends
        is_quantity = box.metaObject().indexOfProperty("rawValue") >= 0
        self._property = "rawValue" if is_quantity else "value"
        if is_quantity:
            box.setProperty("unit", scale.unit)
            box.setProperty("autoNormalize", False)  # since 1.1: would round what was typed
        box.setKeyboardTracking(False)  # would write into what is being typed
        self._line = renamed(box.findChild(QtGui.QLineEdit))
        self._line.setValidator(None)  # would swallow single keys
        self._line.textEdited.connect(self._note)
        self._line.textChanged.connect(self._show_known)
        self._known, self._typed, self._value = "", None, 0.0
        self._rounded = ""  # what the box shows for the known value of its own accord
        self._before: dict[str, Any] = {}
        self.is_refused = False

    @property
    def is_typing(self) -> bool:
        """Return whether something was typed and the box not been left."""
        return self._typed is not None

    def signals(self) -> list[Any]:
        """Return the signals after which something may have been entered."""
        return [self._line.textEdited, self.box.valueChanged]

    def show(self, value: float) -> None:
        """Show a value, or the limit beyond which it is, without any signal.

        The box would set a text that is out of its range to something else, as if that was entered.
        """
        low, high = self._limits()
        self._value = value = min(max(value, low), high)
        self._rounded = ""
        was_blocked = self.box.blockSignals(True)
        self.box.setProperty(self._property, value)
        self.box.blockSignals(was_blocked)
        text = self._line.text()
        if self.scale.kind is not None and not self._tells(text, value):
            self._set_text(self.scale.text(value, DIGITS if self._is_exact else 4))
        self._rounded = text
        self._known, self._typed, self.is_refused = self._line.text(), None, False
        self._make_room()

    def entered(self) -> float | None:
        """Return a value that was entered since the last call, None for none or a refused one."""
        text = self._line.text()
        if text == self._known or (text == self._rounded and not self.is_typing):
            return None
        self._known, self._rounded = text, ""
        if self._typed is None:  # by the arrows or the wheel
            value = float(self.box.property(self._property))
            if not self._allows(value):  # they stop there; or the box has misread what it shows
                self.show(self._value)
                return None
        elif text == self._typed:
            read = self.scale.read(text, self._obj)
            value = math.nan if read is None else read
        else:  # the box tidies up what was typed
            return None
        self.is_refused = not self._allows(value)
        if self.is_refused:
            self._restore()
            return None
        return value

    def enter(self, value: float) -> None:
        """Enter a value with all its decimals for the user, who has typed nothing."""
        text = self.scale.text(value)
        self._set_text(text)
        self._line.textEdited.emit(text)
        if not self.is_refused:
            self.show(value)

    def refusal(self) -> tuple[str, str]:
        """Return what was typed in vain and what to type instead."""
        typed = self._typed or ""
        if self.scale.kind is None and self.scale.unit:
            typed = typed.replace(self.scale.unit, "")  # which the box adds of its own accord
        return typed.strip(), self._advice(typed)

    def _advice(self, typed: str) -> str:
        low, high = self._limits()
        value = self.scale.read(typed, self._obj)
        if value is None:
            if not self.scale.unit:
                return translate("SpiralPocket", "Type a number.")
            return translate(
                "SpiralPocket", 'Type a number; where no unit is typed, it is "{}".'
            ).format(self.scale.unit)
        if high == MOST and value < low:
            return translate("SpiralPocket", "Type {} or more.").format(self.scale.text(low))
        if self._is_positive:
            return translate("SpiralPocket", "Type more than 0, at most {}.").format(
                self.scale.text(high)
            )
        advice = translate("SpiralPocket", "Type {} to {}.")
        if not self._takes_ends:
            advice = translate("SpiralPocket", "Type more than {} and less than {}.")
        return advice.format(self.scale.text(low), self.scale.text(high))

    def _note(self, text: str) -> None:
        if self._typed is None:
            values = {name: getattr(self._obj, name) for name in self._names}
            self._before = {name: getattr(v, "Value", v) for name, v in values.items()}
        self._typed = text

    def _show_known(self, text: str) -> None:
        """Show all decimals again that the box has taken away, as when its page is shown."""
        if text == self._rounded != self._known and not self.is_typing:
            self._set_text(self._known)

    def _set_text(self, text: str) -> None:
        """Show a text that the box does not get to read."""
        was_blocked = self._line.blockSignals(True)
        self._line.setText(text)
        self._line.blockSignals(was_blocked)

    def _tells(self, text: str, value: float) -> bool:
        """Return whether FreeCAD's text is in the user's unit and leaves nothing out."""
        told = self.scale.read(text, self._obj)
        if told is None:
            return False
        leeway = 10.0**-DIGITS if self._is_exact else ROUNDED
        return text.endswith(self.scale.unit) and math.isclose(told, value, rel_tol=leeway)

    def _make_room(self) -> None:
        """Let the box be wide enough for what it shows; a row that is too wide is wrapped."""
        metrics = self.box.fontMetrics()
        wide = metrics.horizontalAdvance(self._known) + int(AROUND * metrics.height())
        self.box.setMinimumWidth(max(wide, self.box.minimumWidth()))

    def _limits(self) -> tuple[float, float]:
        """Return the least and the largest value."""
        low, high = (float(self.box.property(name)) for name in ("minimum", "maximum"))
        return max(low, -MOST), min(high, MOST)

    def _allows(self, value: float) -> bool:
        low, high = self._limits()
        return low <= value <= high and not (self._is_positive and value <= 0)

    def _restore(self) -> None:
        """Take back what the first letters have set."""
        for name, value in self._before.items():
            old = getattr(self._obj, name)
            if getattr(old, "Value", old) != value:
                setattr(self._obj, name, value)
