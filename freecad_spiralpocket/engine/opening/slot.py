# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way down along a slot: flat levels joined by short ramps.

It runs round a closed ring, the wall or a racetrack about the curve that it opens; one such loop
is one level, and the last runs on over its own ramp [EAS07's cure for the full slot, flat instead
of trochoidal: on machines of ordinary acceleration that is several times faster]. With stairs
(stairs.py) each loop has its own line.
"""

from __future__ import annotations

import math

import numpy as np
from shapely import Point

from ..floor import Descent, Slot, Stairs
from ..model import Floats, PocketRequest
from ..numerics.distinct import distinct
from ..shapes.drawing_near import s_curve
from ..shapes.points import distances_along
from ..shapes.polyline import closed_line, points_at

#: A level is thin that is no deeper than this over the deepest: what fewer loops leave beside them
#: is no more than a lap may take at the full depth.
THIN = 0.7
#: A way from one line of stairs to the next, over how far that is.
ASIDE = 2.5


def slot_end(slot: Slot, asked: tuple[float, float], request: PocketRequest) -> float:
    """Return where along its ring a slot must end to begin nearest to a place [mm].

    Parameters
    ----------
    slot : Slot
    asked : tuple of float
        [mm]
    request : PocketRequest
        For the depth of its first level, nearly, and the ramp's angle.
    """
    ring = closed_line(slot.ring)
    down = Descent(request.axial_depth, 0.0, request.entry.helix_angle)
    return float((ring.project(Point(asked)) + slot_lead(slot, down)) % ring.length)


def slot_lead(slot: Slot, down: Descent) -> float:
    """Return how far before its ring's first point a slot begins, but for whole turns [mm].

    And but for what its first loop is longer (`Slot.ahead`).
    """
    _, ramps, _, asides = _loops(slot, down)
    return float(ramps[0] + asides.sum())


def slot_levels(slot: Slot, angle: float, depth: float) -> int:
    """Return in how many levels a slot of some depth is cut.

    No ramp is longer than once round it: about a short one there are more levels than its bite asks
    for, until all of it is ramp. Stairs are made for the deepest level of a pocket; in a thin one
    the last of its loops do, as many as it has bites.
    """
    if slot.stairs is not None:
        drops = slot.stairs.drops
        if depth * drops[0] > THIN * slot.bite:  # all but the last are a bite deep
            return len(drops)
        return max(1, math.ceil(depth / slot.bite - 1e-9))
    bite = min(slot.bite, closed_line(slot.ring).length * math.tan(angle))
    return max(1, math.ceil(depth / bite - 1e-9))


def slot_path(slot: Slot, down: Descent) -> Floats:
    """Return the loops of a slot, shape (n, 3) [mm].

    Each begins with a ramp along the line of the one above, and goes on to its own line until it
    meets itself there, or the next ramp takes over; the first may be longer (`Slot.ahead`). After
    the last one of stairs it goes on to the line from which laps begin.
    """
    ring = closed_line(slot.ring)
    corners, length = distances_along(ring.coords), ring.length
    drops, ramps, lines, asides = _loops(slot, down)
    spans = ramps + asides[:-1] + length - np.append(ramps[1:], 0.0)
    spans[0] += slot.ahead
    begins = np.cumsum(spans) - spans - spans.sum() - asides[-1]
    knees = begins + ramps
    turns = np.arange(math.floor(begins[0] / length), 1)
    stops = (corners[None, :] + length * turns[:, None]).ravel()
    s = distinct(np.round(np.concatenate([stops, begins, knees, [0.0]]), 9))
    s = s[(s > begins[0] - 1e-6) & (s <= 0.0)]
    floors = down.top - np.cumsum(drops)
    bounds = np.column_stack([begins, knees]).ravel()
    heights = np.interp(s, bounds, np.column_stack([floors + drops, floors]).ravel())
    if len(lines) == 1:
        points = points_at(ring, s % length)
        if slot.wall is not None:
            last = s >= knees[-1]
            points[last] = beside(slot.wall, corners, s[last] % length)
        return np.column_stack([points, heights])
    line = np.zeros(len(s))  # on which line, or between which two
    for begin, aside in zip(np.append(knees[1:], -asides[-1]), asides[1:], strict=True):
        line += s_curve((s - begin) / max(aside, 1e-9))
    points = np.zeros((len(s), 2))
    for number, line_points in enumerate(lines):
        share = np.maximum(1 - np.abs(line - number), 0.0)
        on = np.flatnonzero(share)
        points[on] += share[on, None] * beside(line_points, corners, s[on] % length)
    return np.column_stack([points, heights])


def ways_aside(stairs: Stairs) -> Floats:
    """Return how long the way onto each line of stairs is, and that to the inner line, (k + 1,)."""
    lines = np.concatenate([stairs.lines[:1], stairs.lines, stairs.inner[None]])
    off = np.hypot(*np.moveaxis(np.diff(lines, axis=0), 2, 0)).max(axis=1)
    return np.asarray(ASIDE * off)


def _loops(slot: Slot, down: Descent) -> tuple[Floats, Floats, Floats, Floats]:
    """Return what makes the loops of a slot.

    Returns
    -------
    drops, ramps : ndarray of shape (k,)
        How much deeper each of the loops is than the one above, and how long its ramp is [mm].
    lines : ndarray of shape (k + 1, n, 2)
        Where they run, and where laps go on from; only the ring without stairs [mm].
    asides : ndarray of shape (k + 1,)
        How long the ways onto these lines are [mm].
    """
    loops = slot_levels(slot, down.angle, down.depth)
    drops, lines, asides = np.full(loops, down.depth / loops), slot.ring[None], np.zeros(loops + 1)
    stairs = slot.stairs
    if stairs is None:
        return drops, drops / math.tan(down.angle), lines, asides
    lines = np.concatenate([stairs.lines[-loops:], stairs.inner[None]])
    asides[1:] = ways_aside(stairs)[-loops:]
    if loops == len(stairs.drops):
        drops = down.depth * stairs.drops
    ramps = drops / math.tan(down.angle)
    places = [0.0] if slot.ahead == 0.0 else [0.0, -float(ramps[0] + asides.sum()) - slot.ahead]
    return drops, ramps * _stretch(lines[0], slot.ring, places, ramps[0]), lines, asides


def beside(line: Floats, along: Floats, at: Floats) -> Floats:
    """Return the points of a closed line beside places along the ring.

    Its points, of which the first is not repeated, are beside the places `along` it, the last of
    which is the first again.
    """
    closed = np.vstack([line, line[:1]])
    return np.column_stack([np.interp(at, along, column) for column in closed.T])


def _stretch(line: Floats, ring: Floats, places: list[float], length: float) -> float:
    """Return by how much a ring is longer than a line within it, where slots begin and end.

    Looked at over `length` to both sides of some places along the ring [mm].
    """
    along = distances_along(np.vstack([ring, ring[:1]]))
    around = along[-1]
    off = (along[:-1, None] - np.asarray(places) + around / 2) % around - around / 2
    steps = [np.hypot(*(np.roll(points, -1, axis=0) - points).T) for points in (ring, line)]
    return max(
        1.0, *(steps[0][near].sum() / steps[1][near].sum() for near in (np.abs(off) < length).T)
    )
