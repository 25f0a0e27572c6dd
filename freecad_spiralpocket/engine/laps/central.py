# SPDX-License-Identifier: LGPL-2.1-or-later
"""Central Spiral: a true circular spiral that turns into the pocket's outline [CS08].

For pockets about as wide as long, round, square or polygonal, on machines that
lose time in corners: the inner laps are circles of even thickness.

- The spiral is Archimedean, one step-over a turn, until its diameter is the share
  C of the pocket's width (eq. 1; both of the cutter's center, so that C = 1 touches
  the wall). C is the one that takes least time on the machine, sought from the
  paper's 55 % outwards.
- From there rays to the wall carry the control points (section 2.3), evenly divided.
  The shortest ray is divided by the step-over; in corners the laps are thicker, here no
  more than those of contour-parallel laps in a square corner (the paper's own times can
  only be had with about twice the step-over there, see `./dev bench papers cs08`). The
  rays go to points of the wall that are closer in bends, instead of one each degree.
- Control points in the corners are removed: here the wall is rounded by the largest
  radius that leaves the closing lap no more than a share of the step-over.
- Feed by thickness (section 2.4) is the feed mode "Linear slow-down", by measured engagement,
  which counts bends too, instead of by the distance of points.

Islands, and walls that the middle does not see, are refused.
"""

from __future__ import annotations

import math

import numpy as np
import shapely
from shapely import Point, Polygon

from ..errors import NotYetError
from ..floor import FloorPath, Helix
from ..machine import machine_of
from ..model import Floats, PocketRequest, Tick
from ..motion.timing import polyline_seconds
from ..opening.entry import fit_helix_radius
from ..shapes.points import cross
from ..shapes.polyline import ring_from, ring_points, turning_samples
from ..shapes.region import rounded_inside
from ..shapes.splines import (
    periodic_beziers,
    periodic_controls,
    periodic_cubic,
    sample_beziers,
    spiral_beziers,
)
from ..shapes.starshape import deepest_center
from .closing import closing_passes, corner_fillet, wall_inset

#: C, the end of the circular spiral, in the order tried: the paper's best first.
RATIOS = (0.55, 0.5, 0.6, 0.45, 0.65, 0.4, 0.7, 0.3, 0.8)
#: The wall is rounded by no more than this share of the room about the middle.
MOST_FILLET = 0.5
#: Longest distance between its points, and turning between them [mm, rad]; halved until it stays
#: inside the region.
SAMPLE_LENGTH, SAMPLE_TURN = 8.0, 0.5
HALVINGS = 6
#: Thickness in the corners, along the rays, over the step-over at most; and over D.
THICKEST, WIDEST = math.sqrt(2), 0.85
#: Chords of the spirals that are compared keep within this [mm].
COARSE = 0.01


def floor_path(
    region: Polygon,
    request: PocketRequest,
    tick: Tick,
    ratio: float | None = None,
    thickest: float = THICKEST,
) -> FloorPath:
    """Make the spiral of one cutter-center region.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise.
    request : PocketRequest
    tick : callable
        See `model.Tick`.
    ratio : float, optional
        C, in ``(0, 1)``; by default the one that takes least time on the machine.
    thickest : float, optional
        Largest thickness along the rays over the step-over, 1 or more.

    Raises
    ------
    NotYetError
        If the region has islands or walls that its middle does not see.
    CutterDoesNotFitError
        If there is no room for the helix.
    """
    center = _middle(region)
    radius = fit_helix_radius(region, center, request.cutter_radius, request.entry)
    stepover = request.cutting.stepover
    room = region.boundary.distance(Point(center))
    fillet = min(corner_fillet(region, stepover), MOST_FILLET * room)
    breaks, outer = wall_spline(region, center, fillet)
    tick(0.3)

    circle = unit_circle(center, breaks, outer)
    rays = np.hypot(*(outer - center).T)
    widest = max(stepover, min(thickest * stepover, WIDEST * request.tool_diameter))
    steps = np.array([stepover, widest])

    def spiral(transit: tuple[float, float], tolerance: float) -> Floats:
        end, step = transit
        turns = circular_turns(center, radius, end, stepover, tolerance)
        _, morph = spiral_beziers(breaks, center + end * circle, outer, step)
        return np.vstack([turns[:-1], sample_beziers(morph, tolerance)])

    shares = RATIOS if ratio is None else (ratio,)
    # several shares may come to the same circle
    found = list(dict.fromkeys(transition(rays, radius, s * room, steps) for s in shares))
    if len(found) > 1:
        found.sort(key=lambda transit: _seconds(spiral(transit, COARSE), request))
    tick(0.9)
    points = spiral(found[0], request.tolerance / 2)
    start = points[0] - center
    helix = Helix(center, radius, math.atan2(start[1], start[0]))
    rounded = sample_beziers(periodic_beziers(breaks, outer), request.tolerance / 2)
    return FloorPath(helix, closing_passes(points, rounded, region, request))


def _middle(region: Polygon) -> Floats:
    """Return the center of the spiral, or refuse the region."""
    hint = "Choose the strategy Automatic or Isotherm for this pocket."
    if region.interiors:
        island = region.interiors[0].centroid
        raise NotYetError(
            "Central Spiral cannot go round islands; there is one at {at}.",
            hint,
            (island.x, island.y),
        )
    center = deepest_center(region)
    if center is None:
        place = shapely.point_on_surface(region)
        raise NotYetError(
            "Central Spiral needs a pocket whose whole wall can be seen from one place in its "
            "middle; the one at {at} has walls behind corners.",
            hint,
            (place.x, place.y),
        )
    return center


def wall_spline(region: Polygon, center: Floats, fillet: float) -> tuple[Floats, Floats]:
    """Return the wall as a closed C2 cubic inside the region, from the positive x-axis on.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise, seen wholly from `center`.
    center : ndarray of shape (2,)
    fillet : float
        Radius of the rounding of its corners [mm].

    Returns
    -------
    breaks : ndarray of shape (n + 1,)
    controls : ndarray of shape (n, 2)
        See `splines.periodic_cubic`.

    Raises
    ------
    NotYetError
        If no spline keeps inside.
    """
    inset = wall_inset(region.boundary.distance(Point(center)))
    rounded = rounded_inside(region, fillet, inset)[0]
    ring = ring_from(ring_points(rounded.exterior), center, toward=(1.0, 0.0))
    for halving in range(HALVINGS):
        share = 0.5**halving
        points = turning_samples(ring, SAMPLE_LENGTH * share, SAMPLE_TURN * share)
        breaks, controls = periodic_cubic(points)
        curve = sample_beziers(periodic_beziers(breaks, controls), inset / 4)
        a, b = curve[:-1] - center, curve[1:] - center
        seen = cross(a, b) > -1e-6
        if seen.all() and region.contains(Polygon(curve)):
            return breaks, controls
    raise NotYetError(
        "The wall of the pocket about {at} is too jagged for Central Spiral.",
        "Check the outline for tiny steps, or choose a smaller cutter.",
        (float(center[0]), float(center[1])),
    )


def circular_turns(
    center: Floats, start_radius: float, end_radius: float, stepover: float, tolerance: float
) -> Floats:
    """Return the Archimedean spiral, one step-over a turn; it ends on the positive x-axis.

    Parameters
    ----------
    center : ndarray of shape (2,)
    start_radius, end_radius : float
        [mm]
    stepover, tolerance : float
        Thickness, and what the chords keep within [mm].

    Returns
    -------
    ndarray of shape (k, 2)
        [mm]
    """
    turned = 2 * math.pi * (end_radius - start_radius) / stepover
    chord = 2 * math.acos(1 - min(0.5, tolerance / end_radius))
    angles = np.linspace(-turned, 0.0, math.ceil(turned / chord) + 1)
    radii = end_radius + stepover * angles / (2 * math.pi)
    return center + radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])


def transition(rays: Floats, start: float, wanted: float, steps: Floats) -> tuple[float, float]:
    """Return where the circular spiral ends, and the largest thickness after it [mm].

    It ends at the largest radius up to the wanted one with which the rays take whole turns at the
    step-over on the shortest ray, or at the largest thickness in a corner.

    Parameters
    ----------
    rays : ndarray of shape (n,)
        Lengths of the rays from the center to the wall [mm].
    start, wanted : float
        Where the spiral begins, and where it shall end [mm].
    steps : ndarray of shape (2,)
        Thickness on the shortest ray, and largest thickness [mm].
    """
    reach = np.array([rays.min(), rays.max()])
    turns = max(1, math.ceil(((reach - max(start, wanted)) / steps).max() - 1e-9))
    end = max(start, float((reach - turns * steps).max()))
    return end, (float(rays.max()) - end) / turns


def unit_circle(center: Floats, breaks: Floats, outer: Floats) -> Floats:
    """Return the circle of radius 1 about 0 as a spline, its points on the rays to the wall's.

    Parameters
    ----------
    center : ndarray of shape (2,)
    breaks : ndarray of shape (n + 1,)
    outer : ndarray of shape (n, 2)
        The wall; see `splines.periodic_cubic`.

    Returns
    -------
    ndarray of shape (n, 2)
        Periodic control points over the same breaks.
    """
    rays = periodic_beziers(breaks, outer)[:, 0] - center
    rays /= np.linalg.norm(rays, axis=1)[:, None]
    return periodic_controls(breaks, rays)


def _seconds(spiral: Floats, request: PocketRequest) -> float:
    """Return how long the machine takes for a spiral [s]."""
    points = np.column_stack([spiral, np.zeros(len(spiral))])
    feed, machine = request.feeds.horizontal, machine_of(request)
    return float(polyline_seconds(points, feed, machine))
