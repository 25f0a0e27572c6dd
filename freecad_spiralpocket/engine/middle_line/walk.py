# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two-sided walk round a pruned medial axis, aligned with the wall [LM15, section 3.2].

Each edge of the axis parts two places of the wall, one on either side. Put in the
order in which the wall passes those places, the edges make the walk: out along one
side of every branch and back along the other. A place of the wall thereby
belongs to one of the axis, and the rulings between such partners never cross.
The wall about a pruned branch, between two such places, belongs to where that
branch began: its rulings fan out from there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from scipy.ndimage import gaussian_filter1d
from scipy.spatial import cKDTree

from ..model import Floats
from ..shapes.points import wrapped
from ..shapes.polyline import points_at
from ..shapes.skeleton import Skeleton

#: Places of the wall at which the walk is kept, evenly spaced [mm].
SPACING = 0.2


@dataclass(frozen=True, slots=True, eq=False)
class Walk:
    """Places along a wall and their partners on the axis, in step.

    Attributes
    ----------
    wall, partners : ndarray of shape (n, 2)
        Evenly spaced in the length of both together; the first is not repeated [mm].
    """

    wall: Floats
    partners: Floats

    def samples(self, length: float, turn: float) -> tuple[Floats, Floats]:
        """Return fewer places and partners, spaced by the length and the turning of the wall.

        Parameters
        ----------
        length : float
            Between samples where wall and walk are straight, in the length of both [mm].
        turn : float
            Turning of the wall between samples in a tight bend [rad].
        """
        steps = np.roll(self.wall, -1, axis=0) - self.wall
        bend = np.abs(_turning(steps))
        along = np.hypot(*steps.T) + np.hypot(
            *(np.roll(self.partners, -1, axis=0) - self.partners).T
        )
        effort = along / length + (bend + np.roll(bend, -1)) / 2 / turn
        # a spline through points whose spacing jumps oscillates
        effort = gaussian_filter1d(effort, length / along.mean() / 2, mode="wrap")
        total = np.concatenate([[0.0], np.cumsum(effort)])
        count = max(8, int(np.ceil(total[-1])))
        at = np.interp(np.arange(count) * total[-1] / count, total, np.arange(len(total)))
        return _at(self.wall, at), _at(self.partners, at)


def walk_round(
    wall: Floats, axis: Skeleton, edges: Sequence[tuple[int, int]], smoothing: float
) -> Walk:
    """Return the walk round what is left of an axis, in step with the wall.

    Parameters
    ----------
    wall : ndarray of shape (n, 2)
        Closed, first and last point are the same [mm].
    axis : Skeleton
    edges : sequence of (int, int)
        What is left of the axis, as `skeleton.peel` returns it; at least one.
    smoothing : float
        The walk is smoothed over this length [mm].
    """
    line = shapely.LineString(wall)
    kept = {tuple(sorted(edge)) for edge in edges}
    mask = np.array([tuple(sorted(edge)) in kept for edge in axis.edges.tolist()])
    middles = axis.nodes[axis.edges[mask]].mean(axis=1)
    middles, places = np.repeat(middles, 2, axis=0), axis.walls[mask].reshape(-1, 2)
    count = max(16, int(np.ceil(line.length / SPACING)))
    even = np.arange(count) * line.length / count
    along = even[cKDTree(points_at(line, even)).query(places)[1]]
    # one place may have several edges: they follow each other as they lie along the wall
    ahead = points_at(line, (along + SPACING) % line.length) - points_at(line, along)
    order = np.lexsort((((middles - places) * ahead).sum(axis=1), np.round(along, 6)))
    along, middles = along[order], middles[order]
    stations = np.union1d(even, along)
    walk = np.column_stack(
        [np.interp(stations, along, middles[:, i], period=line.length) for i in (0, 1)]
    )
    return _even(points_at(line, stations), walk, smoothing)


def _even(wall: Floats, partners: Floats, smoothing: float) -> Walk:
    """Return the walk evenly spaced in the length of wall and partners together, and smoothed."""
    both = np.hstack([wall, partners])
    both = np.vstack([both, both[:1]])
    steps = np.diff(both, axis=0)
    total = np.concatenate(
        [[0.0], np.cumsum(np.hypot(*steps[:, :2].T) + np.hypot(*steps[:, 2:].T))]
    )
    count = max(16, int(np.ceil(total[-1] / SPACING)))
    even = np.arange(count) * total[-1] / count
    both = np.column_stack([np.interp(even, total, both[:, i]) for i in range(4)])
    soft = gaussian_filter1d(both[:, 2:], smoothing * count / total[-1], axis=0, mode="wrap")
    return Walk(both[:, :2], soft)


def _turning(steps: Floats) -> Floats:
    """Return how far a closed polyline turns at the end of each step [rad]."""
    heading = np.arctan2(steps[:, 1], steps[:, 0])
    return wrapped(np.roll(heading, -1) - heading)


def _at(points: Floats, index: Floats) -> Floats:
    """Return the points of a closed polyline at fractional indices."""
    closed = np.vstack([points, points[:1]])
    return np.column_stack([np.interp(index, np.arange(len(closed)), closed[:, i]) for i in (0, 1)])
