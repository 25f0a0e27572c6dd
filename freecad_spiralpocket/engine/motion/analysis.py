# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measures by which the papers judge a toolpath, as plain arrays.

[LM15] section 4: feed direction (eq. 9) and the ratio of ideal to machine time (eq. 8).
[HQS24] section 3: absolute curvature and its quantiles Cut95 and Cut99. [CS08] section 2.4:
radial depth and feed along the path. Places along the path are stations, the arc length
from its start; forces are in `force`, engagement in `engagement`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..model import Floats
from ..shapes.points import three_point_curvature, wrapped
from ..toolpath import Kind, Toolpath
from .stations import Measured, ends_of, stations_of
from .timing import MachineTime

#: Moves shorter than this have no direction [mm].
_SHORTEST = 1e-9


def feed_direction(toolpath: Toolpath, *, by_turns: bool = True) -> tuple[Floats, Floats]:
    """Return the direction of travel in the plane along a path ([LM15] eq. 9).

    Parameters
    ----------
    toolpath : Toolpath
        n moves.
    by_turns : bool
        Whether each full turn adds 2 pi, as for spirals; else in ``(-pi, pi]``.

    Returns
    -------
    stations : ndarray of shape (2 m,)
        Begin and end of each of the m moves in the plane [mm].
    directions : ndarray of shape (2 m,)
        [rad]; a corner is a step at one station.
    """
    headings = _headings(toolpath)
    known = np.isfinite(headings).all(axis=1)
    ends = ends_of(toolpath)
    stations = np.column_stack([np.r_[0.0, ends[:-1]], ends])[known].ravel()
    directions = headings[known].ravel()
    if by_turns and len(directions):
        # an arc may turn by more than half a turn, a corner cannot
        steps = wrapped(np.diff(directions))
        sweeps = toolpath.sweeps[known]
        steps[0::2] = sweeps
        directions = directions[0] + np.r_[0.0, np.cumsum(steps)]
    return stations, directions


def time_ratio(toolpath: Toolpath, motion: MachineTime) -> float:
    """Return eta ([LM15] eq. 8): time at the programmed feeds over machine time, without rapids."""
    cuts = toolpath.kinds != Kind.RAPID
    ideal = float((toolpath.lengths[cuts] / toolpath.feeds[cuts]).sum())
    real = float(motion.times[cuts].sum())
    return ideal / real if real > 0 else 1.0


def absolute_curvature(toolpath: Toolpath) -> tuple[Floats, Floats]:
    """Return the absolute curvature along a path and the lengths that have it.

    Of arcs their own; at the joint of two lines that of the circle through the three points,
    for half the length of both.

    Parameters
    ----------
    toolpath : Toolpath
        Rapids and moves straight up or down are left out; they end a curve.

    Returns
    -------
    curvature : ndarray of shape (k,)
        [1/mm]
    lengths : ndarray of shape (k,)
        [mm]
    """
    lengths = toolpath.lengths
    flat = np.hypot(*(toolpath.points - toolpath.starts)[:, :2].T)
    cuts = (toolpath.kinds != Kind.RAPID) & ((flat > _SHORTEST) | toolpath.is_arc)
    arcs = np.flatnonzero(cuts & toolpath.is_arc)
    radii = np.hypot(*(toolpath.points[arcs, :2] - toolpath.centers[arcs]).T)
    lines = cuts & ~toolpath.is_arc
    first = np.flatnonzero(lines[:-1] & lines[1:])
    curvature = three_point_curvature(
        toolpath.starts[first, :2], toolpath.points[first, :2], toolpath.points[first + 1, :2]
    )
    shares = (lengths[first] + lengths[first + 1]) / 2
    return np.r_[1 / radii, np.abs(curvature)], np.r_[lengths[arcs], shares]


def weighted_quantiles(values: Floats, weights: Floats, shares: Floats | Sequence[float]) -> Floats:
    """Return the smallest values below which `shares` of the weight lie, one for each share.

    Parameters
    ----------
    values, weights : ndarray of shape (n,)
        In any order; weights are 0 or more.
    shares : array-like of shape (k,)
        In [0, 1].

    Returns
    -------
    ndarray of shape (k,)
        Of `values`; nan where there are none.

    Notes
    -----
    ``weighted_quantiles(*absolute_curvature(path), [0.95, 0.99])`` are Cut95 and Cut99.
    """
    if len(values) == 0:
        return np.full(len(shares), np.nan)
    order = np.argsort(values, kind="stable")
    done = np.cumsum(weights[order])
    index = np.searchsorted(done, np.asarray(shares) * done[-1])
    return values[order][np.minimum(index, len(values) - 1)]


def sample_times(toolpath: Toolpath, engagement: Measured, motion: MachineTime) -> Floats:
    """Return the time [s] that each sample of the engagement stands for, shape (k,).

    For histograms over the time: ``np.histogram(engagement.angles, bins, weights=times)``; over
    the length `engagement.lengths` are the weights.
    """
    stations = stations_of(toolpath, engagement.moves, engagement.points)
    half = engagement.lengths / 2
    return motion.clock_at(stations + half) - motion.clock_at(stations - half)


def _headings(toolpath: Toolpath) -> Floats:
    """Return the headings at both ends of each move, (n, 2) [rad]; nan straight up or down."""
    step = (toolpath.points - toolpath.starts)[:, :2]
    with np.errstate(invalid="ignore"):
        straight = np.where(
            np.hypot(*step.T) > _SHORTEST, np.arctan2(step[:, 1], step[:, 0]), np.nan
        )
    headings = np.column_stack([straight, straight])
    arcs = toolpath.is_arc
    for column, ends in enumerate((toolpath.starts, toolpath.points)):
        spokes = ends[arcs, :2] - toolpath.centers[arcs]
        quarter = np.sign(toolpath.sweeps[arcs]) * np.pi / 2
        headings[arcs, column] = np.arctan2(spokes[:, 1], spokes[:, 0]) + quarter
    return headings
