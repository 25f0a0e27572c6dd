# SPDX-License-Identifier: LGPL-2.1-or-later
"""Growing fronts: from the region already visited to the next, engagement held.

`C` is the set of places where the cutter's center has been (or could go without
cutting). Its boundary moves outwards by a step that keeps the engagement angle at
the limit: on a straight front the step-over, on a convex one less, because the
cutter meets more stock there. With the cleared edge's radius
``rho = R + 1 / curvature`` the step is
``a = R - rho - R cos(limit) + sqrt(rho^2 - R^2 sin(limit)^2)``: constant
engagement on a growing disc, exactly.

Two morphological filters keep the fronts smooth. A closing rounds reentrant
kinks; an opening makes every front leave and join the walls tangentially. What
the opening keeps from being reached, the corners, is taken at the end, each in as
few strokes as the limit allows. The family of laps is CS08's circular spiral
grown to the walls, or EAS07's extended Archimedean spiral where it starts from
a curve, with the step measured by engagement instead of distance.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPolygon, Polygon

from .filters import evened, highest
from .model import Floats
from .polyline import points_at, simplified
from .region import polygons_of
from .walls import are_near_walls

#: What growing and shrinking return.
Region: TypeAlias = Polygon | MultiPolygon


@dataclass(frozen=True, slots=True)
class FrontRules:
    """What governs the growth.

    Attributes
    ----------
    cutter_radius : float
        R [mm].
    limit : float
        Largest engagement angle [rad], in ``(0, pi)``.
    closing : float
        Least radius of reentrant curves [mm].
    fillet : float
        Radius with which fronts meet walls [mm].
    """

    cutter_radius: float
    limit: float
    closing: float
    fillet: float

    @property
    def stepover(self) -> float:
        """Return the step of a straight front [mm]."""
        return self.cutter_radius * (1 - float(np.cos(self.limit)))


def engagement_step(curvature: Floats, rules: FrontRules) -> Floats:
    """Return the step that keeps the engagement at the limit.

    Parameters
    ----------
    curvature : ndarray of shape (n,)
        Of the front, positive where convex [1/mm].
    rules : FrontRules

    Returns
    -------
    ndarray of shape (n,)
        [mm], in ``(0, WIDEST * stepover]``.
    """
    r, s = rules.cutter_radius, rules.cutter_radius * np.sin(rules.limit)
    k = np.where(np.abs(curvature) < 1e-6, 1e-6, curvature)
    widest = WIDEST * rules.stepover
    # stock that is tighter than this may be taken as deeply as anything is
    rho = np.where(k < 0, np.minimum(r + 1 / k, -s), r + 1 / k)
    root = np.sqrt(rho**2 - s**2)
    # rho - root without cancellation
    return np.minimum(rules.stepover - s**2 / (rho + np.copysign(root, rho)), widest)


def buffer(shape: Region, distance: float) -> Region:
    """Grow or shrink within 0.004 mm."""
    step = 2 * np.arccos(1 - min(0.5, 0.004 / max(abs(distance), 1e-6)))
    return shapely.buffer(shape, distance, quad_segs=max(4, int(np.ceil(np.pi / 2 / step))))


def _filleted(shape: Region, fillet: float, omega: Polygon) -> Region:
    """Open a region where it meets the walls of `omega`; its free tips stay."""
    core = buffer(shape, -fillet)
    opened = buffer(core, fillet)
    kept = buffer(core, (1 + TIP_HEIGHT) * fillet)
    shapely.prepare(kept)
    points = shapely.get_coordinates(shape)
    points = points[~shapely.contains_xy(kept, points)]
    if len(points) == 0 or are_near_walls(omega, points, 0.4 * fillet).all():
        return opened
    taken = shapely.get_parts(shapely.difference(shape, opened))
    taken = taken[shapely.area(taken) > SLIVER]
    if len(taken):
        free = taken[~shapely.dwithin(omega.boundary, taken, 0.02)]
        if len(free):
            return _welded([opened, *free])
    return opened


def ring_samples(ring: shapely.LinearRing, spacing: float) -> Floats:
    """Return evenly spaced points of a ring, shape (n, 2) [mm]."""
    count = max(16, int(np.ceil(ring.length / spacing)))
    return points_at(ring, np.arange(count) * ring.length / count)


def _stepped_ring(
    ring: shapely.LinearRing, omega: Polygon, rules: FrontRules
) -> tuple[Floats, float]:
    """Return a ring moved outwards by the step, and the least of it; parts on the wall stay."""
    # a slim region's tips are tighter than the cutter
    slim = 2 * shapely.area(Polygon(ring)) / ring.length
    spacing = SPACING * min(rules.cutter_radius, max(slim, 0.05 * rules.cutter_radius))
    points = ring_samples(ring, spacing)
    soft = evened(points, SOFT / SPACING, closed=True)
    tangent = (np.roll(soft, -1, axis=0) - np.roll(soft, 1, axis=0)) / 2
    bend = np.roll(soft, -1, axis=0) - 2 * soft + np.roll(soft, 1, axis=0)
    speed = np.hypot(tangent[:, 0], tangent[:, 1]) + 1e-12
    curvature = (tangent[:, 0] * bend[:, 1] - tangent[:, 1] * bend[:, 0]) / speed**3
    on_wall = are_near_walls(omega, points, 0.02)
    curvature = np.where(on_wall, 0.0, curvature)
    near, far = (max(3, round(2 * w * rules.cutter_radius / spacing) | 1) for w in (REACH, FAR))
    convex = highest(curvature, near, closed=True)
    concave = np.minimum(highest(curvature, far, closed=True), 0.0)
    concave = evened(concave, far / 4, closed=True)
    curvature = np.maximum(convex, 0.0) + concave
    curvature = evened(curvature, EVEN * rules.cutter_radius / spacing, closed=True)
    step = np.where(on_wall, 0.0, engagement_step(curvature, rules))
    normal = np.column_stack([tangent[:, 1], -tangent[:, 0]]) / speed[:, None]
    moved = points + step[:, None] * normal
    moved = simplified(np.vstack([moved, moved[:1]]), STRAIGHT)[:-1]
    return moved, float(step[~on_wall].min(initial=rules.stepover))


def advance(visited: Polygon, omega: Polygon, rules: FrontRules) -> Polygon:
    """Return the visited region after one more lap or set of strokes.

    Parameters
    ----------
    visited : shapely.Polygon
        C, exterior counter-clockwise, interiors clockwise.
    omega : shapely.Polygon
        The cutter-center region; contains `visited`.
    """
    visited = _without_idle_holes(visited, omega, rules)
    shell, least = shapely.get_coordinates(visited.exterior), rules.stepover
    if not shapely.equals(visited.exterior, omega.exterior):
        shell, least = _stepped_ring(visited.exterior, omega, rules)
    holes = []
    for ring in visited.interiors:
        hole, least_here = _stepped_ring(ring, omega, rules)
        least = min(least, least_here)
        x, y = hole[:, 0], hole[:, 1]
        if (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() < 0:  # not turned inside out
            holes.append(hole)
    moved = Polygon(shell, holes)
    if not moved.is_valid:
        # where the moved ring crosses itself it leaves loops, which an opening removes
        loop = 0.25 * rules.cutter_radius
        moved = buffer(buffer(shapely.make_valid(moved), -loop), loop)
        moved = shapely.union(moved, buffer(visited, least))
    closed = _without_cusps(_closed(moved, visited, omega, rules, CLOSINGS), moved, rules)
    grown = _filleted(shapely.intersection(closed, omega), rules.fillet, omega)
    front = shapely.simplify(largest(shapely.union(grown, visited)), 0.002)
    # a tiny hole beside the rim may come to lie outside
    return front if front.is_valid else largest(shapely.make_valid(front))


def _without_idle_holes(visited: Polygon, omega: Polygon, rules: FrontRules) -> Polygon:
    """Fill the holes, and the arms of holes, in which no stock stands.

    The cutter reached over them from all around.
    """
    idle, kept = rules.cutter_radius - IDLE, []
    for ring in visited.interiors:
        hole = Polygon(ring)
        if not omega.contains(hole):
            kept.append(ring)
            continue
        holding = shapely.intersection(buffer(buffer(hole, -idle), idle), hole)
        parts = [p for p in polygons_of(holding) if p.area > SLIVER]
        kept.extend(p.exterior for p in parts)
    return oriented(Polygon(visited.exterior, kept))


def _closed(
    moved: Region, visited: Polygon, omega: Polygon, rules: FrontRules, shares: Sequence[float]
) -> Region:
    """Round reentrant kinks of a moved front, each as widely as the cutter reaches over.

    Going round `visited` and then round the new front it clears what is within its radius of
    either; a wider fill would be taken for cleared and stay standing. There the next smaller of
    the radii in `shares` is taken.
    """
    if not shares:
        return moved
    radius = shares[0] * rules.closing
    closed = buffer(buffer(moved, radius), -radius)
    if _is_reached(closed, moved, visited, rules):
        return closed
    fills = shapely.get_parts(shapely.difference(closed, moved))
    fills = fills[shapely.area(fills) > SLIVER]
    if len(fills) == 0:
        return closed
    edges = _new_edges(fills, moved)
    # only a plug's corners: elsewhere strokes, not laps, would have to take so much
    corner = (edges == 1) & shapely.contains_properly(Polygon(visited.exterior), fills)
    edge = shapely.intersection(closed, omega).boundary
    far = fills[_are_beyond(fills, corner, edges == 0, visited, edge, rules)]
    if len(far) == 0:
        return closed
    pieces = [shapely.difference(closed, shapely.union_all(far))]
    for piece in far:
        zone = buffer(piece, 0.01)
        x0, y0, x1, y1 = zone.bounds
        near = shapely.clip_by_rect(moved, x0 - radius, y0 - radius, x1 + radius, y1 + radius)
        finer = _closed(near, visited, omega, rules, shares[1:])
        pieces.append(shapely.intersection(finer, zone))
    return shapely.union_all(pieces)


def _without_cusps(closed: Region, moved: Region, rules: FrontRules) -> Region:
    """Round the cusps of what was filled, which arise where a closing just fits through a channel.

    Tips of the moved front itself stay.
    """
    rings = [ring for p in polygons_of(closed) for ring in (p.exterior, *p.interiors)]
    coords, of = shapely.get_coordinates(rings, return_index=True)
    steps, same = np.diff(coords, axis=0), of[1:] == of[:-1]
    turns = np.arctan2(
        steps[:-1, 0] * steps[1:, 1] - steps[:-1, 1] * steps[1:, 0],
        (steps[:-1] * steps[1:]).sum(axis=1),
    )
    # the visited region is on the left
    sharp = coords[1:-1][(turns > CUSP_TURN) & same[1:] & same[:-1]]
    if shapely.dwithin(moved, shapely.points(sharp), NEW).all():
        return closed
    radius = CUSP * rules.cutter_radius
    return _welded([buffer(buffer(closed, -radius), radius), moved])


def _welded(shapes: Sequence[Region]) -> Region:
    """Return the union, without the cracks that stay where edges are nearly the same."""
    return buffer(buffer(shapely.union_all(shapes), CRACK), -CRACK)


def _is_reached(closed: Region, moved: Region, visited: Polygon, rules: FrontRules) -> bool:
    """Return whether surely all that was filled is within reach of `visited`; quick."""
    holes = [sum(len(p.interiors) for p in polygons_of(shape)) for shape in (closed, moved)]
    if holes[0] < holes[1]:
        return False
    shapely.prepare(visited)
    points = shapely.points(shapely.get_coordinates(closed))
    return bool(shapely.dwithin(visited, points, REACHED * rules.cutter_radius).all())


def _new_edges(fills: NDArray[np.object_], moved: Region) -> NDArray[np.intp]:
    """Return how many new edges each fill has: none closes a hole, two join two fronts."""
    rings = shapely.segmentize(shapely.get_exterior_ring(fills), EDGE)
    coords, of = shapely.get_coordinates(rings, return_index=True)
    shapely.prepare(moved)
    new = ~shapely.dwithin(moved, shapely.points(coords), NEW)
    # a ring's last point is its first
    begins = new[1:] & ~new[:-1] & (of[1:] == of[:-1])
    edges = np.bincount(of[1:][begins], minlength=len(fills))
    whole = np.bincount(of, weights=~new, minlength=len(fills)) == 0
    return np.where(whole, 1, edges) + shapely.get_num_interior_rings(fills)


def _are_beyond(
    fills: NDArray[np.object_],
    corner: NDArray[np.bool_],
    closing: NDArray[np.bool_],
    visited: Polygon,
    edge: Region,
    rules: FrontRules,
) -> NDArray[np.bool_]:
    """Return which fills the cutter does not clear wholly.

    It goes round `visited`, and where a `corner` is rounded then along its new edge.
    """
    reach = REACHED * rules.cutter_radius
    coords, of = shapely.get_coordinates(fills, return_index=True)
    points = shapely.points(coords)
    shapely.prepare(visited)
    shapely.prepare(edge)
    lost = ~shapely.dwithin(visited, points, reach)
    lost &= ~(corner[of] & shapely.dwithin(edge, points, reach))
    bulge = rules.stepover + BULGE * rules.closing
    lost |= corner[of] & ~shapely.dwithin(visited, points, bulge)
    beyond = np.zeros(len(fills), dtype=bool)
    beyond[of[lost]] = True
    # the middle of a wide piece may be out of reach though its rim is not
    for i in np.flatnonzero(~beyond & (closing | (shapely.area(fills) > reach**2))):
        x0, y0, x1, y1 = fills[i].bounds
        window = shapely.box(x0 - reach, y0 - reach, x1 + reach, y1 + reach)
        around = (visited, edge) if corner[i] else (visited,)
        near = [buffer(shapely.intersection(s, window), reach) for s in around]
        beyond[i] = shapely.difference(fills[i], shapely.union_all(near)).area > SLIVER
    return beyond


def largest(shape: Region) -> Polygon:
    """Return the largest polygon of a region, counter-clockwise."""
    return oriented(shape) if isinstance(shape, Polygon) else polygons_of(shape)[0]


#: The step keeps to the sharpest bend within so far to both sides, and then evens out over so
#: much, over R: a step that jumps makes waves that grow from lap to lap.
REACH, EVEN = 0.8, 0.9
#: A step goes beyond the step-over only where it is concave so far to both sides, over R.
FAR = 3.0
#: Distance of samples along a front, and width of the smoothing under which its bends are taken,
#: over R or over the width of a slim one.
SPACING, SOFT = 0.12, 0.4
#: Samples of a moved front that matter less than this are left out [mm].
STRAIGHT = 0.0005
#: Where the stock bends away from the cutter the step may be so much over the step-over.
WIDEST = 1.15
#: A front goes no farther than this beyond the last, over R: there the cutter reached over.
REACHED = 0.92
#: The rounded corner of a plug is no deeper than this over `FrontRules.closing` and the step-over:
#: the cutter comes to it along a side and would be engaged that much more.
BULGE = 0.32
#: Radii tried to round a reentrant kink, over `FrontRules.closing`.
CLOSINGS = (1.0, 0.5, 0.2)
#: A fill's cusp turns by more than this [rad], and is rounded with this radius, over R.
CUSP_TURN, CUSP = np.radians(25.0), 0.35
#: Cracks where shapes are joined are narrower than twice this [mm].
CRACK = 0.01
#: Distance of the points of a fill by which its new edges are counted [mm].
EDGE = 0.5
#: A hole holds no stock that is wide enough for less than the cutter by this, half its width [mm].
IDLE = 0.003
#: Growth ends when a step adds less than this share of the last stroke's area.
STALLED = 0.02
#: A stroke before a corner is not worth its link that cuts less than this over the step-over.
SCRAP = 0.35
#: A lap may be wider by this to leave no ribs; as much as feeds allow without slowing down.
STRETCH = 1.05
#: Ribs below this area are not worth that, over R and the step-over.
RIBS = 0.1
#: The front is new where it is farther than this from the region before [mm].
NEW = 0.012
#: An opening may take so much of a free tip, over the fillet.
TIP_HEIGHT = 0.01
#: What is left is no corner but a room beyond a neck if it holds a disc of this radius, over the
#: fillet's: a corner of 30 degrees just holds that.
ROOM = 0.6
#: Most steps of one growth: a pocket 2000 steps wide is not cut with this cutter.
MAX_FRONTS = 2000
#: What is thinner than twice this is a hairline [mm].
HAIRLINE = 2e-4
#: Left-over pieces of less area are not worth a stroke [mm2].
SLIVER = 1e-3


def grow(
    start: Polygon,
    omega: Polygon,
    rules: FrontRules,
    tick: Callable[[], None],
    most: int = MAX_FRONTS,
) -> list[Polygon] | None:
    """Return the visited region after the entry and after each level of laps and strokes.

    Parameters
    ----------
    start : shapely.Polygon
        Visited by the entry.
    omega : shapely.Polygon
        The cutter-center region.
    tick : callable
        Is called once a front; may raise.
    most : int
        Give up beyond so many.

    Returns
    -------
    list of shapely.Polygon or None
        Nested, from `start` to where only corners are left (see `corners`); None if there would
        be more than `most`.
    """
    fronts = [oriented(_without_idle_holes(start, omega, rules))]
    least = STALLED * rules.stepover * rules.cutter_radius
    for _ in range(most):
        tick()
        grown = _without_scraps(_stretched(fronts[-1], omega, rules), fronts[-1], omega, rules)
        if grown.area - fronts[-1].area < least:
            grown = _through_neck(fronts[-1], omega, rules)
            if grown is None:
                break
        fronts.append(oriented(grown))
    if len(fronts) > most:
        return None
    return fronts


def _stretched(visited: Polygon, omega: Polygon, rules: FrontRules) -> Polygon:
    """Return the next front, a little wider where it would leave only thin ribs in places."""
    grown = advance(visited, omega, rules)
    ribs = _ribs(grown, omega, rules)
    if ribs < RIBS * rules.cutter_radius * rules.stepover:
        return grown
    wider = np.arccos(max(-1.0, 1 - STRETCH * (1 - np.cos(rules.limit))))
    other = advance(visited, omega, replace(rules, limit=float(wider)))
    return other if _ribs(other, omega, rules) < ribs / 2 else grown


def _ribs(visited: Polygon, omega: Polygon, rules: FrontRules) -> float:
    """Return the area of the stock in ribs so thin that a wider lap would have taken them [mm2]."""
    thin, area = (STRETCH - 1) * rules.stepover, 0.0
    for ring in visited.interiors:
        hole = Polygon(ring)
        if omega.contains(hole):
            stock = buffer(hole, IDLE - rules.cutter_radius)
            area += stock.area - buffer(buffer(stock, -thin), thin).area
    # along slopes and in corners the opening takes a little too
    return area


def _without_scraps(grown: Polygon, visited: Polygon, omega: Polygon, rules: FrontRules) -> Polygon:
    """Return a front without the strokes that would hardly cut anything before a corner.

    There the fillet is nearly reached; the corner is better finished from where it is.
    """
    shapely.prepare(visited)
    if not _may_have_scraps(grown, visited, rules):
        return grown
    pieces = shapely.get_parts(shapely.difference(grown, visited))
    coords, piece = shapely.get_coordinates(pieces, return_index=True)
    thin = np.ones(len(pieces), dtype=bool)
    thin[piece[~shapely.dwithin(visited, shapely.points(coords), SCRAP * rules.stepover)]] = False
    thin &= shapely.dwithin(pieces, omega.boundary, 0.02)
    if not thin.any():
        return grown
    return largest(shapely.difference(grown, shapely.union_all(pieces[thin])))


def _may_have_scraps(grown: Polygon, visited: Polygon, rules: FrontRules) -> bool:
    """Return whether a run of new points along the rings stays close to `visited`; quick."""
    for ring in (grown.exterior, *grown.interiors):
        # straight walls have no points of their own between the corners
        points = shapely.points(shapely.get_coordinates(shapely.segmentize(ring, 1.0)))
        new = ~shapely.dwithin(visited, points, NEW)
        if not new.any() or new.all():
            continue
        first = int(np.flatnonzero(~new)[0])
        new = np.roll(new, -first)
        far = np.roll(~shapely.dwithin(visited, points, SCRAP * rules.stepover), -first)
        run = np.cumsum(np.diff(new.astype(np.int8), prepend=0) > 0)[new]
        if (np.bincount(run, weights=far[new])[1:] == 0).any():
            return True
    return False


def _through_neck(visited: Polygon, omega: Polygon, rules: FrontRules) -> Polygon | None:
    """Return the next front where only a neck too narrow for the fillet leads on, or None."""
    rest = shapely.difference(omega, visited)
    if shapely.buffer(rest, -ROOM * rules.fillet).is_empty:
        return None
    for share in (0.5, 0.25, 0.1):
        finer = replace(rules, fillet=share * rules.fillet)
        grown = advance(visited, omega, finer)
        if grown.area - visited.area > STALLED * rules.stepover * rules.cutter_radius:
            return grown
    return None


def thick_parts(shape: Region) -> NDArray[np.object_]:
    """Return the pieces of a region, without what is as thin as a hair.

    Rounding of numbers leaves hairlines along walls, which would join all corners to a frame.
    """
    core = buffer(shape, -HAIRLINE)
    parts = shapely.get_parts(shapely.intersection(shape, buffer(core, 8 * HAIRLINE)))
    return parts[shapely.area(parts) > SLIVER]


def oriented(shape: Polygon) -> Polygon:
    """Return `shape` with its exterior counter-clockwise and its interiors clockwise."""
    return shapely.geometry.polygon.orient(shape)
