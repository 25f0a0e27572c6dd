# SPDX-License-Identifier: LGPL-2.1-or-later
"""Linear morph: a spiral between a circle and the wall that is exactly a B-spline [LM15].

``c(u) = (1 - u) d_in(m u) + u d_out(m u)`` (eq. 3): both curves are periodic
cubic B-splines over the same knots, run through m times; times a linear factor
that is a B-spline of degree 4 (eq. 5), built from control points alone.

- ``d_out`` is the wall of the cutter-center region, its sharp corners rounded.
- ``d_in`` has the same number of control points, on a circle about the innermost
  point, each on the ray to its partner. That is the alignment which the paper
  names as the one that always avoids self-intersections; it needs every
  wall point to be seen from the center. Other regions are refused.
- m is the ceiling of the longest distance between partners over the step-over.
  The paper's quotient (eq. 4) rounds down and can leave stock.

The step is even along each ray, so the engagement is not held: in corners it
passes the limit, and the report says how far.
"""

from __future__ import annotations

import math

import numpy as np
import shapely
from shapely import Point, Polygon

from ..entry import fit_helix_radius
from ..errors import NotYetError
from ..floor import FloorPath, Helix
from ..model import Floats, PocketRequest, Tick
from ..polyline import ring_from, turning_samples
from ..region import grow, polygons_of
from ..splines import join_c2, multiply_linear, periodic_beziers, periodic_cubic, sample_beziers
from ..starshape import deepest_center
from .closing import closing_passes

#: Fillet radius of the rounded wall over the step-over.
ROUNDING = 1.0
#: The spline of the wall runs this far inside of it [mm].
INSET = 0.01
#: Longest distance between interpolated points, and turning between them [mm, rad]; halved until
#: the spline stays inside the region.
SAMPLE_LENGTH, SAMPLE_TURN = 8.0, 0.5
HALVINGS = 6


def floor_path(region: Polygon, request: PocketRequest, tick: Tick) -> FloorPath:
    """Make the spiral of one cutter-center region.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise.
    request : PocketRequest
    tick : callable
        See `model.Tick`.

    Raises
    ------
    NotYetError
        If the region has islands or walls that its middle does not see.
    CutterDoesNotFitError
        If there is no room for the helix.
    """
    center = _middle(region)
    radius = fit_helix_radius(region, center, request.cutter_radius, request.entry)
    breaks, outer = wall_spline(region, center, ROUNDING * request.cutting.stepover)
    inner = _circle_controls(outer, center, radius)
    turns, beziers = spiral_beziers(breaks, inner, outer, request.cutting.stepover)
    tick(0.5)
    all_breaks = (np.arange(turns)[:, None] + breaks[None, :-1]).ravel() / turns
    curve = join_c2(beziers, np.append(all_breaks, 1.0))
    spiral = sample_beziers(beziers, request.tolerance / 2)
    start = spiral[0] - center
    helix = Helix(center, float(np.hypot(*start)), math.atan2(start[1], start[0]))
    rounded = sample_beziers(periodic_beziers(breaks, outer), request.tolerance / 2)
    return FloorPath(helix, closing_passes(spiral, rounded, region, request), curve)


def _middle(region: Polygon) -> Floats:
    """Return the center of the inner circle, or refuse the region."""
    hint = "Choose another pocket for now, or FreeCAD's Adaptive operation for this one."
    if region.interiors:
        island = region.interiors[0].centroid
        raise NotYetError(
            "Linear Morph cannot go round islands; there is one at {at}.",
            hint,
            (island.x, island.y),
        )
    center = deepest_center(region)
    if center is None:
        place = shapely.point_on_surface(region)
        raise NotYetError(
            "Linear Morph needs a pocket whose whole wall can be seen from one place in its "
            "middle; this one has walls behind corners.",
            hint,
            (place.x, place.y),
        )
    return center


def wall_spline(region: Polygon, center: Floats, fillet: float) -> tuple[Floats, Floats]:
    """Return ``d_out``: a closed C2 cubic inside the region, starting on the positive x-axis.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise, seen wholly from `center`.
    center : ndarray of shape (2,)
    fillet : float
        Radius of the rounding of sharp corners, less where there is no room [mm].

    Returns
    -------
    breaks : ndarray of shape (n + 1,)
    controls : ndarray of shape (n, 2)
        See `splines.periodic_cubic`.
    """
    room = region.boundary.distance(Point(center))
    fillet = min(fillet, 0.5 * room)
    rounded = polygons_of(grow(grow(region, -fillet - INSET), fillet))[0]
    ring = ring_from(np.array(rounded.exterior.coords)[:-1], center, toward=(1.0, 0.0))
    for halving in range(HALVINGS):
        share = 0.5**halving
        points = turning_samples(ring, SAMPLE_LENGTH * share, SAMPLE_TURN * share)
        breaks, controls = periodic_cubic(points)
        curve = sample_beziers(periodic_beziers(breaks, controls), INSET / 4)
        if region.contains(Polygon(curve)) and _is_seen(curve, center):
            return breaks, controls
    raise NotYetError(
        "The pocket's wall is too jagged for Linear Morph.",
        "Check the outline for tiny steps, or choose a smaller cutter.",
        (float(center[0]), float(center[1])),
    )


def _is_seen(curve: Floats, center: Floats) -> bool:
    """Return whether a closed curve runs counter-clockwise as seen from `center` all the way."""
    a, b = curve[:-1] - center, curve[1:] - center
    cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return bool((cross > -1e-6).all())


def _circle_controls(outer: Floats, center: Floats, radius: float) -> Floats:
    """Return ``d_in``: control points on the circle, each on the ray to its partner."""
    rays = outer - center
    return center + radius * rays / np.linalg.norm(rays, axis=1)[:, None]


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
