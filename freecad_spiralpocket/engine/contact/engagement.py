# SPDX-License-Identifier: LGPL-2.1-or-later
"""Engagement angle and radial depth along any toolpath, against the stock as it is then.

At every sample the rim of the cutter is compared with all earlier motion, also of
the same lap and the cutter's own trail: what no earlier piece has cleared, on the
half of the rim that leads, is engaged. Exact for lines and arcs (`rim`); only the
places of measurement are sampled, closer where the angle changes (`sampling`).

Axial depth: a rim point counts with the share of a full axial depth that still stands
there, so a slot opened in shallow steps counts as shallow. Outside the cleared ground
everything is solid up to the top, as far as the stock reaches.

Cost: a sample has hundreds of earlier pieces within two radii, most of them under
ground that nearer ones have cleared too. So the nearest are measured first, and of
the others only those that come near what then still stands.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..levels import levels_of
from ..model import Floats, PocketRequest
from ..toolpath import Toolpath
from .air import EVERYWHERE, Stock
from .axial import standing_share
from .gaps import Gaps, standing
from .levels_alike import find_twins
from .neighbors import Neighbors, neighborhoods
from .rim import cleared_intervals
from .sampling import Samples, merge_order, merged, samples_between, take_samples
from .swept import Pieces, cut_into_pieces

#: Largest distance of samples, in cutter radii.
SPACING = 0.2
#: Between neighbors that differ by more than this [rad] it is halved, this often.
JUMP, HALVINGS = np.radians(3.0), 2
#: Pieces within this many radii of the cutter center are measured first.
NEAR = 1.0
#: Samples that are compared with the motion above them at once.
PORTION = 5_000
#: A cutter arrives in the solid if more than this of its whole rim is engaged [rad].
SOLID = 0.95 * 2 * np.pi


@dataclass(frozen=True, slots=True, eq=False)
class Engagement:
    """Engagement along a toolpath.

    Attributes
    ----------
    points : ndarray of shape (k, 3)
        Cutter centers [mm], in the order of travel.
    angles : ndarray of shape (k,)
        Engagement angle, each rim point weighted by the share of a full axial depth that
        stood there [rad], in ``[0, pi]``.
    chips : ndarray of shape (k,)
        Thickness of the thickest chip over the feed per tooth, not weighted, in ``[0, 1]``.
    radial_depths : ndarray of shape (k,)
        Width of the cut across the direction of travel at the cutter's tip, not weighted [mm],
        in ``[0, 2 r]``.
    bites : ndarray of shape (k,)
        Height of what stands straight ahead, up to a full axial depth [mm].
    lengths : ndarray of shape (k,)
        Length of path each sample stands for [mm].
    solid_arrivals : ndarray of bool, shape (k,)
        Where the cutter, fed down from above, begins to cut at a height where nothing near it
        has been cleared.
    moves : ndarray of int, shape (k,)
        Move of the toolpath it is on.
    """

    points: Floats
    angles: Floats
    chips: Floats
    radial_depths: Floats
    bites: Floats
    lengths: Floats
    solid_arrivals: NDArray[np.bool_]
    moves: NDArray[np.int64]


def engagement_of(toolpath: Toolpath, request: PocketRequest) -> Engagement:
    """Measure the engagement along a toolpath in the stock that a request tells of."""
    return along_path(
        toolpath,
        request.cutter_radius,
        axial_depth=request.axial_depth,
        top=request.heights.start_depth,
        stock=Stock.at_levels(levels_of(request)),
    )


def along_path(
    toolpath: Toolpath,
    cutter_radius: float,
    *,
    axial_depth: float,
    top: float = 0.0,
    stock: Stock = EVERYWHERE,
    spacing: float | None = None,
) -> Engagement:
    """Measure the engagement of all moves below the top of the stock, rapids too.

    Parameters
    ----------
    toolpath : Toolpath
    cutter_radius : float
        [mm], positive.
    axial_depth : float
        Axial depth of a full cut [mm], positive: the step-down, or the depth of the pocket
        where that is less.
    top : float
        Z of the top of the stock [mm].
    stock : Stock, optional
    spacing : float, optional
        Largest distance of samples [mm], by default a fifth of the radius. Where neighbors
        differ by more than 3 degrees they come as close as a quarter of this.

    Returns
    -------
    Engagement
        Without samples on moves straight up or down.

    Raises
    ------
    ValueError
        If `cutter_radius`, `axial_depth` or `spacing` is not positive.
    """
    spacing = SPACING * cutter_radius if spacing is None else spacing
    for name, value in (
        ("cutter_radius", cutter_radius),
        ("axial_depth", axial_depth),
        ("spacing", spacing),
    ):
        if not value > 0:
            raise ValueError(f"{name} must be positive, got {value}")
    pieces = cut_into_pieces(toolpath, cutter_radius, top, axial_depth)
    samples = take_samples(pieces, cutter_radius, spacing)
    measured = _measure(samples, pieces, cutter_radius, axial_depth, top, stock)
    for halving in range(1, HALVINGS + 1):
        apart = 0.75 * spacing / 2**halving
        more = samples_between(pieces, samples, measured[0], cutter_radius, JUMP, apart)
        added = _measure(more, pieces, cutter_radius, axial_depth, top, stock)
        order = merge_order(samples, more)
        samples = merged(samples, more, order)
        measured = np.concatenate([measured, added], axis=1)[:, order]
    load, chips, width, bites = measured
    return Engagement(
        points=samples.points,
        angles=load,
        chips=chips,
        radial_depths=width,
        bites=bites,
        lengths=samples.lengths,
        solid_arrivals=_solid_arrivals(samples, pieces, cutter_radius, stock),
        moves=pieces.moves[samples.pieces],
    )


def _solid_arrivals(samples: Samples, pieces: Pieces, r: float, stock: Stock) -> NDArray[np.bool_]:
    """Return where level motion begins with nearly all of the rim in uncleared ground."""
    level = pieces.is_level[samples.pieces] & ~pieces.rapid[samples.pieces]
    climbs = np.cumsum(~pieces.is_level | (pieces.lengths == 0))[samples.pieces]
    fresh = level & (np.diff(climbs, prepend=-1) != 0)
    arrivals = np.flatnonzero(fresh)
    # the plunge that brought the cutter here does not count
    undrilled = replace(pieces, heights=pieces.bottoms.max(axis=1))
    around = uncleared(samples.select(arrivals), undrilled, r, np.pi, stock).angles(len(arrivals))
    solid = np.zeros(len(samples), bool)
    solid[arrivals[around > SOLID]] = True
    return solid


def _measure(
    samples: Samples,
    pieces: Pieces,
    r: float,
    axial_depth: float,
    top: float,
    stock: Stock,
) -> Floats:
    """Return weighted angles [rad], chips, radial depths and bites [mm], shape (4, n)."""
    n = len(samples)
    if n == 0:
        return np.zeros((4, 0))
    twins = find_twins(samples, pieces, stock)
    new = twins == np.arange(n)
    gaps = uncleared(samples.select(new), pieces, r, stock=stock)
    gaps = gaps.repeated(np.cumsum(new)[twins] - 1)
    shares = []
    for first in range(0, n, PORTION):
        some = np.arange(first, min(first + PORTION, n))
        here = samples.select(some)
        mine = gaps.repeated(some)
        shares.append(standing_share(mine, here, pieces, r, axial_depth, top, stock))
    load, bites = np.concatenate(shares, axis=1)
    return np.stack([load, gaps.foremost(n), gaps.widths(n, r), bites])


def uncleared(
    samples: Samples,
    pieces: Pieces,
    r: float,
    half: float = np.pi / 2,
    stock: Stock = EVERYWHERE,
) -> Gaps:
    """Return what of the stock no earlier piece has cleared down to the height of the cutter.

    Parameters
    ----------
    samples : Samples
    pieces : Pieces
    r : float
        Cutter radius [mm].
    half : float
        ``pi / 2`` for the leading half of the rim, ``pi`` for all of it.
    stock : Stock, optional
    """
    hoods = neighborhoods(samples, pieces, r)
    gaps = Gaps.joined([_uncleared_here(hood, samples, r, half) for hood in hoods])
    in_air = stock.in_air(samples.points, samples.headings, r)
    return gaps.without(*in_air, half) if len(in_air[0]) else gaps


def _uncleared_here(hood: Neighbors, samples: Samples, r: float, half: float) -> Gaps:
    """Measure the nearest pieces of a neighborhood first, then those near what still stands."""
    here = np.arange(hood.first, hood.last)
    distance = hood.distances()
    near = distance <= NEAR * r
    rows, piece = hood.pairs(near)
    pair, low, high = cleared_intervals(samples, rows, piece, hood.pieces, r)
    gaps = standing(rows[pair], low, high, here, half)
    middle, reach = gaps.surroundings(hood.first, samples.headings[here], r, half)
    rest = ~near & (distance <= 2 * r) & hood.within(hood.points + middle, reach)
    rows, piece = hood.pairs(rest)
    pair, low, high = cleared_intervals(samples, rows, piece, hood.pieces, r)
    return gaps.without(rows[pair], low, high, half)
