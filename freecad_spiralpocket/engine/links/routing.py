# SPDX-License-Identifier: LGPL-2.1-or-later
"""The long way round: a smooth link through free ground where no single curve fits.

The shortest way over the coarsened raster of free ground becomes the control
polygon of a clamped cubic B-spline, tangent at both ends; the closer its control
points, the closer it keeps to that way.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import shapely
from shapely import LineString, Polygon

from ..model import Floats
from ..numerics.filters import dilated
from ..shapes.points import three_point_curvature
from .cleared import ClearedMap
from .ground import COARSE, Ground

#: Longest chord of a link that is tried, and of one that is taken [mm].
CHORD, FINE = 0.12, 0.05
#: A curve is made whole where of its points one of so many is on free ground.
GLANCE = 12
#: Distances of control points tried, over R.
SPACINGS = (3.0, 2.0, 1.3, 0.8, 0.5, 0.3)
#: A way is looked for nearer to what stands where it is longer than so much times the straight one
#: and D, and taken if it is shorter than this share of the one before.
DETOUR, SHORTER = 2.0, 0.7
#: From middle to middle of coarse cells a way may be so many of them longer than it is.
HOPE = 3
#: How far the loops go that turn round, over R.
TURNS = (0.5, 1.0)


class LongWays:
    """The long ways round from a place, on ground that is free now.

    Parameters
    ----------
    start, heading : ndarray of shape (2,)
        Where all ways begin [mm], and the unit direction there.
    cleared : ClearedMap
    fence : shapely.Polygon
        Is not left; prepared.
    radius : float
        R [mm].
    least_radius : float
        Where a way would bend more tightly [mm], because it leads back from where the cutter comes
        or goes, it turns round in a loop if there is room for one.
    """

    def __init__(
        self,
        start: Floats,
        heading: Floats,
        cleared: ClearedMap,
        fence: Polygon,
        radius: float,
        least_radius: float = 0.0,
    ) -> None:
        self._start, self._heading, self._cleared, self._fence = start, heading, cleared, fence
        self._radius, self._least_radius = radius, least_radius
        self._grounds: list[Ground] = []
        self._hopeful: Ground | None = None

    def to(self, end: Floats, arriving: Floats) -> Floats | None:
        """Return a smooth way, shape (n, 2) [mm]; None if there is none.

        Parameters
        ----------
        end, arriving : ndarray of shape (2,)
            Where it ends [mm], and the unit direction there.
        """
        best, longest = None, np.inf
        straight = float(np.hypot(*(end - self._start)))
        for ground in self._all_grounds():
            way = ground.way_to(end, longest)
            if way is not None and LineString(way).length < longest:
                found = self._along(LineString(way), end, arriving)
                length = np.inf if found is None else LineString(found).length
                if length < longest:
                    best, longest = found, SHORTER * length
            # nearer to what stands there may be a way through
            if longest < SHORTER * (DETOUR * straight + 2 * self._radius):
                break
            if best is not None and not self._may_be_shorter(end, longest):
                break
        return best

    def _may_be_shorter(self, end: Floats, longest: float) -> bool:
        """Return whether there may be a way shorter than `longest` [mm] on any ground; quick."""
        if self._hopeful is None:
            self._hopeful = Ground(self._cleared, self._cleared.near, self._start, hopeful=True)
        slack = HOPE * COARSE * self._cleared.pixel
        return self._hopeful.way_to(end, longest + slack) is not None

    def _all_grounds(self) -> Iterator[Ground]:
        """Yield ground well off what stands, all free ground, that up to its very edge, and finer.

        Each has ways that the ones before have not.
        """
        cleared = self._cleared
        free_ground = (cleared.free, cleared.free, cleared.near, cleared.free)
        for i, free in enumerate(free_ground):
            if i == len(self._grounds):
                if i == 0:
                    # a way along the very edge is hard to follow smoothly
                    closed = ~free
                    for _ in range(COARSE):
                        closed = dilated(closed)
                    free = ~closed
                coarse = 1 if i == 3 else COARSE
                self._grounds.append(Ground(cleared, free, self._start, coarse))
            yield self._grounds[i]

    def _along(self, way: LineString, end: Floats, arriving: Floats) -> Floats | None:
        """Return a free curve near a way, tangent at both ends; None if none is free."""
        found = None
        spacings = self._radius * np.array(SPACINGS)
        pieces = np.maximum(2, np.ceil(way.length / spacings)).astype(int).tolist()
        for spacing, count in zip(spacings, pieces, strict=True):
            handle = min(spacing, way.length / 3) / 2
            ends = [(handle * self._heading[None], handle * arriving[None])]
            found = next(self._free_curves(way, count, end, ends), None)
            if found is not None:
                break
        if found is None or tightest_bend(found) >= self._least_radius:
            return found
        turns = [
            (leaving, reaching)
            for leaving in _turns(self._heading, self._radius)
            for reaching in _turns(arriving, self._radius)
        ]
        for count in dict.fromkeys(pieces):  # short ways have the same again and again
            smooth = next(self._free_curves(way, count, end, turns, self._least_radius), None)
            if smooth is not None:
                return smooth
        return found

    def _free_curves(
        self,
        way: LineString,
        pieces: int,
        end: Floats,
        turns: Sequence[tuple[Floats, Floats]],
        least_radius: float = 0.0,
    ) -> Iterator[Floats]:
        """Yield the free curves near a way that bend no more tightly, the shortest first.

        Parameters
        ----------
        way : shapely.LineString
        pieces : int
            Into so many the control points part it.
        end : ndarray of shape (2,)
        turns : sequence of pair of ndarray of shape (k, 2)
            What is added to the start, and taken away from the end backwards, for the control
            points beside them [mm].
        least_radius : float
            [mm]
        """
        places = np.linspace(0, 1, pieces + 1)[1:-1]
        middle = shapely.get_coordinates(
            shapely.line_interpolate_point(way, places, normalized=True)
        )
        free: list[tuple[float, Floats]] = []
        for size in sorted({(len(a), len(b)) for a, b in turns}):
            of_size = [(a, b) for a, b in turns if (len(a), len(b)) == size]
            controls = np.array(
                [
                    np.vstack([self._start, self._start + a, middle, end - b[::-1], end])
                    for a, b in of_size
                ]
            )
            count = max(97, int(way.length / CHORD))
            controls = controls[self._cleared.are_free(clamped_spline(controls, count, GLANCE))]
            curves = clamped_spline(controls, count)
            good = self._cleared.are_free(curves) & (tightest_bend(curves) >= least_radius)
            lengths = np.hypot(*np.moveaxis(np.diff(curves[good], axis=1), -1, 0)).sum(axis=1)
            free += zip(lengths.tolist(), controls[good], strict=True)
        for length, controls in sorted(free, key=lambda pair: pair[0]):
            curve = clamped_spline(controls, max(193, int(length / FINE)))
            if self._cleared.are_free(curve) and self._fence.covers(LineString(curve)):
                yield curve


def _turns(heading: Floats, radius: float) -> list[Floats]:
    """Return the first control points after a place, straight on and round to both sides [mm]."""
    aside = np.array([-heading[1], heading[0]])
    wide = [np.vstack([w * heading, w * (heading + s * aside)]) for w in TURNS for s in (1, -1)]
    return [radius * turn for turn in [0.5 * heading[None], *wide]]


def tightest_bend(points: Floats) -> Floats:
    """Return the least radius of the circles through three points in a row [mm].

    Parameters
    ----------
    points : ndarray of shape (..., n, 2)
        [mm]
    """
    a, b, c = points[..., :-2, :], points[..., 1:-1, :], points[..., 2:, :]
    with np.errstate(divide="ignore"):
        return np.asarray(1 / np.abs(three_point_curvature(a, b, c)).max(axis=-1))


def clamped_spline(controls: Floats, count: int, every: int = 1) -> Floats:
    """Return `count` points of clamped cubic B-splines, by de Boor's algorithm.

    Parameters
    ----------
    controls : ndarray of shape (..., n, 2)
        [mm]
    count : int
    every : int
        Only one of so many points is returned, and the last.

    Returns
    -------
    ndarray of shape (..., count, 2)
        [mm]
    """
    n = controls.shape[-2]
    degree = min(3, n - 1)
    knots = np.concatenate([np.zeros(degree), np.linspace(0, 1, n - degree + 1), np.ones(degree)])
    u = np.linspace(0, 1, count)
    u = np.append(u[:-1:every], u[-1])
    span = np.clip(np.searchsorted(knots, u, side="right") - 1, degree, n - 1)
    points = controls[..., span[:, None] + np.arange(-degree, 1), :]
    for r in range(1, degree + 1):
        i = span[:, None] + np.arange(r - degree, 1)
        low, high = knots[i], knots[i + degree - r + 1]
        share = ((u[:, None] - low) / (high - low))[..., None]
        points = (1 - share) * points[..., :-1, :] + share * points[..., 1:, :]
    return points[..., 0, :]
