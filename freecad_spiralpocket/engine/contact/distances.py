# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact distances between points, segments and circular arcs, row by row.

Every argument is an array with one row per pair, so a million pairs are one call.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from ..shapes.points import cross
from .swept import Pieces


def point_to_piece(points: Floats, pieces: Pieces, index: NDArray[np.int64]) -> Floats:
    """Return distances of points, shape (k, 2), to swept pieces, lines or arcs [mm]."""
    straight = point_to_segment(points, pieces.starts[index], pieces.ends[index])
    return np.where(pieces.is_arc[index], point_to_arc(pieces, index, points), straight)


def point_to_segment(p: Floats, a: Floats, b: Floats) -> Floats:
    """Return distances of points to segments, all of shape (k, 2) [mm]."""
    (dx, dy), (px, py) = (b - a).T, (p - a).T
    square = np.maximum(dx * dx + dy * dy, 1e-30)
    t = np.clip((px * dx + py * dy) / square, 0.0, 1.0)
    return np.hypot(px - t * dx, py - t * dy)


def segment_to_segment(a: Floats, b: Floats, c: Floats, d: Floats) -> Floats:
    """Return distances of segments ab to segments cd, 0 where they cross [mm]."""
    ends = np.minimum.reduce(
        [
            point_to_segment(a, c, d),
            point_to_segment(b, c, d),
            point_to_segment(c, a, b),
            point_to_segment(d, a, b),
        ]
    )
    crossing = (_side(a, b, c) * _side(a, b, d) < 0) & (_side(c, d, a) * _side(c, d, b) < 0)
    return np.where(crossing, 0.0, ends)


def _side(a: Floats, b: Floats, p: Floats) -> Floats:
    return cross(b - a, p - a)


def arc_to_segment(pieces: Pieces, index: NDArray[np.int64], a: Floats, b: Floats) -> Floats:
    """Return distances of circular pieces to segments ab, 0 where they cross [mm]."""
    m, rho = pieces.centers[index], pieces.radii[index]
    ends = np.minimum.reduce(
        [
            point_to_segment(pieces.starts[index], a, b),
            point_to_segment(pieces.ends[index], a, b),
            point_to_arc(pieces, index, a),
            point_to_arc(pieces, index, b),
        ]
    )
    d = b - a
    square = np.maximum((d * d).sum(axis=1), 1e-30)
    t = ((m - a) * d).sum(axis=1) / square
    foot = a + t[:, None] * d
    off = np.hypot(*(foot - m).T)
    beside = (t >= 0) & (t <= 1) & _faces(pieces, index, foot)
    ends = np.where(beside, np.minimum(ends, np.abs(off - rho)), ends)
    half = np.sqrt(np.maximum(rho * rho - off * off, 0.0)) / np.sqrt(square)
    for crossing in (t - half, t + half):
        hit = a + crossing[:, None] * d
        meets = (off <= rho) & (crossing >= 0) & (crossing <= 1) & _faces(pieces, index, hit)
        ends = np.where(meets, 0.0, ends)
    return ends


def point_to_arc(pieces: Pieces, index: NDArray[np.int64], p: Floats) -> Floats:
    """Return distances of points, shape (k, 2), to circular pieces [mm]."""
    ends = np.minimum(
        np.hypot(*(p - pieces.starts[index]).T), np.hypot(*(p - pieces.ends[index]).T)
    )
    off = np.abs(np.hypot(*(p - pieces.centers[index]).T) - pieces.radii[index])
    return np.where(_faces(pieces, index, p), np.minimum(off, ends), ends)


def _faces(pieces: Pieces, index: NDArray[np.int64], p: Floats) -> NDArray[np.bool_]:
    """Return which points lie in the sector of their circular piece."""
    v = p - pieces.centers[index]
    sweep = pieces.sweeps[index]
    turn = np.mod((np.arctan2(v[:, 1], v[:, 0]) - pieces.angles[index]) * np.sign(sweep), 2 * np.pi)
    return turn <= np.abs(sweep)
