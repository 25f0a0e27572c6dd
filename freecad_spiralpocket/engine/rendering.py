# SPDX-License-Identifier: LGPL-2.1-or-later
"""From plane paths and levels to moves: entry, spiral, closing lap, lift, next level.

A room is cut down to its floor before the next one is begun. Between levels
of a room the cutter only lifts to the safe height, between rooms to the
clearance height.
"""

from __future__ import annotations

from collections.abc import Sequence

from .entry import APPROACH, cut_helix, helix_start
from .model import FloorPath, PocketRequest
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
    heights, angle = request.heights, request.entry.helix_angle
    tops = [heights.start_depth, *levels[:-1]]
    begin = [min(top + APPROACH, heights.safe) for top in tops]
    x, y = helix_start(paths[0].entry, angle, begin[0], levels[0])
    builder = ToolpathBuilder((x, y, heights.clearance))
    for path in paths:
        lift = heights.clearance
        for top, bottom in zip(begin, levels, strict=True):
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
    """Add one level of one region: over to it at height `lift`, down, and all round."""
    feeds, angle = request.feeds, request.entry.helix_angle
    x, y = helix_start(path.entry, angle, top, bottom)
    builder.rapid(feeds.vertical_rapid, z=lift)
    builder.rapid(feeds.horizontal_rapid, x, y)
    builder.rapid(feeds.vertical_rapid, z=top)
    cut_helix(builder, path.entry, angle, bottom, feeds)
    builder.polyline(path.spiral, bottom, feeds.horizontal, Role.CUT)
    builder.polyline(path.closing_lap, bottom, feeds.horizontal, Role.FINISH)
    builder.polyline(path.leave, bottom, feeds.horizontal, Role.LINK)
