# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets and requests that several tests share."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import strategies as st
from shapely import Point, Polygon, box

from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, Plan, PocketRequest
from freecad_spiralpocket.engine.toolpath import Kind, Role

HEIGHTS = Heights(
    clearance=8.0, safe=3.0, start_depth=0.0, final_depth=-5.0, step_down=6.0, finish_depth=0.0
)
FEEDS = Feeds(horizontal=50.0, vertical=12.5, horizontal_rapid=83.0, vertical_rapid=83.0)


def regular(
    n: int, radius: float, turn: float = 0.0, center: tuple[float, float] = (0.0, 0.0)
) -> Polygon:
    """Return a regular polygon of `n` corners on a circle."""
    x, y = center
    angles = [turn + 2 * math.pi * i / n for i in range(n)]
    return Polygon([(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles])


def rounded(polygon: Polygon, radius: float) -> Polygon:
    """Return `polygon` with its convex corners rounded."""
    return polygon.buffer(-radius).buffer(radius, quad_segs=32)


def opened(pocket: Polygon, radius: float) -> Polygon:
    """Return what a cutter clears of a pocket."""
    return pocket.buffer(-radius, quad_segs=64).buffer(radius, quad_segs=64)


#: LM15's test shapes: triangle, square and pentagon for a 6 mm cutter.
TRIANGLE = rounded(regular(3, 54 / math.sqrt(3), math.pi / 2), 4.0)
SQUARE = rounded(box(0, 0, 44, 44), 4.0)
PENTAGON = rounded(regular(5, 27.0, math.pi / 2), 4.0)
CIRCLE = Point(10, 5).buffer(30, quad_segs=256)
L_SHAPE = Polygon([(0, 0), (80, 0), (80, 30), (30, 30), (30, 80), (0, 80)])
DUMBBELL = box(-50, -20, -15, 20).union(box(15, -20, 50, 20)).union(box(-20, -6, 20, 6))
TEE = rounded(box(-45, 0, 45, 24).union(box(-14, -50, 14, 10)), 3.5)
RING = box(0, 0, 60, 60).difference(Point(30, 30).buffer(8))
ISLANDS = (
    box(0, 0, 80, 60)
    .difference(Point(22, 30).buffer(7))
    .difference(box(45, 20, 55, 34))
    .difference(Point(64, 44).buffer(4))
)


def request(pocket: Polygon, **changes) -> PocketRequest:
    """Return a request for `pocket` with a 6 mm cutter at a 40 % step-over."""
    values = {
        "pocket": pocket,
        "tool_diameter": 6.0,
        "heights": HEIGHTS,
        "feeds": FEEDS,
        "cutting": Cutting(stepover=2.4),
    }
    values.update(changes)
    return PocketRequest(**values)


def no_tick(done: float) -> None:
    """Never cancel."""


def lifts(result: Plan) -> int:
    """Return how often the cutter leaves the stock."""
    z = np.concatenate([result.toolpath.start[2:], result.toolpath.points[:, 2]])
    top = result.request.heights.start_depth
    return int(((z[1:] > top) & (z[:-1] <= top)).sum())


def assert_ways_down_are_fed(result: Plan) -> None:
    """Fail where the cutter goes straight down faster than its vertical feed, or a rapid is none.

    Only rapids, which are above what was cleared, may do so.
    """
    path, feeds = result.toolpath, result.request.feeds
    steps = path.points - path.starts
    rapid = path.kinds == Kind.RAPID
    down = (steps[:, 2] < 0) & (np.hypot(steps[:, 0], steps[:, 1]) < 1e-9) & ~rapid
    assert down.any()
    assert path.feeds[down].max() <= feeds.vertical
    assert (path.roles[rapid] == Role.AIR).all() and (path.roles[~rapid] != Role.AIR).all()


@st.composite
def convex_pockets(draw) -> Polygon:
    """Draw a convex pocket, 25 to 90 mm across."""
    count = draw(st.integers(3, 9))
    angles = sorted(
        draw(st.lists(st.floats(0, 2 * math.pi), min_size=count, max_size=count, unique=True))
    )
    a, b = draw(st.floats(20, 45)), draw(st.floats(20, 45))
    hull = Polygon(
        [(a * math.cos(t), b * math.sin(t)) for t in (*angles, 0.3, 2.4, 4.5)]
    ).convex_hull
    return rounded(hull, draw(st.floats(0.0, 4.0)))


@st.composite
def crossed_bars(draw) -> Polygon:
    """Draw a pocket of two to four bars that overlap: bends, tees, crosses and steps."""
    count = draw(st.integers(2, 4))
    x = y = 0.0
    shape = Polygon()
    for i in range(count):
        long, wide = draw(st.floats(14, 40)), draw(st.floats(6.0, 16))
        half = (long, wide) if i % 2 == 0 else (wide, long)
        shape = shape.union(box(x - half[0], y - half[1], x + half[0], y + half[1]))
        x += draw(st.floats(-0.8, 0.8)) * half[0]
        y += draw(st.floats(-0.8, 0.8)) * half[1]
    return Polygon(rounded(Polygon(shape.exterior), draw(st.floats(0.0, 4.0))).exterior)
