# SPDX-License-Identifier: LGPL-2.1-or-later
"""Axial levels: the floors at which the pocket is cleared, from the top down.

As FreeCAD's own operations do it: full steps down from the start depth, what
is left as the last one, and, where a finish depth is set, one thin level at
the very end.
"""

from __future__ import annotations

import math

from .model import Heights

#: A remainder thinner than this is no level of its own [mm].
THIN = 1e-6


def floors(heights: Heights, floor_stock: float = 0.0) -> list[float]:
    """Return the levels' Z [mm], highest first; the last is ``final_depth + floor_stock``.

    Parameters
    ----------
    heights : Heights
    floor_stock : float
        Stock to leave on the floor [mm].
    """
    top, bottom = heights.start_depth, heights.final_depth + floor_stock
    rough = bottom + heights.finish_depth
    count = max(1, math.ceil((top - rough) / heights.step_down - THIN))
    levels = [top - heights.step_down * i for i in range(1, count)]
    if top - rough > THIN:
        levels.append(rough)
    if heights.finish_depth > THIN:
        levels.append(bottom)
    return levels
