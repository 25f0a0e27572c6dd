# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all laps of a region have in common: the plate's temperature, and what a lap encloses."""

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
from ..shapes.polyline import ring_points
from ..shapes.region import INSET, grow, polygons_of, rings_of, rounded_inside
from ..shapes.shaping import oriented
from .nested import SPACING
from .poisson import HeatField, solve

if TYPE_CHECKING:
    from contourpy import ContourGenerator

#: Nodes of the grid; more where the spacing would pass this share of the step-over, up to `MOST`.
UNKNOWNS, COARSEST, MOST = 12_000, 0.5, 150_000
#: That share where a slot is kept hot, whose ends are close to each other.
COARSEST_HOT = 0.35
#: Largest deviation of refitted laps over the step-over, and [mm] (the paper's).
DEVIATION, LARGEST_DEVIATION = 0.04, 0.5
#: Where the library is missing that finds the isotherms on the grid.
_NO_CONTOURS = (
    "It comes with matplotlib 3.6 or later: install that with FreeCAD's Addon Manager, or choose "
    "another strategy."
)


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
class Enclosed:
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
    if hot is not None and not rounded.covers(hot):
        # the slot runs into a corner; it keeps off the walls themselves
        rounded = _rounded(region, 0.0)
    even = math.sqrt(rounded.area / UNKNOWNS)
    coarsest = (COARSEST if hot is None else COARSEST_HOT) * stepover
    spacing = max(min(even, coarsest), math.sqrt(rounded.area / MOST))
    heat = 0.0
    if hot is not None:
        # between walls so far apart an evenly heated plate is half as hot
        heat = float(distances(points_of(rounded), [hot]).max()) ** 2
    field = solve(rounded, spacing, hot, heat)
    return Family(field, _contours(field), rounded, request, deviation, hot, heat)


def evenly_divided(family: Family, room: Enclosed, finer: int = 1) -> tuple[Family, Enclosed]:
    """Return laps that divide the way from a room's lap to the hot slot inside of it evenly.

    Where the slot bends inwards the plate is as hot as the slot far off it, and isotherms are no
    guide any more.

    Parameters
    ----------
    family : Family
    room : Enclosed
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
    return one, Enclosed(room.region, 0.0, inside, room.patches)


def _rounded(region: Polygon, fillet: float) -> Polygon:
    """Return the region, corners rounded by a radius [mm], unless that costs a neck or an island.

    It keeps off the walls by `INSET`.
    """
    parts = rounded_inside(region, fillet, INSET)
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


def points_of(region: Polygon) -> Floats:
    """Return the points of a region's rings, the first not repeated, shape (n, 2) [mm]."""
    return np.vstack([ring_points(ring) for ring in rings_of(region)])


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
