# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motion at depth between cuts: off the wall and onto it, smooth links and how long they take.

A link is a cubic, tangent to the cuts at both ends. Candidates differ in the lengths of their
handles; thousands are made, and timed by acceleration and curvature alone, as one array.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon
from shapely.ops import substring

from ..model import Floats
from ..shapes.drawing_near import drawn_to
from ..shapes.points import cross

#: Radius of the arc that leaves the wall, over R; halved until it fits.
LEAVE_RADIUS = 0.3
HALVINGS = 4
#: Chords of that quarter circle.
CHORDS = 8
#: A lap that begins nearer to the wall than this is on it [mm].
ON_WALL = 1e-4
#: It comes to the wall over R, halved until it fits; chords of that way.
COME_HALVINGS, COME_CHORDS = 3, 12
#: Handle lengths of a link over the distance of its ends, and absolute over R.
HANDLES, HANDLES_R = (0.25, 0.5, 0.8, 1.2, 2.0, 3.0), (2.0, 4.0)
#: A link with a tighter bend than the least radius counts as so much slower: in time alone a near
#: stop is no worse than a loop, but it jerks the machine.
NERVOUS = 2.0
#: Points of a link when it is timed and tested.
POINTS = 25


def leave_wall(lap: Floats, region: Polygon, cutter_radius: float) -> Floats:
    """Return a quarter circle that leaves the wall tangentially, so that lifting marks nothing.

    Parameters
    ----------
    lap : ndarray of shape (n, 2)
        The finished lap along the wall, counter-clockwise: cleared ground is on its left.
    region : shapely.Polygon
        The cutter-center region.
    cutter_radius : float
        R [mm].

    Returns
    -------
    ndarray of shape (k, 2)
        From the end of `lap`; empty where no such arc fits.
    """
    ahead = lap[-1] - lap[-2]
    ahead = ahead / np.linalg.norm(ahead)
    left = np.array([-ahead[1], ahead[0]])
    turn = np.linspace(0.0, np.pi / 2, CHORDS + 1)[:, None]
    for halving in range(HALVINGS):
        radius = LEAVE_RADIUS * cutter_radius * 0.5**halving
        arc = lap[-1] + radius * (np.sin(turn) * ahead + (1 - np.cos(turn)) * left)
        if region.buffer(1e-6).covers(LineString(arc)):
            return arc[1:]
    return np.empty((0, 2))


def come_to_wall(lap: Floats, here: Floats, region: Polygon, cutter_radius: float) -> Floats:
    """Return a lap along a wall that begins beside it: it comes to the wall bit by bit.

    The lap runs on as far as it took to come there.

    Parameters
    ----------
    lap : ndarray of shape (n, 2)
        Closed, first and last point the same, from the place on the wall that is nearest [mm].
    here : ndarray of shape (2,)
        Where the cutter comes from [mm].
    region : shapely.Polygon
        The cutter-center region; where the way to the wall would leave it the lap stays as it is.
    cutter_radius : float
        R [mm].
    """
    line = LineString(lap)
    if np.hypot(*(here - lap[0])) < ON_WALL or line.length < 2 * cutter_radius:
        return lap
    fence = region.buffer(ON_WALL)
    for halving in range(COME_HALVINGS):
        length = cutter_radius * 0.5**halving
        first = shapely.get_coordinates(
            shapely.segmentize(substring(line, 0.0, length), length / COME_CHORDS)
        )
        way = drawn_to(first, here, length)
        if fence.covers(LineString(way)):
            rest = shapely.get_coordinates(substring(line, length, line.length))
            return np.vstack([way, rest[1:], first[1:]])
    return lap


@dataclass(frozen=True, slots=True)
class Motion:
    """What limits motion between cuts.

    Attributes
    ----------
    acceleration : float
        [mm/s2]
    link_feed, cut_feed : float
        Top speed of links, and speed of the cuts that they join [mm/s].
    least_radius : float
        Links with tighter bends count as slower than they are [mm].
    """

    acceleration: float
    link_feed: float
    cut_feed: float
    least_radius: float


def _hermite_basis(count: int) -> Floats:
    u = np.linspace(0.0, 1.0, count)
    return np.stack(
        [2 * u**3 - 3 * u**2 + 1, u**3 - 2 * u**2 + u, -2 * u**3 + 3 * u**2, u**3 - u**2], axis=1
    )


def hermite_links(
    start: Floats,
    heading: Floats,
    ends: Floats,
    headings: Floats,
    radius: float,
    handles: tuple[Sequence[float], Sequence[float]] = (HANDLES, HANDLES_R),
) -> Floats:
    """Return candidates for a smooth link, tangent at both ends.

    Parameters
    ----------
    start, heading : ndarray of shape (2,)
        Where it begins, and the unit direction there.
    ends, headings : ndarray of shape (m, 2)
        Where it may end, and the unit directions there.
    radius : float
        R [mm].
    handles : tuple of sequence of float
        Lengths of handles, over the distance of its ends and over R.

    Returns
    -------
    ndarray of shape (m, h, POINTS, 2)
        h combinations of handle lengths.
    """
    return _curves(_controls(start, heading, ends, headings, radius, handles), POINTS)


def fine_link(
    start: Floats,
    heading: Floats,
    end: Floats,
    arriving: Floats,
    radius: float,
    which: int,
    count: int,
) -> Floats:
    """Return one of the candidates of `hermite_links`, more finely drawn.

    Parameters
    ----------
    start, heading, end, arriving : ndarray of shape (2,)
        Where it begins and ends [mm], and the unit directions there.
    radius : float
        R [mm].
    which : int
        Its place among the combinations of handles.
    count : int
        Points to draw.

    Returns
    -------
    ndarray of shape (count, 2)
        [mm]
    """
    controls = _controls(start, heading, end[None], arriving[None], radius)
    return _curves(controls[:, which : which + 1], count)[0, 0]


def _controls(
    start: Floats,
    heading: Floats,
    ends: Floats,
    headings: Floats,
    radius: float,
    shares: tuple[Sequence[float], Sequence[float]] = (HANDLES, HANDLES_R),
) -> Floats:
    """Return begin, tangent, end and tangent of the candidates, shape (m, h, 4, 2)."""
    distance = np.hypot(*(ends - start).T)
    handles = np.concatenate(
        [
            distance[:, None] * np.array(shares[0]),
            np.tile(radius * np.array(shares[1]), (len(ends), 1)),
        ],
        axis=1,
    )
    n = handles.shape[1]
    controls = np.empty((len(ends), n * n, 4, 2))
    controls[:, :, 0] = start
    controls[:, :, 1] = np.repeat(handles, n, axis=1)[..., None] * 3 * heading
    controls[:, :, 2] = ends[:, None]
    controls[:, :, 3] = np.tile(handles, (1, n))[..., None] * 3 * headings[:, None]
    return controls


def _curves(controls: Floats, count: int) -> Floats:
    """Return points of curves from their controls, shape (m, h, count, 2)."""
    m, h = controls.shape[:2]
    flat = np.moveaxis(controls, 2, 0).reshape(4, -1)
    return np.moveaxis((_hermite_basis(count) @ flat).reshape(count, m, h, 2), 0, 2)


def link_times(paths: Floats, motion: Motion) -> Floats:
    """Return how long each path takes between two cuts [s].

    The speed is bound by the link feed, by the curvature, and by accelerating and braking from
    and to the cutting feed; where a path begins or ends slower than that, the time that the
    neighboring cut loses is added.

    Parameters
    ----------
    paths : ndarray of shape (..., n, 2)
        [mm]
    """
    length, bend = _bends(paths)
    a = motion.acceleration
    inner = np.minimum(a / (bend + 1e-9), motion.link_feed**2)
    ends = np.full((*inner.shape[:-1], 1), motion.cut_feed**2)
    square = np.concatenate([ends, inner, ends], axis=-1)
    climb = (
        2
        * a
        * np.concatenate([np.zeros((*length.shape[:-1], 1)), np.cumsum(length, axis=-1)], axis=-1)
    )
    forward = np.minimum.accumulate(square - climb, axis=-1) + climb
    back = (
        np.flip(np.minimum.accumulate(np.flip(square + climb, axis=-1), axis=-1), axis=-1) - climb
    )
    v = np.sqrt(np.maximum(np.minimum(forward, back), 1e-6))
    time = (2 * length / (v[..., :-1] + v[..., 1:])).sum(axis=-1)
    lost = ((motion.cut_feed - v[..., 0]) ** 2 + (motion.cut_feed - v[..., -1]) ** 2) / (
        2 * a * motion.cut_feed
    )
    nervous = _are_tight(bend, motion)
    return (time + lost) * np.where(nervous, NERVOUS, 1.0)


def are_nervous(paths: Floats, motion: Motion) -> NDArray[np.bool_]:
    """Return which paths, shape (..., n, 2) [mm], have a bend tighter than the least radius."""
    return _are_tight(_bends(paths)[1], motion)


def _are_tight(bend: Floats, motion: Motion) -> NDArray[np.bool_]:
    return np.asarray(bend.max(axis=-1, initial=0.0) * motion.least_radius > 1)


def _bends(paths: Floats) -> tuple[Floats, Floats]:
    """Return the lengths of chords [mm], and the curvature at the points between [1/mm]."""
    d = np.diff(paths, axis=-2)
    length = np.hypot(d[..., 0], d[..., 1]) + 1e-9
    here, onward = d[..., :-1, :], d[..., 1:, :]
    turn = np.arctan2(cross(here, onward), (here * onward).sum(axis=-1))
    bend = np.abs(turn) / (0.5 * (length[..., :-1] + length[..., 1:]))
    return length, bend
