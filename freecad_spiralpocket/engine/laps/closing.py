# SPDX-License-Identifier: LGPL-2.1-or-later
"""What spirals make of the wall: its corners rounded, at the end a lap along it, and off on an arc.

The last turn of a spiral comes to the wall at its end only; the lap takes the wedge
that is left, and the corners that the laps rounded off.
"""

from __future__ import annotations

import numpy as np
import shapely
from shapely import Polygon

from ..floor import Pass
from ..links.linking import come_to_wall, leave_wall
from ..model import Floats, PocketRequest
from ..shapes.polyline import ring_from, simplified
from ..shapes.region import INSET, grow
from ..toolpath import Role

#: Fillet radii of the rounded wall tried, over the step-over.
FILLETS = (4.0, 3.0, 2.4, 1.75, 1.3, 1.0, 0.7, 0.5)
#: What the rounding may leave in a corner for the closing lap, over the step-over: where the wall
#: turns at once the engagement jumps.
CORNER_BITE = 0.5
#: Detail that does not matter there [mm].
ROUGH = 0.01
#: The spline of the wall runs inside of it by no more than this over the room.
MOST_INSET = 0.25


def wall_inset(room: float) -> float:
    """Return how far inside of the wall its spline runs [mm].

    Parameters
    ----------
    room : float
        Of the cutter's center about the middle [mm].
    """
    return min(INSET, MOST_INSET * room)


def corner_fillet(region: Polygon, stepover: float) -> float:
    """Return the largest fillet that leaves the closing lap little enough in the corners [mm].

    And that goes through every neck: beyond one too narrow for it the wall would get a dent.
    """
    # arcs of a thousand points that shrink to their center take GEOS minutes
    region = shapely.simplify(region, ROUGH)
    corners = shapely.points(shapely.get_coordinates(region))
    for share in FILLETS:
        core = grow(region, -share * stepover)
        if not isinstance(core, Polygon) or core.is_empty:
            continue
        if len(core.interiors) != len(region.interiors):
            continue
        opened = grow(core, share * stepover)
        shapely.prepare(opened)
        if shapely.dwithin(opened, corners, CORNER_BITE * stepover).all():
            return share * stepover
    return FILLETS[-1] * stepover


def closing_passes(
    spiral: Floats, rounded: Floats, region: Polygon, request: PocketRequest
) -> tuple[Pass, ...]:
    """Return a spiral with its closing lap and the arc that leaves the wall.

    Parameters
    ----------
    spiral : ndarray of shape (n, 2)
        Ends where `rounded` begins [mm].
    rounded : ndarray of shape (m, 2)
        The closed last lap of the spiral; it closes the path where no finishing lap along the
        exact wall is wanted.
    region : shapely.Polygon
        The cutter-center region.
    request : PocketRequest
    """
    lap = rounded
    if request.cutting.finishing_lap:
        wall = ring_from(np.array(region.exterior.coords)[:-1], spiral[-1])
        wall = come_to_wall(wall, spiral[-1], region, request.cutter_radius)
        lap = simplified(wall, request.tolerance / 2)
    leave = leave_wall(lap, region, request.cutter_radius)
    return Pass(spiral, Role.CUT), Pass(lap, Role.FINISH), Pass(leave, Role.LINK)
