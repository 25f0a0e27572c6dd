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

from .coverage import reachable_floor, uncut_floor
from .engagement import Engagement, along_path
from .gouge import gouge_depth
from .model import Floats, Notice, PocketRequest, Report
from .swept import SAME_HEIGHT, Pieces, cut_into_pieces
from .toolpath import Kind, Role, Toolpath

#: A height is a floor if the flat motion there is at least this share of the longest.
FLOOR_SHARE = 0.5
#: Tool circumferences at a floor, after the cutter arrived in solid stock, that are still entry.
ENTRY_TURNS = 1.5
#: Engagement above this multiple of the limit and this much more [rad] is reported.
OVER_FACTOR, OVER_MARGIN = 1.15, np.radians(4.0)
#: Uncut area, over that of the cutter, that is worth a notice.
UNCUT_SHARE = 1e-4


def prove(request: PocketRequest, toolpath: Toolpath) -> Report:
    """Measure a finished toolpath against what was asked.

    Parameters
    ----------
    request : PocketRequest
    toolpath : Toolpath

    Returns
    -------
    Report
    """
    r, heights = request.cutter_radius, request.heights
    stock = request.cutting.stock_to_leave
    top, bottom = heights.start_depth, heights.final_depth + request.cutting.floor_stock
    pieces = cut_into_pieces(toolpath, r, top)
    levels = floors(pieces, bottom)
    engagement = along_path(toolpath, r, axial_depth=min(heights.step_down, top - bottom), top=top)
    judged = ~_is_rapid(toolpath, engagement) & _after_entry(engagement, levels, r)
    steady = _Statistics.of(engagement.angles[judged], engagement.lengths[judged])
    reach = reachable_floor(request.pocket, r, stock)
    uncut = uncut_floor(reach, pieces, bottom, r, request.tolerance)
    gouge, place = gouge_depth(request.pocket, pieces, r + stock)
    too_deep = max(0.0, bottom - float(toolpath.points[:, 2].min(initial=bottom)))
    through = engagement.radial_depths > 2 * request.tolerance
    rapid = _is_rapid(toolpath, engagement)
    link = toolpath.roles[engagement.moves] == Role.LINK
    limit = request.engagement_limit
    chips = chip_loads(toolpath, engagement, request.feeds.horizontal, limit)[judged]
    over = judged & (engagement.angles > OVER_FACTOR * limit + OVER_MARGIN)
    below = np.minimum(toolpath.starts[:, 2], toolpath.points[:, 2]) < top
    fed = toolpath.kinds != Kind.RAPID
    report = Report(
        time=float(np.sum(toolpath.lengths / toolpath.feeds)),
        cut_length=float(toolpath.lengths[below & fed].sum()),
        engagement_limit=limit,
        engagement_max=steady.largest,
        engagement_p99=steady.p99,
        engagement_mean=steady.mean,
        over_limit_share=_share(engagement.lengths, over, judged),
        chip_load_p99=_Statistics.of(chips, engagement.lengths[judged]).p99,
        rapid_hit=float(engagement.lengths[rapid & through].sum()),
        link_hit=float(engagement.lengths[link & through].sum()),
        engagement_points=engagement.points,
        engagement_angles=engagement.angles,
        uncut=uncut,
        gouge=max(gouge, too_deep),
    )
    return report


@dataclass(frozen=True, slots=True)
class _Statistics:
    """Of values weighted by length."""

    largest: float
    p99: float
    mean: float

    @classmethod
    def of(cls, values: Floats, weights: Floats) -> _Statistics:
        if weights.sum() <= 0:
            return cls(0.0, 0.0, 0.0)
        order = np.argsort(values)
        share = np.cumsum(weights[order]) / weights.sum()
        p99 = values[order][min(np.searchsorted(share, 0.99), len(values) - 1)]
        return cls(float(values.max()), float(p99), float(np.average(values, weights=weights)))


def _share(lengths: Floats, part: NDArray[np.bool_], whole: NDArray[np.bool_]) -> float:
    total = float(lengths[whole].sum())
    return float(lengths[part].sum()) / total if total > 0 else 0.0


def _is_rapid(toolpath: Toolpath, engagement: Engagement) -> NDArray[np.bool_]:
    return toolpath.kinds[engagement.moves] == Kind.RAPID


def floors(pieces: Pieces, bottom: float) -> Floats:
    """Return the Z of the floors that the path clears, descending; always with `bottom` [mm]."""
    flat = pieces.is_level & ~pieces.rapid
    z = np.round(pieces.heights[flat] / SAME_HEIGHT) * SAME_HEIGHT
    found, index = np.unique(z, return_inverse=True)
    lengths = np.bincount(index, pieces.lengths[flat], minlength=len(found))
    long = found[lengths >= FLOOR_SHARE * lengths.max(initial=0.0)]
    long = long[np.abs(long - bottom) > SAME_HEIGHT]
    return np.sort(np.r_[long, bottom])[::-1]


def _after_entry(engagement: Engagement, levels: Floats, r: float) -> NDArray[np.bool_]:
    """Return which samples are at a floor and past the entry."""
    z = engagement.points[:, 2]
    chosen = np.zeros(len(z), bool)
    for level in levels:
        here = np.abs(z - level) <= SAME_HEIGHT
        run = np.cumsum(np.where(here, engagement.lengths, 0.0))
        chosen |= here & (run > ENTRY_TURNS * 2 * np.pi * r)
    return chosen


def chip_loads(toolpath: Toolpath, engagement: Engagement, feed: float, limit: float) -> Floats:
    """Return the chip load of each sample over that of a straight cut, shape (k,).

    Feed times the sine of the engagement (a chip is thickest at 90 degrees), over the same of
    `feed` [mm/s] at the engagement `limit` [rad].
    """
    thick = np.sin(np.minimum(engagement.angles, np.pi / 2))
    full = feed * np.sin(min(limit, np.pi / 2))
    return toolpath.feeds[engagement.moves] * thick / full
