# SPDX-License-Identifier: LGPL-2.1-or-later
"""Linear morph: a spiral between an inner curve and the wall that is exactly a B-spline [LM15].

``c(u) = (1 - u) d_in(m u) + u d_out(m u)`` (eq. 3): both curves are periodic
cubic B-splines over the same knots, run through m times; times a linear factor
that is a B-spline of degree 4 (eq. 5), built from control points alone.

- ``d_out`` is the wall of the cutter-center region, its sharp corners rounded.
- ``d_in`` is a circle about the innermost point of a compact region, opened by a
  helix; else a slender curve round the pruned medial axis, opened as a slot
  (inner_curves.py).
- Laps cross nowhere if all rulings turn the same way about both curves; where
  they do not, ever longer axes are tried, and at last the region is refused.
- m is the ceiling of the longest distance between partners over the step-over.
  The paper's quotient (eq. 4) rounds down and can leave stock.

The step is even along each ruling, so the engagement is not held: in corners it
passes the limit, and the report says how far.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import shapely
from shapely import Polygon

from ..errors import NotYetError
from ..floor import FloorPath, Helix, Slot
from ..middle_line.inner_curves import Spine, axis_spines, is_compact, point_spine
from ..model import Floats, PocketRequest, Tick
from ..opening.slot import slot_end
from ..opening.start import slot_bite
from ..opening.starts import leaves_no_post
from ..shapes.polyline import closed_line, ring_from, ring_points
from ..shapes.region import rounded_inside
from ..shapes.splines import (
    join_c2,
    periodic_beziers,
    periodic_cubic,
    sample_beziers,
    spiral_beziers,
)
from .closing import closing_passes, wall_inset

#: Fillet radius of the rounded wall over the step-over at first; halved while it takes more than
#: `DEEPEST` off a corner, or anything off a neck.
ROUNDING = 1.0
#: What the fillet takes off a corner at most, over the step-over.
DEEPEST = 1.5
#: Longest distance between interpolated points, and turning between them [mm, rad]; halved until
#: the splines fit.
SAMPLE_LENGTH, SAMPLE_TURN = 8.0, 0.5
HALVINGS = 6
#: Posts in the middle do not go away by finer samples than this.
POST_HALVINGS = 2
#: They are sought to within this [mm].
POST_SLACK = 0.01
#: The walk along a medial axis is smoothed over this length, over R.
SMOOTHING = 0.7
HINT = "Choose another strategy, for example Automatic."


@dataclass(frozen=True, slots=True, eq=False)
class Morph:
    """The two curves of a linear morph, as periodic cubics over the same breaks.

    Attributes
    ----------
    spine : Spine
    breaks : ndarray of shape (n + 1,)
    inner, outer : ndarray of shape (n, 2)
        Control points of ``d_in`` and ``d_out`` [mm]; see `splines.periodic_cubic`.
    """

    spine: Spine
    breaks: Floats
    inner: Floats
    outer: Floats


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
        If the region has islands, or laps would cross themselves.
    CutterDoesNotFitError
        If there is no room for the helix.
    """
    morph = morph_of(region, request)
    entry = _entry(morph, request)
    if request.start_point is not None and isinstance(entry, Slot):
        # the spiral begins where the slot must end
        ring = closed_line(entry.ring)
        end = ring.interpolate(slot_end(entry, request.start_point, request))
        morph = morph_of(region, replace(request, start_point=(end.x, end.y)))
    tick(0.5)
    turns, beziers = spiral_beziers(
        morph.breaks, morph.inner, morph.outer, request.cutting.stepover
    )
    all_breaks = (np.arange(turns)[:, None] + morph.breaks[None, :-1]).ravel() / turns
    curve = join_c2(beziers, np.append(all_breaks, 1.0))
    slack = request.tolerance / 2
    spiral = sample_beziers(beziers, slack)
    rounded = sample_beziers(periodic_beziers(morph.breaks, morph.outer), slack)
    passes = closing_passes(spiral, rounded, region, request)
    return FloorPath(_entry(morph, request), passes, curve)


def _entry(morph: Morph, request: PocketRequest) -> Helix | Slot:
    """Return the way down that opens the inner curve and ends where the spiral begins."""
    ring = sample_beziers(periodic_beziers(morph.breaks, morph.inner), request.tolerance / 2)
    if morph.spine.edges:
        return Slot(ring[:-1], slot_bite(request))
    start = ring[0] - morph.spine.center
    return Helix(morph.spine.center, float(np.hypot(*start)), math.atan2(start[1], start[0]))


def morph_of(region: Polygon, request: PocketRequest) -> Morph:
    """Return the curves to morph between: the first spine's whose laps do not cross themselves.

    Raises
    ------
    NotYetError
        If there is none.
    CutterDoesNotFitError
        If there is no room for the helix.
    """
    if region.interiors:
        island = region.interiors[0].centroid
        raise NotYetError(
            "Linear Morph cannot go round islands; there is one at {at}.",
            HINT,
            (island.x, island.y),
        )
    failure = None
    for spine in _spines(region, request):
        try:
            return _fitted(region, spine, request)
        except NotYetError as error:
            failure = failure or error
    if failure is None:
        place = shapely.point_on_surface(region)
        raise NotYetError("Linear Morph finds no middle to start from.", HINT, (place.x, place.y))
    raise failure


def _spines(region: Polygon, request: PocketRequest) -> Iterator[Spine]:
    """Yield spines to try: a point for a compact region, else the medial axis before it."""
    point = point_spine(region, request)
    if point is not None and is_compact(region, point):
        yield point
    yield from axis_spines(region, request)
    if point is not None:
        yield point


def _fitted(region: Polygon, spine: Spine, request: PocketRequest) -> Morph:
    """Return the morph about a spine, sampled as finely as it needs, or refuse."""
    ring = rounded_wall(region, spine, request.cutting.stepover, request.start_point)
    samples = spine.samples(ring, SMOOTHING * request.cutter_radius)
    fault = None
    for halving in range(HALVINGS):
        share = 0.5**halving
        points, partners = samples(SAMPLE_LENGTH * share, SAMPLE_TURN * share)
        breaks, outer = periodic_cubic(points)
        curve = sample_beziers(periodic_beziers(breaks, outer), wall_inset(spine.room) / 4)
        if not region.contains(Polygon(curve)):
            continue
        # control i + 1 of a periodic cubic goes with break i
        partners = np.roll(partners, 1, axis=0)
        fault = fold(breaks, spine.beside(partners, outer, spine.half_widths[0]), outer)
        if fault is not None:
            continue
        for half in spine.half_widths:
            inner = spine.beside(partners, outer, half)
            loop = Polygon(sample_beziers(periodic_beziers(breaks, inner), POST_SLACK)[:-1])
            if loop.is_valid and leaves_no_post(loop, request):
                return Morph(spine, breaks, inner, outer)
        if halving >= POST_HALVINGS:
            break
    if fault is not None:
        raise NotYetError(
            "Laps of Linear Morph would cross themselves at {at}, where the wall turns away from "
            "the middle of the pocket.",
            HINT,
            (float(fault[0]), float(fault[1])),
        )
    raise NotYetError(
        "The pocket's wall near {at} is too jagged or too narrow for Linear Morph.",
        "Check the outline for tiny steps, or choose a smaller cutter.",
        (float(spine.center[0]), float(spine.center[1])),
    )


def rounded_wall(
    region: Polygon,
    spine: Spine,
    stepover: float,
    asked: tuple[float, float] | None = None,
) -> Floats:
    """Return the wall with its sharp corners rounded, closed, from the positive x-axis on.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise.
    spine : Spine
        Its center is the origin of that axis.
    stepover : float
        The fillet radius follows it [mm].
    asked : tuple of float, optional
        Where the cutter shall go down [mm]: the wall then begins beside it, or about a point in
        its direction.

    Returns
    -------
    ndarray of shape (n, 2)
    """
    fillet, inset = min(ROUNDING * stepover, 0.5 * spine.room), wall_inset(spine.room)
    corners = shapely.points(np.array(region.exterior.coords))
    for _ in range(HALVINGS):
        rounded = rounded_inside(region, fillet, inset)[0]
        shapely.prepare(rounded)
        if shapely.dwithin(rounded, corners, DEEPEST * stepover + inset).all():
            break
        fillet /= 2
    wall = ring_points(rounded.exterior)
    if asked is not None and spine.edges:
        return ring_from(wall, np.array(asked))
    ahead = np.array((1.0, 0.0) if asked is None else asked - spine.center)
    if not ahead.any():
        ahead = np.array((1.0, 0.0))
    return ring_from(wall, spine.center, toward=(ahead[0], ahead[1]))


def fold(breaks: Floats, inner: Floats, outer: Floats) -> Floats | None:
    """Return where laps between two curves would cross themselves; None if they do not.

    The laps are nested if and only if the ruled surface between both curves folds nowhere: its
    Jacobian ``((1 - v) d_in' + v d_out') x (d_out - d_in)`` keeps its sign. It is linear in v, so
    that both curves decide for all laps between them.

    Parameters
    ----------
    breaks : ndarray of shape (n + 1,)
    inner, outer : ndarray of shape (n, 2)
        Periodic control points, both counter-clockwise.
    """
    pieces = [periodic_beziers(breaks, controls) for controls in (inner, outer)]
    t = np.linspace(0.0, 1.0, 9)[:-1]
    cubic = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3])
    square = 3 * np.stack([(1 - t) ** 2, 2 * t * (1 - t), t * t])
    b_in, b_out = (np.einsum("kt,nkc->cnt", cubic, p) for p in pieces)
    rulings = b_out - b_in
    scale = float((rulings**2).sum(axis=0).max())
    for piece, places in zip(pieces, (b_in, b_out), strict=True):
        slopes = np.einsum("kt,nkc->cnt", square, np.diff(piece, axis=1))
        jacobian = slopes[0] * rulings[1] - slopes[1] * rulings[0]
        worst = np.unravel_index(int(np.argmax(jacobian)), jacobian.shape)
        if jacobian[worst] > 1e-9 * scale:
            return places[:, worst[0], worst[1]]
    return None
