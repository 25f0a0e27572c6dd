# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a pocket that the cutter cannot enter, with their places and real widths.

What no center position reaches are corners, dead ends, and what stands in necks: a web right
across it, or stubs on its walls where the cutter reaches in from both sides. Corners that merely
keep the cutter's radius are nobody's news. A piece in a neck is bounded by arcs about two places
of the center, that in a corner or a dead end by the arc about one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from shapely import MultiPolygon, Polygon

from .errors import told_area
from .model import Floats, Notice
from .shapes.region import grow, polygons_of, widest_disc
from .shapes.shaping import CRACK, clipped

#: A piece at one place that takes a disc of this share of R is told; that in a square corner takes
#: 0.17.
TOLD_SHARE = 0.3
#: A piece is in a neck if the places that it is bounded from are farther apart than the first, and
#: told if it is larger than the second, over R and its square.
APART, LARGE = 0.3, 0.1
#: It is a dead end all the same if the middle between these is nearer to other places of the center
#: than this, over how far they are apart.
BESIDE = 0.25
#: What bounds a piece is as far from the center's place as R but for this, over R.
NEAR = 0.01
#: Halvings in the search for a neck's width.
HALVINGS = 12
#: Gaps narrower than this, over the diameter of the cutter, are as good as closed.
CLOSED = 0.1
#: Rooms that are joined by ways narrower than twice this have nothing to do with each other [mm].
HAIR = 1e-3
#: More parts than this that the cutter cannot enter are told together.
TOLD_ONE_BY_ONE = 3


@dataclass(frozen=True, slots=True)
class _Part:
    """A part that stays: width of the way in, or of a whole room, a place, and area [mm, mm2]."""

    width: float
    place: tuple[float, float]
    area: float
    is_room: bool = False


def unreachable_notices(
    pocket: Polygon, regions: list[Polygon], cutter_radius: float, stock: float
) -> tuple[Notice, ...]:
    """Return a notice for each part of the pocket that the cutter cannot enter, one for many.

    Parameters
    ----------
    pocket : shapely.Polygon
    regions : list of shapely.Polygon
        Its cutter-center regions.
    cutter_radius, stock : float
        R, and what is left on the walls [mm].
    """
    target = grow(pocket, -stock) if stock else pocket
    rooms = [grow(room, HAIR) for room in polygons_of(grow(target, -HAIR))]
    found = [part for room in rooms for part in _parts_in(room, regions, cutter_radius)]
    parts = _joined(found, cutter_radius)
    kinds = ([part for part in parts if part.is_room is it] for it in (False, True))
    return tuple(notice for kind in kinds for notice in _notices(kind, 2 * cutter_radius))


def _notices(parts: Sequence[_Part], cutter: float) -> list[Notice]:
    """Return what is told of parts that are all rooms, or all behind necks."""
    if len(parts) > TOLD_ONE_BY_ONE:
        widest = max(parts, key=lambda part: (part.width, part.place))
        many, width = len(parts), _mm(widest.width)
        area = told_area(sum(part.area for part in parts))
        return [
            Notice(
                f"The {cutter:g} mm cutter does not fit {many} rooms, up to {width} mm wide, the "
                f"widest at {{at}}; these ({area} mm2) stay uncut."
                if widest.is_room
                else f"The {cutter:g} mm cutter does not fit {many} necks, up to {width} mm wide, "
                f"the widest at {{at}}; these parts ({area} mm2) stay uncut.",
                _advice([part.width for part in parts], cutter),
                widest.place,
            )
        ]
    return [
        Notice(
            f"The {cutter:g} mm cutter does not fit the room at {{at}}, {_mm(part.width)} mm wide "
            f"at its widest; that part ({told_area(part.area)} mm2) stays uncut."
            if part.is_room
            else f"The {cutter:g} mm cutter does not fit the {_mm(part.width)} mm neck at {{at}}; "
            f"that part ({told_area(part.area)} mm2) stays uncut.",
            _advice([part.width], cutter),
            part.place,
        )
        for part in parts
    ]


def _parts_in(room: Polygon, regions: Sequence[Polygon], radius: float) -> list[_Part]:
    """Return what stays in a room that no way leads to, the whole room if no center is in it."""
    centers = MultiPolygon([region for region in regions if region.intersects(room)])
    if centers.is_empty:
        place, widest = widest_disc(room)
        return [_Part(2 * widest, place, room.area, True)] if widest > TOLD_SHARE * radius else []
    # films along walls would join corners
    reached = grow(centers, (1 + NEAR / 4) * radius)
    rest = polygons_of(shapely.difference(room, reached))
    rest = [piece for piece in rest if piece.area > LARGE * radius**2]
    found = [_part(piece, room, centers, radius) for piece in rest]
    return [part for part in found if part is not None]


def _advice(widths: Sequence[float], cutter: float) -> str:
    """Return what cutter reaches parts with ways in so wide, if there is one in the shop."""
    open_ways = [width for width in widths if width >= CLOSED * cutter]
    if not open_ways:
        return "No cutter goes through so narrow a gap; check the model."
    if len(widths) == 1:
        return f"A cutter below {_mm(open_ways[0])} mm reaches it."
    if len(open_ways) == len(widths):
        return f"A cutter below {_mm(min(open_ways))} mm reaches all of them."
    return f"A cutter below {_mm(min(open_ways))} mm reaches {len(open_ways)} of them."


def _part(piece: Polygon, target: Polygon, centers: MultiPolygon, radius: float) -> _Part | None:
    """Return a piece as what is told of it; None if it is a corner, or a crumb."""
    rim = shapely.get_coordinates(shapely.simplify(piece, NEAR / 4 * radius))[:-1]
    bounded = _bounded_from(rim, centers, radius)
    ends = _farthest(bounded) if len(bounded) else None
    if ends is not None and _are_across(ends, centers, radius):
        width = 2 * _narrowest(piece, bounded, ends, target, radius)
        return _Part(width, _middle_of(piece, ends, target), piece.area)
    if piece.area < math.pi * (TOLD_SHARE * radius) ** 2:  # no such disc fits
        return None
    place, widest = widest_disc(piece)
    if widest <= TOLD_SHARE * radius:
        return None
    room = float(shapely.distance(target.boundary, shapely.points([place, *rim])).max())
    width, place = _way_in(place, piece, target, centers, min(room, radius))
    return _Part(width, place, piece.area)


def _are_across(ends: Floats, centers: MultiPolygon, radius: float) -> bool:
    """Return whether a piece lies between two places of the center, not beside both."""
    apart = float(np.hypot(*(ends[1] - ends[0])))
    middle = shapely.points(ends.mean(axis=0))
    return apart > APART * radius and centers.distance(middle) > BESIDE * apart


def _way_in(
    place: tuple[float, float],
    piece: Polygon,
    target: Polygon,
    centers: MultiPolygon,
    widest: float,
) -> tuple[float, tuple[float, float]]:
    """Return how wide the way to a place in a dead end is, and where it is narrow.

    As wide as the dead end itself, from wall to wall twice `widest` [mm], and at the place, where
    nothing on the way is narrower.
    """
    around = clipped(target, shapely.buffer(piece, 3 * widest).bounds)
    there = shapely.points(place)

    def rooms(cutter: float) -> tuple[shapely.Geometry, shapely.Geometry]:
        """Return where a smaller cutter's center gets to, and where else it has room."""
        parts = polygons_of(grow(around, -cutter))
        ours = [part.intersects(centers) for part in parts]
        return tuple(
            shapely.union_all([p for p, is_ours in zip(parts, ours, strict=True) if is_ours is it])
            for it in (True, False)
        )

    def goes(cutter: float) -> bool:
        return bool(rooms(cutter)[0].dwithin(there, cutter + CRACK))

    if goes(widest):
        return 2 * widest, place
    low, high = 0.0, widest
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if goes(middle) else (low, middle)
    reached, beyond = rooms(high)
    if not reached.is_empty and not beyond.is_empty:
        narrow = shapely.shortest_line(reached, beyond).centroid
        place = (float(narrow.x), float(narrow.y))
    return low + high, place


def _bounded_from(rim: Floats, centers: MultiPolygon, radius: float) -> Floats:
    """Return the places of the center that clear up to points of a piece's rim, shape (n, 2)."""
    lines = shapely.shortest_line(shapely.points(rim), centers)
    ends = shapely.get_coordinates(lines).reshape(-1, 2, 2)
    far = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    return ends[np.abs(far - radius) < NEAR * radius, 1]


def _farthest(places: Floats) -> Floats:
    """Return the two of some places that are farthest apart, shape (2, 2)."""
    apart = np.hypot(*(places[:, None] - places).T)
    i, j = np.unravel_index(int(np.argmax(apart)), apart.shape)
    return places[[min(i, j), max(i, j)]]


def _narrowest(
    piece: Polygon, bounded: Floats, ends: Floats, target: Polygon, radius: float
) -> float:
    """Return how large a cutter's radius is at most that goes from end to end through a piece."""
    discs = shapely.buffer(shapely.multipoints(bounded), (1 + NEAR) * radius)
    passage = shapely.union(discs, shapely.buffer(piece, NEAR * radius))
    around = clipped(target, shapely.buffer(passage, 2 * radius).bounds)
    low, high = 0.0, radius
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        free = shapely.intersection(passage, grow(around, -middle))
        goes = any(shapely.dwithin(p, shapely.points(ends), CRACK).all() for p in polygons_of(free))
        low, high = (middle, high) if goes else (low, middle)
    return (low + high) / 2


def _middle_of(piece: Polygon, ends: Floats, target: Polygon) -> tuple[float, float]:
    """Return the middle between two ends, or of a piece if the way is not straight."""
    middle = shapely.points(ends.mean(axis=0))
    if not target.contains(middle):
        middle = piece.representative_point()
    return float(middle.x), float(middle.y)


def _joined(parts: Sequence[_Part], radius: float) -> list[_Part]:
    """Return parts without telling of one neck for each of its walls."""
    joined: list[_Part] = []
    for part in parts:
        for i, other in enumerate(joined):
            if math.dist(part.place, other.place) < APART * radius:
                width, area = min(part.width, other.width), part.area + other.area
                joined[i] = replace(other, width=width, area=area)
                break
        else:
            joined.append(part)
    return joined


def _mm(width: float) -> str:
    return f"{round(width, 2):g}"
