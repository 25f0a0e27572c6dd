# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a machine tool can do: speeds, accelerations, jerks, corners, and its control's blocks.

A `Machine` is all that `timing` needs to know. Limits hold for each axis and, where the
control has such a limit too, along the path. Corners follow one of three rules that cover
the controls in use: LinuxCNC's ``G64 P`` and most industrial look-ahead rounds a corner
within a tolerance; GRBL and Marlin leave the corner sharp and take it at the speed that a
rounding within the *junction deviation* would allow; others pass it at a fixed change of
velocity. Tangential and normal acceleration are limited one by one, not their vector sum,
as those controls do.

References: S. Jeon, "Improving Grbl: cornering algorithm" (2011) for the junction deviation;
[CS08] table 2 for the corner speed; [HQS24] table 2 for axis jerk.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np

from .model import Floats, PocketRequest

#: x, y, z
Axes = tuple[float, float, float]

_UNLIMITED: Axes = (np.inf, np.inf, np.inf)


class CornerRule(Enum):
    """How the control takes a corner."""

    BLENDING = "blending"  # rounded within a tolerance [mm]
    JUNCTION_DEVIATION = "junction deviation"  # sharp, as fast as a rounding within it [mm]
    CORNER_SPEED = "corner speed"  # sharp, a square corner at this speed [mm/s]


@dataclass(frozen=True, slots=True)
class Machine:
    """Limits of a machine tool and its control.

    Attributes
    ----------
    name : str
        As the machinist reads it.
    speed, acceleration : tuple of 3 float
        Of the axes x, y, z [mm/s], [mm/s2], positive.
    corner_rule : CornerRule
    corner_value : float
        Tolerance or deviation [mm], or speed of a square corner [mm/s]; positive.
    jerk : tuple of 3 float
        Of the axes [mm/s3]; infinite for a control that switches acceleration at once.
    path_speed, path_acceleration : float
        Limits along the path, whatever its direction [mm/s], [mm/s2].
    normal_acceleration : float or None
        Limit across the path in bends [mm/s2]; None where it is `acceleration`'s.
    start_overhead : float
        Until the first motion of a program [s].
    block_rate : float
        Moves that the control can take in each second [1/s].
    look_ahead : int
        Moves that it looks ahead; 0 for the whole program.

    Raises
    ------
    ValueError
        If a limit is not positive.
    """

    name: str
    speed: Axes
    acceleration: Axes
    corner_rule: CornerRule = CornerRule.BLENDING
    corner_value: float = 0.01
    jerk: Axes = _UNLIMITED
    path_speed: float = np.inf
    path_acceleration: float = np.inf
    normal_acceleration: float | None = None
    start_overhead: float = 0.0
    block_rate: float = np.inf
    look_ahead: int = 0

    def __post_init__(self) -> None:
        """Check the ranges."""
        for name in ("speed", "acceleration", "jerk"):
            values = getattr(self, name)
            if len(values) != 3 or not all(v > 0 for v in values):
                raise ValueError(f"{name} must be three positive numbers, got {values}")
        for name in ("path_speed", "path_acceleration", "corner_value", "block_rate"):
            if not getattr(self, name) > 0:
                raise ValueError(f"{name} must be positive, got {getattr(self, name)}")
        if self.normal_acceleration is not None and not self.normal_acceleration > 0:
            raise ValueError(f"normal_acceleration must be positive: {self.normal_acceleration}")
        for name in ("start_overhead", "look_ahead"):
            if getattr(self, name) < 0:
                raise ValueError(f"{name} must not be negative, got {getattr(self, name)}")

    @property
    def has_jerk_limit(self) -> bool:
        """Return whether acceleration takes time to build up."""
        return bool(np.isfinite(self.jerk).any())

    @property
    def flat_speed(self) -> float:
        """Return the speed that it reaches in every direction of the plane [mm/s]."""
        return min(*self.speed[:2], self.path_speed)

    def speed_along(self, directions: Floats) -> Floats:
        """Return the largest speed [mm/s] in each of `directions`, unit vectors (..., 3)."""
        return np.minimum(_along(directions, self.speed), self.path_speed)

    def acceleration_along(self, directions: Floats) -> Floats:
        """Return the largest acceleration [mm/s2] in each of `directions`, (..., 3)."""
        return np.minimum(_along(directions, self.acceleration), self.path_acceleration)

    def acceleration_across(self, normals: Floats) -> Floats:
        """Return the largest normal acceleration [mm/s2] towards each of `normals`, (..., 3)."""
        if self.normal_acceleration is not None:
            return np.full(normals.shape[:-1], self.normal_acceleration)
        return self.acceleration_along(normals)

    def jerk_along(self, directions: Floats) -> Floats:
        """Return the largest jerk [mm/s3] in each of `directions`, unit vectors (..., 3)."""
        return _along(directions, self.jerk)


#: When nothing is known about the machine.
MIDDLING = Machine("Middling", (200.0,) * 3, (1000.0,) * 3)


def machine_of(request: PocketRequest) -> Machine:
    """Return on which machine a request's time is to be least."""
    return request.machine or MIDDLING


def _along(directions: Floats, limits: Axes) -> Floats:
    """Return the largest length of a vector in each direction that keeps every axis' limit."""
    with np.errstate(divide="ignore", over="ignore"):
        x, y, z = (limit / np.abs(directions[..., i]) for i, limit in enumerate(limits))
    return np.minimum(np.minimum(x, y), z)
