# SPDX-License-Identifier: LGPL-2.1-or-later
"""Turns of a spiral between nested closed laps: linear interpolation from lap to lap.

HQS24 eq. 11 (LM15 eq. 3 is the same between two laps only): a turn begins on one lap,
``x = (1 - s) inner + s outer`` with s rising from 0 to 1 once around, and ends on the
next. The paper takes points of equal normalized arc length for partners. In rooms that
are not convex that skews the step; here each point of the outer lap has the partner to
which the gradient leads, so that a ruling crosses all laps squarely. s rises evenly but
for its ends, where it is eased so that turns join with equal tangent and curvature.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d
from scipy.spatial import cKDTree
from shapely import LineString

from ..model import Floats
from ..shapes.points import distances_along

#: Share of a turn over which the rise of s builds up, and dies away.
EASE = 0.1
#: Partners are smoothed over so many samples.
SMOOTHING = 1.5
#: A partner farther than this over the nearest place of the other ring, and a little more [mm], is
#: none.
ASTRAY, SLACK = 2.5, 0.1
#: Partners that go back by more than this share of the ring are on a wrong leg of it; where a ring
#: goes another way it counts as farther by the second, over the distance of the rings, a radian.
BACK, ALONG = 0.02, 2.0
#: Rulings keep at least this share of their mean distance from each other.
LEAST = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class Ring:
    """A closed lap.

    Attributes
    ----------
    points : ndarray of shape (n, 2)
        In the direction of travel, the last is the first again [mm].
    along : ndarray of shape (n,)
        Length up to each point [mm].
    """

    points: Floats
    along: Floats

    @classmethod
    def of(cls, points: Floats) -> Ring:
        """Return the ring through `points`, shape (n, 2), whose last is the first again."""
        return cls(points, distances_along(points))

    @property
    def length(self) -> float:
        """Return the length [mm]."""
        return float(self.along[-1])

    @property
    def line(self) -> LineString:
        """Return it as a closed line."""
        return LineString(self.points)

    def at(self, s: Floats) -> Floats:
        """Return the points at distances along the ring, however many turns, shape (k, 2)."""
        s = np.mod(s, self.length)
        return np.column_stack([np.interp(s, self.along, self.points[:, i]) for i in (0, 1)])

    def ahead(self, s: Floats) -> Floats:
        """Return the unit directions of travel at distances along the ring, shape (k, 2)."""
        half = self.length / len(self.points)
        ahead = self.at(s + half) - self.at(s - half)
        return np.asarray(ahead / np.maximum(np.hypot(*ahead.T), 1e-12)[:, None])

    def locate(self, points: Floats, ahead: Floats | None = None, weight: float = 0.0) -> Floats:
        """Return the distances along the ring of the places nearest to `points`, shape (k,).

        O(log n) for each: the nearest place is beside the nearest vertex, if these are close.

        Parameters
        ----------
        points : ndarray of shape (k, 2)
            [mm]
        ahead : ndarray of shape (k, 2), optional
            Unit directions of travel there: where the ring goes another way it counts as farther.
        weight : float
            By so much for each radian, nearly [mm].
        """
        n = len(self.points) - 1
        vertices, sought = self.points[:-1], points
        if ahead is not None:
            vertices = np.hstack([vertices, weight * self.ahead(self.along[:-1])])
            sought = np.hstack([points, weight * ahead])
        tree = cKDTree(vertices, balanced_tree=False, compact_nodes=False)
        nearest = tree.query(sought)[1]
        found = []
        for first in ((nearest - 1) % n, nearest):
            a, b = self.points[first], self.points[first + 1]
            length = self.along[first + 1] - self.along[first]
            share = ((points - a) * (b - a)).sum(axis=1) / np.maximum(length, 1e-12) ** 2
            share = np.clip(share, 0.0, 1.0)
            off = np.hypot(*(a + share[:, None] * (b - a) - points).T)
            found.append((off, self.along[first] + share * length))
        (off, place), (other_off, other) = found
        return np.where(off <= other_off, place, other)


@dataclass(frozen=True, slots=True, eq=False)
class Match:
    """Which places of two rings are partners.

    Attributes
    ----------
    outer, inner : ndarray of shape (k,)
        Distances along the rings, increasing by one length from first to last [mm].
    """

    outer: Floats
    inner: Floats

    def inwards(self, s: Floats) -> Floats:
        """Return the places on the inner ring that belong to places on the outer one."""
        return _mapped(s, self.outer, self.inner)

    def outwards(self, s: Floats) -> Floats:
        """Return the places on the outer ring that belong to places on the inner one."""
        return _mapped(s, self.inner, self.outer)


def _mapped(s: Floats, knots: Floats, values: Floats) -> Floats:
    turns, rest = np.divmod(s - knots[0], knots[-1] - knots[0])
    return np.interp(rest + knots[0], knots, values) + turns * (values[-1] - values[0])


def match(inner: Ring, outer: Ring, places: Floats, moved: Floats) -> Match:
    """Match two rings.

    Parameters
    ----------
    inner, outer : Ring
        In the same direction.
    places : ndarray of shape (k,)
        Distances along `outer`, increasing from 0 [mm].
    moved : ndarray of shape (k, 2)
        Where those places come to when they move to the inner ring.
    """
    raw, off = _partners(inner, outer, places, moved)
    if (np.maximum.accumulate(raw) - raw).max() > BACK * inner.length:
        # where two legs of a ring are close to each other both go opposite ways
        raw, _ = _partners(inner, outer, places, moved, ALONG * off)
    # rulings do not cross: the nearest order that never goes back
    forward = np.maximum.accumulate(raw)
    back = np.minimum.accumulate(raw[::-1])[::-1]
    rises = np.diff((forward + back) / 2)
    rises = gaussian_filter1d(rises, SMOOTHING, mode="wrap")
    rises = np.maximum(rises, LEAST * inner.length / len(rises))
    rises *= inner.length / rises.sum()
    reached = raw[0] + np.concatenate([[0.0], np.cumsum(rises)])
    # the smoothing moves all places alike; take that back
    reached += float(np.mean(raw - reached))
    return Match(np.append(places, outer.length), reached)


def _partners(
    inner: Ring, outer: Ring, places: Floats, moved: Floats, weight: float = 0.0
) -> tuple[Floats, float]:
    """Return the places on the inner ring beside those on the outer one, and how far off it is.

    Parameters
    ----------
    inner, outer : Ring
    places : ndarray of shape (k,)
    moved : ndarray of shape (k, 2)
        See `match`.
    weight : float
        By how much the inner ring counts as farther where it goes another way [mm].

    Returns
    -------
    raw : ndarray of shape (k,)
        Distances along the inner ring, each by less than half of it from the one before [mm].
    off : float
        How far the inner ring is from the outer one, mostly [mm].
    """
    points = outer.at(places)
    ahead = np.tile(outer.ahead(places), (2, 1)) if weight else None
    beside, at = np.split(inner.locate(np.vstack([points, moved]), ahead, weight), 2)
    away = np.hypot(*(inner.at(beside) - points).T)
    # beside a saddle the gradient leads astray
    astray = np.hypot(*(moved - points).T) > ASTRAY * away + SLACK
    at = np.where(astray, beside, at)
    steps = np.diff(at, append=at[:1])
    steps = (steps + inner.length / 2) % inner.length - inner.length / 2
    return at[0] + np.concatenate([[0.0], np.cumsum(steps)]), float(np.median(away))


def rise(u: Floats) -> Floats:
    """Return a twice differentiable rise from 0 to 1, even but for its eased ends."""
    top = 1 / (1 - EASE)

    def eased(v: Floats) -> Floats:
        x = np.minimum(v / EASE, 1.0)
        return top * (EASE * (x**3 - x**4 / 2) + np.maximum(v - EASE, 0.0))

    return np.where(u < 0.5, eased(u), 1 - eased(1 - u))


def turn(
    inner: Ring, outer: Ring, matched: Match, start: float, spacing: float
) -> tuple[Floats, float]:
    """Return the turn from a place on the inner ring to its partner on the outer one.

    Parameters
    ----------
    inner, outer : Ring
    matched : Match
    start : float
        Distance along `inner` [mm].
    spacing : float
        Of the points [mm].

    Returns
    -------
    points : ndarray of shape (n, 2)
        [mm]
    end : float
        Distance along `outer` [mm].
    """
    end = float(matched.outwards(np.array(start)))
    u = np.linspace(0.0, 1.0, max(32, int(np.ceil(outer.length / spacing))) + 1)
    s = end + u * outer.length
    share = rise(u)[:, None]
    points = (1 - share) * inner.at(matched.inwards(s)) + share * outer.at(s)
    return points, end
