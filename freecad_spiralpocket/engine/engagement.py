# SPDX-License-Identifier: LGPL-2.1-or-later
"""Engagement angle and radial depth along any toolpath, against the stock as it is then.

At every sample the rim of the cutter is compared with all earlier motion, also of
the same lap and the cutter's own trail: what no earlier piece has cleared, on the
half of the rim that leads, is engaged. Exact for lines and arcs (`rim`); only the
places of measurement are sampled.

Axial depth: a rim point counts with the share of the level's depth that still stands
there, so a slot opened in shallow steps counts as shallow. Ground above the level's
top does not count. Outside the cleared ground everything is solid: a closed pocket.

Sampling bound: samples are at most `spacing` apart and at both sides of every kink.
Between two samples the cutter moves by at most half a spacing to the nearer one, so
no rim point farther than ``spacing / 2`` from the front passes unseen.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from .model import Floats
from .rim import cleared_by_arcs, cleared_by_lines, standing
from .swept import SAME_HEIGHT, Pieces, cut_into_pieces
from .toolpath import Toolpath

#: Distance of samples in cutter radii.
SPACING = 0.1
#: A turn between two moves above this is a kink and gets a sample on both sides [rad].
KINK = np.radians(5.0)
#: How far after a kink the next move is first measured, in cutter radii.
AFTER_KINK = 1e-6
#: Samples that look for neighbors together, and pairs that are measured at once.
BLOCK, CHUNK = 12, 150_000
#: Blocks that share one search tree.
WINDOW = 4000


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """Places of measurement in the order of travel.

    Attributes
    ----------
    points : ndarray of shape (k, 3)
        Cutter center [mm].
    headings : ndarray of shape (k,)
        Direction of travel [rad].
    lengths : ndarray of shape (k,)
        Length of path each one stands for [mm]; 0 for the extra ones at kinks.
    pieces : ndarray of int, shape (k,)
        The swept piece it is on.
    fractions : ndarray of shape (k,)
        How far along the piece, in (0, 1].
    """

    points: Floats
    headings: Floats
    lengths: Floats
    pieces: NDArray[np.int64]
    fractions: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Engagement:
    """Engagement along a toolpath.

    Attributes
    ----------
    points : ndarray of shape (k, 3)
        Cutter centers [mm], in the order of travel.
    angles : ndarray of shape (k,)
        Engagement angle, each rim point weighted by the share of the level's depth that
        stood there [rad], in ``[0, pi]``.
    radial_depths : ndarray of shape (k,)
        Width of the cut across the direction of travel at the cutter's tip, not weighted [mm],
        in ``[0, 2 r]``.
    lengths : ndarray of shape (k,)
        Length of path each sample stands for [mm]; 0 at kinks, where it is an extra one.
    moves : ndarray of int, shape (k,)
        Move of the toolpath it is on.
    """

    points: Floats
    angles: Floats
    radial_depths: Floats
    lengths: Floats
    moves: NDArray[np.int64]


def along_path(
    toolpath: Toolpath,
    cutter_radius: float,
    *,
    axial_depth: float,
    top: float = 0.0,
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
    spacing : float, optional
        Largest distance of samples [mm]; by default a tenth of the radius.

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
    pieces = cut_into_pieces(toolpath, cutter_radius, top)
    samples = take_samples(pieces, cutter_radius, spacing)
    every = np.arange(len(samples.pieces))
    z = samples.points[:, 2]
    angles, widths = uncleared(samples, every, pieces, cutter_radius, z + SAME_HEIGHT)
    angles = _weigh(angles, samples, pieces, cutter_radius, axial_depth, top)
    moves = pieces.moves[samples.pieces]
    return Engagement(samples.points, angles, widths, samples.lengths, moves)


def take_samples(pieces: Pieces, r: float, spacing: float) -> Samples:
    """Place samples along the pieces, evenly and on both sides of kinks."""
    lengths = pieces.lengths
    done = np.cumsum(lengths)
    total = float(done[-1]) if len(done) else 0.0
    count = int(np.ceil(total / spacing))
    pitch = total / max(count, 1)
    marks = (np.arange(count) + 0.5) * pitch
    index = np.searchsorted(done, marks)
    fraction = np.clip(1.0 - (done[index] - marks) / lengths[index], 1e-12, 1.0)
    moving = np.flatnonzero(lengths > 0)
    here, following = moving[:-1], moving[1:]
    one = np.ones(len(here))
    turn = pieces.directions(following, 0 * one) - pieces.directions(here, one)
    turn = np.abs((turn + np.pi) % (2 * np.pi) - np.pi)
    apart = np.hypot(*(pieces.starts[following] - pieces.ends[here]).T) > 1e-9
    kink = np.flatnonzero((turn > KINK) | apart | (following != here + 1))
    after = np.r_[moving[:1], following[kink]]
    index = np.concatenate([index, here[kink], moving[-1:], after])
    start = np.minimum(AFTER_KINK * r / lengths[after], 1.0)
    fraction = np.concatenate([fraction, np.ones(len(kink) + len(moving[-1:])), start])
    weight = np.r_[np.full(count, pitch), np.zeros(len(index) - count)]
    order = np.lexsort((fraction, index))
    index, fraction, weight = index[order], fraction[order], weight[order]
    z0, z1 = pieces.bottoms[index].T
    points = np.column_stack([pieces.positions(index, fraction), z0 + fraction * (z1 - z0)])
    return Samples(points, pieces.directions(index, fraction), weight, index, fraction)


def _weigh(
    angles: Floats, samples: Samples, pieces: Pieces, r: float, axial_depth: float, top: float
) -> Floats:
    """Average the uncleared angle over the axial depth, from each sample's Z upwards.

    It is constant between the heights that earlier motion nearby has left.
    """
    z = samples.points[:, 2]
    ceiling = np.minimum(z + axial_depth, top)
    level, load, angle = z.copy(), np.zeros(len(z)), angles.copy()
    steps = np.where(pieces.rapid, np.inf, np.round(pieces.heights / SAME_HEIGHT) * SAME_HEIGHT)
    for height in np.unique(steps):
        which = np.flatnonzero(
            (z + SAME_HEIGHT < height) & (height < ceiling - SAME_HEIGHT) & (angle > 0)
        )
        which = _near(samples, which, pieces, np.flatnonzero(steps == height), r)
        if len(which) == 0:
            continue
        below = np.full(len(which), height + SAME_HEIGHT)
        load[which] += angle[which] * (height - level[which])
        level[which] = height
        angle[which], _ = uncleared(samples, which, pieces, r, below)
    load += angle * np.maximum(ceiling - level, 0.0)
    return load / axial_depth


def _near(
    samples: Samples, which: NDArray[np.int64], pieces: Pieces, chosen: NDArray[np.int64], r: float
) -> NDArray[np.int64]:
    """Return those samples that have one of the chosen pieces within reach and before them."""
    if len(which) == 0 or len(chosen) == 0:
        return which[:0]
    xy = samples.points[which, :2]
    tree = shapely.STRtree(shapely.box(*pieces.bounds[chosen].T))
    hit, piece = tree.query(shapely.box(*(xy - 2 * r).T, *(xy + 2 * r).T))
    return which[np.unique(hit[chosen[piece] < samples.pieces[which[hit]]])]


def uncleared(
    samples: Samples,
    which: NDArray[np.int64],
    pieces: Pieces,
    r: float,
    below: Floats,
    half: float = np.pi / 2,
) -> tuple[Floats, Floats]:
    """Return what no earlier piece has cleared down to a height.

    Parameters
    ----------
    samples : Samples
    which : ndarray of int, shape (k,)
        Samples to measure, ascending.
    pieces : Pieces
    r : float
        Cutter radius [mm].
    below : ndarray of shape (k,)
        Z up to which a piece counts as having cleared, of each sample [mm].
    half : float
        ``pi / 2`` for the leading half of the rim, ``pi`` for all of it.

    Returns
    -------
    angles : ndarray of shape (k,)
        [rad]
    widths : ndarray of shape (k,)
        Across the direction of travel [mm].
    """
    angles = np.full(len(which), 2 * half)
    widths = np.full(len(which), 2.0 * r)
    for first, last, who, piece in _pairs(samples, which, pieces, r, below):
        s = which[who]
        owner, low, high = _intervals(samples, s, pieces, piece, r)
        n = last - first
        owner, begin, end = standing(who[owner] - first, low, high, n, half)
        angles[first:last] = np.bincount(owner, end - begin, minlength=n)
        wide = r * np.abs(np.sin(end) - np.sin(begin))
        widths[first:last] = np.bincount(owner, wide, minlength=n)
    return angles, widths


def _intervals(
    samples: Samples, s: NDArray[np.int64], pieces: Pieces, piece: NDArray[np.int64], r: float
) -> tuple[NDArray[np.int64], Floats, Floats]:
    """Return the rim intervals cleared in pairs of sample and piece, and the pair of each."""
    xy, heading = samples.points[s, :2], samples.headings[s]
    arc = pieces.is_arc[piece]
    lines, arcs = np.flatnonzero(~arc), np.flatnonzero(arc)
    pair, low, high = cleared_by_lines(xy[lines], heading[lines], pieces, piece[lines], r)
    if len(arcs) == 0:
        return lines[pair], low, high
    own = samples.pieces[s[arcs]] == piece[arcs]
    until = np.where(own, samples.fractions[s[arcs]], 1.0)
    bent = cleared_by_arcs(xy[arcs], heading[arcs], pieces, piece[arcs], r, until, own)
    return (
        np.concatenate([lines[pair], arcs[bent[0]]]),
        np.concatenate([low, bent[1]]),
        np.concatenate([high, bent[2]]),
    )


def _pairs(
    samples: Samples, which: NDArray[np.int64], pieces: Pieces, r: float, below: Floats
) -> Iterator[tuple[int, int, NDArray[np.int64], NDArray[np.int64]]]:
    """Yield (first, last, rows of `which`, pieces): all earlier pieces that may reach a sample.

    Chunks hold whole blocks of consecutive samples, so that memory stays bounded.
    """
    for begin in range(0, len(which), WINDOW * BLOCK):
        window = slice(begin, min(begin + WINDOW * BLOCK, len(which)))
        block, piece = _neighbors(samples, which[window], pieces, r, below[window])
        starts = np.arange(begin, window.stop, BLOCK)
        sizes = np.minimum(BLOCK, window.stop - starts)
        work = np.cumsum(np.bincount(block, minlength=len(starts)) * sizes)
        cuts = np.searchsorted(work, np.arange(CHUNK, work[-1], CHUNK), side="right")
        cuts = np.unique(np.r_[0, cuts, len(starts)])
        edges = np.searchsorted(block, cuts)
        for b0, b1, e0, e1 in zip(cuts[:-1], cuts[1:], edges[:-1], edges[1:], strict=True):
            b, p = block[e0:e1], piece[e0:e1]
            size = sizes[b]
            within = np.arange(size.sum()) - np.repeat(np.cumsum(size) - size, size)
            who, p = np.repeat(starts[b], size) + within, np.repeat(p, size)
            now = samples.pieces[which[who]]
            early = ((p < now) | ((p == now) & pieces.is_arc[p])) & (
                pieces.heights[p] <= below[who]
            )
            yield starts[b0], starts[b1 - 1] + sizes[b1 - 1], who[early], p[early]


def _neighbors(
    samples: Samples, which: NDArray[np.int64], pieces: Pieces, r: float, below: Floats
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return pairs of block and piece whose boxes come within reach, sorted by block."""
    starts = np.arange(0, len(which), BLOCK)
    xy = samples.points[which, :2]
    low, high = np.minimum.reduceat(xy, starts) - 2 * r, np.maximum.reduceat(xy, starts) + 2 * r
    now = samples.pieces[which[np.minimum(starts + BLOCK, len(which)) - 1]]
    before = slice(0, now[-1] + 1)
    useful = np.flatnonzero(~pieces.rapid[before] & (pieces.heights[before] <= below.max()))
    tree = shapely.STRtree(shapely.box(*pieces.bounds[useful].T))
    block, hit = tree.query(shapely.box(*low.T, *high.T))
    piece = useful[hit]
    early = piece <= now[block]
    block, piece = block[early], piece[early]
    order = np.argsort(block, kind="stable")
    return block[order], piece[order]
