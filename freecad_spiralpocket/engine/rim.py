# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which part of the cutter's rim stands in ground that earlier motion has cleared.

A rim point q is clear of an earlier cutter position p when ``|q - p| <= r``. Seen
from the cutter center c, with p at distance d and bearing phi, these q fill the
interval ``phi -+ acos(d / 2r)``. While p runs along a line or arc inside the disc
of radius 2r about c that interval moves without a jump, so a swept piece clears
one interval: from the least ``phi - acos`` to the largest ``phi + acos`` along it.
These are at its ends or where the rim point lies square to the piece at distance
r; both are known in closed form. Nothing is sampled here.

Angles are unwrapped and relative to the direction of travel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .model import Floats
from .swept import Pieces

#: The cutter's own trail is taken up to this many radii behind its center: at the very
#: center the bearing is undefined.
OWN_TRAIL_GAP = 1e-6
#: Narrower gaps are rounding [rad].
NARROWEST = 1e-9


def cleared_by_lines(
    centers: Floats, headings: Floats, pieces: Pieces, index: NDArray[np.int64], r: float
) -> tuple[NDArray[np.int64], Floats, Floats]:
    """Return the rim intervals that straight pieces have cleared.

    Parameters
    ----------
    centers : ndarray of shape (k, 2)
        Cutter center of each pair [mm].
    headings : ndarray of shape (k,)
        Direction of travel there [rad].
    pieces : Pieces
    index : ndarray of int, shape (k,)
        The straight piece of each pair.
    r : float
        Cutter radius [mm].

    Returns
    -------
    pair : ndarray of int, shape (m,)
        Pairs that meet.
    low, high : ndarray of shape (m,)
        Interval of rim angles from the heading, ``low <= high <= low + 2 pi`` [rad].
    """
    a = pieces.starts[index]
    d = pieces.ends[index] - a
    length = np.hypot(d[:, 0], d[:, 1])
    still = length < 1e-12
    ux = np.where(still, 1.0, d[:, 0] / np.where(still, 1.0, length))
    uy = np.where(still, 0.0, d[:, 1] / np.where(still, 1.0, length))
    cx, cy = centers[:, 0] - a[:, 0], centers[:, 1] - a[:, 1]
    along = cx * ux + cy * uy
    side = ux * cy - uy * cx
    h = np.abs(side)
    reach = np.sqrt(np.maximum(4 * r * r - h * h, 0.0))
    first, last = np.maximum(-along, -reach), np.minimum(length - along, reach)
    pair = np.flatnonzero((h < 2 * r) & (first < last + np.where(still, 1e-12, 0.0)))
    h, first, last = h[pair], first[pair], last[pair]
    square = np.sqrt(h * (2 * r - h))
    to_high = np.clip(square, first, last)
    to_low = np.clip(-square, first, last)
    high = np.arctan2(-h, to_high) + np.arccos(np.minimum(np.hypot(h, to_high) / (2 * r), 1.0))
    low = np.arctan2(-h, to_low) - np.arccos(np.minimum(np.hypot(h, to_low) / (2 * r), 1.0))
    turn = np.arctan2(uy[pair], ux[pair]) - headings[pair]
    left = side[pair] >= 0
    return pair, np.where(left, turn + low, turn - high), np.where(left, turn + high, turn - low)


def cleared_by_arcs(
    centers: Floats,
    headings: Floats,
    pieces: Pieces,
    index: NDArray[np.int64],
    r: float,
    until: Floats,
    own: NDArray[np.bool_],
) -> tuple[NDArray[np.int64], Floats, Floats]:
    """Return the rim intervals that circular pieces have cleared.

    Parameters are those of `cleared_by_lines`, and of shape (k,): `until`, the fraction of
    the piece that was already travelled, and `own`, whether the cutter is on this very piece.

    Returns
    -------
    As `cleared_by_lines`; a piece that leaves the disc of radius 2r and comes back
    gives two intervals.
    """
    spoke = centers - pieces.centers[index]
    rho, sweep = pieces.radii[index], pieces.sweeps[index]
    far = np.maximum(np.hypot(spoke[:, 0], spoke[:, 1]), 1e-9)
    bearing = np.arctan2(spoke[:, 1], spoke[:, 0])
    swept = np.clip(until - np.where(own, OWN_TRAIL_GAP * r / (rho * np.abs(sweep)), 0), 0, 1)
    begin = pieces.angles[index] + np.minimum(sweep * swept, 0.0) - bearing
    begin -= 2 * np.pi * np.floor((begin + np.pi) / (2 * np.pi))
    end = begin + np.abs(sweep) * swept
    # the part of the circle within 2r of the cutter center is -+ `span` about its bearing
    cos_span = (rho * rho + far * far - 4 * r * r) / (2 * rho * far)
    span = np.arccos(np.clip(cos_span, -1.0, 1.0))
    parts = []
    for turn in (0.0, 2 * np.pi):
        t0, t1 = np.maximum(begin - turn, -span), np.minimum(end - turn, span)
        pair = np.flatnonzero((cos_span < 1.0) & (t0 < t1))
        low, high = _arc_interval(t0[pair], t1[pair], rho[pair], far[pair], r)
        shift = bearing[pair] - headings[pair]
        parts.append((pair, shift + low, shift + high))
    pair, low, high = (np.concatenate(p) for p in zip(*parts, strict=True))
    return pair, low, high


def _arc_interval(
    t0: Floats, t1: Floats, rho: Floats, far: Floats, r: float
) -> tuple[Floats, Floats]:
    """Return the interval cleared by circle angles [t0, t1], all measured from the bearing of c."""
    low, high = np.full(len(t0), np.inf), np.full(len(t0), -np.inf)
    inside = far < rho

    def include(t: Floats, valid: NDArray[np.bool_]) -> None:
        x, y = rho * np.cos(t) - far, rho * np.sin(t)
        # continuous in t: seen from inside the circle the bearing runs through 0, seen from
        # outside through pi
        phi = np.where(inside, np.arctan2(y, x), np.pi + np.arctan2(-y, -x))
        half = np.arccos(np.minimum(np.hypot(x, y) / (2 * r), 1.0))
        np.minimum(low, np.where(valid, phi - half, np.inf), out=low)
        np.maximum(high, np.where(valid, phi + half, -np.inf), out=high)

    every = np.ones(len(t0), bool)
    include(t0, every)
    include(t1, every)
    for reach in (rho + r, rho - r):
        reach = np.where(reach == 0.0, 1e-12, reach)
        cos_square = (reach * reach + far * far - r * r) / (2 * reach * far)
        square = np.arccos(np.clip(cos_square, -1.0, 1.0))
        exists = np.abs(cos_square) <= 1.0
        for t in (square, -square):
            include(t, exists & (t > t0) & (t < t1))
    return low, high


@dataclass(frozen=True, slots=True, eq=False)
class Gaps:
    """What still stands along rims: intervals of rim angle, sorted by rim and angle.

    Attributes
    ----------
    rims : ndarray of int, shape (g,)
    begins, ends : ndarray of shape (g,)
        From the heading, within ``[-pi / 2, pi / 2]`` for the leading half [rad].
    """

    rims: NDArray[np.int64]
    begins: Floats
    ends: Floats

    def angles(self, n: int) -> Floats:
        """Return the sum of the gaps of each of `n` rims [rad]."""
        return np.bincount(self.rims, self.ends - self.begins, minlength=n)

    def widths(self, n: int, cutter_radius: float) -> Floats:
        """Return the sum of the gaps' widths across the heading [mm]."""
        wide = cutter_radius * np.abs(np.sin(self.ends) - np.sin(self.begins))
        return np.bincount(self.rims, wide, minlength=n)

    def hull(self, offset: int, n: int, half: float) -> tuple[Floats, Floats]:
        """Return where the first gap of `n` rims begins and the last one ends [rad].

        Of rims `offset` and following. Without gaps the end comes before the begin.
        """
        first, last = np.full(n, half), np.full(n, -half)
        new = self._firsts()
        first[self.rims[new] - offset] = self.begins[new]
        final = np.roll(new, -1)
        last[self.rims[final] - offset] = self.ends[final]
        return first, last

    def without(self, rims: NDArray[np.int64], low: Floats, high: Floats, half: float) -> Gaps:
        """Return what is left when these intervals, given as in `standing`, are cleared too."""
        mine, others = self.split(rims)
        known = np.isin(rims, mine.rims)
        cleared = mine._complement(half)
        rest = standing(
            np.concatenate([rims[known], cleared[0]]),
            np.concatenate([low[known], cleared[1]]),
            np.concatenate([high[known], cleared[2]]),
            mine.rims[mine._firsts()],
            half,
        )
        both = Gaps.joined([others, rest])
        order = np.lexsort((both.begins, both.rims))
        return Gaps(both.rims[order], both.begins[order], both.ends[order])

    def split(self, rims: NDArray[np.int64]) -> tuple[Gaps, Gaps]:
        """Return the gaps of the given rims, and the others."""
        mine = np.isin(self.rims, rims)
        fields = self.rims, self.begins, self.ends
        return Gaps(*(f[mine] for f in fields)), Gaps(*(f[~mine] for f in fields))

    def repeated(self, sources: NDArray[np.int64]) -> Gaps:
        """Return gaps where rim i has those that rim ``sources[i]`` has here."""
        first = np.searchsorted(self.rims, sources, side="left")
        count = np.searchsorted(self.rims, sources, side="right") - first
        rims = np.repeat(np.arange(len(sources)), count)
        place = np.arange(len(rims)) - np.repeat(np.cumsum(count) - count, count)
        index = first[rims] + place
        return Gaps(rims, self.begins[index], self.ends[index])

    @staticmethod
    def joined(parts: Sequence[Gaps]) -> Gaps:
        """Return the gaps of all parts, one part after the other."""
        if len(parts) == 0:
            return Gaps(np.zeros(0, np.int64), np.zeros(0), np.zeros(0))
        return Gaps(*(np.concatenate([getattr(p, f) for p in parts]) for f in Gaps.__slots__))

    def _firsts(self) -> NDArray[np.bool_]:
        """Return which gaps are the first of their rim."""
        return np.diff(self.rims, prepend=-1) != 0

    def _complement(self, half: float) -> tuple[NDArray[np.int64], Floats, Floats]:
        """Return the cleared intervals of the rims that have gaps: rims, lows, highs."""
        new = self._firsts()
        final = np.roll(new, -1)
        return (
            np.concatenate([self.rims, self.rims[final]]),
            np.concatenate([np.where(new, -half, np.roll(self.ends, 1)), self.ends[final]]),
            np.concatenate([self.begins, np.full(int(final.sum()), half)]),
        )


def standing(
    rims: NDArray[np.int64], low: Floats, high: Floats, every: NDArray[np.int64], half: float
) -> Gaps:
    """Return what is left of each rim's ``[-half, half]`` outside all its cleared intervals.

    Sorted starts and sorted ends tell the gaps of a union: after the k-th end there is a
    gap if it comes before the (k+1)-th start. Two plain sorts over all rims at once.

    Parameters
    ----------
    rims : ndarray of int, shape (m,)
        Rim of each interval, 0 or more.
    low, high : ndarray of shape (m,)
        [rad]
    every : ndarray of int
        All rims, also those without an interval.
    half : float
        ``pi / 2`` for the leading half of the rim, ``pi`` for all of it.

    Returns
    -------
    Gaps
    """
    turns = 2 * np.pi * np.floor((low + np.pi) / (2 * np.pi))
    low, high = low - turns, high - turns
    wraps = high > 2 * np.pi - half
    ahead = (low < half) & (high > -half)
    n = len(every)
    rim = np.concatenate([rims[ahead], rims[wraps], every, every])
    begins = np.concatenate(
        [np.maximum(low[ahead], -half), np.full(wraps.sum() + n, -half), np.full(n, half)]
    )
    ends = np.concatenate(
        [
            np.minimum(high[ahead], half),
            np.minimum(high[wraps] - 2 * np.pi, half),
            np.full(n, -half),
            np.full(n, half),
        ]
    )
    pitch = 10.0  # one rim after the other on one axis, farther apart than 2 pi
    begins = np.sort(begins + pitch * rim)[1:]
    ends = np.sort(ends + pitch * rim)[:-1]
    gap = np.flatnonzero(begins > ends + NARROWEST)
    of = np.rint(ends[gap] / pitch).astype(np.int64)
    inner = np.rint(begins[gap] / pitch).astype(np.int64) == of
    gap, of = gap[inner], of[inner]
    return Gaps(of, ends[gap] - pitch * of, begins[gap] - pitch * of)
