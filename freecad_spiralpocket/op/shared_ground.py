# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ground that several pockets of one operation share: it is cut once.

Above ribs lower than the rim the pockets between them are one, and above a ledge that is selected
itself so are its pocket and the one in it. The first of them cuts that; the others begin where
nothing is cleared yet. So of pockets one above the other the upper one goes first.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import shapely
from shapely import Polygon

from ..engine.checks import MOST_LEVELS, NESTED
from ..engine.levels import THIN, levels_of
from ..engine.model import PocketRequest

#: Pockets that share less are beside each other [mm2].
LEAST = 1e-3


def order(wanted: Sequence[PocketRequest]) -> list[int]:
    """Return in which order pockets are cut, by their numbers.

    Those that share ground from the top down, in their places among the others.
    """
    if len(wanted) < 2:
        return list(range(len(wanted)))
    tops = [_top(request) for request in wanted]
    groups = {i: [i] for i in range(len(wanted))}
    for i, j in shapely.STRtree(tops).query(tops, predicate="intersects").T.tolist():
        is_new = groups[i] is not groups[j]
        if is_new and shapely.intersection(tops[i], tops[j]).area > LEAST:
            groups[i] += groups[j]
            groups |= dict.fromkeys(groups[j], groups[i])
    found = list(range(len(wanted)))
    for first, group in groups.items():
        places = sorted(group)
        if first == places[0]:
            highest = sorted(places, key=lambda i: -wanted[i].floor)
            for place, number in zip(places, highest, strict=True):
                found[place] = number
    return found


def lowered(wanted: Sequence[PocketRequest], failed: Collection[int] = ()) -> list[PocketRequest]:
    """Return requests that begin where those before them have cleared the ground.

    Parameters
    ----------
    wanted : sequence of PocketRequest
        In the order in which they are cut.
    failed : collection of int
        The numbers of those that are not cut, or not wholly.
    """
    found: list[PocketRequest] = []
    cleared: list[tuple[float, Polygon]] = []
    for number, request in enumerate(wanted):
        if not _has_levels(request):
            found.append(request)
            continue
        found.append(_from(_cleared_to(request, cleared), request))
        # what is beyond open sides may be cut, but need not
        if number not in failed and request.beyond is None:
            cleared += _widened(request)
    return found


def _has_levels(request: PocketRequest) -> bool:
    """Return whether the heights of a request make sense; what does not the engine refuses."""
    heights = request.heights
    step, depth = heights.step_down, heights.start_depth - request.floor
    return math.isfinite(step) and step > 0 and 0 < depth <= MOST_LEVELS * step


def _top(request: PocketRequest) -> Polygon:
    """Return the ground of a pocket at its uppermost level."""
    return request.sections[0].pocket if request.sections else request.pocket


def _widened(request: PocketRequest) -> Iterator[tuple[float, Polygon]]:
    """Yield down to which Z which ground is cleared, and a hair around it; each once."""
    levels = levels_of(request)
    for level, below in zip(levels, [*levels[1:], None], strict=True):
        if below is None or below.pocket is not level.pocket:
            wide = shapely.buffer(level.pocket, NESTED / 2)
            shapely.prepare(wide)
            yield level.bottom, wide


def _cleared_to(request: PocketRequest, cleared: Sequence[tuple[float, Polygon]]) -> float:
    """Return down to which Z a pocket is cleared before it is cut."""
    start = request.heights.start_depth
    for level in levels_of(request):
        deepest = min((z for z, ground in cleared if ground.covers(level.pocket)), default=start)
        if deepest >= start - THIN:
            return start
        start = max(level.bottom, deepest)
        if start > level.bottom + THIN:
            return start
    return start


def _from(start: float, request: PocketRequest) -> PocketRequest:
    """Return a request that begins at a Z; the same if that is where it begins, or its floor."""
    if start >= request.heights.start_depth - THIN or start <= request.floor + THIN:
        return request
    sections = tuple(section for section in request.sections if section.z < start - THIN)
    return replace(request, heights=replace(request.heights, start_depth=start), sections=sections)
