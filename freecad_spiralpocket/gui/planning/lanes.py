# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the window has its pockets planned, and what is kept of it.

Two lanes: short drafts, which are never ended, and proofs, which are when a value
changes or Stop is pressed. Proved plans are kept, the newest of them, so that OK takes
what the preview has shown and going back to an earlier value costs nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ...beside.interpreters import cores
from ...beside.progress import stage_among
from ...beside.tasks import Drawn
from ...engine.errors import SpiralPocketError, report_progress
from ...engine.model import Plan, PocketRequest, Progress
from .lane import Job, Lane

#: So many proved plans are kept.
KEPT = 60
#: Processes that prove; one core is left to the window and the drafts.
PROVERS = max(1, min(4, cores() - 1))
#: Processes that draft, where there are many pockets: proofs and the window wait meanwhile.
DRAFTERS = max(1, min(3, cores()))
WAIT = 20  # ms, how long Stop may go unheard

drafts = Lane(DRAFTERS)
proofs = Lane(PROVERS, is_patient=True)

#: What came of requests, the newest last.
proved: dict[PocketRequest, Drawn | SpiralPocketError] = {}


def known(request: PocketRequest) -> Drawn | SpiralPocketError | None:
    """Return what is known of a request: its plan, why there is none, or None."""
    outcome = proved.pop(request, None)
    if outcome is not None:
        proved[request] = outcome  # as the newest
    return outcome


def prove(request: PocketRequest) -> Job:
    """Return the job that proves a request; when it is done the outcome is known."""
    job = proofs.submit("plan", request)
    if _keep not in job.listeners:
        job.listeners.insert(0, _keep)
    return job


def _keep(job: Job) -> None:
    outcome = job.error or job.result
    if job.is_done and outcome is not None:
        proved[job.argument] = outcome
        for old in list(proved)[:-KEPT]:
            del proved[old]


def plan_all(
    requests: Sequence[PocketRequest], progress: Progress | None
) -> list[Plan | SpiralPocketError]:
    """Plan pockets beside the window; a `Planner` for the operation's recompute.

    Raises
    ------
    CancelledError
        If `progress` says so; whatever was under way is ended.
    """
    outcomes: list[Any] = [known(request) for request in requests]
    missing = [i for i, outcome in enumerate(outcomes) if outcome is None]
    jobs = [prove(requests[i]) for i in missing]
    try:
        while not all(job.is_done for job in jobs):
            proofs.wait(WAIT)
            report_progress(progress, *_how_far(jobs))
    finally:
        for job in jobs:
            proofs.give_up(job)
    for i, job in zip(missing, jobs, strict=True):
        if job.crash:
            raise RuntimeError(job.crash)
        outcomes[i] = job.error or job.result
    return [o.plan if isinstance(o, Drawn) else o for o in outcomes]


def _how_far(jobs: Sequence[Job]) -> tuple[float, str]:
    """Return the share of all jobs that is done, and what is being done."""
    fraction = sum(job.fraction for job in jobs) / len(jobs)
    busy = next((job for job in jobs if not job.is_done and job.stage), None)
    done = sum(job.is_done for job in jobs)
    return fraction, stage_among(done, len(jobs), busy.stage if busy else "")
