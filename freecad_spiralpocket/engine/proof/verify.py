# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof: what a finished toolpath does, measured on its moves alone.

Uncut area, gouge, engagement, rapids and links through stock, time;
what a machinist should know becomes a notice in the report.

It knows nothing of how the path was made: no fronts, laps or links. What was asked for
it takes from where the planner takes it, and would not see an error there: the outline,
the sections of slanted walls, the levels, and which channels are too narrow to enter
(`region.without_hairs`). The engagement is the one that the feeds were set by. Beyond
that only small helpers for shapes and points are shared.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import MultiPolygon, Polygon

from ..contact.air import Stock
from ..contact.engagement import Engagement, engagement_of
from ..contact.swept import SAME_HEIGHT, Pieces, cut_into_pieces
from ..levels import Level, at_level, levels_of
from ..machine import machine_of
from ..model import PocketRequest, Report
from ..motion.timing import time_of
from ..numerics.distinct import are_among
from ..shapes.region import polygons_of
from ..toolpath import Kind, Role, Toolpath
from . import findings
from .collisions import Hit, hits_along, plunges
from .coverage import reachable_floor, uncut_floor
from .gouge import gouge_depth
from .loads import measure_load
from .wall_steps import largest_step, notches

#: Narrower steps on slanted walls are not told [mm].
TOLD_STEP = 0.05
#: Air moves may skim this many tolerances of stock (that much a path may leave on both sides)
#: or this share of the radius, which no cutter feels.
AIR_TOLERANCES, AIR_SHARE = 2.0, 0.02
#: No ground.
NOTHING = Polygon()


def prove(
    request: PocketRequest,
    toolpath: Toolpath,
    engagement: Engagement | None = None,
    missed: shapely.Geometry = NOTHING,
) -> Report:
    """Measure a finished toolpath against what was asked.

    Parameters
    ----------
    request : PocketRequest
    toolpath : Toolpath
    engagement : Engagement, optional
        Along this toolpath, where it is known already.
    missed : shapely.Geometry, optional
        Ground of which it is told elsewhere that it stays uncut.

    Returns
    -------
    Report
        Engagement points and angles are those of feed moves.
    """
    r, top = request.cutter_radius, request.heights.start_depth
    pieces = cut_into_pieces(toolpath, r, top, request.axial_depth)
    if engagement is None:
        engagement = engagement_of(toolpath, request)
    load = measure_load(request, toolpath, engagement, pieces)
    levels = levels_of(request)
    uncut = _uncut(request, levels, pieces)
    gouge, place = _gouge(levels, pieces, r + request.cutting.stock_to_leave)
    inset = request.cutter_radius + request.cutting.stock_to_leave
    step = largest_step(levels, TOLD_STEP, inset)
    too_deep, deepest = _too_deep(toolpath, request.floor)
    rapid, link = _hits(request, toolpath, engagement, pieces, Stock.at_levels(levels))
    fed = toolpath.kinds[engagement.moves] != Kind.RAPID
    return Report(
        time=time_of(toolpath, machine_of(request)).total,
        cut_length=_cut_length(toolpath, top),
        engagement_limit=request.engagement_limit,
        engagement_max=load.largest,
        engagement_p99=load.p99,
        engagement_mean=load.mean,
        over_limit_share=load.over_share,
        rapid_hit=rapid.length,
        link_hit=link.length,
        entry_bite=load.bite,
        engagement_points=engagement.points[fed],
        engagement_angles=engagement.angles[fed],
        engagement_moves=engagement.moves[fed],
        uncut=uncut,
        gouge=max(gouge, too_deep),
        gouge_place=deepest if too_deep > gouge else place,
        hit_moves=rapid.moves | link.moves,
        step_width=step.width,
        step_height=step.height,
        notices=(
            *findings.tell_gouge(gouge, place, request),
            *findings.tell_too_deep(too_deep, request),
            *findings.tell_hits("rapid", rapid.length, rapid.place),
            *findings.tell_hits("link", link.length, link.place),
            *findings.tell_uncut(uncut, missed, request),
            *findings.tell_steps(step),
            *findings.tell_notches(notches(levels, inset), request.tool_diameter),
            *findings.tell_engagement(
                load.largest, load.place, load.over_share, load.is_slowed, request
            ),
        ),
    )


def _gouge(
    levels: Sequence[Level], pieces: Pieces, clearance: float
) -> tuple[float, tuple[float, float] | None]:
    """Return how far the cutter passes the wall, at each level by the level's own wall."""
    bottoms = np.array([level.bottom for level in levels])
    lowest = pieces.bottoms.min(axis=1)
    layer = (bottoms[None, :] > lowest[:, None] + SAME_HEIGHT).sum(axis=1)
    layer = np.minimum(layer, len(levels) - 1)
    found = [
        gouge_depth(pocket, pieces.select(are_among(layer, np.asarray(members))), clearance)
        for pocket, members in _alike(levels)
    ]
    return max(found, key=lambda each: each[0])


def _uncut(request: PocketRequest, levels: Sequence[Level], pieces: Pieces) -> MultiPolygon:
    """Return what the cutter could reach and left standing at any level.

    What is cut at one level is cut above it too: of levels alike the lowest tells. The motion at
    a level nearly always clears it; what is deeper is looked at only where it does not.
    """
    r, left = request.cutter_radius, []
    for pocket, members in _alike(levels):
        bottom = levels[members[-1]].bottom
        reach = reachable_floor(pocket, r, request.cutting.stock_to_leave)
        reach = at_level(request, levels[members[-1]]).to_clear(reach)
        here = pieces.select(pieces.heights >= bottom - SAME_HEIGHT)
        standing = uncut_floor(reach, here, bottom, r, request.tolerance)
        if not standing.is_empty and len(here) < len(pieces):
            standing = uncut_floor(reach, pieces, bottom, r, request.tolerance)
        left.append(standing)
    if len(left) == 1:
        return left[0]
    return MultiPolygon(polygons_of(shapely.union_all(left)))


def _too_deep(toolpath: Toolpath, floor: float) -> tuple[float, tuple[float, float] | None]:
    """Return how far a path goes below the floor [mm], and where it does most."""
    heights = toolpath.points[:, 2]
    depth = max(0.0, floor - float(heights.min(initial=floor)))
    if depth == 0.0:
        return 0.0, None
    x, y, _ = toolpath.points[int(np.argmin(heights))].tolist()
    return depth, (x, y)


def _alike(levels: Sequence[Level]) -> list[tuple[Polygon, list[int]]]:
    """Return outlines, and the numbers of the levels one after the other that have each.

    And the same stock.
    """
    found: list[tuple[Polygon, list[int]]] = []
    above: Level | None = None
    for number, level in enumerate(levels):
        if above is None or above.pocket != level.pocket or above.stock is not level.stock:
            found.append((level.pocket, []))
        found[-1][1].append(number)
        above = level
    return found


def _hits(
    request: PocketRequest,
    toolpath: Toolpath,
    engagement: Engagement,
    pieces: Pieces,
    stock: Stock,
) -> tuple[Hit, Hit]:
    """Return how far rapids run through stock, and links, with all that is fed straight down."""
    fed = toolpath.kinds[engagement.moves] != Kind.RAPID
    slack = max(AIR_TOLERANCES * request.tolerance, AIR_SHARE * request.cutter_radius)
    links = fed & (toolpath.roles[engagement.moves] == Role.LINK)
    found = []
    for along, down in ((~fed, pieces.rapid), (links, ~pieces.rapid)):
        hits = hits_along(engagement, along, slack)
        into = plunges(pieces, down, request.cutter_radius, slack, stock)
        length, moves = hits.length + into.length, hits.moves | into.moves
        found.append(Hit(length, hits.place or into.place, moves))
    return found[0], found[1]


def _cut_length(toolpath: Toolpath, top: float) -> float:
    """Return the length of all feed moves that go below the top [mm]."""
    below = np.minimum(toolpath.starts[:, 2], toolpath.points[:, 2]) < top
    return float(toolpath.lengths[below & (toolpath.kinds != Kind.RAPID)].sum())
