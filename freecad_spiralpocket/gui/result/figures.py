# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of planned pockets together, and remarks with their places."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import FreeCAD
import numpy as np
import Path

from ...engine.errors import CancelledError, SpiralPocketError
from ...engine.model import Notice, Plan, Report
from ...op import commands, request, results
from ..texts.choices import choice_text
from ..texts.localized import in_panel
from ..texts.measures import alarming, area, duration, length, small

if TYPE_CHECKING:
    from ..planning.outlook import Outlook

translate = FreeCAD.Qt.translate

Place = tuple[float, float, float]


@dataclass(frozen=True)
class Remark:
    """Something the machinist should know, and where it is, (x, y, z) [mm]."""

    text: str
    place: Place | None = None


def figures_of(obj: Any, plans: Sequence[Plan]) -> list[tuple[str, str]]:
    """Return name and value of each figure, as they stand in the result box."""
    reports = [p.report for p in plans]
    lengths = np.array([r.cut_length for r in reports])
    mean = np.average([r.engagement_mean for r in reports], weights=np.maximum(lengths, 1e-9))
    timed = request.has_feeds(obj.ToolController)
    machine = choice_text("Machine", obj.Machine)
    return [
        (
            translate("SpiralPocket", "Time on {}").format(machine),
            duration(results.machining_time(plans) if timed else 0.0),
        ),
        (
            translate("SpiralPocket", "FreeCAD's estimate"),
            duration(naive_time(obj.ToolController, plans) if timed else 0.0),
        ),
        (translate("SpiralPocket", "Cutting length"), length(float(lengths.sum()))),
        (
            translate("SpiralPocket", "Largest engagement"),
            _largest_engagement(reports),
        ),
        (translate("SpiralPocket", "Mean engagement"), f"{np.degrees(mean):.0f}°"),
        (
            translate("SpiralPocket", "Entry at full width, deep"),
            small(max(r.entry_bite for r in reports)),
        ),
        (
            translate("SpiralPocket", "Left uncut in reach"),
            area(sum(r.uncut_area for r in reports)),
        ),
        (
            translate("SpiralPocket", "Gouge"),
            translate("SpiralPocket", "{} (allowed: {})").format(
                small(max(r.gouge for r in reports)), small(obj.Tolerance.Value)
            ),
        ),
    ]


def summary_of(obj: Any, plans: Sequence[Plan], remarks: Sequence[Remark], missing: int = 0) -> str:
    """Return time, largest engagement and number of remarks in one line, or what is the matter.

    `missing` pockets cannot be cut, which is told too. Empty while nothing is known. HTML where
    something stays uncut.
    """
    if not plans:
        return in_panel(remarks[0].text) if remarks else ""
    timed = request.has_feeds(obj.ToolController)
    reports = [p.report for p in plans]
    parts = [
        duration(results.machining_time(plans) if timed else 0.0),
        _largest_engagement(reports),
    ]
    uncut = uncut_of(plans)
    if uncut:
        parts.append(alarming(translate("SpiralPocket", "{} uncut").format(area(uncut))))
    if missing:
        parts.append(translate("SpiralPocket", "pockets not cut: {}").format(missing))
    if remarks:
        parts.append(translate("SpiralPocket", "remarks: {}").format(len(remarks)))
    return "; ".join(parts)


def _largest_engagement(reports: Sequence[Report]) -> str:
    """Return it and the limit; where all is the way down, that it is the whole width."""
    largest = max(r.engagement_max for r in reports)
    if largest == 0:
        deep = small(max(r.entry_bite for r in reports))
        return translate("SpiralPocket", "whole width, {} deep").format(deep)
    return translate("SpiralPocket", "{:.0f}°, limit {:.0f}°").format(
        np.degrees(largest), np.degrees(max(r.engagement_limit for r in reports))
    )


def uncut_of(plans: Sequence[Plan]) -> float:
    """Return how much ground plans leave in the cutter's reach [mm2], 0 if too little to tell."""
    from ...engine.proof.findings import uncut_allowed  # needs shapely

    left = [(p.report.uncut_area, uncut_allowed(p.request)) for p in plans]
    return sum(uncut for uncut, allowed in left if uncut > allowed)


def left_out(plans: Sequence[Plan]) -> float:
    """Return how much ground stays uncut in pockets of which whole parts do [mm2], 0 if in none.

    A part is whole that is as large as the cutter: what laps leave between them is smaller.
    """
    left = [(p.report.uncut_area, p.request.cutter_radius) for p in plans]
    return sum(uncut for uncut, radius in left if uncut > np.pi * radius**2)


def naive_time(tool_controller: Any, plans: Sequence[Plan]) -> float:
    """Return FreeCAD's own estimate of the time [s]: one feed, no acceleration."""
    moves = commands.join(commands.from_toolpath(p.toolpath) for p in plans)
    names = ("HorizFeed", "VertFeed", "HorizRapid", "VertRapid")
    return float(Path.Path(moves).getCycleTime(*(getattr(tool_controller, n).Value for n in names)))


def is_applied(obj: Any, plans: Sequence[Plan]) -> bool:
    """Return whether the operation's path is the one of these plans."""
    made = obj.Proxy.plans
    if plans and not made:  # a document was opened
        return results.are_of(obj, plans)
    return bool(plans) and len(made) == len(plans) and all(map(_is_same, made, plans))


def made_plans(obj: Any, outlook: Outlook) -> Sequence[Plan]:
    """Return the plans of the operation's path, if nobody looks ahead and it is up to date."""
    return () if outlook.is_on or "Touched" in obj.State else obj.Proxy.plans


def remarks_of(obj: Any, outlook: Outlook, plans: Sequence[Plan]) -> list[Remark]:
    """Return what is to be told of the path, or first why there is none.

    What the operation has noted is told while it is up to date: what was changed since may need
    a remark though the path stays the same.
    """
    top = outlook.pockets[0].request.heights.start_depth if outlook.pockets else 0.0
    known: list[tuple[Notice | SpiralPocketError, float]] = []
    known += [(error, top) for error in outlook.errors]
    known += [(notice, top) for notice in outlook.notices]
    for pocket in outlook.pockets:
        found = pocket.drawn.plan.report.notices if pocket.drawn else ()
        if outlook.are_several:
            found = [Notice(f"{pocket.label}: {n.message}", n.hint, n.place) for n in found]
        known += [(notice, pocket.request.heights.start_depth) for notice in found]
    if not outlook.is_on:
        known = [(n, p.request.heights.start_depth) for p in plans for n in p.report.notices]
    if is_applied(obj, plans) and "Touched" not in obj.State:
        return [Remark(text, _place_in(text, known)) for text in obj.Notices]
    if not outlook.is_on and "Touched" not in obj.State:
        return [Remark(str(e)) for e in obj.Proxy.errors if not isinstance(e, CancelledError)]
    return list(dict.fromkeys(Remark(str(notice), _place(notice, z)) for notice, z in known))


def _is_same(one: Plan, other: Plan) -> bool:
    return one is other or one.request == other.request


def _place(notice: Notice | SpiralPocketError, z: float) -> Place | None:
    return None if notice.place is None else (*notice.place, z)


def _place_in(text: str, known: Sequence[tuple[Notice | SpiralPocketError, float]]) -> Place | None:
    """Return the place of the notice whose words are in a text."""
    return next((_place(n, z) for n, z in known if str(n) in text), None)
