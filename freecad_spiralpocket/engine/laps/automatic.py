# SPDX-License-Identifier: LGPL-2.1-or-later
"""Automatic: engagement-limited fronts from the start that simulates fastest.

For each way to open the region (starts.py) fronts grow to the walls (fronts.py);
their new parts are strokes (strokes.py), closed laps among them one spiral
(spiral.py); an order and smooth links through free ground join all (ordering.py).
The way that takes least time on the machine is chosen: simulated, never by rule.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, partial

import numpy as np
import shapely
from shapely import LineString, Polygon

from ..errors import CutterDoesNotFitError
from ..floor import FloorPath, Groove, Pass, Plunge, WayDown
from ..growth.corners import finish_corners, levels_from
from ..growth.front_rules import WIDEST, FrontRules, rules_of
from ..growth.fronts import MAX_FRONTS, without_idle_holes
from ..growth.lap_width import STRETCH
from ..growth.stroke_runs import Run, runs_of
from ..growth.strokes import Stroke, strokes_between, strokes_of
from ..growth.too_wide import too_wide
from ..links.cleared import ClearedMap, pixel_of
from ..links.estimates import (
    LIFT_SECONDS,
    entry_seconds,
    least_seconds,
    link_seconds,
    motion_of,
    seconds_of,
)
from ..links.linking import Motion
from ..links.ordering import Situation, Step, order
from ..links.passes import passes_of
from ..links.sequence import in_better_sequence
from ..model import PocketRequest, Tick
from ..opening.leftovers import is_left, large_pieces, without
from ..opening.mouths import cusps_at, mouths_of
from ..opening.open_sides import needed, starts_of, strokes_in_stock, strokes_within
from ..opening.promising import FEW, promising
from ..opening.slot_ends import well_ended
from ..opening.start import Start
from ..opening.starts import candidates
from ..shapes.points import unit
from ..shapes.polyline import between
from ..shapes.shaping import grow_coarsely, largest, slim_region, thick_parts

#: A start is given up that needs more levels than the first over the best, and than the second:
#: `FEW` step-overs are always worth simulating, and take some levels more, those of corners.
HOPELESS_LEVELS, FEW_LEVELS = 1.8, FEW + 6
#: What a front leaves takes longer by this than the least: in 28 starts beside the first of their
#: pockets, wherever these were grown to their end, it was never below 1.4.
LIKELY = 1.3
#: No corner takes so many levels at a step-over of so much over R, or the more the smaller that is;
#: what does is a channel hardly wider than the cutter, where strokes cannot hold the engagement. A
#: start that leaves one is taken if it is faster by this.
CORNER_LEVELS, CORNER_STEPOVER, CHANNEL_TOLL = 8, 0.8, 1.2
#: Of two starts that with more links is taken only if it is faster by this share: where a stroke
#: leaves a wall the engagement jumps, and links wear the machine. With more than so many times as
#: many, a few apart, it must be faster by this twice over.
TIE, MANY_TIMES, FEW_LINKS = 0.06, 3, 4
#: A slot without stairs spares at most the time of so many links, and this share of that of all: it
#: is not grown where stairs save more than that.
SPARED, SPARED_SHARE = 0.9, 0.3
#: The order of so many runs is searched for.
WORTH_A_SEARCH = 4


def floor_path(region: Polygon, request: PocketRequest, tick: Tick) -> FloorPath:
    """Make the path of one cutter-center region.

    Parameters
    ----------
    region : shapely.Polygon
        Counter-clockwise.
    request : PocketRequest
    tick : callable
        See `model.Tick`.

    Raises
    ------
    CutterDoesNotFitError
        If there is no room to go down.
    """
    region = slim_region(region)
    best = _fastest(starts_of(region, request), needed(region, request), request, tick)
    pieces = [] if request.stock is None else large_pieces(region, request)
    return _joined(_piecewise(best, pieces, region, request, tick), region, request)


def _piecewise(
    best: _Best, pieces: Sequence[Polygon], region: Polygon, request: PocketRequest, tick: Tick
) -> list[_Best]:
    """Return the pieces that are faster cut on their own, and what takes the rest after them."""
    motion, after = motion_of(request), request
    from_air = best.start is not None and isinstance(best.start.entry, Plunge)
    alone: list[_Best] = []
    for inner in pieces:
        try:
            starts = [(start, inner) for start in candidates(inner, request)]
        except CutterDoesNotFitError:
            continue
        piece = _fastest(starts, inner, request, tick)
        if from_air:
            here = grow_coarsely(inner, request.cutting.stepover)
            peeled = [s for s in best.steps if here.contains(LineString(s.points).centroid)]
            # in a channel strokes cannot hold the engagement
            toll = CHANNEL_TOLL if _is_channel(len(peeled), rules_of(request)) else 1.0
            if piece.seconds + LIFT_SECONDS > toll * seconds_of(peeled, request, motion):
                continue
        alone.append(piece)
        after = without(after, inner)
    if not alone:
        return [best]
    if is_left(region, after):
        alone.append(_fastest(starts_of(region, after), needed(region, after), after, tick))
    total = sum(part.seconds for part in alone) + LIFT_SECONDS * (len(alone) - 1)
    return alone if total < (CHANNEL_TOLL if from_air else 1.0) * best.seconds else [best]


def _joined(parts: Sequence[_Best], region: Polygon, request: PocketRequest) -> FloorPath:
    """Return the path of some starts one after the other."""
    entries = [part.start.entry for part in parts if part.start is not None]
    passes: list[Pass | WayDown] = []
    for entry, part in zip(entries, parts, strict=True):
        passes += [entry, *passes_of(part.steps, region, request)]
    return FloorPath(entries[0], tuple(passes[1:]))


def _fastest(
    starts: list[tuple[Start, Polygon]], region: Polygon, request: PocketRequest, tick: Tick
) -> _Best:
    """Return the start that simulates fastest.

    Raises
    ------
    NotYetError
        If the region is too wide.
    """
    motion, rules = motion_of(request), rules_of(request)
    best, most = _Best(), MAX_FRONTS
    laps = region.area / (WIDEST * STRETCH * rules.stepover) / motion.cut_feed
    entry_of = cache(partial(entry_seconds, request=request, motion=motion))
    entries = [entry_of(start) / laps for start, _ in starts]
    starts = promising(starts, region, request.cutting.stepover, entries)
    for i, (start, within) in enumerate(starts):
        done = partial(tick, i / len(starts))
        entry = entry_of(start)
        grown = _grown(start, rules, best, most, entry, motion, done)
        if grown is None:
            continue
        fronts, corners = grown
        toll = CHANNEL_TOLL if _is_channel(corners, rules) else 1.0
        if start.within is not None:
            fronts = _with_corners(fronts, start.within, within, rules)
        most = min(most, max(int(HOPELESS_LEVELS * len(fronts)), FEW_LEVELS))
        strokes = strokes_in_stock(strokes_of(fronts), start.idle)
        # no links can make up for entry, cuts and turns back that take longer already
        at_least = entry + least_seconds(strokes, motion)
        if not best.is_beaten_by(toll * at_least, _open_strokes(strokes)):
            continue
        start = well_ended(start, strokes, request)
        laid = _laid(start, fronts, strokes, within, request, motion, done)
        seconds = entry + seconds_of(laid.all_steps, request, motion)
        links = sum(step.link is None or len(step.link) > 0 for step in laid.all_steps)
        if best.is_beaten_by(toll * seconds, links):
            best = _Best(start, laid, toll * seconds, links)
        if start.plain is not None and not start.is_sure and links > 0:
            more = entry_of(start.plain) - entry
            more += _least_left(start.plain.visited, start.plain, rules, motion)
            more -= _least_left(start.visited, start, rules, motion)
            spared = min(SPARED_SHARE, SPARED / links) * link_seconds(laid.all_steps, motion)
            if toll * (seconds + more - spared) < best.seconds:
                starts.append((start.plain, within))
    if best.start is None:
        raise too_wide()
    return _in_better_order(best, motion, partial(tick, 1.0))


def _in_better_order(best: _Best, motion: Motion, tick: Callable[[], None]) -> _Best:
    """Return the runs of a start in the sequence that is found by search, if that takes less.

    Where the cutter still lifts, runs may be begun by their spare ways.
    """
    laid = best.laid
    if laid.situation is None:
        return best
    steps = _searched(laid.steps, laid.runs, laid.situation, tick)
    if _lifts(steps):
        situation = replace(laid.situation, takes_spares=True)
        other: Sequence[Step] = order(laid.runs, situation, tick)
        # where spare ways spare no lift the search finds the same again
        if _lifts(other) < _lifts(laid.steps):
            other = _searched(other, laid.runs, situation, tick)
        steps = min(steps, other, key=lambda steps: link_seconds(steps, motion))
    saved = link_seconds(laid.steps, motion) - link_seconds(steps, motion)
    return replace(best, laid=replace(laid, steps=steps), seconds=best.seconds - saved)


def _lifts(steps: Sequence[Step]) -> int:
    """Return before how many steps the cutter lifts."""
    return sum(step.link is None for step in steps)


def _searched(
    steps: Sequence[Step], runs: Sequence[Run], situation: Situation, tick: Callable[[], None]
) -> Sequence[Step]:
    """Return steps in the sequence that is found by search, if these are enough for one."""
    if len(steps) < WORTH_A_SEARCH:
        return steps
    return in_better_sequence(steps, runs, situation, tick)


def _is_channel(levels: int, rules: FrontRules) -> bool:
    """Return whether so many levels are more than a corner takes."""
    return levels > CORNER_LEVELS * max(1.0, CORNER_STEPOVER * rules.cutter_radius / rules.stepover)


@dataclass(frozen=True, slots=True, eq=False)
class _Laid:
    """What follows a start: the rest of its entry, then its runs as steps; none in no situation."""

    opening: Sequence[Step] = ()
    steps: Sequence[Step] = ()
    runs: Sequence[Run] = ()
    situation: Situation | None = None

    @property
    def all_steps(self) -> list[Step]:
        """Return all steps."""
        return [*self.opening, *self.steps]


@dataclass(frozen=True, slots=True)
class _Best:
    """The fastest start so far, what follows it, and how long all takes [s]."""

    start: Start | None = None
    laid: _Laid = field(default_factory=_Laid)
    seconds: float = math.inf
    links: int = 0

    @property
    def steps(self) -> list[Step]:
        """Return what follows the entry."""
        return self.laid.all_steps

    def is_beaten_by(self, seconds: float, links: int) -> bool:
        """Return whether a start is better that takes so long, with so many links."""
        more = _more_links(links, self.links) - _more_links(self.links, links)
        return seconds < (1 - TIE) ** more * self.seconds


def _grown(
    start: Start,
    rules: FrontRules,
    best: _Best,
    most: int,
    entry: float,
    motion: Motion,
    tick: Callable[[], None],
) -> tuple[list[Polygon], int] | None:
    """Return the fronts of a start, and how many of them only finish corners.

    None once it cannot be the best. `entry` is how long its way down takes [s], `most` the number
    of fronts beyond which there is no hope.
    """
    fronts: list[Polygon] = []
    strokes: list[Stroke] = []
    corners = 0
    levels = levels_from(start.visited, start.omega, rules, start.idle, start.fronts)
    for front, is_corner in levels:
        tick()
        fronts.append(front)
        corners += is_corner
        if len(fronts) > most + 1:
            return None
        if best.start is not None:
            if len(fronts) > 1:
                more = strokes_between(fronts[-2], front, len(fronts) - 1)
                strokes += strokes_in_stock(more, start.idle)
            likely = entry + least_seconds(strokes, motion)
            likely += LIKELY * _least_left(front, start, rules, motion)
            if not best.is_beaten_by(likely, _open_strokes(strokes)):
                return None
    return fronts, corners


def _least_left(front: Polygon, start: Start, rules: FrontRules, motion: Motion) -> float:
    """Return how long it takes at least to cut what a front of a start leaves [s]."""
    # narrow holes need no stroke: the cutter reaches over them
    idle = rules.cutter_radius * sum(ring.length for ring in front.interiors)
    idle += sum(ground.area for ground in start.idle if not front.contains(ground))
    widest = WIDEST * STRETCH * rules.stepover
    return float(max(0.0, start.omega.area - front.area - idle) / widest / motion.cut_feed)


def _more_links(links: int, others: int) -> int:
    """Return whether a start has more links than another: 1, or 2 if by far."""
    return (links > others) + (links > MANY_TIMES * max(others, FEW_LINKS))


def _open_strokes(strokes: Sequence[Stroke]) -> int:
    return sum(not stroke.closed for stroke in strokes)


def _with_corners(
    fronts: list[Polygon], within: Polygon, region: Polygon, rules: FrontRules
) -> list[Polygon]:
    """Return fronts that reach beyond the wall, without the corners that a slot along it leaves.

    What follows takes these.
    """
    corners = thick_parts(shapely.difference(region, within))
    if len(corners) == 0:
        return fronts
    outside = shapely.union_all(corners)
    fronts = [largest(shapely.difference(front, outside)) for front in fronts]
    inside = largest(shapely.intersection(fronts[-1], within))
    return [*fronts, inside, *finish_corners(inside, region, rules)]


def _laid(
    start: Start,
    fronts: list[Polygon],
    strokes: list[Stroke],
    region: Polygon,
    request: PocketRequest,
    motion: Motion,
    tick: Callable[[], None],
) -> _Laid:
    """Return the cutting runs and links that follow an entry, the nearest run first each time."""
    radius = request.cutter_radius
    if isinstance(start.entry, Plunge):
        strokes = strokes_within(strokes, region)
    mouths = mouths_of(start, region, radius)
    strokes = strokes + [Stroke(m, len(fronts), False, False) for m in mouths]
    opening = _rest_of_entry(start, strokes)
    if not strokes:
        return _Laid(opening)
    # about a plug's rounded corner the next lap is farther away than R
    reach = radius if start.within is None else 2 * radius
    slot, opened = start.ring, fronts[0]
    if start.plain is not None:
        slot = start.plain.ring
        opened = without_idle_holes(start.plain.visited, start.omega, rules_of(request))
    pixel, grown = pixel_of(request), [opened, *fronts[1:]]
    cusps = cusps_at(mouths, radius)
    cleared = ClearedMap(grown, strokes, region, cusps, reach, pixel, slot, start.ring)
    runs = runs_of(strokes, fronts, start.ring, radius, request.cutting.stepover)
    if opening:
        before, here = opening[-1].points[-2:]
        ahead = here - before
    else:
        here, following = shapely.get_coordinates(start.ring)[:2]
        ahead = following - here
    situation = Situation(cleared, region, here, unit(ahead), motion, radius)
    return _Laid(opening, order(runs, situation, tick), runs, situation)


def _rest_of_entry(start: Start, strokes: list[Stroke]) -> list[Step]:
    """Return what a groove's ways leave of it, where no first lap goes round the groove anyway.

    Its way forth stands a level above its way back.
    """
    entry = start.entry
    if not isinstance(entry, Groove):
        return []
    if any(s.level == 1 and s.closed and s.exterior for s in strokes):
        return []
    ring = start.ring
    end = entry.tips[0] if len(entry.tips) == 1 else ring.length
    return [Step(np.empty((0, 2)), between(ring, 0.0, end), -1)]
