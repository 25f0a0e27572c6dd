# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a slot along the wall ends best: where most of the laps that follow it follow each other.

A spiral goes on to the next lap where that is near. Where the slot ends is chosen before the laps
are known, beside the middle of the plug; once they are known another place may take more of them,
or all, in one spiral, and spare a link or two.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from shapely import LineString, Point

from ..floor import Slot, Stairs
from ..growth.spiral import BLEND
from ..growth.stroke_runs import first_laps, followed
from ..growth.strokes import Stroke
from ..model import Floats, PocketRequest
from ..numerics.distinct import distinct
from ..shapes.points import distances_along
from ..shapes.polyline import closed_line, points_at
from .leaving import STRAIGHT, bends
from .slot import beside
from .start import Start

#: Distance of places that are looked at, over R.
APART = 0.5


def well_ended(start: Start, strokes: Sequence[Stroke], request: PocketRequest) -> Start:
    """Return a slot along the wall that ends where most of its laps follow each other.

    Parameters
    ----------
    start : Start
    strokes : sequence of Stroke
        What is cut after it.
    request : PocketRequest
        Where a start point is asked for, nothing is moved.
    """
    radius, stepover = request.cutter_radius, request.cutting.stepover
    if start.within is None or request.start_point is not None:
        return start
    laps = first_laps(strokes, start.ring, radius, stepover)
    if len(laps) < 2:
        return start
    ring = start.ring
    places = np.arange(0.0, ring.length, APART * radius)  # the first is where it ends now
    zone = BLEND * radius
    bent = bends(ring, places - zone / 4, 1.5 * zone)
    places = places[bent <= max(STRAIGHT, float(bent[0]))]
    counts = followed(ring, places, laps, radius, stepover)
    best = np.flatnonzero(counts == counts.max())
    if best[0] == 0:
        return start
    away = np.minimum(places[best], ring.length - places[best])
    place = float(places[best[np.argmin(away)]])
    return ended_at(start, points_at(ring, np.array([place]))[0])


def ended_at(start: Start, place: Floats) -> Start:
    """Return a slot along the wall that ends where it is nearest to a place.

    Parameters
    ----------
    start : Start
        Its entry is a slot.
    place : ndarray of shape (2,)
        [mm]
    """
    slot = start.entry
    assert isinstance(slot, Slot)
    plain = None if start.plain is None else ended_at(start.plain, place)
    along = distances_along(np.vstack([slot.ring, slot.ring[:1]]))
    length = along[-1]
    inner = slot.ring if slot.stairs is None else slot.stairs.inner
    at = _beside_ring(closed_line(inner), along, place)
    stops = distinct(np.append((along[:-1] - at) % length, 0.0))

    def turned(line: Floats) -> Floats:
        return beside(line, along, (stops + at) % length)

    stairs = slot.stairs
    if stairs is not None:
        lines = np.stack([turned(line) for line in stairs.lines])
        stairs = Stairs(lines, stairs.drops, turned(stairs.inner))
    wall = None if slot.wall is None else turned(slot.wall)
    entry = Slot(turned(slot.ring), slot.bite, stairs, wall)
    inner = entry.ring if stairs is None else stairs.inner
    ring = closed_line(np.vstack([inner[:1], inner[:0:-1]]))
    return replace(start, entry=entry, ring=ring, plain=plain)


def _beside_ring(line: LineString, along: Floats, place: Floats) -> float:
    """Return beside which place along the ring a line is nearest to a place [mm]."""
    own = distances_along(np.asarray(line.coords))
    return float(np.interp(line.project(Point(place)), own, along))
