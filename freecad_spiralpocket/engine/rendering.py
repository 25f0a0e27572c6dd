# SPDX-License-Identifier: LGPL-2.1-or-later
"""From plane paths and levels to moves: entry, passes, lifts, next level.

A room is cut down to its floor before the next one is begun. Between levels
of a room the cutter only lifts to the safe height, between rooms to the
clearance height.
"""

from __future__ import annotations

from collections.abc import Sequence

from .entry import APPROACH, cut_entry, entry_start
from .floor import FloorPath, Helix, Pass, Slot
from .model import PocketRequest
from .toolpath import Role, Toolpath, ToolpathBuilder


def render(paths: Sequence[FloorPath], levels: Sequence[float], request: PocketRequest) -> Toolpath:
    """Return the moves that cut every path at every level.

    Parameters
    ----------
    paths : sequence of FloorPath
        One per cutter-center region.
    levels : sequence of float
        Z of the floors, highest first [mm].
    request : PocketRequest
        For its heights, feeds and helix angle.
    """
    heights = request.heights
    tops = [heights.start_depth, *levels[:-1]]
    x, y = entry_start(paths[0].entry, request.entry.helix_angle, tops[0], levels[0])
    builder = ToolpathBuilder((x, y, heights.clearance))
    for path in paths:
        lift = heights.clearance
        for top, bottom in zip(tops, levels, strict=True):
            _cut_level(builder, path, top, bottom, lift, request)
            lift = heights.safe
        builder.rapid(request.feeds.vertical_rapid, z=heights.clearance)
    return builder.build()


def _cut_level(
    builder: ToolpathBuilder,
    path: FloorPath,
    top: float,
    bottom: float,
    lift: float,
    request: PocketRequest,
) -> None:
    """Add one level of one region: over to it at height `lift`, down, and all passes."""
    feeds, safe = request.feeds, request.heights.safe
    builder.rapid(feeds.vertical_rapid, z=lift)
    _go_down(builder, path.entry, top, bottom, request)
    for part in path.passes:
        if not isinstance(part, Pass):
            builder.rapid(feeds.vertical_rapid, z=safe)
            _go_down(builder, part, top, bottom, request)
        elif part.role is Role.AIR:
            builder.rapid(feeds.vertical_rapid, z=safe)
            builder.rapid(feeds.horizontal_rapid, *part.points[-1])
            builder.rapid(feeds.vertical_rapid, z=min(bottom + APPROACH, safe))
            builder.line((*part.points[-1], bottom), feeds.vertical, Role.LINK)
        else:
            feed = request.link_feed if part.role is Role.LINK else feeds.horizontal
            builder.polyline(part.points, bottom, feed, part.role)


def _go_down(
    builder: ToolpathBuilder, entry: Helix | Slot, top: float, bottom: float, request: PocketRequest
) -> None:
    """Add the way over to an entry, at the height where the cutter is, and down into the stock."""
    feeds, angle = request.feeds, request.entry.helix_angle
    builder.rapid(feeds.horizontal_rapid, *entry_start(entry, angle, top, bottom))
    builder.rapid(feeds.vertical_rapid, z=min(top + APPROACH, request.heights.safe))
    cut_entry(builder, entry, angle, top, bottom, feeds)
