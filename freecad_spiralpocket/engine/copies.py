# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets that are others turned about Z and moved: their plans are too.

Parts have rows and rings of the same pocket. One of each is planned and proved; what differs from
it by no more than rounding has the same walls and the same path, so the proof holds for it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
import shapely
from shapely import Geometry, Polygon
from shapely.affinity import affine_transform

from .errors import Place, SpiralPocketError
from .machine import machine_of
from .model import Floats, Plan, PocketRequest
from .motion.timing import time_of
from .shapes.points import wrapped

#: Outlines of copies are nowhere farther apart [mm]: FreeCAD's own precision is 1e-7.
SAME = 1e-6
#: So many ways to turn one pocket onto another are tried; a regular polygon or a circle has many.
TURNS = 24

Shape = TypeVar("Shape", bound=Geometry)


@dataclass(frozen=True, slots=True)
class Displacement:
    """A turn about Z through the origin, then a move in the plane.

    Attributes
    ----------
    cos, sin : float
        Of the turn.
    x, y : float
        The move [mm].
    """

    cos: float
    sin: float
    x: float
    y: float

    def points(self, points: Floats) -> Floats:
        """Return points, shape (n, 2) or (n, 3), displaced."""
        x, y = points[:, 0], points[:, 1]
        there = points.copy()
        there[:, 0] = self.cos * x - self.sin * y + self.x
        there[:, 1] = self.sin * x + self.cos * y + self.y
        return there

    def place(self, place: Place) -> Place:
        """Return one place displaced."""
        ((x, y),) = self.points(np.array([place])).tolist()
        return x, y

    def shape(self, shape: Shape) -> Shape:
        """Return a shape displaced."""
        return affine_transform(shape, [self.cos, -self.sin, self.sin, self.cos, self.x, self.y])


def originals(requests: Sequence[PocketRequest]) -> list[int]:
    """Return for each request the number of the first one that it is a copy of, or its own."""
    found: list[int] = []
    firsts: list[int] = []
    for number, request in enumerate(requests):
        same = (n for n in firsts if displacement(requests[n], request) is not None)
        first = next(same, number)
        if first == number:
            firsts.append(number)
        found.append(first)
    return found


def moved(
    outcome: Plan | SpiralPocketError, original: PocketRequest, request: PocketRequest
) -> Plan | SpiralPocketError:
    """Return what came of a request as that of a copy of it.

    Parameters
    ----------
    outcome : Plan or SpiralPocketError
    original, request : PocketRequest
        What it is of, and the copy.

    Raises
    ------
    ValueError
        If it is no copy.
    """
    way = displacement(original, request)
    if way is None:
        raise ValueError("the pockets are no copies of each other")
    if isinstance(outcome, SpiralPocketError):
        return outcome.moved(way.place)
    path = outcome.toolpath
    toolpath = replace(
        path,
        start=way.points(path.start[None])[0],
        points=way.points(path.points),
        centers=way.points(path.centers),
    )
    report = outcome.report
    report = replace(
        report,
        # axes may differ
        time=time_of(toolpath, machine_of(request)).total if way.sin else report.time,
        engagement_points=way.points(report.engagement_points),
        uncut=way.shape(report.uncut),
        gouge_place=report.gouge_place and way.place(report.gouge_place),
        notices=tuple(replace(n, place=n.place and way.place(n.place)) for n in report.notices),
    )
    curves = (replace(c, control_points=way.points(c.control_points)) for c in outcome.curves)
    return Plan(request, toolpath, report, tuple(curves))


def displacement(request: PocketRequest, other: PocketRequest) -> Displacement | None:
    """Return how the other pocket lies to one, None if it is no copy."""
    if abs(request.pocket.area - other.pocket.area) > SAME * request.pocket.length:
        return None
    if _without_places(request, request.pocket) != _without_places(other, request.pocket):
        return None
    mine, others = _shapes(request), _shapes(other)
    if [s and s.geom_type for s in mine] != [s and s.geom_type for s in others]:
        return None
    heights = [section.z for section in request.sections]
    if heights != [section.z for section in other.sections]:
        return None
    for way in _ways(request.pocket, other.pocket):
        if all(_is_at(a, b, way) for a, b in zip(mine, others, strict=True)):
            return way
    return None


def _without_places(request: PocketRequest, pocket: Polygon) -> PocketRequest:
    return replace(request, pocket=pocket, start_point=None, stock=None, beyond=None, sections=())


def _shapes(request: PocketRequest) -> list[Geometry | None]:
    """Return all shapes of a request; its start point is one."""
    start = None if request.start_point is None else shapely.Point(request.start_point)
    steps = [s for each in request.sections for s in (each.pocket, each.mouth, each.stock)]
    return [request.pocket, start, request.stock, request.beyond, *steps]


def _ways(shape: Polygon, other: Polygon) -> Iterator[Displacement]:
    """Yield the ways in which one outline may be displaced to another, moves alone first.

    Of its points the one farthest from the middle comes where another one is as far.
    """
    here, there = (shapely.get_coordinates(s.centroid)[0] for s in (shape, other))
    yield Displacement(1.0, 0.0, *(there - here).tolist())
    arms, others = (
        shapely.get_coordinates(s.exterior)[:-1] - c for s, c in ((shape, here), (other, there))
    )
    lengths, reaches = np.hypot(*arms.T), np.hypot(*others.T)
    far = int(np.argmax(lengths))
    alike = np.abs(reaches - lengths[far]) < 4 * SAME
    turns = np.arctan2(*others[alike].T[::-1]) - math.atan2(arms[far, 1], arms[far, 0])
    turns = wrapped(turns)
    for turn in sorted(turns.tolist(), key=abs)[:TURNS]:
        c, s = math.cos(turn), math.sin(turn)
        x, y = there - (c * here[0] - s * here[1], s * here[0] + c * here[1])
        yield Displacement(c, s, float(x), float(y))


def _is_at(shape: Geometry | None, other: Geometry | None, way: Displacement) -> bool:
    """Return whether a shape displaced is another."""
    if shape is None or other is None:
        return shape is other
    if shape.is_empty or other.is_empty:
        return shape.is_empty and other.is_empty
    lines = [s.boundary if s.area else s for s in (way.shape(shape), other)]
    return bool(shapely.hausdorff_distance(*lines) <= SAME)
