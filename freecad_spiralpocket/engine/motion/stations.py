# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places along a toolpath: from points on its moves to arc lengths, and back.

A station is the arc length from the start of the path. Feeds, speeds, forces and
engagement of one path are brought together by their stations, which stay the same when
moves are split.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from ..shapes.points import cross
from ..toolpath import Toolpath

Moves = NDArray[np.int64]


class Measured(Protocol):
    """Engagement at places along a path, in the order of travel (see `engagement`)."""

    @property
    def points(self) -> Floats:
        """Cutter centers, shape (k, 3) [mm]."""

    @property
    def angles(self) -> Floats:
        """Engagement angles, shape (k,) [rad]."""

    @property
    def chips(self) -> Floats:
        """Thickness of the thickest chip over the feed per tooth, shape (k,)."""

    @property
    def lengths(self) -> Floats:
        """Length of path each stands for, shape (k,) [mm]."""

    @property
    def moves(self) -> Moves:
        """Move of the toolpath each is on, shape (k,)."""


def ends_of(toolpath: Toolpath) -> Floats:
    """Return the station of the end of each move, shape (n,) [mm]."""
    return np.cumsum(toolpath.lengths)


def fractions_of(toolpath: Toolpath, moves: Moves, points: Floats) -> Floats:
    """Return how far along their moves points are.

    Parameters
    ----------
    toolpath : Toolpath
    moves : ndarray of int, shape (k,)
        Move of each point.
    points : ndarray of shape (k, 3)
        Points on these moves [mm].

    Returns
    -------
    ndarray of shape (k,)
        In ``[0, 1]``; 0 on moves that go nowhere.
    """
    starts, ends = toolpath.starts[moves], toolpath.points[moves]
    chords = ends - starts
    with np.errstate(invalid="ignore", divide="ignore"):
        share = np.sum((points - starts) * chords, axis=1) / np.sum(chords**2, axis=1)
    arcs = np.flatnonzero(toolpath.is_arc[moves])
    if len(arcs):
        centers, sweeps = toolpath.centers[moves[arcs]], toolpath.sweeps[moves[arcs]]
        a, b = starts[arcs, :2] - centers, points[arcs, :2] - centers
        turn = np.arctan2(cross(a, b), np.sum(a * b, axis=1))
        # a hair before the start is the start, not the end of a full turn
        turn = np.mod(turn * np.sign(sweeps) + 1e-9, 2 * np.pi) - 1e-9
        share[arcs] = turn / np.abs(sweeps)
    return np.clip(np.nan_to_num(share), 0.0, 1.0)


def stations_of(toolpath: Toolpath, moves: Moves, points: Floats) -> Floats:
    """Return the stations of points on the moves of a path, shape (k,) [mm]."""
    lengths = toolpath.lengths
    begins = np.cumsum(lengths) - lengths
    return begins[moves] + fractions_of(toolpath, moves, points) * lengths[moves]


def points_at(toolpath: Toolpath, moves: Moves, fractions: Floats) -> Floats:
    """Return the points at `fractions` of `moves`, shape (k, 3) [mm]; 1 is exactly the end."""
    starts, ends = toolpath.starts[moves], toolpath.points[moves]
    points = starts + fractions[:, None] * (ends - starts)
    arcs = np.flatnonzero(toolpath.is_arc[moves])
    if len(arcs):
        centers = toolpath.centers[moves[arcs]]
        spokes = starts[arcs, :2] - centers
        radii = np.hypot(*(ends[arcs, :2] - centers).T) - np.hypot(*spokes.T)
        radii = np.hypot(*spokes.T) + fractions[arcs] * radii
        angles = np.arctan2(spokes[:, 1], spokes[:, 0])
        angles += fractions[arcs] * toolpath.sweeps[moves[arcs]]
        points[arcs, 0] = centers[:, 0] + radii * np.cos(angles)
        points[arcs, 1] = centers[:, 1] + radii * np.sin(angles)
    return np.where(fractions[:, None] >= 1.0, ends, points)


def moves_at(toolpath: Toolpath, stations: Floats) -> Moves:
    """Return the move on which each station [mm] lies, shape (k,); the earlier one at a joint."""
    return np.minimum(np.searchsorted(ends_of(toolpath), stations), len(toolpath) - 1)
