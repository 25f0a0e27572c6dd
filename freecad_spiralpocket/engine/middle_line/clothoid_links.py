# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links between spirals: rays, straight pieces, bi-clothoids at their corners [EAS07, section 4].

A clothoid unwinds from the curvature of the spiral that ends, to 0; its ray and
the ray backwards from the spiral that begins are joined by a bi-clothoid where they meet.
Where they meet outside of free ground, or not at all, a straight piece
between both rays makes two corners of one. So the curvature of the whole link is
continuous, both ends included, and piecewise linear in the arc length.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
import shapely
import shapely.ops
from shapely import LineString, Polygon

from ..links.cleared import ClearedMap
from ..links.ground import Ground
from ..links.linking import Motion, link_times
from ..model import Floats
from ..shapes.points import cross
from ..shapes.polyline import simplified
from .clothoids import ClothoidPath, begin, half_corner, tangent_share, through

#: Clothoids at both ends: length over R, and R times the curvature to which they tighten to the
#: left, away from the stock, before they unwind. The first with which a link fits is taken.
LEADS = ((1.0, 0.0), (0.5, 1.3), (0.35, 2.5))
#: Distances along the rays at which straight pieces begin and end, over R.
REACHES = (0.4, 1.0, 2.5, 6.0, 15.0)
#: Shares of the room at a corner that its bi-clothoid takes.
SHARES = (1.0, 0.4)
#: No corner turns farther than this [rad].
SHARPEST = 2.7
#: Points of each half corner and each straight piece when a link is timed and tested.
CORNER, STRAIGHT = 7, 16
#: Along a longer way: how much it is simplified, and how far rays run, over R.
WAY_SLACKS, WAY_REACHES = (0.5, 0.15), (0.3, 0.8, 2.0)
#: Corners with less room than this, over R, are not tried.
TIGHTEST = 0.1
#: So many of the fastest candidates are looked at closely.
TRIED = 30


@dataclass(frozen=True, slots=True, eq=False)
class Place:
    """Where a spiral begins or ends.

    Attributes
    ----------
    point : ndarray of shape (2,)
        [mm]
    heading, curvature : float
        [rad], [1/mm]
    """

    point: Floats
    heading: float
    curvature: float


def clothoid_link(
    start: Place,
    ends: Sequence[Place],
    cleared: ClearedMap,
    fence: Polygon,
    motion: Motion,
    radius: float,
    tolerance: float,
) -> tuple[ClothoidPath, int] | None:
    """Return the fastest link through free ground, and to which of `ends`; None if there is none.

    Parameters
    ----------
    start : Place
    ends : sequence of Place
        Where it may end.
    cleared : ClearedMap
    fence : shapely.Polygon
        No link leaves it.
    motion : Motion
    radius : float
        R [mm].
    tolerance : float
        Of the points when a link is tested [mm].
    """
    for lead in LEADS:
        out = _lead(start, lead, radius)
        backs = [_lead(_backwards(end), lead, radius, -1.0) for end in ends]
        tip = _tip(out)
        found = [_candidates(tip, _tip(back), radius) for back in backs]
        which = np.repeat(np.arange(len(ends)), [len(corners) for corners, _ in found])
        if len(which) == 0:
            continue
        corners, tangents = (np.concatenate(parts) for parts in zip(*found, strict=True))
        leads = [p.points_at(np.linspace(0.0, p.length, CORNER)) for p in (out, *backs)]
        paths = _sampled(leads[0], np.array(leads[1:])[which], corners, tangents)
        # what turns away from the stock begins on the very edge of free ground
        safe = CORNER - 1 if lead[1] > 0 else 0
        free = cleared.are_free(paths[:, safe : paths.shape[1] - safe])
        times = np.full(len(paths), np.inf)
        times[free] = link_times(paths[free], motion)
        for k in np.argsort(times, kind="stable")[: min(TRIED, int(free.sum()))].tolist():
            way = through(out, corners[k], tangents[k].tolist())
            path = way.then_back(backs[which[k]])
            if fence.covers(LineString(path.sampled(tolerance))):
                return path, int(which[k])
    return None


def clothoid_way(
    start: Place,
    end: Place,
    cleared: ClearedMap,
    fence: Polygon,
    radius: float,
    tolerance: float,
) -> ClothoidPath | None:
    """Return a link along the shortest way through free ground; None if none is found.

    The way, with as few corners as free ground allows, is the straight pieces. The parameters
    are those of `clothoid_link`.
    """
    for lead in LEADS:
        out = _lead(start, lead, radius)
        back = _lead(_backwards(end), lead, radius, -1.0)
        (p, u), (q, v) = _tip(out), _tip(back)
        way = Ground(cleared, cleared.near, p).way_to(q)
        if way is None:
            continue
        for slack, i, j in product(WAY_SLACKS, WAY_REACHES, WAY_REACHES):
            middle = _between(simplified(way, slack * radius), (p, i * radius), (q, j * radius))
            corners = np.vstack([p, p + i * radius * u, middle, q + j * radius * v, q])
            edges = np.diff(corners, axis=0)
            lengths = np.hypot(edges[:, 0], edges[:, 1])
            turns = _turns(edges[None])[0]
            if lengths.min() < 1e-6 or np.abs(turns).max() > SHARPEST:
                continue
            room = lengths * np.r_[1.0, np.full(len(lengths) - 2, 0.5), 1.0]
            room = np.minimum(room[:-1], room[1:])
            if room.min() < TIGHTEST * radius or not _is_free(corners[1:-1], cleared):
                continue
            for share in SHARES:
                path = through(out, corners, (share * room).tolist()).then_back(back)
                points = path.sampled(tolerance)
                safe = (out.length, path.length - back.length) if lead[1] > 0 else None
                if fence.covers(LineString(points)) and _is_free(points, cleared, safe):
                    return path
    return None


def _between(way: Floats, *ends: tuple[Floats, float]) -> Floats:
    """Return the points of a way that are farther from its ends than so much."""
    keep = np.ones(len(way), bool)
    for place, distance in ends:
        keep &= np.hypot(*(way - place).T) > distance
    return way[keep]


def _is_free(
    points: Floats, cleared: ClearedMap, between: tuple[float, float] | None = None
) -> bool:
    """Return whether a path keeps to free ground, between two lengths along it [mm] if given."""
    line = LineString(points)
    if between is not None:
        line = shapely.ops.substring(line, *between)
    fine = shapely.get_coordinates(shapely.segmentize(line, cleared.pixel))
    return bool(cleared.are_free(fine))


def turn_away(place: Place, radius: float) -> ClothoidPath:
    """Return the clothoids that leave a place to the left, away from the stock."""
    return _lead(place, LEADS[1], radius)


def _backwards(place: Place) -> Place:
    return Place(place.point, place.heading + math.pi, -place.curvature)


def _lead(
    place: Place, lead: tuple[float, float], radius: float, side: float = 1.0
) -> ClothoidPath:
    """Return the clothoids that leave a place, tightening to the left first, or right for -1."""
    length, tight = lead[0] * radius, lead[1] / radius
    path = begin(place.point, place.heading, place.curvature)
    if tight > 0:
        path = path.then(length, side * tight)
    return path.then(length, 0.0)


def _tip(path: ClothoidPath) -> tuple[Floats, Floats]:
    """Return the end of a path, and the direction there."""
    end = np.array([path.length])
    heading = float(path.heading_at(end)[0])
    return path.points_at(end)[0], np.array([math.cos(heading), math.sin(heading)])


def _candidates(
    out: tuple[Floats, Floats], back: tuple[Floats, Floats], radius: float
) -> tuple[Floats, Floats]:
    """Return polylines of two corners, shape (m, 4, 2), and the tangents there, shape (m, 2).

    From one tip of a lead to another; see `_tip`.
    """
    (p, u), (q, v) = out, back
    reach = radius * np.array(REACHES)
    along_u, along_v = (g.ravel() for g in np.meshgrid(reach, reach, indexing="ij"))
    a, b = p + along_u[:, None] * u, q + along_v[:, None] * v
    sine = cross(u, v)
    if abs(sine) > 1e-6:
        w = q - p
        x, y = cross(w, v) / sine, cross(w, u) / sine
        if x > 1e-6 and y > 1e-6:  # the rays meet: one corner, the other is straight
            a, b = np.vstack([a, p + x / 2 * u]), np.vstack([b, p + x * u])
    ends = (np.broadcast_to(e, a.shape) for e in (p, q))
    first, last = ends
    corners = np.stack([first, a, b, last], axis=1)
    edges = np.diff(corners, axis=1)
    lengths = np.hypot(edges[..., 0], edges[..., 1])
    turns = _turns(edges)
    good = (np.abs(turns) < SHARPEST).all(axis=1) & (lengths > 1e-6).all(axis=1)
    corners, lengths, turns = corners[good], lengths[good], turns[good]
    straight = np.abs(turns) < 1e-9
    # a corner next to none has the edge between for itself
    share = np.where(straight[:, ::-1], 1.0, 0.5)
    middle = share * lengths[:, 1:2]
    room = np.where(straight, 0.0, np.minimum(lengths[:, [0, 2]], middle))
    tangents = np.concatenate([s * room for s in SHARES])
    return np.tile(corners, (len(SHARES), 1, 1)), tangents


def _turns(edges: Floats) -> Floats:
    """Return how far polylines turn at their corners, shape (m, k - 1) [rad]."""
    a, b = edges[:, :-1], edges[:, 1:]
    return np.arctan2(cross(a, b), (a * b).sum(axis=-1))


def _sampled(out: Floats, back: Floats, corners: Floats, tangents: Floats) -> Floats:
    """Return points of all candidates, shape (m, n, 2).

    Parameters
    ----------
    out : ndarray of shape (k, 2)
        On the lead from where all begin [mm].
    back : ndarray of shape (m, k, 2)
        On the leads, backwards, to where they end [mm].
    corners, tangents : ndarray of shape (m, 4, 2) and (m, 2)
        See `_candidates`.
    """
    m = len(corners)
    edges = np.diff(corners, axis=1)
    units = edges / np.hypot(edges[..., 0], edges[..., 1])[..., None]
    turns = _turns(edges)
    pieces = [np.broadcast_to(out[:-1], (m, len(out) - 1, 2))]
    here = corners[:, 0]
    for i in (0, 1):
        before, after, rounded = _corner(
            corners[:, i + 1], units[:, i], units[:, i + 1], turns[:, i], tangents[:, i]
        )
        pieces += [_line(here, before), rounded]
        here = after
    pieces += [_line(here, corners[:, 3]), back[:, -2::-1]]
    return np.concatenate(pieces, axis=1)


def _line(start: Floats, end: Floats) -> Floats:
    t = np.linspace(0.0, 1.0, STRAIGHT)[:, None]
    return start[:, None] + t * (end - start)[:, None]


def _corner(
    corner: Floats, u: Floats, v: Floats, turn: Floats, tangent: Floats
) -> tuple[Floats, Floats, Floats]:
    """Return where bi-clothoids begin and end, and points on them, shape (m, k, 2)."""
    half = tangent / tangent_share(turn)
    x, y = half_corner(np.abs(turn), np.linspace(0.0, 1.0, CORNER)[1:])
    side = np.sign(turn)
    before, after = corner - tangent[:, None] * u, corner + tangent[:, None] * v

    def placed(origin: Floats, ahead: Floats, left: Floats) -> Floats:
        along, across = (half[:, None] * x)[..., None], (half[:, None] * y)[..., None]
        return origin[:, None] + along * ahead[:, None] + across * left[:, None]

    def normal(d: Floats) -> Floats:
        return side[:, None] * np.column_stack([-d[:, 1], d[:, 0]])

    first = placed(before, u, normal(u))
    second = placed(after, -v, normal(v))[:, ::-1]
    return before, after, np.concatenate([first, second[:, 1:]], axis=1)
