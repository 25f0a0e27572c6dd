# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets, laps and paths of Isotherm for several test modules."""

from __future__ import annotations

import numpy as np
from shapely import MultiPoint, MultiPolygon, Point, Polygon, box
from shapes import no_tick
from shapes import request as make_request

from freecad_spiralpocket.engine.heat.family import family_of
from freecad_spiralpocket.engine.laps import isotherm
from freecad_spiralpocket.engine.shapes.region import center_regions

STEP = 2.4
#: Two lobes of one size with a wide waist: two summits and a saddle.
TWO_LOBES = Point(-26, 0).buffer(24).union(Point(26, 0).buffer(24)).union(box(-26, -14, 26, 14))
ROUND_RING = Point(0, 0).buffer(40, quad_segs=64).difference(Point(0, 0).buffer(14, quad_segs=64))
TWO_ISLANDS = box(0, 0, 90, 60).difference(Point(25, 30).buffer(8)).difference(box(55, 20, 70, 38))
FOUR_POSTS = box(0, 0, 120, 80).difference(
    MultiPoint([(30, 25), (90, 25), (30, 55), (90, 55)]).buffer(8.0)
)
#: Between posts laps close about islands that are far from most of the laps inside.
SIX_POSTS = box(0, 0, 100, 67).difference(
    MultiPoint([(20 + 30 * i, 20 + 27 * k) for i in range(3) for k in range(2)]).buffer(5.0)
)


def laps_of(pocket: Polygon, deviation: float | None = None):
    region = center_regions(pocket, 3.0, 0.0)[0]
    family = family_of(region, make_request(pocket), 3.0, deviation)
    return family, isotherm.laps_of(family, no_tick)


def path_of(pocket: Polygon, **changes):
    region = center_regions(pocket, 3.0, 0.0)[0]
    return region, isotherm.floor_path(region, make_request(pocket, **changes), no_tick)


def pairs(lap):
    """Yield each lap with the laps inside of it."""
    yield lap, lap.inner
    for inner in lap.inner:
        yield from pairs(inner)


#: Channels hardly wider than the cutter.
FINS = box(0, 0, 70, 35.4).difference(MultiPolygon([box(7, y, 63, y + 6) for y in (8, 20.7)]))


def arc(x: float, y: float, radius: float, start: float, end: float) -> list[tuple[float, float]]:
    """Return points of a counter-clockwise arc."""
    angles = np.linspace(start, end, 40)
    return list(zip(x + radius * np.cos(angles), y + radius * np.sin(angles), strict=True))


def turning(points: np.ndarray) -> np.ndarray:
    """Return how far a path turns at each of its inner points [deg]."""
    steps = np.diff(points, axis=0)
    heading = np.arctan2(*steps[np.hypot(*steps.T) > 1e-6].T[::-1])
    return np.degrees(np.abs((np.diff(heading) + np.pi) % (2 * np.pi) - np.pi))
