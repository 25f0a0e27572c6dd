# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of points: how far along them each is, how they bend, what they go round.

In numpy alone, for a toolpath must load where shapely is missing.
"""

from __future__ import annotations

import numpy as np

from ..model import Floats

#: The center of three points that are nearly in line is so far off them in x and in y [mm].
FAR = 1e6


def distances_along(points: Floats) -> Floats:
    """Return how far along a polyline each of its points is, shape (n,) [mm]."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])


def unit(v: Floats) -> Floats:
    """Return the unit vector along one, shape (2,); of none, none."""
    return v / (np.hypot(*v) + 1e-12)


def cross(u: Floats, v: Floats) -> Floats:
    """Return the cross product of vectors, shape (..., 2): positive where `v` is to the left."""
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


def wrapped(angles: Floats) -> Floats:
    """Return angles less whole turns, in [-pi, pi) [rad]."""
    return (angles + np.pi) % (2 * np.pi) - np.pi


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
    doubled = cross(ab, bc)
    sides = np.prod([np.hypot(v[..., 0], v[..., 1]) for v in (ab, bc, ac)], axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        curvature = 2 * doubled / sides
    return np.where(sides > 0, curvature, np.inf)


def circumcenters(a: Floats, b: Floats, c: Floats) -> Floats:
    """Return the centers of the circles through three points each, far off where they are in line.

    Parameters
    ----------
    a, b, c : ndarray of shape (n, 2)
        [mm]

    Returns
    -------
    ndarray of shape (n, 2)
        [mm]; no farther than `FAR` from `a` in x and in y.
    """
    ab, ac = b - a, c - a
    area = cross(ab, ac)
    q, s = (ab**2).sum(axis=1), (ac**2).sum(axis=1)
    twice_area = np.where(np.abs(area) < 1e-12 * np.maximum(q, s), 1e-100, 2 * area)
    away = np.column_stack([ac[:, 1] * q - ab[:, 1] * s, ab[:, 0] * s - ac[:, 0] * q])
    return a + np.clip(away / twice_area[:, None], -FAR, FAR)
