# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinks of a path spread over a length.

Beside saddles isotherms have corners by nature, and where laps branch so have the turns between
them. A machine stops there; the stock does not care whether such a tip is reached.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter1d

from ..model import Floats
from ..shapes.points import wrapped

#: A turn at one point of a path above this is a kink [rad].
KINK = np.radians(12.0)
#: Widths over which kinks are spread, over R; the first that moves no point too far.
WIDTHS = (0.2, 0.1, 0.05)
#: So many widths to both sides are looked at; over the last of them the change fades away.
REACH, FADE = 6.0, 2.0
#: Points of a spread kink are so far apart, over the width.
SPACING = 0.2


def reach_of_kinks(radius: float) -> float:
    """Return over which length to both sides a kink is spread [mm]."""
    return REACH * WIDTHS[0] * radius


def has_kink(points: Floats) -> bool:
    """Return whether a path of points of shape (n, 2), none twice, has a kink."""
    return bool((_turns(np.diff(points, axis=0)) > KINK).any())


def _turns(steps: Floats) -> Floats:
    """Return by how much each step turns from the one before, shape (n - 1,) [rad]."""
    heading = np.arctan2(steps[:, 1], steps[:, 0])
    return np.asarray(np.abs(wrapped(np.diff(heading))))


def softened(points: Floats, radius: float, most: float) -> Floats:
    """Return a path whose kinks are spread as widely as moves no point too far.

    Parameters
    ----------
    points : ndarray of shape (n, 2)
        No longer piece than about 0.1 R where it bends [mm].
    radius : float
        R [mm].
    most : float
        No point is moved farther [mm]; a kink that would be stays.
    """
    steps = np.diff(points, axis=0)
    lengths = np.hypot(steps[:, 0], steps[:, 1])
    kept = np.append(lengths > 1e-9, True)
    points, steps, lengths = points[kept], steps[kept[:-1]], lengths[kept[:-1]]
    turns = _turns(steps)
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    kinks = along[1:-1][turns > KINK]
    if len(kinks) == 0:
        return points
    reach = reach_of_kinks(radius)
    begins, ends = np.maximum(kinks - reach, 0.0), np.minimum(kinks + reach, along[-1])
    # windows that overlap are one
    first = np.concatenate([[True], begins[1:] > ends[:-1]])
    begins, ends = begins[first], ends[np.append(np.flatnonzero(first)[1:] - 1, len(ends) - 1)]
    pieces, done = [], 0.0
    for begin, end in zip(begins, ends, strict=True):
        pieces.append(points[(along >= done) & (along < begin)])
        pieces.append(_spread(points, along, begin, end, radius, most))
        done = float(np.nextafter(end, np.inf))
    pieces.append(points[along >= done])
    return np.vstack(pieces)


def _spread(
    points: Floats, along: Floats, begin: float, end: float, radius: float, most: float
) -> Floats:
    """Return the part of a path between two lengths, its kinks spread, ends where they are."""
    for share in WIDTHS:
        width = share * radius
        count = max(4, int(np.ceil((end - begin) / (SPACING * width))))
        s = np.linspace(begin, end, count + 1)
        raw = np.column_stack([np.interp(s, along, x) for x in points.T])
        smooth = gaussian_filter1d(raw, width * count / (end - begin), axis=0, mode="nearest")
        fade = np.minimum(s - begin, end - s) / (FADE * width)
        moved = np.clip(fade, 0.0, 1.0)[:, None] * (smooth - raw)
        if np.hypot(*moved.T).max() <= most:
            return np.asarray(raw + moved)
    inner = (along > begin) & (along < end)
    return np.vstack([raw[:1], points[inner], raw[-1:]])
