# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair of what the proof finds wrong, a few times at most, before a path is refused.

The proof judges the emitted moves and tells which of them run through stock. First
every link among these becomes a cut at both ends, if all that it does is to touch the
edge of the stock, or else a lift over the safe height: neither needs new laps. What then
still is wrong, a gouge, a rapid or link through stock, ground left standing, lies in some
room; its path is planned again, with a smaller step-over, then by other strategies. Each
change is proved as a whole and kept only if it is better.

Repair decides nothing by itself that the proof does not see, and never hides: what is
left is refused or told by the planner.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial

from shapely import Point, Polygon

from .floor import FloorPath, Pass
from .growth.front_rules import MEETING
from .levels import at_level
from .links.passes import with_leads
from .model import PocketRequest, Report, Strategy
from .proof.findings import TOUCH, gouge_allowed, uncut_allowed
from .rendering import Cut
from .toolpath import Role, Toolpath

#: A path is proved so many times more at most, and if it would be refused, so many.
ROUNDS, LAST_ROUNDS = 5, 9
#: Shares of the step-over with which a room is planned again, in this order; then by other
#: strategies, by these instead of *Automatic*: the first refuses islands.
STEPOVERS = (0.93, 0.8, 0.64)
OTHERS = (Strategy.LINEAR_MORPH, Strategy.EXTENDED_ARCHIMEDEAN)
#: What is wrong is the same where it differs by no more than this share: no step-over is its cause.
SAME = 0.05
#: Links that touch stock over no more than this each, in the mean, become cuts over so much at both
#: ends, over R: they begin and end at its very edge.
LEAD = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Proved:
    """A path and what the proof says of it.

    Attributes
    ----------
    cuts : sequence of Cut
    toolpath : Toolpath
    report : Report
    hits : frozenset of tuple of int
        Which cuts, and which of their passes (-1: the way down), have rapids or links through
        stock.
    complete : bool
        Whether every room has a path; ground left in one without is nothing to repair.
    """

    cuts: Sequence[Cut]
    toolpath: Toolpath
    report: Report
    hits: frozenset[tuple[int, int]]
    complete: bool = True


#: What tells apart rooms that are cut by different paths, see `Room.ground`.
Ground = tuple[bytes, bytes | None]
#: Returns the proved path of cuts.
Prover = Callable[[Sequence[Cut]], Proved]
#: Returns the path of a region by other settings; None if these cannot cut it.
Planner = Callable[[Polygon, PocketRequest], FloorPath | None]


def repaired(
    proved: Proved, request: PocketRequest, prove_cuts: Prover, plan_again: Planner
) -> Proved:
    """Return the path, repaired as far as that succeeds.

    Parameters
    ----------
    proved : Proved
    request : PocketRequest
    prove_cuts, plan_again : callable
    """
    best, repair = proved, _Repair(request, plan_again)
    latest = best
    for round_ in range(LAST_ROUNDS):
        gouge, hit, left = badness(best, request)
        if not (gouge or hit or (left and round_ < ROUNDS)):
            break
        cuts = repair.relinked(latest)
        is_relinked = cuts is not None
        if cuts is None:
            cuts = repair.planned_again(best)
        if cuts is None:
            break
        tried = prove_cuts(cuts)
        if not is_relinked and _is_as_bad(tried, best, request):
            repair.leave_stepovers()
        if badness(tried, request) < badness(best, request):
            best = tried
        # where one link has run through stock it may stand in the way of the next
        latest = tried if is_relinked else best
    return best


def badness(proved: Proved, request: PocketRequest) -> tuple[float, float, float]:
    """Return how far a path is from being handed out: gouge, hits [mm], ground left [mm2].

    Each is 0 where it is good enough; the first that differs decides between two paths.
    """
    report = proved.report
    gouge = report.gouge - gouge_allowed(request)
    hit = max(report.rapid_hit, 0.0) + max(report.link_hit, 0.0)
    struck = report.rapid_hit > TOUCH or report.link_hit > TOUCH
    left = _left(report, request) if proved.complete else 0.0
    return max(gouge, 0.0), hit if struck else 0.0, left


def other_settings(request: PocketRequest) -> list[PocketRequest]:
    """Return the requests by which a room is planned again, in this order."""
    cutting = request.cutting
    stepover = cutting.stepover
    others: tuple[Strategy, ...] = (Strategy.AUTOMATIC,)
    if request.strategy is Strategy.AUTOMATIC:  # no lap of its own is wider
        others, stepover = OTHERS, min(stepover, MEETING * request.cutter_radius)
    return [
        *(
            replace(request, cutting=replace(cutting, stepover=share * stepover))
            for share in STEPOVERS
        ),
        *(replace(request, strategy=other) for other in others),
    ]


class _Repair:
    """What has been tried so far."""

    def __init__(self, request: PocketRequest, plan_again: Planner) -> None:
        self._request, self._plan_again = request, plan_again
        self._led: set[Pass] = set()
        self._lifted: set[Pass] = set()
        self._settings: dict[Ground, list[PocketRequest]] = {}

    def relinked(self, proved: Proved) -> list[Cut] | None:
        """Return cuts with other links where these run through stock; None without any new."""
        lead = LEAD * self._request.cutter_radius
        links = sum(_is_link(proved.cuts[cut].path, part) for cut, part in proved.hits)
        cuts = None
        if proved.report.link_hit <= lead * links:
            cuts = self._relinked(proved, self._led, partial(with_leads, length=lead))
        return cuts or self._relinked(proved, self._lifted, with_lifts)

    def _relinked(
        self,
        proved: Proved,
        done: set[Pass],
        change: Callable[[FloorPath, set[int]], FloorPath],
    ) -> list[Cut] | None:
        """Return the cuts with other links where these run through stock; None without any new.

        `done` holds the links that have been changed so, and what became of them.
        """
        found: dict[FloorPath, set[int]] = {}
        for number, part in proved.hits:
            path = proved.cuts[number].path
            if _is_link(path, part) and path.passes[part] not in done:
                found.setdefault(path, set()).add(part)
        if not found:
            return None
        changed = {path: change(path, parts) for path, parts in found.items()}
        for path, parts in found.items():
            new = set(changed[path].passes) - set(path.passes)
            links = [*(path.passes[i] for i in parts), *new]
            done.update(p for p in links if isinstance(p, Pass) and p.role is Role.LINK)
        return [replace(cut, path=changed.get(cut.path, cut.path)) for cut in proved.cuts]

    def leave_stepovers(self) -> None:
        """Plan no room again by a smaller step-over that has been so already."""
        for settings in self._settings.values():
            settings[:] = [s for s in settings if s.strategy is not self._request.strategy]

    def planned_again(self, proved: Proved) -> list[Cut] | None:
        """Return the cuts with new paths where something is wrong; None without any."""
        new: dict[Ground, tuple[FloorPath, PocketRequest]] = {}
        for cut in _sick(proved, self._request):
            key = cut.room.ground
            settings = self._settings.setdefault(key, other_settings(self._request))
            while key not in new and settings:
                other = settings.pop(0)
                path = self._plan_again(cut.room.region, at_level(other, cut.room.level))
                if path is not None:
                    new[key] = path, other
        if not new:
            return None
        return [
            Cut(cut.room, *new.get(cut.room.ground, (cut.path, cut.settings)))
            for cut in proved.cuts
        ]


def with_lifts(path: FloorPath, parts: Iterable[int]) -> FloorPath:
    """Return a path that lifts over the given links; a link at its very end is left out."""
    chosen, passes = set(parts), []
    for number, part in enumerate(path.passes):
        if number not in chosen or not isinstance(part, Pass):
            passes.append(part)
        elif number < len(path.passes) - 1:
            passes.append(Pass(part.points[-1:], Role.AIR))
    return replace(path, passes=tuple(passes))


def _is_link(path: FloorPath, number: int) -> bool:
    part = path.passes[number] if number >= 0 else None
    return isinstance(part, Pass) and part.role is Role.LINK


def _sick(proved: Proved, request: PocketRequest) -> list[Cut]:
    """Return the cuts that something is wrong with, by the worst that there is."""
    gouge, hit, left = badness(proved, request)
    reach = request.cutter_radius + request.cutting.stock_to_leave + request.tolerance
    if gouge:
        place = proved.report.gouge_place
        return [
            cut
            for cut in proved.cuts
            if place is None or cut.room.region.distance(Point(place)) <= gouge + reach
        ]
    if hit:
        return [proved.cuts[number] for number in sorted({cut for cut, _ in proved.hits})]
    if left:
        return [cut for cut in proved.cuts if cut.room.region.dwithin(proved.report.uncut, reach)]
    return []


def _is_as_bad(tried: Proved, before: Proved, request: PocketRequest) -> bool:
    """Return whether a path leaves as much ground as another one, or runs through as much stock.

    A shallow notch or the tip of a wedge stays at any step-over, and so does stock where the cutter
    goes down.
    """
    gouge, *before_it = badness(before, request)
    return not gouge and all(
        abs(now - then) <= SAME * then
        for now, then in zip(badness(tried, request)[1:], before_it, strict=True)
    )


def _left(report: Report, request: PocketRequest) -> float:
    """Return the ground left standing that is worth another plan [mm2]: what would be told.

    Without a closing lap the corners are left on purpose.
    """
    leaves_corners = request.strategy.has_closing_lap and not request.cutting.finishing_lap
    if leaves_corners or report.uncut_area <= uncut_allowed(request):
        return 0.0
    return report.uncut_area
