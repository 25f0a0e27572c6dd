# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operation as its next recompute will see it, without recomputing anything.

Depths and heights are expressions over values that FreeCAD brings up to date in a
recompute only (`OpStartDepth`, `OpToolDiameter` and so on): right after an operation
was made or its tool changed they are stale. Here these values are taken from stock,
floors and tool as they are now, and every expression is evaluated with them. The
document is only read.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, NamedTuple

import FreeCAD

from ..engine.errors import SpiralPocketError
from ..engine.model import Notice, PocketRequest
from . import selection
from .compat import parent_job
from .expressions import as_number, told
from .known import Known
from .pockets import Pockets


class Foresight:
    """Stands in for an operation where only its properties are read.

    Raises
    ------
    SpiralPocketError
        If the next recompute could not begin: no job, no tool.
    """

    def __init__(self, obj: Any) -> None:
        obj.Proxy.check_setup(obj)
        self._obj = obj
        self._values = {k: FreeCAD.Units.Quantity(v, FreeCAD.Units.Length) for k, v in _now(obj)}
        for path, expression in obj.ExpressionEngine:
            name, *part = path.lstrip(".").split(".")  # StartPoint.x, or .StartPoint.x
            if hasattr(obj, name):
                self._values[name] = self._evaluated(name, part, expression)

    def __getattr__(self, name: str) -> Any:
        """Return a property's value to come."""
        values = self.__dict__["_values"]
        return values[name] if name in values else getattr(self.__dict__["_obj"], name)

    def _evaluated(self, name: str, part: Sequence[str], expression: str) -> Any:
        """Return what an expression will make of a property, or of a part of one, in its type."""

        def value_of(match: re.Match[str]) -> str:
            value = self._values.get(match.group())
            return match.group() if value is None else f"({value.Value!r} mm)"

        with told(name):
            value = self._obj.evalExpression(re.sub(r"\b(?<!\.)Op[A-Z]\w*\b", value_of, expression))
            return self._converted(name, part, getattr(value, "Value", value))

    def _converted(self, name: str, part: Sequence[str], value: Any) -> Any:
        """Return what a property is after FreeCAD has written a value to it, or to its part."""
        now = getattr(self, name)
        if part:
            point = FreeCAD.Vector(now)
            setattr(point, part[0], float(value))
            return point
        if hasattr(now, "Unit"):
            return FreeCAD.Units.Quantity(value, now.Unit)
        if isinstance(now, str):  # of an enumeration, which takes a number as well
            choices = self._obj.getEnumerationsOfProperty(name)
            return choices[choices.index(value) if isinstance(value, str) else int(value)]
        return as_number(now, value)


class Foreseen(NamedTuple):
    """What the next recompute will ask for.

    Attributes
    ----------
    requests : list of PocketRequest or SpiralPocketError
        One for each selected floor.
    notices : list of Notice
    labels : list of str
        What the user calls each floor.
    """

    requests: list[PocketRequest | SpiralPocketError]
    notices: list[Notice]
    labels: list[str]


def requests_of(obj: Any, known: Known | None = None) -> Foreseen:
    """Return what the next recompute will ask for.

    Parameters
    ----------
    obj : object
        The operation.
    known : Known, optional
        See `Pockets`.

    Raises
    ------
    SpiralPocketError
        If it could not begin: no job, no tool, no face.
    """
    pockets = Pockets(Foresight(obj), known=known)
    found = pockets.requests()
    notices = pockets.foreseen_notices(found)
    return Foreseen([each.wanted for each in found], notices, [each.label for each in found])


def _now(obj: Any) -> list[tuple[str, float]]:
    """Return what the recompute will set of its own accord [mm]."""
    tool = obj.ToolController.Proxy.getTool(obj.ToolController)
    depths = selection.depth_limits(obj.Base, parent_job(obj).Stock.Shape.BoundBox)
    return [("OpToolDiameter", float(tool.Diameter)), *depths.items()]
