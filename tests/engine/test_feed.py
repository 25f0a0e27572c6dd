# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feed planning: what each mode allows, few long runs, never above what is allowed."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import box

from freecad_spiralpocket.engine.contact.air import Stock
from freecad_spiralpocket.engine.contact.engagement import along_path
from freecad_spiralpocket.engine.motion.feed import (
    DEAD_BAND,
    LEAST_RUN,
    RUNG,
    SLOT,
    FeedMode,
    FeedRules,
    linear_slowdown,
    plan_feeds,
)
from freecad_spiralpocket.engine.motion.feed_runs import lengthen_runs
from freecad_spiralpocket.engine.motion.stations import (
    fractions_of,
    moves_at,
    points_at,
    stations_of,
)
from freecad_spiralpocket.engine.toolpath import Kind, Role, Toolpath, ToolpathBuilder

RADIUS, LIMIT, FEED, LINK_FEED = 3.0, math.radians(60.0), 50.0, 80.0
SPACING = 0.25
#: A chip is nowhere thicker than this over that at the limit: slack, dead band, rounding.
CHIP_BOUND = 1.08
#: Feeds are rounded down to whole mm/min.
ROUNDING = 1 / 60


class Engagement(NamedTuple):
    """What is measured along a path."""

    points: np.ndarray
    angles: np.ndarray
    chips: np.ndarray
    lengths: np.ndarray
    moves: np.ndarray


def rules(mode: FeedMode, **changes) -> FeedRules:
    """Return rules for the cutter of these tests."""
    return replace(FeedRules(mode, RADIUS, LIMIT, LINK_FEED), **changes)


def straight(*lengths: float, role: Role = Role.CUT) -> Toolpath:
    """Return moves along x."""
    builder = ToolpathBuilder((0, 0, 0))
    for x in np.cumsum(lengths):
        builder.line((x, 0, 0), FEED, role)
    return builder.build()


def engaged(path: Toolpath, angle_at) -> Engagement:
    """Return samples along `path`; `angle_at` maps stations [mm] to angles [rad]."""
    total = path.lengths.sum()
    stations = np.arange(SPACING / 2, total, SPACING)
    moves = moves_at(path, stations)
    begins = np.cumsum(path.lengths) - path.lengths
    points = points_at(path, moves, (stations - begins[moves]) / path.lengths[moves])
    angles = np.broadcast_to(angle_at(stations), stations.shape).astype(float)
    chips = np.sin(np.minimum(angles, np.pi / 2))
    return Engagement(points, angles, chips, np.full(len(stations), SPACING), moves)


def feeds_at(path: Toolpath, stations: np.ndarray) -> np.ndarray:
    """Return the programmed feeds at stations."""
    return path.feeds[moves_at(path, stations)]


def test_there_are_three_modes():
    names = [mode.value for mode in FeedMode]
    assert names == ["Constant", "Linear slow-down", "Chip thickness"]


# --- what each mode allows ----------------------------------------------------------------


@pytest.mark.parametrize("mode", list(FeedMode))
def test_path_at_the_limit_stays_as_it_is(mode):
    path = straight(40, 40)
    dust = 4e-8 * np.sin(np.arange(320))
    planned = plan_feeds(path, engaged(path, lambda s: LIMIT + dust), rules(mode))
    np.testing.assert_array_equal(planned.feeds, path.feeds)
    np.testing.assert_array_equal(planned.points, path.points)


def test_constant_slows_down_above_the_limit_only():
    path = straight(100)
    engagement = engaged(path, lambda s: np.where(abs(s - 50) < 10, 1.5 * LIMIT, LIMIT / 2))
    planned = plan_feeds(path, engagement, rules(FeedMode.CONSTANT))
    assert feeds_at(planned, np.array([20.0, 80.0])) == pytest.approx(FEED)
    slowed = feeds_at(planned, np.array([50.0]))[0]
    assert FEED / 1.5 / RUNG < slowed <= FEED * math.sin(LIMIT) * CHIP_BOUND


def test_chip_thickness_stays_the_same_where_engagement_is_low():
    path, low = straight(100), math.radians(35.0)
    planned = plan_feeds(path, engaged(path, lambda s: low), rules(FeedMode.CHIP_THICKNESS))
    ratio = planned.feeds[0] / FEED
    allowed = math.sin(LIMIT) / math.sin(low)
    assert allowed / RUNG < ratio <= allowed * (1 + DEAD_BAND)


@pytest.mark.parametrize(
    ("changes", "largest"),
    [
        ({}, 2.0),
        ({"largest_ratio": 1.4}, 1.4),
        ({"largest_ratio": 2.01}, 2.01),
        ({"machine_speed": 60}, 1.2),
    ],
)
def test_raised_feed_is_capped(changes, largest):
    path = straight(100)
    planned = plan_feeds(
        path, engaged(path, lambda s: 0.0), rules(FeedMode.CHIP_THICKNESS, **changes)
    )
    assert largest / RUNG < planned.feeds[0] / FEED <= largest
    assert planned.feeds.max() <= changes.get("machine_speed", np.inf)


def test_a_rib_makes_chips_as_thick_as_its_far_side_does():
    path, low = straight(100), math.radians(35.0)
    engagement = engaged(path, lambda s: low)._replace(chips=np.full(400, math.sin(LIMIT)))
    planned = plan_feeds(path, engagement, rules(FeedMode.CHIP_THICKNESS))
    assert planned.feeds == pytest.approx(FEED)


@pytest.mark.parametrize("mode", list(FeedMode))
@pytest.mark.parametrize("role", [Role.CUT, Role.FINISH])
def test_a_cut_that_meets_no_stock_for_long_is_a_link(mode, role):
    path = straight(40, 60, role=role)
    idle = engaged(path, lambda s: np.where((s > 30) & (s < 60), 0.0, LIMIT))
    planned = plan_feeds(path, idle, rules(mode))
    links = planned.roles == Role.LINK
    ends = np.cumsum(planned.lengths)
    if role is Role.FINISH:
        assert not links.any()
        return
    assert planned.lengths[links].sum() == pytest.approx(30 - 0.2 * RADIUS, abs=2 * SPACING)
    assert (ends - planned.lengths)[links].min() > 30 and ends[links].max() < 60
    assert (planned.feeds[links] == LINK_FEED).all()


@pytest.mark.parametrize("mode", list(FeedMode))
def test_ways_down_between_cuts_without_stock_keep_their_feeds(mode):
    builder = ToolpathBuilder((0.0, 0.0, 5.0))
    builder.line((0.0, 0.0, 0.0), 0.1 * FEED, Role.ENTRY)
    builder.line((40.0, 0.0, 0.0), FEED, Role.CUT)
    builder.rapid(LINK_FEED, z=5.0)
    builder.rapid(LINK_FEED, y=20.0)
    builder.line((40.0, 20.0, 0.0), 0.1 * FEED, Role.ENTRY)
    builder.line((0.0, 20.0, 0.0), FEED, Role.CUT)
    path = builder.build()
    # air from X20 on, and no sample on moves straight up and down
    stock = Stock.of(box(-40, -40, 20, 60))
    engagement = along_path(path, RADIUS, axial_depth=5.0, top=5.0, stock=stock)
    planned = plan_feeds(path, engagement, rules(mode))
    assert (planned.roles == Role.LINK).sum() >= 2
    entries = planned.roles == Role.ENTRY
    assert (planned.feeds[entries] <= 0.1 * FEED).all() and entries.sum() == 2
    assert ((planned.roles == Role.AIR) == (planned.kinds == Kind.RAPID)).all()


@pytest.mark.parametrize("mode", list(FeedMode))
def test_a_short_way_without_stock_is_no_link(mode):
    path = straight(100)
    idle = engaged(path, lambda s: np.where(abs(s - 50) < 0.4 * RADIUS, 0.0, LIMIT))
    assert not (plan_feeds(path, idle, rules(mode)).roles == Role.LINK).any()


def test_lap_along_the_wall_is_never_raised():
    path = straight(50, role=Role.FINISH)
    planned = plan_feeds(path, engaged(path, lambda s: 0.1), rules(FeedMode.CHIP_THICKNESS))
    assert planned.feeds == pytest.approx(FEED)


def test_linear_slowdown_is_full_at_the_specified_depth_and_slowed_at_the_largest():
    depths = np.array([1.0, 1.5, 1.75, 2.0, 2.5])
    ratios = linear_slowdown(depths, 1.5, 2.0, 0.75)
    np.testing.assert_allclose(ratios, [1.0, 1.0, 0.875, 0.75, 0.75])


def test_linear_slowdown_of_a_pocket_with_a_slot_and_corners():
    path, largest = straight(30, 200), math.radians(90.0)

    def angle(s):  # a slot, then laps whose corners are deeper
        corners = LIMIT + (largest - LIMIT) * (np.sin(2 * np.pi * s / 50) > 0.6)
        return np.where(s < 30, np.pi, corners)

    planned = plan_feeds(path, engaged(path, angle), rules(FeedMode.LINEAR_SLOWDOWN))
    slowed = RUNG ** math.floor(math.log(0.75 * (1 + DEAD_BAND)) / math.log(RUNG))
    stations = np.linspace(1, 229, 500)
    feeds = feeds_at(planned, stations)
    assert feeds[stations < 28] == pytest.approx(FEED * slowed, abs=ROUNDING)
    assert feeds.min() == pytest.approx(FEED * slowed, abs=ROUNDING)
    assert feeds[stations > 40].max() == pytest.approx(FEED)
    changes = np.flatnonzero(np.diff(feeds[stations > 40]))
    assert len(changes) == 8  # waves: down and up at each of four corners


def test_only_the_slow_down_touches_entries():
    path = straight(60, role=Role.ENTRY)
    engagement = engaged(path, lambda s: np.pi)
    for mode in FeedMode:
        slower = plan_feeds(path, engagement, rules(mode)).feeds < FEED
        assert slower.all() if mode is FeedMode.LINEAR_SLOWDOWN else not slower.any()


def test_links_and_rapids_have_their_own_feeds():
    builder = ToolpathBuilder((0, 0, 5))
    builder.rapid(100.0, z=0)
    builder.line((20, 0, 0), FEED, Role.CUT)
    builder.line((20, 20, 0), FEED, Role.LINK)
    builder.line((0, 20, 0), FEED, Role.CUT)
    path = builder.build()
    for mode in FeedMode:
        planned = plan_feeds(path, engaged(path, lambda s: LIMIT), rules(mode))
        np.testing.assert_allclose(planned.feeds, [100.0, FEED, LINK_FEED, FEED])


# --- invariants ---------------------------------------------------------------------------

shares = st.lists(st.floats(0.0, 1.0), min_size=2, max_size=40)
moves = st.lists(st.floats(0.05, 30.0), min_size=1, max_size=20)


def chip_thickness(feeds: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Return the thickest chip over that of the programmed feed at the limit."""
    return feeds * np.sin(np.minimum(angles, np.pi / 2)) / (FEED * math.sin(LIMIT))


@settings(deadline=None, max_examples=60)
@given(shares, moves, st.sampled_from(FeedMode), st.floats(0.1, 50.0))
def test_feed_is_nowhere_above_what_is_allowed(angles, lengths, mode, radius):
    path = straight(*lengths)
    knots = np.linspace(0, sum(lengths), len(angles))
    engagement = engaged(path, lambda s: np.pi * np.interp(s, knots, angles))
    if not len(engagement.moves):
        return
    planned = plan_feeds(path, engagement, rules(mode, cutter_radius=radius))
    stations = stations_of(path, engagement.moves, engagement.points)
    links = planned.roles[moves_at(planned, stations)] == Role.LINK
    phi, feeds = engagement.angles, feeds_at(planned, stations)
    # only what meets no stock becomes a link
    assert np.all(phi[links] == 0)
    assert np.all(feeds[links] == LINK_FEED)
    phi, feeds = phi[~links], feeds[~links]
    if mode is FeedMode.LINEAR_SLOWDOWN:
        depths = 1 - np.cos(phi)
        largest = depths[phi < SLOT].max(initial=0.0)
        ratios = linear_slowdown(depths, 1 - math.cos(LIMIT), largest, 0.75)
        allowed = FEED * np.where(phi >= SLOT, 0.75, ratios) * (1 + DEAD_BAND)
        assert np.all(feeds <= allowed + 1e-9)
        return
    assert np.all(chip_thickness(feeds, phi) <= CHIP_BOUND)
    # far above the limit slower than equal chips: the engaged arc is longer
    far = phi > 1.3 * LIMIT
    assert np.all(feeds[far] < FEED)
    largest = {FeedMode.CONSTANT: 1.0, FeedMode.CHIP_THICKNESS: 2.0}[mode]
    assert np.all(feeds <= FEED * largest)


@settings(deadline=None, max_examples=40)
@given(shares, moves)
def test_geometry_stays_and_moves_are_only_split(angles, lengths):
    path = straight(*lengths)
    knots = np.linspace(0, sum(lengths), len(angles))
    engagement = engaged(path, lambda s: np.pi * np.interp(s, knots, angles))
    planned = plan_feeds(path, engagement, rules(FeedMode.CHIP_THICKNESS))
    assert planned.lengths.sum() == pytest.approx(path.lengths.sum())
    kept = {tuple(p) for p in planned.points}
    assert {tuple(p) for p in path.points} <= kept
    assert planned.lengths.min() > 0


def test_arcs_are_split_on_their_circles():
    builder = ToolpathBuilder((20, 0, 0))
    builder.arc((-20, 0, -1), (0, 0), True, FEED, Role.CUT)
    builder.arc((20, 0, 0), (0, 0), True, FEED, Role.CUT)
    path = builder.build()
    engagement = engaged(path, lambda s: np.where(abs(s - 60) < 15, 2 * LIMIT, LIMIT))
    planned = plan_feeds(path, engagement, rules(FeedMode.CONSTANT))
    assert len(planned) == 4
    np.testing.assert_allclose(np.hypot(*planned.points[:, :2].T), 20.0)
    assert planned.lengths.sum() == pytest.approx(path.lengths.sum())
    assert np.all(np.abs(planned.sweeps) <= np.pi + 1e-9)


def test_runs_are_long_and_few():
    rng = np.random.default_rng(3)
    path = straight(*rng.uniform(0.1, 0.6, 2000))
    noise = rng.normal(0, 0.15, 10_000)
    engagement = engaged(path, lambda s: LIMIT * (0.8 + noise[: len(s)]))
    least = 6.0
    wide = rules(FeedMode.CHIP_THICKNESS, cutter_radius=least / LEAST_RUN)
    planned = plan_feeds(path, engagement, wide)
    starts = np.flatnonzero(np.r_[True, np.diff(planned.feeds) != 0])
    runs = np.add.reduceat(planned.lengths, starts)
    assert runs[1:-1].min() > least - 2 * 0.6  # edges go to ends of moves
    assert len(planned) <= len(path) + len(runs)


@settings(deadline=None, max_examples=150)
@given(
    st.lists(st.tuples(st.floats(0.1, 10), st.integers(-5, 8)), min_size=1, max_size=40),
    st.floats(0.0, 20.0),
)
def test_lengthened_runs_are_below_and_long(steps, least):
    lengths, rungs = (np.array(v) for v in zip(*steps, strict=True))
    edges = np.r_[0.0, np.cumsum(lengths)]
    new_edges, new = lengthen_runs(edges, rungs, least, RUNG)
    assert (new_edges[0], new_edges[-1]) == (edges[0], edges[-1])
    assert np.all(np.diff(new_edges) > 0)
    middles = (np.unique(np.r_[edges, new_edges])[1:] + np.unique(np.r_[edges, new_edges])[:-1]) / 2
    before = rungs[np.searchsorted(edges, middles) - 1]
    after = new[np.searchsorted(new_edges, middles) - 1]
    assert np.all(after <= before)
    assert after.min() == before.min()
    short = np.diff(new_edges) < min(least, edges[-1]) - 1e-9
    # what is still short is a dip next to another: nothing may be raised to lengthen it
    padded = np.r_[np.inf, new, np.inf]
    assert np.all((padded[:-2] > padded[1:-1])[short] & (padded[2:] > padded[1:-1])[short])


def test_runs_far_along_a_path_come_to_an_end():
    rng = np.random.default_rng(0)
    for _ in range(100):  # rounding of stations once kept a run short for ever
        lengths = rng.uniform(0.05, 3, rng.integers(3, 40))
        edges = 5000 * rng.random() + np.r_[0.0, np.cumsum(lengths)]
        least = rng.uniform(0.3, 3)
        new_edges, rungs = lengthen_runs(edges, rng.integers(-5, 8, len(lengths)), least, RUNG)
        assert len(new_edges) == len(rungs) + 1


def test_path_without_moves_or_samples():
    empty = ToolpathBuilder((0, 0, 0)).build()
    none = Engagement(np.zeros((0, 3)), *np.zeros((3, 0)), np.zeros(0, int))
    assert len(plan_feeds(empty, none, rules(FeedMode.CONSTANT))) == 0
    path = straight(10, 20)
    np.testing.assert_array_equal(
        plan_feeds(path, none, rules(FeedMode.CHIP_THICKNESS)).feeds, path.feeds
    )


@pytest.mark.parametrize(
    "change",
    [
        {"slowed": 0.0},
        {"slowed": 1.1},
        {"largest_ratio": 0.9},
        {"machine_speed": 0.0},
    ],
)
def test_values_that_make_no_sense_are_refused(change):
    with pytest.raises(ValueError, match=next(iter(change))):
        rules(FeedMode.CONSTANT, **change)


# --- stations -----------------------------------------------------------------------------


def test_stations_of_points_on_lines_and_arcs():
    builder = ToolpathBuilder((0, 0, 0))
    builder.line((10, 0, 0), FEED, Role.CUT)
    builder.arc((0, 10, 3), (0, 0), True, FEED, Role.CUT)
    builder.arc((10, 0, 0), (0, 0), False, FEED, Role.CUT)
    path = builder.build()
    moves = np.repeat([0, 1, 2], 5)
    fractions = np.tile([0.0, 0.25, 0.5, 0.75, 1.0], 3)
    points = points_at(path, moves, fractions)
    np.testing.assert_allclose(fractions_of(path, moves, points), fractions, atol=1e-9)
    begins = np.cumsum(path.lengths) - path.lengths
    expected = begins[moves] + fractions * path.lengths[moves]
    np.testing.assert_allclose(stations_of(path, moves, points), expected, atol=1e-8)
