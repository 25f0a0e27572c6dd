# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isotherms as laps: contours of the temperature, refitted and nested.

The isotherms of a room at some temperature enclose one or more rooms that are
hotter; where they enclose an island they have inner rings.
"""

from __future__ import annotations

import math

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy import ndimage
from shapely import Polygon

from ..model import Floats
from ..shapes.points import signed_area
from ..shapes.polyline import ring_points
from ..shapes.region import INSET, polygons_of, rings_of
from ..shapes.shaping import oriented
from .family import Enclosed, Family, points_of
from .hermite_quartic import ClosedFit
from .nested import SPACING, Mover
from .poisson import HeatField

#: The deviation of refitted laps is halved so often until they do not cross themselves.
HALVINGS = 3
#: Between the points that are fitted a lap may be so much farther from its isotherm, and where it
#: keeps inside of the one before, and by so much more over the grid's spacing, as the contour's
#: chords cut its bends; one in so many of its points is looked at.
FARTHER, BULGE, SOME = 1.5, 0.1, 5
#: The last lap is refitted within these shares of `INSET`, the first that keeps off; about so long
#: are its patches [mm].
WALL_SHARES, WALL_PATCH = (1.0, 0.4), 5.0
#: Steps along a gradient line.
GRADIENT_STEPS = 4


def mover(field: HeatField, even: HeatField | None = None, heat: float = math.inf) -> Mover:
    """Return what moves points along gradient lines; see `nested.Mover`.

    Parameters
    ----------
    field : HeatField
    even : HeatField, optional
        Beside a hot slot laps follow this one; its levels are counted from `heat` on.
    heat : float, optional
        [mm2]
    """

    def move(points: Floats, level: float, to_level: float) -> Floats:
        along = field
        if even is not None and to_level > heat:
            along, level, to_level = even, max(level - heat, 0.0), to_level - heat
        rise = (to_level - level) / GRADIENT_STEPS
        for _ in range(GRADIENT_STEPS):
            middle = points + _uphill(along, points) * rise / 2
            points = points + _uphill(along, middle) * rise
        return points

    return move


def _uphill(field: HeatField, points: Floats) -> Floats:
    """Return the way from points, shape (n, 2) [mm], along the gradient for a rise of 1 mm2.

    Of the same shape [1/mm], less where the slope is below the grid's spacing.
    """
    slope = field.gradient(points)
    return slope / np.maximum((slope**2).sum(axis=1), field.spacing**2)[:, None]


def outer_room(family: Family) -> Enclosed:
    """Return the room within the wall, its lap a closed C2 curve where laps are refitted."""
    region, wall = family.region, family.region
    fence = shapely.buffer(region, INSET)
    if family.deviation > 0:
        dense = shapely.segmentize(region, 2 * SPACING)
        guess = round(region.length / WALL_PATCH)
        walls = (refitted(dense, INSET * share, guess)[0] for share in WALL_SHARES)
        wall = next((w for w in walls if w.is_valid and fence.covers(w)), region)
    return Enclosed(wall, 0.0, _nodes_of(family))


def _nodes_of(family: Family) -> NDArray[np.bool_]:
    """Return the nodes of a family's field, those of the hot slot among them.

    Where walls are so close to the slot that no node is between, a lap is beside these.
    """
    field, nodes = family.field, family.field.inside.copy()
    if family.hot is not None:
        rows, columns = np.nonzero(np.isfinite(field.values) & ~nodes)
        x, y = field.xy
        nodes[rows, columns] = shapely.contains_xy(family.hot, x[columns], y[rows])
    return nodes


def lines_at(family: Family, room: Enclosed, level: float) -> list[Floats]:
    """Return the isotherms of a room at a temperature [mm2], as they come off the grid.

    Closed lines of shape (n, 2) each [mm]: counter-clockwise about what is hotter, clockwise about
    islands.
    """
    found = []
    for line in family.contours.lines(level):
        points = np.asarray(line)
        if len(points) < 4 or not np.array_equal(points[0], points[-1]):
            continue
        if family.field.is_beside(points[0], room.nodes):
            found.append(points)
    return found


def isotherms(family: Family, room: Enclosed, level: float) -> list[Polygon]:
    """Return the parts of a room that are hotter than `level` [mm2], as they come off the grid."""
    shells: list[Floats] = []
    holes: list[Floats] = []
    for points in lines_at(family, room, level):
        (shells if signed_area(points) > 0 else holes).append(points)
    if not holes:
        return [Polygon(shell) for shell in shells]
    outlines = [Polygon(shell) for shell in shells]
    inner: list[list[Floats]] = [[] for _ in shells]
    for hole in holes:
        place = shapely.Point(hole[0])
        about = [i for i, outline in enumerate(outlines) if outline.contains(place)]
        if about:
            inner[min(about, key=lambda i: outlines[i].area)].append(hole)
    return [Polygon(shell, rings) for shell, rings in zip(shells, inner, strict=True)]


def rooms_at(family: Family, room: Enclosed, level: float) -> list[Enclosed]:
    """Return the rooms within the laps at `level` [mm2], laps refitted, the hottest last."""
    field = family.field
    rooms = []
    hotter = room.nodes & (np.nan_to_num(field.values) > level)
    parts = isotherms(family, room, level)
    whole = len(parts) == 1 and ndimage.label(hotter)[1] == 1
    for part in parts:
        nodes = hotter if whole else _nodes_in(part, hotter, field)
        if nodes.any():
            lap, patches = _nested(family, part, room)
            rooms.append(Enclosed(lap, level, nodes, patches))
    return sorted(rooms, key=lambda r: r.peak(field)[1])


def _nodes_in(part: Polygon, nodes: NDArray[np.bool_], field: HeatField) -> NDArray[np.bool_]:
    """Return which of some nodes of a field, shape (ny, nx), lie in a polygon."""
    rows, columns = np.nonzero(nodes)
    x, y = field.xy
    inside = shapely.contains_xy(part, x[columns], y[rows])
    found = np.zeros_like(nodes)
    found[rows[inside], columns[inside]] = True
    return found


def _nested(family: Family, part: Polygon, room: Enclosed) -> tuple[Polygon, int]:
    """Return a lap refitted so that it keeps inside its room, and how many patches it has.

    Along ridges, and beside saddles, laps are closer than their deviation. There a lap takes the
    way of the one before instead of one that is as close and crosses it.
    """
    if family.deviation == 0:
        return part, room.patches
    shapely.prepare(room.region)
    fits = _fits(part)
    guess = round(room.patches * min(1.0, fits[0].length / room.region.exterior.length))
    for halving in range(HALVINGS):
        bound = family.deviation * 0.5**halving
        lap, guess = _of_fits(fits, bound, guess)
        if not lap.is_valid:
            continue
        inside = [lap]
        if not room.region.contains(lap):
            inside = polygons_of(shapely.intersection(lap, room.region))
        if _is_all_of(part, inside, slack(family, bound)):
            return oriented(inside[0]), guess
    return part, room.patches


def slack(family: Family, bound: float | None = None) -> float:
    """Return how far from its isotherm a lap may be that is refitted within a bound [mm]."""
    deviation = family.deviation if bound is None else bound
    return FARTHER * deviation + BULGE * family.field.spacing


def _is_all_of(part: Polygon, inside: list[Polygon], bound: float) -> bool:
    """Return whether the first of some polygons is an isotherm's region to within a bound [mm]."""
    if not inside or len(inside[0].interiors) != len(part.interiors):
        return False
    if abs(inside[0].area - part.area) > bound * part.length:
        return False
    line = part.boundary
    shapely.prepare(line)
    places = shapely.points(points_of(inside[0])[::SOME])
    return bool(shapely.dwithin(line, places, bound).all())


def refitted(part: Polygon, deviation: float, guess: int = 8) -> tuple[Polygon, int]:
    """Return a region whose rings are refitted within a deviation, and its outer ring's patches.

    Parameters
    ----------
    part : shapely.Polygon
    deviation : float
        [mm]
    guess : int, optional
        Patches of the outer ring from which the search begins; see `ClosedFit.within`.
    """
    return _of_fits(_fits(part), deviation, guess)


def _fits(part: Polygon) -> list[ClosedFit]:
    """Return what fits the rings of a region."""
    return [ClosedFit(ring_points(ring)) for ring in rings_of(part)]


def _of_fits(fits: list[ClosedFit], deviation: float, guess: int) -> tuple[Polygon, int]:
    """Return the region of rings fitted within a deviation [mm], and its outer ring's patches."""
    counts = [round(guess * fit.length / fits[0].length) for fit in fits]
    curves = [fit.within(deviation, count) for fit, count in zip(fits, counts, strict=True)]
    shell, *holes = [curve.sample(SPACING) for curve in curves]
    return oriented(Polygon(shell, holes)), len(curves[0].breaks) - 1
