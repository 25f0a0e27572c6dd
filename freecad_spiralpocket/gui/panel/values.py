# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an operation was when its panel was opened, to tell whether it is still that."""

from __future__ import annotations

from typing import Any

import Part
import Path

from ...op.compat import parent_job

#: Whatever is done to these is not the panel's doing; expressions are kept by themselves.
OTHERS = {"Label", "Label2", "Visibility", "Proxy", "ExpressionEngine"}


class Values:
    """All properties of an operation and the expressions that rule them."""

    def __init__(self, obj: Any) -> None:
        self._obj = obj
        self._values = {n: getattr(obj, n) for n in obj.PropertiesList if n not in OTHERS}
        self._expressions = list(obj.ExpressionEngine)

    @property
    def are_kept(self) -> bool:
        """Return whether all is as it was, but for path and shapes, which come of the rest."""
        if self._obj.ExpressionEngine != self._expressions:
            return False
        made = (Path.Path, Part.Shape)
        known = ((n, v) for n, v in self._values.items() if not isinstance(v, made))
        return all(getattr(self._obj, name) == value for name, value in known)

    def bring_back(self) -> None:
        """Set all as it was, path and shapes too, and have the job add up its times anew."""
        for path, _ in self._obj.ExpressionEngine:
            self._obj.setExpression(path, None)
        for name, value in self._values.items():
            if getattr(self._obj, name) != value:
                setattr(self._obj, name, value)
        for path, text in self._expressions:
            self._obj.setExpression(path, text)
        job = parent_job(self._obj)
        if job is not None:
            job.Proxy.getCycleTime()
