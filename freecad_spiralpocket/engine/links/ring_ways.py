# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways that lead over the slot that the entry cut, where it is a line with stock beside it.

A raster of free ground does not show so narrow a slot, nor a spline keep to it.
"""

from __future__ import annotations

import numpy as np
import shapely
from shapely import LineString, Polygon

from ..model import Floats
from ..shapes.drawing_near import drawn_to
from ..shapes.points import distances_along
from ..shapes.polyline import between, points_at
from .cleared import ClearedMap
from .routing import CHORD, LongWays

#: What is nearer than this to the slot is on it [mm].
ON_RING = 0.1
#: Beside the slot a way draws near to it over so many times its distance.
DRAW = 15.0
#: A run begins along the slot where the cosine between both is more than this.
ALONG = 0.95
#: A way goes onto the slot no farther than this before a run begins, over R.
FARTHEST = 12.0
#: To so many places on the slot, so far apart over R, a way is looked for.
PLACES, APART = 10, 0.7


def onto_ring(
    long_ways: LongWays,
    ends: Floats,
    arriving: Floats,
    cleared: ClearedMap,
    fence: Polygon,
    radius: float,
) -> tuple[Floats, int] | None:
    """Return a smooth way onto the slot and along it to an end, and the index of that.

    None if there is none: where the slot leaves free ground, as from a channel into a room in which
    it runs along the wall, a way may turn onto it.

    Parameters
    ----------
    long_ways : LongWays
        From where the cutter is.
    ends, arriving : ndarray of shape (n, 2)
        Where ways may end [mm], and the unit directions there.
    cleared : ClearedMap
    fence : shapely.Polygon
        Is not left; prepared.
    radius : float
        R [mm].
    """
    ring = cleared.ring
    if ring is None:
        return None
    near = np.flatnonzero(shapely.distance(ring, shapely.points(ends)) <= ON_RING)
    places = shapely.line_locate_point(ring, shapely.points(ends[near]))
    with_it = (_tangents(ring, places) * arriving[near]).sum(axis=1)
    near, places, with_it = (of[np.abs(with_it) > ALONG] for of in (near, places, with_it))
    behind = np.arange(APART * radius, min(FARTHEST * radius, ring.length / 2), APART * radius)
    onto = (places[:, None] - np.sign(with_it)[:, None] * behind) % ring.length
    free = cleared.free[cleared.cells(points_at(ring, onto.ravel()))].reshape(onto.shape)
    back, end = np.nonzero(free.T)  # the shortest way along the slot first
    taken: list[int] = []
    for k in range(len(back)):
        apart = np.abs(onto[end[k], back[k]] - onto[end[taken], back[taken]])
        if (apart > APART * radius).all():
            taken.append(k)
        if len(taken) == PLACES:
            break
    for k in taken:
        i, at = end[k], float(onto[end[k], back[k]])
        place = points_at(ring, np.array([at]))[0]
        way = long_ways.to(place, np.sign(with_it[i]) * _tangents(ring, np.array([at]))[0])
        if way is None:
            continue
        if with_it[i] > 0:
            rest = between(ring, at, float(behind[back[k]]))
        else:
            rest = between(ring, float(places[i]), float(behind[back[k]]))[::-1]
        rest = shapely.get_coordinates(shapely.segmentize(LineString(rest), CHORD))
        rest = _from_and_to(rest, place, ends[near[i]])
        if fence.covers(LineString(rest)):
            return np.vstack([way, rest[1:]]), int(near[i])
    return None


def back_along_ring(
    start: Floats, ends: Floats, cleared: ClearedMap, fence: Polygon
) -> tuple[Floats, int] | None:
    """Return the shortest way over the slot that the entry cut, and the index of its end.

    None if it leads to no end. The cutter stops and turns where it leaves and where it arrives:
    from the end of an arm hardly wider than itself there is no other way back but to lift.

    Parameters
    ----------
    start : ndarray of shape (2,)
        [mm]
    ends : ndarray of shape (n, 2)
        [mm]
    cleared : ClearedMap
    fence : shapely.Polygon
        Is not left.
    """
    ring = cleared.ring
    if ring is None or shapely.distance(ring, shapely.points(start)) > ON_RING:
        return None
    near = np.flatnonzero(shapely.distance(ring, shapely.points(ends)) <= ON_RING)
    begin = float(shapely.line_locate_point(ring, shapely.points(start)))
    places = shapely.line_locate_point(ring, shapely.points(ends[near]))
    onwards = (places - begin) % ring.length
    lengths = np.minimum(onwards, ring.length - onwards)
    for i in np.argsort(lengths, kind="stable").tolist():
        end = ends[near[i]]
        if lengths[i] < ON_RING:  # straight across, for both are beside one place
            line = LineString([start, end])
        elif onwards[i] < ring.length / 2:
            line = LineString(between(ring, begin, float(onwards[i])))
        else:
            line = LineString(between(ring, float(places[i]), float(lengths[i]))[::-1])
        # the time of a link is told from its points
        way = _from_and_to(shapely.get_coordinates(shapely.segmentize(line, CHORD)), start, end)
        if fence.covers(LineString(way)):
            return way, int(near[i])
    return None


def _tangents(ring: LineString, places: Floats) -> Floats:
    """Return the unit directions of a closed line at places along it [mm], shape (n, 2)."""
    half = ON_RING / 2
    ahead = points_at(ring, (places + half) % ring.length)
    ahead -= points_at(ring, (places - half) % ring.length)
    return np.asarray(ahead / np.maximum(np.hypot(*ahead.T), 1e-12)[:, None])


def _from_and_to(way: Floats, start: Floats, end: Floats) -> Floats:
    """Return a way from a place beside its first point to one beside its last."""
    half = float(distances_along(way)[-1]) / 2
    for place, at_end in ((start, False), (end, True)):
        aside = float(np.hypot(*(place - way[-1 if at_end else 0])))
        way = drawn_to(way, place, min(DRAW * aside, half), at_end=at_end)
    return way
