# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of the ground at each level belongs to a pocket.

Above a ledge, or a rib lower than the rim, the walls go around more than the pocket. Rooms that
the cutter does not get to from above the floor, as the way is too narrow, are none of it; nor are
pockets beside it whose own floors are not selected. Holes in a ledge are passed over with it.
"""

from __future__ import annotations

from collections.abc import Sequence

import shapely
from shapely import Polygon

from ..engine.shapes.region import grow, polygons_of

#: A pocket beside is one of its own if more than this share of its rim is near a wall: so far, over
#: the cutter's radius. Else it is a hole in a ledge.
WALLED, NEAR = 0.5, 0.5
#: What is closer together touches [mm].
TOUCHES = 0.01
#: What is narrower than twice this beside ground that was taken away is a film [mm].
FILM = 1e-3


class Belonging:
    """What belongs to a pocket, level by level from its floor up.

    Parameters
    ----------
    floor : shapely.Polygon
        The pocket at its floor.
    inset : float
        How far the cutter's center stays off the walls [mm].
    """

    def __init__(self, floor: Polygon, inset: float) -> None:
        self._inset = inset
        self._below = self._whole = floor
        self._beside: shapely.Geometry = Polygon()

    def may_have_more(self, whole: Polygon) -> bool:
        """Return whether all that the walls go around has room for the cutter beside the pocket."""
        more = shapely.difference(whole, self._below)
        return not shapely.buffer(more, -self._inset).is_empty

    def leave_out(
        self, ground: shapely.Geometry, whole: Polygon, selected: Sequence[shapely.Point]
    ) -> None:
        """Leave pockets beside this one out, from the next level on.

        Parameters
        ----------
        ground : shapely.Geometry
            What else is free just below the next level.
        whole : shapely.Polygon
            All that the walls go around at that level.
        selected : sequence of shapely.Point
            Places of other floors that are selected.
        """
        walls = shapely.buffer(whole.exterior, NEAR * self._inset)
        for piece in polygons_of(shapely.intersection(ground, whole)):
            if shapely.buffer(piece, -self._inset).is_empty or piece.intersects(self._below):
                continue
            if any(piece.contains(place) for place in selected):
                continue
            walled = shapely.intersection(piece.exterior, walls).length
            if walled > WALLED * piece.exterior.length:
                self._beside = shapely.union(self._beside, piece)

    def of(self, whole: Polygon) -> Polygon:
        """Return what belongs to the pocket at the next level of all that the walls go around."""
        was_all = self._below is self._whole and self._beside.is_empty
        has_more = not was_all or self.may_have_more(whole)
        self._below, self._whole = self.reached(whole) if has_more else whole, whole
        return self._below

    def reached(self, whole: Polygon) -> Polygon:
        """Return what the cutter reaches of a level from above the one below it."""
        ground = shapely.difference(whole, self._beside)
        rooms = polygons_of(shapely.buffer(ground, -self._inset))
        kept = [room for room in rooms if room.intersects(self._below)]
        if len(kept) == len(rooms) and self._beside.is_empty:
            return whole
        others = [room for room in rooms if not room.intersects(self._below)]
        lost = shapely.union(grow(shapely.union_all(others), self._inset), self._beside)
        near = shapely.buffer(lost, TOUCHES)
        narrow = shapely.difference(ground, grow(shapely.union_all(kept), self._inset))
        ways = [piece for piece in polygons_of(narrow) if piece.intersects(near)]
        # what is under it has to be cut through it
        away = shapely.difference(shapely.union_all([near, *ways]), self._below)
        found = shapely.union(_without_films(shapely.difference(ground, away), away), self._below)
        parts = polygons_of(found)
        shares = [shapely.intersection(part, self._below).area for part in parts]
        return parts[shares.index(max(shares))] if parts else whole


def _without_films(ground: shapely.Geometry, away: shapely.Geometry) -> shapely.Geometry:
    """Return ground without films along the walls where something was taken away."""
    wide = shapely.buffer(ground, -FILM)
    wide = shapely.buffer(wide, 1.1 * FILM, join_style="mitre")
    near = shapely.buffer(away, TOUCHES)
    films = [p for p in polygons_of(shapely.difference(ground, wide)) if p.intersects(near)]
    return shapely.difference(ground, shapely.union_all(films))
