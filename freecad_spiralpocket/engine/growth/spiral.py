# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed laps become one spiral: each lap blends into the next over a short zone.

Over `BLEND` the path is ``(1 - s) lap_k + s nearest(lap_k+1)`` with s rising
smoothly (the linear morph of LM15, one zone long). Every lap blends at the same
place, so the distance between turns stays one step everywhere: nothing is lost,
nothing is cut twice, on any shape. The last lap runs on through its own zone.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import LineString, Polygon

from ..model import Floats
from ..numerics.distinct import distinct
from ..numerics.filters import evened, highest
from ..numerics.nearest import nearest
from ..shapes.points import distances_along
from ..shapes.polyline import between, located_nearby, points_at
from ..shapes.shaping import Region, rim_points
from .strokes import CHORD, Stroke

#: Length of the zone over which a lap becomes the next, over R: the way across adds its angle to
#: the engagement.
BLEND = 7.0
#: A step-over wider than this over R has a longer zone, so that the way across is as flat.
FLAT = 0.8
#: Longest chord of a blend [mm]: round the tip of a slot it is tight.
FINE_CHORD = 0.1
#: It is at most this share of the shorter lap: outwards, and inwards, where more would be lost by a
#: steep way across than by a long one.
OUTWARDS, INWARDS = 0.4, 0.8
#: A lap is slim whose area is less than this share of a disc's of the same girth.
SLIM = 0.5
#: The way across is evened out over so much [mm].
EVEN = 1.0
#: Steps into which a zone is divided to measure gaps.
SAMPLES = 6
#: Places to leave a lap that are looked at, on long ones one in so many R.
ZONES, APART = 8, 1.5
#: Distance of all places where a lap may be left, over R.
CLOSE = 0.25
#: Distance of samples of the stock that the last lap of a plug takes, over R.
SAMPLING = 0.2
#: So little of that stock is none [mm2], and the path runs on so far, over R.
CRUMB, RUN_ON = 1e-4, 0.3
#: Where that is not enough so much more of the path is looked at, over R.
FURTHER = 0.1
#: Where all of a path is looked at, points are left out that matter less [mm].
STRAIGHT = 0.0002
#: Share of the zone over which that angle builds up, and dies away.
EASE = 0.2


def eased(u: Floats) -> Floats:
    """Return a rise from 0 to 1 over `u` in [0, 1], of any shape.

    Its slope builds up and dies away evenly and is constant between.
    """
    top = 1 / (1 - EASE)
    rise = top * u * u / (2 * EASE)
    fall = 1 - top * (1 - u) ** 2 / (2 * EASE)
    return np.where(u < EASE, rise, np.where(u > 1 - EASE, fall, top * (u - EASE / 2)))


def blend(lap: LineString, start: float, target: LineString, length: float) -> Floats:
    """Return the way from `lap` at `start` onto `target`, over `length`, shape (n, 2) [mm]."""
    count = max(4, int(np.ceil(length / FINE_CHORD)))
    u = np.linspace(0.0, 1.0, count + 1)
    source = points_at(lap, (start + u * length) % lap.length)
    across = located_nearby(target, source)
    # the nearest point jumps at every vertex of the chords that stand for a curve
    across = np.unwrap(across, period=target.length)
    across = evened(across, EVEN / FINE_CHORD)
    onto = points_at(target, across % target.length)
    s = eased(u)[:, None]
    return (1 - s) * source + s * onto


def zone_size(radius: float, stepover: float) -> float:
    """Return what stands for R, as `radius`, where zones between laps are laid out [mm]."""
    return max(radius, stepover / FLAT)


def zone_length(lap: LineString, target: LineString, radius: float) -> float:
    """Return the length of the zone between two laps [mm]; for `radius` see `zone_size`."""
    shortest = min(lap.length, target.length)
    share = INWARDS if target.length < lap.length else OUTWARDS
    return min(BLEND * radius, share * shortest)


def gaps(
    lap: LineString, target: LineString, starts: Floats, length: float, within: float = np.inf
) -> Floats:
    """Return the widest gap between two laps in the zone that begins at each of some places.

    Parameters
    ----------
    lap, target : LineString
        Closed.
    starts : ndarray of shape (n,)
        Places along `lap` [mm].
    length : float
        Of the zones [mm].
    within : float, optional
        Wider gaps are infinite, which takes less time [mm].

    Returns
    -------
    ndarray of shape (n,)
        [mm]
    """
    at = (starts[:, None] + np.linspace(0.0, length, SAMPLES + 1)) % lap.length
    return _apart(lap, target, at.ravel(), within).reshape(at.shape).max(axis=1)


def gaps_all_round(
    lap: LineString, target: LineString, count: int, length: float, within: float = np.inf
) -> Floats:
    """Return what `gaps` does for `count` places that divide a lap evenly, shape (count,) [mm].

    What the zones have in common is only measured once.
    """
    each = max(1, int(np.ceil(SAMPLES * lap.length / (length * count))))
    at = np.linspace(0.0, lap.length, each * count, endpoint=False)
    apart = _apart(lap, target, at, within)
    half = int(np.ceil(length / lap.length * len(at) / 2))
    return np.roll(highest(apart, 2 * half + 1, closed=True), -half)[::each]


def zones(lap: LineString, target: LineString, radius: float, widest: float) -> Floats:
    """Return places along `lap` where it may be left for `target`, some `ZONES`, shape (n,) [mm].

    Spread over those where the gap through the zone is at most `widest`; the one of the least gap
    where there is none. For `radius` see `zone_size`.
    """
    places = max(12, int(lap.length / radius))
    starts = np.linspace(0.0, lap.length, places, endpoint=False)
    wide = np.round(gaps_all_round(lap, target, places, zone_length(lap, target, radius)), 3)
    good = np.flatnonzero(wide <= widest)
    if len(good) == 0:
        return starts[[int(np.argmin(wide))]]
    count = max(ZONES, int(lap.length / (APART * radius)))
    return starts[good[distinct(np.linspace(0, len(good) - 1, count).astype(int))]]


def anywhere(lap: LineString, target: LineString, radius: float, widest: float) -> Floats:
    """Return all places along `lap` where it may be left for `target`, shape (n,) [mm].

    They are `CLOSE` together; `radius` and `widest` are as in `zones`.
    """
    count = max(12, int(lap.length / (CLOSE * radius)))
    starts = np.linspace(0.0, lap.length, count, endpoint=False)
    length = zone_length(lap, target, radius)
    wide = gaps_all_round(lap, target, count, length, 1.01 * widest)
    return starts[np.round(wide, 3) <= widest]


def slim_ends_of(lap: LineString, target: LineString, radius: float, widest: float) -> Floats:
    """Return where to leave `lap` for a slim `target`, so that one side of that is cut first [mm].

    Then hardly anything is left for the way back. Shape (2,) at most, empty where it is not slim,
    or too far; `radius` and `widest` are as in `zones`.
    """
    coords = shapely.get_coordinates(target)
    if 4 * np.pi * Polygon(coords).area > SLIM * target.length**2:
        return np.empty(0)
    middle = coords.mean(axis=0)
    along = (coords - middle) @ np.linalg.svd(coords - middle, full_matrices=False)[2][0]
    tips = shapely.points(coords[[np.argmin(along), np.argmax(along)]])
    length = zone_length(lap, target, radius)
    starts = (shapely.line_locate_point(lap, tips) - length) % lap.length
    return starts[gaps(lap, target, starts, length) <= widest]


def onward(
    lap: LineString, start: float, target: LineString, radius: float, widest: float
) -> float | None:
    """Return how far beyond `start` a lap is best left for the next [mm].

    That is to where the gap through the zone is at most `widest`, at most over the length of a
    zone; None if it is nowhere. `radius` and `widest` are as in `zones`.
    """
    length = zone_length(lap, target, radius)
    further = np.arange(0.0, length, radius / 2)
    if gaps(lap, target, np.array([start]), length)[0] <= widest:
        return 0.0
    good = np.flatnonzero(gaps(lap, target, start + further, length) <= widest)
    return float(further[good[0]]) if len(good) else None


def spiral_through(
    first: LineString,
    start: float,
    laps: Sequence[LineString],
    radius: float,
    widest: float = np.inf,
    whole: int = 1,
) -> Floats:
    """Return the spiral from `first`, which is already cut, through `laps`.

    Parameters
    ----------
    first : LineString
        Closed; left at `start` [mm] along it.
    laps : sequence of LineString
        Closed, each beside the one before, in the same direction.
    radius : float
        See `zone_size` [mm].
    widest : float, optional
        A lap goes on until the next is so near [mm].
    whole : int, optional
        So many of the last laps run on through their own zone, where each lags behind.

    Returns
    -------
    ndarray of shape (n, 2)
    """
    pieces = []
    here, at = first, start
    for i, lap in enumerate(laps):
        length = zone_length(here, lap, radius)
        way = blend(here, at, lap, length)
        pieces.append(way)
        landed = lap.project(shapely.Point(way[-1]))
        # the next blend begins beside the place where this one began
        leave = lap.project(shapely.Point(way[0]))
        run = (leave - landed) % lap.length
        if i >= len(laps) - whole:
            run += (landed - leave) % lap.length
        if i < len(laps) - 1:
            run += onward(lap, (landed + run) % lap.length, laps[i + 1], radius, widest) or 0.0
        pieces.append(between(lap, landed, run)[1:])
        here, at = lap, (landed + run) % lap.length
    return np.vstack(pieces)


def without_air(points: Floats, stock: Region, reach: float) -> Floats | None:
    """Return a path up to where all of `stock` has been within `reach` of it; None if it never is.

    Parameters
    ----------
    points : ndarray of shape (n, 2)
        Close together against `reach` [mm].
    stock : shapely.Polygon or MultiPolygon
        That stands before, outside of the reach of nearly all of the path.
    reach : float
        [mm]
    """
    if stock.is_empty:
        return points
    x0, y0, x1, y1 = stock.bounds
    x, y = np.meshgrid(np.arange(x0, x1, SAMPLING * reach), np.arange(y0, y1, SAMPLING * reach))
    inner = np.column_stack([x.ravel(), y.ravel()])
    inner = inner[shapely.contains_xy(stock, inner)]
    rim, _ = rim_points(stock, SAMPLING * reach)
    samples = np.vstack([inner, rim])
    tree = shapely.STRtree(shapely.points(points))
    sample, hit = tree.query(shapely.points(samples), predicate="dwithin", distance=reach)
    if len(hit) == 0:
        return None
    earliest = np.full(len(samples), len(points))
    np.minimum.at(earliest, sample, hit)
    earliest = earliest[earliest < len(points)]
    first, needed = int(earliest.min()), int(earliest.max()) + 1
    # between the samples a little may stand yet
    rest = shapely.simplify(LineString(points[first:]), STRAIGHT, preserve_topology=False)
    if shapely.difference(stock, shapely.buffer(rest, reach, quad_segs=32)).area >= CRUMB:
        return None
    along = distances_along(points)
    while True:
        way = LineString(points[first : needed + 1])
        stock = shapely.difference(stock, shapely.buffer(way, reach, quad_segs=32))
        if stock.area < CRUMB:
            end = along[min(needed, len(along) - 1)] + RUN_ON * reach
            return points[: int(np.searchsorted(along, end)) + 2]
        if needed >= len(points) - 1:
            return None
        first = needed
        needed = int(np.searchsorted(along, along[needed] + FURTHER * reach))


def chains_of(strokes: Sequence[Stroke]) -> list[list[int]]:
    """Return runs of closed laps at successive levels, each beside the one before, as indices.

    The visited region is one piece, so that each level has one outer boundary: a closed outer
    lap follows the one of the level before. An inner lap, about stock that the fronts surround,
    follows the one that it lies in.
    """
    chains: list[list[int]] = []
    for i in sorted((i for i, s in enumerate(strokes) if s.closed), key=lambda i: strokes[i].level):
        for chain in chains:
            if _follows(strokes[i], strokes[chain[-1]]):
                chain.append(i)
                break
        else:
            chains.append([i])
    return chains


def _follows(lap: Stroke, before: Stroke) -> bool:
    """Return whether a closed lap is the next one after another."""
    if lap.level != before.level + 1 or lap.exterior != before.exterior:
        return False
    return lap.exterior or Polygon(before.points).contains(shapely.Point(lap.points[0]))


def _apart(lap: LineString, target: LineString, at: Floats, within: float) -> Floats:
    """Return how far places along a lap [mm] are from another; infinite beyond `within` [mm]."""
    chords = shapely.get_coordinates(shapely.segmentize(target, CHORD))
    return nearest(chords, points_at(lap, at), within)[0]
