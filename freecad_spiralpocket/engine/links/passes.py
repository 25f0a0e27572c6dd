# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps as passes: what is cut, and the links or lifts before it, in as few points as do."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import shapely
from shapely import LineString, Polygon
from shapely.ops import substring

from ..floor import FloorPath, Pass
from ..model import Floats, PocketRequest
from ..shapes.points import cross
from ..shapes.polyline import simplified
from ..shapes.shaping import drawn_inside
from ..toolpath import Role
from .ordering import Step

#: Points that matter less than this share of the tolerance are dropped.
SLIM = 0.3
#: What is cut may leave the region by this share of the tolerance: between two laps that both run
#: along a wall's bend the way across is a chord of it.
ASIDE = 0.3
#: A short step at whose ends the path turns by more than this together is a step aside [rad].
JOG = np.radians(90.0)


def slim(points: Floats, request: PocketRequest) -> Floats:
    """Return a path without the points that matter little, shape (n, 2) [mm]."""
    within = SLIM * request.tolerance
    return _without_jogs(simplified(points, within), within)


def _without_jogs(points: Floats, within: float) -> Floats:
    """Return a path whose steps aside and back are their middles, where that is `within` [mm].

    Where regions are joined steps of a few micrometers stay, at which the cutter would stop.
    """
    steps = np.diff(points, axis=0)
    lengths = np.hypot(*steps.T)
    turns = np.abs(np.arctan2(cross(steps[:-1], steps[1:]), (steps[:-1] * steps[1:]).sum(axis=1)))
    # first and last point stay
    short = 1 + np.flatnonzero((lengths[1:-1] < 2 * within) & (turns[:-1] + turns[1:] > JOG))
    short = short[np.diff(short, prepend=-1) > 1]
    points = points.copy()
    points[short] = (points[short] + points[short + 1]) / 2
    return np.delete(points, short + 1, axis=0)


def passes_of(steps: Sequence[Step], region: Polygon, request: PocketRequest) -> tuple[Pass, ...]:
    """Return the passes of runs inside a region, with the links or lifts between them."""
    passes, aside = [], ASIDE * request.tolerance
    for step in steps:
        if step.link is None:
            passes.append(Pass(step.points[:1], Role.AIR))
        elif len(step.link):
            passes.append(Pass(slim(step.link, request), Role.LINK))
        inside = drawn_inside(step.points, region, aside)
        passes.append(Pass(slim(inside, request), Role.CUT))
    return tuple(passes)


def with_leads(path: FloorPath, parts: Iterable[int], length: float) -> FloorPath:
    """Return a path whose given links are cuts over `length` [mm] at both ends."""
    chosen, passes = set(parts), []
    for number, part in enumerate(path.passes):
        if number not in chosen or not isinstance(part, Pass):
            passes.append(part)
            continue
        line = LineString(part.points)
        if line.length <= 2 * length:
            passes.append(replace(part, role=Role.CUT))
            continue
        bounds = (0.0, length, line.length - length, line.length)
        roles = (Role.CUT, Role.LINK, Role.CUT)
        for (begin, end), role in zip(pairwise(bounds), roles, strict=True):
            passes.append(Pass(shapely.get_coordinates(substring(line, begin, end)), role))
    return replace(path, passes=tuple(passes))
