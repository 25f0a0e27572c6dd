# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pocket as it will be: its draft, its plan."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import FreeCAD

from ...beside.tasks import Drawn
from ...engine.errors import SpiralPocketError
from ...engine.model import PocketRequest
from . import lanes
from .lane import Job

if TYPE_CHECKING:
    from ...engine.draft import Draft


class Pocket:
    """One pocket: its draft first, then its plan or why there is none.

    Attributes
    ----------
    request, original : PocketRequest
        Its own, and that of the first pocket that it is a copy of, or its own.
    label : str
        What the user calls its floor.
    draft : Draft or None
    is_drafted : bool
        Whether there is a draft, or will be none.
    drawn : Drawn or None
        The proved plan.
    error : SpiralPocketError or None
        Why there is none.
    """

    def __init__(
        self, request: PocketRequest, original: PocketRequest, tell: Callable[[], None]
    ) -> None:
        self.request, self.original = request, original
        self.label = ""
        self.draft: Draft | None = None
        self.is_drafted = False
        self.drawn: Drawn | None = None
        self.error: SpiralPocketError | None = None
        self._tell = tell
        self._jobs: list[tuple[Any, Job]] = []

    @property
    def is_settled(self) -> bool:
        """Return whether its plan is there, or will not be."""
        return self.drawn is not None or self.error is not None

    @property
    def fraction(self) -> float:
        """Return the share of the proof that is done."""
        shares = [job.fraction for _, job in self._jobs if job.task == "plan"]
        return 1.0 if self.is_settled else max(shares, default=0.0)

    def draw(self) -> None:
        """Take the plan if it is known, else ask for a draft."""
        if self.is_settled or self.is_drafted or self._jobs or self._take_known():
            return
        self._start(lanes.drafts, lanes.drafts.submit("draft", self.request))

    def prove(self) -> None:
        """Ask for the plan."""
        if self.is_settled or any(job.task == "plan" for _, job in self._jobs):
            return
        if not self._take_known():
            self._start(lanes.proofs, lanes.prove(self.original))

    def close(self) -> None:
        """Give up what is under way."""
        jobs, self._jobs = self._jobs, []
        for lane, job in jobs:
            if self._hear in job.listeners:
                job.listeners.remove(self._hear)
            lane.give_up(job)

    def _start(self, lane: Any, job: Job) -> None:
        self._jobs.append((lane, job))
        job.listeners.append(self._hear)

    def _take_known(self) -> bool:
        outcome = lanes.known(self.original)
        if outcome is not None and self.original is not self.request:
            outcome = self._moved(outcome)
        if isinstance(outcome, SpiralPocketError):
            self.error = outcome
        elif outcome is not None:
            self.drawn = outcome
        return outcome is not None

    def _moved(self, outcome: Drawn | SpiralPocketError) -> Drawn | SpiralPocketError:
        """Return what came of the original as its own."""
        from ...engine import copies  # where shapely is missing the window opens all the same

        plan = outcome.plan if isinstance(outcome, Drawn) else outcome
        own = copies.moved(plan, self.original, self.request)
        return own if isinstance(own, SpiralPocketError) else Drawn.of(own)

    def _hear(self, job: Job) -> None:
        if job.crash:
            FreeCAD.Console.PrintError(job.crash + "\n")
            self.error = SpiralPocketError("An error in the add-on: see the Report view.")
        elif job.is_done and job.task == "draft":
            # without a draft, the proof says what is the matter
            self.draft, self.is_drafted = job.result, True
        elif job.is_done:
            self._take_known()
        if self.is_settled:
            self.close()
        self._tell()
