# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rest machining: what earlier operations of the job have left standing in a pocket.

Their paths are read as they are, whichever operation made them: of each level what a flat cutter
has swept at its own depth, or deeper, is gone. As in FreeCAD's own pockets these are the operations
that stand before this one in the job and are active.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import shapely
from shapely import MultiPolygon, Polygon

from ..engine.contact.swept import Pieces, cut_into_pieces
from ..engine.errors import RequestError
from ..engine.levels import at_level, floors, levels_of
from ..engine.model import PocketRequest, Section
from ..engine.proof.coverage import reachable_floor, uncut_floor
from ..engine.shapes.region import polygons_of
from ..engine.toolpath import Toolpath
from ..gcode import parse_program
from .compat import operation_property, tool_shape
from .known import Known
from .rest_watch import standing_before
from .tools import FLAT_TOOLS

#: A path that ends this much above the floor has cleared it [mm].
SHALLOW = 0.005
#: Walls of earlier cuts may be off by this; what is thinner than twice that is no rest [mm].
SKIN = 0.015
#: The rest is taken for wider by this [mm]: cutting air does no harm.
MORE = 0.005
#: Stock around a pocket without open sides, over the cutter's diameter.
AROUND = 10.0
#: Where no feed is given any will do here [mm/s].
ANY_FEED = 1.0
#: Words of a path that turns the part.
_TURNS = re.compile(r"\b[ABC]\s*[-+.\d]")


def rest_of(wanted: PocketRequest, obj: Any, known: Known) -> PocketRequest:
    """Return a request for what earlier operations have left of a pocket.

    Parameters
    ----------
    wanted : PocketRequest
        For the whole pocket.
    obj : object
        The operation.
    known : Known
        See `Pockets`.
    """
    cutters = list(cutters_before(obj))

    def standing(section: Section) -> shapely.Geometry:
        return _standing((section.pocket, section.z), cutters, wanted, known)

    sections = wanted.sections or _levels(wanted)
    if not wanted.sections and _is_skin(standing(sections[-1]), standing(sections[0])):
        sections = sections[-1:]
    rests = [standing(section) for section in sections]
    if all(rest is s.pocket for rest, s in zip(rests, sections, strict=True)):
        return wanted
    rests = [shapely.buffer(shapely.buffer(rest, -SKIN), SKIN + MORE) for rest in rests]
    around = _around(wanted)
    stocks = [
        _without(around, shapely.difference(s.pocket, rest))
        for rest, s in zip(rests, sections, strict=True)
    ]
    if len(sections) == 1 and not wanted.sections:
        return replace(wanted, stock=stocks[0])
    # corners that stay at one level are nothing to cut at another
    radius, left = wanted.cutter_radius, wanted.cutting.stock_to_leave
    within = [reachable_floor(s.pocket, radius, left) for s in sections]
    rests = [shapely.intersection(rest, w) for rest, w in zip(rests, within, strict=True)]
    cleared = shapely.difference(sections[0].pocket, shapely.union_all(rests))
    levels = zip(sections, stocks, strict=True)
    return replace(
        wanted,
        stock=_without(around, cleared),
        sections=tuple(replace(section, stock=stock) for section, stock in levels),
    )


def _levels(wanted: PocketRequest) -> tuple[Section, ...]:
    """Return the levels between vertical walls."""
    bottoms = floors(wanted.heights, wanted.cutting.floor_stock)
    return tuple(Section(z, wanted.pocket) for z in bottoms)


def _is_skin(low: shapely.Geometry, high: shapely.Geometry) -> bool:
    """Return whether what stands at a level and not at a higher one is too thin for a rest."""
    return bool(shapely.buffer(shapely.difference(low, high), -SKIN).is_empty)


def _around(wanted: PocketRequest) -> Polygon | MultiPolygon:
    """Return where stock stands before any operation of the job."""
    if wanted.stock is not None:
        return wanted.stock
    reach = AROUND * wanted.tool_diameter
    # walls that lean outwards are far beyond the floor
    widest = [s.pocket if s.mouth is None else s.mouth for s in wanted.sections]
    bounds = shapely.total_bounds([wanted.pocket, *widest])
    return shapely.buffer(shapely.box(*bounds), reach, join_style="mitre")


def _without(around: shapely.Geometry, cleared: shapely.Geometry) -> Polygon | MultiPolygon:
    parts = polygons_of(shapely.difference(around, cleared))
    return parts[0] if len(parts) == 1 else MultiPolygon(parts)


def _standing(
    floor: tuple[Polygon, float],
    cutters: Sequence[tuple[str, float]],
    wanted: PocketRequest,
    known: Known,
) -> shapely.Geometry:
    """Return what earlier operations have left of a level's floor; itself if they were not there.

    Parameters
    ----------
    floor : tuple of shapely.Polygon and float
        The pocket at the bottom of the level, and that bottom's Z [mm].
    cutters : sequence of tuple
        See `cutters_before`.
    wanted, known
        See `rest_of`.
    """
    pocket, z = floor
    rest: shapely.Geometry = pocket
    for program, diameter in cutters:
        key = (program, diameter, rest.wkb, z, wanted.axial_depth)
        if key not in known.rests:
            pieces = _pieces(program, diameter / 2, z, wanted.axial_depth, known)
            known.rests[key] = rest
            if pieces is not None:
                known.rests[key] = uncut_floor(rest, pieces, z + SHALLOW, diameter / 2, 0.0)
        rest = known.rests[key]
    return rest


def share_cleared(request: PocketRequest) -> float:
    """Return which share of a pocket's volume was cleared before, in [0, 1]."""
    if not request.sections:  # the same is left at all levels
        left, whole = request.to_clear(request.pocket).area, _inside(request.pocket, request).area
        return 1 - float(left / whole)
    levels = levels_of(request)
    heights = [level.top - level.bottom for level in levels]
    whole = [_inside(level.pocket, request).area for level in levels]
    left = [at_level(request, level).to_clear(level.pocket).area for level in levels]
    return 1 - float(np.dot(heights, left) / np.dot(heights, whole))


def _inside(pocket: Polygon, request: PocketRequest) -> shapely.Geometry:
    """Return the ground of a pocket within its own edge."""
    return pocket if request.beyond is None else pocket.difference(request.beyond)


def operations_before(obj: Any) -> Iterator[Any]:
    """Yield the active operations of the job that stand before this one and have a path."""
    for operation, _ in standing_before(obj):
        path = getattr(operation, "Path", None)
        if path is not None and path.Size and operation_property(operation, "Active"):
            yield operation


def cutters_before(obj: Any) -> Iterator[tuple[str, float]]:
    """Yield the programs before this one that may clear floors, and their cutters' widths [mm]."""
    for operation in operations_before(obj):
        controller = operation_property(operation, "ToolController")
        if controller is None:
            continue
        tool = controller.Proxy.getTool(controller)
        if tool and tool_shape(tool) in FLAT_TOOLS:
            yield operation.Path.toGCode(), float(tool.Diameter)


def _pieces(program: str, radius: float, floor: float, depth: float, known: Known) -> Pieces | None:
    """Return the motion of a path near the floor; None if it is none that clears a floor."""
    if program not in known.paths:  # every level asks for it again
        known.paths[program] = _path(program)
    path = known.paths[program]
    return None if path is None else cut_into_pieces(path, radius, floor + 2 * SHALLOW, depth)


def _path(program: str) -> Toolpath | None:
    """Return a path that may clear floors, None if it cannot."""
    if _TURNS.search(re.sub(r"\([^)]*\)", "", program)):
        return None
    try:
        return parse_program(program, feed=ANY_FEED)
    except RequestError:  # a path of holes, or none at all
        return None
