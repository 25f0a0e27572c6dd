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

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d

from .model import Floats

DEGREE = 4
#: Fewest patches of a closed curve, and most.
FEWEST, MOST = 3, 200
#: Share of the breaks that follows the length; the rest follows the turning.
BY_LENGTH = 0.35
#: Turning is measured on points smoothed over this share of the length.
SMOOTHING = 0.006
#: Points of the curve that is fitted, for each break.
PER_PATCH = 6


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

    def at(self, u: Floats, order: int = 0) -> Floats:
        """Return points, or derivatives by the parameter, at parameters of shape (k,)."""
        knots, index = _periodic(self.breaks)
        from scipy.interpolate import BSpline

        spline = BSpline(knots, self.controls[index], DEGREE)
        return np.asarray(spline(np.mod(u, 1.0), order))

    def patches(self) -> tuple[Floats, Floats, Floats]:
        """Return the patches in Hermite form.

        Returns
        -------
        points, tangents : ndarray of shape (n + 1, 2)
            At the breaks, and the derivatives there by the parameter [mm].
        bulges : ndarray of shape (n, 2)
            w: on patch i, with u from 0 to 1 and tangents times the patch's span, the curve is
            the cubic Hermite curve plus ``u^2 (1 - u)^2 w``.
        """
        points, tangents = self.at(self.breaks), self.at(self.breaks, 1)
        spans = np.diff(self.breaks)[:, None]
        middle = self.at((self.breaks[:-1] + self.breaks[1:]) / 2)
        cubic = (points[:-1] + points[1:]) / 2 + spans * (tangents[:-1] - tangents[1:]) / 8
        return points, tangents, 16.0 * (middle - cubic)

    def sample(self, spacing: float) -> Floats:
        """Return points about `spacing` apart [mm], the last is the first again."""
        length = float(np.hypot(*np.diff(self.controls, axis=0, append=self.controls[:1]).T).sum())
        return self.at(np.linspace(0.0, 1.0, max(16, int(np.ceil(length / spacing))) + 1))


def fit_closed(points: Floats, deviation: float, guess: int = 8) -> ClosedQuartic:
    """Fit a closed curve with the least number of patches that keeps a bound.

    Parameters
    ----------
    points : ndarray of shape (m, 2)
        Along the curve; the last is not the first again [mm].
    deviation : float
        Largest distance of points from the curve [mm], positive. Not kept where `MOST` patches
        cannot.
    guess : int, optional
        With how many patches the search begins; saves time where it is near.
    """
    closed = np.vstack([points, points[:1]])
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(closed, axis=0).T))])
    effort = _effort(closed, along)

    curves: dict[int, ClosedQuartic] = {}

    def keeps(count: int) -> bool:
        curves[count] = _fit(closed, along, effort, count)
        return curves[count].deviation <= deviation

    # gallop away from the guess, then halve
    guess, step = int(np.clip(guess, FEWEST, MOST)), 1
    if keeps(guess):
        low, high = FEWEST - 1, guess
        while high > FEWEST and low < FEWEST:
            lower = max(FEWEST, high - step)
            low, high = (low, lower) if keeps(lower) else (lower, high)
            step *= 2
    else:
        low, high = guess, min(MOST, guess + step)
        while not keeps(high) and high < MOST:
            step *= 2
            low, high = high, min(MOST, high + step)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if keeps(middle) else (middle, high)
    return curves[high]


def _effort(closed: Floats, along: Floats) -> Floats:
    """Return the running sum of length and turning at each point, from 0 to 1."""
    count = max(64, len(closed))
    even = np.linspace(0.0, along[-1], count, endpoint=False)
    places = np.column_stack([np.interp(even, along, closed[:, i]) for i in (0, 1)])
    width = max(1.0, SMOOTHING * count)
    places = gaussian_filter1d(places, width, axis=0, mode="wrap")
    steps = np.roll(places, -1, axis=0) - places
    heading = np.arctan2(steps[:, 1], steps[:, 0])
    bend = np.abs((np.diff(heading, append=heading[:1]) + np.pi) % (2 * np.pi) - np.pi)
    bend = gaussian_filter1d(bend, width, mode="wrap")
    density = BY_LENGTH / count + (1 - BY_LENGTH) * bend / max(float(bend.sum()), 1e-12)
    total = np.concatenate([[0.0], np.cumsum(density)])
    return np.interp(along, np.append(even, along[-1]), total / total[-1])


def _fit(closed: Floats, along: Floats, effort: Floats, count: int) -> ClosedQuartic:
    """Return the least-squares curve of `count` patches, parameters corrected once."""
    s = along / along[-1]
    breaks = np.interp(np.arange(count + 1) / count, effort, s)
    u, points = s[:-1], closed[:-1]
    if len(points) < PER_PATCH * count:
        u = np.interp(np.arange(PER_PATCH * count) / (PER_PATCH * count), effort, s)
        points = np.column_stack([np.interp(u, s, closed[:, i]) for i in (0, 1)])
    for _ in range(2):
        controls = _least_squares(breaks, u, points)
        curve = ClosedQuartic(breaks, controls, 0.0)
        off, tangent = points - curve.at(u), curve.at(u, 1)
        square = (tangent**2).sum(axis=1) + 1e-12
        u = u + (off * tangent).sum(axis=1) / square
    normal = (off[:, 0] * tangent[:, 1] - off[:, 1] * tangent[:, 0]) / np.sqrt(square)
    return ClosedQuartic(breaks, controls, float(np.abs(normal).max()))


def _periodic(breaks: Floats) -> tuple[Floats, np.ndarray]:
    """Return the double knots of one period and what it needs beside, and the controls' order."""
    n = len(breaks) - 1
    before, after = breaks[-3:-1] - 1.0, breaks[1:3] + 1.0
    knots = np.repeat(np.concatenate([before, breaks, after]), 2)
    return knots, np.arange(len(knots) - DEGREE - 1) % (2 * n)


def _least_squares(breaks: Floats, u: Floats, points: Floats) -> Floats:
    knots, index = _periodic(breaks)
    n, order = 2 * (len(breaks) - 1), DEGREE + 1
    from scipy.interpolate import BSpline

    matrix = BSpline.design_matrix(np.mod(u, 1.0), knots, DEGREE)
    # each point has the same number of entries; their products are the normal equations
    basis, column = matrix.data.reshape(-1, order), index[matrix.indices].reshape(-1, order)
    pairs = (column[:, :, None] * n + column[:, None, :]).ravel()
    products = (basis[:, :, None] * basis[:, None, :]).ravel()
    square = np.bincount(pairs, products, n * n).reshape(n, n)
    square[np.diag_indices(n)] += 1e-9 * np.trace(square) / n
    right = [np.bincount(column.ravel(), (basis * x[:, None]).ravel(), n) for x in points.T]
    return np.asarray(np.linalg.solve(square, np.column_stack(right)))
