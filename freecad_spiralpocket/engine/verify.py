# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof: what a finished toolpath does, measured on its moves alone.

It knows nothing of how the path was made and shares no code with what makes it.
Uncut area, gouge, engagement, chip load, rapids and links through stock, time;
what a machinist should know becomes a notice in the report.
"""

from __future__ import annotations

import numpy as np

from . import findings
from .collisions import Hit, hits_along, rapid_plunges
from .coverage import reachable_floor, uncut_floor
from .engagement import Engagement, along_path
from .gouge import gouge_depth
from .loads import measure_load
from .model import PocketRequest, Report
from .swept import Pieces, cut_into_pieces
from .toolpath import Kind, Role, Toolpath

#: Air moves may skim this many tolerances of stock (that much a path may leave on both sides)
#: or this share of the radius, which no cutter feels.
AIR_TOLERANCES, AIR_SHARE = 2.0, 0.02


def prove(
    request: PocketRequest, toolpath: Toolpath, engagement: Engagement | None = None
) -> Report:
    """Measure a finished toolpath against what was asked.

    Parameters
    ----------
    request : PocketRequest
    toolpath : Toolpath
    engagement : Engagement, optional
        Along this toolpath, where it is known already.

    Returns
    -------
    Report
        Engagement points and angles are those of feed moves.
    """
    r, stock = request.cutter_radius, request.cutting.stock_to_leave
    top, bottom = request.heights.start_depth, request.floor
    pieces = cut_into_pieces(toolpath, r, top, request.axial_depth)
    if engagement is None:
        engagement = along_path(toolpath, r, axial_depth=request.axial_depth, top=top)
    load = measure_load(request, toolpath, engagement, pieces)
    reach = reachable_floor(request.pocket, r, stock)
    uncut = uncut_floor(reach, pieces, bottom, r, request.tolerance)
    gouge, place = gouge_depth(request.pocket, pieces, r + stock)
    too_deep = max(0.0, bottom - float(toolpath.points[:, 2].min(initial=bottom)))
    rapid, link = _hits(request, toolpath, engagement, pieces)
    fed = toolpath.kinds[engagement.moves] != Kind.RAPID
    return Report(
        time=float(np.sum(toolpath.lengths / toolpath.feeds)),
        cut_length=_cut_length(toolpath, top),
        engagement_limit=request.engagement_limit,
        engagement_max=load.largest,
        engagement_p99=load.p99,
        engagement_mean=load.mean,
        over_limit_share=load.over_share,
        chip_load_p99=load.chip_p99,
        rapid_hit=rapid.length,
        link_hit=link.length,
        entry_bite=load.bite,
        engagement_points=engagement.points[fed],
        engagement_angles=engagement.angles[fed],
        engagement_moves=engagement.moves[fed],
        uncut=uncut,
        gouge=max(gouge, too_deep),
        notices=(
            *findings.tell_gouge(gouge, place, request.tolerance),
            *findings.tell_too_deep(too_deep, request.tolerance),
            *findings.tell_hits("rapid", rapid.length, rapid.place),
            *findings.tell_hits("link", link.length, link.place),
            *findings.tell_uncut(uncut, request),
            *findings.tell_engagement(load.largest, load.place, request),
        ),
    )


def _hits(
    request: PocketRequest,
    toolpath: Toolpath,
    engagement: Engagement,
    pieces: Pieces,
) -> tuple[Hit, Hit]:
    """Return how far rapids and links run through stock."""
    fed = toolpath.kinds[engagement.moves] != Kind.RAPID
    slack = max(AIR_TOLERANCES * request.tolerance, AIR_SHARE * request.cutter_radius)
    along = hits_along(engagement, ~fed, slack)
    down = rapid_plunges(pieces, request.cutter_radius, slack)
    links = fed & (toolpath.roles[engagement.moves] == Role.LINK)
    rapid = Hit(along.length + down.length, along.place or down.place)
    return rapid, hits_along(engagement, links, slack)


def _cut_length(toolpath: Toolpath, top: float) -> float:
    """Return the length of all feed moves that go below the top [mm]."""
    below = np.minimum(toolpath.starts[:, 2], toolpath.points[:, 2]) < top
    return float(toolpath.lengths[below & (toolpath.kinds != Kind.RAPID)].sum())
