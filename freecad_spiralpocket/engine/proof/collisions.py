# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion through standing stock that is meant to be in the air: rapids and links.

Along a move the engagement tells it, whose leading half of the rim is enough. The way
straight down is different, fed or not: the whole disc at its end must have been cleared to
that depth. Rings of points in the disc are looked up in the earlier motion.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from ..contact.air import EVERYWHERE, Stock, are_in_stock
from ..contact.distances import point_to_piece
from ..contact.engagement import Engagement
from ..contact.swept import SAME_HEIGHT, Pieces
from ..model import Floats

#: Rings of the disc, over the radius less the slack, and points on each.
RINGS, RING_POINTS = (1.0, 0.75, 0.5, 0.25, 0.0), 72


@dataclass(frozen=True, slots=True)
class Hit:
    """Moves through stock.

    Attributes
    ----------
    length : float
        Of motion there [mm].
    place : tuple of float or None
        The worst one, (x, y) [mm].
    moves : frozenset of int
        Their numbers in the toolpath.
    """

    length: float
    place: tuple[float, float] | None
    moves: frozenset[int] = frozenset()


def hits_along(engagement: Engagement, chosen: NDArray[np.bool_], slack: float) -> Hit:
    """Return how far the chosen samples run through stock.

    Parameters
    ----------
    engagement : Engagement
        Of k samples.
    chosen : ndarray of bool, shape (k,)
    slack : float
        Stock that reaches no farther across the direction of travel does not count [mm].
    """
    through = np.flatnonzero(chosen & (engagement.radial_depths > slack))
    if len(through) == 0:
        return Hit(0.0, None)
    worst = through[np.argmax(engagement.radial_depths[through])]
    x, y = engagement.points[worst, :2]
    moves = frozenset(engagement.moves[through].tolist())
    return Hit(float(engagement.lengths[through].sum()), (float(x), float(y)), moves)


def plunges(
    pieces: Pieces,
    chosen: NDArray[np.bool_],
    cutter_radius: float,
    slack: float,
    stock: Stock = EVERYWHERE,
) -> Hit:
    """Return how far the chosen pieces go straight down into stock.

    Parameters
    ----------
    pieces : Pieces
    chosen : ndarray of bool
    cutter_radius, slack : float
        What stands within `slack` of the cutter's edge does not count [mm].
    stock : Stock, optional
    """
    down = np.flatnonzero(
        chosen & (pieces.lengths == 0) & (pieces.bottoms[:, 1] < pieces.bottoms[:, 0])
    )
    if len(down) == 0:
        return Hit(0.0, None)
    disc = disc_points(cutter_radius - slack)
    fed = np.flatnonzero(~pieces.rapid)
    tree = shapely.STRtree(shapely.box(*pieces.bounds[fed].T))
    length, place, moves = 0.0, None, set()
    for i in down:
        end, floor = pieces.ends[i], pieces.bottoms[i, 1]
        standing = disc[are_in_stock(disc + end, stock.at(floor))] + end
        low, high = end - 2 * cutter_radius, end + 2 * cutter_radius
        near = np.sort(fed[tree.query(shapely.box(*low, *high))])
        before = near[(near < i) & (pieces.heights[near] <= floor + SAME_HEIGHT)]
        if not _are_cleared(standing, pieces, before, cutter_radius):
            length += float(pieces.bottoms[i, 0] - floor)
            place = place or (float(end[0]), float(end[1]))
            moves.add(int(pieces.moves[i]))
    return Hit(length, place, frozenset(moves))


def disc_points(radius: float) -> Floats:
    """Return points on rings in a disc about the origin, shape (k, 2) [mm]."""
    turn = 2 * np.pi * np.arange(RING_POINTS) / RING_POINTS
    ring = np.column_stack([np.cos(turn), np.sin(turn)])
    return np.concatenate([radius * share * ring for share in RINGS])


def _are_cleared(points: Floats, pieces: Pieces, index: NDArray[np.intp], r: float) -> bool:
    """Return whether the cutter has reached all points along some pieces."""
    standing = np.ones(len(points), bool)
    for start in range(0, len(index), 256):
        part = index[start : start + 256]
        which = np.flatnonzero(standing)
        row, piece = np.repeat(which, len(part)), np.tile(part, len(which))
        inside = point_to_piece(points[row], pieces, piece) <= r
        standing[row[inside]] = False
    return not standing.any()
