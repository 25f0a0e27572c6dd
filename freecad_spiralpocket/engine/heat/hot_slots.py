# SPDX-License-Identifier: LGPL-2.1-or-later
"""The slot that is kept hot: along a pocket's ridges, from room to room and round islands.

A plate that is heated evenly has a summit in each room. Towards a summit laps creep along the
ridge by a step-over each, every summit takes an entry of its own, and beside the saddles
between them laps have tips. So the ridges, the medial axis without its forks into corners,
are opened by one slot in shallow levels, and that is kept hot: isotherms are then nested all
the way from the slot to the walls.

A small room beside a large one counts as a corner; where no laps lead to such a slot, it goes on
to the middle of every room, which is whatever rises again behind a neck.

A ridge that is closed round an island is parted where it is narrowest; laps close there.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise, product

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from ..floor import Slot
from ..model import PocketRequest
from ..numerics.graphs import root_of, shortest_paths, spanning_tree
from ..opening.branches import smoothed
from ..opening.starts import leaves_no_post, slot_round
from ..shapes.shaping import grow_coarsely, largest, oriented
from ..shapes.skeleton import Edges, Skeleton, neighbors_of, peel, spurs_of

#: Half the width of the slot over D: the first is taken that leaves no post.
HALF_WIDTHS = (0.46, 0.38, 0.3, 0.22)
#: Its reentrant curves over R: they cost a slim one, or leave a post where ridges cross.
BENDS = (1.0, 0.5, 0.25)
#: It misses no place along a ridge by more than this over R: else it broke off.
MISSED = 1.5
#: Tips are peeled while the walls that they serve are nearer than this over the largest clearance;
#: branches shorter than this over the clearance at their foot are left out: forks into corners.
PEELED, SPUR = 1.0, 1.6
#: A room is wider than the neck before it by this, and than the slot: over R.
NECK, ROOM = 0.9, 1.0
#: Width of the smoothing along ridges, and the shortest of them, over R.
SMOOTHING, SHORTEST = 1.0, 1.0
#: Where a ridge round an island is parted the ends of the slot are so far apart over the step-over,
#: or over R where rounding would join them.
PARTED, ROUNDED = 1.2, 1.0
#: The slot keeps off walls by one of these over the step-over: the first with which it is nowhere
#: narrower than the last. In a hairline no grid has nodes, and laps would part it.
OFFS, HAIRLINE = (0.3, 0.2, 0.1), 0.1
#: Its corners are rounded by these over R, the first that costs nothing.
ROUNDINGS = (0.5, 0.25, 0.1)


def hot_slot(
    region: Polygon, axis: Skeleton, request: PocketRequest, *, all_rooms: bool = False
) -> Polygon | None:
    """Return the region that a slot along its outline opens; None if there is no ridge for it.

    Parameters
    ----------
    region : shapely.Polygon
        The cutter-center region.
    axis : Skeleton
        Its medial axis.
    request : PocketRequest
    all_rooms : bool, optional
        Whether it goes on to small rooms beside large ones.
    """
    if not region.interiors and axis.clearance.max(initial=0.0) < request.cutter_radius:
        return None  # once round such a narrow region all of it is cut
    stepover = request.cutting.stepover
    branches = peel(axis, PEELED)
    ridges = _without_forks(axis, branches)
    if all_rooms:
        middles = _rooms(axis, request.cutter_radius)
        is_long = _length(axis, ridges) >= SHORTEST * request.cutter_radius
        ridges = _to_rooms(axis, branches, middles) if is_long or len(middles) > 1 else []
    best, fewest = None, np.inf
    for off in OFFS:
        for slot, missed in _slots_off(off * stepover, region, axis, ridges, request):
            core = grow_coarsely(slot, -HAIRLINE / 2 * stepover)
            if missed == 0 and isinstance(core, Polygon) and not core.is_empty:
                return slot
            if missed < fewest:
                best, fewest = slot, missed
            if missed == 0:
                break
    return best


def _slots_off(
    off: float, region: Polygon, axis: Skeleton, ridges: Edges, request: PocketRequest
) -> Iterator[tuple[Polygon, int]]:
    """Yield what slots along ridges open that keep off walls by so much [mm], the widest first.

    Each with how many nodes of the ridges it misses.
    """
    places = shapely.points(axis.nodes[np.unique(np.array(ridges, np.intp))])
    radius, stepover = request.cutter_radius, request.cutting.stepover
    inner = grow_coarsely(region, -off)
    for gap, half in product((PARTED * stepover, ROUNDED * radius), HALF_WIDTHS):
        wide = half * request.tool_diameter
        edges = _parted(axis, ridges, 2 * wide + gap)
        if not edges or inner.is_empty:
            return
        pieces = shapely.multilinestrings([axis.nodes[list(edge)] for edge in edges])
        branches = [
            LineString(smoothed(line, SMOOTHING * radius))
            for line in shapely.get_parts(shapely.line_merge(pieces))
        ]
        if sum(branch.length for branch in branches) < SHORTEST * radius:
            return
        shape = shapely.union_all([grow_coarsely(branch, wide) for branch in branches])
        clipped = largest(shapely.intersection(shape, inner))
        breaks = not shapely.dwithin(clipped, places, MISSED * radius).all()
        for rounding in BENDS:
            start = slot_round(inner, shape, request, (rounding,))
            if start is None or not isinstance(start.entry, Slot) or start.visited.interiors:
                continue
            slot = _smoothed(Polygon(start.entry.ring), grow_coarsely(inner, off / 2), request)
            yield slot, int((~shapely.dwithin(slot, places, MISSED * radius)).sum())
            if breaks:
                return  # at a channel, as all others that keep off so much


def _smoothed(slot: Polygon, fence: Polygon, request: PocketRequest) -> Polygon:
    """Return a slot with its corners rounded, as far as it keeps in one piece and in a fence."""
    for share in ROUNDINGS:
        q = share * request.cutter_radius
        shape = grow_coarsely(grow_coarsely(grow_coarsely(slot, q), -2 * q), q)
        if not isinstance(shape, Polygon) or shape.interiors or not fence.covers(shape):
            continue
        if grow_coarsely(shape, q).covers(slot) and leaves_no_post(shape, request):
            return oriented(shape)
    return oriented(slot)


def _length(axis: Skeleton, edges: Edges) -> float:
    """Return the length of edges [mm]."""
    ends = axis.nodes[np.array(edges, np.intp).reshape(-1, 2)]
    return float(np.hypot(*(ends[:, 0] - ends[:, 1]).T).sum())


def _to_rooms(axis: Skeleton, edges: Edges, middles: list[int]) -> Edges:
    """Return edges with the shortest ways to the middles of rooms; if none, between these."""
    kept, reached = {frozenset(edge) for edge in edges}, {node for edge in edges for node in edge}
    if not reached:
        reached.update(middles[:1])
    for middle in middles:
        away, before = shortest_paths(axis.edges, axis.lengths, middle)
        node = min(reached, key=lambda other: float(away[other]))
        way = [node]
        while before[way[-1]] >= 0:
            way.append(int(before[way[-1]]))
        kept.update(frozenset(edge) for edge in pairwise(way))
        reached.update(way)
    return sorted((min(edge), max(edge)) for edge in kept)


def _rooms(axis: Skeleton, radius: float) -> list[int]:
    """Return the widest node of each room that a neck parts from wider ones, the widest first."""
    neighbors = neighbors_of(axis.edges.tolist())
    peak: dict[int, int] = {}  # of each node that is as wide as any looked at so far
    rooms = []
    for node in np.argsort(-axis.clearance, kind="stable").tolist():
        peak[node] = node
        peaks = {root_of(peak, other) for other in neighbors.get(node, ()) if other in peak}
        widest = max(peaks, key=lambda p: (axis.clearance[p], -p), default=node)
        for other in (node, *peaks):
            peak[other] = widest
        narrow = axis.clearance[node] / NECK
        rooms += [p for p in peaks - {widest} if axis.clearance[p] > max(narrow, ROOM * radius)]
    rooms += [node for node in peak if peak[node] == node]
    return sorted(rooms, key=lambda p: (-axis.clearance[p], p))


def _without_forks(axis: Skeleton, edges: Edges) -> Edges:
    """Return edges without the branches that are short beside the room at their foot."""
    while True:
        spurs = spurs_of(axis, neighbors_of(edges), SPUR)
        if not spurs:
            return edges
        # all of a fork at once: the last one left would be a hook
        gone = {frozenset(edge) for spur in spurs for edge in pairwise(spur)}
        edges = [edge for edge in edges if frozenset(edge) not in gone]


def _parted(axis: Skeleton, edges: Edges, apart: float) -> Edges:
    """Return edges with the loops among them parted over so much [mm]."""
    pairs: NDArray[np.intp] = np.array(edges, np.intp).reshape(-1, 2)
    narrow = axis.clearance[pairs].min(axis=1)
    tree = spanning_tree(len(axis.nodes), pairs, -narrow).tolist()
    neighbors, kept = neighbors_of(tree), {frozenset(edge) for edge in tree}
    for edge in edges:
        if frozenset(edge) in kept:
            continue
        for tip in edge:
            left = (apart - float(np.hypot(*(axis.nodes[edge[0]] - axis.nodes[edge[1]])))) / 2
            while left > 0 and len(neighbors[tip]) == 1:
                (inner,) = neighbors[tip]
                left -= float(np.hypot(*(axis.nodes[tip] - axis.nodes[inner])))
                neighbors[tip].discard(inner)
                neighbors[inner].discard(tip)
                tip = inner
    return [(a, b) for a, near in neighbors.items() for b in near if a < b]
