# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the cutter could reach and left standing.

Reach: the pocket shrunk by radius and stock to leave (where the center may be), and
grown again by the radius. Swept: the union of all pieces of motion at a floor or
deeper, grown by the radius. A path that keeps to its tolerance may leave a skin of
that thickness on the wall; this is not counted.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPolygon, Polygon

from .model import Floats
from .swept import SAME_HEIGHT, Pieces

#: Chords in a quarter circle: off by 8e-5 of the radius.
QUADRANT = 64
#: Arcs of the motion become chords no farther off than this [mm].
CHORD_TOLERANCE = 1e-4


def reachable_floor(pocket: Polygon, radius: float, stock: float) -> shapely.Geometry:
    """Return the part of the pocket that the cutter can reach, `stock` [mm] off the wall."""
    centers = pocket.buffer(-(radius + stock), quad_segs=QUADRANT)
    return centers.buffer(radius, quad_segs=QUADRANT)


def uncut_floor(
    reach: shapely.Geometry, pieces: Pieces, floor: float, radius: float, skin: float
) -> MultiPolygon:
    """Return what stands above `floor` after all motion.

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
        Thickness on the wall that does not count [mm], 0 or more.

    Returns
    -------
    shapely.MultiPolygon
    """
    deep = pieces.select(~pieces.rapid & (pieces.heights <= floor + SAME_HEIGHT))
    wanted = reach.buffer(-skin - radius * 1e-4, quad_segs=QUADRANT)
    rest = wanted.difference(
        shapely.unary_union(shapely.buffer(polylines(deep), radius, quad_segs=QUADRANT))
    )
    return MultiPolygon([p for p in shapely.get_parts(rest) if p.geom_type == "Polygon"])


def polylines(pieces: Pieces) -> NDArray[np.object_]:
    """Return each piece as a line string, arcs as chords within `CHORD_TOLERANCE`."""
    bend = 2 * np.arccos(np.maximum(0.0, 1 - CHORD_TOLERANCE / np.maximum(pieces.radii, 1e-9)))
    chords = np.ceil(np.abs(pieces.sweeps) / np.maximum(bend, 1e-9)).astype(np.int64)
    n = np.maximum(chords, 1) + 1
    row = np.repeat(np.arange(len(pieces)), n)
    part = np.arange(len(row)) - np.repeat(np.cumsum(n) - n, n)
    return shapely.linestrings(_points(pieces, row, part / (n[row] - 1)), indices=row)


def _points(pieces: Pieces, row: NDArray[np.int64], fraction: Floats) -> Floats:
    return pieces.positions(row, fraction)
