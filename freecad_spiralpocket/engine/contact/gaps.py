# SPDX-License-Identifier: LGPL-2.1-or-later
"""What still stands along the cutter's rim when all cleared intervals are taken away.

Sets of angle intervals, of many rims in one flat array each: union and difference are
sorts over all rims at once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from ..numerics.distinct import are_among
from ..numerics.ragged import rows_of

#: Narrower gaps are rounding [rad].
NARROWEST = 1e-9
#: What stands in narrower gaps breaks off as dust [rad].
DUST = np.radians(1.0)


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
        """Return the sum of the gaps of each of `n` rims, shape (n,) [rad]."""
        return np.bincount(self.rims, self.ends - self.begins, minlength=n).astype(float)

    def widths(self, n: int, cutter_radius: float) -> Floats:
        """Return the sum of the gaps' widths across the heading, shape (n,) [mm]."""
        wide = cutter_radius * np.abs(np.sin(self.ends) - np.sin(self.begins))
        return np.bincount(self.rims, wide, minlength=n).astype(float)

    def foremost(self, n: int) -> Floats:
        """Return the largest cosine of rim angles in the gaps of each of `n` rims, shape (n,).

        0 for none. Gaps narrower than `DUST` do not count.
        """
        wide = self.ends - self.begins > DUST
        nearest = np.maximum(np.maximum(self.begins, -self.ends), 0.0)[wide]
        found = np.zeros(n)
        np.maximum.at(found, self.rims[wide], np.cos(nearest))
        return found

    def contain(self, n: int, angle: float) -> NDArray[np.bool_]:
        """Return which of `n` rims have a gap around an angle [rad]."""
        found = np.zeros(n, bool)
        found[self.rims[(self.begins < angle) & (angle < self.ends)]] = True
        return found

    def hull(self, offset: int, n: int, half: float) -> tuple[Floats, Floats]:
        """Return where the first gap of `n` rims begins and the last one ends, shape (n,) [rad].

        Of rims `offset` and following. Without gaps the end comes before the begin.
        """
        first, last = np.full(n, half), np.full(n, -half)
        new = self._firsts()
        first[self.rims[new] - offset] = self.begins[new]
        final = np.roll(new, -1)
        last[self.rims[final] - offset] = self.ends[final]
        return first, last

    def surroundings(
        self, offset: int, headings: Floats, r: float, half: float
    ) -> tuple[Floats, Floats]:
        """Return the middle of the gaps of rims and how near to it a piece must come to clear any.

        Parameters
        ----------
        offset : int
            Of rims `offset` and following.
        headings : ndarray of shape (n,)
            [rad]
        r, half : float
            Cutter radius [mm]; as in `standing`.

        Returns
        -------
        middles : ndarray of shape (2, n)
            From the cutter center [mm].
        reach : ndarray of shape (n,)
            [mm]; negative without gaps.
        """
        first, last = self.hull(offset, len(headings), half)
        middle = (first + last) / 2 + headings
        # a piece matters if it is within r of the gap, which is this far from its middle
        span = 2 * r * np.sin(np.maximum(last - first, 0.0) / 4)
        reach = np.where(first < last, 1.000001 * (r + span), -1.0)
        return r * np.stack([np.cos(middle), np.sin(middle)]), reach

    def without(self, rims: NDArray[np.int64], low: Floats, high: Floats, half: float) -> Gaps:
        """Return what is left when more intervals are cleared too.

        `rims`, `low`, `high` [rad] and `half` are as in `standing`.
        """
        mine, others = self.split(rims)
        known = are_among(rims, mine.rims)
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
        mine = are_among(self.rims, rims)
        return self._select(mine), self._select(~mine)

    def _select(self, chosen: NDArray[np.bool_]) -> Gaps:
        return Gaps(self.rims[chosen], self.begins[chosen], self.ends[chosen])

    def repeated(self, sources: NDArray[np.int64]) -> Gaps:
        """Return gaps where rim i has those that rim ``sources[i]`` has here."""
        first = np.searchsorted(self.rims, sources, side="left")
        count = np.searchsorted(self.rims, sources, side="right") - first
        rims, place = rows_of(count)
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
