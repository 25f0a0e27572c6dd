# SPDX-License-Identifier: LGPL-2.1-or-later
"""How hard a path loads the cutter: engagement at the floors, bite on the way down.

Figures are weighted by length. Links do not count, nor does the end of the way down and
what comes right after the cutter has arrived in the solid: there a slot cannot be avoided.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..contact.engagement import Engagement
from ..contact.swept import SAME_HEIGHT, Pieces
from ..model import Floats, PocketRequest
from ..motion.analysis import weighted_quantiles
from ..stepover import over_limit
from ..toolpath import Kind, Role, Toolpath

#: A height is a floor if the level motion there is at least this share of the longest.
FLOOR_SHARE = 0.5
#: A feed is told as lowered from this share of the programmed one on.
SLOWED = 0.99
#: Tool circumferences at a floor, after the cutter arrived in the solid, that may still be entry.
ENTRY_TURNS = 1.5


@dataclass(frozen=True, slots=True)
class Load:
    """What the cutter has to bear.

    Attributes
    ----------
    largest, p99, mean : float
        Engagement angle at the floors after the entry [rad].
    place : tuple of float or None
        Where it is largest, (x, y) [mm].
    is_slowed : bool
        Whether the feed is lowered there.
    over_share : float
        Share of the length there that clearly passes the limit.
    bite : float
        Height straight ahead on the way down, not passed over 99 % of its length [mm].
    """

    largest: float
    p99: float
    mean: float
    place: tuple[float, float] | None
    is_slowed: bool
    over_share: float
    bite: float


def measure_load(
    request: PocketRequest, toolpath: Toolpath, engagement: Engagement, pieces: Pieces
) -> Load:
    """Return what the cutter has to bear on a path.

    Parameters
    ----------
    request : PocketRequest
    toolpath : Toolpath
    engagement : Engagement
        Along the toolpath.
    pieces : Pieces
        Of the toolpath.
    """
    fed = toolpath.kinds[engagement.moves] != Kind.RAPID
    known = [section.z for section in request.sections] or [request.floor]
    at_floor = fed & _near_any(engagement.points[:, 2], floors(pieces, known))
    entry = toolpath.roles[engagement.moves] == Role.ENTRY
    judged = at_floor & ~_is_entry(engagement, at_floor, entry, request.cutter_radius)
    judged &= toolpath.roles[engagement.moves] != Role.LINK  # in the air, or told as a hit
    angles, lengths, limit = engagement.angles, engagement.lengths, request.engagement_limit
    total = float(lengths[judged].sum())
    over = float(lengths[judged & (angles > over_limit(limit))].sum())
    worst = int(np.argmax(np.where(judged, angles, -1.0))) if total > 0 else -1
    x, y = engagement.points[worst, :2] if total > 0 else (0.0, 0.0)
    feed = toolpath.feeds[engagement.moves[worst]] if total > 0 else np.inf
    return Load(
        largest=float(angles[worst]) if total > 0 else 0.0,
        p99=_p99(angles, lengths, judged),
        mean=float((angles * lengths)[judged].sum()) / total if total > 0 else 0.0,
        place=(float(x), float(y)) if total > 0 else None,
        is_slowed=bool(feed < SLOWED * request.feeds.horizontal),
        over_share=over / total if total > 0 else 0.0,
        bite=_p99(engagement.bites, lengths, fed & ~at_floor),
    )


def floors(pieces: Pieces, known: Sequence[float]) -> Floats:
    """Return the Z of the floors that the path clears, descending; always with `known` [mm]."""
    level = pieces.is_level & ~pieces.rapid
    z = np.round(pieces.heights[level] / SAME_HEIGHT) * SAME_HEIGHT
    found, index = np.unique(z, return_inverse=True)
    lengths = np.bincount(index, pieces.lengths[level], minlength=len(found))
    long = found[lengths >= FLOOR_SHARE * lengths.max(initial=0.0)]
    long = long[~_near_any(long, np.array(known))]
    return np.sort(np.r_[long, known])[::-1]


def _near_any(z: Floats, levels: Floats) -> NDArray[np.bool_]:
    return np.abs(z[:, None] - levels[None, :]).min(axis=1) <= SAME_HEIGHT


def _is_entry(
    engagement: Engagement, at_floor: NDArray[np.bool_], entry: NDArray[np.bool_], r: float
) -> NDArray[np.bool_]:
    """Return which samples count as entry.

    All that come soon after an arrival in the solid, and those of the way down that come soon
    after the first at the floor: a slot longer than that is judged as any cut.
    """
    done = np.cumsum(np.where(at_floor, engagement.lengths, 0.0))
    arrivals = np.where(at_floor & engagement.solid_arrivals, done, -np.inf)
    soon = ENTRY_TURNS * 2 * np.pi * r
    solid = done - np.maximum.accumulate(arrivals) <= soon
    return np.asarray(solid | (entry & (done <= soon)))


def _p99(values: Floats, lengths: Floats, chosen: NDArray[np.bool_]) -> float:
    """Return what the values do not pass over 99 % of the length; 0 for none."""
    if lengths[chosen].sum() <= 0:
        return 0.0
    return float(weighted_quantiles(values[chosen], lengths[chosen], [0.99])[0])
