# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended Archimedean spiral A(c, b): even laps about a point or a curve [EAS07, 2.2].

Its distance to the center c grows by b a turn, evenly along the lap. About a point that is
Archimedes' spiral. Lap k lies between the offsets of c at ``w + (k - 1) b`` and
``w + k b``; each place of it is on the shortest way between the two, which is b long
wherever the outer one is. It ends with one turn at constant distance.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely
from scipy.ndimage import gaussian_filter1d
from shapely import LineString, Polygon

from .coverable import Center
from .fronts import buffer, oriented
from .model import Floats
from .polyline import points_at
from .strokes import CHORD

#: Curvature is measured over this length to both sides, over R.
WINDOW = 0.5
#: Radius of the inside of bends, over R, where the laps' distance exceeds that of the center.
ROUNDING = 0.5
#: Jumps of the shortest way between two laps are smoothed over this length [mm].
SMOOTHING = 1.0
#: Chords of a lap keep within this [mm].
SAG = 0.003


@dataclass(frozen=True, slots=True, eq=False)
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

    @property
    def rings(self) -> list[LineString]:
        """Return the offsets as closed lines, counter-clockwise."""
        return [LineString(p.exterior.coords) for p in self.within]

    def unwound(self, start: float) -> Floats:
        """Return the spiral from the first ring, at `start` [mm] along it, to the last.

        Returns
        -------
        ndarray of shape (n, 2)
        """
        rings = self.rings
        here = points_at(rings[0], np.array([start]))
        pieces = [here]
        for inner, outer in pairwise(rings):
            begin = float(outer.project(shapely.Point(here[0])))
            count = _count(outer)
            share = np.arange(1, count + 1) / count
            onto = points_at(outer, (begin + share * outer.length) % outer.length)
            foot = points_at(inner, _feet(inner, onto, outer.length / count))
            pieces.append(foot + share[:, None] * (onto - foot))
            here = onto[-1:]
        last = rings[-1]
        begin = float(last.project(shapely.Point(here[0])))
        count = _count(last)
        share = np.arange(1, count + 1) / count
        pieces.append(points_at(last, (begin + share * last.length) % last.length))
        return np.vstack(pieces)

    def end_of(self, start: float) -> float:
        """Return where along the last ring the spiral ends that begins at `start` [mm]."""
        rings = self.rings
        here = points_at(rings[0], np.array([start]))[0]
        for ring in rings[1:]:
            here = points_at(ring, np.array([ring.project(shapely.Point(here))]))[0]
        return float(rings[-1].project(shapely.Point(here)))


def _feet(ring: LineString, points: Floats, spacing: float) -> Floats:
    """Return where on a closed line points around it have their feet, never going back [mm].

    On the inside of a bend that is tighter than the points' distance the nearest places run
    back and jump: they wait and are smoothed instead.
    """
    feet = shapely.line_locate_point(ring, shapely.points(points))
    steps = np.diff(feet, prepend=feet[-1])
    steps = (steps + ring.length / 2) % ring.length - ring.length / 2
    ahead = feet[-1] - ring.length + np.cumsum(steps)
    # once round and a little more at both ends, so that they meet
    thrice = np.concatenate([ahead - ring.length, ahead, ahead + ring.length])
    thrice = gaussian_filter1d(np.maximum.accumulate(thrice), SMOOTHING / spacing)
    return np.asarray(thrice[len(points) : 2 * len(points)] % ring.length)


def _count(ring: LineString) -> int:
    """Return the number of points of a lap: chords of a circle as long keep within `SAG`."""
    chord = min(CHORD, math.sqrt(8 * SAG * ring.length / (2 * math.pi)))
    return max(16, math.ceil(ring.length / chord))


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
    rounding = ROUNDING * radius
    shapes = [
        oriented(buffer(buffer(center.curve, half_width + k * stepover + rounding), -rounding))
        for k in range(center.laps + 1)
    ]
    return Spiral(center, tuple(Polygon(s.exterior) for s in shapes))


def bend_at(ring: LineString, at: float, radius: float) -> tuple[Floats, float, float]:
    """Return point, heading [rad] and curvature [1/mm] of a closed line at `at` [mm] along it."""
    window = WINDOW * radius
    s = (at + window * np.array([-1.0, 0.0, 1.0])) % ring.length
    a, b, c = points_at(ring, s)
    u, v = b - a, c - b
    chord = c - a
    double_area = u[0] * v[1] - u[1] * v[0]
    curvature = 2 * double_area / (np.hypot(*u) * np.hypot(*v) * np.hypot(*chord))
    return b, float(np.arctan2(chord[1], chord[0])), float(curvature)
