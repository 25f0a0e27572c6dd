# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole way from a request to a proved plan, as a page of named stages.

check -> levels -> rooms, the cutter-center regions of each level -> a floor path
for each -> entry, lifts -> feeds -> proof -> repair. Strategies only know climb milling:
for conventional milling the regions are mirrored before, and what came of them
after.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.polygon import orient

from .checks import check_request
from .contact.engagement import Engagement, engagement_of
from .dependencies import require_libraries
from .errors import (
    AlreadyClearedError,
    ProofError,
    SpiralPocketError,
    report_progress,
    told_area,
)
from .floor import FloorPath
from .floor_paths import FloorPaths, floor_path, floor_paths
from .growth.front_rules import MEETING
from .levels import at_level, levels_of
from .machine import machine_of
from .model import (
    CutMode,
    Notice,
    Plan,
    PocketRequest,
    Progress,
    SplineCurve,
    Strategy,
)
from .motion.feed import FeedRules, plan_feeds
from .motion.stations import ends_of, moves_at, stations_of
from .opening.leftovers import is_left
from .proof.verify import prove
from .rendering import Cut, render
from .repair import Proved, badness, repaired
from .rooms import Room, rooms_of
from .shapes.region import grow
from .toolpath import Toolpath

#: Points of an outline that matter less than this are left out where most do [mm].
CROWD = 5e-4
#: That no lap is as wide as the step-over is told where that is wider by this: else both are nearly
#: the same percentage.
WIDER = 1.02


def plan(
    request: PocketRequest, progress: Progress | None = None, lay: FloorPaths = floor_paths
) -> Plan:
    """Plan the toolpath of one pocket, and prove it.

    Parameters
    ----------
    request : PocketRequest
    progress : callable, optional
        See `model.Progress`.
    lay : callable, optional
        Who lays the paths of all regions; by default one after the other, here.

    Returns
    -------
    Plan
        Its report says what was measured, and what stays uncut.

    Raises
    ------
    SpiralPocketError
        If no part of the pocket can be cut as asked, or the user cancelled; see `errors`.
    """
    require_libraries()
    report_progress(progress, 0.0, "Checking the pocket")
    check_request(request)
    asked, request = request, _without_crowds(request)
    rooms, notices = _rooms_with_stock(request)
    cuts, uncut = _cuts(rooms, request, progress, lay)
    done = {cut.room for cut in cuts}
    missed = [grow(r.region, request.cutter_radius) for r in rooms if r not in done]
    prove_cuts = partial(
        _proved, request=request, missed=shapely.union_all(missed), progress=progress
    )
    again = partial(_planned_again, progress=progress)
    first = prove_cuts(cuts)
    proved = repaired(first, request, prove_cuts, again)
    toolpath, report = proved.toolpath, proved.report
    _refuse_bad(proved, request)
    report_progress(progress, 1.0, "Done")
    changed = _change_notices(proved.cuts, first, request) or _width_notices(request)
    told = (*notices, *uncut, *changed, *_start_notices(toolpath, request), *report.notices)
    report = replace(report, notices=told)
    return Plan(asked, toolpath, report, _curves(proved.cuts, request))


def _without_crowds(request: PocketRequest) -> PocketRequest:
    """Return a request whose outline has no crowds of points that matter to nobody.

    Each costs as much time as one of a wall, and outlines from meshes or scans have thousands.
    """
    is_upright = all(s.pocket == request.pocket and s.mouth is None for s in request.sections)
    slim = shapely.simplify(request.pocket, CROWD)
    counts = shapely.get_num_coordinates([slim, request.pocket])
    if not is_upright or 2 * counts[0] > counts[1]:
        return request
    pocket = orient(slim)
    sections = tuple(replace(section, pocket=pocket) for section in request.sections)
    return replace(request, pocket=pocket, sections=sections)


def _rooms_with_stock(request: PocketRequest) -> tuple[list[Room], list[Notice]]:
    """Return the rooms in which something is left to cut, and what is to be told of the others.

    Raises
    ------
    AlreadyClearedError
        If there is none.
    CutterDoesNotFitError
        If the cutter does not fit the topmost level.
    """
    stock = request.cutting.stock_to_leave
    rooms, notices = rooms_of(levels_of(request), request.cutter_radius, stock)
    rooms = [room for room in rooms if _is_left(room, request)]
    if not rooms:
        raise AlreadyClearedError(
            "Earlier operations have cleared this pocket as far as this cutter reaches.",
            "Unset UseRestMachining to cut it all the same.",
        )
    return rooms, notices


def _is_left(room: Room, request: PocketRequest) -> bool:
    return room.level.stock is None or is_left(room.region, at_level(request, room.level))


def _width_notices(request: PocketRequest) -> list[Notice]:
    """Return what is to be told if no lap will be as wide as the step-over."""
    widest, asked = MEETING * request.cutter_radius, request.cutting.stepover
    if request.strategy is not Strategy.AUTOMATIC or asked < WIDER * widest:
        return []
    percent = 100 / request.tool_diameter
    return [
        Notice(
            f"Of the step-over of {percent * asked:.0f} % Automatic uses {percent * widest:.0f}: "
            "wider laps would leave stock where they meet.",
            "Other strategies use it whole, and may leave stock.",
        )
    ]


def _start_notices(toolpath: Toolpath, request: PocketRequest) -> list[Notice]:
    """Return what is to be told if the cutter goes down far from where it was asked to."""
    asked = request.start_point
    if asked is None:
        return []
    cut = toolpath.points[:, 2] < request.heights.start_depth - 1e-9
    down = toolpath.starts[int(np.argmax(cut)), :2]
    off = float(np.hypot(*(down - asked)))
    if off <= request.tool_diameter:
        return []
    hint = "The strategy Automatic begins anywhere with room for a helix."
    if request.strategy is Strategy.AUTOMATIC:
        hint = "Set StartPoint where a helix has room, or near the slot along the wall."
    return [
        Notice(
            f"The cutter goes down at {{at}}, {off:.0f} mm from the start point: that is as near "
            f"as {request.strategy.value} can begin.",
            hint,
            (float(down[0]), float(down[1])),
        )
    ]


def _proved(
    cuts: Sequence[Cut],
    request: PocketRequest,
    missed: shapely.Geometry,
    progress: Progress | None,
) -> Proved:
    """Return the path of cuts with its feeds, and its proof; `missed` is the ground of others."""
    drawn, owners = render(cuts, request)
    if request.cutting.cut_mode is CutMode.CONVENTIONAL:
        drawn = drawn.mirrored()
    report_progress(progress, 0.7, "Planning feeds")
    toolpath, engagement = _with_feeds(drawn, request)
    report_progress(progress, 0.8, "Proving the path")
    report = prove(request, toolpath, engagement, missed)
    middles = ends_of(toolpath) - toolpath.lengths / 2  # feeds split moves
    hit = owners[moves_at(drawn, middles[sorted(report.hit_moves)])]
    return Proved(
        cuts, toolpath, report, frozenset((int(c), int(p)) for c, p in hit), missed.is_empty
    )


def _planned_again(
    region: Polygon, request: PocketRequest, progress: Progress | None
) -> FloorPath | None:
    """Return the path of one region by other settings, None if these cannot cut it."""

    def tick(done: float) -> None:
        report_progress(progress, 0.8 + 0.1 * done, "Repairing the path")

    path = floor_path(region, request, tick)
    return path if isinstance(path, FloorPath) else None


def _change_notices(cuts: Sequence[Cut], first: Proved, request: PocketRequest) -> list[Notice]:
    """Return what is to be told of regions that are cut by other settings than those asked for.

    `first` is what came of those.
    """
    told: dict[FloorPath, Notice] = {}
    gouge, hit, left = badness(first, request)
    why = "the path asked for failed its proof"
    if not gouge and not hit:
        why = f"the path asked for would leave {told_area(left)} mm2 standing"
    for cut in cuts:
        other = cut.settings
        if other is None:
            continue
        place = cut.room.region.representative_point()
        asked, taken = request.cutting.stepover, other.cutting.stepover
        if other.strategy is request.strategy:
            message = (
                f"The pocket at {{at}} is cut with a step-over of {taken:.3g} mm instead of "
                f"{asked:.3g} mm: {why}."
            )
            hint = f"Set StepOver to {100 * taken / request.tool_diameter:.0f}, or a smaller one."
        else:
            message = (
                f"The pocket at {{at}} is cut by {other.strategy.value} instead of "
                f"{request.strategy.value}: {why}."
            )
            hint = "Choose that strategy, or another step-over."
        told[cut.path] = Notice(message, hint, (float(place.x), float(place.y)))
    return list(told.values())


def _refuse_bad(proved: Proved, request: PocketRequest) -> None:
    """Raise if a path must not be run."""
    report = proved.report
    gouge, hit, _ = badness(proved, request)
    hint = "Try another step-over or strategy, and please report this pocket."
    if gouge:
        raise ProofError(
            f"The path was made, but at {{at}} would cut {report.gouge:.3f} mm into a wall or the "
            "floor; it is not handed out.",
            hint,
            report.gouge_place,
        )
    if hit:
        raise ProofError(
            f"The path was made, but at {{at}} would run {hit:.2g} mm through standing stock where "
            "it should not cut; it is not handed out.",
            hint,
            tuple(proved.toolpath.points[min(report.hit_moves), :2]),
        )


def _with_feeds(toolpath: Toolpath, request: PocketRequest) -> tuple[Toolpath, Engagement]:
    """Return the toolpath with its feeds planned, and the engagement along it."""
    wanted = request.feed_plan
    engagement = engagement_of(toolpath, request)
    rules = FeedRules(
        mode=wanted.mode,
        cutter_radius=request.cutter_radius,
        engagement_limit=request.engagement_limit,
        link_feed=request.link_feed,
        slowed=wanted.slowed,
        largest_ratio=wanted.largest_ratio,
        machine_speed=machine_of(request).flat_speed,
    )
    fed = plan_feeds(toolpath, engagement, rules)
    stations = stations_of(toolpath, engagement.moves, engagement.points)
    moves = np.minimum(np.searchsorted(ends_of(fed), stations - 1e-9), len(fed) - 1)
    return fed, replace(engagement, moves=moves)


def _cuts(
    rooms: Sequence[Room], request: PocketRequest, progress: Progress | None, lay: FloorPaths
) -> tuple[list[Cut], tuple[Notice, ...]]:
    """Return a path for each room that can be cut, and a notice for each that cannot.

    Rooms with the same region in the same stock have the same path; under a room that cannot be cut
    none is.
    """

    def tick(done: float) -> None:
        report_progress(progress, 0.1 + 0.6 * done, "Laying the spiral")

    asked = {room.ground: (room.region, at_level(request, room.level)) for room in rooms}
    paths = dict(zip(asked, lay([*asked.values()], tick), strict=True))
    cuts: list[Cut] = []
    failures: list[tuple[Room, SpiralPocketError]] = []
    shut: set[Room | None] = set()
    for room in rooms:
        path = paths[room.ground]
        if room.above in shut:
            shut.add(room)
        elif isinstance(path, FloorPath):
            cuts.append(Cut(room, path))
        else:
            failures.append((room, path))
            shut.add(room)
    if not cuts:
        raise failures[0][1]
    tops = {cut.room.level.top for cut in cuts}
    return cuts, tuple(
        Notice(_left_out(room, error, tops), error.hint, error.place) for room, error in failures
    )


def _left_out(room: Room, error: SpiralPocketError, tops: Collection[float]) -> str:
    """Return why a room is not cut, and what stays; `tops` are those of levels with cut rooms."""
    top = room.level.top
    if top not in tops:
        return f"{error.message} Nothing is cut below Z{top:g}."
    if room.above is not None:
        return f"{error.message} Below Z{top:g} that part stays uncut."
    return f"{error.message} That part stays uncut."


def _curves(cuts: Sequence[Cut], request: PocketRequest) -> tuple[SplineCurve, ...]:
    """Return the exact curve of each path, at the lowest level that it cuts."""
    side = -1 if request.cutting.cut_mode is CutMode.CONVENTIONAL else 1
    curves: dict[FloorPath, SplineCurve] = {}
    for cut in cuts:
        curve = cut.path.curve
        if curve is not None:
            points = curve.control_points * (side, 1)
            height = cut.room.level.bottom
            curves[cut.path] = replace(curve, control_points=points, height=height)
    return tuple(curves.values())
