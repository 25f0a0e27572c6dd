# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps that a flat cutter leaves on slanted walls.

Between two levels the wall recedes by the difference of what is free at the top of
the level and what the cutter may clear at its bottom. That ring stays, as high as the
level is deep: the stairs on the wall of [CS08] section 3.2, figure 20.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from ..levels import Level
from ..shapes.region import polygons_of, widest_disc
from ..shapes.shaping import rim_points

#: The rim of a step is looked at in places no farther apart than this [mm].
SPACING = 1.0
#: What reaches less far is rounding [mm].
ROUNDING = 1e-6


@dataclass(frozen=True, slots=True)
class WallStep:
    """The stock that stays between the wall and what is cleared.

    Attributes
    ----------
    width, height : float
        How far it reaches from what is cleared, and how high it stands [mm].
    place : tuple of float or None
        Where it is widest, (x, y) [mm].
    """

    width: float
    height: float
    place: tuple[float, float] | None


def largest_step(levels: Sequence[Level], least: float) -> WallStep:
    """Return the width of the widest and the height of the highest step.

    Parameters
    ----------
    levels : sequence of Level
    least : float
        Narrower ones do not count [mm].
    """
    steps = [step for step in map(step_of, levels) if step.width > least]
    if not steps:
        return WallStep(0.0, 0.0, None)
    widest = max(steps, key=lambda step: step.width)
    return WallStep(widest.width, max(step.height for step in steps), widest.place)


def step_of(level: Level) -> WallStep:
    """Return the step that stays on the walls of one level."""
    width, place = 0.0, None
    for piece in polygons_of(shapely.difference(level.mouth, level.pocket)):
        points, _ = rim_points(piece, SPACING)
        far = shapely.distance(shapely.points(points), level.pocket)
        worst = int(np.argmax(far))
        here, reach = (points[worst][0], points[worst][1]), float(far[worst])
        if reach < ROUNDING:  # all around it is cleared: the top of a low island
            here, reach = widest_disc(piece)
        if reach > width:
            width, place = reach, (float(here[0]), float(here[1]))
    return WallStep(width, level.top - level.bottom, place)
