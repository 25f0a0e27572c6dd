# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a spiral ends: a closing lap along the wall, and off the wall on an arc.

The last turn of a spiral comes to the wall at its end only; the lap takes the wedge
that is left, and the corners that the laps rounded off.
"""

from __future__ import annotations

import numpy as np
from shapely import Polygon

from ..floor import Pass
from ..linking import leave_wall
from ..model import Floats, PocketRequest
from ..polyline import ring_from, simplified
from ..toolpath import Role


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
        lap = simplified(wall, request.tolerance / 2)
    leave = leave_wall(lap, region, request.cutter_radius)
    return Pass(spiral, Role.CUT), Pass(lap, Role.FINISH), Pass(leave, Role.LINK)
