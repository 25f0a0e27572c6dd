# SPDX-License-Identifier: LGPL-2.1-or-later
"""Paths whose curvature is piecewise linear in the arc length: clothoids, arcs, straights [EAS07].

A path is its start, its heading there, and its curvature at the joints of its pieces.
The heading is the curvature's integral, a quadratic; the points are the integrals of
its cosine and sine (the Fresnel integrals of the paper), by Gauss's rule to rounding.

The corner between two rays is turned by a *bi-clothoid*: the curvature rises
linearly from 0 and falls back to 0, both rays are met tangentially, and nothing jumps.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..model import Floats
from ..shapes.points import wrapped

#: Points of Gauss's rule, and the most turning over which it is used at once [rad].
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_TURN = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class ClothoidPath:
    """A plane path with piecewise linear, continuous curvature.

    Attributes
    ----------
    start : ndarray of shape (2,)
        [mm]
    heading : float
        At the start, from the X axis [rad].
    lengths : ndarray of shape (n,)
        Of the pieces [mm], positive.
    curvatures : ndarray of shape (n + 1,)
        At the joints and both ends, positive to the left [1/mm].
    """

    start: Floats
    heading: float
    lengths: Floats
    curvatures: Floats

    @property
    def length(self) -> float:
        """Return the length of the path [mm]."""
        return float(self.lengths.sum())

    @property
    def joints(self) -> Floats:
        """Return the arc lengths of the joints, both ends included, shape (n + 1,) [mm]."""
        return np.concatenate([[0.0], np.cumsum(self.lengths)])

    def curvature_at(self, s: Floats) -> Floats:
        """Return the curvature at arc lengths [mm], of the same shape [1/mm]."""
        return np.interp(s, self.joints, self.curvatures)

    def heading_at(self, s: Floats) -> Floats:
        """Return the heading at arc lengths [mm], of the same shape [rad]."""
        joints, k = self.joints, self.curvatures
        whole = np.concatenate([[0.0], np.cumsum(self.lengths * (k[1:] + k[:-1]) / 2)])
        piece = np.clip(np.searchsorted(joints, s, side="right") - 1, 0, len(self.lengths) - 1)
        gone = s - joints[piece]
        return self.heading + whole[piece] + gone * (k[piece] + self.curvature_at(s)) / 2

    def points_at(self, s: Floats) -> Floats:
        """Return the points at ascending arc lengths, shape (m,) [mm], as shape (m, 2) [mm]."""
        knots = np.unique(np.concatenate([self.joints, s]))
        bend = np.abs(self.curvature_at(knots))
        turn = np.diff(knots) * np.maximum(bend[1:], bend[:-1])
        counts = np.maximum(1, np.ceil(turn / _TURN)).astype(int)
        first = np.concatenate([[0], np.cumsum(counts)])
        edges = np.interp(np.arange(first[-1] + 1), first, knots)
        half, middle = np.diff(edges) / 2, (edges[1:] + edges[:-1]) / 2
        heading = self.heading_at(middle[:, None] + half[:, None] * _NODES)
        steps = half[:, None] * np.column_stack(
            [np.cos(heading) @ _WEIGHTS, np.sin(heading) @ _WEIGHTS]
        )
        points = self.start + np.vstack([np.zeros((1, 2)), np.cumsum(steps, axis=0)])
        return points[first[np.searchsorted(knots, s)]]

    def sampled(self, tolerance: float) -> Floats:
        """Return points whose chords keep within `tolerance` of the path, both ends included.

        Of shape (m, 2), all in mm.
        """
        counts = [
            max(1, int(np.ceil(length * np.sqrt(bend / (8 * tolerance)))))
            for length, bend in zip(
                self.lengths,
                np.maximum(np.abs(self.curvatures[1:]), np.abs(self.curvatures[:-1])),
                strict=True,
            )
        ]
        joints = self.joints
        s = [
            np.linspace(a, b, n, endpoint=False)
            for a, b, n in zip(joints, joints[1:], counts, strict=False)
        ]
        return self.points_at(np.append(np.concatenate(s), joints[-1]))

    def then(self, length: float, curvature: float) -> ClothoidPath:
        """Return this path with one more piece, at whose end the curvature is `curvature`.

        Its `length` is in mm, the curvature in 1/mm.
        """
        return ClothoidPath(
            self.start,
            self.heading,
            np.append(self.lengths, length),
            np.append(self.curvatures, curvature),
        )

    def then_back(self, other: ClothoidPath) -> ClothoidPath:
        """Return this path and then another one, run backwards, that ends where this one does."""
        return ClothoidPath(
            self.start,
            self.heading,
            np.concatenate([self.lengths, other.lengths[::-1]]),
            np.concatenate([self.curvatures, -other.curvatures[-2::-1]]),
        )


def begin(start: Floats, heading: float, curvature: float = 0.0) -> ClothoidPath:
    """Return a path without any pieces yet.

    Parameters
    ----------
    start : ndarray of shape (2,)
        [mm]
    heading : float
        [rad]
    curvature : float, optional
        [1/mm]
    """
    return ClothoidPath(np.asarray(start, float), heading, np.empty(0), np.array([curvature]))


def tangent_share(turn: Floats) -> Floats:
    """Return the length of each ray that a bi-clothoid takes, over the length of half of it.

    Parameters
    ----------
    turn : ndarray of any shape
        Angle between the rays [rad], in ``(-pi, pi)``.

    Returns
    -------
    ndarray of the same shape
    """
    x, y = half_corner(np.abs(turn), np.ones(1))
    return np.asarray(x[..., 0] + y[..., 0] * np.tan(np.abs(turn) / 2))


def half_corner(turn: Floats, u: Floats) -> tuple[Floats, Floats]:
    """Return places on the first half of a bi-clothoid, for half of it of length 1.

    Its curvature rises from 0 to `turn`, its heading from 0 to half of it. It starts at the
    origin along the X axis.

    Parameters
    ----------
    turn : ndarray of shape (...)
        [rad]
    u : ndarray of shape (k,)
        Arc lengths in [0, 1].

    Returns
    -------
    x, y : ndarray of shape (..., k)
    """
    t = u[:, None] * (_NODES + 1) / 2
    heading = np.asarray(turn)[..., None, None] * t**2 / 2
    return (
        u / 2 * (np.cos(heading) @ _WEIGHTS),
        u / 2 * (np.sin(heading) @ _WEIGHTS),
    )


def through(path: ClothoidPath, corners: Floats, tangents: Sequence[float]) -> ClothoidPath:
    """Return a path that goes on along a polyline, each corner turned by a bi-clothoid.

    Parameters
    ----------
    path : ClothoidPath
        Ends at the polyline's first point along its first edge, with curvature 0.
    corners : ndarray of shape (n + 2, 2)
        The polyline [mm].
    tangents : sequence of float
        How much of the edges before and after each of the n corners the bi-clothoids take [mm].
    """
    edges = np.diff(corners, axis=0)
    lengths = np.hypot(edges[:, 0], edges[:, 1])
    headings = np.arctan2(edges[:, 1], edges[:, 0])
    turns = wrapped(np.diff(headings))
    taken = np.concatenate([[0.0], tangents, [0.0]])
    for i, length in enumerate(lengths):
        straight = length - taken[i] - taken[i + 1]
        if straight > 1e-9:
            path = path.then(float(straight), 0.0)
        if i < len(turns) and taken[i + 1] > 0:
            half = float(taken[i + 1] / tangent_share(turns[i]))
            path = path.then(half, float(turns[i] / half)).then(half, 0.0)
    return path
