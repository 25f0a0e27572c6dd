# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vectorised polyline maths: where a ring begins, parts of it, even samples, simplification."""

from __future__ import annotations

import numpy as np
import shapely
from shapely import LinearRing, LineString, Point

from ..model import Floats
from .points import distances_along, wrapped


def closed_line(points: Floats) -> LineString:
    """Return the line through points, shape (n, 2), and back to the first of them [mm]."""
    return LineString(np.vstack([points, points[:1]]))


def ring_points(ring: LinearRing) -> Floats:
    """Return the points of a ring, the first not repeated, shape (n, 2) [mm]."""
    return np.asarray(ring.coords)[:-1]


def points_at(line: LineString, at: Floats) -> Floats:
    """Return the points at distances along a line, shape (..., 2) [mm]; O(log n) for each."""
    coords = shapely.get_coordinates(line)
    along = distances_along(coords)
    return np.stack([np.interp(at, along, coords[:, i]) for i in (0, 1)], axis=-1)


def between(line: LineString, start: float, length: float) -> Floats:
    """Return the points of a closed line from `start` on over `length`, shape (n, 2) [mm].

    Both ends are among them.
    """
    coords = shapely.get_coordinates(line)
    along = distances_along(coords)
    total = float(along[-1])
    turns = np.arange(-1, int(np.ceil(length / total)) + 2)
    s = (along[:-1][None, :] + total * turns[:, None]).ravel()
    points = np.tile(coords[:-1], (len(turns), 1))
    start %= total
    inner = (s > start + 1e-6) & (s < start + length - 1e-6)

    def at(where: float) -> Floats:
        return np.array([np.interp(where % total, along, coords[:, i]) for i in (0, 1)])

    return np.vstack([at(start), points[inner], at(start + length)])


def ring_samples(ring: shapely.LinearRing, spacing: float, fewest: int = 16) -> Floats:
    """Return evenly spaced points of a ring, shape (n, 2) [mm]."""
    count = max(fewest, int(np.ceil(ring.length / spacing)))
    return points_at(ring, np.arange(count) * ring.length / count)


def located(line: LineString, points: Floats) -> Floats:
    """Return how far along a line it is nearest to each of many points, shape (n,) [mm].

    `shapely.line_locate_point` looks at the whole line for each.
    """
    coords = shapely.get_coordinates(line)
    steps = np.diff(coords, axis=0)
    lengths = np.hypot(*steps.T)
    tree = shapely.STRtree(shapely.linestrings(np.stack([coords[:-1], coords[1:]], axis=1)))
    which = tree.query_nearest(shapely.points(points), all_matches=False)[1]
    share = ((points - coords[which]) * steps[which]).sum(axis=1)
    share = share / np.maximum(lengths[which], 1e-12) ** 2
    return np.cumsum(lengths)[which] - (1 - np.clip(share, 0.0, 1.0)) * lengths[which]


def located_nearby(line: LineString, points: Floats) -> Floats:
    """Return how far along a line it is nearest to each of a row of points, shape (n,) [mm].

    Parameters
    ----------
    line : shapely.LineString
    points : ndarray of shape (n, 2)
        Along a curve: only the part of the line near it is looked at.
    """
    coords = shapely.get_coordinates(line)
    steps = np.diff(coords, axis=0)
    lengths = np.hypot(steps[:, 0], steps[:, 1])
    begins = np.cumsum(lengths) - lengths
    # from one probe to the next the distance to the line grows by no more than the way between
    skip = max(1, len(points) // 8)
    probes = points[::skip]
    along = np.cumsum(np.hypot(*np.diff(points, axis=0).T), dtype=float)
    stretch = np.diff(np.r_[0.0, along[skip - 1 :: skip], along[-1:]]).max(initial=0.0)
    far = np.hypot(*(probes[:, None] - coords).T).min(axis=0).max() + stretch
    low, high = points.min(axis=0) - far, points.max(axis=0) + far
    a, b = coords[:-1], coords[1:]
    near = ((np.maximum(a, b) >= low) & (np.minimum(a, b) <= high)).all(axis=1)
    a, steps, lengths, begins = a[near], steps[near], lengths[near], begins[near]
    dx, dy = points[:, :1] - a[:, 0], points[:, 1:] - a[:, 1]
    square = np.maximum(lengths**2, 1e-30)
    share = np.clip((dx * steps[:, 0] + dy * steps[:, 1]) / square, 0.0, 1.0)
    apart = (dx - share * steps[:, 0]) ** 2 + (dy - share * steps[:, 1]) ** 2
    which = np.argmin(apart, axis=1)
    return begins[which] + share[np.arange(len(points)), which] * lengths[which]


def ring_from(ring: Floats, place: Floats, toward: tuple[float, float] | None = None) -> Floats:
    """Return a closed ring that begins at the point of it nearest to `place`.

    Parameters
    ----------
    ring : ndarray of shape (n, 2)
        Its last point is not the first again.
    place : ndarray of shape (2,)
    toward : tuple of float, optional
        Then the ring begins where the ray from `place` in this direction first meets it.

    Returns
    -------
    ndarray of shape (m, 2)
        First and last point are the same.
    """
    line = closed_line(ring)
    if toward is not None:
        far = place + np.array(toward) * (line.length + float(np.ptp(ring)))
        met = shapely.intersection(line, LineString([place, far]))
        if not met.is_empty:
            place = np.array(shapely.shortest_line(met, Point(place)).coords[0])
    at = line.project(Point(place))
    coords = np.array(line.coords)
    along = distances_along(coords)
    start = np.array(line.interpolate(at).coords[0])
    after = coords[:-1][along[:-1] > at + 1e-9]
    before = coords[:-1][along[:-1] < at - 1e-9]
    return np.vstack([start, after, before, start])


def turning_samples(closed: Floats, length: float, turn: float) -> Floats:
    """Sample a closed ring evenly in length plus turning, so that bends get more points.

    Parameters
    ----------
    closed : ndarray of shape (n, 2)
        First and last point are the same.
    length : float
        Distance of samples on a straight [mm].
    turn : float
        Turning between samples in a tight bend [rad].

    Returns
    -------
    ndarray of shape (m, 2)
        The last is not the first again.
    """
    steps = np.diff(closed, axis=0)
    lengths = np.hypot(steps[:, 0], steps[:, 1])
    keep = lengths > 1e-9
    closed = np.vstack([closed[:-1][keep], closed[-1:]])
    steps, lengths = steps[keep], lengths[keep]
    heading = np.arctan2(steps[:, 1], steps[:, 0])
    bend = np.abs(wrapped(np.diff(heading, append=heading[:1])))
    # half of each corner's turning goes to either side of it, spread over that edge
    effort = lengths / length + (bend + np.roll(bend, 1)) / 2 / turn
    total = np.concatenate([[0.0], np.cumsum(effort)])
    count = max(8, int(np.ceil(total[-1])))
    at = np.interp(np.arange(count) * total[-1] / count, total, np.arange(len(total)))
    return _spread(closed, lengths, at)


def _spread(closed: Floats, lengths: Floats, at: Floats) -> Floats:
    """Smooth the spacing of samples at fractional indices `at`, and return their points.

    A spline through points whose spacing jumps oscillates: distances between neighbors are
    evened out along the ring, the first sample staying where it is.
    """
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    s = np.interp(at, np.arange(len(along)), along)
    gaps = np.diff(np.append(s, along[-1]))
    for _ in range(4):
        gaps = (np.roll(gaps, 1) + 2 * gaps + np.roll(gaps, -1)) / 4
    s = np.concatenate([[0.0], np.cumsum(gaps)[:-1]]) * along[-1] / gaps.sum()
    return np.column_stack([np.interp(s, along, closed[:, i]) for i in (0, 1)])


def simplified(points: Floats, tolerance: float) -> Floats:
    """Drop points of a polyline where the chords keep within `tolerance` [mm]."""
    line = shapely.simplify(LineString(points), tolerance, preserve_topology=False)
    return shapely.get_coordinates(line)
