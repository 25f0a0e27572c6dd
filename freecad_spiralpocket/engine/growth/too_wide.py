# SPDX-License-Identifier: LGPL-2.1-or-later
"""Regions of so many laps that nobody means them: a step-over in the wrong unit, a tiny cutter."""

from __future__ import annotations

from shapely import Polygon

from ..errors import NotYetError
from ..shapes.shaping import grow_coarsely
from .front_rules import WIDEST
from .fronts import MAX_FRONTS
from .lap_width import STRETCH


def check_width(region: Polygon, stepover: float) -> None:
    """Refuse at once what would take minutes, and more memory than there is, by any strategy.

    Parameters
    ----------
    region : shapely.Polygon
    stepover : float
        [mm]

    Raises
    ------
    NotYetError
        If it is thousands of step-overs wide.
    """
    if not grow_coarsely(region, -MAX_FRONTS * WIDEST * STRETCH * stepover).is_empty:
        raise too_wide()


def too_wide() -> NotYetError:
    """Return what is to be told of such a region."""
    return NotYetError(
        f"The pocket is more than {MAX_FRONTS} step-overs wide.",
        "Take a wider cutter or a larger step-over.",
    )
