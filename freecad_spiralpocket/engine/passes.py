# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps as passes: what is cut, and the links or lifts before it, in as few points as do."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

import shapely
from shapely import LineString
from shapely.ops import substring

from .floor import FloorPath, Pass
from .model import Floats, PocketRequest
from .ordering import Step
from .polyline import simplified
from .toolpath import Role

#: Points that matter less than this share of the tolerance are dropped.
SLIM = 0.3


def slim(points: Floats, request: PocketRequest) -> Floats:
    """Return a path without the points that matter little, shape (n, 2) [mm]."""
    return simplified(points, SLIM * request.tolerance)


def passes_of(steps: Sequence[Step], request: PocketRequest) -> tuple[Pass, ...]:
    """Return the passes of runs, with the links or lifts between them."""
    passes = []
    for step in steps:
        if step.link is None:
            passes.append(Pass(step.points[:1], Role.AIR))
        elif len(step.link):
            passes.append(Pass(slim(step.link, request), Role.LINK))
        passes.append(Pass(slim(step.points, request), Role.CUT))
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
