# SPDX-License-Identifier: LGPL-2.1-or-later
"""A slot barely wider than the cutter, opened forth and back in flat levels.

The cutter goes round a slim ring about a line, or about a tree of lines. On the way
out of a branch's foot it takes one level, on the way back the next, so that no pass
runs in air. At every tip it goes down on a slim loop as long as the ramp
angle needs: nowhere does more stand ahead of it than one level's bite. Against
a racetrack of nearly two diameters this leaves half of the width to the spiral, which
removes it at the full depth and therefore faster [another cure for EAS07's full slot].
"""

from __future__ import annotations

import math

import numpy as np
from shapely import LineString

from ..floor import Descent, Groove
from ..model import Floats
from ..shapes.points import distances_along
from ..shapes.polyline import between, closed_line

#: Chords of half a turn.
CHORDS = 10
#: A loop keeps within this share of its branch.
ROOM = 0.8
#: Between two branches the cutter rises by one level over so much, over the bite.
RISE = 2.0


def groove_levels(groove: Groove, depth: float) -> int:
    """Return how many passes open the groove to a depth [mm].

    About a tree every branch is left by the way it was entered: an even number.
    """
    count = max(1, math.ceil(depth / groove.bite - 1e-9))
    return count if len(groove.tips) == 1 else count + count % 2


def groove_path(groove: Groove, down: Descent) -> Floats:
    """Return the way of the cutter's center, shape (n, 3) [mm].

    It ends at the ring's first point, at the bottom.

    Parameters
    ----------
    groove : Groove
    down : Descent
    """
    count = groove_levels(groove, down.depth)
    bite = down.depth / count
    ring = closed_line(groove.ring)
    tips = [0.0, *groove.tips, ring.length]
    feet = groove.feet  # behind each tip but the first and the last
    rooms = loop_rooms(groove, ring.length)
    first = count % 2  # an odd number of passes along a line begins at its far end
    pieces = []
    level = 0
    while level < count:
        for i in range(first, len(tips) - 1):
            last = i == len(tips) - 2
            pieces.append(_ramp(ring, tips[i], rooms[i], bite, down.angle, down.top - bite * level))
            level += 1
            z = down.top - bite * level
            if last or i == 0:
                pieces.append(_flat(ring, tips[i], tips[i + 1], z))
            else:
                foot, risen = feet[i - 1], feet[i - 1] + RISE * bite
                pieces.append(_flat(ring, tips[i], foot, z))
                pieces.append(_sloped(between(ring, foot, risen - foot), z, z + bite))
                level -= 1
                pieces.append(_flat(ring, risen, tips[i + 1], z + bite))
        first = 0
    path = np.vstack(pieces)
    moved = np.abs(np.diff(path, axis=0)).max(axis=1) > 1e-9
    return path[np.concatenate([[True], moved])]


def _flat(ring: LineString, start: float, end: float, z: float) -> Floats:
    points = between(ring, start, end - start)
    return np.column_stack([points, np.full(len(points), z)])


def loop_rooms(groove: Groove, length: float) -> list[float]:
    """Return how far a loop may go on both sides of each tip, the ring's beginning first [mm].

    Up to near the foot of its branch, along a line up to near the other tip.
    """
    if len(groove.tips) == 1:
        return [ROOM * groove.trunk] * 2
    rooms = [groove.trunk]
    # the foot on one side at least is that of the tip's own branch
    bounds = [0.0, *groove.feet, length]
    for i, tip in enumerate(groove.tips):
        rooms.append(min(tip - bounds[i], bounds[i + 1] - tip))
    return [ROOM * room for room in rooms]


def _ramp(
    ring: LineString, tip: float, room: float, fall: float, angle: float, high: float
) -> Floats:
    """Return slim loops about a tip of the ring, out and back to it, down by `fall`.

    As many as the ramp angle needs where one may not go farther than `room`.
    """
    needed = fall / math.tan(angle) / 2
    loops = math.ceil(needed / room - 1e-9)
    reach = needed / loops
    out, back = between(ring, tip, reach), between(ring, tip - reach, reach)
    loop = np.vstack([out, _turn(out[-1], back[0], out[-1] - out[-2])[1:-1], back])
    return _sloped(np.vstack([loop] * loops), high, high - fall)


def _sloped(points: Floats, start: float, end: float) -> Floats:
    """Return points with their heights, even from `start` to `end`."""
    along = distances_along(points)
    return np.column_stack([points, start + (end - start) * along / along[-1]])


def _turn(start: Floats, end: Floats, ahead: Floats) -> Floats:
    """Return half a turn to the left from `start` to `end`, bulging `ahead`."""
    center, arm = (start + end) / 2, (start - end) / 2
    ahead = ahead / np.hypot(*ahead) * np.hypot(*arm)
    phi = np.linspace(0.0, math.pi, CHORDS + 1)[:, None]
    return center + np.cos(phi) * arm + np.sin(phi) * ahead
