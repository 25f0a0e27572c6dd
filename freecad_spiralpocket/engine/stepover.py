# SPDX-License-Identifier: LGPL-2.1-or-later
"""Step-over and engagement angle of a straight cut: one figure in two units.

A cutter of radius R that cuts straight on with radial depth of cut ``s`` meets
the stock over the angle ``phi`` with ``cos(phi) = 1 - s / R``: 90 degrees at half
the diameter, 180 in a full slot. On a bend the true angle differs; that is what
`engagement` measures.
"""

from __future__ import annotations

import math
from typing import overload

import numpy as np
from numpy.typing import NDArray

#: Engagement above this multiple of the limit and this much more [rad] clearly passes it.
OVER_FACTOR, OVER_MARGIN = 1.15, math.radians(4.0)


def engagement_angle(stepover: float, cutter_radius: float) -> float:
    """Return the engagement angle of a straight cut [rad], in ``[0, pi]``.

    Parameters
    ----------
    stepover : float
        Radial depth of cut [mm]; what is outside ``[0, 2 R]`` counts as its end.
    cutter_radius : float
        R [mm], positive.
    """
    return math.acos(min(1.0, max(-1.0, 1.0 - stepover / cutter_radius)))


@overload
def radial_depth(angle: float, cutter_radius: float) -> float: ...


@overload
def radial_depth(angle: NDArray[np.float64], cutter_radius: float) -> NDArray[np.float64]: ...


def radial_depth(
    angle: float | NDArray[np.float64], cutter_radius: float
) -> float | NDArray[np.float64]:
    """Return the step-over [mm] whose straight cut has an engagement `angle` [rad].

    Parameters
    ----------
    angle : float or ndarray
        In ``[0, pi]`` [rad].
    cutter_radius : float
        R [mm], positive.

    Returns
    -------
    float or ndarray
        As `angle`.
    """
    depth = cutter_radius * (1.0 - np.cos(angle))
    return depth if isinstance(angle, np.ndarray) else float(depth)


def over_limit(limit: float) -> float:
    """Return the engagement angle that clearly passes a limit [rad]: that is told."""
    return OVER_FACTOR * limit + OVER_MARGIN
