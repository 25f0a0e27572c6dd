# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which values of an array differ, and which are among others.

As `numpy.unique` and `numpy.isin` tell, in a fraction of their time for arrays of a few hundred;
newer versions of these also load masked arrays, which takes as long as a tenth of a small pocket.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..model import Floats


def distinct(values: NDArray[Any]) -> NDArray[Any]:
    """Return the different values of an array of any shape, sorted, shape (k,)."""
    ordered = np.sort(values, axis=None)
    return ordered[np.append(True, ordered[1:] != ordered[:-1])[: len(ordered)]]


def distinct_pairs(pairs: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return the different rows, shape (k, 2), of pairs of indices, shape (n, 2), sorted."""
    base = pairs.max(initial=0) + 1
    return np.column_stack(np.divmod(distinct(pairs[:, 0] * base + pairs[:, 1]), base))


def distinct_places(points: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return where points, shape (n, 2), are for the first time, and which of these each is at.

    Returns
    -------
    first : ndarray of int, shape (k,)
        Of each place, sorted by x and y.
    place : ndarray of int, shape (n,)
    """
    # a complex number a point: rows are compared a hundred times as slowly
    numbers = np.ascontiguousarray(points).view(complex).ravel()
    _, first, place = np.unique(numbers, return_index=True, return_inverse=True)
    return first, place


def are_among(indices: NDArray[np.intp], chosen: NDArray[np.intp]) -> NDArray[np.bool_]:
    """Return which indices, shape (n,), are among the chosen ones; both 0 or more."""
    marked = np.zeros(1 + max(indices.max(initial=-1), chosen.max(initial=-1)), bool)
    marked[chosen] = True
    return marked[indices]
