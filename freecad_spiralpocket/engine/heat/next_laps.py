# SPDX-License-Identifier: LGPL-2.1-or-later
"""The next laps inwards: the hottest isotherms of which no point of the lap before is farther.

Farther than the step-over, that is [HQS24, eq. 10]. About a slot that is kept hot there is one
lap, or several where isotherms part; about summits slots take the place of laps that would creep.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from shapely import Polygon

from ..errors import NotYetError
from ..model import Floats
from .family import Enclosed, Family, distances, from_lines, points_of
from .isotherm_slots import core_share, pays, slots_for
from .isotherms import isotherms, lines_at, rooms_at, slack
from .nested import Lap

#: Steps of the search for the next isotherm. It begins with this share of the temperature left, and
#: ends where the distance is this close to the step-over; distances are measured from every so
#: many points of a lap.
BISECTIONS, FIRST_SHARE, CLOSE, THINNED = 14, 0.08, 0.97, 5
#: Refitted laps may be farther apart by this factor.
REFITTED = 1.02
#: A step after which laps are too far apart is made shorter by this until they are not: each is
#: refitted, which takes long.
LESS = 0.95
#: A step of less than this share of the temperature left is no step.
LEAST_STEP = 2e-3
#: Below this share laps may creep along a neck; there these steps are tried with slots.
SLOW = 0.03
NECK_STEPS = (0.5, 0.35, 0.25, 0.17, 0.12, 0.08, 0.05, 0.03, 0.02, 0.01, 0.005)
#: Steps of less than this share are none where a slot is kept hot.
LEAST_HOT = 1e-4


def holds(region: Polygon, hot: Polygon) -> bool:
    """Return whether a region has the hot slot inside."""
    return bool(region.contains(hot.representative_point()))


def rooms_about(family: Family, hot: Polygon, room: Enclosed, points: Floats) -> list[Enclosed]:
    """Return the rooms inside of the next laps about the hot slot; none if these are no guide.

    `points` are those of the room's lap.
    """

    def level(share: float) -> float:
        return room.level + share * (family.heat - room.level)

    def farthest(share: float) -> float:
        return float(from_lines(points[::THINNED], lines_at(family, room, level(share))).max())

    def off_laps(share: float) -> float:
        parts = isotherms(family, room, level(share))
        if family.is_even:
            parts = [part for part in parts if holds(part, hot)]
        return float(distances(points[::THINNED], parts).max())

    share = _largest(farthest, family.stepover)
    while share > LEAST_HOT:
        rooms = rooms_at(family, room, level(share))
        if family.is_even:  # others are on no way to the slot, and thin
            rooms = [one for one in rooms if holds(one.region, hot)]
        if distances(points, [r.region for r in rooms]).max() <= REFITTED * family.stepover:
            return rooms
        share *= LESS
        # refitting takes long; no refitted lap is as much nearer
        while share > LEAST_HOT and off_laps(share) > REFITTED * family.stepover + slack(family):
            share *= LESS
    return []


def inner_rooms(family: Family, room: Enclosed) -> tuple[list[Enclosed], list[Lap]]:
    """Return the rooms inside of the next laps, the hottest last, and slots for what they leave.

    Raises
    ------
    NotYetError
        If neither laps nor slots lead on.
    """
    _, hottest = room.peak(family.field)

    def level(share: float) -> float:
        return room.level + share * (hottest - room.level)

    points = points_of(room.region)
    some = points[::THINNED]

    def farthest(share: float) -> float:
        return float(from_lines(some, lines_at(family, room, level(share))).max())

    low = _largest(farthest, family.stepover)
    if low < SLOW:
        for share in NECK_STEPS:
            lines = isotherms(family, room, level(share))
            if low > LEAST_STEP and not pays(family, distances(some, lines).max()):
                break
            slots = slots_for(family, room, lines, must_pay=low > LEAST_STEP)
            if slots:
                return rooms_at(family, room, level(share)), slots
    low = core_share(family, room, low, hottest)
    while low > LEAST_STEP:
        rooms = rooms_at(family, room, level(low))
        if distances(points, [r.region for r in rooms]).max() <= REFITTED * family.stepover:
            return rooms, []
        low *= LESS
    for share in NECK_STEPS:
        lines = isotherms(family, room, level(share))
        slots = slots_for(family, room, lines, must_pay=False, any_shape=True)
        if slots:
            return rooms_at(family, room, level(share)), slots
    off = distances(points, isotherms(family, room, level(LEAST_STEP)))
    x, y = points[int(np.argmax(off))]
    raise NotYetError(
        "The pocket is too narrow at {at} for Isotherm: no isotherm leads through.",
        "Take a smaller cutter or the strategy Automatic.",
        (float(x), float(y)),
    )


def _largest(distance: Callable[[float], float], most: float) -> float:
    """Return the largest share in ``(0, 1)`` whose distance is at most `most`, nearly.

    The distance rises with the share, from 0: about as its square root or evenly.
    """
    low, high, near = 0.0, 1.0, 0.0
    guess = FIRST_SHARE
    for _ in range(BISECTIONS):
        far = distance(guess)
        if far <= most:
            low, near = guess, far
            if far >= CLOSE * most:
                break
            ahead = guess * min((most / max(far, 1e-9)) ** 1.5, 8.0)
            guess = min(ahead, (low + high) / 2) if high < 1.0 else min(ahead, (low + 1) / 2)
        else:
            high = guess
            guess = low + (high - low) * max(0.1, min(0.7, (most - near) / (far - near)))
    return low
