# SPDX-License-Identifier: LGPL-2.1-or-later
"""The helical entry: down into solid stock at a ramp angle, then one flat turn.

The cutter center's circle is at most as wide as the cutter's radius, so that
no post remains in the middle; as wide as fits otherwise, because a wide helix
sinks more per turn at the same ramp angle. It starts at just the angle that
makes it end, after whole and part turns, where the spiral begins.
"""

from __future__ import annotations

import math

import numpy as np
from shapely import Point, Polygon

from .errors import CutterDoesNotFitError
from .model import Entry, Feeds, Floats, Helix
from .toolpath import Role, ToolpathBuilder

#: Radius of the cutter center's circle over R at most: nearly R, and surely no post left.
WIDEST = 0.94
#: The same at least: below it the helix is a plunge.
NARROWEST = 0.05
#: The helix begins this far above the stock [mm].
APPROACH = 0.5


def fit_helix_radius(region: Polygon, center: Floats, cutter_radius: float, entry: Entry) -> float:
    """Return the radius of the widest helix about `center` [mm].

    Parameters
    ----------
    region : shapely.Polygon
        The cutter-center region.
    center : ndarray of shape (2,)
        Inside `region` [mm].
    cutter_radius : float
        R [mm].
    entry : Entry

    Raises
    ------
    CutterDoesNotFitError
        If there is no room to go down.
    """
    room = region.boundary.distance(Point(center))
    radius = min(WIDEST * cutter_radius, room)
    if entry.max_diameter > 0:
        radius = min(radius, entry.max_diameter / 2)
    if radius < NARROWEST * cutter_radius:
        raise CutterDoesNotFitError(
            f"The {2 * cutter_radius:g} mm cutter fits the pocket, but has no room for its helix "
            f"at {{at}} (circle of {2 * radius:.3g} mm).",
            f"Take a cutter below {2 * (cutter_radius + room) / (1 + NARROWEST):.3g} mm, or raise "
            "HelixDiameterLimit if it is set.",
            (center[0], center[1]),
        )
    return radius


def ramp_feed(feeds: Feeds, angle: float) -> float:
    """Return the feed along a ramp of `angle` [rad] that keeps both feeds [mm/s]."""
    return min(feeds.horizontal, feeds.vertical / math.sin(angle))


def helix_start(helix: Helix, angle: float, top: float, bottom: float) -> Floats:
    """Return where the helix from `top` down to `bottom` begins, (x, y) [mm]."""
    sweep = (top - bottom) / (helix.radius * math.tan(angle))
    at = helix.start_angle - sweep
    return helix.center + helix.radius * np.array([math.cos(at), math.sin(at)])


def cut_helix(
    builder: ToolpathBuilder, helix: Helix, angle: float, bottom: float, feeds: Feeds
) -> None:
    """Add the helix from where the builder is down to `bottom`, and its flat turn.

    Counter-clockwise, in arcs of half a turn at most.
    """
    x, y, top = builder.here
    at = math.atan2(y - helix.center[1], x - helix.center[0])
    sweep = (top - bottom) / (helix.radius * math.tan(angle))
    arcs = max(1, math.ceil(sweep / math.pi - 1e-9))
    feed = ramp_feed(feeds, angle)

    def turn(to: float, z: float, at_feed: float) -> None:
        px, py = helix.center + helix.radius * np.array([math.cos(to), math.sin(to)])
        builder.arc((px, py, z), helix.center, True, at_feed, Role.ENTRY)

    for i in range(1, arcs + 1):
        turn(at + sweep * i / arcs, top + (bottom - top) * i / arcs, feed)
    turn(at + sweep + math.pi, bottom, feeds.horizontal)
    turn(at + sweep + 2 * math.pi, bottom, feeds.horizontal)
