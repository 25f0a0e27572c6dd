# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of points: how far along them each is, how they bend, what they go round.

In numpy alone, for a toolpath must load where shapely is missing.
"""

from __future__ import annotations

import numpy as np

from ..model import Floats


def distances_along(points: Floats) -> Floats:
    """Return how far along a polyline each of its points is, shape (n,) [mm]."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])


def signed_area(ring: Floats) -> float:
    """Return the area of a ring, shape (n, 2) [mm2], negative if it is clockwise."""
    x, y = ring.T
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2


def three_point_curvature(a: Floats, b: Floats, c: Floats) -> Floats:
    """Return the curvature of the circles through three points each.

    Parameters
    ----------
    a, b, c : ndarray of shape (..., 2)
        In the order of travel [mm].

    Returns
    -------
    ndarray of shape (...,)
        Positive to the left [1/mm]; infinite where two of the points are the same.
    """
    ab, bc, ac = b - a, c - b, c - a
    doubled = ab[..., 0] * bc[..., 1] - ab[..., 1] * bc[..., 0]
    sides = np.prod([np.hypot(v[..., 0], v[..., 1]) for v in (ab, bc, ac)], axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        curvature = 2 * doubled / sides
    return np.where(sides > 0, curvature, np.inf)
