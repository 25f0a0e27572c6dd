# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of different lengths, one after the other in flat arrays; what edges cross of a raster."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..model import Floats


def rows_of(counts: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the row of each element, and its place in that row.

    Parameters
    ----------
    counts : ndarray of int, shape (n,)
        Elements of each row, 0 or more.

    Returns
    -------
    row, place : ndarray of int, shape (k,)
    """
    row = np.repeat(np.arange(len(counts)), counts)
    return row, np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts, counts)


def crossings_of(begins: Floats, ends: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp], Floats]:
    """Return where edges cross the rows of a raster, at whole y.

    Of an edge's ends only the lower one counts. Where two edges meet on a row they so make one
    crossing, at a tip none or two, and rings an even number in each row.

    Parameters
    ----------
    begins, ends : ndarray of shape (n, 2)
        Of the edges, in units of the raster.

    Returns
    -------
    edge, row : ndarray of int, shape (k,)
    x : ndarray of shape (k,)
    """
    low = np.ceil(np.minimum(begins[:, 1], ends[:, 1])).astype(np.intp)
    high = np.ceil(np.maximum(begins[:, 1], ends[:, 1])).astype(np.intp)  # low <= row < high
    edge, place = rows_of(high - low)
    row = low[edge] + place
    share = (row - begins[edge, 1]) / (ends[edge, 1] - begins[edge, 1])
    return edge, row, begins[edge, 0] + share * (ends[edge, 0] - begins[edge, 0])
