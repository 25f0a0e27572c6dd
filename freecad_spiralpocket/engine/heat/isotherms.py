# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isotherms as laps: contours of the temperature, refitted and nested.

A `Family` holds what all laps of one region have in common, a `Room` is what one lap
encloses. The isotherms of a room at some temperature enclose one or more rooms that are
hotter; where they enclose an island they have inner rings.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial import cKDTree
from shapely import Polygon

from ..dependencies import require
from ..model import Floats, PocketRequest
from ..shapes.points import signed_area
from ..shapes.region import grow, polygons_of
from ..shapes.shaping import oriented
from .hermite_quartic import ClosedFit
from .nested import SPACING, Mover
from .poisson import HeatField, solve

if TYPE_CHECKING:
    from contourpy import ContourGenerator

#: Nodes of the grid; more where the spacing would pass this share of the step-over, up to `MOST`.
UNKNOWNS, COARSEST, MOST = 12_000, 0.5, 150_000
#: That share where a slot is kept hot, whose ends are close to each other.
COARSEST_HOT = 0.35
#: Largest deviation of refitted laps over the step-over, and [mm] (the paper's).
DEVIATION, LARGEST_DEVIATION = 0.04, 0.5
#: It is halved so often until laps do not cross themselves.
HALVINGS = 3
#: Where the library is missing that finds the isotherms on the grid.
_NO_CONTOURS = (
    "It comes with matplotlib 3.6 or later: install that with FreeCAD's Addon Manager, or choose "
    "another strategy."
)
#: Between the points that are fitted a lap may be so much farther from its isotherm, and where it
#: keeps inside of the one before, and by so much more over the grid's spacing, as the contour's
#: chords cut its bends; one in so many of its points is looked at.
FARTHER, BULGE, SOME = 1.5, 0.1, 5
#: The last lap keeps off the wall by this [mm].
INSET = 0.01
#: It is refitted within these shares of that, the first that keeps off; about so long are its
#: patches [mm].
WALL_SHARES, WALL_PATCH = (1.0, 0.4), 5.0
#: Steps along a gradient line.
GRADIENT_STEPS = 4


@dataclass(frozen=True, slots=True, eq=False)
class Family:
    """The isotherms of one region, and how laps are chosen among them.

    Attributes
    ----------
    field : HeatField
    contours : contourpy.ContourGenerator
        Of the field.
    region : shapely.Polygon
        The cutter-center region, corners rounded.
    request : PocketRequest
    deviation : float
        Largest deviation of refitted laps [mm]; 0 for raw isotherms.
    hot : shapely.Polygon or None
        The slot that is kept hot.
    heat : float
        Its temperature [mm2].
    is_even : bool
        Whether the field is no temperature but the share of the way to the slot, times the heat.
    """

    field: HeatField
    contours: ContourGenerator
    region: Polygon
    request: PocketRequest
    deviation: float
    hot: Polygon | None = None
    heat: float = 0.0
    is_even: bool = False

    @property
    def stepover(self) -> float:
        """Return the largest distance of laps [mm]."""
        return self.request.cutting.stepover


@dataclass(frozen=True, slots=True, eq=False)
class Room:
    """What a lap encloses.

    Attributes
    ----------
    region : shapely.Polygon
        The lap is its boundary.
    level : float
        Temperature of the lap [mm2].
    nodes : ndarray of bool, shape (ny, nx)
        Nodes of the field that are hotter.
    patches : int
        Of the lap's outer ring.
    """

    region: Polygon
    level: float
    nodes: NDArray[np.bool_]
    patches: int = 8

    def peak(self, field: HeatField) -> tuple[Floats, float]:
        """Return place, shape (2,) [mm], and temperature [mm2] of the hottest node."""
        values = np.where(self.nodes, field.values, -np.inf)
        row, column = np.unravel_index(int(np.argmax(values)), values.shape)
        x, y = field.xy
        return np.array([x[column], y[row]]), float(values[row, column])


def family_of(
    region: Polygon,
    request: PocketRequest,
    fillet: float,
    deviation: float | None = None,
    hot: Polygon | None = None,
) -> Family:
    """Return the isotherms of a cutter-center region.

    Parameters
    ----------
    region : shapely.Polygon
    request : PocketRequest
    fillet : float
        Radius with which its corners are rounded [mm].
    deviation : float, optional
        Largest deviation of refitted laps [mm]; 0 for raw isotherms.
    hot : shapely.Polygon, optional
        A slot in it that is kept hot.
    """
    stepover = request.cutting.stepover
    if deviation is None:
        deviation = min(LARGEST_DEVIATION, DEVIATION * stepover)
    rounded = _rounded(region, fillet)
    even = math.sqrt(rounded.area / UNKNOWNS)
    coarsest = (COARSEST if hot is None else COARSEST_HOT) * stepover
    spacing = max(min(even, coarsest), math.sqrt(rounded.area / MOST))
    heat = 0.0
    if hot is not None:
        # between walls so far apart an evenly heated plate is half as hot
        heat = float(distances(points_of(rounded), [hot]).max()) ** 2
    field = solve(rounded, spacing, hot, heat)
    return Family(field, _contours(field), rounded, request, deviation, hot, heat)


def evened(family: Family, room: Room, finer: int = 1) -> tuple[Family, Room]:
    """Return laps that divide the way from a room's lap to the hot slot inside of it evenly.

    Where the slot bends inwards the plate is as hot as the slot far off it, and isotherms are no
    guide any more.

    Parameters
    ----------
    family : Family
    room : Room
    finer : int, optional
        The grid has so many times as many rows and columns as that of the family.
    """
    field, hot = family.field, family.hot
    assert hot is not None
    for shape in (room.region, hot):
        shapely.prepare(shape)
    in_slot = shapely.contains_xy(hot, *np.meshgrid(*field.xy))
    beside = ndimage.binary_dilation(room.nodes | in_slot, iterations=2)
    if finer > 1:
        beside &= ~ndimage.binary_erosion(in_slot, iterations=2)
        beside = beside.repeat(finer, axis=0).repeat(finer, axis=1)
    spacing = field.spacing / finer
    rows, columns = np.nonzero(beside)
    x, y = (field.origin + spacing * np.column_stack([columns, rows])).T
    ways = []
    for shape in (room.region, hot):
        off = distances(np.column_stack([x, y]), [shapely.segmentize(shape, SPACING)])
        ways.append(np.where(shapely.contains_xy(shape, x, y), off, -off))
    from_lap, to_slot = ways[0], -ways[1]
    share = np.clip(from_lap / np.maximum(from_lap + to_slot, 1e-3), -1.0, 2.0)
    values = np.full(beside.shape, np.nan)
    values[rows, columns] = family.heat * share
    inside = np.zeros(beside.shape, bool)
    # those in the slot too: a lap may be so close to it that there are no others beside it
    inside[rows, columns] = from_lap > 0
    even = HeatField.of(field.origin, spacing, values, inside)
    one = replace(family, field=even, contours=_contours(even), is_even=True)
    return one, Room(room.region, 0.0, inside, room.patches)


def _rounded(region: Polygon, fillet: float) -> Polygon:
    """Return the region, corners rounded by a radius [mm], unless that costs a neck or an island.

    It keeps off the walls by `INSET`.
    """
    parts = polygons_of(grow(grow(region, -fillet - INSET), fillet))
    if len(parts) == 1 and len(parts[0].interiors) == len(region.interiors):
        return oriented(parts[0])
    parts = polygons_of(grow(region, -INSET))
    return oriented(parts[0] if len(parts) == 1 else region)


def _contours(field: HeatField) -> ContourGenerator:
    """Return what finds the isotherms of a field."""
    values = np.ma.masked_invalid(field.values)
    return require("contourpy", _NO_CONTOURS).contour_generator(
        *field.xy, values, line_type="Separate", corner_mask=False
    )


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


def outer_room(family: Family) -> Room:
    """Return the room within the wall, its lap a closed C2 curve where laps are refitted."""
    region, wall = family.region, family.region
    fence = shapely.buffer(region, INSET)
    if family.deviation > 0:
        dense = shapely.segmentize(region, 2 * SPACING)
        guess = round(region.length / WALL_PATCH)
        walls = (refitted(dense, INSET * share, guess)[0] for share in WALL_SHARES)
        wall = next((w for w in walls if w.is_valid and fence.covers(w)), region)
    return Room(wall, 0.0, _nodes_of(family))


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


def lines_at(family: Family, room: Room, level: float) -> list[Floats]:
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


def isotherms(family: Family, room: Room, level: float) -> list[Polygon]:
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


def rooms_at(family: Family, room: Room, level: float) -> list[Room]:
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
            rooms.append(Room(lap, level, nodes, patches))
    return sorted(rooms, key=lambda r: r.peak(field)[1])


def _nodes_in(part: Polygon, nodes: NDArray[np.bool_], field: HeatField) -> NDArray[np.bool_]:
    """Return which of some nodes of a field, shape (ny, nx), lie in a polygon."""
    rows, columns = np.nonzero(nodes)
    x, y = field.xy
    inside = shapely.contains_xy(part, x[columns], y[rows])
    found = np.zeros_like(nodes)
    found[rows[inside], columns[inside]] = True
    return found


def points_of(region: Polygon) -> Floats:
    """Return the points of a region's rings, the first not repeated, shape (n, 2) [mm]."""
    rings = (region.exterior, *region.interiors)
    return np.vstack([np.asarray(r.coords)[:-1] for r in rings])


def distances(points: Floats, regions: list[Polygon]) -> Floats:
    """Return the distance of each point, shape (n, 2), from the regions' boundaries [mm].

    Measured to the points of these; of shape (n,), infinite where there are no regions.
    """
    return from_lines(points, [points_of(region) for region in regions])


def from_lines(points: Floats, lines: list[Floats]) -> Floats:
    """Return the distance of each point, shape (n, 2), from the nearest point of some lines [mm].

    Of shape (n,), infinite where there are no lines.
    """
    if not lines:
        return np.full(len(points), np.inf)
    tree = cKDTree(np.vstack(lines), balanced_tree=False, compact_nodes=False)
    return np.asarray(tree.query(points)[0])


def _nested(family: Family, part: Polygon, room: Room) -> tuple[Polygon, int]:
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
    return [ClosedFit(np.asarray(r.coords)[:-1]) for r in (part.exterior, *part.interiors)]


def _of_fits(fits: list[ClosedFit], deviation: float, guess: int) -> tuple[Polygon, int]:
    """Return the region of rings fitted within a deviation [mm], and its outer ring's patches."""
    counts = [round(guess * fit.length / fits[0].length) for fit in fits]
    curves = [fit.within(deviation, count) for fit, count in zip(fits, counts, strict=True)]
    shell, *holes = [curve.sample(SPACING) for curve in curves]
    return oriented(Polygon(shell, holes)), len(curves[0].breaks) - 1
