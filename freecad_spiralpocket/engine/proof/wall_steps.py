# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps that a flat cutter leaves on slanted walls.

Between two levels the wall recedes by the difference of what is free at the top of
the level and what the cutter may clear at its bottom. That ring stays, as high as the
level is deep: the stairs on the wall of [CS08] section 3.2, figure 20.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import Polygon

from ..levels import Level
from ..shapes.region import grow, polygons_of, widest_disc
from ..shapes.shaping import rim_points

#: The rim of a step is looked at in places no farther apart than this [mm].
SPACING = 1.0
#: What the cutter clears no more of than this share is a notch.
NOTCH = 0.5
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


def largest_step(levels: Sequence[Level], least: float, inset: float = 0.0) -> WallStep:
    """Return the width of the widest and the height of the highest step.

    Parameters
    ----------
    levels : sequence of Level
    least : float
        Narrower ones do not count [mm].
    inset : float
        How far the cutter's center keeps off the walls [mm]; notches do not count.
    """
    steps = [step for step in (step_of(level, inset) for level in levels) if step.width > least]
    if not steps:
        return WallStep(0.0, 0.0, None)
    widest = max(steps, key=lambda step: step.width)
    return WallStep(widest.width, max(step.height for step in steps), widest.place)


def notches(levels: Sequence[Level], inset: float) -> list[Polygon]:
    """Return the notches of all levels: no StepDown brings the cutter into these.

    Without those that are seen at the bottom of a higher level: they are told with its necks.
    """
    return [
        piece
        for level, above in zip(levels, [None, *levels], strict=False)
        for piece, is_notch in _left(level, inset)
        if is_notch and not (above and above.pocket.intersection(piece).area > piece.area / 2)
    ]


def _left(level: Level, inset: float) -> Iterator[tuple[Polygon, bool]]:
    """Yield what stays beside the ground of a level, and whether it is a notch.

    Most of a notch is not cleared at the height of its mouth either.
    """
    if level.mouth is level.pocket:
        return
    reached = grow(grow(level.mouth, -inset), inset)
    for piece in polygons_of(shapely.difference(level.mouth, level.pocket)):
        cleared = shapely.intersection(piece, reached).area
        yield piece, inset > 0 and cleared <= NOTCH * piece.area


def step_of(level: Level, inset: float = 0.0) -> WallStep:
    """Return the step that stays on the walls of one level, but for notches."""
    width, place = 0.0, None
    for piece, is_notch in _left(level, inset):
        if is_notch:
            continue
        points, _ = rim_points(piece, SPACING)
        far = shapely.distance(shapely.points(points), level.pocket)
        worst = int(np.argmax(far))
        here, reach = (points[worst][0], points[worst][1]), float(far[worst])
        if reach < ROUNDING:  # all around it is cleared: the top of a low island
            here, reach = widest_disc(piece)
        if reach > width:
            width, place = reach, (float(here[0]), float(here[1]))
    return WallStep(width, level.top - level.bottom, place)
