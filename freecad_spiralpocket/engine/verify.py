# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof: what a finished toolpath does, measured on its moves alone.

It knows nothing of how the path was made and shares no code with what makes it.
Uncut area, gouge, engagement, chip load, rapids and links through stock, time;
what a machinist should know becomes a notice in the report.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import findings
from .collisions import Hit, hits_along, rapid_plunges
from .coverage import reachable_floor, uncut_floor
from .engagement import Engagement, along_path
from .gouge import gouge_depth
from .model import Floats, PocketRequest, Report
from .swept import SAME_HEIGHT, Pieces, cut_into_pieces
from .toolpath import Kind, Role, Toolpath

#: A height is a floor if the level motion there is at least this share of the longest.
FLOOR_SHARE = 0.5
#: Tool circumferences at a floor, after the cutter arrived in the solid, that are still entry.
ENTRY_TURNS = 1.5
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
    r, heights, stock = request.cutter_radius, request.heights, request.cutting.stock_to_leave
    top, bottom = heights.start_depth, heights.final_depth + request.cutting.floor_stock
    axial_depth = min(heights.step_down, top - bottom)
    pieces = cut_into_pieces(toolpath, r, top, axial_depth)
    if engagement is None:
        engagement = along_path(toolpath, r, axial_depth=axial_depth, top=top)
    fed = toolpath.kinds[engagement.moves] != Kind.RAPID
    judged, descent = _judged(engagement, fed, floors(pieces, bottom), r)
    steady = _Spread.of(engagement.angles, engagement.lengths, judged)
    limit = request.engagement_limit
    over = judged & (engagement.angles > findings.over_limit(limit))
    chips = chip_loads(toolpath, engagement, request.feeds.horizontal, limit)
    reach = reachable_floor(request.pocket, r, stock)
    uncut = uncut_floor(reach, pieces, bottom, r, request.tolerance)
    gouge, place = gouge_depth(request.pocket, pieces, r + stock)
    too_deep = max(0.0, bottom - float(toolpath.points[:, 2].min(initial=bottom)))
    rapid, link = _hits(request, toolpath, engagement, pieces, fed)
    notices = (
        *findings.tell_gouge(gouge, place, request.tolerance),
        *findings.tell_too_deep(too_deep, request.tolerance),
        *findings.tell_hits("rapid", rapid.length, rapid.place),
        *findings.tell_hits("link", link.length, link.place),
        *findings.tell_uncut(uncut, request),
        *findings.tell_engagement(steady.largest, _place(engagement, steady.where), request),
    )
    return Report(
        time=float(np.sum(toolpath.lengths / toolpath.feeds)),
        cut_length=_cut_length(toolpath, top),
        engagement_limit=limit,
        engagement_max=steady.largest,
        engagement_p99=steady.p99,
        engagement_mean=steady.mean,
        over_limit_share=_share(engagement.lengths, over, judged),
        chip_load_p99=_Spread.of(chips, engagement.lengths, judged).p99,
        rapid_hit=rapid.length,
        link_hit=link.length,
        entry_bite=_Spread.of(engagement.bites, engagement.lengths, descent).p99,
        engagement_points=engagement.points[fed],
        engagement_angles=engagement.angles[fed],
        uncut=uncut,
        gouge=max(gouge, too_deep),
        notices=notices,
    )


@dataclass(frozen=True, slots=True)
class _Spread:
    """Of chosen values, weighted by the length of path they stand for."""

    largest: float
    where: int
    p99: float
    mean: float

    @classmethod
    def of(cls, values: Floats, lengths: Floats, chosen: NDArray[np.bool_]) -> _Spread:
        index = np.flatnonzero(chosen & (lengths > 0))
        if len(index) == 0:
            return cls(0.0, -1, 0.0, 0.0)
        index = index[np.argsort(values[index], kind="stable")]
        values, share = values[index], np.cumsum(lengths[index])
        p99 = values[np.searchsorted(share, 0.99 * share[-1])]
        mean = np.average(values, weights=lengths[index])
        return cls(float(values[-1]), int(index[-1]), float(p99), float(mean))


def floors(pieces: Pieces, bottom: float) -> Floats:
    """Return the Z of the floors that the path clears, descending; always with `bottom` [mm]."""
    level = pieces.is_level & ~pieces.rapid
    z = np.round(pieces.heights[level] / SAME_HEIGHT) * SAME_HEIGHT
    found, index = np.unique(z, return_inverse=True)
    lengths = np.bincount(index, pieces.lengths[level], minlength=len(found))
    long = found[lengths >= FLOOR_SHARE * lengths.max(initial=0.0)]
    long = long[np.abs(long - bottom) > SAME_HEIGHT]
    return np.sort(np.r_[long, bottom])[::-1]


def chip_loads(toolpath: Toolpath, engagement: Engagement, feed: float, limit: float) -> Floats:
    """Return the chip load of each sample over that of a straight cut, shape (k,).

    Feed times the sine of the engagement (a chip is thickest at 90 degrees), over the same of
    `feed` [mm/s] at the engagement `limit` [rad].
    """
    thick = np.sin(np.minimum(engagement.angles, np.pi / 2))
    full = feed * np.sin(min(limit, np.pi / 2))
    return toolpath.feeds[engagement.moves] * thick / full


def _judged(
    engagement: Engagement, fed: NDArray[np.bool_], levels: Floats, r: float
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return which samples are at a floor and past the entry, and which are on the way down."""
    gap = np.abs(engagement.points[:, 2][:, None] - levels[None, :]).min(axis=1)
    here = fed & (gap <= SAME_HEIGHT)
    done = np.cumsum(np.where(here, engagement.lengths, 0.0))
    arrivals = np.where(here & engagement.solid_arrivals, done, 0.0)
    since = done - np.maximum.accumulate(arrivals)
    return here & (since > ENTRY_TURNS * 2 * np.pi * r), fed & ~here


def _hits(
    request: PocketRequest,
    toolpath: Toolpath,
    engagement: Engagement,
    pieces: Pieces,
    fed: NDArray[np.bool_],
) -> tuple[Hit, Hit]:
    """Return how far rapids and links run through stock."""
    slack = max(AIR_TOLERANCES * request.tolerance, AIR_SHARE * request.cutter_radius)
    along = hits_along(engagement, ~fed, slack)
    down = rapid_plunges(pieces, request.cutter_radius, slack)
    links = fed & (toolpath.roles[engagement.moves] == Role.LINK)
    rapid = Hit(along.length + down.length, along.place or down.place)
    return rapid, hits_along(engagement, links, slack)


def _cut_length(toolpath: Toolpath, top: float) -> float:
    below = np.minimum(toolpath.starts[:, 2], toolpath.points[:, 2]) < top
    return float(toolpath.lengths[below & (toolpath.kinds != Kind.RAPID)].sum())


def _share(lengths: Floats, part: NDArray[np.bool_], whole: NDArray[np.bool_]) -> float:
    total = float(lengths[whole].sum())
    return float(lengths[part].sum()) / total if total > 0 else 0.0


def _place(engagement: Engagement, index: int) -> tuple[float, float] | None:
    if index < 0:
        return None
    x, y = engagement.points[index, :2]
    return float(x), float(y)
