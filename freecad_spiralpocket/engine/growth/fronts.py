# SPDX-License-Identifier: LGPL-2.1-or-later
"""Growing fronts: from the region already visited to the next, engagement held.

`C` is the set of places where the cutter's center has been (or could go without
cutting). Its boundary moves outwards by a step that keeps the engagement angle at
the limit (front_rules.py).

Two morphological filters keep the fronts smooth. A closing rounds reentrant
kinks (closings.py); an opening makes every front leave and join the walls tangentially. What
the opening keeps from being reached, the corners, is taken at the end, each in as
few strokes as the limit allows. The family of laps is CS08's circular spiral
grown to the walls, or EAS07's extended Archimedean spiral where it starts from
a curve, with the step measured by engagement instead of distance.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from ..model import Floats
from ..numerics.filters import evened, highest
from ..shapes.points import cross
from ..shapes.polyline import ring_samples, simplified
from ..shapes.region import polygons_of, rings_of
from ..shapes.shaping import (
    SLIVER,
    Region,
    are_within,
    grow_coarsely,
    grow_prepared,
    largest,
    opening_of,
    oriented,
    simplified_region,
    sizable_parts,
    welded,
    without_whiskers,
)
from .closings import without_kinks
from .front_rules import NEW, FrontRules, engagement_step
from .lap_width import IDLE, STRETCH, best_width, ribs_in, widened
from .locally import grown_locally
from .walls import are_near_walls

#: The step keeps to the sharpest bend within so far to both sides, and then evens out over so
#: much, over R: a step that jumps makes waves that grow from lap to lap.
REACH, EVEN = 0.8, 0.9
#: A step goes beyond the step-over only where it is concave so far to both sides, over R.
FAR = 3.0
#: Where a stroke leaves a wall it turns into the stock, and is engaged most on the way. There its
#: step is less by this times the square of the step-over over R; so far from the wall, over R, it
#: is whole again, from so much nearer on bit by bit.
LEAVING, WHOLE, TAPER = 0.3, 2.8, 1.5
#: Distance of samples along a front, and width of the smoothing under which its bends are taken,
#: over R or over the width of a slim one.
SPACING, SOFT = 0.12, 0.4
#: A front as near to a wall as this meets it [mm].
TOUCHES = 0.02
#: What is left of a hole without its arms is as much smaller all around [mm]: within the hole.
INSIDE = 0.002
#: Samples of a moved front that matter less than this are left out [mm].
STRAIGHT = 0.0005
#: Points of a front that matter less than this are left out [mm].
FLAT = 0.002
#: Growth ends when a step adds less than this share of the last stroke's area.
STALLED = 0.02
#: So does one whose new ground is nowhere wider than this over the step-over: where an opening
#: takes more than the step has added, fronts are hairs.
CREEP = 0.1
#: A stroke before a corner is not worth its link that cuts less than this over the step-over.
SCRAP = 0.35
#: Ribs below this area are not worth that, over R and the step-over.
RIBS = 0.1
#: An opening may take so much of a free tip, over the fillet.
TIP_HEIGHT = 0.01
#: Where all corners that it takes are nearer to walls than this over the fillet there is no such
#: tip, and no piece need be looked at.
AT_WALL = 0.4
#: What is left is no corner but a room beyond a neck if it holds a disc of this radius, over the
#: fillet's: a corner of 30 degrees just holds that.
ROOM = 0.6
#: Around a room the front matters so far, over R: by what it is smoothed over, and some more.
AROUND = 6.0
#: Fillets, over the rules', with which fronts go where these do not fit.
NECK_FILLETS = (0.5, 0.25, 0.1)
#: Most steps of one growth: a pocket 2000 steps wide is not cut with this cutter.
MAX_FRONTS = 2000


def _filleted(shape: Region, fillet: float, omega: Polygon) -> Region:
    """Open a region where it meets the walls of `omega`; its free tips stay."""
    core = grow_coarsely(shape, -fillet)
    if core.is_empty and not shapely.dwithin(shape, omega.boundary, TOUCHES):
        return shape  # a slim room, whose walls it does not meet yet
    opened = grow_coarsely(core, fillet)
    kept = grow_coarsely(core, (1 + TIP_HEIGHT) * fillet)
    shapely.prepare(kept)
    points = shapely.get_coordinates(shape)
    points = points[~shapely.contains_xy(kept, points)]
    if len(points) == 0 or are_near_walls(omega, points, AT_WALL * fillet).all():
        return opened
    # where edges nearly are the same GEOS takes ten times as long
    if len(_free_parts(shapely.difference(shape, grow_coarsely(opened, INSIDE)), omega)):
        return welded([opened, *_free_parts(shapely.difference(shape, opened), omega)])
    return opened


def _free_parts(taken: Region, omega: Polygon) -> NDArray[np.object_]:
    """Return the pieces of what an opening takes that meet no wall of `omega`."""
    parts = sizable_parts(taken)
    return parts[~shapely.dwithin(omega.boundary, parts, TOUCHES)]


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
    curvature = cross(tangent, bend) / speed**3
    on_wall = are_near_walls(omega, points, TOUCHES)
    curvature = np.where(on_wall, 0.0, curvature)
    near, far = (max(3, round(2 * w * rules.cutter_radius / spacing) | 1) for w in (REACH, FAR))
    convex = highest(curvature, near, closed=True)
    concave = np.minimum(highest(curvature, far, closed=True), 0.0)
    concave = evened(concave, far / 4, closed=True)
    curvature = np.maximum(convex, 0.0) + concave
    curvature = evened(curvature, EVEN * rules.cutter_radius / spacing, closed=True)
    step = np.where(on_wall, 0.0, engagement_step(curvature, rules))
    if on_wall.any() and not on_wall.all():
        off = _since_wall(on_wall) * spacing / rules.cutter_radius
        less = LEAVING * (rules.stepover / rules.cutter_radius) ** 2
        step *= 1 - less * np.clip((WHOLE - off) / TAPER, 0.0, 1.0)
    normal = np.column_stack([tangent[:, 1], -tangent[:, 0]]) / speed[:, None]
    moved = points + step[:, None] * normal
    moved = simplified(np.vstack([moved, moved[:1]]), STRAIGHT)[:-1]
    return moved, float(step[~on_wall].min(initial=rules.stepover))


def _since_wall(on_wall: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return how many samples of a ring ago, at each, the last one was that is on a wall."""
    twice = np.arange(2 * len(on_wall))
    last = np.maximum.accumulate(np.where(np.tile(on_wall, 2), twice, 0))
    return (twice - last)[len(on_wall) :]


def advance(visited: Polygon, omega: Polygon, rules: FrontRules) -> Polygon:
    """Return the visited region after one more lap or set of strokes.

    Parameters
    ----------
    visited : shapely.Polygon
        C, exterior counter-clockwise, interiors clockwise.
    omega : shapely.Polygon
        The cutter-center region; contains `visited`.
    """
    visited = without_idle_holes(visited, omega, rules)
    shell, least = shapely.get_coordinates(visited.exterior), rules.stepover
    if not shapely.equals(visited.exterior, omega.exterior):
        shell, least = _stepped_ring(visited.exterior, omega, rules)
    holes = []
    for ring in visited.interiors:
        hole, least_here = _stepped_ring(ring, omega, rules)
        least = min(least, least_here)
        x, y = hole[:, 0], hole[:, 1]
        is_inside_out = (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() >= 0
        # where only a slim arm of it is, and that outweighs the rest, the rest is left
        if not is_inside_out or not grow_coarsely(Polygon(ring), -least_here).is_empty:
            holes.append(hole)
    moved = Polygon(shell, holes)
    if not moved.is_valid:
        # where the moved ring crosses itself it leaves loops, which an opening removes
        loop = 0.25 * rules.cutter_radius
        moved = opening_of(shapely.make_valid(moved), loop)
        moved = shapely.union(moved, grow_coarsely(visited, least))
    closed = without_kinks(moved, visited, omega, rules)
    grown = _filleted(shapely.intersection(closed, omega), rules.fillet, omega)
    front = simplified_region(largest(shapely.union(grown, visited)), FLAT)
    # a tiny hole beside the rim may come to lie outside
    return front if front.is_valid else largest(shapely.make_valid(front))


def without_idle_holes(visited: Polygon, omega: Polygon, rules: FrontRules) -> Polygon:
    """Fill the holes, and the arms of holes, in which no stock stands.

    The cutter reached over them from all around.
    """
    idle, kept = rules.cutter_radius - IDLE, []
    for ring in visited.interiors:
        hole = Polygon(ring)
        if not omega.contains(hole):
            kept.append(ring)
            continue
        # as `ribs_in` has shrunk it already
        opened = grow_coarsely(grow_prepared(hole, -idle), idle - INSIDE)
        kept.extend(p.exterior for p in polygons_of(opened) if p.area > SLIVER)
    return oriented(Polygon(visited.exterior, kept))


def fronts_from(
    start: Polygon,
    omega: Polygon,
    rules: FrontRules,
    idle: Sequence[Polygon] = (),
    known: Sequence[Polygon] = (),
) -> Iterator[Polygon]:
    """Yield the visited region after the entry and after each level of laps and strokes.

    Parameters
    ----------
    start : shapely.Polygon
        Visited by the entry.
    omega : shapely.Polygon
        The cutter-center region.
    rules : FrontRules
    idle : sequence of shapely.Polygon, optional
        Ground where nothing is cut; a front that touches it takes all of it.
    known : sequence of shapely.Polygon, optional
        The first of what this yields.

    Yields
    ------
    shapely.Polygon
        Nested, from `start` to where only corners are left (see `corners`).
    """
    known = known or [oriented(without_idle_holes(start, omega, rules))]
    yield from known
    front = known[-1]
    wanted = best_width(front, omega, rules)

    def step(visited: Polygon, within: Polygon) -> Polygon:
        return _without_scraps(_stretched(visited, within, rules, wanted), visited, within, rules)

    is_beyond_neck = False
    while True:
        # what is less than a room is left to steps of the whole front, in the end
        rooms = rooms_left(front, omega, rules) if is_beyond_neck else []
        if rooms:
            grown = grown_locally(step, front, omega, rooms, _around(rules))
        else:
            grown = step(front, omega)
        if _has_stalled(grown, front, rules):
            is_beyond_neck = True
            through = _through_necks(front, omega, rules)
            if through is None and rooms:
                through = step(front, omega)
            if through is None or _has_stalled(through, front, rules):
                return
            grown = through
        touched = [ground for ground in idle if ground.intersects(grown)]
        if touched:
            grown = largest(welded([grown, *touched]))
            idle = [ground for ground in idle if ground not in touched]
        front = oriented(without_whiskers(grown))
        yield front


def _stretched(visited: Polygon, omega: Polygon, rules: FrontRules, wanted: FrontRules) -> Polygon:
    """Return the next front as wide as wanted, or wider where it would leave only thin ribs."""
    grown = advance(visited, omega, wanted)
    ribs = ribs_in(grown, omega, rules)
    if ribs < RIBS * rules.cutter_radius * rules.stepover:
        return grown
    other = advance(visited, omega, widened(rules, STRETCH))
    return other if ribs_in(other, omega, rules) < ribs / 2 else grown


def _without_scraps(grown: Polygon, visited: Polygon, omega: Polygon, rules: FrontRules) -> Polygon:
    """Return a front without the strokes that would hardly cut anything before a corner.

    There the fillet is nearly reached; the corner is better finished from where it is.
    """
    if not _may_have_scraps(grown, visited, rules):
        return grown
    pieces = shapely.get_parts(shapely.difference(grown, visited))
    coords, piece = shapely.get_coordinates(pieces, return_index=True)
    thin = np.ones(len(pieces), dtype=bool)
    thin[piece[~are_within(visited, coords, SCRAP * rules.stepover)]] = False
    thin &= shapely.dwithin(pieces, omega.boundary, TOUCHES)
    if not thin.any():
        return grown
    return largest(shapely.difference(grown, shapely.union_all(pieces[thin])))


def _may_have_scraps(grown: Polygon, visited: Polygon, rules: FrontRules) -> bool:
    """Return whether a run of new points along the rings stays close to `visited`; quick."""
    for ring in rings_of(grown):
        # straight walls have no points of their own between the corners
        points = shapely.get_coordinates(shapely.segmentize(ring, 1.0))
        new = ~are_within(visited, points, NEW)
        if not new.any() or new.all():
            continue
        first = int(np.flatnonzero(~new)[0])
        new = np.roll(new, -first)
        far = np.roll(~are_within(visited, points, SCRAP * rules.stepover), -first)
        run = np.cumsum(np.diff(new.astype(np.int8), prepend=0) > 0)[new]
        if (np.bincount(run, weights=far[new])[1:] == 0).any():
            return True
    return False


def _has_stalled(grown: Polygon, visited: Polygon, rules: FrontRules) -> bool:
    """Return whether a front adds next to nothing, or creeps on."""
    gained = grown.area - visited.area
    if gained < STALLED * rules.stepover * rules.cutter_radius:
        return True
    creep = CREEP * rules.stepover
    if gained > creep * visited.length:
        return False
    return bool(grow_coarsely(shapely.difference(grown, visited), -creep / 2).is_empty)


def advance_narrowly(visited: Polygon, omega: Polygon, rules: FrontRules, share: float) -> Polygon:
    """Return the next front with a share of the fillet, which enters narrower ways."""
    return advance(visited, omega, replace(rules, fillet=share * rules.fillet))


def leads_on(visited: Polygon, omega: Polygon, rules: FrontRules) -> bool:
    """Return whether there is a room ahead into which an ordinary front goes on."""
    rooms = rooms_left(visited, omega, rules)
    if not rooms:
        return False
    step = partial(advance, rules=rules)
    grown = grown_locally(step, visited, omega, rooms, _around(rules))
    return not _has_stalled(grown, visited, rules)


def rooms_left(visited: Polygon, omega: Polygon, rules: FrontRules) -> list[Polygon]:
    """Return the pieces of what is left that are more than corners."""
    rest = polygons_of(shapely.difference(omega, visited))
    return [p for p in rest if not shapely.buffer(p, -ROOM * rules.fillet).is_empty]


def _around(rules: FrontRules) -> float:
    """Return how far around a room the front matters for its steps [mm]."""
    return AROUND * rules.cutter_radius


def _through_necks(visited: Polygon, omega: Polygon, rules: FrontRules) -> Polygon | None:
    """Return the next front where only necks too narrow for the fillet lead on, or None."""
    rooms = rooms_left(visited, omega, rules)
    if not rooms:
        return None
    for share in NECK_FILLETS:
        step = partial(advance_narrowly, rules=rules, share=share)
        grown = grown_locally(step, visited, omega, rooms, _around(rules))
        if not _has_stalled(grown, visited, rules):
            return grown
    return None
