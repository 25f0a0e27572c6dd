# SPDX-License-Identifier: LGPL-2.1-or-later
"""A request, and the path planned for it, in another size.

A cutter of a tenth of the size cuts a pocket of a tenth of the size in the same time by the
same path, if all that has a length in it, speeds and accelerations too, is a tenth. So a strategy
may plan in the size that its own lengths are made for.
"""

from __future__ import annotations

from dataclasses import replace

from shapely import Polygon
from shapely.affinity import scale

from .floor import FloorPath, Groove, Helix, Pass, Slot
from .machine import MIDDLING, Axes, Machine
from .model import PocketRequest, Section


def resized(shape: Polygon, factor: float) -> Polygon:
    """Return a polygon with all coordinates times `factor`."""
    return scale(shape, factor, factor, origin=(0.0, 0.0))


def resized_request(request: PocketRequest, factor: float) -> PocketRequest:
    """Return a request with all lengths, speeds and accelerations times `factor`."""
    heights, feeds, cutting = request.heights, request.feeds, request.cutting
    start = request.start_point
    return replace(
        request,
        pocket=resized(request.pocket, factor),
        tool_diameter=factor * request.tool_diameter,
        heights=replace(
            heights,
            clearance=factor * heights.clearance,
            safe=factor * heights.safe,
            start_depth=factor * heights.start_depth,
            final_depth=factor * heights.final_depth,
            step_down=factor * heights.step_down,
            finish_depth=factor * heights.finish_depth,
        ),
        feeds=replace(
            feeds,
            horizontal=factor * feeds.horizontal,
            vertical=factor * feeds.vertical,
            horizontal_rapid=factor * feeds.horizontal_rapid,
            vertical_rapid=factor * feeds.vertical_rapid,
        ),
        cutting=replace(
            cutting,
            stepover=factor * cutting.stepover,
            stock_to_leave=factor * cutting.stock_to_leave,
            floor_stock=factor * cutting.floor_stock,
        ),
        entry=replace(
            request.entry,
            max_diameter=factor * request.entry.max_diameter,
            slot_bite=factor * request.entry.slot_bite,
        ),
        tolerance=factor * request.tolerance,
        feed_plan=replace(request.feed_plan, link_feed=factor * request.feed_plan.link_feed),
        machine=resized_machine(request.machine or MIDDLING, factor),
        start_point=None if start is None else (factor * start[0], factor * start[1]),
        sections=tuple(_resized_section(section, factor) for section in request.sections),
    )


def resized_machine(machine: Machine, factor: float) -> Machine:
    """Return a machine with all lengths, speeds, accelerations and jerks times `factor`."""
    normal = machine.normal_acceleration
    return replace(
        machine,
        speed=_times(machine.speed, factor),
        acceleration=_times(machine.acceleration, factor),
        corner_value=factor * machine.corner_value,
        jerk=_times(machine.jerk, factor),
        path_speed=factor * machine.path_speed,
        path_acceleration=factor * machine.path_acceleration,
        normal_acceleration=None if normal is None else factor * normal,
    )


def resized_path(path: FloorPath, factor: float) -> FloorPath:
    """Return a path with all lengths times `factor`."""
    curve = path.curve
    return FloorPath(
        _resized_entry(path.entry, factor),
        tuple(
            replace(part, points=factor * part.points)
            if isinstance(part, Pass)
            else _resized_entry(part, factor)
            for part in path.passes
        ),
        None if curve is None else replace(curve, control_points=factor * curve.control_points),
    )


def _resized_entry(entry: Helix | Slot | Groove, factor: float) -> Helix | Slot | Groove:
    if isinstance(entry, Helix):
        return replace(entry, center=factor * entry.center, radius=factor * entry.radius)
    if isinstance(entry, Slot):
        return replace(entry, ring=factor * entry.ring, bite=factor * entry.bite)
    return replace(
        entry,
        ring=factor * entry.ring,
        tips=tuple(factor * at for at in entry.tips),
        feet=tuple(factor * at for at in entry.feet),
        trunk=factor * entry.trunk,
        bite=factor * entry.bite,
    )


def _resized_section(section: Section, factor: float) -> Section:
    mouth = section.mouth
    return Section(
        factor * section.z,
        resized(section.pocket, factor),
        None if mouth is None else resized(mouth, factor),
    )


def _times(axes: Axes, factor: float) -> Axes:
    x, y, z = axes
    return (factor * x, factor * y, factor * z)
