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
from shapely import LineString

from .model import Floats
from .strokes import CHORD, Stroke

#: Length of the zone over which a lap becomes the next, over R: the way across adds its angle to
#: the engagement.
BLEND = 7.0
#: Share of the zone over which that angle builds up, and dies away.
EASE = 0.2


def closed_line(points: Floats) -> LineString:
    """Return a closed lap as a line whose last point is its first."""
    return LineString(np.vstack([points, points[:1]]))


def eased(u: Floats) -> Floats:
    """Return a rise from 0 to 1 whose slope builds up and dies away evenly, flat between."""
    top = 1 / (1 - EASE)
    rise = top * u * u / (2 * EASE)
    fall = 1 - top * (1 - u) ** 2 / (2 * EASE)
    return np.where(u < EASE, rise, np.where(u > 1 - EASE, fall, top * (u - EASE / 2)))


def between(line: LineString, start: float, length: float) -> Floats:
    """Return the points of a closed line from `start` on over `length` [mm], ends included."""
    coords = shapely.get_coordinates(line)
    total = line.length
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(coords, axis=0).T))])
    total = float(along[-1])
    turns = np.arange(-1, int(np.ceil(length / total)) + 2)
    s = (along[:-1][None, :] + total * turns[:, None]).ravel()
    points = np.tile(coords[:-1], (len(turns), 1))
    start %= total
    inner = (s > start + 1e-6) & (s < start + length - 1e-6)

    def at(where: float) -> Floats:
        return np.array([np.interp(where % total, along, coords[:, i]) for i in (0, 1)])

    return np.vstack([at(start), points[inner], at(start + length)])


def blend(lap: LineString, start: float, target: LineString, length: float) -> Floats:
    """Return the way from `lap` at `start` onto `target`, over `length` [mm]."""
    count = max(4, int(np.ceil(length / CHORD)))
    u = np.linspace(0.0, 1.0, count + 1)
    source = shapely.line_interpolate_point(lap, (start + u * length) % lap.length)
    onto = shapely.line_interpolate_point(target, shapely.line_locate_point(target, source))
    s = eased(u)[:, None]
    return (1 - s) * shapely.get_coordinates(source) + s * shapely.get_coordinates(onto)


def spiral_through(first: LineString, start: float, laps: Sequence[LineString], radius: float) -> Floats:
    """Return the spiral from `first`, which is already cut, through `laps`.

    Parameters
    ----------
    first : LineString
        Closed; left at `start` [mm] along it.
    laps : sequence of LineString
        Closed, each outside of the one before, in the same direction.
    radius : float
        R [mm].

    Returns
    -------
    ndarray of shape (n, 2)
    """
    pieces = []
    here, at = first, start
    for i, lap in enumerate(laps):
        length = min(BLEND * radius, 0.4 * here.length, 0.4 * lap.length)
        way = blend(here, at, lap, length)
        pieces.append(way)
        landed = lap.project(shapely.Point(way[-1]))
        # the next blend begins beside the place where this one began
        leave = lap.project(shapely.Point(way[0]))
        run = (leave - landed) % lap.length
        if i == len(laps) - 1:
            run += (landed - leave) % lap.length  # through the zone once more
        pieces.append(between(lap, landed, run)[1:])
        here, at = lap, (landed + run) % lap.length
    return np.vstack(pieces)


def chains_of(strokes: Sequence[Stroke], n_levels: int) -> list[list[int]]:
    """Return runs of closed outer laps at successive levels, as indices of strokes.

    The visited region is one piece, so that each level has one outer boundary: a closed outer
    lap follows the one of the level before.
    """
    outer = {s.level: i for i, s in enumerate(strokes) if s.closed and s.exterior}
    chains: list[list[int]] = []
    for level in range(1, n_levels):
        if level not in outer:
            continue
        if level - 1 in outer and chains:
            chains[-1].append(outer[level])
        else:
            chains.append([outer[level]])
    return chains
