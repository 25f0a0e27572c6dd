# SPDX-License-Identifier: LGPL-2.1-or-later
"""Axial levels: the floors at which the pocket is cleared, from the top down.

As FreeCAD's own operations do it: full steps down from the start depth, what
is left as the last one, and, where a finish depth is set, one thin level at
the very end. A flat ledge in the wall, or the top of a low island, is a floor too:
the steps end on it and begin anew below. This is the one place that decides the
levels; what the walls leave free at each of them, and what stands there, comes with the request.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from shapely import MultiPolygon, Polygon

from .model import Heights, PocketRequest

#: A remainder thinner than this is no level of its own [mm].
THIN = 1e-6


@dataclass(frozen=True, slots=True)
class Level:
    """One layer of the pocket, cleared at its bottom.

    Attributes
    ----------
    top, bottom : float
        Z [mm].
    pocket : shapely.Polygon
        Free for the cutter at the bottom.
    mouth : shapely.Polygon
        Free at the top.
    stock : shapely.Polygon or MultiPolygon or None
        Where material stands before the first move; None: everywhere.
    """

    top: float
    bottom: float
    pocket: Polygon
    mouth: Polygon
    stock: Polygon | MultiPolygon | None = None


def levels_of(request: PocketRequest) -> list[Level]:
    """Return the levels of a request, highest first."""
    if request.sections:
        bottoms = [s.z for s in request.sections]
        shapes = [
            (s.pocket, s.mouth or s.pocket, request.stock if s.stock is None else s.stock)
            for s in request.sections
        ]
    else:
        bottoms = floors(request.heights, request.cutting.floor_stock)
        shapes = [(request.pocket, request.pocket, request.stock)] * len(bottoms)
    heights = pairwise([request.heights.start_depth, *bottoms])
    return [
        Level(top, bottom, *shape) for (top, bottom), shape in zip(heights, shapes, strict=True)
    ]


def at_level(request: PocketRequest, level: Level) -> PocketRequest:
    """Return the request for one of the levels alone, the same where all have the same stock."""
    if level.stock is request.stock:
        return request
    return replace(request, pocket=level.pocket, stock=level.stock, sections=())


def floors(heights: Heights, floor_stock: float = 0.0, ledges: Sequence[float] = ()) -> list[float]:
    """Return the levels' Z [mm], highest first; the last is ``final_depth + floor_stock``.

    Parameters
    ----------
    heights : Heights
    floor_stock : float
        Stock to leave on the floor [mm].
    ledges : sequence of float
        Z at which a level has to end [mm]; those outside of the pocket's depth do not count.
    """
    top, bottom = heights.start_depth, heights.final_depth + floor_stock
    rough = bottom + heights.finish_depth
    stops = [z for z in ledges if bottom + THIN < z < top - THIN]
    if rough < top - THIN:
        stops.append(rough)
    if heights.finish_depth > THIN:
        stops.append(bottom)
    levels: list[float] = []
    for stop in sorted(set(stops), reverse=True):
        count = math.ceil((top - stop) / heights.step_down - THIN)
        levels += [top - heights.step_down * i for i in range(1, count)]
        levels.append(stop)
        top = stop
    return levels
