# SPDX-License-Identifier: LGPL-2.1-or-later
"""Filters along a row of values: even out, spread the largest or the smallest; rasters.

What scipy.ndimage does, in numpy: loading scipy takes as long as planning a small pocket.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from .ragged import rows_of

#: The bell curve is cut off at this many of its widths.
TRUNCATE = 4.0


def evened(values: Floats, sigma: float, *, closed: bool = False) -> Floats:
    """Return values under a Gaussian filter.

    Parameters
    ----------
    values : ndarray of shape (n,) or (n, m)
        Filtered along the first axis.
    sigma : float
        Width of the bell curve [samples].
    closed : bool
        Whether the last value is followed by the first; else the ends go on as they are.
    """
    reach = int(TRUNCATE * sigma + 0.5)
    if reach == 0:
        return values.astype(float)
    bell = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    bell /= bell.sum()
    around = _continued(values, reach, closed)
    if values.ndim == 1:
        return np.convolve(around, bell, mode="valid")
    return np.column_stack([np.convolve(column, bell, mode="valid") for column in around.T])


def highest(values: Floats, width: int, *, closed: bool = False) -> Floats:
    """Return the largest of the `width` (odd) values about each, shape (n,).

    `closed` is as in `evened`.
    """
    return _over_windows(np.maximum, _continued(values, width // 2, closed), width)


def lowest(values: Floats, width: int, *, closed: bool = False) -> Floats:
    """Return the smallest of the `width` (odd) values about each, shape (n,).

    `closed` is as in `evened`.
    """
    return _over_windows(np.minimum, _continued(values, width // 2, closed), width)


def dilated(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return a raster's mask with the four neighbors of each pixel added."""
    grown = mask.copy()
    grown[1:] |= mask[:-1]
    grown[:-1] |= mask[1:]
    grown[:, 1:] |= mask[:, :-1]
    grown[:, :-1] |= mask[:, 1:]
    return grown


def patches_of(mask: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return a number for each pixel of a raster's mask, the same where they hang together.

    Pixels that touch at a corner do. -1 outside of the mask.
    """
    rows, columns = mask.shape
    width = columns + 2
    flat = np.pad(mask, ((0, 0), (1, 1))).ravel()
    change = np.flatnonzero(flat[1:] != flat[:-1]) + 1
    begin, end = change[::2], change[1::2]
    # each run of a row, with those of the next row that touch it
    first = np.searchsorted(end, begin + width)
    count = np.maximum(np.searchsorted(begin, end + width, "right") - first, 0)
    here, place = rows_of(count)
    below = first[here] + place
    patch = np.arange(len(begin))
    while True:
        least = np.minimum(patch[here], patch[below])
        lower = patch.copy()
        np.minimum.at(lower, patch[here], least)
        np.minimum.at(lower, patch[below], least)
        lower = lower[lower]
        if np.array_equal(lower, patch):
            break
        patch = lower
    numbers = np.full(flat.shape, -1, np.intp)
    numbers[flat] = np.repeat(patch, end - begin)
    return numbers.reshape(rows, width)[:, 1:-1]


def _over_windows(extreme: np.ufunc, values: Floats, width: int) -> Floats:
    """Return the extreme of each `width` values in a row; windows are doubled till they suffice."""
    done = 1
    while 2 * done <= width:
        values = extreme(values[:-done], values[done:])
        done *= 2
    rest = width - done
    return extreme(values[: len(values) - rest], values[rest:]) if rest else values


def _continued(values: Floats, reach: int, closed: bool) -> Floats:
    """Return values with `reach` more before and after."""
    count = len(values)
    index = np.arange(-reach, count + reach)
    return values[index % count if closed else np.clip(index, 0, count - 1)]
