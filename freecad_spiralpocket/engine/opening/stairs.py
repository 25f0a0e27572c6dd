# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loops of a slot along the wall that come nearer to it level by level.

A full slot takes its bite and no more, and its last level is mostly a thin one. So each loop
runs nearer to the wall than the one above it, by as much as the engagement allows, and takes
the rib beside it along: it removes as much as a lap. Only the last one runs along the wall, at
the full depth, climb, so that the wall is cut in one and not in levels. What they leave within
is a stair, on which the first lap may step farther than others; it clears the stair's floor.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from ..floor import Stairs
from ..growth.front_rules import WIDEST, FrontRules, rules_of
from ..growth.strokes import Stroke
from ..model import Floats, PocketRequest
from ..shapes.points import signed_area
from ..shapes.polyline import closed_line
from ..shapes.shaping import CRACK
from ..stepover import radial_depth
from .slot import ways_aside
from .stair_profile import profile_of

#: Stairs are not worth a look that save less than this, over all stock.
WORTH = 0.015
#: What laps must do in every corner that the lines avoid, over R and the inner line's distance.
LUMP = 2.5
#: The ring is longer than this over all ramps and ways aside.
LEAST_LENGTH = 1.2
#: The loop along the wall and the first lap are engaged by no more than the second above the limit
#: where the stock is lower than told by the first, over the depth [rad].
LOWER, SLACK = 1 / 6, math.radians(5.0)
#: What the first lap may leave of the stair's floor, over R squared.
CRUMB = 1e-4
#: Halvings in the search for many limits at once, and rounds and sections in that for one.
HALVINGS = 30
ROUNDS, SECTIONS = 4, 24


def stairs_of(
    ring: Floats, region: Polygon, bite: float, request: PocketRequest, bare: float
) -> tuple[Stairs, float] | None:
    """Return the loops of a slot along a wall, and what they save, over all stock.

    None where all had better run along the wall.

    Parameters
    ----------
    ring : ndarray of shape (n, 2)
        Along the wall, counter-clockwise, the first point is not repeated [mm].
    region : shapely.Polygon
        The cutter-center region, with the ring as its exterior.
    bite : float
        Axial depth of the slot's levels [mm].
    request : PocketRequest
    bare : float
        So far beside corners all loops run along the wall, over R.
    """
    radius, rules, depth = request.cutter_radius, rules_of(request), request.axial_depth
    drops = _drops(depth, bite)
    distances = _distances(drops, rules)
    inner = float(_first_lap(drops, distances, rules)) - rules.stepover
    if inner <= 0:
        return None
    wall = closed_line(ring)
    stock = region.area + region.length * radius
    if inner * wall.length < WORTH * stock:
        return None
    profile = profile_of(wall, region, distances[0], inner, rules, bare * radius)
    if profile is None:
        return None
    offsets = np.stack([profile.offsets(d) for d in distances])
    lines = np.stack([profile.line(off) for off in offsets])
    inner_offsets = np.maximum(_first_lap(drops, offsets, rules) - rules.stepover, 0.0)
    stairs = Stairs(lines, drops / depth, profile.line(inner_offsets))
    asides = float(ways_aside(stairs).sum())
    if wall.length < LEAST_LENGTH * (asides + depth / math.tan(request.entry.helix_angle)):
        return None
    saved = signed_area(lines[-1]) - signed_area(stairs.inner) - asides * rules.stepover
    off = float(np.hypot(*(lines[-1] - stairs.inner).T).max())
    saved -= LUMP * profile.tapers * off * radius
    share = saved / stock
    if share < WORTH or not _are_within(region, [*lines[:-1], stairs.inner]):
        return None
    return stairs, share


def leaves_crumbs(stairs: Stairs, first: Sequence[Stroke], radius: float) -> bool:
    """Return whether the first lap leaves any of what the stairs leave on the floor.

    Parameters
    ----------
    stairs : Stairs
    first : sequence of Stroke
        Along the first front from the inner line.
    radius : float
        R [mm].
    """
    wall = Polygon(stairs.lines[-1])
    steps = shapely.difference(wall, Polygon(stairs.inner))
    laps = [closed_line(s.points) if s.closed else LineString(s.points) for s in first]
    lines = shapely.multilinestrings([wall.exterior, *laps])
    # a tenth of the time of seeing to it that no edges come to cross, which growing heals
    steps, lines = shapely.simplify([steps, lines], CRACK / 4, preserve_topology=False)
    swept = shapely.buffer(lines, radius + CRACK)
    return bool(shapely.difference(shapely.buffer(steps, radius), swept).area > CRUMB * radius**2)


def _drops(depth: float, bite: float) -> Floats:
    """Return how much deeper each level is than the one before, all but the last one by a bite."""
    count = max(1, math.ceil(depth / bite - 1e-9))
    return np.append(np.full(count - 1, bite), depth - (count - 1) * bite)


def _distances(drops: Floats, rules: FrontRules) -> Floats:
    """Return how far off a straight wall each loop runs, shape (k,) [mm].

    It is engaged all round in its own level, and in the levels above with the rib beside it: no
    more than a lap is, and removing no more than the widest. The first lap must reach over all
    that is left to what is cleared down to the floor.
    """
    radius, depth = rules.cutter_radius, float(drops.sum())
    above = (np.cumsum(drops) - drops)[1:]
    angles = (rules.limit * depth - math.pi * drops[1:]) / above
    if len(above):
        lower = LOWER * depth
        at_most = (rules.limit + SLACK) * (depth - lower) - math.pi * drops[-1]
        angles[-1] = min(angles[-1], at_most / max(above[-1] - lower, 1e-9))
    by_angle = radial_depth(np.maximum(angles, 0.0), radius)
    by_volume = (WIDEST * rules.stepover * depth - 2 * radius * drops[1:]) / above
    steps = np.maximum(np.minimum(by_angle, by_volume), 0.0)
    distances = np.append(np.cumsum(steps[::-1])[::-1], 0.0)
    reach = 2 * radius - (WIDEST - 1) * rules.stepover

    def is_reached(most: Floats) -> NDArray[np.bool_]:
        tried = np.minimum(distances[:, None], most)
        return np.asarray(_first_lap(drops, tried, rules) < reach)

    distances = np.minimum(distances, _largest_one(is_reached, float(distances[0])))
    # what a loop clears beyond the first lap's middle would be lost
    return np.minimum(distances, _first_lap(drops, distances, rules))


def _first_lap(drops: Floats, distances: Floats, rules: FrontRules) -> Floats:
    """Return how far off the wall a lap is engaged to the limit by what the loops leave [mm].

    `distances` of the loops have shape (k, ...), the result that without the first axis.
    """
    radius, depth = rules.cutter_radius, float(drops.sum())
    lower = LOWER * depth
    layers, left = (
        part.reshape(-1, *[1] * (distances.ndim - 1))
        for part in (drops, np.clip(np.cumsum(drops) - lower, 0.0, drops))
    )

    def is_below(lap: Floats) -> NDArray[np.bool_]:
        angles = np.arccos(np.clip((radius + distances - lap) / radius, -1.0, 1.0))
        is_gentle = (left * angles).sum(axis=0) < (rules.limit + SLACK) * (depth - lower)
        return np.asarray(((layers * angles).sum(axis=0) < rules.limit * depth) & is_gentle)

    return _largest(is_below, distances[0] + 2 * radius)


def _largest(holds: Callable[[Floats], NDArray[np.bool_]], most: Floats) -> Floats:
    """Return the largest values in [0, `most`] up to which something holds, each for itself."""
    low, high = np.zeros(np.shape(most)), np.asarray(most, dtype=float)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        found = holds(middle)
        low, high = np.where(found, middle, low), np.where(found, high, middle)
    return low


def _largest_one(holds: Callable[[Floats], NDArray[np.bool_]], most: float) -> float:
    """Return the largest value in [0, `most`] up to which something holds."""
    low, step = 0.0, most
    for _ in range(ROUNDS):
        step /= SECTIONS
        found = holds(np.linspace(low, low + SECTIONS * step, SECTIONS + 1)[1:])
        low += step * int(np.logical_and.accumulate(found).sum())
    return low


def _are_within(region: Polygon, lines: Sequence[Floats]) -> bool:
    """Return whether closed lines do not cross themselves, nor the outer wall."""
    fence = shapely.buffer(Polygon(region.exterior), 1e-6)
    rings = shapely.polygons([np.vstack([line, line[:1]]) for line in lines])
    return bool(shapely.is_valid(rings).all() and shapely.covers(fence, rings).all())
