# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which earlier motion is near enough to a sample to have cleared part of its rim.

Blocks of consecutive samples look for pieces together, by bounding box; within a
block every sample is paired with every piece found, in dense arrays of one row per
block and piece and one column per sample. Blocks come in portions of bounded size,
so memory stays linear in the path, with a small factor.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from ..model import Floats
from ..numerics.distinct import distinct
from .distances import point_to_segment
from .sampling import Samples
from .swept import SAME_HEIGHT, Pieces

#: Samples in a block, and pairs that are measured at once: small enough for a CPU's cache.
BLOCK, PORTION = 12, 50_000
#: Blocks that share one search tree.
WINDOW = 2000


@dataclass(frozen=True, slots=True, eq=False)
class Neighbors:
    """Samples ``first`` to ``last - 1`` and the pieces near them.

    Attributes
    ----------
    first, last : int
    pieces : Pieces
    rows : ndarray of int, shape (m, 1)
        First sample of each block and piece; its others follow.
    index : ndarray of int, shape (m,)
        The piece.
    points : ndarray of shape (2, last - first)
        Cutter centers, x and y [mm].
    allowed : ndarray of bool, shape (m, BLOCK)
        Which pieces are earlier than the sample and deep enough.
    """

    first: int
    last: int
    pieces: Pieces
    rows: NDArray[np.int64]
    index: NDArray[np.int64]
    points: Floats
    allowed: NDArray[np.bool_]

    def distances(self) -> Floats:
        """Return lower bounds of the distances of samples to pieces, shape (m, BLOCK) [mm].

        Exact for lines; for arcs it is the distance to the chord less the sagitta. Infinite for
        pieces that are not allowed.
        """
        return np.where(self.allowed, self._to_chords(*self.points), np.inf)

    def within(self, points: Floats, reach: Floats) -> NDArray[np.bool_]:
        """Return which allowed pieces may come within reach of a point given for each sample.

        Parameters
        ----------
        points : ndarray of shape (2, last - first)
            [mm]
        reach : ndarray of shape (last - first,)
            [mm]; negative for samples that do not ask.
        """
        return self.allowed & (self._to_chords(*points) <= self._spread(reach))

    def pairs(self, chosen: NDArray[np.bool_]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Return sample and piece of the chosen pairs, `chosen` of shape (m, BLOCK)."""
        row, column = np.nonzero(chosen)
        return self.rows[row, 0] + column, self.index[row]

    def _to_chords(self, x: Floats, y: Floats) -> Floats:
        p, i = self.pieces, self.index
        (ax, ay), (bx, by) = p.starts[i].T, p.ends[i].T
        length = np.hypot(bx - ax, by - ay)
        scale = 1.0 / np.maximum(length, 1e-12)
        ux, uy = ((bx - ax) * scale)[:, None], ((by - ay) * scale)[:, None]
        cx, cy = self._spread(x) - ax[:, None], self._spread(y) - ay[:, None]
        along = cx * ux + cy * uy
        side = ux * cy - uy * cx
        beyond = along - np.clip(along, 0.0, length[:, None])
        sag = p.sags[i]
        return np.sqrt(side * side + beyond * beyond) - sag[:, None]

    def _spread(self, values: Floats) -> Floats:
        """Return per-sample values as one row of its block for each pair, shape (m, BLOCK)."""
        return _blocks(values)[(self.rows[:, 0] - self.first) // BLOCK]


def neighborhoods(samples: Samples, pieces: Pieces, cutter_radius: float) -> Iterator[Neighbors]:
    """Yield the samples, portion by portion, with the earlier pieces within 2 r of them [mm].

    Pieces above a sample have not cleared its ground and are not allowed; rapids never are.
    """
    n = len(samples)
    for first in range(0, n, WINDOW * BLOCK):
        last = min(first + WINDOW * BLOCK, n)
        block, index = _candidates(samples, slice(first, last), pieces, cutter_radius)
        blocks = -(-(last - first) // BLOCK)
        work = np.cumsum(np.bincount(block, minlength=blocks)) * BLOCK
        cuts = np.searchsorted(work, np.arange(PORTION, work[-1], PORTION), side="right")
        cuts = distinct(np.r_[0, cuts, blocks])
        edges = np.searchsorted(block, cuts)
        for b0, b1, e0, e1 in zip(cuts[:-1], cuts[1:], edges[:-1], edges[1:], strict=True):
            f, t = first + b0 * BLOCK, min(first + b1 * BLOCK, last)
            yield _portion(samples, f, t, pieces, block[e0:e1] - b0, index[e0:e1])


def pairs_of(
    samples: Samples,
    asking: NDArray[np.bool_],
    pieces: Pieces,
    wanted: NDArray[np.bool_],
    places: Floats,
    reach: Floats,
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return pairs of asking samples and wanted earlier pieces that come near a place.

    For few pieces, of any height; rapids are left out.

    Parameters
    ----------
    places : ndarray of shape (n, 2)
        Of each sample [mm].
    reach : ndarray of shape (n,)
        A piece may be farther from the place than this only by its own bend [mm].
    """
    rows, index = np.flatnonzero(asking), np.flatnonzero(wanted & ~pieces.rapid)
    if len(rows) == 0 or len(index) == 0:
        return rows[:0], index[:0]
    tree = shapely.STRtree(shapely.points(places[rows]))
    box, most = pieces.bounds[index], reach[rows].max()
    piece, row = tree.query(shapely.box(*(box[:, :2] - most).T, *(box[:, 2:] + most).T))
    row, piece = rows[row], index[piece]
    earlier = piece < samples.pieces[row]
    row, piece = row[earlier], piece[earlier]
    to_chord = point_to_segment(places[row], pieces.starts[piece], pieces.ends[piece])
    near = to_chord - pieces.sags[piece] <= reach[row]
    return row[near], piece[near]


def _portion(
    samples: Samples,
    first: int,
    last: int,
    pieces: Pieces,
    block: NDArray[np.int64],
    index: NDArray[np.int64],
) -> Neighbors:
    here = slice(first, last)
    now = _blocks(samples.pieces[here])[block]
    below = _blocks(samples.points[here, 2])[block] + SAME_HEIGHT
    piece = index[:, None]
    earlier = (piece < now) | ((piece == now) & pieces.is_arc[piece])
    column = block[:, None] * BLOCK + np.arange(BLOCK)
    allowed = earlier & (pieces.heights[piece] <= below) & (column < last - first)
    rows = first + block[:, None] * BLOCK
    return Neighbors(first, last, pieces, rows, index, samples.points[here, :2].T, allowed)


def _candidates(
    samples: Samples, here: slice, pieces: Pieces, r: float
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return pairs of block and piece whose boxes come within reach, sorted by block."""
    xy, z = samples.points[here, :2], samples.points[here, 2]
    starts = np.arange(0, len(xy), BLOCK)
    low, high = np.minimum.reduceat(xy, starts) - 2 * r, np.maximum.reduceat(xy, starts) + 2 * r
    now = np.maximum.reduceat(samples.pieces[here], starts)
    below = np.maximum.reduceat(z, starts) + SAME_HEIGHT
    past = slice(0, now[-1] + 1)
    useful = np.flatnonzero(~pieces.rapid[past] & (pieces.heights[past] <= below.max()))
    tree = shapely.STRtree(shapely.box(*pieces.bounds[useful].T))
    block, hit = tree.query(shapely.box(*low.T, *high.T))
    index = useful[hit]
    early = (index <= now[block]) & (pieces.heights[index] <= below[block])
    block, index = block[early], index[early]
    order = np.argsort(block, kind="stable")
    return block[order], index[order]


def _blocks(values: NDArray[Any]) -> NDArray[Any]:
    """Return values as rows of `BLOCK`, the last one filled up with its last value."""
    missing = -len(values) % BLOCK
    return np.concatenate([values, np.repeat(values[-1:], missing)]).reshape(-1, BLOCK)
