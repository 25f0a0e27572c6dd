# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inner curve of a linear morph: a circle, or a slender curve round the medial axis [LM15].

Every place of the wall has a partner on the *spine*: the innermost point of a
compact region, else a place on the pruned medial axis (walk.py). The inner curve lies
on the rulings between them, a half width off the spine: a circle about a point, a
racetrack about an axis. A helix or a slot opens it, so that nothing is cut full wide at
the full depth. The half width is less than R, so that no post stays in the middle.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from shapely import Point, Polygon

from ..model import Floats, PocketRequest
from ..opening.entry import fit_helix_radius
from ..opening.starts import HALF_WIDTHS
from ..shapes.polyline import turning_samples
from ..shapes.skeleton import Skeleton, medial_axis, peel
from ..shapes.starshape import deepest_center
from .walk import walk_round

#: Half the width of inner curves over D where wider ones leave a post, as where branches meet in
#: rooms.
SLIM = (0.25, 0.18)
#: A region is compact if its wall is nowhere farther from the middle than this, over the nearest.
COMPACT = 2.2
#: Shares of the largest clearance down to which the axis is pruned: to its bifurcations first,
#: 1.45 being a little more than the branch of a square corner needs.
PRUNED = (1.45, 1.1, 0.8, 0.5)
#: The inner curve goes this far from the spine towards a near wall.
NEAR_WALL = 0.9


@dataclass(frozen=True, slots=True, eq=False)
class Spine:
    """What the inner curve runs about.

    Attributes
    ----------
    center : ndarray of shape (2,)
        Where there is most room [mm].
    room : float
        The nearest wall's distance to the spine [mm].
    half_widths : tuple of float
        Of the inner curve; the widest that leaves no post is to be taken [mm].
    axis, edges
        The medial axis and what is left of it; None and empty for a point.
    """

    center: Floats
    room: float
    half_widths: tuple[float, ...]
    axis: Skeleton | None = None
    edges: tuple[tuple[int, int], ...] = ()

    def samples(
        self, wall: Floats, smoothing: float
    ) -> Callable[[float, float], tuple[Floats, Floats]]:
        """Return what samples a closed wall and the partners on the spine, by length and turn."""
        if self.axis is not None:
            return walk_round(wall, self.axis, self.edges, smoothing).samples

        def about_point(length: float, turn: float) -> tuple[Floats, Floats]:
            places = turning_samples(wall, length, turn)
            return places, np.tile(self.center, (len(places), 1))

        return about_point

    def beside(self, partners: Floats, wall: Floats, half_width: float) -> Floats:
        """Return the places `half_width` off the spine on the rulings to the wall, shape (n, 2)."""
        rulings = wall - partners
        lengths = np.maximum(np.hypot(rulings[:, 0], rulings[:, 1]), 1e-9)
        off = np.minimum(half_width, NEAR_WALL * lengths) if self.edges else half_width
        return partners + (off / lengths)[:, None] * rulings


def point_spine(region: Polygon, request: PocketRequest) -> Spine | None:
    """Return the innermost point of a region; None if that does not see the whole wall.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise, without islands.
    request : PocketRequest

    Raises
    ------
    CutterDoesNotFitError
        If there is no room for the helix.
    """
    center = deepest_center(region)
    if center is None:
        return None
    room = float(region.exterior.distance(Point(center)))
    radius = fit_helix_radius(region, center, request.cutter_radius, request.entry)
    return Spine(center, room, (radius,))


def is_compact(region: Polygon, spine: Spine) -> bool:
    """Return whether the farthest wall is not much farther from a point than the nearest."""
    farthest = np.hypot(*(np.array(region.exterior.coords) - spine.center).T).max()
    return bool(farthest <= COMPACT * spine.room)


def axis_spines(region: Polygon, request: PocketRequest) -> Iterator[Spine]:
    """Yield the medial axis, pruned to its bifurcations and then ever less.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise, without islands.
    request : PocketRequest
    """
    axis = medial_axis(region)
    halves = tuple(share * request.tool_diameter for share in (*HALF_WIDTHS, *SLIM))
    for share in PRUNED:
        edges = peel(axis, share)
        if edges:
            used = np.unique(np.array(edges))
            center = axis.nodes[used[int(np.argmax(axis.clearance[used]))]]
            room = float(axis.clearance[used].min())
            yield Spine(center, room, halves, axis, tuple(edges))
