# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed curves of Hermite quartic patches, C2 all round, fitted to points [HQS24].

A patch of HQS24 (eq. 5 and 6) is the cubic Hermite curve of its end points ``P0, P1`` and
end tangents ``T0 = k0 (cos t0, sin t0)``, ``T1``, plus ``u^2 (1 - u)^2 w`` with
``w = alpha (P0 - P1) + beta (T0 - T1)``. alpha and beta may be anything, so w may: the
patches are the quartics, and a chain of them that is C2 is a quartic B-spline whose
knots are double. That makes the fit linear.

The paper chooses the parameters of one patch after the other by a genetic algorithm and
a descent, each patch as long as the deviation allows; the first and the last of a curve
then meet with a kink. Here all patches of a curve are fitted at once, by least squares
on a periodic spline: the same curve every time, C2 where it closes too. The breaks are
spread evenly over length and turning, and the least number of patches is sought that
keeps the bound. On contours like the paper's (2500 points, 0.5 mm) that needs no more
patches than its 25 (`./dev bench papers hqs24` prints them).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from ..model import Floats
from ..shapes.points import distances_along, wrapped

DEGREE = 4
#: Fewest patches of a closed curve, and most.
FEWEST, MOST = 3, 200
#: Share of the breaks that follows the length; the rest follows the turning.
BY_LENGTH = 0.35
#: Turning is measured on points smoothed over this share of the length.
SMOOTHING = 0.006
#: Points of the curve that is fitted, for each break.
PER_PATCH = 6
#: The deviation rises about with this power of fewer patches, where contours are noisy, and falls
#: about with this power of more; until both sides are known that tells how many are tried.
FALLING, RISING = 2.0, 4.0
#: Smaller deviations over the bound count as this; in every so many steps the middle is tried.
LEAST_OFF, HALVED, GROWS = 0.05, 4, 0.02
#: Controls that a patch has in common are no farther apart than this where the ring is folded.
BAND = 9
#: Powers of the parameter from Bezier points: rows by power.
POWERS = np.array(
    [[1, 0, 0, 0, 0], [-4, 4, 0, 0, 0], [6, -12, 6, 0, 0], [-4, 12, -12, 4, 0], [1, -4, 6, -4, 1]],
    float,
)
#: All pairs of the controls of a patch.
FIRST, SECOND = np.triu_indices(DEGREE + 1)


@dataclass(frozen=True, slots=True, eq=False)
class ClosedQuartic:
    """A closed C2 curve of n quartic patches over the parameter [0, 1].

    Attributes
    ----------
    breaks : ndarray of shape (n + 1,)
        From 0 to 1.
    controls : ndarray of shape (2 n, 2)
        Of the periodic B-spline with double knots [mm].
    deviation : float
        Largest distance of the fitted points from it [mm].
    """

    breaks: Floats
    controls: Floats
    deviation: float

    def sample(self, spacing: float) -> Floats:
        """Return points about `spacing` apart [mm], the last is the first again."""
        length = float(np.hypot(*np.diff(self.controls, axis=0, append=self.controls[:1]).T).sum())
        u = np.linspace(0.0, 1.0, max(16, int(np.ceil(length / spacing))) + 1)
        basis = _Basis(self.breaks)
        points, _ = basis.curve(self.controls, basis.at(u))
        return np.ascontiguousarray(points.T)


class ClosedFit:
    """Fits curves to closed contours, and knows those that it has tried.

    Parameters
    ----------
    points : ndarray of shape (m, 2)
        Along the curve; the last is not the first again [mm].
    """

    def __init__(self, points: Floats) -> None:
        self._closed = np.vstack([points, points[:1]])
        self._along = distances_along(self._closed)
        self._effort = _effort(self._closed, self._along)
        self._tried: dict[int, ClosedQuartic] = {}

    @property
    def length(self) -> float:
        """Return the length of the contour [mm]."""
        return float(self._along[-1])

    def within(self, deviation: float, guess: int = 8) -> ClosedQuartic:
        """Return the curve with the least number of patches that keeps a bound.

        Parameters
        ----------
        deviation : float
            Largest distance of points from the curve [mm], positive. Not kept where `MOST`
            patches cannot.
        guess : int, optional
            With how many patches the search begins; saves time where it is near.
        """
        low, high = FEWEST - 1, MOST + 1  # too few patches, enough
        below = above = math.nan  # the deviations there over the bound
        count, step = int(np.clip(guess, FEWEST, MOST)), 0
        while high - low > 1:
            step += 1
            off = max(self._of(count).deviation / deviation, LEAST_OFF)
            if off <= 1:
                high, above = count, off
            else:
                low, below = count, off
            if step % HALVED == 0 and high <= MOST:
                ahead = float(np.sqrt(low * high))
            elif low < FEWEST or high > MOST:
                ahead = count * (off ** (1 / FALLING) if off <= 1 else off ** (1 / RISING) + GROWS)
            else:  # as if the deviation fell evenly on a logarithmic scale
                ahead = low * (high / low) ** (math.log(below) / math.log(below / above))
            count = min(max(low + 1, math.ceil(ahead)), high - 1)
        return self._of(min(high, MOST))

    def _of(self, count: int) -> ClosedQuartic:
        """Return the least-squares curve of so many patches."""
        if count not in self._tried:
            self._tried[count] = _fit(self._closed, self._along, self._effort, count)
        return self._tried[count]


def _effort(closed: Floats, along: Floats) -> Floats:
    """Return the running sum of length and turning at each point, from 0 to 1."""
    count = max(64, len(closed))
    even = np.linspace(0.0, along[-1], count, endpoint=False)
    places = np.column_stack([np.interp(even, along, closed[:, i]) for i in (0, 1)])
    width = max(1.0, SMOOTHING * count)
    places = gaussian_filter1d(places, width, axis=0, mode="wrap")
    steps = np.roll(places, -1, axis=0) - places
    heading = np.arctan2(steps[:, 1], steps[:, 0])
    bend = np.abs(wrapped(np.diff(heading, append=heading[:1])))
    bend = gaussian_filter1d(bend, width, mode="wrap")
    density = BY_LENGTH / count + (1 - BY_LENGTH) * bend / max(float(bend.sum()), 1e-12)
    total = np.concatenate([[0.0], np.cumsum(density)])
    return np.interp(along, np.append(even, along[-1]), total / total[-1])


def _fit(closed: Floats, along: Floats, effort: Floats, count: int) -> ClosedQuartic:
    """Return the least-squares curve of `count` patches, parameters corrected once."""
    s = along / along[-1]
    breaks = np.interp(np.arange(count + 1) / count, effort, s)
    u, points = s[:-1], closed[:-1].T
    if points.shape[1] < PER_PATCH * count:
        u = np.interp(np.arange(PER_PATCH * count) / (PER_PATCH * count), effort, s)
        points = np.stack([np.interp(u, s, x) for x in closed.T])
    basis = _Basis(breaks)
    for _ in range(2):
        places = basis.at(u)
        controls = basis.nearest(places, points)
        reached, (tx, ty) = basis.curve(controls, places)
        dx, dy = points - reached
        square = tx * tx + ty * ty + 1e-12
        u = u + (dx * tx + dy * ty) / square
    normal = (dx * ty - dy * tx) / np.sqrt(square)
    return ClosedQuartic(breaks, controls, float(np.abs(normal).max()))


class _Basis:
    """The splines over one period of double knots, patch by patch."""

    def __init__(self, breaks: Floats) -> None:
        self.breaks, self.spans = breaks, np.diff(breaks)
        n = len(self.spans)
        #: The five controls of each patch, shape (5, n).
        self.columns = (1 + np.arange(DEGREE + 1)[:, None] + 2 * np.arange(n)) % (2 * n)
        # each patch's span over its own and the one before, and over its own and the next
        before = self.spans / (self.spans + np.roll(self.spans, 1))
        after = self.spans / (self.spans + np.roll(self.spans, -1))
        near, far = 1 - before, 1 - after
        # what the five controls weigh in the five Bezier points, shape (5, 5, n)
        beziers = np.zeros((DEGREE + 1, DEGREE + 1, n))
        beziers[0, :3] = before * before, 2 * before * near, near * near
        beziers[1, 1:3] = before, near
        beziers[2, 2] = 1.0
        beziers[3, 2:4] = far, after
        beziers[4, 2:] = far * far, 2 * far * after, after * after
        #: The same for the powers of the parameter within the patch.
        self.powers = (POWERS @ beziers.reshape(DEGREE + 1, -1)).reshape(beziers.shape)

    def at(self, u: Floats) -> _Places:
        """Return where parameters of shape (k,) are."""
        u = u - np.floor(u)
        patch = np.searchsorted(self.breaks[1:-1], u, side="right")
        v = (u - self.breaks[patch]) / self.spans[patch]
        c0, c1, c2, c3, c4 = np.take(self.powers, patch, axis=2)
        weights = (((c4 * v + c3) * v + c2) * v + c1) * v + c0
        slopes = ((4 * c4 * v + 3 * c3) * v + 2 * c2) * v + c1
        return _Places(patch, weights, slopes / self.spans[patch])

    def curve(self, controls: Floats, places: _Places) -> tuple[Floats, Floats]:
        """Return points and derivatives by the parameter, both of shape (2, k)."""
        chosen = np.take(controls.T, np.take(self.columns, places.patch, axis=1), axis=1)
        return (chosen * places.weights).sum(axis=1), (chosen * places.slopes).sum(axis=1)

    def nearest(self, places: _Places, points: Floats) -> Floats:
        """Return the controls, shape (2 n, 2), that come nearest to points of shape (2, k)."""
        from scipy.linalg.lapack import dpbsv

        n, weights = len(self.spans), places.weights
        # a ring of controls folded in two is a band: 0, n - 1, 1, n - 2, ...
        block = np.arange(n)
        fold = np.where(2 * block < n, 2 * block, 2 * (n - block) - 1)
        place = (2 * fold[:, None] + np.arange(2)).ravel()
        at = place[self.columns]
        one, other = at[FIRST], at[SECOND]
        cells = (BAND - np.abs(one - other)) * 2 * n + np.maximum(one, other)
        products = places.sums(weights[FIRST] * weights[SECOND], n)
        band = np.bincount(cells.ravel(), products.ravel(), (BAND + 1) * 2 * n)
        band = band.reshape(BAND + 1, 2 * n)
        band[BAND] += 1e-9 * band[BAND].sum() / (2 * n)
        sums = [places.sums(x * weights, n) for x in points]
        right = np.stack([np.bincount(at.ravel(), s.ravel(), 2 * n) for s in sums], axis=1)
        _, solved, failed = dpbsv(band, right, overwrite_ab=True, overwrite_b=True)
        if failed:
            raise np.linalg.LinAlgError(f"The fit of {n} patches has no solution.")
        return np.asarray(solved[place])


@dataclass(frozen=True, slots=True, eq=False)
class _Places:
    """Where parameters are on a curve.

    Attributes
    ----------
    patch : ndarray of int, shape (k,)
    weights, slopes : ndarray of shape (5, k)
        Of the patch's five controls in the point, and in the derivative by the parameter.
    """

    patch: NDArray[np.intp]
    weights: Floats
    slopes: Floats

    def sums(self, rows: Floats, n: int) -> Floats:
        """Return the sums of rows of values, shape (r, k), over each of n patches, (r, n)."""
        cells = self.patch + n * np.arange(len(rows))[:, None]
        total = np.bincount(cells.ravel(), rows.ravel(), n * len(rows))
        return total.reshape(-1, n).astype(float)
