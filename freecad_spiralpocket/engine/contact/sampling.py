# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where along a toolpath its engagement is measured.

Evenly along the path, at both sides of every kink (where the leading half of the rim
turns at once) and at both ends of every unbroken run. `samples_between` adds samples where
the measured values still jump.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from ..numerics.ragged import rows_of
from ..shapes.points import wrapped
from .swept import Pieces

#: A turn between two pieces above this is a kink [rad].
KINK = np.radians(5.0)
#: How far after its start a piece is first measured, in cutter radii.
AFTER_KINK = 1e-6
#: Ends and starts nearer than this join: posts round arcs [mm].
ROUNDING = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """Places of measurement in the order of travel.

    Attributes
    ----------
    points : ndarray of shape (k, 3)
        Cutter center [mm].
    headings : ndarray of shape (k,)
        Direction of travel [rad].
    pieces : ndarray of int, shape (k,)
        The swept piece it is on.
    fractions : ndarray of shape (k,)
        How far along the piece, in (0, 1].
    distances : ndarray of shape (k,)
        Length of path before it [mm].
    """

    points: Floats
    headings: Floats
    pieces: NDArray[np.int64]
    fractions: Floats
    distances: Floats

    def __len__(self) -> int:
        """Return the number of samples."""
        return len(self.pieces)

    def select(self, chosen: NDArray[np.generic]) -> Samples:
        """Return the chosen samples (indices or a mask), in their order."""
        return Samples(*(getattr(self, name)[chosen] for name in self.__slots__))

    @property
    def lengths(self) -> Floats:
        """Return the length of path each one stands for, shape (k,) [mm]."""
        gaps = np.diff(self.distances)
        return (np.r_[0.0, gaps] + np.r_[gaps, 0.0]) / 2


def take_samples(pieces: Pieces, cutter_radius: float, spacing: float) -> Samples:
    """Place samples at most `spacing` apart in every run, and at its ends; lengths are in mm.

    A run is level or a ramp throughout and has no kink, so equal levels get equal samples.
    """
    lengths = pieces.lengths
    moving = np.flatnonzero(lengths > 0)
    if len(moving) == 0:
        return _samples_at(pieces, moving, np.zeros(0))
    broken = np.flatnonzero(_breaks(pieces, moving[:-1], moving[1:]))
    before = np.r_[moving[broken], moving[-1:]]
    after = np.r_[moving[:1], moving[broken + 1]]
    done = np.cumsum(lengths)
    begin, end = done[after] - lengths[after], done[before]
    count = np.maximum(np.ceil((end - begin) / spacing), 1).astype(np.int64)
    run, place = rows_of(count)
    marks = begin[run] + (place + 0.5) * (end - begin)[run] / count[run]
    index, fraction = _locate(done, lengths, marks)
    index = np.concatenate([index, before, after])
    fraction = np.concatenate([fraction, np.ones(len(before)), np.zeros(len(after))])
    return _samples_at(pieces, index, _off_start(fraction, lengths[index], cutter_radius))


def _breaks(
    pieces: Pieces, here: NDArray[np.int64], following: NDArray[np.int64]
) -> NDArray[np.bool_]:
    """Return where a run ends between a piece and the next one that moves in the plane."""
    turn = pieces.directions(following, np.zeros(len(here)))
    turn = turn - pieces.directions(here, np.ones(len(here)))
    kink = np.abs(wrapped(turn)) > KINK
    apart = np.hypot(*(pieces.starts[following] - pieces.ends[here]).T) > ROUNDING
    level = pieces.is_level
    ramp = level[here] != level[following]
    return kink | apart | ramp | (following != here + 1)


def samples_between(
    pieces: Pieces,
    samples: Samples,
    values: Floats,
    cutter_radius: float,
    jump: float,
    spacing: float,
) -> Samples:
    """Return new samples halfway between neighbors whose values differ much.

    Parameters
    ----------
    pieces : Pieces
        What the samples are on.
    samples : Samples
    values : ndarray of shape (k,)
        What was measured at each.
    cutter_radius : float
        [mm]
    jump : float
        Values that differ by no more need nothing between them, in their unit.
    spacing : float
        Nor do neighbors that are no farther apart [mm].
    """
    gaps = np.diff(samples.distances)
    wide = np.flatnonzero((gaps > spacing) & (np.abs(np.diff(values)) > jump))
    marks = samples.distances[wide] + gaps[wide] / 2
    lengths = pieces.lengths
    index, fraction = _locate(np.cumsum(lengths), lengths, marks)
    return _samples_at(pieces, index, _off_start(fraction, lengths[index], cutter_radius))


def merge_order(one: Samples, other: Samples) -> NDArray[np.int64]:
    """Return the order of travel of the samples of both, the second numbered after the first."""
    return np.lexsort((np.r_[one.fractions, other.fractions], np.r_[one.pieces, other.pieces]))


def merged(one: Samples, other: Samples, order: NDArray[np.int64]) -> Samples:
    """Return the samples of both in the given order."""
    fields = Samples.__slots__
    return Samples(*(np.concatenate([getattr(one, f), getattr(other, f)])[order] for f in fields))


def _locate(done: Floats, lengths: Floats, marks: Floats) -> tuple[NDArray[np.int64], Floats]:
    """Return piece and fraction at lengths of path `marks`; `done` is the length after each."""
    index = np.minimum(np.searchsorted(done, marks), len(done) - 1)
    return index, np.clip(1.0 - (done[index] - marks) / lengths[index], 0.0, 1.0)


def _off_start(fraction: Floats, lengths: Floats, r: float) -> Floats:
    """Keep samples off the very start of a piece, where the cutter covers its own trail."""
    return np.maximum(fraction, np.minimum(AFTER_KINK * r / lengths, 1.0))


def _samples_at(pieces: Pieces, index: NDArray[np.int64], fraction: Floats) -> Samples:
    order = np.lexsort((fraction, index))
    index, fraction = index[order], fraction[order]
    z0, z1 = pieces.bottoms[index].T
    lengths = pieces.lengths
    before = np.cumsum(lengths) - lengths
    return Samples(
        points=np.column_stack([pieces.positions(index, fraction), z0 + fraction * (z1 - z0)]),
        headings=pieces.directions(index, fraction),
        pieces=index,
        fractions=fraction,
        distances=before[index] + fraction * lengths[index],
    )
