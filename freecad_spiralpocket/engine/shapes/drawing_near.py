# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways that draw near to what is beside them bit by bit.

A step aside would be two corners, at each of which the cutter stops.
"""

from __future__ import annotations

import numpy as np

from ..model import Floats
from .points import distances_along


def s_curve(u: Floats) -> Floats:
    """Return what rises from 0 to 1 with `u` along a cubic, level at both ends."""
    u = np.clip(u, 0.0, 1.0)
    return u * u * (3 - 2 * u)


def drawn_to(way: Floats, place: Floats, over: float, *, at_end: bool = False) -> Floats:
    """Return a way that begins at a place beside its first point, or ends at one beside its last.

    Parameters
    ----------
    way : ndarray of shape (n, 2)
        In chords much shorter than `over` [mm].
    place : ndarray of shape (2,)
        [mm]
    over : float
        From so far along the way on, or up to there, it stays as it is [mm].
    at_end : bool
        Whether the last point is moved, not the first.

    Returns
    -------
    ndarray of shape (n, 2)
    """
    along = distances_along(way)
    off = along[-1] - along if at_end else along
    aside = place - way[-1 if at_end else 0]
    drawn: Floats = way + (1 - s_curve(off / max(over, 1e-9)))[:, None] * aside
    drawn[-1 if at_end else 0] = place
    return drawn
