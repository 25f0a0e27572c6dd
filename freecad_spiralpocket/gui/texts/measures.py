# SPDX-License-Identifier: LGPL-2.1-or-later
"""How figures read: times, lengths and areas in the user's unit; and what stands for them."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

import FreeCAD
from PySide import QtCore

translate = FreeCAD.Qt.translate

#: In a sentence: a length or an area, and a coordinate of a place.
_MEASURE = re.compile(r"(-?\d+(?:[.,]\d+)?(?:e-?\d+)?) mm(2?)(?![A-Za-z0-9/])")
_COORDINATE = re.compile(r"\b([XYZ])(-?\d+(?:[.,]\d+)?)\b")


#: What clearly passes a limit, or stays uncut, is written in this color.
ALARM = "#d9432f"


def small(value: float) -> str:
    """Return a length [mm] in the unit the user has for a part's size.

    FreeCAD's own text would turn a gouge of nothing but rounding into nanometers.
    """
    factor, unit = _user_unit()
    return f"{decimal(value / factor, 3 if factor < 20 else 4)} {unit}"


def length(value: float) -> str:
    """Return a length [mm] in the user's unit, a long one in meters where that is metric."""
    if value < 1000 or not _user_unit()[1].endswith("m"):
        return str(FreeCAD.Units.Quantity(value, FreeCAD.Units.Length).UserString)
    return f"{decimal(value / 1000, 2)} m"


def area(value: float) -> str:
    """Return an area [mm2] in the unit the user has for a part's size, by three digits or whole."""
    factor, unit = _user_unit()
    number = value / factor**2
    size = math.floor(math.log10(number)) if number > 0 else 0
    finest = 2 if factor < 20 else 4
    digits = min(finest, max(0, 2 - size))
    text = decimal(number, digits)
    return f"{_short(text) if digits else text} {unit}²"


def alarming(text: str) -> str:
    """Return a text as HTML in the color of what the machinist must not overlook."""
    return f'<span style="color:{ALARM}">{text}</span>'


def feed_unit() -> tuple[float, str]:
    """Return how many mm/min the user's unit of feeds is, and its name."""
    factor, unit = _user_unit()
    return (1.0, "mm/min") if unit.endswith("m") else (factor, f"{unit}/min")


def duration(seconds: float) -> str:
    """Return e.g. ``1 h 02 min``, ``3 min 05 s``, ``12 s``; unknown for 0."""
    whole = round(seconds)
    if not seconds:
        return translate("SpiralPocket", "unknown")
    if whole >= 3600:
        return f"{whole // 3600} h {whole // 60 % 60:02d} min"
    if whole >= 60:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole} s"


def switched_off() -> str:
    """Return what to say in place of the path of an operation that is not active."""
    return translate("SpiralPocket", "Switched off: no path until Active is set again.")


def decimal(value: float, digits: int) -> str:
    """Return a number with the user's decimal mark."""
    return f"{value:.{digits}f}".replace(".", str(QtCore.QLocale().decimalPoint()))


def _user_unit() -> tuple[float, str]:
    """Return the unit that the user has for a part's size, and how many mm it is."""
    _, factor, unit = FreeCAD.Units.Quantity(10.0, FreeCAD.Units.Length).getUserPreferred()
    return float(factor), "in" if unit == '"' else unit


def in_user_unit(text: str) -> str:
    """Return a text with the lengths, areas and places in it [mm] in the user's unit."""
    factor, unit = _user_unit()
    if unit == "mm":
        return text
    digits = 2 + math.ceil(math.log10(factor))

    def measure(found: re.Match[str]) -> str:
        power = 2 if found[2] else 1
        value = decimal(_number(found[1]) / factor**power, digits)
        return f"{_short(value)} {unit}{'²' if found[2] else ''}"

    def coordinate(found: re.Match[str]) -> str:
        return found[1] + decimal(_number(found[2]) / factor, digits - 1)

    return _COORDINATE.sub(coordinate, _MEASURE.sub(measure, text))


def _number(text: str) -> float:
    return float(text.replace(",", "."))


def _short(number: str) -> str:
    """Return a decimal number without the zeros at its end."""
    return number.rstrip("0").rstrip(".,")


def as_table(figures: Sequence[tuple[str, str]]) -> str:
    """Return figures as HTML, for one label: FreeCAD may abort when labels come and go.

    Names and values may be HTML themselves.
    """
    rows = (f"<tr><td>{n}&nbsp;</td><td align=right>{v}</td></tr>" for n, v in figures)
    return f"<table width=100%>{''.join(rows)}</table>"
