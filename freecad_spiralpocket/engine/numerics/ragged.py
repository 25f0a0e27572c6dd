# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of different lengths, one after the other in flat arrays."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


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
