# SPDX-License-Identifier: LGPL-2.1-or-later
"""One way to open a region, and how deep a slot's levels are."""

from __future__ import annotations

from dataclasses import dataclass

from shapely import LineString, Polygon

from ..floor import WayDown
from ..model import PocketRequest

#: A slot's axial bite over D at most.
DEEPEST_BITE = 0.3


@dataclass(frozen=True, slots=True, eq=False)
class Start:
    """One way to open a region.

    Attributes
    ----------
    name : str
    visited : shapely.Polygon
        Where the cutter's center has been, or could go without cutting, after the entry; ringed
        islands are filled.
    omega : shapely.Polygon
        The region to grow in, ringed islands filled.
    entry : WayDown
    ring : LineString
        The entry's last lap, closed, from where the entry ends, stock on its right.
    within : shapely.Polygon or None
        Where fronts do not end at the outer wall: all of the cutter-center region that they
        reach. What is left of the region is corners.
    idle : tuple of shapely.Polygon
        Other ground in `omega` where the center could go without cutting, once it gets there.
    plain : Start or None
        The same without stairs, if this has some. What of `visited` is not visited in that is not
        yet open down to the floor: a first lap clears it.
    is_sure : bool
        Whether stairs need no comparison with that.
    fronts : tuple of shapely.Polygon
        The first fronts from `visited`, if they are known.
    """

    name: str
    visited: Polygon
    omega: Polygon
    entry: WayDown
    ring: LineString
    within: Polygon | None = None
    idle: tuple[Polygon, ...] = ()
    plain: Start | None = None
    is_sure: bool = True
    fronts: tuple[Polygon, ...] = ()


def slot_bite(request: PocketRequest) -> float:
    """Return the axial depth of a slot's levels [mm].

    By default a full slot of that depth removes as much as the step-over at the full depth.
    """
    if request.entry.slot_bite > 0:
        return request.entry.slot_bite
    return min(equal_bite(request), DEEPEST_BITE * request.tool_diameter)


def equal_bite(request: PocketRequest) -> float:
    """Return the axial depth of a full slot that removes as much as the step-over does [mm]."""
    return request.cutting.stepover * request.axial_depth / request.tool_diameter
