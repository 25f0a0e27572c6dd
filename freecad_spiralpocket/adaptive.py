# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own Adaptive on the same pocket, for comparison.

Asks FreeCAD's clearing library (the extension module `area`, which needs neither a
document nor FreeCAD itself) with the operation's default values, and moves as its
operation does: helix in short lines at the vertical feed, cuts at the horizontal one,
rapids for its links. Measured by the same proof as our own paths.
"""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import shapely

from .engine.checks import check_request
from .engine.errors import SetupError, SpiralPocketError
from .engine.levels import floors
from .engine.machine import machine_of
from .engine.model import Floats, Plan, PocketRequest
from .engine.proof.verify import prove
from .engine.shapes.region import polygons_of
from .engine.toolpath import Role, Toolpath, ToolpathBuilder

#: Defaults of FreeCAD's operation: tolerance of the library, and its longest links at depth.
TOLERANCE, KEEP_DOWN_RATIO = 0.1, 3.0
#: A helix narrower than this is none [mm]; its radius is less by as much.
NO_HELIX = 0.01
#: Angle of the helix' chords [rad].
CHORD = math.pi / 16
#: In some pockets it never ends [s].
MOST_SECONDS = 60
#: Chords of curved walls [mm]; stock around the pocket [mm].
SAG, AROUND = 0.01, 20.0


def plan_adaptive(request: PocketRequest) -> Plan:
    """Return what FreeCAD's Adaptive makes of a request at the same step-over.

    Raises
    ------
    SpiralPocketError
        If this FreeCAD has no such library, or it finds no path, or no path could be cut.
    """
    check_request(request)
    toolpath = _toolpath(_regions(request), request)
    request = replace(request, machine=machine_of(request))
    return Plan(request, toolpath, prove(request, toolpath))


def _regions(request: PocketRequest) -> Sequence[Any]:
    """Return the library's result, one for each region."""
    try:
        import area
    except ImportError as error:
        raise SetupError("FreeCAD's Adaptive cannot be reached from here.") from error
    cutting, pocket = request.cutting, shapely.simplify(request.pocket, SAG / 5)
    clearing = area.Adaptive2d()
    clearing.stepOverFactor = cutting.stepover / request.tool_diameter
    clearing.toolDiameter = request.tool_diameter
    clearing.helixRampDiameter = request.entry.max_diameter
    clearing.keepToolDownDistRatio = KEEP_DOWN_RATIO
    clearing.stockToLeave = cutting.stock_to_leave
    clearing.tolerance = TOLERANCE
    clearing.forceInsideOut = False
    clearing.finishingProfile = True
    clearing.opType = area.AdaptiveOperationType.ClearingInside
    stock = request.stock or shapely.box(*pocket.bounds).buffer(AROUND, join_style="mitre")
    rings = [pocket.exterior, *pocket.interiors]
    # it starts from full stock, whatever was cleared before
    outlines = [_ring(part.exterior) for part in polygons_of(stock)]
    end = time.monotonic() + MOST_SECONDS

    def is_late(_: object) -> bool:
        return time.monotonic() > end

    found = clearing.Execute(outlines, [_ring(r) for r in rings], is_late)
    if is_late(None):
        raise SpiralPocketError(
            f"FreeCAD's Adaptive has found no path in this pocket within {MOST_SECONDS} s."
        )
    if not found or not found[0].AdaptivePaths:
        raise SpiralPocketError("FreeCAD's Adaptive finds no path in this pocket.")
    return list(found)


def _ring(ring: shapely.LinearRing) -> list[list[float]]:
    return [[float(x), float(y)] for x, y in shapely.get_coordinates(ring)]


def _toolpath(regions: Sequence[Any], request: PocketRequest) -> Toolpath:
    """Return the moves of all regions at all levels."""
    heights = request.heights
    first = regions[0].HelixCenterPoint
    builder = ToolpathBuilder((first[0], first[1], heights.clearance))
    radius = max(math.dist(r.HelixCenterPoint[:2], r.StartPoint[:2]) for r in regions)
    pitch = 2 * math.pi * radius * math.tan(request.entry.helix_angle)
    top = heights.start_depth
    for bottom in floors(heights, request.cutting.floor_stock):
        for region in regions:
            _go_down(builder, region, top, bottom, pitch, request)
            for motion, points in region.AdaptivePaths:
                _move(builder, int(motion), np.array(points, float), bottom, request)
            builder.rapid(request.feeds.vertical_rapid, z=heights.clearance)
        top = bottom
    return builder.build()


def _go_down(
    builder: ToolpathBuilder,
    region: Any,
    top: float,
    bottom: float,
    pitch: float,
    request: PocketRequest,
) -> None:
    """Add the helix from `top` to `bottom` and one flat turn, or a plunge."""
    feeds, heights = request.feeds, request.heights
    center, start = np.array(region.HelixCenterPoint[:2]), np.array(region.StartPoint[:2])
    radius = math.dist(center, start)
    builder.rapid(feeds.vertical_rapid, z=heights.clearance)
    if radius <= NO_HELIX:
        builder.rapid(feeds.horizontal_rapid, *start)
        builder.line((*start, bottom), feeds.vertical, Role.ENTRY)
        return
    down = (top - bottom) / pitch * 2 * math.pi
    begin = math.atan2(*(start - center)[::-1]) - math.pi / 16 - down
    turned = np.append(np.arange(0.0, down + 2 * math.pi, CHORD), down + 2 * math.pi)
    angles = begin + turned
    xy = center + (radius - NO_HELIX) * np.column_stack([np.cos(angles), np.sin(angles)])
    z = np.maximum(top - turned / down * (top - bottom), bottom)
    builder.rapid(feeds.horizontal_rapid, *xy[0])
    builder.rapid(feeds.vertical_rapid, z=heights.safe)
    for (x, y), height, turn in zip(xy, z, turned, strict=True):
        feed = feeds.vertical if turn <= down else feeds.horizontal
        builder.line((x, y, height), feed, Role.ENTRY)


def _move(
    builder: ToolpathBuilder, motion: int, points: Floats, bottom: float, request: PocketRequest
) -> None:
    """Add one of the library's paths: 0 cuts, 1 links at depth, others above the part."""
    feeds = request.feeds
    z = bottom if motion in (0, 1) else request.heights.clearance
    if motion == 0:
        builder.line((*builder.here[:2], z), feeds.vertical, Role.CUT)
        for x, y in points:
            builder.line((x, y, z), feeds.horizontal, Role.CUT)
        return
    builder.rapid(feeds.vertical_rapid, z=z)
    for x, y in points:
        builder.rapid(feeds.horizontal_rapid, x, y)
