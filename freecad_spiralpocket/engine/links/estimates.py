# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a way to cut a region takes on the machine, told before it becomes moves."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from shapely import LineString

from ..floor import Descent, Groove, Helix, Plunge
from ..growth.strokes import Stroke
from ..machine import machine_of
from ..model import Floats, PocketRequest
from ..motion.timing import polyline_seconds
from ..opening.groove import groove_path
from ..opening.slot import slot_levels, slot_path
from ..opening.start import Start
from .linking import Motion, link_times
from .ordering import Step

#: Links avoid tighter bends than this, over R.
LEAST_RADIUS = 0.12
#: A lift, over and down again takes about so long [s].
LIFT_SECONDS = 3.0


def motion_of(request: PocketRequest) -> Motion:
    """Return what limits the motion between cuts on the request's machine."""
    machine = machine_of(request)
    link = min(request.link_feed, machine.flat_speed)
    cut = min(request.feeds.horizontal, machine.flat_speed)
    least_radius = LEAST_RADIUS * request.cutter_radius
    acceleration = min(*machine.acceleration[:2], machine.path_acceleration)
    return Motion(acceleration, link, cut, least_radius)


def seconds_of(steps: Sequence[Step], request: PocketRequest, motion: Motion) -> float:
    """Return how long cuts and links take, at the last level [s]."""
    cuts = sum(way_seconds(step.points, request, motion) for step in steps)
    return cuts + link_seconds(steps, motion)


def link_seconds(steps: Sequence[Step], motion: Motion) -> float:
    """Return how long the links and lifts before steps take [s]."""
    total = 0.0
    for step in steps:
        if step.link is None:
            total += LIFT_SECONDS
        elif len(step.link):
            total += float(link_times(step.link[None], motion)[0])
    return total


def way_seconds(points: Floats, request: PocketRequest, motion: Motion) -> float:
    """Return how long a way takes at the cutting feed, from and to full speed [s]."""
    feed, machine = motion.cut_feed, machine_of(request)
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    return float(polyline_seconds(points, feed, machine, feed, feed))


def entry_seconds(start: Start, request: PocketRequest, motion: Motion) -> float:
    """Return how long the way down takes [s]."""
    entry, angle, depth = start.entry, request.entry.helix_angle, request.axial_depth
    if isinstance(entry, Plunge):
        return depth / request.feeds.vertical
    ring = shapely.get_coordinates(start.ring)
    once = way_seconds(ring, request, motion)
    if isinstance(entry, Helix):
        return (depth / math.tan(angle) / start.ring.length + 1) * once
    down = Descent(depth, 0.0, angle)
    if isinstance(entry, Groove):
        return way_seconds(groove_path(entry, down), request, motion)
    if entry.stairs is not None:
        return way_seconds(slot_path(entry, down), request, motion)
    levels = slot_levels(entry, angle, depth)
    last = once
    if entry.wall is not None:
        last = way_seconds(np.vstack([entry.wall, entry.wall[:1]]), request, motion)
    return (levels - 1) * once + last + depth / levels / math.tan(angle) / motion.cut_feed


def least_seconds(strokes: list[Stroke], motion: Motion) -> float:
    """Return how long strokes and the links between them take at least [s].

    An open stroke ends where it may go no farther, and all are cut the same way about: from one
    to the next the cutter turns back, in half a circle as tight as the machine allows.
    """
    cuts = sum(LineString(s.points).length for s in strokes) / motion.cut_feed
    turns = sum(not s.closed for s in strokes) * math.pi * motion.cut_feed / motion.acceleration
    return cuts + turns
