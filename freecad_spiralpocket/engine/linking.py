# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion between cuts."""

from __future__ import annotations

import numpy as np
from shapely import LineString, Polygon

from .model import Floats

#: Radius of the arc that leaves the wall, over R; halved until it fits.
LEAVE_RADIUS = 0.3
HALVINGS = 4
#: Chords of that quarter circle.
CHORDS = 8


def leave_wall(lap: Floats, region: Polygon, cutter_radius: float) -> Floats:
    """Return a quarter circle that leaves the wall tangentially, so that lifting marks nothing.

    Parameters
    ----------
    lap : ndarray of shape (n, 2)
        The finished lap along the wall, counter-clockwise: cleared ground is on its left.
    region : shapely.Polygon
        The cutter-center region.
    cutter_radius : float
        R [mm].

    Returns
    -------
    ndarray of shape (k, 2)
        From the end of `lap`; empty where no such arc fits.
    """
    ahead = lap[-1] - lap[-2]
    ahead = ahead / np.linalg.norm(ahead)
    left = np.array([-ahead[1], ahead[0]])
    turn = np.linspace(0.0, np.pi / 2, CHORDS + 1)[:, None]
    for halving in range(HALVINGS):
        radius = LEAVE_RADIUS * cutter_radius * 0.5**halving
        arc = lap[-1] + radius * (np.sin(turn) * ahead + (1 - np.cos(turn)) * left)
        if region.buffer(1e-6).covers(LineString(arc)):
            return arc[1:]
    return np.empty((0, 2))
