# SPDX-License-Identifier: LGPL-2.1-or-later
"""A request, and the path planned for it, in another size.

A cutter of a tenth of the size cuts a pocket of a tenth of the size in the same time by the
same path, if all that has a length in it, speeds and accelerations too, is a tenth. So strategies
plan in the size that their own lengths are made for.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import fields, replace
from typing import Any, TypeVar

from shapely import Geometry, GEOSException, Polygon
from shapely.affinity import scale

from .errors import SpiralPocketError
from .floor import FloorPath, Helix, Pass, Plunge, Slot, WayDown
from .machine import Axes, Machine, machine_of
from .model import Feeds, Heights, PocketRequest, Section, Tick

#: The lengths in mm of all strategies are meant for this R and this tolerance [mm].
SIZE, EXACT = 3.0, 0.01
#: No finer tolerance makes it larger than this: what takes minutes then is not kept all the same.
LARGEST = 20.0
#: Sizes that are tried, over that. GEOS gives up once in thousands of times where edges nearly
#: coincide; in another size they are rounded in another way.
TRIED = (1.0, 0.999, 0.99)

Shape = TypeVar("Shape", bound=Geometry)
#: A dataclass.
Record = TypeVar("Record")


def planned_resized(
    strategy: Callable[[Polygon, PocketRequest, Tick], FloorPath],
    region: Polygon,
    request: PocketRequest,
    tick: Tick,
) -> FloorPath:
    """Return a region's path by a strategy, in the size that its lengths are meant for.

    A smaller cutter's pocket is planned larger, and so is one with a finer tolerance. A larger
    one's is planned smaller as far as the tolerance is coarser too.

    Raises
    ------
    SpiralPocketError
        What the strategy raises, with lengths and places in the size of the pocket.
    """
    factor = max(SIZE / request.cutter_radius, min(LARGEST, EXACT / request.tolerance))
    *others, last = TRIED
    for share in others:
        try:
            return _planned_in(share * factor, strategy, region, request, tick)
        except GEOSException:
            continue
    return _planned_in(last * factor, strategy, region, request, tick)


def _planned_in(
    factor: float,
    strategy: Callable[[Polygon, PocketRequest, Tick], FloorPath],
    region: Polygon,
    request: PocketRequest,
    tick: Tick,
) -> FloorPath:
    """Return a region's path, planned `factor` times as large."""
    if factor == 1.0:
        return strategy(region, request, tick)
    try:
        path = strategy(resized(region, factor), resized_request(request, factor), tick)
    except SpiralPocketError as error:
        raise error.resized(1.0 / factor) from None
    return resized_path(path, 1.0 / factor)


def resized(shape: Shape, factor: float) -> Shape:
    """Return a shape with all coordinates times `factor`."""
    return scale(shape, factor, factor, origin=(0.0, 0.0))


def resized_request(request: PocketRequest, factor: float) -> PocketRequest:
    """Return a request with all lengths, speeds and accelerations times `factor`."""
    start = request.start_point
    return replace(
        request,
        pocket=resized(request.pocket, factor),
        tool_diameter=factor * request.tool_diameter,
        heights=_times(request.heights, factor, [f.name for f in fields(Heights)]),
        feeds=_times(request.feeds, factor, [f.name for f in fields(Feeds)]),
        cutting=_times(request.cutting, factor, ["stepover", "stock_to_leave", "floor_stock"]),
        entry=_times(request.entry, factor, ["max_diameter", "slot_bite"]),
        tolerance=factor * request.tolerance,
        feed_plan=_times(request.feed_plan, factor, ["link_feed"]),
        machine=resized_machine(machine_of(request), factor),
        start_point=None if start is None else (factor * start[0], factor * start[1]),
        stock=None if request.stock is None else resized(request.stock, factor),
        beyond=None if request.beyond is None else resized(request.beyond, factor),
        sections=tuple(_resized_section(section, factor) for section in request.sections),
    )


def resized_machine(machine: Machine, factor: float) -> Machine:
    """Return a machine with all lengths, speeds, accelerations and jerks times `factor`."""
    names = ["corner_value", "path_speed", "path_acceleration"]
    if machine.normal_acceleration is not None:
        names.append("normal_acceleration")
    moved = replace(
        machine,
        speed=_axes(machine.speed, factor),
        acceleration=_axes(machine.acceleration, factor),
        jerk=_axes(machine.jerk, factor),
    )
    return _times(moved, factor, names)


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


def _resized_entry(entry: WayDown, factor: float) -> WayDown:
    if isinstance(entry, Helix):
        return _times(entry, factor, ["center", "radius"])
    if isinstance(entry, Slot):
        slot = _times(entry, factor, ["ring", "bite"])
        stairs, wall = slot.stairs, slot.wall
        stairs = stairs and _times(stairs, factor, ["lines", "inner"])
        return replace(slot, stairs=stairs, wall=None if wall is None else factor * wall)
    if isinstance(entry, Plunge):
        return Plunge(factor * entry.place)
    lengths = _times(entry, factor, ["ring", "trunk", "bite"])
    return replace(lengths, tips=_each(entry.tips, factor), feet=_each(entry.feet, factor))


def _resized_section(section: Section, factor: float) -> Section:
    mouth, stock = section.mouth, section.stock
    return Section(
        factor * section.z,
        resized(section.pocket, factor),
        None if mouth is None else resized(mouth, factor),
        None if stock is None else resized(stock, factor),
    )


def _times(record: Record, factor: float, names: Sequence[str]) -> Record:
    """Return a record with the values of these names times `factor`."""
    values: dict[str, Any] = {name: factor * getattr(record, name) for name in names}
    return replace(record, **values)  # type: ignore[type-var]


def _each(values: Sequence[float], factor: float) -> tuple[float, ...]:
    return tuple(factor * value for value in values)


def _axes(axes: Axes, factor: float) -> Axes:
    x, y, z = axes
    return (factor * x, factor * y, factor * z)
