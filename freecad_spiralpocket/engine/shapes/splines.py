# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane B-splines: periodic interpolation, Bezier pieces, products, spirals, joining, sampling.

A closed curve is held as its Bezier pieces, an array of shape (n, d + 1, 2)
over breakpoints of shape (n + 1,): everything that LM15 does to curves is then
one array expression. scipy does the interpolation and the change of basis.
"""

from __future__ import annotations

import math

import numpy as np

from ..model import Floats, SplineCurve
from ..numerics.ragged import rows_of


def periodic_cubic(points: Floats) -> tuple[Floats, Floats]:
    """Interpolate a closed C2 cubic spline through points, with chord lengths as parameter.

    Parameters
    ----------
    points : ndarray of shape (n, 2)
        The last is not the first again [mm]; ``n >= 3``.

    Returns
    -------
    breaks : ndarray of shape (n + 1,)
        Parameters of the points, from 0 to 1.
    controls : ndarray of shape (n, 2)
        Periodic control points: piece ``i`` depends on controls ``i .. i + 3`` (modulo n).
    """
    chords = np.hypot(*np.diff(points, axis=0, append=points[:1]).T)
    breaks = np.concatenate([[0.0], np.cumsum(chords)])
    breaks /= breaks[-1]
    return breaks, periodic_controls(breaks, points)


def periodic_controls(breaks: Floats, points: Floats) -> Floats:
    """Return the control points of the closed C2 cubic spline that passes points at breaks.

    Parameters
    ----------
    breaks : ndarray of shape (n + 1,)
        From 0 to 1.
    points : ndarray of shape (n, 2)
        At all but the last, where the first comes again; ``n >= 3``.

    Returns
    -------
    ndarray of shape (n, 2)
        See `periodic_cubic`.
    """
    from scipy.interpolate import CubicSpline

    closed = np.vstack([points, points[:1]])
    _, second, first, value = CubicSpline(breaks, closed, bc_type="periodic").c
    # control i is the blossom of piece i at break i and the two before it
    past = np.roll(np.diff(breaks), 1)
    far = past + np.roll(past, 1)
    controls = value - first * (past + far)[:, None] / 3 + second * (past * far)[:, None] / 3
    return np.asarray(controls)


def periodic_beziers(breaks: Floats, controls: Floats) -> Floats:
    """Return the Bezier pieces of a periodic cubic B-spline.

    Parameters
    ----------
    breaks : ndarray of shape (n + 1,)
        From 0 to 1.
    controls : ndarray of shape (n, 2)
        As `periodic_cubic` returns them.

    Returns
    -------
    ndarray of shape (n, 4, 2)
    """
    n = len(controls)
    before, after = breaks[-4:-1] - 1.0, breaks[1:4] + 1.0
    knots = np.concatenate([before, breaks, after])
    c = controls[np.arange(n + 3) % n]
    # knot insertion in closed form: blossoms of the four control points of each piece, with the
    # knots k[i] .. k[i + 5] around the piece's own span [k[2], k[3]]
    k = np.stack([knots[i : i + n] for i in range(1, 7)])[..., None]
    p0, p1, p2, p3 = (c[i : i + n] for i in range(4))

    def between(a: Floats, b: Floats, low: Floats, high: Floats, at: Floats) -> Floats:
        return a + (b - a) * ((at - low) / (high - low))

    first = between(p1, p2, k[1], k[4], k[2])
    second = between(p1, p2, k[1], k[4], k[3])
    left = between(p0, p1, k[0], k[3], k[2])
    right = between(p2, p3, k[2], k[5], k[3])
    start = between(left, first, k[1], k[3], k[2])
    end = between(second, right, k[2], k[4], k[3])
    return np.stack([start, first, second, end], axis=1)


def multiply_linear(beziers: Floats, start: Floats, end: Floats) -> Floats:
    """Multiply Bezier pieces by linear factors, by convolution of the coefficients.

    Parameters
    ----------
    beziers : ndarray of shape (n, d + 1, 2)
    start, end : ndarray of shape (n,)
        The factor at each piece's start and end.

    Returns
    -------
    ndarray of shape (n, d + 2, 2)
        Pieces of degree ``d + 1`` (LM15 eq. 5, step 4).
    """
    n, count, _ = beziers.shape
    share = (np.arange(count + 1) / count)[None, :, None]
    padded = np.zeros((n, count + 2, 2))
    padded[:, 1:-1] = beziers
    return (1 - share) * start[:, None, None] * padded[:, 1:] + share * end[:, None, None] * padded[
        :, :-1
    ]


def spiral_beziers(
    breaks: Floats, inner: Floats, outer: Floats, stepover: float
) -> tuple[int, Floats]:
    """Return the number of turns and the exact spiral as quartic Bezier pieces (LM15 eq. 5).

    Parameters
    ----------
    breaks : ndarray of shape (n + 1,)
    inner, outer : ndarray of shape (n, 2)
        Periodic control points of ``d_in`` and ``d_out`` over the same breaks [mm].
    stepover : float
        [mm]

    Returns
    -------
    turns : int
        m, at least 1.
    beziers : ndarray of shape (m * n, 5, 2)
    """
    b_in, b_out = periodic_beziers(breaks, inner), periodic_beziers(breaks, outer)
    # control points bound the curve: no ruling is longer than the longest between them
    longest = float(np.linalg.norm(b_out - b_in, axis=2).max())
    turns = max(1, math.ceil(longest / stepover - 1e-9))
    lap = np.repeat(np.arange(turns), len(inner))
    start = (lap + np.tile(breaks[:-1], turns)) / turns
    end = (lap + np.tile(breaks[1:], turns)) / turns
    rising = multiply_linear(np.tile(b_out, (turns, 1, 1)), start, end)
    falling = multiply_linear(np.tile(b_in, (turns, 1, 1)), 1 - start, 1 - end)
    return turns, rising + falling


def join_c2(beziers: Floats, breaks: Floats) -> SplineCurve:
    """Join quartic Bezier pieces that meet with C2 continuity to one B-spline.

    Each interior knot then needs a multiplicity of 2 only: LM15's removal of removable knots
    (section 3.1, step 5) in closed form, by blossoms.

    Parameters
    ----------
    beziers : ndarray of shape (n, 5, 2)
    breaks : ndarray of shape (n + 1,)
        From 0 to 1.
    """
    steps = np.diff(breaks)[:, None]
    b = beziers
    # blossom at (a, b, b, c) from the piece over [a, b]: one affine step from (a, a, b, b)
    ahead = (steps[:-1] + steps[1:]) / steps[:-1]
    across = b[:-1, 2] + (b[:-1, 3] - b[:-1, 2]) * ahead
    middle = np.empty((2 * len(b) - 1, 2))
    middle[0::2], middle[1::2] = b[:, 2], across
    controls = np.vstack([b[0, :2], middle, b[-1, 3:]])
    knots = np.concatenate([np.zeros(5), np.repeat(breaks[1:-1], 2), np.ones(5)])
    return SplineCurve(4, knots, controls)


def sample_beziers(beziers: Floats, tolerance: float) -> Floats:
    """Sample connected Bezier pieces so that the chords keep within a tolerance.

    The number of chords of a piece follows from its second differences: the deviation of k even
    chords is at most ``d (d - 1) / 8 * max|second difference| / k^2``.

    Parameters
    ----------
    beziers : ndarray of shape (n, d + 1, 2)
        Each begins where the one before ends.
    tolerance : float
        [mm]

    Returns
    -------
    ndarray of shape (m, 2)
        First and last point are the curve's ends.
    """
    degree = beziers.shape[1] - 1
    second = np.diff(beziers, n=2, axis=1)
    bend = np.hypot(second[..., 0], second[..., 1]).max(axis=1)
    counts = np.maximum(1, np.ceil(np.sqrt(degree * (degree - 1) / 8 * bend / tolerance)))
    counts = counts.astype(int)
    piece, place = rows_of(counts)
    t = ((place + 1) / counts[piece])[:, None]
    # powers of t about the start of each piece: differences times binomials
    powers = [
        math.comb(degree, k) * np.diff(beziers[:, : k + 1], n=k, axis=1)[:, 0]
        for k in range(degree + 1)
    ]
    points = powers[degree][piece]
    for power in powers[-2::-1]:
        points = points * t + power[piece]
    return np.vstack([beziers[0, :1], points])
