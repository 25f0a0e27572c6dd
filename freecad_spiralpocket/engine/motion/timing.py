# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a machine takes for a toolpath, and how fast it is where.

The planner works on speed squared over arc length, where a constant acceleration is a
straight line: the fastest profile under caps is then ``w_i = min_j (cap_j + |A_i - A_j|)``
with ``A`` the running sum of ``2 a ds``, and two running minima find it. Within a block the
machine speeds up, cruises and slows down again.

Jerk makes speed changes slower: from v to v + d it takes ``d/a + J^-1 a`` or, where a is not
reached, ``2 sqrt(d/J)``, over the same distance as the constant acceleration of the same
time. So each run of the profile between a slowest and a fastest point gets the acceleration
of its own S-curve, and the passes are repeated until the runs stay the same. That is exact
for changes of speed between points of no acceleration, the only ones at the ends, the
extremes and the cruising stretches of a profile; where a cap cuts into a speed change it is
an approximation (docs/machine-time.md measures it).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..machine import Machine
from ..model import Floats
from ..toolpath import Toolpath
from .bends import bend_limits
from .blocks import Blocks, blocks_of_polylines, blocks_of_toolpath
from .ramps import s_curve_accelerations

#: Passes for the S-curves; each halves the logarithm of what is left, or better.
_PASSES = 12
#: Largest change of the total time at which the passes end.
_SETTLED = 1e-4


@dataclass(frozen=True, slots=True, eq=False)
class MachineTime:
    """The motion of a machine along a toolpath of n moves.

    Attributes
    ----------
    total : float
        [s], with the overhead at the start.
    times : ndarray of shape (n,)
        Of each move [s].
    distances : ndarray of shape (3 n + 1,)
        Arc lengths at which the acceleration changes [mm]: for each move its start, the end of
        speeding up, the start of slowing down; at last the end of the path.
    speeds : ndarray of shape (3 n + 1,)
        Speed there [mm/s]; in between its square is linear in the arc length.
    """

    total: float
    times: Floats
    distances: Floats
    speeds: Floats

    def speed_at(self, distances: Floats) -> Floats:
        """Return the speed [mm/s] at arc lengths [mm] of any shape."""
        return np.sqrt(np.interp(distances, self.distances, self.speeds**2))

    def clock_at(self, distances: Floats) -> Floats:
        """Return the time since the first motion [s] at arc lengths [mm] of any shape."""
        steps = np.diff(self.distances)
        with np.errstate(invalid="ignore", divide="ignore"):
            times = np.where(steps > 0, 2 * steps / (self.speeds[1:] + self.speeds[:-1]), 0.0)
        place = np.clip(distances, 0.0, self.distances[-1])
        index = np.clip(np.searchsorted(self.distances, place) - 1, 0, len(steps) - 1)
        with np.errstate(invalid="ignore", divide="ignore"):
            gone = place - self.distances[index]
            inside = np.where(gone > 0, 2 * gone / (self.speeds[index] + self.speed_at(place)), 0.0)
        return np.cumsum(np.r_[0.0, times])[index] + inside


@dataclass(frozen=True, slots=True, eq=False)
class _Profile:
    """Speeds squared, distances of speeding up and slowing down, times: (..., n) or n + 1."""

    joints: Floats
    peaks: Floats
    ups: Floats
    downs: Floats
    cruises: Floats
    times: Floats


def time_of(toolpath: Toolpath, machine: Machine) -> MachineTime:
    """Return how `machine` moves along `toolpath`, from rest to rest.

    Rapids run at the machine's own rate, all other moves at their feed where the machine
    reaches it.

    Parameters
    ----------
    toolpath : Toolpath
        n moves.
    machine : Machine

    Returns
    -------
    MachineTime

    Notes
    -----
    Linear in n; 50,000 moves take 0.03 s, with jerk limits 0.1 s.
    """
    count = len(toolpath)
    if count == 0:
        return MachineTime(machine.start_overhead, np.zeros(0), np.zeros(1), np.zeros(1))
    blocks = blocks_of_toolpath(toolpath, machine)
    profile = _plan(blocks, machine, 0.0, 0.0)
    ends = np.cumsum(blocks.lengths)
    distances = np.zeros(3 * count + 1)
    distances[3::3] = ends
    distances[1::3] = ends - blocks.lengths + profile.ups
    distances[2::3] = ends - profile.downs
    speeds = np.zeros(3 * count + 1)
    speeds[0::3] = profile.joints
    speeds[1::3] = speeds[2::3] = profile.peaks
    total = float(profile.times.sum()) + machine.start_overhead
    return MachineTime(total, profile.times, np.maximum.accumulate(distances), np.sqrt(speeds))


def polyline_seconds(
    points: Floats,
    feeds: Floats | float,
    machine: Machine,
    entry_speed: Floats | float = 0.0,
    exit_speed: Floats | float = 0.0,
) -> Floats:
    """Return the times of straight-lined paths, many at once.

    Meant for the choice between candidates: no overhead at the start, no record of speeds.

    Parameters
    ----------
    points : ndarray of shape (..., n + 1, 3)
        Corners of each path [mm].
    feeds : float or ndarray of shape (..., n)
        Programmed speeds [mm/s].
    machine : Machine
    entry_speed, exit_speed : float or ndarray of shape (...)
        Speeds at both ends of each path [mm/s]; lowered where the path does not allow them.

    Returns
    -------
    ndarray of shape (...)
        [s]
    """
    blocks = blocks_of_polylines(np.asarray(points, float), np.asarray(feeds, float), machine)
    return _plan(blocks, machine, entry_speed, exit_speed).times.sum(axis=-1)


def _plan(
    blocks: Blocks, machine: Machine, entry_speed: Floats | float, exit_speed: Floats | float
) -> _Profile:
    """Return the fastest profile that keeps all limits."""
    joints, arcs = bend_limits(blocks, machine)
    tops = np.minimum(np.minimum(arcs, blocks.speeds), _block_rate_speeds(blocks, machine))
    joints[..., :-1] = np.minimum(joints[..., :-1], tops)
    joints[..., 1:] = np.minimum(joints[..., 1:], tops)
    joints[..., 0] = np.minimum(joints[..., 0], entry_speed)
    joints[..., -1] = np.minimum(joints[..., -1], exit_speed)
    caps, tops = joints**2, tops**2
    up = down = blocks.accelerations
    profile = _profile(caps, tops, up, down, blocks.lengths, machine.look_ahead)
    if not machine.has_jerk_limit:
        return profile
    total = profile.times.sum()
    for _ in range(_PASSES):
        up_new, down_new = s_curve_accelerations(
            np.sqrt(profile.joints),
            np.sqrt(profile.peaks),
            profile.cruises,
            blocks.accelerations,
            blocks.jerks,
        )
        up, down = np.minimum(up, up_new), np.minimum(down, down_new)
        profile = _profile(caps, tops, up, down, blocks.lengths, machine.look_ahead)
        last, total = total, profile.times.sum()
        if total - last <= _SETTLED * last:
            break
    return profile


def _profile(
    caps: Floats, tops: Floats, up: Floats, down: Floats, lengths: Floats, look_ahead: int
) -> _Profile:
    """Return the profile of largest speeds under `caps` (joints) and `tops` (blocks), squared."""
    pad = [(0, 0)] * (lengths.ndim - 1) + [(1, 0)]
    rise = np.pad(np.cumsum(2 * up * lengths, axis=-1), pad)
    fall = np.pad(np.cumsum(2 * down * lengths, axis=-1), pad)
    if look_ahead:
        count = lengths.shape[-1]
        seen = np.minimum(np.arange(count + 1) + look_ahead, count)
        last = np.where(seen == count, caps[..., -1:], 0.0)
        caps = np.minimum(caps, fall[..., seen] - fall + last)
    joints = np.minimum.accumulate(caps - rise, axis=-1) + rise
    joints = np.minimum.accumulate((joints + fall)[..., ::-1], axis=-1)[..., ::-1] - fall
    joints = np.maximum(joints, 0.0)
    before, after = joints[..., :-1], joints[..., 1:]
    peaks = (before * down + after * up + 2 * up * down * lengths) / (up + down)
    peaks = np.maximum(np.minimum(peaks, tops), np.maximum(before, after))
    ups = np.minimum((peaks - before) / (2 * up), lengths)
    downs = np.minimum((peaks - after) / (2 * down), lengths - ups)
    top = np.sqrt(peaks)
    with np.errstate(invalid="ignore", divide="ignore"):
        cruises = (lengths - ups - downs) / top
        times = 2 * ups / (np.sqrt(before) + top) + 2 * downs / (np.sqrt(after) + top) + cruises
    # 0 / 0 is a block that goes nowhere between two stops
    cruises, times = np.nan_to_num(cruises), np.nan_to_num(times)
    return _Profile(joints, peaks, ups, downs, cruises, times)


def _block_rate_speeds(blocks: Blocks, machine: Machine) -> Floats:
    """Return the speeds [mm/s] at which blocks are no shorter than the control can take them.

    What counts is the mean length of the blocks in its look-ahead, whose buffer evens out.
    """
    if not np.isfinite(machine.block_rate):
        return np.full(blocks.lengths.shape, np.inf)
    count = blocks.lengths.shape[-1]
    size = min(max(machine.look_ahead, 1), count)
    pad = [(0, 0)] * (blocks.lengths.ndim - 1) + [(1, 0)]
    at = np.pad(np.cumsum(blocks.lengths, axis=-1), pad)
    first = np.clip(np.arange(count) - size // 2, 0, count - size)
    return machine.block_rate * (at[..., first + size] - at[..., first]) / size
