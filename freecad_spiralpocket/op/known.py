# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found out about parts and pockets, kept from one look at the operation to the next.

While values are typed in the panel everything is asked again and again; what was read off the
model is found here again as long as its shape is the same. Shapes are told apart by FreeCAD's hash
codes, and kept with what is known of them: the code of one that is gone may become another's.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import shapely

    from ..engine.toolpath import Toolpath
    from .adjacency import Adjacency
    from .open_sides import OpenSides
    from .selection import Floor
    from .walls import Walls
    from .windows import Windows


@dataclass(eq=False)
class Known:
    """What was found out, by what it depends on.

    Attributes
    ----------
    solids : dict of (Part.Shape, list of Part.Solid)
        By the hash code of the shape.
    adjacency : dict of Adjacency
    windows : dict of Windows
        By the hash code of the solid.
    floors : dict of Floor
    walls : dict of Walls
    open_sides : dict of OpenSides
    paths : dict of Toolpath or None
        By the program of an earlier operation; None where it clears no floors.
    rests : dict of shapely.Geometry
        What earlier operations leave.
    """

    solids: dict[int, tuple[Any, list[Any]]] = field(default_factory=dict)
    adjacency: dict[int, Adjacency] = field(default_factory=dict)
    windows: dict[int, Windows] = field(default_factory=dict)
    floors: dict[Hashable, Floor] = field(default_factory=dict)
    walls: dict[Hashable, Walls] = field(default_factory=dict)
    open_sides: dict[Hashable, OpenSides] = field(default_factory=dict)
    paths: dict[str, Toolpath | None] = field(default_factory=dict)
    rests: dict[Hashable, shapely.Geometry] = field(default_factory=dict)

    @property
    def count(self) -> int:
        """Return how many things are known."""
        return sum(len(getattr(self, each.name)) for each in fields(self))
