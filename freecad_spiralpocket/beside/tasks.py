# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done beside FreeCAD: each task takes one record and returns one.

Runs in a process that has neither FreeCAD nor Qt (`process`), or in a thread of the window
where no such process can be started. Everything that goes in or out is pickled. The
engine is loaded by the first task: without shapely the window opens all the same.
"""

from __future__ import annotations

import math
import pickle
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from .interpreters import cores

if TYPE_CHECKING:
    from shapely import Polygon

    from ..engine.draft import Draft, DraftOpening
    from ..engine.model import Plan, PocketRequest, Progress
    from ..trace import Areas, Trace

#: Openings of so many pockets are kept.
KEPT = 64
#: A pocket is opened as before while the stock to leave differs by no more than this, over R.
ALIKE = 0.1
#: Further processes for the levels of one pocket, at most: others may be planned beside it.
SPARE = 3


@dataclass(frozen=True, eq=False)
class Drawn:
    """A plan and what is drawn of it."""

    plan: Plan
    trace: Trace
    areas: Areas

    @classmethod
    def of(cls, plan: Plan) -> Drawn:
        """Return a plan, drawn."""
        from ..trace import areas_of, trace_of

        return cls(plan, trace_of(plan), areas_of(plan))


class Tasks:
    """All tasks, by name, and what they keep from one call to the next."""

    def __init__(self) -> None:
        # by the stock to leave, the first one found without another
        self._openings: dict[Any, dict[float, list[DraftOpening]]] = {}

    def __getitem__(self, name: str) -> Callable[[Any, Progress], Any]:
        """Return the task of that name."""
        return getattr(self, name)

    def draft(self, request: PocketRequest, _: Progress) -> Draft:
        """Return rough laps; how the pocket is opened is known from the last time."""
        from ..engine.draft import draft

        return draft(request, self._opened(request))

    def _opened(self, request: PocketRequest) -> list[DraftOpening]:
        """Return how a pocket is opened, as the last time if its walls have hardly moved."""
        from ..engine.draft import openings, reopened

        stock = request.cutting.stock_to_leave
        # other step-overs and depths may have another start; a draft does with the one it has
        key = (
            request.pocket,
            request.tool_diameter,
            request.cutting.cut_mode,
            request.entry,
            request.start_point,
            request.stock,
            request.beyond,
        )
        known = self._openings.pop(key, {})
        if stock not in known:
            first = next(iter(known), math.inf)
            found = None
            if abs(stock - first) <= ALIKE * request.cutter_radius and len(known) < KEPT:
                found = reopened(known[first], request)
            if found is None:
                known, found = {}, openings(request)
            known[stock] = found
        self._openings[key] = known  # as the newest
        for old in list(self._openings)[:-KEPT]:
            del self._openings[old]
        return known[stock]

    def packed_plan(self, request: PocketRequest, progress: Progress) -> bytes:
        """Return the proved plan, pickled, for the receiver to unpack when and where it may."""
        from ..engine.planner import plan

        return pickle.dumps(plan(request, progress), pickle.HIGHEST_PROTOCOL)

    def packed_floor_path(self, asked: tuple[Polygon, PocketRequest], progress: Progress) -> bytes:
        """Return the path of a region or what is the matter with it, pickled."""
        from ..engine.errors import report_progress
        from ..engine.floor_paths import floor_path

        def tick(done: float) -> None:
            report_progress(progress, done, "")

        return pickle.dumps(floor_path(*asked, tick), pickle.HIGHEST_PROTOCOL)

    def plan(self, request: PocketRequest, progress: Progress) -> Drawn:
        """Return the proved plan, drawn."""
        from ..engine.planner import plan
        from .crew import lay_together

        spare = max(0, min(SPARE, cores() - 2))  # this one and the window have one each
        return Drawn.of(plan(request, progress, partial(lay_together, helpers=spare)))

    def adaptive(self, request: PocketRequest, _: Progress) -> Drawn:
        """Return what FreeCAD's own Adaptive makes of a request, drawn."""
        from ..adaptive import plan_adaptive

        return Drawn.of(plan_adaptive(request))
