# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feeds that follow the engagement of a finished toolpath, in few steps.

Three modes, the machinist's `FeedMode`. What a mode allows at a place is a ratio to the
programmed feed:

- *Constant*: 1 up to the engagement limit, ``limit / angle`` above it. That is below what
  equal chip thickness asks for, because a longer engaged arc also loads the cutter longer.
- *Linear slow-down* ([CS08] section 2.4): 1 up to the specified radial depth, the slowed
  feed at the largest on the path, linear in between; slots at the slowed feed.
- *Chip thickness*: as Constant, and below the limit ``sin(limit)`` over the thickness of the
  thickest chip, which so stays the same, up to a largest ratio. That thickness is the sine of the
  angle, but where only a rib is left that of the rib's far side. Laps along the wall stay at the
  programmed feed, for the sake of the wall.

Where a cut meets no stock for longer than the cutter's radius, in any mode, it is a link: it runs
at the feed of links, and the proof sees to it that it stays clear.

Ratios are rounded down to rungs of 4 % (a dead band keeps dust from costing a rung), and
runs shorter than a least length join the neighbor that costs less time, at the lower of the
two feeds: a feed is never above what is allowed anywhere in its run.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..model import FeedMode, Floats
from ..numerics.distinct import distinct
from ..numerics.filters import lowest
from ..stepover import radial_depth
from ..toolpath import Role, Toolpath
from .feed_runs import lengthen_runs
from .stations import Measured, ends_of, points_at, stations_of

#: Ratio of neighboring rungs.
RUNG = 1.04
#: Ratios this share below a rung still count as on it: no engagement is known better.
DEAD_BAND = 0.01
#: Up to so much times the limit and a little more [rad] engagement counts as at the limit: the
#: chip is then at most 5 % thicker, and every lap would flicker.
SLACK, SLACK_ANGLE = 1.05, np.radians(2.0)
#: Engagement above this is a slot [rad].
SLOT = np.radians(150.0)
#: Least length of one feed over R: the thin chips beside walls are no longer.
LEAST_RUN = 0.3
#: A cut is a link where it meets no stock for longer than this, less this at both ends, over R.
IDLE, IDLE_MARGIN = 1.0, 0.1
#: A change of feed goes to the end of a move this near, in least runs.
SNAP = 0.1
#: Moves are not split closer than this to their ends [mm].
SHORTEST = 1e-3


@dataclass(frozen=True, slots=True)
class FeedRules:
    """What feeds are planned by.

    Attributes
    ----------
    mode : FeedMode
    cutter_radius : float
        [mm]
    engagement_limit : float
        Engagement of a straight cut at the specified step-over [rad], in ``(0, pi]``.
    link_feed : float
        Feed of moves at depth through cleared ground [mm/s].
    slowed : float
        Ratio of the slowed feed (Linear slow-down), in ``(0, 1]``.
    largest_ratio : float
        Largest ratio to the programmed feed (Chip thickness), 1 or more.
    machine_speed : float
        No feed above this [mm/s].

    Raises
    ------
    ValueError
        If a value is out of its range.
    """

    mode: FeedMode
    cutter_radius: float
    engagement_limit: float
    link_feed: float
    slowed: float = 0.75
    largest_ratio: float = 2.0
    machine_speed: float = np.inf

    def __post_init__(self) -> None:
        """Check the ranges."""
        for name in ("cutter_radius", "engagement_limit", "link_feed", "machine_speed"):
            if not getattr(self, name) > 0:
                raise ValueError(f"{name} must be positive, got {getattr(self, name)}")
        if not 0 < self.slowed <= 1:
            raise ValueError(f"slowed must be in (0, 1], got {self.slowed}")
        if self.largest_ratio < 1:
            raise ValueError(f"largest_ratio must be 1 or more, got {self.largest_ratio}")


def plan_feeds(toolpath: Toolpath, engagement: Measured, rules: FeedRules) -> Toolpath:
    """Return `toolpath` with its feeds planned; moves are split where the feed changes.

    Rapids and entries keep their feeds, but the slow-down also slows entries that slot.

    Parameters
    ----------
    toolpath : Toolpath
        n moves; those that cut carry the programmed feed.
    engagement : Measured
        Along this path, as `engagement.along_path` returns it.
    rules : FeedRules

    Returns
    -------
    Toolpath
    """
    if len(toolpath) == 0:
        return toolpath
    follows = _follows(toolpath.roles, rules.mode)
    least = LEAST_RUN * rules.cutter_radius
    stations, ratios = _allowed_ratios(toolpath, engagement, rules)
    lengths = toolpath.lengths
    ends = np.cumsum(lengths)
    cuts, rungs = [], []
    idle = _idle_spans(stations, toolpath.roles, engagement, rules.cutter_radius)
    highest = int(np.log(rules.largest_ratio) / np.log(RUNG) + 1e-9)
    for first, last in _stretches(follows):
        span = (ends[first] - lengths[first], ends[last])
        edges, allowed = _steps_between(stations, ratios, *span)
        levels = np.floor(np.log(allowed * (1 + DEAD_BAND)) / np.log(RUNG)).astype(np.int64)
        levels = np.minimum(levels, highest)
        edges, levels = lengthen_runs(edges, levels, least, RUNG)
        edges, levels = _snap(edges, levels, ends[first : last + 1], least * SNAP)
        cuts.append(edges[1:])
        rungs.append(levels)
    pieces = _split(toolpath, distinct(np.concatenate([*cuts, idle.ravel()])))
    feeds, roles = toolpath.feeds[pieces.moves], toolpath.roles[pieces.moves]
    in_air = _are_within(pieces.middles, idle) & (roles == Role.CUT)
    roles = np.where(in_air, np.int8(Role.LINK), roles)
    planned = _whole(feeds * _ratio_at(pieces.middles, cuts, rungs))
    feeds = np.where(follows[pieces.moves], planned, feeds)
    feeds = np.where(roles == Role.LINK, rules.link_feed, feeds)
    feeds = np.where(roles == Role.AIR, feeds, np.minimum(feeds, rules.machine_speed))
    return Toolpath(
        start=toolpath.start,
        kinds=toolpath.kinds[pieces.moves],
        roles=roles,
        points=points_at(toolpath, pieces.moves, pieces.fractions),
        centers=toolpath.centers[pieces.moves],
        feeds=feeds,
    )


def linear_slowdown(depths: Floats, specified: float, largest: float, slowed: float) -> Floats:
    """Return CS08's ratio to the programmed feed for radial depths of cut.

    Parameters
    ----------
    depths : ndarray
        Radial depths of cut [mm].
    specified, largest : float
        Depths at which the feed is full, and at which it is slowed wholly [mm].
    slowed : float
        Ratio there.
    """
    if largest <= specified * (1 + DEAD_BAND):
        return np.where(depths > specified * (1 + DEAD_BAND), slowed, 1.0)
    share = np.clip((depths - specified) / (largest - specified), 0.0, 1.0)
    return 1.0 - (1.0 - slowed) * share


def _follows(roles: NDArray[np.int8], mode: FeedMode) -> NDArray[np.bool_]:
    """Return which moves follow the engagement."""
    follows = (roles == Role.CUT) | (roles == Role.FINISH)
    return follows | (roles == Role.ENTRY) if mode is FeedMode.LINEAR_SLOWDOWN else follows


def _stretches(follows: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return first and last move of each unbroken stretch that follows the engagement."""
    change = np.diff(np.r_[False, follows, False].astype(np.int8))
    first, last = np.flatnonzero(change > 0), np.flatnonzero(change < 0) - 1
    return list(zip(first.tolist(), last.tolist(), strict=True))


def _allowed_ratios(
    toolpath: Toolpath, engagement: Measured, rules: FeedRules
) -> tuple[Floats, Floats]:
    """Return the stations of the samples and the ratio to the programmed feed allowed there."""
    limit, r = rules.engagement_limit, rules.cutter_radius
    stations = stations_of(toolpath, engagement.moves, engagement.points)
    angles, roles = engagement.angles, toolpath.roles[engagement.moves]
    if rules.mode is FeedMode.LINEAR_SLOWDOWN:
        depths = radial_depth(angles, r)
        steady = (angles < SLOT) & (roles != Role.ENTRY)
        specified = radial_depth(limit, r)
        ratio = linear_slowdown(
            depths, specified, float(depths[steady].max(initial=0.0)), rules.slowed
        )
        return stations, np.where((angles >= SLOT) & (limit < SLOT), rules.slowed, ratio)
    steady = SLACK * limit + SLACK_ANGLE
    above = steady / np.maximum(angles, steady)
    if rules.mode is FeedMode.CONSTANT:
        return stations, above
    thickest = np.sin(min(limit, np.pi / 2))
    thin = thickest / np.clip(engagement.chips, thickest / rules.largest_ratio, thickest)
    raised = np.where(angles < limit, thin, above)
    return stations, np.where(roles == Role.FINISH, np.minimum(raised, 1.0), raised)


def _idle_spans(
    stations: Floats, roles: NDArray[np.int8], engagement: Measured, radius: float
) -> Floats:
    """Return from which to which station cuts meet no stock, shape (s, 2) [mm]."""
    cuts = roles == Role.CUT
    # rapids and ways down may have no samples: a span ends with the cuts that are in a row
    row = np.cumsum(np.diff(cuts, prepend=False))[engagement.moves]
    idle = (engagement.angles <= 0) & cuts[engagement.moves]
    row = np.r_[0, np.where(idle, row, 0), 0]
    first = np.flatnonzero((row[1:-1] > 0) & (row[1:-1] != row[:-2]))
    last = np.flatnonzero((row[1:-1] > 0) & (row[1:-1] != row[2:]))
    spans = stations[np.column_stack([first, last])]
    spans = spans[np.diff(spans)[:, 0] > IDLE * radius]
    return spans + IDLE_MARGIN * radius * np.array([1, -1])


def _are_within(stations: Floats, spans: Floats) -> NDArray[np.bool_]:
    """Return which stations are in one of the spans, ascending and apart."""
    return np.searchsorted(spans[:, 0], stations) > np.searchsorted(spans[:, 1], stations)


def _steps_between(
    stations: Floats, ratios: Floats, begin: float, end: float
) -> tuple[Floats, Floats]:
    """Return edges and values of the ratio allowed from `begin` to `end`.

    Between two samples it is the lowest of these and of one more to either side.
    """
    slack = 1e-6
    first, last = np.searchsorted(stations, (begin - slack, end + slack))
    if first == last:
        return np.array([begin, end]), np.ones(1)
    values = lowest(ratios[first:last], 3)
    edges = np.r_[begin, np.clip(stations[first:last], begin, end), end]
    values = np.r_[values[0], np.minimum(values[:-1], values[1:]), values[-1]]
    keep = np.diff(edges) > slack
    return np.r_[edges[:-1][keep], end], values[keep]


def _snap(
    edges: Floats, rungs: NDArray[np.int64], joints: Floats, reach: float
) -> tuple[Floats, NDArray[np.int64]]:
    """Move edges to the joints of moves where one is within reach on the lower side."""
    inner = edges[1:-1]
    before = np.r_[edges[0], joints][np.searchsorted(joints, inner, side="right")]
    after = joints[np.minimum(np.searchsorted(joints, inner), len(joints) - 1)]
    target = np.where(np.diff(rungs) < 0, before, after)
    moved = np.where(np.abs(target - inner) <= reach, target, inner)
    snapped = np.r_[edges[0], moved, edges[-1]]
    # a step that has become empty, or whose edges have passed each other, gives way to the lower
    order = distinct(snapped)
    values = np.full(len(order) - 1, np.iinfo(np.int64).max)
    for low, high, rung in zip(snapped[:-1], snapped[1:], rungs, strict=True):
        i, j = np.searchsorted(order, (low, high))
        values[i:j] = np.minimum(values[i:j], rung)
    return order, values


@dataclass(frozen=True, slots=True, eq=False)
class _Pieces:
    """Parts of moves, (p,) each: move, how far along it they end, station of the middle."""

    moves: NDArray[np.int64]
    fractions: Floats
    middles: Floats


def _split(toolpath: Toolpath, cuts: Floats) -> _Pieces:
    """Cut the moves at stations, but not within a micron of their ends."""
    ends, lengths = ends_of(toolpath), toolpath.lengths
    moves = np.minimum(np.searchsorted(ends, cuts), len(ends) - 1)
    inner = (cuts > ends[moves] - lengths[moves] + SHORTEST) & (cuts < ends[moves] - SHORTEST)
    cuts, moves = cuts[inner], moves[inner]
    fractions = np.r_[1.0 - (ends[moves] - cuts) / lengths[moves], np.ones(len(ends))]
    stations = np.r_[cuts, ends]
    moves = np.r_[moves, np.arange(len(ends))]
    order = np.lexsort((fractions, moves))
    moves, fractions, stations = moves[order], fractions[order], stations[order]
    begins = np.r_[0.0, stations[:-1]]
    return _Pieces(moves, fractions, (begins + stations) / 2)


def _ratio_at(stations: Floats, cuts: list[Floats], rungs: list[NDArray[np.int64]]) -> Floats:
    """Return the planned ratio at stations; anything where nothing is planned."""
    if not cuts:
        return np.ones(len(stations))
    edges, values = np.concatenate(cuts), np.concatenate(rungs)
    index = np.minimum(np.searchsorted(edges, stations), len(edges) - 1)
    return np.power(RUNG, values[index].astype(np.float64))


def _whole(feeds: Floats) -> Floats:
    """Return feeds [mm/s] rounded down to whole mm/min, as they are written."""
    return np.where(feeds * 60 >= 1, np.floor(feeds * 60 + 1e-6) / 60, feeds)
