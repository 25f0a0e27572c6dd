# SPDX-License-Identifier: LGPL-2.1-or-later
"""The acceleration that stands for an S-curve, for each run of a speed profile.

A run is a stretch between a slowest and a fastest point, or a stretch of cruising that is
long enough for the acceleration to die away. See `timing` for what it is used for.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..model import Floats

#: Changes of speed below this are none [mm/s].
_STILL = 1e-6


def s_curve_time(change: Floats, acceleration: Floats, jerk: Floats) -> Floats:
    """Return the shortest time [s] for a change of speed [mm/s], without acceleration at its ends.

    Parameters
    ----------
    change, acceleration, jerk : ndarray
        Of the speed [mm/s], and limits [mm/s2], [mm/s3].
    """
    short = 2 * np.sqrt(change / jerk)
    long = change / acceleration + acceleration / jerk
    return np.where(change * jerk < acceleration**2, short, long)


def s_curve_accelerations(
    joints: Floats, peaks: Floats, cruises: Floats, accelerations: Floats, jerks: Floats
) -> tuple[Floats, Floats]:
    """Return the mean accelerations of the runs of a speed profile.

    Parameters
    ----------
    joints : ndarray of shape (..., n + 1)
        Speeds at the joints of the blocks [mm/s].
    peaks, cruises : ndarray of shape (..., n)
        Largest speed in each block [mm/s], time at that speed [s].
    accelerations, jerks : ndarray of shape (..., n)
        Limits along the path [mm/s2], [mm/s3].

    Returns
    -------
    up, down : ndarray of shape (..., n)
        For the speeding up and the slowing down within each block [mm/s2]; the limit itself
        where the speed does not change.
    """
    # each block is two steps, up and down, with its cruising between them
    changes = np.stack([peaks - joints[..., :-1], joints[..., 1:] - peaks], axis=-1)
    limits = np.repeat(accelerations, 2, axis=-1).ravel()
    steps = np.flatnonzero(np.abs(changes) > _STILL)
    if len(steps):
        change = changes.ravel()[steps]
        a, j = limits[steps], np.repeat(jerks, 2, axis=-1).ravel()[steps]
        clock = np.repeat(np.cumsum(cruises), 2)
        clock[0::2] -= cruises.ravel()
        is_new = _is_new_run(change, steps // (2 * peaks.shape[-1]), clock[steps], a, j)
        starts = np.flatnonzero(np.r_[True, is_new])
        total = np.abs(np.add.reduceat(change, starts))
        a, j = np.minimum.reduceat(a, starts), np.minimum.reduceat(j, starts)
        means = total / s_curve_time(total, a, j)
        limits[steps] = np.repeat(means, np.diff(np.r_[starts, len(steps)]))
    up_and_down = limits.reshape(*peaks.shape, 2)
    return up_and_down[..., 0], up_and_down[..., 1]


def _is_new_run(
    change: Floats, row: Floats, clock: Floats, acceleration: Floats, jerk: Floats
) -> NDArray[np.bool_]:
    """Return which of the steps after the first begin a new run.

    A step of the same sign as the last joins its run unless the cruising in between lasts
    longer than the S-curves of the two steps would gain by being one.
    """
    size = np.abs(change)
    alone = s_curve_time(size, acceleration, jerk)
    together = s_curve_time(
        size[:-1] + size[1:],
        np.minimum(acceleration[:-1], acceleration[1:]),
        np.minimum(jerk[:-1], jerk[1:]),
    )
    turns = change[:-1] * change[1:] < 0
    rests = np.diff(clock) > alone[:-1] + alone[1:] - together
    return turns | rests | (np.diff(row) != 0)
