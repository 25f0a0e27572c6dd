# SPDX-License-Identifier: LGPL-2.1-or-later
"""All floors of pockets in a part, for scripts that name none."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from ..engine.errors import SelectionError
from . import seams
from .known import Known
from .level import looks
from .selection import Floor, floor


def find_floors(model: Any) -> Iterator[Floor]:
    """Yield every floor of a pocket in `model` that is walled all around.

    Faces that meet at one height are one floor, as in an operation.
    """
    known = Known()
    shape = model.Shape
    # whether a window is a pocket only the machinist knows
    level = [(f"Face{i}", face) for i, face in enumerate(shape.Faces, 1) if looks(face) > 0]
    for names in seams.meeting(level):
        found = _walled(model, names, known, shape)
        if not found and len(names) > 1:
            found = [one for name in names for one in _walled(model, [name], known, shape)]
        yield from found


def _walled(model: Any, names: Sequence[str], known: Known, shape: Any) -> list[Floor]:
    """Return the floor that some faces are, if they are one and it is walled all around."""
    try:
        found = floor(model, names, known, shape)
    except SelectionError:
        return []
    return [] if found.open_edges else [found]
