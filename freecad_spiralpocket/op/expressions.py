# SPDX-License-Identifier: LGPL-2.1-or-later
"""Expressions that rule properties: what FreeCAD makes of their values, and which are broken."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from ..engine.errors import RequestError


def as_number(old: Any, value: float) -> Any:
    """Return what a value makes of the number or truth `old`; FreeCAD rounds."""
    return type(old)(math.floor(value + 0.5) if isinstance(old, int) else value)


def check_expressions(obj: Any) -> None:
    """Raise where an expression of an operation names what is not there.

    Raises
    ------
    RequestError
    """
    for path, expression in obj.ExpressionEngine:
        with told(path.lstrip(".")):
            obj.evalExpression(expression)


@contextmanager
def told(name: str) -> Iterator[None]:
    """Say in words what FreeCAD has against the expression of a property.

    Raises
    ------
    RequestError
    """
    try:
        yield
    except (RuntimeError, ValueError, TypeError, ArithmeticError, LookupError) as error:
        raise RequestError(
            f"The expression of {name} cannot be evaluated: {error}.", "Mend or remove it."
        ) from error
