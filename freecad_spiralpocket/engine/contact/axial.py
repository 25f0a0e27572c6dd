# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of a full axial depth stands where the rim is engaged.

Earlier motion that passed above the cutter has left lower ground: a slot opened in
steps, a helix; so may operations before this one have done. What stands at a height is
what neither the motion at the cutter's own depth nor that up to this height has cleared;
it is constant between the heights that occur, so a walk over these, from below, sums it
up exactly. Ramps are taken as steps.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from ..numerics.distinct import distinct
from .air import Stock, intervals_in_air
from .gaps import Gaps
from .neighbors import pairs_of
from .rim import cleared_intervals
from .sampling import Samples
from .swept import SAME_HEIGHT, Pieces

#: Heights of ramps are rounded to this share of the axial depth.
HEIGHT_STEP = 1 / 32


def standing_share(
    gaps: Gaps,
    samples: Samples,
    pieces: Pieces,
    r: float,
    axial_depth: float,
    top: float,
    stock: Stock,
) -> tuple[Floats, Floats]:
    """Return the uncleared angle, averaged over the axial depth from each sample's Z upwards.

    Parameters
    ----------
    gaps : Gaps
        What no earlier motion has cleared down to the sample's Z.
    samples : Samples
    pieces : Pieces
    r, axial_depth, top : float
        Cutter radius, axial depth of a full cut and Z of the top of the stock [mm].
    stock : Stock

    Returns
    -------
    angles : ndarray of shape (k,)
        [rad]
    bites : ndarray of shape (k,)
        Height that stands straight ahead [mm], in ``[0, axial_depth]``.
    """
    z, n = samples.points[:, 2], len(samples)
    ceiling = np.minimum(z + axial_depth, top)
    level, load, bite = z.copy(), np.zeros(n), np.zeros(n)
    angle, ahead = gaps.angles(n), gaps.contain(n, 0.0)
    heights = _stepped_heights(pieces, top, HEIGHT_STEP * axial_depth)
    middle, reach = gaps.surroundings(0, samples.headings, r, np.pi / 2)
    around = (samples.points[:, :2] + middle.T, reach)
    rows, piece = _higher_pairs(samples, angle > 0, pieces, heights, ceiling, around)
    pair, low, high = cleared_intervals(samples, rows, piece, pieces, r)
    air_rows, air_at, air_low, air_high = _air_above(samples, angle > 0, ceiling, stock, r)
    rows = np.concatenate([rows[pair], air_rows])
    at = np.concatenate([heights[piece[pair]], air_at])
    low, high = np.concatenate([low, air_low]), np.concatenate([high, air_high])
    order = np.lexsort((at, rows))
    rows, at, low, high = rows[order], at[order], low[order], high[order]
    rank = _ranks(rows, at)
    by_rank = np.argsort(rank, kind="stable")
    ends = np.cumsum(np.bincount(rank))
    before, rest = np.arange(n), gaps
    # each sample's own heights one after the other, the lowest of all samples at once
    for here in np.split(by_rank, ends[:-1]) if len(ends) else []:
        is_first = np.append(True, np.diff(rows[here]) != 0)
        touched = rows[here[is_first]]
        rise = at[here[is_first]] - level[touched]
        load[touched] += angle[touched] * rise
        bite[touched] += ahead[touched] * rise
        level[touched] = at[here[is_first]]
        # who has a height of this rank had one of that before
        rest = rest.repeated(np.searchsorted(before, touched))
        rest = rest.without(np.cumsum(is_first) - 1, low[here], high[here], np.pi / 2)
        angle[touched] = rest.angles(len(touched))
        ahead[touched] = rest.contain(len(touched), 0.0)
        before = touched
    rise = np.maximum(ceiling - level, 0.0)
    return (load + angle * rise) / axial_depth, bite + ahead * rise


def _air_above(
    samples: Samples, asking: NDArray[np.bool_], ceiling: Floats, stock: Stock, r: float
) -> tuple[NDArray[np.int64], Floats, Floats, Floats]:
    """Return the rim intervals that are air from a layer above the sample on, and from which Z."""
    z = samples.points[:, 2]
    found = [(np.zeros(0, np.int64), np.zeros(0), np.zeros(0), np.zeros(0))]
    for bottom, region in zip(stock.bottoms, stock.regions, strict=True):
        below = (z + SAME_HEIGHT < bottom) & (bottom < ceiling - SAME_HEIGHT)
        mine = np.flatnonzero(asking & below)
        if region is not None and len(mine):
            here = samples.select(mine)
            rims, low, high = intervals_in_air(here.points[:, :2], here.headings, region, r)
            found.append((mine[rims], np.full(len(rims), bottom), low, high))
    rows, at, low, high = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return rows, at, low, high


def _ranks(rows: NDArray[np.int64], at: Floats) -> NDArray[np.intp]:
    """Return which of a row's different heights each is, from 0 on; both are sorted by row."""
    same_row = rows[1:] == rows[:-1]
    steps = np.append(0, np.cumsum(~same_row | (at[1:] != at[:-1])))[: len(rows)]
    begins = np.append(True, ~same_row)[: len(rows)]
    return steps - steps[begins][np.cumsum(begins) - 1]


def _higher_pairs(
    samples: Samples,
    asking: NDArray[np.bool_],
    pieces: Pieces,
    heights: Floats,
    ceiling: Floats,
    around: tuple[Floats, Floats],
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return pairs of sample and earlier piece between the sample's Z and its ceiling.

    Of pieces that come near enough to what stands `around` (see `Gaps.surroundings`) to clear any.

    Level by level, because what lies above the ceiling is most of a deep pocket.
    """
    z = samples.points[:, 2]
    step = np.where(pieces.is_level[samples.pieces], SAME_HEIGHT, np.ptp(z) / 4 + SAME_HEIGHT)
    group = np.round(z / step) * step
    found = [(np.zeros(0, np.int64), np.zeros(0, np.int64))]
    for height in distinct(group[asking]):
        mine = asking & (group == height)
        low, high = z[mine].min() + SAME_HEIGHT, ceiling[mine].max() - SAME_HEIGHT
        wanted = (heights > low) & (heights < high)
        rows, piece = pairs_of(samples, mine, pieces, wanted, *around)
        true = (z[rows] + SAME_HEIGHT < heights[piece]) & (
            heights[piece] < ceiling[rows] - SAME_HEIGHT
        )
        found.append((rows[true], piece[true]))
    rows, piece = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return rows, piece


def _stepped_heights(pieces: Pieces, top: float, step: float) -> Floats:
    """Return the heights of pieces, those of ramps in the middle and rounded; inf for rapids."""
    grain = np.where(pieces.is_level, SAME_HEIGHT, step)
    middle = np.where(pieces.lengths > 0, pieces.bottoms.mean(axis=1), pieces.heights) - top
    return np.where(pieces.rapid, np.inf, top + np.round(middle / grain) * grain)
