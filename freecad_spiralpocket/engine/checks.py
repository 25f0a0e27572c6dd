# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of a request at the engine's door; nothing behind it checks again.

What a machinist can get wrong becomes an error in the machinist's words.
"""

from __future__ import annotations

import math
from dataclasses import fields

import numpy as np
from shapely import Geometry, Polygon, get_coordinates, is_valid_reason

from .errors import GeometryError, RequestError
from .model import Cutting, Entry, FeedPlan, Feeds, PocketRequest
from .opening.entry import NARROWEST, WIDEST

#: Levels may pass the one above, and the step down, by this [mm].
NESTED = 0.01
#: Largest tolerance, over D.
COARSEST = 0.05
#: A pocket or a slot is cut in no more levels, and the widest helix takes no more turns.
MOST_LEVELS = 500


def check_request(request: PocketRequest) -> None:
    """Check every value of a request.

    Raises
    ------
    RequestError
        If a value makes no sense.
    GeometryError
        If the outline of the pocket, the stock, or what lies beyond open sides is broken.
    """
    _check_cutter(request.tool_diameter, request.cutting.stepover)
    _check_feeds(request.feeds)
    _check_tolerance(request.tolerance, request.tool_diameter)
    _check_entry(request.entry, request.axial_depth)
    _check_feed_plan(request.feed_plan)
    _check_start_point(request.start_point)
    _check_stock_to_leave(request.cutting)
    _check_heights(request)
    _check_turns(request)
    _check_outline(request.pocket)
    _check_ground("the stock", request.stock)
    _check_ground("the ground beyond the open sides", request.beyond)
    if request.sections:
        _check_sections(request)


def _check_cutter(diameter: float, stepover: float) -> None:
    _check_positive("The cutter's diameter", diameter, "Set it in the tool of the tool controller.")
    if not (math.isfinite(stepover) and stepover > 0):
        raise RequestError(
            f"A step-over of {stepover:g} mm never clears the pocket.",
            "Set StepOver above 0; 20 to 45 % of the cutter's diameter is usual.",
        )
    if stepover > diameter:
        raise RequestError(
            f"A step-over of {stepover:g} mm is wider than the {diameter:g} mm cutter.",
            "Set StepOver to 100 % or less.",
        )


def _check_feeds(feeds: Feeds) -> None:
    hint = "Set the feeds in the tool controller."
    _check_positive("The horizontal feed", feeds.horizontal, hint)
    _check_positive("The vertical feed", feeds.vertical, hint)
    _check_positive("The horizontal rapid rate", feeds.horizontal_rapid, hint)
    _check_positive("The vertical rapid rate", feeds.vertical_rapid, hint)


def _check_tolerance(tolerance: float, diameter: float) -> None:
    _check_positive("The tolerance", tolerance, "0.01 mm is usual.")
    if tolerance > COARSEST * diameter:
        raise RequestError(
            f"A tolerance of {tolerance:g} mm is too coarse for this cutter.",
            f"Set Tolerance to at most {COARSEST * diameter:g} mm.",
        )


def _check_entry(entry: Entry, axial_depth: float) -> None:
    if not 0 < entry.helix_angle < math.pi / 2:
        raise RequestError(
            f"A helix angle of {math.degrees(entry.helix_angle):g} degrees cannot be cut.",
            "Set HelixAngle above 0 and below 90 degrees; 5 is usual.",
        )
    if not 0 <= entry.slot_bite < math.inf:
        raise RequestError("The slot bite is negative.", "Set SlotBite to 0 to have it found.")
    if axial_depth > MOST_LEVELS * entry.slot_bite > 0:
        raise RequestError(
            f"With a slot bite of {entry.slot_bite:g} mm a slot has more than {MOST_LEVELS} "
            "levels.",
            "Raise SlotBite, or set it to 0 to have it found.",
        )
    if not entry.max_diameter >= 0:
        raise RequestError(
            "The helix's diameter limit is negative.", "Set HelixDiameterLimit to 0 for no limit."
        )


def _check_feed_plan(plan: FeedPlan) -> None:
    if not 0 < plan.slowed <= 1:
        raise RequestError(
            f"The slowed feed of {100 * plan.slowed:g} percent is not between 0 and 100 percent.",
            "Set SlowdownPercent between 1 and 100; 75 is usual.",
        )
    if not 1 <= plan.largest_ratio < math.inf:
        raise RequestError(
            f"The largest feed ratio of {plan.largest_ratio:g} is below 1.",
            "Set MaxFeedRatio to 1 or more; 2 is usual.",
        )
    if not 0 <= plan.link_feed < math.inf:
        raise RequestError(
            "The link feed is negative.", "Set LinkFeed to 0 for the horizontal rapid rate."
        )


def _check_start_point(place: tuple[float, float] | None) -> None:
    if place is not None and not np.isfinite(place).all():
        raise RequestError("The start point is not a place.", "Set StartPoint, or do without.")


def _check_stock_to_leave(cutting: Cutting) -> None:
    for name, value in (
        ("XY stock to leave", cutting.stock_to_leave),
        ("Z stock to leave", cutting.floor_stock),
    ):
        if not math.isfinite(value):
            raise RequestError(f"The {name} is not a number.", "Set it to 0 for none.")


def _check_positive(name: str, value: float, hint: str) -> None:
    if not (math.isfinite(value) and value > 0):
        raise RequestError(f"{name} is {value:g}; it must be more than 0.", hint)


def _check_heights(request: PocketRequest) -> None:
    h = request.heights
    for field in fields(h):
        value = getattr(h, field.name)
        if not math.isfinite(value):
            raise RequestError(
                f"A depth or height is {value:g}; it must be a number of millimeters.",
                "Set all depths and heights.",
            )
    floor = h.final_depth + request.cutting.floor_stock
    if h.final_depth >= h.start_depth:
        raise RequestError(
            f"The depths are upside down: the pocket's floor (final depth {h.final_depth:g} mm) is "
            f"not below its top (start depth {h.start_depth:g} mm).",
            "Set StartDepth above FinalDepth.",
        )
    if floor >= h.start_depth:
        raise RequestError(
            f"With {request.cutting.floor_stock:g} mm of stock to leave on the floor nothing is "
            "left to cut.",
            "Lower ZStockToLeave.",
        )
    if not h.step_down > 0:
        raise RequestError(
            f"A step down of {h.step_down:g} mm never reaches the floor.", "Set StepDown above 0."
        )
    if h.start_depth - floor > MOST_LEVELS * h.step_down:
        raise RequestError(
            f"A step down of {h.step_down:g} mm makes more than {MOST_LEVELS} levels.",
            "Raise StepDown.",
        )
    if not 0 <= h.finish_depth <= h.step_down:
        raise RequestError(
            f"The finish depth of {h.finish_depth:g} mm is not between 0 and the step down of "
            f"{h.step_down:g} mm.",
            "Lower FinishDepth or raise StepDown.",
        )
    if not h.clearance >= h.safe >= h.start_depth:
        raise RequestError(
            f"The heights are upside down: clearance {h.clearance:g} mm, safe {h.safe:g} mm, "
            f"start depth {h.start_depth:g} mm.",
            "Set ClearanceHeight above SafeHeight above StartDepth.",
        )


def _check_turns(request: PocketRequest) -> None:
    """Check that the widest helix that there could be is no endless one."""
    entry, radius = request.entry, request.cutter_radius
    widest = min(WIDEST * radius, entry.max_diameter / 2 or math.inf)
    around = 2 * math.pi * max(widest, NARROWEST * radius)
    depth = request.heights.start_depth - request.floor
    if depth > MOST_LEVELS * around * math.tan(entry.helix_angle):
        least = math.degrees(math.atan(depth / (MOST_LEVELS * around)))
        raise RequestError(
            f"At a helix angle of {math.degrees(entry.helix_angle):g} degrees the cutter goes "
            f"round more than {MOST_LEVELS} times on its way down.",
            f"Set HelixAngle above {least:.2g} degrees; 5 is usual.",
        )


def _check_sections(request: PocketRequest) -> None:
    """Check that the levels go down to the floor and that none reaches under a wall."""
    top, above = request.heights.start_depth, None
    for section in request.sections:
        _check_outline(section.pocket)
        _check_ground("the pocket's mouth", section.mouth)
        _check_ground("the stock", section.stock)
        if not 0 < top - section.z < request.heights.step_down + NESTED:
            raise RequestError(
                f"The level from Z{top:g} to Z{section.z:g} is not between 0 and the step down of "
                f"{request.heights.step_down:g} mm deep.",
                "Set StepDown above 0.",
            )
        if above is not None and not above.buffer(NESTED).covers(section.pocket):
            raise GeometryError(
                f"At Z{section.z:g} the pocket reaches under a wall.",
                "Check the part's geometry in the Part workbench.",
            )
        top, above = section.z, section.pocket
    if abs(top - request.floor) > NESTED or above != request.pocket:
        raise GeometryError(f"The lowest level, at Z{top:g}, is not the pocket's floor.")


def _check_outline(pocket: Polygon) -> None:
    if pocket.is_empty or pocket.area == 0:
        raise GeometryError("The pocket has no area.", "Select the floor face of the pocket.")
    if not np.isfinite(get_coordinates(pocket)).all():
        raise GeometryError("The pocket's outline has points at infinity.")
    if not pocket.is_valid:
        place = pocket.exterior.coords[0]
        raise GeometryError(
            f"The pocket's outline is broken ({is_valid_reason(pocket)}).",
            "Check the part's geometry in the Part workbench and repair the face.",
            (place[0], place[1]),
        )


def _check_ground(name: str, ground: Geometry | None) -> None:
    """Check what may also be nothing at all."""
    if ground is None or ground.is_empty:
        return
    points = get_coordinates(ground)
    hint = "Check the geometry of the part and the job's stock."
    if not np.isfinite(points).all():
        raise GeometryError(f"The outline of {name} has points at infinity.", hint)
    if not ground.is_valid:
        place = (points[0, 0], points[0, 1])
        raise GeometryError(
            f"The outline of {name} is broken ({is_valid_reason(ground)}).", hint, place
        )
