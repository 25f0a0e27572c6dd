# SPDX-License-Identifier: LGPL-2.1-or-later
"""Growing fronts only where they still have room to go.

Once all but a few rooms beyond necks is visited, a step of the whole front would move next to
nothing of it, in a large pocket with many islands for most of the time.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import shapely
from shapely import Polygon

from ..shapes.region import polygons_of
from ..shapes.shaping import clipped, grow_coarsely, largest, oriented

#: A room's part of the front overlaps what is visited by this [mm].
OVERLAP = 0.01


def grown_locally(
    step: Callable[[Polygon, Polygon], Polygon],
    visited: Polygon,
    omega: Polygon,
    rooms: Sequence[Polygon],
    around: float,
) -> Polygon:
    """Return the region visited after a step into each room.

    Parameters
    ----------
    step : callable
        Returns what is visited next, of a visited region and a cutter-center region.
    visited, omega : shapely.Polygon
        The region visited before; the cutter-center region.
    rooms : sequence of shapely.Polygon
        Pieces of what is left.
    around : float
        Of the ground around a room so much is looked at [mm].
    """
    taken = [
        shapely.intersection(step(*_view(visited, omega, room, around)), _wider(room))
        for room in rooms
    ]
    return oriented(largest(shapely.union_all([visited, *taken])))


def _view(
    visited: Polygon, omega: Polygon, room: Polygon, around: float
) -> tuple[Polygon, Polygon]:
    """Return both regions as far as they matter for a room; all where that is in pieces."""
    x0, y0, x1, y1 = room.bounds
    window = x0 - around, y0 - around, x1 + around, y1 + around
    found = []
    for region in (visited, omega):
        parts = polygons_of(clipped(region, window))
        parts = [part for part in parts if part.distance(room) < OVERLAP]
        if len(parts) != 1:
            return visited, omega
        found.append(oriented(parts[0]))
    return found[0], found[1]


def _wider(room: Polygon) -> shapely.Geometry:
    return grow_coarsely(room, OVERLAP)
