# SPDX-License-Identifier: LGPL-2.1-or-later
"""Levels whose motion in the plane repeats that of an earlier one, so that it is measured once.

The rim at a floor depends only on the motion at that floor and deeper, and on the stock. Where
the whole of that is, piece by piece, what it was at an earlier floor in the same stock, a sample
has a twin there: the same place on the same motion.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..numerics.distinct import distinct
from .air import Stock
from .sampling import Samples
from .swept import SAME_HEIGHT, Pieces

#: Pieces nearer than this are the same [mm], and places on them [of their length].
SAME_PLACE = 1e-6


def find_twins(samples: Samples, pieces: Pieces, stock: Stock) -> NDArray[np.int64]:
    """Return, for each sample, the earliest one that sees the same ground; itself if none.

    Parameters
    ----------
    samples : Samples
        In the order of travel.
    pieces : Pieces
    stock : Stock

    Returns
    -------
    ndarray of int, shape (k,)
    """
    twin_piece = _twin_pieces(pieces, stock)
    twins = np.arange(len(samples))
    source = twin_piece[samples.pieces]
    asking = np.flatnonzero(source != samples.pieces)
    if len(asking) == 0:
        return twins
    key = samples.pieces + samples.fractions / 2
    wanted = source[asking] + samples.fractions[asking] / 2
    found = np.minimum(np.searchsorted(key, wanted - SAME_PLACE), len(key) - 1)
    same = np.abs(key[found] - wanted) <= SAME_PLACE
    twins[asking[same]] = found[same]
    return twins


def _twin_pieces(pieces: Pieces, stock: Stock) -> NDArray[np.int64]:
    """Return for each piece the one of the first level alike, or itself."""
    twins = np.arange(len(pieces))
    cutting = ~pieces.rapid
    heights = np.round(pieces.heights / SAME_HEIGHT).astype(np.int64)
    flat = np.flatnonzero(cutting & pieces.is_level)
    known: dict[tuple[int, ...], list[NDArray[np.int64]]] = {}
    # levels alike begin at the same place: a cell, or the one beside it
    cells = np.round(pieces.starts / (2 * SAME_HEIGHT)).astype(np.int64)
    layers = stock.layers(pieces.heights)
    for height in distinct(heights[flat])[::-1]:
        level = flat[heights[flat] == height]
        deep = cutting[: level[-1] + 1] & (heights[: level[-1] + 1] <= height)
        if np.count_nonzero(deep) != len(level):
            continue  # something else has been at this depth or deeper before its end
        x, y = cells[level[0]].tolist()
        alike = len(level), int(layers[level[0]])
        around = [(*alike, x + i, y + j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
        for other in (o for key in around for o in known.get(key, ())):
            if _alike(pieces, level, other):
                twins[level] = other
                break
        else:
            known.setdefault((*alike, x, y), []).append(level)
    return twins


def _alike(pieces: Pieces, one: NDArray[np.int64], other: NDArray[np.int64]) -> bool:
    return len(one) == len(other) and all(
        np.allclose(getattr(pieces, f)[one], getattr(pieces, f)[other], rtol=0, atol=SAME_PLACE)
        for f in ("starts", "ends", "sweeps")
    )
