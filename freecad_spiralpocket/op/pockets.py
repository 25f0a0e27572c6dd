# SPDX-License-Identifier: LGPL-2.1-or-later
"""All pockets of one operation: each is planned on its own and fails on its own.

A plan is taken over from the last recompute where its request is the same, so
that adding a tenth face to nine plans one pocket, and changing the coolant none. Pockets that
are copies of each other have the same path (copies.py).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, TypeAlias

from ..beside.crew import plan_together
from ..engine import copies
from ..engine.errors import SpiralPocketError, named
from ..engine.model import Notice, Plan, PocketRequest, Progress
from ..engine.proof.findings import uncut_allowed
from . import (
    commands,
    geometry,
    open_sides,
    remarks,
    request,
    rest,
    seams,
    sections,
    selection,
    shared_ground,
    walls,
)
from .compat import parent_job
from .known import Known
from .level import SAME_HEIGHT
from .solids import solids_of

#: Share of the operation's tolerance that goes into the chords of curved walls; the rest is
#: for the path.
SAG_SHARE = 0.2
#: Limits of the sag [mm]: a tolerance of 0 is refused later, a wide one must not lose arcs.
SAG_RANGE = (1e-4, 0.02)

#: Plans many pockets: called with their requests and a progress, returns for each a plan or what
#: is the matter with it; raises `CancelledError` if the progress says so.
Planner: TypeAlias = Callable[
    [Sequence[PocketRequest], Progress | None], Sequence[Plan | SpiralPocketError]
]


class Found(NamedTuple):
    """A selected floor and its request, or what is the matter.

    Attributes
    ----------
    label : str
        What the user calls the floor.
    floor : Floor or None
    wanted : PocketRequest or SpiralPocketError
    kept_off : float
        How much of the floor is kept off for what hangs over it [mm2].
    is_shared : bool
        Whether other parts of the job stand in the pocket or over it.
    whole : PocketRequest or None
        Of which `wanted` is what pockets before it leave.
    """

    label: str
    floor: selection.Floor | None
    wanted: PocketRequest | SpiralPocketError
    kept_off: float = 0.0
    is_shared: bool = False
    whole: PocketRequest | None = None


class Pockets:
    """The pockets of an operation.

    Parameters
    ----------
    obj : object
        The operation.
    earlier : sequence of Plan
        What may be taken over.
    known : Known, optional
        From earlier calls for the same operation; is added to.

    Attributes
    ----------
    plans : list of Plan
    errors : list of SpiralPocketError
        One for each thing that is the matter, naming the pockets that have it.
    """

    def __init__(self, obj: Any, earlier: Sequence[Plan] = (), known: Known | None = None) -> None:
        self._obj = obj
        self._known = known or Known()
        firsts = copies.originals([plan.request for plan in earlier])
        self._earlier = [earlier[i] for i in dict.fromkeys(firsts)]
        self._notices: list[tuple[str, Notice]] = []
        self._failures: list[tuple[str, SpiralPocketError]] = []
        self.plans: list[Plan] = []
        shapes = (getattr(model, "Shape", None) for model in parent_job(obj).Model.Group)
        self._shapes = [shape for shape in shapes if shape is not None and not shape.isNull()]
        self._deepest = min(selection.heights(obj.Base, self._known), default=0.0)
        self._solids = [s for shape in self._shapes for s in solids_of(shape, self._known)]
        groups = seams.groups(selection.selected(obj.Base))
        found = [floor for group in groups for floor in self._floors_of(*group)]
        self._selected = self._without_twins(found)

    def requests(self) -> list[Found]:
        """Return for each selected floor what was found, in the order in which they are cut."""
        floors = [self._floor(*face) for face in self._selected]
        sound = [f for f in floors if isinstance(f, selection.Floor)]
        found: list[Found] = []
        for (model, names), floor in zip(self._selected, floors, strict=True):
            label = selection.label(model, ", ".join(names))
            if isinstance(floor, SpiralPocketError):
                found.append(Found(label, None, floor))
                continue
            try:
                found.append(self._request(label, floor, sound))
            except SpiralPocketError as error:
                found.append(Found(label, None, error))
        return _without_shared_ground(found)

    def plan(self, progress: Progress | None = None, planner: Planner | None = None) -> None:
        """Plan all pockets, by default with a process for every further core.

        Raises
        ------
        CancelledError
            If `progress` says so.
        """
        found = self.requests()
        whole = [each.whole for each in found if each.whole is not None]
        outcomes = iter(self._all_outcomes(whole, progress, planner or plan_together))
        for each in found:
            outcome = each.wanted if each.whole is None else next(outcomes)
            if isinstance(outcome, SpiralPocketError):
                self._failures.append((each.label, outcome))
            else:
                self._take(each, outcome, found)

    def _all_outcomes(
        self, whole: Sequence[PocketRequest], progress: Progress | None, planner: Planner
    ) -> list[Plan | SpiralPocketError]:
        """Return what comes of each pocket; where one leaves ground the others begin at the top."""
        failed: set[int] = set()
        while True:
            wanted = shared_ground.lowered(whole, failed)
            outcomes = self._outcomes(wanted, progress, planner)
            failed |= {i for i, outcome in enumerate(outcomes) if not _is_cleared(outcome)}
            if shared_ground.lowered(whole, failed) == wanted:
                return outcomes

    def _outcomes(
        self, wanted: Sequence[PocketRequest], progress: Progress | None, planner: Planner
    ) -> list[Plan | SpiralPocketError]:
        """Return what comes of each request. Of copies the first is planned."""
        firsts = copies.originals(wanted)
        known: dict[int, Any] = {i: self._taken_over(wanted[i]) for i in dict.fromkeys(firsts)}
        missing = [i for i, plan in known.items() if plan is None]
        planned = planner([wanted[i] for i in missing], progress)
        known |= zip(missing, planned, strict=True)
        self._earlier += [plan for plan in planned if isinstance(plan, Plan)]
        return [
            known[first] if first == i else copies.moved(known[first], wanted[first], wanted[i])
            for i, first in enumerate(firsts)
        ]

    @property
    def errors(self) -> list[SpiralPocketError]:
        """Return what went wrong; an error that all pockets share names none of them."""
        return named(self._failures, len(self._selected))

    def notices(self) -> list[Notice]:
        """Return what the machinist should know, the pockets that failed first."""
        failed = [
            Notice(f"{e.message} This pocket is not cut.", e.hint, e.place) for e in self.errors
        ]
        general = self._general_notices([p.request for p in self.plans])
        return [*failed, *general, *remarks.labelled(self._notices, len(self._selected))]

    def foreseen_notices(self, found: Sequence[Found]) -> list[Notice]:
        """Return what is known of `requests()` before anything is planned."""
        wanted = [each.wanted for each in found if isinstance(each.wanted, PocketRequest)]
        told = [notice for each in found for notice in self._remarks_on(each, found)]
        return [*self._general_notices(wanted), *remarks.labelled(told, len(self._selected))]

    def _general_notices(self, wanted: Sequence[PocketRequest]) -> list[Notice]:
        """Return what concerns all pockets."""
        feeds, missing = [], request.missing_feeds(self._obj.ToolController)
        if missing:
            feeds.append(
                Notice(
                    f"{self._obj.ToolController.Label} has no {missing}; the path carries no "
                    "feeds and its time is unknown.",
                    "Set the horizontal and vertical feed in the tool controller.",
                )
            )
        elif wanted:
            feeds = remarks.feed(wanted[0])
        depth = max((w.axial_depth for w in wanted), default=0.0)
        step = max((w.cutting.stepover for w in wanted), default=0.0)
        top = parent_job(self._obj).Stock.Shape.BoundBox.ZMax
        reach = max((top - w.floor for w in wanted), default=0.0)
        tool = remarks.tool(self._obj.ToolController, depth, reach, step)
        return [*feeds, *tool, *self._start_point_notices(wanted)]

    def commands(self) -> list[Any]:
        """Return the commands that cut all pockets one after the other."""
        with_feeds = request.has_feeds(self._obj.ToolController)
        return commands.join(
            commands.from_toolpath(p.toolpath, with_feeds=with_feeds) for p in self.plans
        )

    def _start_point_notices(self, wanted: Sequence[PocketRequest]) -> list[Notice]:
        if not self._obj.UseStartPoint or not wanted or any(w.start_point for w in wanted):
            return []
        point = self._obj.StartPoint
        return [
            Notice(
                "The start point at {at} lies in none of the pockets.",
                "Set StartPoint inside one, or do without.",
                (point.x, point.y),
            )
        ]

    def _floors_of(self, model: Any, names: Sequence[str]) -> list[tuple[Any, Sequence[str]]]:
        """Return faces that meet as one floor, each alone where they are only a part of one."""
        if len(names) == 1 or isinstance(self._floor(model, names), selection.Floor):
            return [(model, names)]
        return [(model, [name]) for name in names]

    def _without_twins(
        self, found: Sequence[tuple[Any, Sequence[str]]]
    ) -> list[tuple[Any, Sequence[str]]]:
        """Return faces without further walls of the same window."""
        kept: list[tuple[Any, Sequence[str]]] = []
        windows: list[selection.Floor] = []
        for face in found:
            floor = self._floor(*face)
            if isinstance(floor, selection.Floor) and floor.is_window:
                if any(selection.are_at_one_place(floor, other) for other in windows):
                    continue
                windows.append(floor)
            kept.append(face)
        return kept

    def _floor(self, model: Any, names: Sequence[str]) -> selection.Floor | SpiralPocketError:
        """Return the floor that faces are, or why they are none."""
        key = (model.Name, tuple(names), model.Shape.hashCode())
        floors = self._known.floors
        if key not in floors:
            try:
                floors[key] = selection.floor(model, names, self._known)
            except SpiralPocketError as error:
                return error
        return floors[key]

    def _request(
        self, label: str, floor: selection.Floor, floors: Sequence[selection.Floor]
    ) -> Found:
        """Return the request for the pocket above a floor, one of those selected."""
        selection.check_stock(floor, parent_job(self._obj).Stock.Shape.BoundBox)
        sag = min(max(self._obj.Tolerance.Value * SAG_SHARE, SAG_RANGE[0]), SAG_RANGE[1])
        beyond = self._open_sides(floor, sag)
        shapes = self._shapes
        codes = (shape.hashCode() for shape in shapes)
        key = (id(floor), sag, self._obj.UseOutline, beyond and id(beyond), *codes)
        if key not in self._known.walls:
            self._known.walls[key] = walls.Walls(
                floor,
                sag,
                use_outline=self._obj.UseOutline,
                open_sides=beyond,
                others=selection.others(floor, self._solids),
            )
        above = self._known.walls[key]
        depth = request.final_depth(self._obj, floor.z, self._deepest)
        stock = beyond.stock if beyond else None
        wanted = request.build(self._obj, above.outline, depth, stock, above.beyond)
        others = [other for other in floors if other is not floor]
        fitted = sections.fitted(wanted, floor, above, others, sag)
        kept_off = remarks.overhung(above.outline, fitted.pocket)
        if self._obj.UseRestMachining:
            fitted = rest.rest_of(fitted, self._obj, self._known)
        return Found(label, floor, fitted, kept_off, above.are_others_inside, fitted)

    def _open_sides(self, floor: selection.Floor, sag: float) -> open_sides.OpenSides | None:
        """Return the floor's open sides if the cutter goes beyond them, else None."""
        if not (floor.open_edges and self._obj.ExtendOpenSides):
            return None
        job, shapes = parent_job(self._obj), self._shapes
        radius, left = self._obj.OpToolDiameter.Value / 2, self._obj.StockToLeave.Value
        stock = open_sides.outline_of_stock(job.Stock.Shape)
        key = (id(floor), sag, radius, left, stock.wkb, *(shape.hashCode() for shape in shapes))
        if key not in self._known.open_sides:
            self._known.open_sides[key] = open_sides.OpenSides(
                floor,
                sag,
                solids=self._solids,
                stock=stock,
                cutter_radius=radius,
                stock_to_leave=left,
            )
        return self._known.open_sides[key]

    def _taken_over(self, wanted: PocketRequest) -> Plan | None:
        """Return an earlier plan for the same request, or None.

        What was a copy's is not: the path must be the same whatever was selected before.
        """
        return next((plan for plan in self._earlier if plan.request == wanted), None)

    def _take(self, each: Found, plan: Plan, found: Sequence[Found]) -> None:
        """Add the plan of one pocket, and what is to be told of it."""
        self.plans.append(plan)
        self._notices += self._remarks_on(each, found)
        if each.floor is not None:
            self._notices += [(each.floor.label, notice) for notice in plan.report.notices]

    def _remarks_on(self, each: Found, among: Sequence[Found]) -> list[tuple[str, Notice]]:
        """Return what is to be told of one pocket, with its label, whatever comes of its plan."""
        _, floor, _, kept_off, is_shared, wanted = each
        if floor is None or wanted is None:
            return []
        found = remarks.setup(wanted, floor.z, self._obj)
        if floor.model.Name not in {m.Name for m in parent_job(self._obj).Model.Group}:
            found.append(remarks.foreign(floor.model.Label))
        if floor.is_window and floor.z > floor.part.BoundBox.ZMin + SAME_HEIGHT:
            found.append(remarks.ends_higher(floor.z, floor.part.BoundBox.ZMin, wanted.floor))
        if floor.goes_on:
            found.append(remarks.goes_on())
        if floor.open_edges:
            found.append(remarks.open_sides(wanted))
        if self._obj.UseOutline and (away := geometry.islands(floor, SAG_RANGE[1])):
            found.append(remarks.islands(sum(island.area for island in away)))
        if is_shared:
            found.append(remarks.others(kept_off))
        elif kept_off > remarks.TOLD_OVERHANG:
            found.append(remarks.overhang(kept_off))
        if self._obj.UseRestMachining:
            found.append(remarks.rest(rest.share_cleared(wanted)))
        else:
            others = [o.whole.pocket for o in among if o.whole and o is not each]
            found += remarks.ledges(wanted, others)
        return [(floor.label, notice) for notice in found]


def _without_shared_ground(found: Sequence[Found]) -> list[Found]:
    """Return what was found in the order in which it is cut, none where others have been."""
    places = [i for i, each in enumerate(found) if each.whole is not None]
    whole = [found[i].whole for i in places]
    order = shared_ground.order(whole)
    turned = dict(zip(places, (places[i] for i in order), strict=True))
    wanted = iter(shared_ground.lowered([whole[i] for i in order]))
    return [
        each if each.whole is None else each._replace(wanted=next(wanted))
        for each in (found[turned.get(i, i)] for i in range(len(found)))
    ]


def _is_cleared(outcome: Plan | SpiralPocketError) -> bool:
    """Return whether a pocket is cut as far as the cutter reaches."""
    return isinstance(outcome, Plan) and outcome.report.uncut_area <= uncut_allowed(outcome.request)
