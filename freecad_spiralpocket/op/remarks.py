# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a machinist should know of a pocket before it is cut, told by what is asked for alone."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import shapely
from shapely import Polygon

from ..engine.errors import Place, told_area
from ..engine.machine import machine_of
from ..engine.model import Heights, Notice, PocketRequest
from .compat import flat_end, parent_job, spindle_start, tool_name, tool_shape
from .level import SAME_HEIGHT
from .rest import operations_before
from .selection import PICK_ALL
from .tools import BULL_NOSES, ROUND_TOOLS

#: Of so many pockets more that have much the same the notices are not told one by one.
MANY = 3
#: Of so many of those the places are told.
MOST_PLACES = 20
#: A figure in a notice.
_FIGURE = re.compile(r"\d+(?:\.\d+)?")
#: A smaller share of a pocket that was cleared before is none.
LEAST_SHARE = 0.001
#: Of a larger share no percentage is told: it would read as if nothing were left.
MOST_SHARE = 0.99
#: A smaller part of the floor under leaning walls is not told [mm2], nor a thinner one [mm].
TOLD_OVERHANG, FILM = 0.5, 0.05
#: A smaller ledge is not told [mm2].
TOLD_LEDGE = 1.0
#: A smaller part of a pocket beside the stock is not told [mm2].
TOLD_BESIDE = 0.5


def labelled(told: Sequence[tuple[str, Notice]], pockets: int) -> list[Notice]:
    """Return notices, each once with the labels of the pockets that have it, if not all have it.

    Of many that differ in figures and places only the one with the largest figures, and the places
    of the others.

    Parameters
    ----------
    told : sequence of (str, Notice)
        The label of a pocket and what is to be told of it.
    pockets : int
        How many there are.
    """
    labels: dict[Notice, dict[str, None]] = {}
    alike: dict[tuple[str, ...], list[Notice]] = {}
    for label, notice in told:
        labels.setdefault(notice, {})[label] = None
    for notice in labels:
        alike.setdefault(_words(notice), []).append(notice)
    found: dict[Notice, None] = {}
    for notice, having_it in labels.items():
        same = alike[_words(notice)]
        largest = max(same, key=lambda one: [float(n) for n in _FIGURE.findall(one.message)])
        more = len({label for one in same for label in labels[one]}) - len(labels[largest])
        shown = labels[largest]
        if more < MANY:
            largest, shown = notice, having_it
        message = largest.message
        if len(shown) < pockets:
            message = f"{'; '.join(shown)}: {message}"
        if more >= MANY:
            places = [one.place for one in same if one is not largest and one.place is not None]
            message = f"{message} {_much_the_same(more, places)}"
        found[replace(largest, message=message)] = None
    return list(found)


def _much_the_same(pockets: int, places: Sequence[Place]) -> str:
    """Return what is told of so many more pockets, and where, once for each place [mm]."""
    told = list(dict.fromkeys(f"X{x:.1f} Y{y:.1f}" for x, y in places))
    if not told:
        return f"Much the same is told of {pockets} more pockets."
    if len(told) > MOST_PLACES:
        told = [*told[:MOST_PLACES], "..."]
    return f"Much the same is told of {pockets} more pockets (at {', '.join(told)})."


def _words(notice: Notice) -> tuple[str, ...]:
    """Return a notice without its figures."""
    return tuple(_FIGURE.sub("", text) for text in (notice.message, notice.hint))


def setup(wanted: PocketRequest, floor: float, obj: Any) -> list[Notice]:
    """Tell of cuts below the selected floor, into walls, and of stock that is not where it should.

    Parameters
    ----------
    wanted : PocketRequest
    floor : float
        Z of the selected face [mm].
    obj : object
        The operation.
    """
    stock = parent_job(obj).Stock.Shape.BoundBox
    found = [
        _below(floor - wanted.floor, stock.ZMin - wanted.floor),
        _into_walls(-wanted.cutting.stock_to_leave),
        _beside(wanted, shapely.box(stock.XMin, stock.YMin, stock.XMax, stock.YMax)),
        *_above(wanted.heights, stock.ZMax, obj),
    ]
    return [notice for notice in found if notice is not None]


def _below(floor: float, stock: float) -> Notice | None:
    """Tell how far the cutter goes below the selected floor and below the stock [mm]."""
    is_below, is_through = floor > SAME_HEIGHT, stock > SAME_HEIGHT
    if is_through and is_below:
        return Notice(
            f"The cutter goes {floor:.3g} mm below the selected floor, {stock:.3g} mm of "
            "that below the stock.",
            "Look what lies under the stock, or raise FinalDepth.",
        )
    if is_through:
        return Notice(
            f"The selected floor lies {stock:.3g} mm below the stock.",
            "Look whether the stock is where it should be.",
        )
    if is_below:
        return Notice(
            f"The cutter goes {floor:.3g} mm below the selected floor.",
            "Raise FinalDepth or ZStockToLeave if that is not meant.",
        )
    return None


def _into_walls(into: float) -> Notice | None:
    """Tell how far the cutter goes into the walls [mm]."""
    if into <= 0:
        return None
    return Notice(
        f"The cutter goes {into:.3g} mm into the walls.",
        "Raise StockToLeave if that is not meant.",
    )


def _beside(wanted: PocketRequest, stock: Polygon) -> Notice | None:
    """Tell how much of a pocket lies beside the stock, given as a box."""
    own = wanted.pocket if wanted.beyond is None else wanted.pocket.difference(wanted.beyond)
    beside = own.difference(stock)
    if beside.area < TOLD_BESIDE:
        return None
    hint = "Look whether the stock is where it should be."
    if beside.area > own.area - TOLD_BESIDE:
        return Notice("The pocket lies beside the stock.", hint)
    at = beside.representative_point()
    message = f"{told_area(beside.area)} mm2 of the pocket lie beside the stock, at {{at}}."
    return Notice(message, hint, (at.x, at.y))


def _above(heights: Heights, stock: float, obj: Any) -> list[Notice]:
    """Tell how far the stock's top, its Z, is above where the cutter begins or moves over.

    Not where an operation before this one has been there.
    """
    start, over = heights.start_depth, min(heights.safe, heights.clearance)
    if stock - min(start, over) <= SAME_HEIGHT:
        return []
    lowest = min((o.Path.BoundBox.ZMin for o in operations_before(obj)), default=stock)
    if lowest <= start + SAME_HEIGHT:
        return []
    found = []
    if stock - start > SAME_HEIGHT:
        found.append(
            Notice(
                f"The stock reaches {stock - start:.3g} mm above the start depth; the cutter goes "
                "down through that without ramping.",
                "Raise StartDepth to the top of the stock, or clear it with an operation before.",
            )
        )
    if stock - over > SAME_HEIGHT:
        found.append(
            Notice(
                f"The stock reaches {stock - over:.3g} mm above the height at which rapids go over "
                "it.",
                "Raise SafeHeight and ClearanceHeight above the stock.",
            )
        )
    return found


def tool(controller: Any, depth: float, reach: float, stepover: float) -> list[Notice]:
    """Tell what a tool's shape leaves, of a tool that is too short, and of the spindle.

    Parameters
    ----------
    controller : object
    depth, reach, stepover : float
        Of the deepest level, from the stock's top to the floor, and of the widest step [mm].
    """
    mill = controller.Proxy.getTool(controller)
    found = _shape(mill, stepover)
    length = float(getattr(mill, "CuttingEdgeHeight", None) or 0.0)
    if 0 < length < depth - SAME_HEIGHT:
        found.append(
            Notice(
                f"Levels are {depth:.3g} mm deep, the tool's cutting edge is {length:.3g} mm long.",
                "Lower StepDown, or take a longer tool.",
            )
        )
    whole = float(getattr(mill, "Length", None) or 0.0)
    if 0 < whole < reach - SAME_HEIGHT:
        found.append(
            Notice(
                f"The cutter goes {reach:.3g} mm below the top of the stock, the tool is "
                f"{whole:.3g} mm long.",
                "Take a longer tool; its holder would strike the part.",
            )
        )
    if controller.SpindleSpeed <= 0:
        found.append(
            Notice(
                f"The spindle speed of {controller.Label} is 0; the program does not start it.",
                "Set it in the tool controller, unless you start the spindle by hand.",
            )
        )
    elif spindle_start(controller) == "":
        found.append(
            Notice(
                f"{controller.Label} does not start the spindle.",
                "Set the spindle's direction there, or in the tool, unless you start it by hand.",
            )
        )
    if spindle_start(controller) == "M4":
        found.append(
            Notice(
                "The spindle runs in reverse; what CutMode calls climb is conventional then.",
                "Set the spindle's direction in the tool controller or the tool, or the other "
                "CutMode.",
            )
        )
    return found


def feed(wanted: PocketRequest) -> list[Notice]:
    """Tell of a feed that is more than the chosen machine does; the program keeps to the machine.

    Parameters
    ----------
    wanted : PocketRequest
    """
    asked, most = wanted.feeds.horizontal, machine_of(wanted).flat_speed
    if asked <= most:
        return []
    return [
        Notice(
            f"The horizontal feed of {60 * asked:.0f} mm/min is more than the chosen machine does; "
            f"the program runs at {60 * most:.0f} mm/min.",
            "Choose your machine in Machine, or lower the feed in the tool controller.",
        )
    ]


def _shape(mill: Any, stepover: float) -> list[Notice]:
    """Tell what a tool that is not flat leaves, with so wide steps [mm]."""
    shape = tool_shape(mill)
    if shape not in ROUND_TOOLS + BULL_NOSES:
        return []
    flat = flat_end(mill) if shape in BULL_NOSES else 0.0
    if stepover <= flat:
        corner = (float(mill.Diameter) - flat) / 2
        return [
            Notice(
                f"{tool_name(mill)} leaves the radius of its corner, {corner:.3g} mm, at the foot "
                "of walls.",
                "Finish with a flat end mill where that must be sharp.",
            )
        ]
    return [
        Notice(
            f"{tool_name(mill)} is not flat at its end and leaves ridges on the floor.",
            "Use a flat end mill, or finish the floor with one.",
        )
    ]


def open_sides(wanted: PocketRequest) -> Notice:
    """Tell what becomes of a pocket's open sides."""
    if wanted.beyond is None or wanted.beyond.is_empty:  # something may stand there
        return Notice(
            "The pocket is open at a side; the cutter stays within the floor there.",
            "Set ExtendOpenSides, or clear that side with another operation.",
        )
    return Notice(
        "The pocket is open at a side; the cutter runs out of it there.",
        "Keep clamps away from that side, or unset ExtendOpenSides.",
    )


def foreign(part: str) -> Notice:
    """Tell that a part is not in the job."""
    return Notice(
        f"{part} is not in the job's model.",
        "Select a face of the job's model, or add that part to it.",
    )


def ends_higher(window: float, part: float, cut: float) -> Notice:
    """Tell that a window ends above the part's lowest place, and how deep is cut, all Z [mm]."""
    return Notice(
        f"The hole ends at Z{window:.4g}, the part goes down to Z{part:.4g}; the cutter goes down "
        f"to Z{cut:.4g}.",
        "Look what lies under the hole. If it goes on there, select a wall of that.",
    )


def goes_on() -> Notice:
    """Tell that only a part of a floor is selected."""
    return Notice("The floor goes on beyond what is selected; that stays.", PICK_ALL)


def islands(area: float) -> Notice:
    """Tell how much floor the islands take that are left out [mm2]."""
    return Notice(
        f"Islands on {told_area(area)} mm2 of the floor are milled away.",
        "Unset UseOutline if they shall stand.",
    )


def ledges(wanted: PocketRequest, others: Sequence[Polygon]) -> list[Notice]:
    """Tell how much is cleared above ledges beside the floor, if that is more than the floor.

    Parameters
    ----------
    wanted : PocketRequest
    others : sequence of shapely.Polygon
        The floors of other pockets that are selected; what is above those is meant.
    """
    more, lowest, meant = 0.0, None, shapely.union_all(others)
    for above, level in pairwise(wanted.sections):
        wider = shapely.difference(above.pocket, level.mouth or level.pocket)
        wider = shapely.difference(wider, meant).area
        more += wider
        if wider > TOLD_LEDGE:
            lowest = above.z
    if lowest is None or more < wanted.pocket.area:
        return []
    return [
        Notice(
            f"Above Z{lowest:.4g} also {told_area(more)} mm2 beside the selected floor are "
            "cleared, down to ledges.",
            "Where that is done already, lower StartDepth or set UseRestMachining.",
        )
    ]


def overhung(outline: Polygon, pocket: Polygon) -> float:
    """Return how much of a floor within its outline is kept off for what hangs over it [mm2]."""
    kept_off = shapely.difference(outline, pocket)
    return float(shapely.buffer(shapely.buffer(kept_off, -FILM / 2), FILM / 2).area)


def overhang(area: float) -> Notice:
    """Tell how much of a floor lies under leaning walls [mm2]."""
    return Notice(
        f"Walls lean over the floor; {area:.0f} mm2 of it below them stay uncut.",
        "Machine that part from another side, or with an undercutting tool.",
    )


def others(area: float) -> Notice:
    """Tell of another part of the job in the pocket, and how much floor it covers [mm2]."""
    hint = "Take that part out of the job's model if it is not there when the pocket is cut."
    if area > TOLD_OVERHANG:
        return Notice(
            f"Another part of the job covers {area:.0f} mm2 of the floor; that stays uncut.", hint
        )
    return Notice(
        "Another part of the job stands in the pocket or over it; the cutter keeps off that.", hint
    )


def rest(share: float) -> Notice:
    """Tell which share of a pocket was cleared before, in [0, 1]."""
    if share < LEAST_SHARE:
        return Notice(
            "No earlier operation has cleared any of this pocket down to its floor; all is cut.",
            "Move this operation behind the one with the larger end mill, or unset "
            "UseRestMachining. Only flat end mills count: round ones leave ridges.",
        )
    if share > MOST_SHARE:
        return Notice(
            "Earlier operations have cleared more than 99 % of this pocket; what this cutter "
            "reaches of the rest is cut."
        )
    return Notice(
        f"Earlier operations have cleared {int(100 * share)} % of this pocket; what this cutter "
        "reaches of the rest is cut."
    )
