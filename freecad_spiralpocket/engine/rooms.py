# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the levels to rooms: the cutter-center regions of each level, in cutting order.

A room lies wholly under one room of the level above, because the free sections of a
pocket are nested. So rooms form trees; a room is cut with everything below it before
its neighbor is begun. Where the cutter goes down into a room, all ground above has
been cleared by the room above. Where walls lean, a room may split on the way down and
islands may rise in it; where they are vertical it is the same region at every level.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from shapely import Point, Polygon

from .errors import CutterDoesNotFitError
from .levels import Level
from .model import Notice
from .necks import unreachable_notices
from .shapes.region import center_regions


@dataclass(frozen=True, slots=True, eq=False)
class Room:
    """One cutter-center region at one level.

    Attributes
    ----------
    region : shapely.Polygon
        Counter-clockwise.
    level : Level
    above : Room or None
        The room in which it lies; None at the top.
    """

    region: Polygon
    level: Level
    above: Room | None

    @property
    def ground(self) -> tuple[bytes, bytes | None]:
        """Return what tells apart rooms that are cut by different paths."""
        stock = self.level.stock
        return self.region.wkb, None if stock is None else stock.wkb


def rooms_of(
    levels: Sequence[Level], cutter_radius: float, stock: float
) -> tuple[list[Room], list[Notice]]:
    """Return the rooms in cutting order, and a notice for each place the cutter cannot enter.

    Parameters
    ----------
    levels : sequence of Level
        Highest first.
    cutter_radius, stock : float
        R and the stock to leave on the walls [mm].

    Raises
    ------
    CutterDoesNotFitError
        If the cutter does not fit the topmost level.
    """
    layers: list[list[Room]] = []
    notices: list[Notice] = []
    regions: list[Polygon] = []
    pocket: Polygon | None = None
    for level in levels:
        above = layers[-1] if layers else []
        if level.pocket != pocket:
            try:
                regions = center_regions(level.pocket, cutter_radius, stock)
            except CutterDoesNotFitError as error:
                if not layers:
                    raise
                notices.append(_stops_at(level.top, error))
                break
            pocket = level.pocket
            found = unreachable_notices(pocket, regions, cutter_radius, stock)
            notices += [n for n in found if not _is_told(n, notices, cutter_radius)]
        rooms = [Room(region, level, _over(region, above)) for region in regions]
        layers.append([room for room in rooms if room.above is not None or not layers])
    return list(_downwards(None, layers)), notices


def _over(region: Polygon, above: Sequence[Room]) -> Room | None:
    """Return the room of the level above in which a region lies."""
    same = next((room for room in above if room.region is region), None)
    if same is not None or not above:
        return same
    point = region.representative_point()
    return next((room for room in above if room.region.covers(point)), None)


def _downwards(above: Room | None, layers: Sequence[list[Room]]) -> Iterator[Room]:
    """Yield the rooms under `above`, each followed by all that lies under it."""
    if layers:
        for room in layers[0]:
            if room.above is above:
                yield room
                yield from _downwards(room, layers[1:])


def _stops_at(z: float, error: CutterDoesNotFitError) -> Notice:
    return Notice(
        f"Below Z{z:g} the pocket is too narrow and stays uncut. {error.message}",
        error.hint,
        error.place,
    )


def _is_told(notice: Notice, told: Sequence[Notice], radius: float) -> bool:
    """Return whether the same place has been told of at a higher level."""
    return notice.place is not None and any(
        other.place is not None and Point(other.place).distance(Point(notice.place)) < radius
        for other in told
    )
