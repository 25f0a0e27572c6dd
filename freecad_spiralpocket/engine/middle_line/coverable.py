# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which piece of the medial axis is the best center of a spiral [EAS07, section 3].

FindingMaximalCoverableArea: the axis with its clearance as height is sliced at the
offsets that laps of even spacing reach. Of each slice that is left above, the longest
path of every connected part is a candidate; a spiral about it may unwind to the height
of the slice without touching a wall. The one that covers most is taken, what its spiral
covers is marked on the axis, which is never computed again, and so on.

The paper measures z * length. Here it is ``2 z length + pi z^2``, the area within z of
the piece: a point then counts for its disc, and a square gets one spiral about its
middle instead of one along a diagonal.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d
from shapely import LineString, Point, Polygon

from ..model import Floats
from ..shapes.points import distances_along
from ..shapes.polyline import points_at
from ..shapes.region import polygons_of
from ..shapes.skeleton import Skeleton, longest_route

#: Centers are smoothed over these lengths, over R: the first that costs no lap, and where there is
#: room for none, no distance to the walls. Laps on the inside of a bend have a kink where it is
#: tighter than their distance.
SMOOTHINGS = (6.0, 4.0, 2.5, 1.5, 1.0, 0.6, 0.3, 0.0)
#: A center shorter than this, over R, is a point.
POINT = 1.0
#: A piece that covers less than this share of the region, or takes fewer laps, is left to what
#: follows the spirals. So is a corner that covers less than the second share: laps about its foot
#: and the ways to them take longer than strokes across it.
LEAST_SHARE, CORNER_SHARE, FEWEST = 0.06, 0.18, 3
#: A channel is longer than this over its greatest half width; it is worth opening without laps.
SLIM = 2.0
#: Centers keep off each other by this, over R, so that what is opened about them does not merge.
APART = 3.2
#: Slices below the first lap, over the half width of the opened center: narrow channels, the last
#: hardly wider than the cutter.
NARROW = (0.005, 0.15, 0.5, 0.9)
#: A path that closes to a ring is made shorter by this share of the distance at a time.
SHORTER = 0.25
#: Between walls that are nearer to it than this the axis zigzags; nodes that matter less than the
#: clearance, and than the second, are left out there [mm].
ZIGZAG, STRAIGHT = 0.3, 0.02
#: Points of a center are this far apart [mm].
SPACING = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Center:
    """A curve or a point about which a spiral runs.

    Attributes
    ----------
    curve : shapely.LineString or shapely.Point
    laps : int
        So many fit between its opening and the walls.
    nodes : ndarray of int
        Of the axis along it.
    """

    curve: LineString | Point
    laps: int
    nodes: NDArray[np.intp]


def maximal_centers(
    region: Polygon, axis: Skeleton, half_width: float, stepover: float, radius: float
) -> list[Center]:
    """Return the centers of spirals, each time the one that covers most of what is left.

    Parameters
    ----------
    region : shapely.Polygon
        The cutter-center region.
    axis : Skeleton
        Its medial axis.
    half_width : float
        The centers are opened this wide to both sides [mm].
    stepover : float
        b, the spacing of laps [mm].
    radius : float
        R [mm].
    """
    centers: list[Center] = []
    if len(axis.nodes) == 0:  # hardly wider than the cutter
        return centers
    # a node is in slices below this only
    below = np.full(len(axis.nodes), np.inf)
    points = shapely.points(axis.nodes)
    rest, wall = shapely.simplify(region, 0.1), region.boundary
    shapely.prepare(wall)
    offsets = _offsets(axis, half_width, stepover)
    while (below > 0).any():
        found = _maximal(axis, below, offsets)
        if found is None:
            break
        nodes, offset = found
        nodes = _without_loop(axis, nodes, offset + radius)
        center = _center(wall, axis, nodes, half_width, stepover, radius)
        reach = max(half_width + center.laps * stepover, offset, APART * radius)
        shape = shapely.intersection(shapely.buffer(center.curve, reach, quad_segs=8), rest)
        share = shape.area / region.area
        is_worth_it = not centers or _is_worth_it(axis, center, share, below > 0)
        if below[nodes].min() < np.inf:
            is_worth_it = _joins_rooms(axis.clearance[nodes], half_width)
        if is_worth_it:
            centers.append(center)
            rest = shapely.difference(rest, shape)
        # rooms that are worth no spiral may lie along a channel
        lowered = 0.0 if is_worth_it or offset < half_width else half_width
        shapely.prepare(center.curve)
        near = np.flatnonzero(below > lowered)
        near = near[shapely.dwithin(center.curve, points[near], reach)]
        below[near[~_are_behind_walls(axis, near, nodes, center.curve, reach, wall)]] = lowered
        below[nodes] = np.minimum(below[nodes], lowered)
    return centers


def _are_behind_walls(
    axis: Skeleton,
    near: NDArray[np.intp],
    nodes: NDArray[np.intp],
    curve: LineString | Point,
    reach: float,
    wall: shapely.Geometry,
) -> NDArray[np.bool_]:
    """Return which of the nodes `near` a center are in another channel.

    Straight on a wall is between, and along the axis they are out of `reach` [mm] of the `nodes`
    of the center.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    behind = shapely.intersects(
        wall, shapely.shortest_line(curve, shapely.points(axis.nodes[near]))
    )
    if not behind.any():
        return behind
    lengths = np.maximum(axis.lengths, 1e-9)
    graph = coo_array((lengths, tuple(axis.edges.T)), shape=(len(axis.nodes),) * 2).tocsr()
    ways = dijkstra(graph, directed=False, indices=nodes, min_only=True, limit=reach)
    return behind & (ways[near] > reach)


def _offsets(axis: Skeleton, half_width: float, stepover: float) -> Floats:
    """Return the heights of the slices, highest first [mm]."""
    most = float(axis.clearance.max())
    laps = np.arange(int(max(0.0, most - half_width) / stepover + 1e-9), -1, -1)
    offsets = np.concatenate([half_width + laps * stepover, half_width * np.array(NARROW[::-1])])
    below = offsets[offsets < most]
    return below if len(below) else np.array([0.5 * most])


def _maximal(
    axis: Skeleton, below: Floats, offsets: Floats
) -> tuple[NDArray[np.intp], float] | None:
    """Return the nodes along the piece that covers most, and the height of its slice.

    A node is in slices only that are lower than its entry in `below` [mm].
    """
    best, most = None, 0.0
    steps = axis.lengths
    for offset in offsets:
        disc = np.pi * offset**2
        mask = (below > offset) & (axis.clearance >= offset)
        above = mask[axis.edges].all(axis=1)
        if not mask.any() or 2 * offset * steps[above].sum() + disc <= most:
            continue
        edges = axis.edges[above]
        label, totals = _parts(len(mask), edges, steps[above])
        # no path in a part is longer than all of it
        bounds = np.where(np.bincount(label, mask) > 0, 2 * offset * totals + disc, 0.0)
        for part in np.argsort(-bounds, kind="stable").tolist():
            if bounds[part] <= most:
                break
            own = edges[label[edges[:, 0]] == part]
            path = longest_route(axis, own)
            if len(path) == 0:
                path = np.flatnonzero(mask & (label == part))[:1]
            area = 2 * offset * _length(axis.nodes[path]) + disc
            if area > most:
                best, most = (path, float(offset)), area
    return best


def _parts(n: int, edges: NDArray[np.intp], steps: Floats) -> tuple[NDArray[np.int32], Floats]:
    """Return in which connected part each node is, and the length of each part [mm]."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    graph = coo_array((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), shape=(n, n))
    _, label = connected_components(graph.tocsr(), directed=False)
    totals = np.bincount(label[edges[:, 0]], steps, minlength=int(label.max()) + 1)
    return label, totals.astype(float)


def _without_loop(axis: Skeleton, nodes: NDArray[np.intp], distance: float) -> NDArray[np.intp]:
    """Return the beginning of a path that is no ring round an island, so wide on both sides."""
    along = distances_along(axis.nodes[nodes])
    length = along[-1]
    while len(nodes) > 1:
        shape = shapely.buffer(along_axis(axis, nodes), distance, quad_segs=4)
        # a buffer may shed a sliver
        if not polygons_of(shape)[0].interiors:
            break
        length -= SHORTER * distance
        nodes = nodes[: max(1, int(np.searchsorted(along, length)))]
    return nodes


def _center(
    wall: shapely.Geometry,
    axis: Skeleton,
    nodes: NDArray[np.intp],
    half_width: float,
    stepover: float,
    radius: float,
) -> Center:
    """Return the center along nodes, as smooth as it can be without costing a lap.

    Whether a prepared `wall` is near is told in a tenth of the time of measuring how near it is.
    """

    def is_off(curve: LineString | Point, distance: float) -> bool:
        return not shapely.dwithin(wall, curve, distance - 1e-6 * stepover)

    def laps_about(curve: LineString | Point, least: int = 0) -> int:
        laps = least
        while is_off(curve, half_width + (laps + 1) * stepover):
            laps += 1
        return laps

    widest = nodes[int(np.argmax(axis.clearance[nodes]))]
    if _length(axis.nodes[nodes]) < POINT * radius:
        place = Point(axis.nodes[widest])
        return Center(place, laps_about(place), nodes)
    raw = along_axis(axis, nodes)
    laps = laps_about(raw)
    kept = half_width + laps * stepover
    if laps == 0 and not is_off(raw, half_width):
        # it keeps in the middle of channels: what its slot leaves there takes strokes
        kept = float(shapely.distance(wall, raw))
    for smoothing in SMOOTHINGS:
        curve = _smoothed(raw, smoothing * radius)
        if is_off(curve, kept):
            break
    return Center(curve, laps_about(curve, laps), nodes)


def along_axis(axis: Skeleton, nodes: NDArray[np.intp]) -> LineString:
    """Return the line along nodes of the axis."""
    line, narrowest = LineString(axis.nodes[nodes]), float(axis.clearance[nodes].min())
    return line if narrowest > ZIGZAG else shapely.simplify(line, min(STRAIGHT, narrowest))


def _smoothed(raw: LineString, width: float) -> LineString:
    """Return a line smoothed over `width` [mm], its ends where they are."""
    if width == 0:
        return raw
    count = max(4, int(raw.length / SPACING))
    points = points_at(raw, np.linspace(0.0, raw.length, count))
    # mirrored at its ends, it goes straight on there
    before, after = 2 * points[0] - points[:0:-1], 2 * points[-1] - points[-2::-1]
    sigma = width * count / raw.length
    smooth = gaussian_filter1d(np.vstack([before, points, after]), sigma, axis=0, mode="nearest")
    return LineString(smooth[count - 1 : 2 * count - 1])


def _is_worth_it(axis: Skeleton, center: Center, share: float, left: NDArray[np.bool_]) -> bool:
    """Return whether a piece is worth a spiral or an opening: neither corner nor margin.

    `share` is what it covers of the region, `left` are the nodes that are not covered.
    """
    length = _length(axis.nodes[center.nodes])
    if length > SLIM * float(axis.clearance[center.nodes].max()):
        return True
    least = LEAST_SHARE if _is_room(axis, center.nodes, left) else CORNER_SHARE
    return center.laps >= FEWEST and share > least


def _is_room(axis: Skeleton, nodes: NDArray[np.intp], left: NDArray[np.bool_]) -> bool:
    """Return whether a piece of the axis is widest inside; a corner is so where it is cut off.

    `left` are the nodes that are not covered.
    """
    widest = nodes[int(np.argmax(axis.clearance[nodes]))]
    wide = axis.clearance >= axis.clearance[widest]
    edges = axis.edges[wide[axis.edges].all(axis=1)]
    label, _ = _parts(len(wide), edges, np.ones(len(edges)))
    return bool(left[label == label[widest]].all())


def _joins_rooms(clearance: Floats, wide: float) -> bool:
    """Return whether a path, by its clearance, leads from a room through a neck to another [mm].

    Rooms have the clearance `wide`, necks have less.
    """
    rooms = np.flatnonzero(clearance >= wide)
    return len(rooms) > 0 and bool((clearance[rooms[0] : rooms[-1]] < wide).any())


def _length(points: Floats) -> float:
    return float(np.hypot(*np.diff(points, axis=0).T).sum())
