# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the cutter could reach and left standing.

Reach: the pocket shrunk by radius and stock to leave (where the center may be, without
channels as wide as the cutter), and grown again by the radius. Swept: the union of what
every piece of motion at the floor or deeper sweeps. Most of it is settled by a rough,
certainly too small picture of the swept ground; only what that leaves, a thin strip along
the walls and what truly stands, is compared with exact shapes of the pieces nearby.

A path that keeps to its tolerance may leave a skin of that thickness on the wall, or a film
between two sides of it; these are not counted. What is cut at the lowest floor is cut above
it too, so the lowest floor is the least favorable one.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPolygon, Polygon

from ..contact.swept import SAME_HEIGHT, Pieces
from ..model import Floats
from ..numerics.distinct import distinct
from ..numerics.ragged import rows_of
from ..shapes.region import polygons_of, without_hairs

#: Chords in a quarter circle of what can be reached and of what is swept: off by 8e-5 and by
#: 3e-4 of the radius; EXACT is more than both.
REACH_QUADRANT, SWEPT_QUADRANT, EXACT = 64, 32, 5e-4
#: What is beside a move is taken to reach so much beyond its ends, over the radius, so that no
#: slits stay between moves: all of it is within 2e-6 of the radius of what is swept.
BEYOND = 2e-3
#: Arcs become chords and straight chains single lines no farther off than this [mm].
CHORD_TOLERANCE = 1e-4
#: The rough picture: motion simplified by this share of the radius and grown by that one.
#: With the 1 % by which GEOS simplifies what it grows they stay below the radius.
ROUGH_MOTION, ROUGH_RADIUS = 0.03, 0.95
#: It is grown in runs of so many corners.
CORNERS = 32


def reachable_floor(pocket: Polygon, radius: float, stock: float) -> shapely.Geometry:
    """Return the part of the pocket that the cutter can clear, `stock` [mm] off the wall."""
    centers = polygons_of(pocket.buffer(-(radius + stock), quad_segs=REACH_QUADRANT))
    rooms = [room for part in centers for room in without_hairs(part, radius)]
    return MultiPolygon(rooms).buffer(radius, quad_segs=REACH_QUADRANT)


def uncut_floor(
    reach: shapely.Geometry, pieces: Pieces, floor: float, radius: float, skin: float
) -> MultiPolygon:
    """Return what stands above a floor after all motion.

    Parameters
    ----------
    reach : shapely.Geometry
        Polygon or polygons that should be cut.
    pieces : Pieces
    floor : float
        Z [mm].
    radius : float
        Cutter radius [mm].
    skin : float
        Thickness on the wall, or of a film anywhere, that does not count [mm], 0 or more.

    Returns
    -------
    shapely.MultiPolygon
    """
    wanted = reach.buffer(-skin - EXACT * radius, quad_segs=REACH_QUADRANT)
    deep = pieces.select(~pieces.rapid & (pieces.heights <= floor + SAME_HEIGHT))
    if len(deep) == 0:
        return _polygons(wanted)
    arcs = deep.select(deep.is_arc)
    chains = _chains(deep.select(~deep.is_arc))
    rough = _roughly_swept(deep, radius)
    doubtful = shapely.get_parts(wanted.difference(rough))
    lines = _segments(chains)
    near, arcs = _near(doubtful, lines, arcs, radius)
    # the ground beside all motion is nearly everything, and simpler than that around its ends
    sides = np.concatenate([_rectangles(near, radius), _sectors(arcs, radius)])
    doubtful = _without(doubtful, sides)
    if len(doubtful) == 0:
        return MultiPolygon()
    near, arcs = _near(doubtful, near, arcs, radius)
    drilled = deep.select(deep.lengths == 0).ends
    tips = shapely.points(np.concatenate([arcs.starts, arcs.ends, drilled]))
    rounds = shapely.buffer(np.concatenate([near, tips]), radius, quad_segs=SWEPT_QUADRANT)
    left = _without(doubtful, rounds)
    is_film = shapely.is_empty(shapely.buffer(left, -skin / 2))
    is_film &= ~shapely.dwithin(left, wanted.boundary, EXACT * radius)
    return MultiPolygon(list(left[~is_film]))


def _without(areas: NDArray[np.object_], taken: NDArray[np.object_]) -> NDArray[np.object_]:
    """Return the polygons that are left of areas without what is taken."""
    rest = shapely.difference(shapely.union_all(areas), shapely.union_all(taken))
    parts = shapely.get_parts(rest)
    return parts[shapely.get_type_id(parts) == shapely.GeometryType.POLYGON]


def _near(
    areas: NDArray[np.object_], lines: NDArray[np.object_], arcs: Pieces, radius: float
) -> tuple[NDArray[np.object_], Pieces]:
    """Return the lines and arcs that come within the radius of any of the areas."""
    tree = shapely.STRtree(np.concatenate([lines, polylines(arcs)]))
    near = distinct(tree.query(areas, predicate="dwithin", distance=radius)[1])
    split = np.searchsorted(near, len(lines))
    return lines[near[:split]], arcs.select(near[split:] - len(lines))


def _rectangles(lines: NDArray[np.object_], radius: float) -> NDArray[np.object_]:
    """Return the rectangle beside each single line."""
    if len(lines) == 0:
        return np.zeros(0, object)
    ends = shapely.get_coordinates(lines).reshape(-1, 2, 2)
    ahead = ends[:, 1] - ends[:, 0]
    ahead = ahead / np.maximum(np.hypot(*ahead.T), 1e-12)[:, None]
    over, left = BEYOND * radius * ahead, radius * np.column_stack([-ahead[:, 1], ahead[:, 0]])
    a, b = ends[:, 0] - over, ends[:, 1] + over
    return shapely.polygons(np.stack([a - left, b - left, b + left, a + left], axis=1))


def _chains(pieces: Pieces) -> NDArray[np.object_]:
    """Return straight pieces as line strings that are as long as the motion is unbroken."""
    return shapely.get_parts(shapely.line_merge(shapely.multilinestrings(polylines(pieces))))


def _segments(chains: NDArray[np.object_]) -> NDArray[np.object_]:
    """Return the single lines of chains, those in one line as one."""
    parts = shapely.simplify(chains, CHORD_TOLERANCE, preserve_topology=False)
    points, index = shapely.get_coordinates(parts, return_index=True)
    same = index[1:] == index[:-1]
    return shapely.linestrings(np.stack([points[:-1][same], points[1:][same]], axis=1))


def _roughly_swept(pieces: Pieces, radius: float) -> shapely.Geometry:
    """Return a simple region that is certainly swept, nearly all of it."""
    # arcs end where the next piece begins, but for rounding
    lines = shapely.transform(polylines(pieces), lambda points: points.round(6))
    chains = shapely.get_parts(shapely.line_merge(shapely.multilinestrings(lines)))
    rough = shapely.simplify(chains, ROUGH_MOTION * radius, preserve_topology=False)
    # strokes that overlap again and again, as Adaptive's, would take minutes in one go
    strips = shapely.buffer(_runs(rough), ROUGH_RADIUS * radius, quad_segs=8)
    return shapely.union_all(strips)


def _runs(chains: NDArray[np.object_]) -> NDArray[np.object_]:
    """Return line strings cut into ones of few corners."""
    points, index = shapely.get_coordinates(chains, return_index=True)
    ends = np.flatnonzero(np.diff(index, append=-1))  # the last point of each chain
    if len(ends) == 0:
        return chains
    firsts = np.concatenate([np.arange(a, b - 1, CORNERS) for a, b in pairwise([-1, *ends])]) + 1
    lasts = np.minimum(firsts + CORNERS, ends[np.searchsorted(ends, firsts)])
    row, part = rows_of(lasts - firsts + 1)
    return shapely.linestrings(points[firsts[row] + part], indices=row)


def _sectors(arcs: Pieces, radius: float) -> NDArray[np.object_]:
    """Return the ring sector beside each arc, a slice of pie where the arc is tight."""
    if len(arcs) == 0:
        return np.zeros(0, object)
    inner, outer = np.maximum(arcs.radii - radius, 0.0), arcs.radii + radius
    over = np.copysign(BEYOND * radius / outer, arcs.sweeps)
    n = _chord_counts(outer, arcs.sweeps) + 1
    row, part = rows_of(n)
    turn = (arcs.angles - over)[row] + (arcs.sweeps + 2 * over)[row] * part / (n[row] - 1)
    spoke = np.column_stack([np.cos(turn), np.sin(turn)])
    points = arcs.centers[row] + outer[row, None] * spoke
    back = arcs.centers[row] + inner[row, None] * spoke
    order = np.lexsort((np.r_[part, 2 * n[row] - part], np.r_[row, row]))
    both = np.r_[row, row][order]
    return shapely.polygons(
        shapely.linearrings(np.concatenate([points, back])[order], indices=both)
    )


def polylines(pieces: Pieces) -> NDArray[np.object_]:
    """Return each piece as a line string, arcs as chords within the tolerance."""
    n = np.where(pieces.is_arc, _chord_counts(pieces.radii, pieces.sweeps), 1) + 1
    row, part = rows_of(n)
    return shapely.linestrings(pieces.positions(row, part / (n[row] - 1)), indices=row)


def _chord_counts(radii: Floats, sweeps: Floats) -> NDArray[np.int64]:
    """Return how many chords keep an arc within the tolerance, one at least."""
    sag = np.minimum(CHORD_TOLERANCE / np.maximum(radii, 1e-9), 1.0)
    return np.maximum(np.ceil(np.abs(sweeps) / (2 * np.arccos(1 - sag))), 1).astype(np.int64)


def _polygons(geometry: shapely.Geometry) -> MultiPolygon:
    """Return the polygons of a geometry."""
    return MultiPolygon([p for p in shapely.get_parts(geometry) if p.geom_type == "Polygon"])
