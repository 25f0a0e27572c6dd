# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feeds that follow the engagement of a finished toolpath, in few steps.

Three modes, the machinist's `FeedMode`. What a mode allows at a place is a ratio to the
programmed feed:

- *Constant*: 1 up to the engagement limit, ``limit / angle`` above it. That is below what
  equal chip thickness asks for, because a longer engaged arc also loads the cutter longer.
- *Linear slow-down* ([CS08] section 2.4): 1 up to the specified radial depth, the slowed
  feed at the largest on the path, linear in between; slots at the slowed feed.
- *Chip thickness*: as Constant, and below the limit ``sin(limit) / sin(angle)``, at which the
  thickest chip stays the same, up to a largest ratio. Laps along the wall stay at the
  programmed feed, for the sake of the wall.

Ratios are rounded down to rungs of 8 % (a dead band keeps dust from costing a rung), and
runs shorter than a least length join the neighbor that costs less time, at the lower of the
two feeds: a feed is never above what is allowed anywhere in its run.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from .engagement import Engagement
from .model import Floats
from .runs import merge_short_runs
from .stations import ends_of, points_at, stations_of
from .toolpath import Role, Toolpath

#: Ratio of neighboring rungs.
RUNG = 1.08
#: Ratios this much below a rung still count as on it.
DEAD_BAND = 0.01
#: Engagement above this is a slot [rad].
SLOT = np.radians(150.0)


class FeedMode(Enum):
    """How the feed follows the engagement; the value is what the machinist reads."""

    CONSTANT = "Constant"
    LINEAR_SLOWDOWN = "Linear slow-down"
    CHIP_THICKNESS = "Chip thickness"


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
    least_run : float
        Least length of one feed [mm].

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
    least_run: float = 6.0

    def __post_init__(self) -> None:
        """Check the ranges."""
        for name in ("cutter_radius", "engagement_limit", "link_feed", "machine_speed"):
            if not getattr(self, name) > 0:
                raise ValueError(f"{name} must be positive, got {getattr(self, name)}")
        if not 0 < self.slowed <= 1:
            raise ValueError(f"slowed must be in (0, 1], got {self.slowed}")
        if self.largest_ratio < 1:
            raise ValueError(f"largest_ratio must be 1 or more, got {self.largest_ratio}")
        if self.least_run < 0:
            raise ValueError(f"least_run must not be negative, got {self.least_run}")


def plan_feeds(toolpath: Toolpath, engagement: Engagement, rules: FeedRules) -> Toolpath:
    """Return `toolpath` with its feeds planned; moves are split where the feed changes.

    Rapids and entries keep their feeds, but the slow-down also slows entries that slot.

    Parameters
    ----------
    toolpath : Toolpath
        n moves; those that cut carry the programmed feed.
    engagement : Engagement
        Measured along this path.
    rules : FeedRules

    Returns
    -------
    Toolpath
    """
    if len(toolpath) == 0:
        return toolpath
    pieces = _cut(toolpath, engagement, rules)
    load = _largest_angles(pieces, toolpath, engagement)
    allowed = np.where(np.isnan(load), 1.0, _allowed(pieces.roles, load, rules, engagement))
    rungs = np.floor(np.log(allowed * (1 + DEAD_BAND)) / np.log(RUNG)).astype(np.int64)
    follows = _follows(pieces.roles, rules.mode)
    groups = np.cumsum(np.r_[True, np.diff(follows) != 0])
    rungs = np.where(follows, rungs, 0)
    rungs = merge_short_runs(rungs, pieces.lengths, groups, rules.least_run, RUNG)
    feeds = toolpath.feeds[pieces.moves] * np.where(follows, RUNG**rungs, 1.0)
    feeds = np.where(pieces.roles == Role.LINK, rules.link_feed, feeds)
    is_feed_move = pieces.roles != Role.AIR
    feeds = np.where(is_feed_move, np.minimum(feeds, rules.machine_speed), feeds)
    return _assemble(toolpath, pieces, np.where(follows, _whole(feeds), feeds))


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


@dataclass(frozen=True, slots=True, eq=False)
class _Pieces:
    """Parts of moves, (p,) each: move, how far along it they end, role, begin and end stations."""

    moves: NDArray[np.int64]
    fractions: Floats
    roles: NDArray[np.int8]
    begins: Floats
    ends: Floats

    @property
    def lengths(self) -> Floats:
        """Return the lengths [mm]."""
        return self.ends - self.begins


def _cut(toolpath: Toolpath, engagement: Engagement, rules: FeedRules) -> _Pieces:
    """Cut moves that are longer than a fraction of the least run at the engagement's samples."""
    lengths, ends = toolpath.lengths, ends_of(toolpath)
    samples = stations_of(toolpath, engagement.moves, engagement.points)
    long = lengths[engagement.moves] > rules.least_run / 4
    begins = ends - lengths
    inner = samples - begins[engagement.moves]
    inside = (inner > 1e-3) & (lengths[engagement.moves] - inner > 1e-3)
    which = np.flatnonzero(long & inside)
    moves = np.r_[engagement.moves[which], np.arange(len(toolpath))]
    fractions = np.r_[inner[which] / lengths[engagement.moves[which]], np.ones(len(toolpath))]
    order = np.lexsort((fractions, moves))
    moves, fractions = moves[order], fractions[order]
    new = np.r_[True, (np.diff(moves) != 0) | (np.diff(fractions) > 1e-9)]
    moves, fractions = moves[new], fractions[new]
    stops = begins[moves] + fractions * lengths[moves]
    first = np.r_[True, np.diff(moves) != 0]
    starts = np.where(first, begins[moves], np.r_[0.0, stops[:-1]])
    return _Pieces(moves, fractions, toolpath.roles[moves], starts, stops)


def _largest_angles(pieces: _Pieces, toolpath: Toolpath, engagement: Engagement) -> Floats:
    """Return the largest engagement next to each piece [rad]; nan where none was measured.

    Of the samples on it and of one more on either side, if they are on the same run of moves.
    """
    if len(engagement.moves) == 0:
        return np.full(len(pieces.moves), np.nan)
    at = stations_of(toolpath, engagement.moves, engagement.points)
    slack = 1e-6
    first = np.searchsorted(at, pieces.begins - slack) - 1
    last = np.searchsorted(at, pieces.ends + slack) + 1
    first, last = np.maximum(first, 0), np.minimum(last, len(at))
    padded = np.r_[engagement.angles, 0.0]
    largest = np.maximum.reduceat(padded, np.column_stack([first, last]).ravel())[::2]
    on_path = np.zeros(len(toolpath), bool)
    on_path[engagement.moves] = True
    return np.where(on_path[pieces.moves] | (last - first > 2), largest, np.nan)


def _allowed(
    roles: NDArray[np.int8], angles: Floats, rules: FeedRules, engagement: Engagement
) -> Floats:
    """Return the largest allowed ratio to the programmed feed."""
    limit, r = rules.engagement_limit, rules.cutter_radius
    if rules.mode is FeedMode.LINEAR_SLOWDOWN:
        steady = engagement.angles[engagement.angles < SLOT]
        depths = r * (1 - np.cos(angles))
        specified = r * (1 - np.cos(limit))
        largest = float(r * (1 - np.cos(steady.max(initial=0.0))))
        ratio = linear_slowdown(depths, specified, largest, rules.slowed)
        return np.where((angles >= SLOT) & (limit < SLOT), rules.slowed, ratio)
    with np.errstate(divide="ignore"):
        above = np.minimum(1.0, limit / angles)
        thin = np.sin(min(limit, np.pi / 2)) / np.sin(np.minimum(angles, np.pi / 2))
    if rules.mode is FeedMode.CONSTANT:
        return above
    raised = np.where(angles < limit, np.minimum(thin, rules.largest_ratio), above)
    return np.where(roles == Role.FINISH, np.minimum(raised, 1.0), raised)


def _follows(roles: NDArray[np.int8], mode: FeedMode) -> NDArray[np.bool_]:
    """Return which moves follow the engagement."""
    follows = (roles == Role.CUT) | (roles == Role.FINISH)
    return follows | (roles == Role.ENTRY) if mode is FeedMode.LINEAR_SLOWDOWN else follows


def _whole(feeds: Floats) -> Floats:
    """Return feeds [mm/s] rounded down to whole mm/min, as they are written."""
    return np.where(feeds * 60 >= 1, np.floor(feeds * 60 + 1e-6) / 60, feeds)


def _assemble(toolpath: Toolpath, pieces: _Pieces, feeds: Floats) -> Toolpath:
    """Return the path of the pieces, those of one move and one feed as one move again."""
    last = np.r_[(np.diff(pieces.moves) != 0) | (np.diff(feeds) != 0), True]
    moves, fractions = pieces.moves[last], pieces.fractions[last]
    return Toolpath(
        start=toolpath.start,
        kinds=toolpath.kinds[moves],
        roles=toolpath.roles[moves],
        points=points_at(toolpath, moves, fractions),
        centers=toolpath.centers[moves],
        feeds=feeds[last],
    )
