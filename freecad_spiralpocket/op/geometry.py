# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the edges of a floor to a polygon that never reaches into a wall.

Curved edges become chords. Where the wall is hollow, as in the corner of a
pocket, a chord stays inside the pocket and leaves at most its sag standing.
Where the wall bulges into the pocket, as around an island, a chord would cut the
wall by its sag; there the two tangents at the chord's ends take its place, which
touch the wall and stay inside the pocket. Which of the two it is, is decided for
each piece of each edge, so B-splines with inflections need no special care.

Rings run with the pocket on their left: the outline counter-clockwise, islands
clockwise. FreeCAD's own sense of rotation differs between its versions.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import shapely
from shapely import Polygon

from ..engine.errors import SelectionError
from ..engine.model import Floats
from ..engine.shapes.points import signed_area
from ..engine.shapes.region import polygons_of
from .adjacency import outer_wire
from .selection import Floor

#: Ends of edges that are closer than this are one corner [mm]; FreeCAD's own limit is 1e-7,
#: IGES files are coarser.
GAP = 1e-3
#: Decimals of points [mm]: a part that was saved and read again gives the same polygon.
DECIMALS = 7
#: The largest turn of one piece [rad]: keeps tangents from meeting far away.
_LARGEST_TURN = np.radians(20)
#: An S-shaped piece is halved until it is as straight as this [mm]: its tangents do not meet.
_STRAIGHT = 1e-8
#: A piece is not halved more often than this.
_DEEPEST = 12
#: Tangents are taken this share inside a piece, so that a kink at its ends does not matter.
_INSET = 1e-6


@dataclass(frozen=True)
class Piece:
    """A stretch of an edge, from one point to the next in the order of the ring.

    Attributes
    ----------
    start, end : ndarray of shape (2,)
        [mm]
    heading, arrival : ndarray of shape (2,)
        Unit tangents there.
    """

    start: Floats
    end: Floats
    heading: Floats
    arrival: Floats

    def reversed(self) -> Piece:
        """Return the same stretch, run the other way."""
        return Piece(self.end, self.start, -self.arrival, -self.heading)


def polygon(floor: Floor, sag: float, *, use_outline: bool = False) -> Polygon:
    """Return the floor as a polygon in the plane.

    Holes in the floor, from whose rim no wall rises or one from a part of it, are no islands and
    are filled.

    Parameters
    ----------
    floor : Floor
    sag : float
        Largest distance of the polygon from the true outline [mm], positive.
    use_outline : bool
        Leave out all islands.

    Returns
    -------
    shapely.Polygon
        Valid; inside the true floor up to rounding.

    Raises
    ------
    SelectionError
        If a wire of the face is not closed or the outline crosses itself.
    """
    outer = outer_wire(floor.face)
    rings = [_ring(outer, sag, floor.label, counter_clockwise=True)]
    if not use_outline:
        for wire in floor.face.Wires:
            if not wire.isSame(outer) and is_island(floor, wire):
                rings.append(_ring(wire, sag, floor.label, counter_clockwise=False))
    result = Polygon(rings[0], rings[1:])
    if not result.is_valid:
        outline, *islands = (_filled(ring, sag) for ring in rings)
        is_sound = not any(part.is_empty for part in (outline, *islands))
        result = _largest(shapely.difference(outline, shapely.union_all(islands)), sag)
        result = result if is_sound else Polygon()
    if result.is_empty:
        raise SelectionError(
            f"The outline of {floor.label} crosses itself.",
            "Repair the part (Part workbench, Check Geometry).",
        )
    return result


def _filled(ring: Floats, sag: float) -> Polygon:
    """Return what a ring encloses; empty if it crosses itself."""
    # chords may cross where an edge comes to another tangentially, as in a cusp
    return _largest(shapely.make_valid(Polygon(ring)), sag)


def _largest(shape: Any, sag: float) -> Polygon:
    """Return the largest polygon in a shape; empty if others are wider than twice the sag."""
    first, *rest = polygons_of(shape) or [Polygon()]
    return Polygon() if any(not part.buffer(-sag).is_empty for part in rest) else first


def holes(floor: Floor, sag: float) -> list[Polygon]:
    """Return the holes in a floor that are no islands, a sag too large or small."""
    return _inside(floor, sag, are_islands=False)


def islands(floor: Floor, sag: float) -> list[Polygon]:
    """Return the feet of the islands on a floor, a sag too large or small."""
    return _inside(floor, sag, are_islands=True)


def _inside(floor: Floor, sag: float, *, are_islands: bool) -> list[Polygon]:
    outer = outer_wire(floor.face)
    return [
        Polygon(_ring(wire, sag, floor.label, counter_clockwise=True)).buffer(0)
        for wire in floor.face.Wires
        if not wire.isSame(outer) and is_island(floor, wire) == are_islands
    ]


def is_island(floor: Floor, wire: Any) -> bool:
    """Return whether a wall rises all along the inner wire `wire`; else it is a hole."""
    return all(rises for rises, _ in floor.adjacency.along(floor.face, wire))


def _ring(wire: Any, sag: float, where: str, *, counter_clockwise: bool) -> Floats:
    """Return the wire as points, shape (n, 2), inside the pocket or on its wall."""
    pieces = _chain([pieces_of(e, sag) for e in wire.OrderedEdges], where)
    area = signed_area(np.array([p.start for p in pieces]))
    if (area > 0) != counter_clockwise:
        pieces = turned(pieces)
    return ring_points(pieces)


def ring_points(pieces: Sequence[Piece]) -> Floats:
    """Return a closed chain of pieces, the pocket on its left, as points, shape (n, 2)."""
    points = []
    for piece in pieces:
        points.append(piece.start)
        points.extend(_bulge(piece))
    return np.round(points, DECIMALS)


def _chain(edges: list[list[Piece]], where: str) -> list[Piece]:
    """Return the pieces of all edges head to tail, turning edges around where needed."""
    if len(edges) > 1 and not _touch(edges[0][-1].end, edges[1]):
        edges[0] = turned(edges[0])
    chain = list(edges[0])
    for pieces in edges[1:]:
        here = chain[-1].end
        if math.dist(pieces[0].start, here) > math.dist(pieces[-1].end, here):
            pieces = turned(pieces)
        if math.dist(pieces[0].start, here) > GAP:
            break
        chain += pieces
    if len(chain) < sum(map(len, edges)) or math.dist(chain[-1].end, chain[0].start) > GAP:
        x, y = chain[-1].end
        raise SelectionError(
            f"The outline of {where} is not closed at X{x:.2f} Y{y:.2f}.",
            "Repair the part (Part workbench, Check Geometry).",
            place=(x, y),
        )
    return chain


def _touch(point: Floats, pieces: list[Piece]) -> bool:
    ends = np.array([pieces[0].start, pieces[-1].end])
    return bool(np.linalg.norm(ends - point, axis=1).min() <= GAP)


def turned(pieces: list[Piece]) -> list[Piece]:
    """Return the same pieces, run the other way."""
    return [p.reversed() for p in reversed(pieces)]


def pieces_of(edge: Any, sag: float, ripple: float = 0.0) -> list[Piece]:
    """Return an edge as pieces from end to end.

    Parameters
    ----------
    edge : Part.Edge
    sag : float
        How far a piece may be from its chord [mm].
    ripple : float
        Of a curve that FreeCAD has approximated [mm]; it is no turn of the curve.
    """
    kind = edge.Curve.TypeId
    t0, t1 = edge.ParameterRange
    if kind == "Part::GeomLine":
        return [_straight(_xy(edge.valueAt(t0)), _xy(edge.valueAt(t1)))]
    if kind == "Part::GeomCircle":
        step = min(2 * np.arccos(max(0.0, 1 - sag / edge.Curve.Radius)), _LARGEST_TURN)
        ts = np.linspace(t0, t1, max(1, int(np.ceil((t1 - t0) / step))) + 1)
        return [_piece(edge, a, b) for a, b in pairwise(ts)]
    ts = {t0, t1, *np.linspace(t0, t1, 9)}
    if not ripple and hasattr(edge.Curve, "getKnots"):
        ts |= {t for t in edge.Curve.getKnots() if t0 < t < t1}
    ordered = sorted(ts)
    result: list[Piece] = []
    for a, b in pairwise(ordered):
        if b - a > 1e-9 * (t1 - t0):
            result += _halved(edge, a, b, (sag, max(ripple, _STRAIGHT)), _DEEPEST)
    return result


def _halved(edge: Any, a: float, b: float, limits: tuple[float, float], depth: int) -> list[Piece]:
    piece = _piece(edge, a, b)
    found = _sag(edge, piece, a, b)
    limit = limits[1] if _is_s_shaped(edge, a, b) else limits[0]
    if depth == 0 or (found <= limit and _turn(piece) <= _LARGEST_TURN):
        return [piece]
    middle = (a + b) / 2
    return _halved(edge, a, middle, limits, depth - 1) + _halved(edge, middle, b, limits, depth - 1)


def _piece(edge: Any, a: float, b: float) -> Piece:
    inset = (b - a) * _INSET
    return Piece(
        start=_xy(edge.valueAt(a)),
        end=_xy(edge.valueAt(b)),
        heading=_xy(edge.tangentAt(a + inset)),
        arrival=_xy(edge.tangentAt(b - inset)),
    )


def _straight(start: Floats, end: Floats) -> Piece:
    way = end - start
    heading = way / max(math.hypot(*way), 1e-12)
    return Piece(start, end, heading, heading)


def _xy(vector: Any) -> Floats:
    return np.array([vector.x, vector.y])


def _cross(a: Floats, b: Floats) -> float:
    return float(a[0] * b[1] - a[1] * b[0])


def _sag(edge: Any, piece: Piece, a: float, b: float) -> float:
    """Return how far the edge is from the piece's chord, at a few points."""
    chord = piece.end - piece.start
    length = np.linalg.norm(chord)
    offsets = [_xy(edge.valueAt(a + (b - a) * f)) - piece.start for f in (0.25, 0.5, 0.75)]
    if length == 0:
        return max(float(np.linalg.norm(o)) for o in offsets)
    return max(abs(_cross(chord, o)) for o in offsets) / float(length)


def _turn(piece: Piece) -> float:
    """Return the angle between the tangents at both ends [rad]."""
    return abs(np.arctan2(_cross(piece.heading, piece.arrival), piece.heading @ piece.arrival))


def _is_s_shaped(edge: Any, a: float, b: float) -> bool:
    """Return whether the edge turns both ways between two parameters."""
    inset = (b - a) * _INSET
    tangents = [_xy(edge.tangentAt(t)) for t in np.linspace(a + inset, b - inset, 5)]
    turns = [_cross(before, after) for before, after in pairwise(tangents)]
    return min(turns) < 0 < max(turns)


def _bulge(piece: Piece) -> list[Floats]:
    """Return the point that keeps the ring out of a wall that bulges to the left.

    That is where the tangents at both ends meet.
    """
    chord = piece.end - piece.start
    leaves, reaches = _cross(chord, piece.heading), _cross(chord, piece.arrival)
    if leaves <= 0 or reaches >= 0:
        return []
    along = reaches / _cross(piece.heading, piece.arrival)
    return [piece.start + along * piece.heading]
