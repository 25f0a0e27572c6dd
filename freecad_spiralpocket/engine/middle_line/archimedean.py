# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended Archimedean spiral A(c, b): even laps about a point or a curve [EAS07, 2.2].

Its distance to the center c grows by b a turn, evenly along the first lap and on the
same rays on all others. About a point that is
Archimedes' spiral. Lap k lies between the offsets of c at ``w + (k - 1) b`` and
``w + k b``; each place of it is on the shortest way between the two, which is b long
wherever the outer one is. It ends with one turn at constant distance.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely
from scipy.ndimage import gaussian_filter1d
from scipy.spatial import cKDTree
from shapely import LineString, Polygon

from ..growth.strokes import CHORD
from ..model import Floats
from ..shapes.points import three_point_curvature
from ..shapes.polyline import points_at
from ..shapes.shaping import grow_coarsely, oriented
from .coverable import Center

#: Curvature is measured over this length to both sides, over R.
WINDOW = 0.5
#: Radius of the last lap on the inside of bends that are tighter than its distance, over R.
ROUNDING = 0.5
#: On the laps before it is larger by b each, so that they stay b apart there too, unless that
#: takes the first lap this far off its distance, over b.
FILLED = 0.6
#: Jumps of the shortest way between two laps are smoothed over this length [mm].
SMOOTHING = 1.0
#: It is sought among places this far apart [mm].
FINE = 0.1
#: Chords of a lap keep within this [mm].
SAG = 0.003


@dataclass(frozen=True, eq=False)
class Spiral:
    """The offsets of a center between which a spiral unwinds.

    Attributes
    ----------
    center : Center
    within : tuple of shapely.Polygon
        What lies within each offset; the first is what the opening cleared.
    """

    center: Center
    within: tuple[Polygon, ...]

    @cached_property
    def rings(self) -> list[LineString]:
        """Return the offsets as closed lines, counter-clockwise."""
        return [LineString(p.exterior.coords) for p in self.within]

    def unwound(self, start: float) -> tuple[Floats, float]:
        """Return the spiral from the first ring, at `start` [mm] along it, to the last.

        Returns
        -------
        points : ndarray of shape (n, 2)
        end : float
            Where along the last ring it ends [mm].
        """
        inner, at = self.rings[0], start
        pieces = [points_at(inner, np.array([start]))]
        # how far round, in [0, 1], from the start to places along the ring
        along, share = np.array([0.0, inner.length]), np.array([0.0, 1.0])
        for outer in self.rings[1:]:
            begin = float(outer.project(shapely.Point(points_at(inner, np.array([at]))[0])))
            ahead = _steps(outer)
            onto = points_at(outer, (begin + ahead) % outer.length)
            feet = _feet(inner, onto, float(ahead[0]))
            foot = points_at(inner, feet % inner.length)
            # a ray has the same share on all laps, so that they stay b apart
            share = np.interp(feet - feet[-1] + inner.length, along, share)
            pieces.append(foot + share[:, None] * (onto - foot))
            inner, at = outer, begin
            along, share = np.append(0.0, ahead), np.append(0.0, share)
        pieces.append(points_at(inner, (at + _steps(inner)) % inner.length))
        return np.vstack(pieces), at


def _feet(ring: LineString, points: Floats, spacing: float) -> Floats:
    """Return where along a closed line points around it have their feet, never going back [mm].

    On the inside of a bend that is tighter than the points' distance the nearest places run
    back and jump: they wait and are smoothed instead.
    """
    even = np.arange(0.0, ring.length, FINE)
    feet = even[cKDTree(points_at(ring, even)).query(points)[1]]
    steps = np.diff(feet, prepend=feet[-1])
    steps = (steps + ring.length / 2) % ring.length - ring.length / 2
    ahead = feet[-1] - ring.length + np.cumsum(steps)
    # once round and a little more at both ends, so that they meet
    thrice = np.concatenate([ahead - ring.length, ahead, ahead + ring.length])
    thrice = gaussian_filter1d(np.maximum.accumulate(thrice), SMOOTHING / spacing)
    return np.asarray(thrice[len(points) : 2 * len(points)])


def _steps(ring: LineString) -> Floats:
    """Return lengths along a lap, to its end: chords of a circle as long keep within `SAG`."""
    chord = min(CHORD, math.sqrt(8 * SAG * ring.length / (2 * math.pi)))
    count = max(16, math.ceil(ring.length / chord))
    return ring.length * np.arange(1, count + 1) / count


def spiral_about(center: Center, half_width: float, stepover: float, radius: float) -> Spiral:
    """Return the spiral about a center.

    Parameters
    ----------
    center : Center
    half_width : float
        Distance from which it starts: so far the center is open [mm].
    stepover, radius : float
        b and R [mm].
    """
    curve, least = center.curve, ROUNDING * radius
    shapely.prepare(curve)
    for wide in range(center.laps, -1, -1):
        bends = [least + min(center.laps - k, wide) * stepover for k in range(center.laps + 1)]
        first = _offset(curve, half_width, bends[0])
        outside = shapely.points(first.exterior.coords)
        if shapely.dwithin(curve, outside, half_width + FILLED * stepover).all():
            break
    rest = [_offset(curve, half_width + k * stepover, b) for k, b in enumerate(bends) if k > 0]
    return Spiral(center, (first, *rest))


def _offset(curve: shapely.Geometry, distance: float, bend: float) -> Polygon:
    """Return what lies within an offset, reentrant bends at least of a radius [mm]."""
    shape = oriented(grow_coarsely(grow_coarsely(curve, distance + bend), -bend))
    return Polygon(shape.exterior)


def bend_at(ring: LineString, at: float, radius: float) -> tuple[Floats, float, float]:
    """Return point, heading [rad] and curvature [1/mm] of a closed line at `at` [mm] along it."""
    window = WINDOW * radius
    s = (at + window * np.array([-1.0, 0.0, 1.0])) % ring.length
    a, b, c = points_at(ring, s)
    chord = c - a
    return b, float(np.arctan2(chord[1], chord[0])), float(three_point_curvature(a, b, c))
