# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rounding the reentrant kinks of a moved front, each as widely as the cutter clears it.

A closing fills kinks. What it fills counts as cleared, so that it must lie within the cutter's
reach of where it goes; and where the cutter goes round what was filled, the rounded corner of a
plug, its engagement must stay near the limit.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from ..model import Floats
from ..shapes.points import cross
from ..shapes.region import polygons_of, rings_of
from ..shapes.shaping import (
    SLIVER,
    Region,
    are_within,
    clipped,
    closing_of,
    grow_coarsely,
    grow_prepared,
    holes_of,
    opening_of,
    sizable_parts,
    welded,
)
from ..stepover import radial_depth
from .front_rules import NEW, WIDEST, FrontRules

#: A front goes no farther than the first beyond the last, over R: there the cutter reached over. Or
#: as far as its widest step where that is farther, up to the second.
REACHED, REACHED_WIDE = 0.92, 0.96
#: Round the corner of a plug the cutter may be engaged by so much above the limit [rad]: it comes
#: out of it along a side, to which the old lap was nearer. Asked at chords of so much, over R.
SLACK, CHORD = np.radians(10.0), 0.1
#: Radii tried to round a reentrant kink, over `FrontRules.closing`.
CLOSINGS = (1.0, 0.5, 0.2)
#: The same for slim tips that are left where fronts meet: no link bends more tightly.
TIP = 0.09
#: A fill's cusp turns by more than this [rad], and is rounded with this radius, over R.
CUSP_TURN, CUSP = np.radians(25.0), 0.35
#: A filled arm shortens the edge by more than this, over R.
ARM = 0.5
#: A fill is small whose points and middle are no farther from its rim than this over the reach.
SMALL = 0.1
#: Beside a moved front so much of a fill is left out [mm], less than fronts are simplified by:
#: edges that a closing does not round are nearly the same, and hairs along them would join fills.
HAIR = 0.001
#: Distance of the points of a fill by which its new edges are counted [mm].
EDGE = 0.5


def without_kinks(moved: Region, visited: Polygon, omega: Polygon, rules: FrontRules) -> Region:
    """Return a moved front with its reentrant kinks rounded.

    Parameters
    ----------
    moved : shapely.Polygon or MultiPolygon
        The region visited after a step.
    visited, omega : shapely.Polygon
        The region visited before; the cutter-center region.
    rules : FrontRules
    """
    return _without_cusps(_closed(moved, visited, omega, rules, CLOSINGS), moved, rules)


def _closed(
    moved: Region, visited: Polygon, omega: Polygon, rules: FrontRules, shares: Sequence[float]
) -> Region:
    """Round reentrant kinks of a moved front, each as widely as the cutter reaches over.

    Going round `visited` and then round the new front it clears what is within its radius of
    either; a wider fill would be taken for cleared and stay standing. There the next smaller of
    the radii in `shares` is taken.
    """
    if not shares:
        return _with_blunt_tips(moved, visited, rules)
    radius = shares[0] * rules.closing
    closed = closing_of(moved, radius)
    fills = _doubtful_fills(closed, moved, visited, rules)
    if len(fills) == 0:
        return closed
    edges = _new_edges(fills, moved)
    # only a plug's corners: elsewhere strokes, not laps, would have to take so much
    corner = (edges == 1) & shapely.contains_properly(Polygon(visited.exterior), fills)

    @cache
    def edge() -> shapely.Geometry:
        return shapely.intersection(closed, omega).boundary

    beyond = _are_beyond(fills, corner, edges == 0, visited, edge, rules)
    asked = corner & ~beyond
    if asked.any():
        beyond[asked] = _are_steep(fills[asked], moved, visited, rules)
    far = fills[beyond]
    if len(far) == 0:
        return closed
    pieces = [shapely.difference(closed, shapely.union_all(far))]
    for piece in far:
        zone = grow_coarsely(piece, 0.01)
        x0, y0, x1, y1 = zone.bounds
        near = clipped(moved, (x0 - radius, y0 - radius, x1 + radius, y1 + radius))
        finer = _closed(near, visited, omega, rules, shares[1:])
        pieces.append(shapely.intersection(finer, zone))
    return shapely.union_all(pieces)


def _with_blunt_tips(moved: Region, visited: Polygon, rules: FrontRules) -> Region:
    """Round the tips of what is left, where the cutter clears what that fills.

    In a slim tip a lap turns back on the spot. Slits stay: filled they would make two plugs of one.
    """
    radius = TIP * rules.closing
    closed = closing_of(moved, radius)
    fills = sizable_parts(_filled(closed, moved))
    if len(fills) == 0:
        return moved
    reach = _gentle_reach(rules)
    coords, of = shapely.get_coordinates(fills, return_index=True)
    kept = _new_edges(fills, moved) != 1
    kept[of[~are_within(visited, coords, reach)]] = True
    return shapely.difference(closed, shapely.union_all(fills[kept]))


def _without_cusps(closed: Region, moved: Region, rules: FrontRules) -> Region:
    """Round the cusps of what was filled, which arise where a closing just fits through a channel.

    Tips of the moved front itself stay.
    """
    rings = [ring for p in polygons_of(closed) for ring in rings_of(p)]
    coords, of = shapely.get_coordinates(rings, return_index=True)
    steps, same = np.diff(coords, axis=0), of[1:] == of[:-1]
    turns = np.arctan2(cross(steps[:-1], steps[1:]), (steps[:-1] * steps[1:]).sum(axis=1))
    # the visited region is on the left
    sharp = coords[1:-1][(turns > CUSP_TURN) & same[1:] & same[:-1]]
    if are_within(moved, sharp, NEW).all():
        return closed
    radius = CUSP * rules.cutter_radius
    return welded([opening_of(closed, radius), moved])


def _doubtful_fills(
    closed: Region, moved: Region, visited: Polygon, rules: FrontRules
) -> NDArray[np.object_]:
    """Return what was filled; none if surely all of it is within reach of `visited`."""
    reach = _gentle_reach(rules)
    is_near = holes_of(closed) >= holes_of(moved) and bool(
        are_within(visited, shapely.get_coordinates(closed), reach).all()
    )
    # an arm that was filled has no edge left that would tell
    if is_near and moved.length - closed.length < ARM * rules.cutter_radius:
        return np.empty(0, object)
    filled = _filled(closed, moved)
    if is_near and shapely.difference(filled, grow_prepared(visited, reach)).area < SLIVER:
        return np.empty(0, object)
    return sizable_parts(filled)


def _filled(closed: Region, moved: Region) -> Region:
    """Return what was filled, but for hairs along the edges of `moved`."""
    return shapely.difference(closed, shapely.buffer(moved, HAIR, join_style="mitre"))


def _reach(rules: FrontRules) -> float:
    """Return how far beyond the last front the cutter surely clears [mm]."""
    widest = WIDEST * rules.stepover / rules.cutter_radius
    return rules.cutter_radius * min(REACHED_WIDE, max(REACHED, widest))


def _gentle_reach(rules: FrontRules) -> float:
    """Return up to where beyond the last front no corner of a plug is `_are_steep` [mm]."""
    return min(_reach(rules), radial_depth(rules.limit + SLACK, rules.cutter_radius))


def _new_edges(fills: NDArray[np.object_], moved: Region) -> NDArray[np.intp]:
    """Return how many new edges each fill has: none closes a hole, two join two fronts."""
    rings = shapely.segmentize(shapely.get_exterior_ring(fills), EDGE)
    coords, of = shapely.get_coordinates(rings, return_index=True)
    new = ~are_within(moved, coords, NEW)
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
    edge: Callable[[], shapely.Geometry],
    rules: FrontRules,
) -> NDArray[np.bool_]:
    """Return which fills the cutter does not clear wholly.

    It goes round `visited`, and where a `corner` is rounded then along its new `edge`, which is
    made when it is asked for.
    """
    reach = _reach(rules)
    coords, of = shapely.get_coordinates(fills, return_index=True)
    lost = ~are_within(visited, coords, reach)
    regained = lost & corner[of]
    if regained.any():
        lost[regained] = ~shapely.dwithin(edge(), shapely.points(coords[regained]), reach)
    beyond = np.zeros(len(fills), dtype=bool)
    beyond[of[lost]] = True
    # the middle of a wide piece may be out of reach though its rim is not
    doubtful = ~beyond & (closing | (shapely.area(fills) > reach**2))
    if doubtful.any():
        doubtful &= ~_are_surely_near(fills, coords, of, visited, reach)
    for i in np.flatnonzero(doubtful):
        x0, y0, x1, y1 = fills[i].bounds
        window = shapely.box(x0 - reach, y0 - reach, x1 + reach, y1 + reach)
        around = (visited, edge()) if corner[i] else (visited,)
        near = [grow_coarsely(shapely.intersection(s, window), reach) for s in around]
        beyond[i] = shapely.difference(fills[i], shapely.union_all(near)).area > SLIVER
    return beyond


def _are_steep(
    corners: NDArray[np.object_], moved: Region, visited: Polygon, rules: FrontRules
) -> NDArray[np.bool_]:
    """Return round which filled corners the cutter would be engaged too much, either way.

    Where its rim is by the largest angle from the stock's side, stock stands if that place is
    farther than R from all that it has visited.
    """
    radius = rules.cutter_radius
    rings = shapely.segmentize(shapely.get_exterior_ring(corners), CHORD * radius)
    coords, of = shapely.get_coordinates(rings, return_index=True)
    middles, steps = (coords[1:] + coords[:-1]) / 2, np.diff(coords, axis=0)
    new = (of[1:] == of[:-1]) & ~are_within(moved, middles, NEW)
    middles, steps, of = middles[new], steps[new], of[1:][new]
    along = steps / np.maximum(np.hypot(*steps.T), 1e-12)[:, None]
    aside = np.column_stack([along[:, 1], -along[:, 0]])
    # a fill is on the left of its ring, if that is counter-clockwise, and the stock on the right
    aside *= np.where(shapely.is_ccw(rings), 1.0, -1.0)[of, None]
    angle = rules.limit + SLACK
    steep = np.zeros(len(corners), dtype=bool)
    for way in (1.0, -1.0):
        rim = middles + radius * (np.cos(angle) * aside + way * np.sin(angle) * along)
        steep[of[~are_within(visited, rim, radius)]] = True
    return steep


def _are_surely_near(
    fills: NDArray[np.object_],
    coords: Floats,
    of: NDArray[np.intp],
    visited: Polygon,
    reach: float,
) -> NDArray[np.bool_]:
    """Return which fills are so small that they lie within reach where their points do; quick.

    `coords` are the points of the fills, and `of` tells to which each belongs.
    """
    slack = SMALL * reach
    chords = np.hypot(*np.diff(coords, axis=0).T) * (of[1:] == of[:-1])
    longest = np.zeros(len(fills))
    np.maximum.at(longest, of[1:], chords)
    # no disc in it is larger than all of it
    small = np.sqrt(shapely.area(fills) / np.pi) + longest / 2 < slack
    far = np.zeros(len(fills), bool)
    far[of[~are_within(visited, coords, reach - slack)]] = True
    return small & ~far
