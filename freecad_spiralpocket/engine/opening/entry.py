# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way down: a helix or a slot opened in shallow levels, or straight down beside the stock.

The radius of the helix' circle is at most nearly the cutter's, so that no post
remains in the middle; as wide as fits otherwise, because a wide helix sinks more
per turn at the same ramp angle. It starts at just the angle that makes it end,
after whole and part turns and one flat one, where the spiral begins.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from shapely import Point, Polygon

from ..errors import CutterDoesNotFitError, Place
from ..floor import Descent, Groove, Helix, Plunge, WayDown
from ..model import Entry, Feeds, Floats
from ..toolpath import Role, ToolpathBuilder
from .groove import groove_path
from .slot import slot_path

#: Radius of the cutter center's circle over R at most: nearly R, and surely no post left.
WIDEST = 0.94
#: The same at least: below it the helix is a plunge, and so is a slot round no more.
NARROWEST = 0.05
#: The way down begins this far above the stock [mm].
APPROACH = 0.5
#: Slopes that differ by less than this share of the ramp's are one.
SAME_SLOPE = 0.01


class NoRoomForHelixError(CutterDoesNotFitError):
    """The cutter fits, but has no room to go down.

    Parameters
    ----------
    cutter_radius, radius, room : float
        R, radius of the helix that there is room for, and of the cutter's center [mm].
    place : tuple of float
        (x, y) [mm].
    is_limited : bool, optional
        Whether the helix is kept narrower than there is room for.
    """

    def __init__(
        self,
        cutter_radius: float,
        radius: float,
        room: float,
        place: Place,
        is_limited: bool = False,
    ) -> None:
        super().__init__(
            f"The {2 * cutter_radius:g} mm cutter fits the pocket, but has no room for its helix "
            f"at {{at}} (circle of {2 * radius:.3g} mm).",
            "Raise HelixDiameterLimit."
            if is_limited
            else f"Take a cutter below {2 * (cutter_radius + room) / (1 + NARROWEST):.3g} mm.",
            place,
        )
        self._sizes = np.array([cutter_radius, radius, room])
        self._is_limited = is_limited

    def __reduce__(self) -> tuple[Any, ...]:
        """Let it be made anew on the other side of a pipe."""
        return type(self), (*self._sizes.tolist(), self.place, self._is_limited)

    def labelled(self, label: str) -> CutterDoesNotFitError:
        """Return the error as that of the pocket with a label."""
        return CutterDoesNotFitError(f"{label}: {self.message}", self.hint, self.place)

    def resized(self, factor: float) -> NoRoomForHelixError:
        """Return the same of a pocket of another size."""
        assert self.place is not None
        r, radius, room = (factor * self._sizes).tolist()
        x, y = self.place
        return NoRoomForHelixError(r, radius, room, (factor * x, factor * y), self._is_limited)


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
        is_limited = room >= NARROWEST * cutter_radius
        place = float(center[0]), float(center[1])
        raise NoRoomForHelixError(cutter_radius, radius, room, place, is_limited)
    return radius


def ramp_feed(feeds: Feeds, angle: float) -> float:
    """Return the feed along a ramp of `angle` [rad] that keeps both feeds [mm/s]."""
    return min(feeds.horizontal, feeds.vertical / math.sin(angle))


def entry_start(entry: WayDown, down: Descent) -> Floats:
    """Return above which place a way down begins, (x, y) [mm]."""
    if isinstance(entry, Helix):
        return _on_circle(entry, entry.start_angle - _helix_sweep(entry, down))
    if isinstance(entry, Groove):
        return groove_path(entry, down)[0, :2]
    if isinstance(entry, Plunge):
        return entry.place
    return slot_path(entry, down)[0, :2]


def cut_entry(
    builder: ToolpathBuilder, entry: WayDown, down: Descent, feeds: Feeds, slack: float
) -> None:
    """Add a way down, beginning above `entry_start`.

    Parameters
    ----------
    builder : ToolpathBuilder
    entry : WayDown
    down : Descent
    feeds : Feeds
    slack : float
        Arcs keep within this of the flat parts that they replace [mm].
    """
    if isinstance(entry, Helix):
        _cut_helix(builder, entry, down, feeds)
    elif isinstance(entry, Groove):
        _cut_points(builder, groove_path(entry, down), down.angle, feeds, slack)
    elif isinstance(entry, Plunge):
        # fed all the way: the edge of the stock may be off by more than the cutter keeps from it
        builder.line((*entry.place, down.bottom), feeds.vertical, Role.ENTRY)
    else:
        _cut_points(builder, slot_path(entry, down), down.angle, feeds, slack)


def _on_circle(helix: Helix, angle: float) -> Floats:
    return helix.center + helix.radius * np.array([math.cos(angle), math.sin(angle)])


def _helix_sweep(helix: Helix, down: Descent) -> float:
    """Return the turning of the helix, which begins `APPROACH` above the top [rad]."""
    return (down.top + APPROACH - down.bottom) / (helix.radius * math.tan(down.angle))


def _cut_helix(builder: ToolpathBuilder, helix: Helix, down: Descent, feeds: Feeds) -> None:
    """Add the helix and its flat turn, in arcs of half a turn at most."""
    begin = builder.here[2]
    x, y = entry_start(helix, down)
    builder.line((x, y, begin), feeds.vertical, Role.ENTRY)
    sweep = _helix_sweep(helix, down)
    at, high = helix.start_angle - sweep, down.top + APPROACH
    arcs = max(1, math.ceil(sweep / math.pi - 1e-9))
    feed = ramp_feed(feeds, down.angle)

    def turn(to: float, z: float, at_feed: float) -> None:
        px, py = _on_circle(helix, to)
        builder.arc((px, py, z), helix.center, True, at_feed, Role.ENTRY)

    for i in range(1, arcs + 1):
        z = high + (down.bottom - high) * i / arcs
        turn(at + sweep * i / arcs, min(z, begin), feed)
    turn(helix.start_angle + math.pi, down.bottom, feeds.horizontal)
    turn(helix.start_angle + 2 * math.pi, down.bottom, feeds.horizontal)


def _cut_points(
    builder: ToolpathBuilder, path: Floats, angle: float, feeds: Feeds, slack: float
) -> None:
    """Go down onto the first point of a path and along it, in lines and arcs."""
    x, y, z = path[0].tolist()
    builder.line((x, y, z), feeds.vertical, Role.ENTRY)
    steep = ramp_feed(feeds, angle)
    steps = np.diff(path, axis=0)
    slopes = steps[:, 2] / (np.hypot(steps[:, 0], steps[:, 1]) + 1e-12)
    same = SAME_SLOPE * math.tan(angle)
    edges = np.flatnonzero(np.abs(np.diff(slopes)) > same) + 1
    for run in np.split(np.arange(1, len(path)), edges):
        is_flat = abs(slopes[run[0] - 1]) < same
        builder.along_slope(path[run], feeds.horizontal if is_flat else steep, Role.ENTRY, slack)
