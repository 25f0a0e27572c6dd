# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a ring is best left for the next lap: where it is straight, and that lap beside it."""

from __future__ import annotations

import numpy as np
import shapely
from shapely import LineString, Polygon

from ..model import Floats
from ..shapes.points import distances_along
from ..shapes.polyline import points_at
from ..shapes.shaping import closing_of

#: A wall that bends less than this is as good as straight to begin a spiral at [rad].
STRAIGHT = 0.4


def straightest(ring: LineString, window: float, radius: float) -> float:
    """Return where along a ring the next `window` [mm] bends least, not in a notch.

    A notch is as narrow as a cutter of `radius` [mm] in a cutter-center region.
    """
    at = np.linspace(0, ring.length, 200, endpoint=False)
    bent = bends(ring, at, window)
    best = int(np.argmin(bent))
    around = closing_of(Polygon(ring), 2 * radius).boundary
    places = shapely.points(points_at(ring, at))
    if around.distance(places[best]) > radius:
        bent = np.where(shapely.dwithin(places, around, radius), bent, np.inf)
        best = int(np.argmin(bent))
    return float(at[best])


def bends(ring: LineString, at: Floats, window: float) -> Floats:
    """Return by how much a closed ring bends from each of some places on [rad].

    Parameters
    ----------
    ring : LineString
        Closed.
    at : ndarray of shape (n,)
        Places along it [mm].
    window : float
        Bends over so much count, left and right alike [mm].

    Returns
    -------
    ndarray of shape (n,)
        0 or more, to 3 decimals: so what is straight but for rounding is equally straight.
    """
    coords = shapely.get_coordinates(ring)
    heading = np.unwrap(np.arctan2(*np.diff(coords, axis=0).T[::-1]))
    along = distances_along(coords)
    # a closed ring turns once, one way or the other
    turn = 2 * np.pi if shapely.is_ccw(ring) else -2 * np.pi

    def heading_at(s: Floats) -> Floats:
        turns = np.floor(s / ring.length)
        edge = np.clip(
            np.searchsorted(along, s % ring.length, side="right") - 1, 0, len(heading) - 1
        )
        return heading[edge] + turn * turns

    total = sum(
        np.abs(heading_at(at + (i + 1) * window / 6) - heading_at(at + i * window / 6))
        for i in range(6)
    )
    return np.round(total, 3)
