# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our options in FreeCAD's setup sheet and in job templates, read as they are meant.

FreeCAD takes any text for yes, fails on a choice that it does not know, in the middle of
making a job, and writes lengths into templates with the decimals that are shown.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import FreeCAD

from . import properties
from .compat import PathSetupSheet

LENGTHS = ("App::PropertyLength", "App::PropertyDistance")
#: A length in the sheet is a text, of which FreeCAD's templates take all.
_TEXT = "App::PropertyString"
_Quantity = FreeCAD.Units.Quantity


def mend(prototype: Any) -> None:
    """Let the setup sheet read and write our options by a prototype as they are meant."""
    for p in properties.TABLE:
        if p.type == "App::PropertyBool":
            prototype.getProperty(p.name).valueFromString = "True".__eq__
        elif p.choices:
            prop = prototype.getProperty(p.name)
            prop.valueFromString = partial(_choice_of, p)
            prop.setupProperty = partial(_set_choice, prop, p)
        elif p.type in LENGTHS:
            prop = prototype.getProperty(p.name)
            prop.valueFromString = partial(_length_of, p)
            prop.setValue = partial(_show_length, prop)
            prop.setupProperty = partial(_set_length, prop)


def renew(sheet: Any, obj: Any, operation: str) -> None:
    """Let a new operation take what the sheet of its job says, with choices of other releases."""
    for p in properties.TABLE:
        name = PathSetupSheet.OpPropertyName(operation, p.name)
        if p.choices and hasattr(sheet, name):
            properties.renew_choices(sheet, name, p)
            setattr(obj, p.name, properties.offered(p, getattr(sheet, name)))


def _choice_of(p: properties.Property, text: str) -> str:
    return text if text in properties.offered(p, text) else str(p.default)


def _set_choice(
    prop: Any, p: properties.Property, sheet: Any, name: str, category: str, value: str
) -> bool:
    """Do what FreeCAD's ``setupProperty`` does, for any value; return whether it was added."""
    is_new = not hasattr(sheet, name)
    if is_new:
        sheet.addProperty(prop.propType, name, category, prop.info)
    setattr(sheet, name, properties.offered(p, value))
    setattr(sheet, name, value)
    return is_new


def _length_of(p: properties.Property, text: str) -> Any:
    """Return a length, the default for what is none or was rounded to nothing."""
    try:
        length = _Quantity(text)
    except (ValueError, ArithmeticError, RuntimeError, OSError):
        length = None
    return length if length is not None and length.Value else _Quantity(p.default)


def _show_length(prop: Any, value: Any) -> None:
    """Take a length from the sheet, for the job's editor."""
    prop.value = _Quantity(value)


def _set_length(prop: Any, sheet: Any, name: str, category: str, value: Any) -> bool:
    """Do what FreeCAD's ``setupProperty`` does; return whether the property was added."""
    if hasattr(sheet, name) and sheet.getTypeIdOfProperty(name) != _TEXT:
        sheet.removeProperty(name)
    is_new = not hasattr(sheet, name)
    if is_new:
        sheet.addProperty(_TEXT, name, category, prop.info)
    setattr(sheet, name, f"{_Quantity(value).Value!r} mm")
    return is_new
