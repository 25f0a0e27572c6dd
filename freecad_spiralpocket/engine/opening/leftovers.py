# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large pieces of stock that stand apart in a pocket which was cleared in part before.

From the air beside them everything can be peeled, corners best of all. A room or a channel is often
cut faster from within, as a pocket of its own, before the rest.
"""

from __future__ import annotations

from dataclasses import replace

import shapely
from shapely import Polygon

from ..model import PocketRequest
from ..shapes.region import grow, polygons_of
from ..shapes.shaping import grow_coarsely, opening_of
from .open_sides import HAIR, needed_for

#: A piece is large if a disc of this radius fits into it, over R, as into every channel,
LARGE = 0.98
#: and so many of them are tried at most, the largest.
TRIED = 12


def is_left(region: Polygon, request: PocketRequest) -> bool:
    """Return whether more than hairlines are left to cut from a cutter-center region."""
    wanted = request.to_clear(grow(region, request.cutter_radius))
    return not grow_coarsely(wanted, -HAIR).is_empty


def large_pieces(region: Polygon, request: PocketRequest) -> list[Polygon]:
    """Return the parts of a cutter-center region from which one large piece each is cleared.

    Parameters
    ----------
    region : shapely.Polygon
    request : PocketRequest
    """
    radius = request.cutter_radius
    wanted = request.to_clear(grow(region, radius))
    pieces = polygons_of(opening_of(wanted, HAIR))  # hairlines do not join them
    if len(pieces) < 2:  # from within it has been tried
        return []
    large = [piece for piece in pieces if not grow_coarsely(piece, -LARGE * radius).is_empty]
    found = [needed_for(piece, piece, region, radius) for piece in large[:TRIED]]
    return [inner for inner in found if inner is not None]


def without(request: PocketRequest, cleared: Polygon) -> PocketRequest:
    """Return a request after the center has been all over a part of its region."""
    assert request.stock is not None
    gone = grow(cleared, request.cutter_radius)
    return replace(request, stock=shapely.difference(request.stock, gone))
