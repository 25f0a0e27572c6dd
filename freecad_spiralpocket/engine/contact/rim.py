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

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from .sampling import Samples
from .swept import Pieces

#: The cutter's own trail is taken up to this many radii behind its center: at the very
#: center the bearing is undefined.
OWN_TRAIL_GAP = 1e-6
#: Nearer than this [mm] the cutter center is back on earlier motion: all is cleared.
SAME_PLACE = 1e-9


def cleared_intervals(
    samples: Samples, rows: NDArray[np.int64], piece: NDArray[np.int64], pieces: Pieces, r: float
) -> tuple[NDArray[np.int64], Floats, Floats]:
    """Return the rim intervals that pieces have cleared, lines and arcs.

    Parameters
    ----------
    samples : Samples
    rows, piece : ndarray of int, shape (k,)
        Sample and piece of each pair; the piece is earlier or the sample's own.
    pieces : Pieces
    r : float
        Cutter radius [mm].

    Returns
    -------
    pair, low, high
        As `cleared_by_lines`.
    """
    xy, heading = samples.points[rows, :2], samples.headings[rows]
    arc = pieces.is_arc[piece]
    if not arc.any():
        pair, low, high = cleared_by_lines(xy, heading, pieces, piece, r)
        return pair, low, high
    lines, arcs = np.flatnonzero(~arc), np.flatnonzero(arc)
    straight = cleared_by_lines(xy[lines], heading[lines], pieces, piece[lines], r)
    own = samples.pieces[rows[arcs]] == piece[arcs]
    until = np.where(own, samples.fractions[rows[arcs]], 1.0)
    bent = cleared_by_arcs(xy[arcs], heading[arcs], pieces, piece[arcs], r, until, own)
    return (
        np.concatenate([lines[straight[0]], arcs[bent[0]]]),
        np.concatenate([straight[1], bent[1]]),
        np.concatenate([straight[2], bent[2]]),
    )


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
    again = (h < SAME_PLACE) & (first < SAME_PLACE) & (last > -SAME_PLACE)
    low, high = np.where(again, -np.pi, low), np.where(again, np.pi, high)
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
        t0, t1 = t0[pair], t1[pair]
        low, high = _arc_interval(t0, t1, rho[pair], far[pair], r)
        # along the circle too: on a wide one the own trail's gap is a tiny angle
        along = rho[pair]
        again = (np.abs(far - rho)[pair] < SAME_PLACE) & (along * t0 < SAME_PLACE)
        again &= along * t1 > -SAME_PLACE
        low, high = np.where(again, -np.pi, low), np.where(again, np.pi, high)
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

    def include(t: Floats, at: NDArray[np.intp]) -> None:
        x, y = rho[at] * np.cos(t) - far[at], rho[at] * np.sin(t)
        # continuous in t: seen from inside the circle the bearing runs through 0, seen from
        # outside through pi
        turned = np.where(inside[at], 0.0, np.pi)
        sign = np.where(inside[at], 1.0, -1.0)
        phi = turned + np.arctan2(sign * y, sign * x)
        half = np.arccos(np.minimum(np.hypot(x, y) / (2 * r), 1.0))
        low[at] = np.minimum(low[at], phi - half)
        high[at] = np.maximum(high[at], phi + half)

    every = np.arange(len(t0))
    include(t0, every)
    include(t1, every)
    for reach in (rho + r, rho - r):
        reach = np.where(reach == 0.0, 1e-12, reach)
        cos_square = (reach * reach + far * far - r * r) / (2 * reach * far)
        square = np.arccos(np.clip(cos_square, -1.0, 1.0))
        exists = np.abs(cos_square) <= 1.0
        for t in (square, -square):
            valid = np.flatnonzero(exists & (t > t0) & (t < t1))
            include(t[valid], valid)
    return low, high
