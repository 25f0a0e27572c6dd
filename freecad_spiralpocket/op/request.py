# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the operation's properties to the engine's request, one for each pocket.

FreeCAD has one `FinalDepth` for an operation, pockets may have floors at several
heights. It holds for the deepest floors; a floor that is higher is cut to its
own height and never below, so that `FinalDepth` can also stop all pockets early.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import machines
from ..engine.errors import RequestError
from ..engine.machine import Machine
from ..engine.model import (
    CutMode,
    Cutting,
    Entry,
    FeedMode,
    FeedPlan,
    Feeds,
    Heights,
    PocketRequest,
    Strategy,
)
from ..engine.stepover import radial_depth
from . import preferences
from .level import SAME_HEIGHT

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon

#: Feed for planning where the tool controller has none [mm/s]; it never reaches the path.
STAND_IN_FEED = 10.0

#: The engagement angle of a full slot [deg].
FULL_SLOT = 180.0


def missing_feeds(tool_controller: Any) -> str:
    """Return what the tool controller does not say of how fast to cut, "" if it says all."""
    is_flat, is_down = (getattr(tool_controller, f).Value > 0 for f in ("HorizFeed", "VertFeed"))
    if is_flat:
        return "" if is_down else "vertical feed"
    return "horizontal feed" if is_down else "feeds"


def has_feeds(tool_controller: Any) -> bool:
    """Return whether the tool controller says how fast to cut."""
    return not missing_feeds(tool_controller)


def feeds(tool_controller: Any, on: Machine) -> Feeds:
    """Return the tool controller's feeds [mm/s].

    A rapid rate of 0, FreeCAD's default, is taken as the machine's; links at depth run at it.
    """
    if not has_feeds(tool_controller):
        return Feeds(STAND_IN_FEED, STAND_IN_FEED, STAND_IN_FEED, STAND_IN_FEED)
    horizontal, vertical = tool_controller.HorizFeed.Value, tool_controller.VertFeed.Value
    return Feeds(
        horizontal=horizontal,
        vertical=vertical,
        horizontal_rapid=tool_controller.HorizRapid.Value or max(horizontal, on.flat_speed),
        vertical_rapid=tool_controller.VertRapid.Value or max(vertical, on.speed[2]),
    )


def final_depth(obj: Any, z: float, deepest: float) -> float:
    """Return how deep the pocket with its floor at `z` is cut, the deepest floor being given."""
    asked = obj.FinalDepth.Value
    return asked if z <= deepest + SAME_HEIGHT else max(asked, z)


def machine(name: str) -> Machine:
    """Return the machine preset `name`, as its file is now."""
    return machines.load(name, preferences.machine_folder())


def stepover(obj: Any) -> float:
    """Return the step-over [mm]: that of `MaxEngagement` if it is given, else of `StepOver`.

    Raises
    ------
    RequestError
        If `MaxEngagement` is no angle of a cut.
    """
    angle, diameter = obj.MaxEngagement.Value, obj.OpToolDiameter.Value
    if angle == 0:
        return obj.StepOver / 100 * diameter
    if not 0 < angle <= FULL_SLOT:
        raise RequestError(
            f"A largest engagement of {angle:g} degrees cannot be cut.",
            f"Set MaxEngagement up to {FULL_SLOT:g} degrees, or to 0 for StepOver's.",
        )
    return radial_depth(math.radians(angle), diameter / 2)


def start_point(obj: Any, pocket: Polygon) -> tuple[float, float] | None:
    """Return the start point that was asked for, if it lies in this pocket."""
    from shapely import Point  # documents open without it

    if not obj.UseStartPoint:
        return None
    x, y = obj.StartPoint.x, obj.StartPoint.y
    return (x, y) if pocket.intersects(Point(x, y)) else None


def build(
    obj: Any,
    pocket: Polygon,
    depth: float,
    stock: Polygon | None = None,
    beyond: Polygon | MultiPolygon | None = None,
) -> PocketRequest:
    """Return the request for one pocket that is cut to `depth` with the operation `obj`.

    `stock` and `beyond` are for pockets with open sides, see `PocketRequest`.
    """
    return PocketRequest(
        pocket=pocket,
        tool_diameter=obj.OpToolDiameter.Value,
        heights=Heights(
            clearance=obj.ClearanceHeight.Value,
            safe=obj.SafeHeight.Value,
            start_depth=obj.StartDepth.Value,
            final_depth=depth,
            step_down=obj.StepDown.Value,
            finish_depth=obj.FinishDepth.Value,
        ),
        feeds=feeds(obj.ToolController, machine(obj.Machine)),
        cutting=Cutting(
            stepover=stepover(obj),
            cut_mode=CutMode(obj.CutMode),
            stock_to_leave=obj.StockToLeave.Value,
            floor_stock=obj.ZStockToLeave.Value,
            finishing_lap=obj.FinishingProfile,
        ),
        entry=Entry(
            helix_angle=float(np.radians(obj.HelixAngle.Value)),
            max_diameter=obj.HelixDiameterLimit.Value,
            slot_bite=obj.SlotBite.Value,
        ),
        strategy=Strategy(obj.Strategy),
        tolerance=obj.Tolerance.Value,
        feed_plan=FeedPlan(
            mode=FeedMode(obj.FeedMode),
            slowed=obj.SlowdownPercent / 100,
            largest_ratio=obj.MaxFeedRatio,
            link_feed=obj.LinkFeed / 60,
        ),
        machine=machine(obj.Machine),
        start_point=start_point(obj, pocket),
        stock=stock,
        beyond=beyond,
    )
