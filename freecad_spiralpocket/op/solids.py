# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are closed but no solids, and solids that are inside out, as solids.

Meshes become closed shells, surfaces of IGES files are faces that only lie side by side, and
a solid may have been turned so that its faces look inwards.
"""

from __future__ import annotations

from typing import Any

import Part

from .known import Known


def solids_of(shape: Any, known: Known | None = None) -> list[Any]:
    """Return the solids of a part, their faces looking outwards.

    Parameters
    ----------
    shape : Part.Shape
    known : Known, optional
        Is added to.
    """
    found = {} if known is None else known.solids
    key = shape.hashCode()
    if key not in found:
        solids = shape.Solids or closed(shape)
        found[key] = shape, [_outside_out(solid) for solid in solids]
    return list(found[key][1])


def closed(shape: Any) -> list[Any]:
    """Return the solids that the shells of a shape without solids are, or its faces when sewn."""
    shells = [shell for shell in shape.Shells if shell.isClosed()]
    if not shells and shape.Faces:
        sewn = shape.copy()
        sewn.sewShape()
        shells = [shell for shell in sewn.Shells if shell.isClosed()]
    return [Part.Solid(shell) for shell in shells]


def _outside_out(solid: Any) -> Any:
    return solid.reversed() if solid.Orientation == "Reversed" and solid.Volume < 0 else solid
