# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rest machining: what earlier operations of the job have left standing in a pocket.

Their paths are read as they are, whichever operation made them: what a flat cutter has swept at the
depth of the pocket's floor, or deeper, is gone; where walls are not upright, at the depth of every
level. As in FreeCAD's own pockets these are the operations that stand before this one in the job
and are active.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import shapely
from shapely import MultiPolygon, Polygon

from ..engine.contact.swept import Pieces, cut_into_pieces
from ..engine.errors import RequestError
from ..engine.model import PocketRequest
from ..engine.proof.coverage import reachable_floor, uncut_floor
from ..engine.shapes.region import polygons_of
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
    floors = [(s.pocket, s.z) for s in wanted.sections] or [(wanted.pocket, wanted.floor)]
    cutters = list(_cutters_before(obj))
    rests = [_standing(floor, cutters, wanted, known) for floor in floors]
    if all(rest is pocket for rest, (pocket, _) in zip(rests, floors, strict=True)):
        return wanted
    rests = [shapely.buffer(shapely.buffer(rest, -SKIN), SKIN + MORE) for rest in rests]
    if wanted.sections:
        # corners that stay at one level are nothing to cut at another
        radius, left = wanted.cutter_radius, wanted.cutting.stock_to_leave
        within = [reachable_floor(pocket, radius, left) for pocket, _ in floors]
        rests = [shapely.intersection(rest, w) for rest, w in zip(rests, within, strict=True)]
    rest = shapely.union_all(rests)  # where at some level something stands
    cleared = shapely.difference(floors[0][0], rest)
    around = wanted.stock
    if around is None:
        reach = AROUND * wanted.tool_diameter
        # walls that lean outwards are far beyond the floor
        widest = [s.pocket if s.mouth is None else s.mouth for s in wanted.sections]
        bounds = shapely.total_bounds([wanted.pocket, *widest])
        around = shapely.buffer(shapely.box(*bounds), reach, join_style="mitre")
    parts = polygons_of(shapely.difference(around, cleared))
    return replace(wanted, stock=parts[0] if len(parts) == 1 else MultiPolygon(parts))


def _standing(
    floor: tuple[Polygon, float],
    cutters: Sequence[tuple[Any, float]],
    wanted: PocketRequest,
    known: Known,
) -> shapely.Geometry:
    """Return what earlier operations have left of a level's floor; itself if they were not there.

    Parameters
    ----------
    floor : tuple of shapely.Polygon and float
        The pocket at the bottom of the level, and that bottom's Z [mm].
    cutters : sequence of tuple
        See `_cutters_before`.
    wanted, known
        See `rest_of`.
    """
    pocket, z = floor
    rest: shapely.Geometry = pocket
    for operation, diameter in cutters:
        program = operation.Path.toGCode()
        key = (program, diameter, rest.wkb, z, wanted.axial_depth)
        if key not in known.rests:
            pieces = _pieces(program, diameter / 2, z, wanted.axial_depth)
            known.rests[key] = rest
            if pieces is not None:
                known.rests[key] = uncut_floor(rest, pieces, z + SHALLOW, diameter / 2, 0.0)
        rest = known.rests[key]
    return rest


def share_cleared(request: PocketRequest) -> float:
    """Return which share of a pocket was cleared before, in [0, 1]."""
    return 1 - float(request.to_clear(request.pocket).area) / _inside(request).area


def _inside(request: PocketRequest) -> Polygon:
    """Return the ground of a pocket within its own edge."""
    pocket = request.pocket
    return pocket if request.beyond is None else pocket.difference(request.beyond)


def operations_before(obj: Any) -> Iterator[Any]:
    """Yield the active operations of the job that stand before this one and have a path."""
    for operation, _ in standing_before(obj):
        path = getattr(operation, "Path", None)
        if path is not None and path.Size and operation_property(operation, "Active"):
            yield operation


def _cutters_before(obj: Any) -> Iterator[tuple[Any, float]]:
    """Yield the operations before this one that clear floors, and their cutters' diameters [mm]."""
    for operation in operations_before(obj):
        controller = operation_property(operation, "ToolController")
        if controller is None:
            continue
        tool = controller.Proxy.getTool(controller)
        if tool and tool_shape(tool) in FLAT_TOOLS:
            yield operation, float(tool.Diameter)


def _pieces(program: str, radius: float, floor: float, depth: float) -> Pieces | None:
    """Return the motion of a path near the floor; None if it is none that clears a floor."""
    if _TURNS.search(re.sub(r"\([^)]*\)", "", program)):
        return None
    try:
        path = parse_program(program, feed=ANY_FEED)
    except RequestError:  # a path of holes, or none at all
        return None
    return cut_into_pieces(path, radius, floor + 2 * SHALLOW, depth)
