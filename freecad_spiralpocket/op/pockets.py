# SPDX-License-Identifier: LGPL-2.1-or-later
"""All pockets of one operation: each is planned on its own and fails on its own.

A plan is taken over from the last recompute where its request is the same, so
that adding a tenth face to nine plans one pocket, and changing the coolant none.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..engine import plan as plan_pocket
from ..engine.errors import CancelledError, SpiralPocketError
from ..engine.model import Notice, Plan, PocketRequest, Progress
from . import commands, geometry, request, selection

#: Share of the operation's tolerance that goes into the chords of curved walls; the rest is
#: for the path.
SAG_SHARE = 0.2
#: Limits of the sag [mm]: a tolerance of 0 is refused later, a wide one must not lose arcs.
SAG_RANGE = (1e-4, 0.02)


class Pockets:
    """The pockets of an operation.

    Parameters
    ----------
    obj : object
        The operation.
    earlier : sequence of Plan
        What may be taken over.

    Attributes
    ----------
    plans : list of Plan
    errors : list of SpiralPocketError
        One for each thing that is the matter, naming the pockets that have it.
    """

    def __init__(self, obj: Any, earlier: Sequence[Plan] = ()) -> None:
        self._obj = obj
        self._earlier = earlier
        self._notices: list[Notice] = []
        self._failures: dict[str, tuple[SpiralPocketError, list[str]]] = {}
        self._selected = selection.selected(obj.Base)
        self._deepest = min(selection.heights(obj.Base), default=0.0)
        self.plans: list[Plan] = []

    def plan(self, progress: Progress | None = None) -> None:
        """Plan all pockets.

        Raises
        ------
        CancelledError
            If `progress` says so.
        """
        count = len(self._selected)
        for number, (model, name) in enumerate(self._selected):
            try:
                self._plan_one(model, name, _part_of(progress, number, count))
            except CancelledError:
                raise
            except SpiralPocketError as error:
                labels = self._failures.setdefault(str(error), (error, []))[1]
                labels.append(selection.label(model, name))

    @property
    def errors(self) -> list[SpiralPocketError]:
        """Return what went wrong; an error that all pockets share names none of them."""
        result = []
        for error, labels in self._failures.values():
            if len(labels) < len(self._selected) and labels[0] not in error.message:
                message = f"{'; '.join(labels)}: {error.message}"
                error = type(error)(message, error.hint, error.place)
            result.append(error)
        return result

    def notices(self) -> list[Notice]:
        """Return what the machinist should know, the pockets that failed first."""
        failed = [
            Notice(f"{e.message} This pocket is not cut.", e.hint, e.place) for e in self.errors
        ]
        feeds = []
        if not request.has_feeds(self._obj.ToolController):
            feeds.append(
                Notice(
                    f"{self._obj.ToolController.Label} has no feeds; the path carries none and "
                    "its time is unknown.",
                    "Set the horizontal and vertical feed in the tool controller.",
                )
            )
        return [*failed, *feeds, *self._start_point_notices(), *self._notices]

    def commands(self) -> list[Any]:
        """Return the commands that cut all pockets one after the other."""
        with_feeds = request.has_feeds(self._obj.ToolController)
        return commands.join(
            commands.from_toolpath(p.toolpath, with_feeds=with_feeds) for p in self.plans
        )

    def _start_point_notices(self) -> list[Notice]:
        if not self._obj.UseStartPoint or any(p.request.start_point for p in self.plans):
            return []
        point = self._obj.StartPoint
        return [
            Notice(
                "The start point at {at} lies in none of the pockets.",
                "Set StartPoint inside one, or do without.",
                (point.x, point.y),
            )
        ]

    def _plan_one(self, model: Any, name: str, progress: Progress | None) -> None:
        floor = selection.floor(model, name)
        sag = min(max(self._obj.Tolerance.Value * SAG_SHARE, SAG_RANGE[0]), SAG_RANGE[1])
        outline = geometry.polygon(floor, sag, use_outline=self._obj.UseOutline)
        depth = request.final_depth(self._obj, floor.z, self._deepest)
        plan = self._planned(request.build(self._obj, outline, depth), progress)
        self.plans.append(plan)
        if floor.open_edges:
            self._note(
                floor,
                Notice(
                    "The pocket is open at a side; the cutter stays within the floor there.",
                    "Clear that side with another operation, or enlarge the floor in the model.",
                ),
            )
        for notice in plan.report.notices:
            self._note(floor, notice)

    def _planned(self, wanted: PocketRequest, progress: Progress | None) -> Plan:
        for plan in self._earlier:
            if plan.request == wanted:
                return plan
        return plan_pocket(wanted, progress)

    def _note(self, floor: selection.Floor, notice: Notice) -> None:
        if len(self._selected) > 1:
            notice = Notice(f"{floor.label}: {notice.message}", notice.hint, notice.place)
        self._notices.append(notice)


def _part_of(progress: Progress | None, number: int, count: int) -> Progress | None:
    """Return the progress of pocket `number` out of `count` as a part of the whole."""
    if progress is None:
        return None
    prefix = f"Pocket {number + 1} of {count}: " if count > 1 else ""
    return lambda done, stage: progress((number + done) / count, prefix + stage)
