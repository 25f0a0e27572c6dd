# SPDX-License-Identifier: LGPL-2.1-or-later
"""From nested closed laps to one path, however they branch.

Laps are a tree: the wall is the outermost lap, and each lap lies about one or more inner
ones, down to the cores where the cutter goes in. A lap is the boundary of a region in
which everything is cut; about islands it has inner rings.

Rings that follow each other one to one are a chain, and a chain is one spiral (turns.py)
that ends with a closed lap: it begins where its core's entry ends, or, where laps join or
part, on a ring that is already cut, from which it goes over to its first ring in a short
zone. Chains are ordered and linked like any strokes (ordering.py).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from ..floor import FloorPath, Helix, Pass, Slot
from ..growth.spiral import BLEND, gaps, spiral_through, zone_length, zones
from ..growth.stroke_runs import Run
from ..growth.strokes import Stroke
from ..links.cleared import ClearedMap, pixel_of
from ..links.linking import Motion, come_to_wall, leave_wall
from ..links.ordering import Situation, Step, order
from ..links.passes import slim
from ..model import Floats, PocketRequest, Tick
from ..opening.leaving import straightest
from ..opening.slot import slot_end
from ..shapes.polyline import ring_from
from ..shapes.region import rings_of
from ..toolpath import Role
from .kinks import has_kink, reach_of_kinks, softened
from .turns import Match, Ring, match, turn

#: Points along a ring are so far apart [mm], partners are sought so far apart, over R.
SPACING, PARTNERS = 0.25, 0.3
#: A chain goes over to its first ring where that is no farther than this over the step-over.
WIDEST = 1.3
#: There both run side by side: in so many places, at no less than this share of the speed.
ALONG, SLOWEST = 9, 0.3
#: A lap that ends beside a kink, which could not be spread there, goes on by its reach so often.
ONWARD = 3
#: Spreading kinks moves no point farther than this over the step-over.
SOFT = 0.15
#: Rings keep within this where a chain goes over from one to another [mm].
OVER = 0.001

#: Moves points from one level of the laps to another: (points, level, to level) -> points.
Mover = Callable[[Floats, float, float], Floats]


@dataclass(frozen=True, slots=True, eq=False)
class Lap:
    """A closed lap.

    Attributes
    ----------
    region : shapely.Polygon
        Cut when the lap is done; exterior counter-clockwise, interiors clockwise.
    level : float
        What the family of laps measures, for `Mover`.
    inner : tuple of Lap
        The next laps inside; none for a core.
    entry : Helix, Slot or None
        How the cutter goes into a core; it goes once round the region's exterior.
    """

    region: Polygon
    level: float
    inner: tuple[Lap, ...] = ()
    entry: Helix | Slot | None = None


@dataclass(slots=True, eq=False)
class _Node:
    """A ring of a lap; `before` are the rings that it leans on, `follows` the one it goes on."""

    ring: Ring
    level: float
    lap: int
    exterior: bool
    wall: bool
    core: Helix | Slot | None = None
    before: list[_Node] = field(default_factory=list)
    follows: _Node | None = None


def path_through(
    wall: Lap, region: Polygon, request: PocketRequest, motion: Motion, move: Mover, tick: Tick
) -> FloorPath:
    """Return the path through all laps.

    Parameters
    ----------
    wall : Lap
        The outermost lap. Where a finishing lap is wanted it is that lap: walked as it is, not
        morphed to.
    region : shapely.Polygon
        The cutter-center region.
    request : PocketRequest
    motion : Motion
        What limits links.
    move : callable
        See `Mover`.
    tick : callable
        See `model.Tick`.
    """
    radius = request.cutter_radius
    laps = _inner_first(wall)
    nodes = _nodes(laps, request.cutting.finishing_lap)
    chains = _chains(nodes)
    walkers: list[_Walker] = []
    for done, chain in enumerate(chains):
        tick(0.6 + 0.2 * done / len(chains))
        asked = None if walkers else request.start_point
        walkers.append(_Walker(chain, move, region, request, asked))
    number = {node: i for i, node in enumerate(nodes)}
    home = {node: r for r, chain in enumerate(chains) for node in chain}
    runs = [
        Run(
            tuple(number[node] for node in chain),
            tuple(partial(walker.walk, way) for way in range(len(walker.starts))),
            walker.starts,
            walker.headings,
            frozenset({home[b] for node in chain for b in node.before} - {r}),
            is_late=True,  # it begins on a ring that is cut, and its last lap runs on
        )
        for r, (chain, walker) in enumerate(zip(chains, walkers, strict=True))
    ]
    strokes = [Stroke(n.ring.points[:-1], n.lap, True, n.exterior) for n in nodes]
    regions = [lap.region for lap in laps]
    cleared = ClearedMap(regions, strokes, region, [], radius, pixel_of(request))
    start, heading = walkers[0].starts[0], walkers[0].headings[0]
    situation = Situation(cleared, region, start, heading, motion, radius)
    steps = order(runs, situation, partial(tick, 0.9))
    passes = _passes(steps, walkers, region, request)
    entry, *rest = passes
    assert not isinstance(entry, Pass)  # the first run is the one where the first core ends
    return FloorPath(entry, tuple(rest))


def _inner_first(lap: Lap) -> list[Lap]:
    """Return a lap after all that are inside of it; the first is a core."""
    return [one for inner in lap.inner for one in _inner_first(inner)] + [lap]


def _nodes(laps: list[Lap], finishing: bool) -> list[_Node]:
    """Return the rings of all laps, laps inner first, each with what it leans on."""
    of_lap: dict[Lap, list[_Node]] = {}
    for i, lap in enumerate(laps):
        rings = rings_of(lap.region)
        wall = finishing and lap is laps[-1]
        of_lap[lap] = [
            _Node(
                Ring.of(np.asarray(r.coords)), lap.level, i, k == 0, wall, None if k else lap.entry
            )
            for k, r in enumerate(rings)
        ]
        if lap.entry is not None:  # the entry goes round the outer ring
            for inner in of_lap[lap][1:]:
                inner.before = of_lap[lap][:1]
    for lap in laps:
        _lean([of_lap[inner] for inner in lap.inner], of_lap[lap])
    return [node for lap in laps for node in of_lap[lap]]


def _lean(inner: list[list[_Node]], outer: list[_Node]) -> None:
    """Tell the rings of a lap what they lean on among those of the laps inside."""
    if not inner:
        return
    outer[0].before = [nodes[0] for nodes in inner]
    holes = [(hole, Polygon(hole.ring.points)) for nodes in inner for hole in nodes[1:]]
    about = []
    for node in outer[1:]:
        place = shapely.Point(node.ring.points[0])
        about.append(next((hole for hole, shape in holes if shape.contains(place)), None))
    for node, hole in zip(outer[1:], about, strict=True):
        node.before = outer[0].before if hole is None else [hole]
        if hole is not None and about.count(hole) == 1:
            node.follows = hole
    # a lap that closes about an island parts: its outer ring is not all of the ring before
    if len(inner) == 1 and None not in about:
        outer[0].follows = inner[0][0]


def _chains(nodes: list[_Node]) -> list[list[_Node]]:
    """Return the rings that follow each other one to one."""
    chains: list[list[_Node]] = []
    of: dict[_Node | None, list[_Node]] = {}
    for node in nodes:
        chain = of.get(node.follows, [])
        if not chain:
            chains.append(chain)
        chain.append(node)
        of[node] = chain
    return chains


class _Walker:
    """Walks one chain: a spiral through its rings, and a closed lap.

    Attributes
    ----------
    starts, headings : ndarray of shape (w, 2)
        Where the ways to walk it begin, and their directions.
    last : int
        Points of the closed lap at the end, once walked.
    """

    def __init__(
        self,
        chain: list[_Node],
        move: Mover,
        region: Polygon,
        request: PocketRequest,
        asked: tuple[float, float] | None = None,
    ) -> None:
        self.chain, self.region, self.request, self.last = chain, region, request, 0
        #: Where a core is to be opened, as near as it can be [mm].
        self.asked = asked
        #: The rings to morph through; a finishing lap is walked as it is.
        self.rings = [node.ring for node in chain if not node.wall] or [chain[0].ring]
        nodes = chain[: len(self.rings)]
        self.matches = [
            _match(a, b, move, PARTNERS * request.cutter_radius) for a, b in pairwise(nodes)
        ]
        self.sources = self._sources()
        places = [(ring.at(np.array([s, s + SPACING]))) for ring, s in self.sources]
        self.starts = np.array([p[0] for p in places])
        ahead = np.array([p[1] - p[0] for p in places])
        self.headings = ahead / np.hypot(*ahead.T)[:, None]

    @property
    def entry(self) -> Helix | Slot | None:
        """Return how the cutter goes in where the chain begins; None if it comes by a link."""
        first = self.chain[0]
        if first.core is None:
            return None
        if isinstance(first.core, Slot):
            ring = ring_from(first.ring.points[:-1], self.starts[0])
            return Slot(slim(ring, self.request)[:-1], first.core.bite)
        x, y = self.starts[0] - first.core.center
        return Helix(first.core.center, first.core.radius, math.atan2(y, x))

    def _sources(self) -> list[tuple[Ring, float]]:
        """Return the rings on which the walk may begin, and where."""
        radius, stepover = self.request.cutter_radius, self.request.cutting.stepover
        first = self.chain[0]
        if first.core is not None and self.asked is not None:
            if isinstance(first.core, Slot):
                return [(first.ring, slot_end(first.core, self.asked, self.request))]
            return [(first.ring, float(first.ring.line.project(shapely.Point(self.asked))))]
        if first.core is not None:
            place = straightest(self.rings[-1].line, BLEND * radius, radius)
            for matched in reversed(self.matches):
                place = float(matched.inwards(np.array(place)))
            return [(first.ring, place)]
        found = []
        for source in first.before:
            ring = source.ring
            if source.lap == first.lap:  # round a core with an island, the other way than about it
                ring = Ring.of(ring.points[::-1])
            lines = ring.line, first.ring.line
            at = zones(*lines, radius, WIDEST * stepover)
            beside = _side_by_side(ring, first.ring, at, radius)
            at = at[beside] if beside.any() else at
            off = gaps(*lines, at, zone_length(*lines, radius))
            found += [(float(g), ring, float(s)) for g, s in zip(off, at, strict=True)]
        # of laps inside, some are far from a ring about an island
        widest = max(WIDEST * stepover, min(off for off, _, _ in found))
        return [(ring, at) for off, ring, at in found if off <= widest]

    def walk(self, way: int) -> Floats:
        """Return the points of one way, shape (n, 2) [mm]."""
        source, place = self.sources[way]
        pieces = [source.at(np.array([place]))]
        if source is not self.rings[0]:
            lines = [shapely.simplify(ring.line, OVER) for ring in (source, self.rings[0])]
            over = spiral_through(lines[0], place, lines[1:], self.request.cutter_radius)
            pieces = [over]
            place = float(self.rings[0].locate(over[-1:])[0])
        for inner, outer, matched in zip(
            self.rings[:-1], self.rings[1:], self.matches, strict=True
        ):
            points, place = turn(inner, outer, matched, place, SPACING)
            pieces.append(points[1:])
        lap = self._closed_lap(place)
        if self.chain[-1].wall:
            lap = come_to_wall(lap, pieces[-1][-1], self.region, self.request.cutter_radius)
        self.last = len(lap)
        return np.vstack([*pieces, lap])

    def _closed_lap(self, place: float) -> Floats:
        """Return the lap that closes the chain, from a place on its last ring."""
        ring = self.rings[-1]
        if self.chain[-1].wall:
            wall = self.chain[-1].ring.points
            return ring_from(wall[:-1], ring.at(np.array([place]))[0])
        count = max(32, math.ceil(ring.length / SPACING))
        step, reach = ring.length / count, reach_of_kinks(self.request.cutter_radius)
        for onward in range(ONWARD + 1):
            end = count + math.ceil(onward * reach / step)
            lap = ring.at(place + np.arange(1.0, end + 1.0) * step)
            if not has_kink(lap[-math.ceil(reach / step) - 2 :]):
                break
        return lap


def _side_by_side(source: Ring, target: Ring, starts: Floats, radius: float) -> NDArray[np.bool_]:
    """Return whether two rings run side by side where one is left for the other at `starts`.

    Where laps part, a ring turns back at its tip and the next one goes on.
    """
    length = zone_length(source.line, target.line, radius)
    at = starts[:, None] + np.linspace(0.0, length, ALONG)
    onto = target.locate(source.at(at.ravel())).reshape(at.shape)
    ahead = np.diff(onto, axis=1)
    ahead = (ahead + target.length / 2) % target.length - target.length / 2
    step = length / (ALONG - 1)
    return np.asarray(((ahead > SLOWEST * step) & (ahead < step / SLOWEST)).all(axis=1))


def _match(inner: _Node, outer: _Node, move: Mover, spacing: float) -> Match:
    """Return the partners on two rings, along the way in which `move` goes."""
    count = max(48, math.ceil(outer.ring.length / spacing))
    places = np.arange(count) * outer.ring.length / count
    points = outer.ring.at(places)
    if not isinstance(inner.core, Helix):  # to a circle the nearest way is the radial one
        points = move(points, outer.level, inner.level)
    return match(inner.ring, outer.ring, places, points)


def _within(points: Floats, region: Polygon) -> Floats:
    """Return a path whose points outside of a region are moved onto its boundary.

    A lap may run a few hundredths of a millimeter into a corner that sticks out into the pocket.
    """
    outside = ~shapely.intersects_xy(region, points)
    if not outside.any():
        return points
    rim = region.boundary
    points = points.copy()
    points[outside] = shapely.get_coordinates(
        shapely.line_interpolate_point(
            rim, shapely.line_locate_point(rim, shapely.points(points[outside]))
        )
    )
    return points


def _passes(
    steps: list[Step], walkers: list[_Walker], region: Polygon, request: PocketRequest
) -> list[Pass | Helix | Slot]:
    """Return what is cut in order, with links, lifts and entries."""
    radius, soft = request.cutter_radius, SOFT * request.cutting.stepover
    passes: list[Pass | Helix | Slot] = []
    for step in steps:
        walker = walkers[step.run]
        entry = walker.entry
        if entry is not None:
            passes.append(entry)
        elif step.link is None:
            passes.append(Pass(step.points[:1], Role.AIR))
        else:
            passes.append(Pass(slim(step.link, request), Role.LINK))
        if not walker.chain[-1].wall:
            cut = _within(softened(step.points, radius, soft), region)
            passes.append(Pass(slim(cut, request), Role.CUT))
            continue
        spiral, lap = step.points[: -walker.last], step.points[-walker.last :]
        if len(spiral) > 1:
            spiral = _within(softened(spiral, radius, soft), region)
            passes.append(Pass(slim(spiral, request), Role.CUT))
        passes.append(Pass(slim(lap, request), Role.FINISH))
    leave = leave_wall(steps[-1].points, region, request.cutter_radius)
    return [*passes, Pass(leave, Role.LINK)]
