# SPDX-License-Identifier: LGPL-2.1-or-later
"""From plane paths and levels to moves: entry, passes, lifts, next level.

A room is cut down to its floor before the next one is begun. On the way down
the cutter only lifts to the safe height, between rooms to the clearance height.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .floor import Descent, FloorPath, Pass, WayDown
from .levels import Level
from .model import PocketRequest
from .opening.entry import APPROACH, cut_entry, entry_start
from .rooms import Room
from .toolpath import Role, Toolpath, ToolpathBuilder

#: Arcs keep within this share of the tolerance of what they replace.
ARC_SHARE = 0.4


@dataclass(frozen=True, slots=True, eq=False)
class Cut:
    """One room and the path that clears it.

    Attributes
    ----------
    room : Room
    path : FloorPath
    settings : PocketRequest or None
        By which the path was planned, if not as asked for.
    """

    room: Room
    path: FloorPath
    settings: PocketRequest | None = None


def render(cuts: Sequence[Cut], request: PocketRequest) -> tuple[Toolpath, NDArray[np.int64]]:
    """Return the moves that cut every room, and what each belongs to.

    Parameters
    ----------
    cuts : sequence of Cut
        In cutting order, one at least.
    request : PocketRequest
        For its heights, feeds and helix angle.

    Returns
    -------
    toolpath : Toolpath
    owners : ndarray of shape (n, 2)
        Of each move the number of its cut and of the pass in that; -1 for the way down, and for
        the last lift.
    """
    heights, first = request.heights, cuts[0]
    x, y = entry_start(first.path.entry, _descent(first.room.level, request))
    builder = ToolpathBuilder((x, y, heights.clearance))
    here: Room | None = None
    owners: list[tuple[int, int]] = []
    for number, cut in enumerate(cuts):
        goes_on = here is not None and cut.room.above is here
        lift = heights.safe if goes_on else heights.clearance
        for part in _cut_room(builder, cut, lift, request):
            owners += [(number, part)] * (len(builder) - len(owners))
        here = cut.room
    builder.rapid(request.feeds.vertical_rapid, z=heights.clearance)
    owners += [(len(cuts) - 1, -1)] * (len(builder) - len(owners))
    toolpath, entries = builder.build_with_entries()
    return toolpath, np.array(owners, np.int64).reshape(-1, 2)[entries]


def _cut_room(
    builder: ToolpathBuilder, cut: Cut, lift: float, request: PocketRequest
) -> Iterator[int]:
    """Add one level of one room: over to it at height `lift`, down, and all passes.

    Yields the number of each pass when it has been added, -1 for the way down.
    """
    path, down = cut.path, _descent(cut.room.level, request)
    feeds, safe = request.feeds, request.heights.safe
    builder.rapid(feeds.vertical_rapid, z=lift)
    _go_down(builder, path.entry, down, request)
    yield -1
    for number, part in enumerate(path.passes):
        if not isinstance(part, Pass):
            builder.rapid(feeds.vertical_rapid, z=safe)
            _go_down(builder, part, down, request)
        elif part.role is Role.AIR:
            builder.rapid(feeds.vertical_rapid, z=safe)
            builder.rapid(feeds.horizontal_rapid, *part.points[-1])
            builder.rapid(feeds.vertical_rapid, z=min(down.bottom + APPROACH, safe))
            builder.line((*part.points[-1], down.bottom), feeds.vertical, Role.ENTRY)
        else:
            feed = request.link_feed if part.role is Role.LINK else feeds.horizontal
            slack = ARC_SHARE * request.tolerance
            builder.along(part.points, down.bottom, feed, part.role, slack)
        yield number


def _descent(level: Level, request: PocketRequest) -> Descent:
    return Descent(level.top, level.bottom, request.entry.helix_angle)


def _go_down(
    builder: ToolpathBuilder, entry: WayDown, down: Descent, request: PocketRequest
) -> None:
    """Add the way over to an entry, at the height where the cutter is, and down to the floor.

    Below the safe height rapids go only to where an earlier level was cut: nobody knows how well
    the top of the stock is where it should be.
    """
    feeds, heights = request.feeds, request.heights
    x, y = entry_start(entry, down)
    near = min(down.top + APPROACH, heights.safe)
    builder.rapid(feeds.horizontal_rapid, x, y)
    if down.top < heights.start_depth:
        builder.rapid(feeds.vertical_rapid, z=near)
    else:
        builder.rapid(feeds.vertical_rapid, z=heights.safe)
        builder.line((x, y, near), feeds.vertical, Role.ENTRY)
    cut_entry(builder, entry, down, feeds, ARC_SHARE * request.tolerance)
