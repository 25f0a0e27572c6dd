# SPDX-License-Identifier: LGPL-2.1-or-later
"""A planned path as vertices along its time, and its floor as areas: what a window draws.

The vertices are the ends of all moves, points on arcs and the places where the
engagement was measured; between two neighbors everything is constant enough to be
one color. Nothing here needs a window, and only numpy arrays come out.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from .engine.machine import machine_of
from .engine.model import Floats, Plan
from .engine.motion.stations import ends_of, moves_at, points_at, stations_of
from .engine.motion.timing import time_of
from .engine.proof.coverage import reachable_floor
from .engine.shapes.region import polygons_of
from .engine.toolpath import Kind, Toolpath

#: Angle of the chords of a drawn arc [rad].
ARC_STEP = np.radians(8)
#: Left-over pieces of less area than this share of the cutter's disc are not shown.
TOLD_LEFT = 1e-3
#: Heights closer than this are one level [mm]; one is loaded that has this share of the most.
SAME_HEIGHT, LOADED = 1e-3, 0.7
#: Walls are shown where the stock is no farther than this [mm].
TOUCHES = 0.01


@dataclass(frozen=True, slots=True, eq=False)
class Trace:
    """A path as n vertices in the order of travel, and the n - 1 stretches between them.

    Attributes
    ----------
    points : ndarray of shape (n, 3)
        Cutter centers [mm].
    clock : ndarray of shape (n,)
        When the machine is there [s].
    speeds : ndarray of shape (n,)
        How fast the machine is there [mm/s].
    roles : ndarray of int8, shape (n - 1,)
        `Role` of each stretch.
    feeds : ndarray of shape (n - 1,)
        Programmed feed or rapid rate of each stretch [mm/s].
    angles : ndarray of shape (n - 1,)
        Engagement angle of each stretch [rad]; 0 in the air.
    """

    points: Floats
    clock: Floats
    speeds: Floats
    roles: NDArray[np.int8]
    feeds: Floats
    angles: Floats

    def point_at(self, seconds: float) -> Floats:
        """Return where the cutter's center is at a time, shape (3,) [mm]."""
        return np.array([np.interp(seconds, self.clock, c) for c in self.points.T])


@dataclass(frozen=True, slots=True, eq=False)
class Areas:
    """The floor of a pocket in pieces without holes, each a ring of shape (k, 2) [mm].

    Attributes
    ----------
    cleared, left, islands : tuple of ndarray
        What is cut, what stays standing (corners, necks, what was left uncut), what shall stay.
    walls : tuple of ndarray of shape (k, 2)
        All outlines of the pocket, closed.
    """

    cleared: tuple[Floats, ...]
    left: tuple[Floats, ...]
    islands: tuple[Floats, ...]
    walls: tuple[Floats, ...]


def trace_of(plan: Plan) -> Trace:
    """Return the trace of a plan on its request's machine."""
    path, report = plan.toolpath, plan.report
    if len(path) == 0:
        none = np.zeros(0)
        roles = np.zeros(0, np.int8)
        return Trace(path.start[None, :], np.zeros(1), np.zeros(1), roles, none, none)
    measured = stations_of(path, report.engagement_moves, report.engagement_points)
    stations = np.unique(np.concatenate([[0.0], ends_of(path), _on_arcs(path), measured]))
    stations = stations[np.diff(stations, prepend=-1.0) > 1e-7]
    begins = ends_of(path) - path.lengths
    moves = moves_at(path, stations)
    with np.errstate(invalid="ignore", divide="ignore"):
        shares = np.nan_to_num((stations - begins[moves]) / path.lengths[moves])
    motion = time_of(path, machine_of(plan.request))
    middles = (stations[1:] + stations[:-1]) / 2
    on = moves_at(path, middles)
    cutting = path.kinds[on] != Kind.RAPID
    angles = (
        np.interp(middles, measured, report.engagement_angles) if len(measured) else middles * 0
    )
    return Trace(
        points=points_at(path, moves, np.clip(shares, 0.0, 1.0)),
        clock=motion.clock_at(stations),
        speeds=motion.speed_at(stations),
        roles=path.roles[on],
        feeds=path.feeds[on],
        angles=np.where(cutting, angles, 0.0),
    )


def areas_of(plan: Plan) -> Areas:
    """Return what of the floor is cleared, and what stays."""
    request, uncut = plan.request, plan.report.uncut
    radius, stock = request.cutter_radius, request.cutting.stock_to_leave
    reach = request.to_clear(reachable_floor(request.pocket, radius, stock))
    wanted = request.to_clear(request.pocket.buffer(-stock) if stock else request.pocket)
    cleared = shapely.difference(reach, uncut)
    left = shapely.get_parts(shapely.difference(wanted, cleared))
    left = left[shapely.area(left) > TOLD_LEFT * np.pi * radius**2]
    islands = [Polygon(ring) for ring in request.pocket.interiors]
    walls = request.pocket.boundary
    if request.stock is not None:
        beside = shapely.buffer(request.stock, TOUCHES)
        walls = shapely.line_merge(shapely.intersection(walls, beside))
    return Areas(
        cleared=pieces_without_holes(polygons_of(cleared)),
        left=pieces_without_holes(left),
        islands=pieces_without_holes(islands),
        walls=tuple(shapely.get_coordinates(line) for line in shapely.get_parts(walls)),
    )


def pieces_without_holes(polygons: Iterable[Polygon]) -> tuple[Floats, ...]:
    """Return polygons cut into pieces without holes, each a ring of shape (k, 2) [mm].

    A cut goes straight up and down through every hole.
    """
    rings: list[Floats] = []
    for polygon in polygons:
        parts: Iterable[Polygon] = [polygon]
        if polygon.interiors:
            _, low, _, high = polygon.bounds
            places = [Polygon(hole).representative_point().x for hole in polygon.interiors]
            cuts = [shapely.LineString([(x, low - 1), (x, high + 1)]) for x in sorted(set(places))]
            lines = shapely.union_all([polygon.boundary, *cuts])
            faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(lines)))
            parts = [f for f in faces if polygon.contains(f.representative_point())]
        rings += [shapely.get_coordinates(part.exterior)[:-1] for part in parts]
    return tuple(rings)


def _on_arcs(path: Toolpath) -> Floats:
    """Return stations along all arcs, as far apart as chords may be [mm]."""
    arcs = np.flatnonzero(path.is_arc)
    counts = np.ceil(np.abs(path.sweeps[arcs]) / ARC_STEP).astype(int)
    begins = (ends_of(path) - path.lengths)[arcs]
    steps = [
        begin + length * np.arange(1, count) / count
        for begin, length, count in zip(begins, path.lengths[arcs], counts, strict=True)
    ]
    return np.concatenate(steps) if steps else np.zeros(0)


def loaded_level(heights: Floats, angles: Floats) -> float:
    """Return the lowest height [mm] at which cuts are loaded nearly as much as at any other.

    On a thin last level the engagement is a part of that on a full one, which a picture from above
    had better show.

    Parameters
    ----------
    heights, angles : ndarray of shape (n,)
        Of places on cuts [mm], and the engagement there [rad].
    """
    levels, of = np.unique(np.round(heights / SAME_HEIGHT), return_inverse=True)
    means = np.bincount(of, weights=angles) / np.bincount(of)
    return float(levels[np.flatnonzero(means >= LOADED * means.max())[0]] * SAME_HEIGHT)
