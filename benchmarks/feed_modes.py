# SPDX-License-Identifier: LGPL-2.1-or-later
"""LM15's triangle, square and pentagon: spiral against conventional paths, and the feed modes.

Repeats the comparison of [LM15] section 5 by simulation: Linear Morph, contour-parallel and
direction-parallel with a 6 mm cutter, 2 mm deep, steps of 3 to 4 mm; the paper does not
dimension its pockets. Then the three feed modes on the spiral, as [CS08] figures 15 and 16.

    ./dev bench feed_modes [FOLDER]     with a folder, the plots are written there

The last line is one JSON object.
"""

from __future__ import annotations

import json
import math
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from shapely import LineString, Point, Polygon, box
from shapely.geometry.polygon import orient

from freecad_spiralpocket import machines, plots
from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, PocketRequest, Strategy
from freecad_spiralpocket.engine.motion.analysis import time_ratio, weighted_quantiles
from freecad_spiralpocket.engine.motion.feed import FeedMode, FeedRules, plan_feeds
from freecad_spiralpocket.engine.motion.force import MATERIALS, Cutter
from freecad_spiralpocket.engine.toolpath import Role, Toolpath, ToolpathBuilder
from freecad_spiralpocket.study import Setup, Study

if TYPE_CHECKING:
    from matplotlib.axes import Axes

DIAMETER, DEPTH, CORNER = 6.0, 2.0, 8.0
SPIRAL_STEP, CONTOUR_STEP, ZIGZAG_STEP = 3.5, 3.0, 4.0
#: For the feed modes: chips only thin below half the diameter.
THIN_STEP = 1.8
#: LM15's feed, and one at which a machine's dynamics show [mm/s].
PAPER_FEED, FAST_FEED = 100 / 60, 3000 / 60
#: Over this length a change of engagement is a jump [mm].
JUMP_LENGTH = 0.3


def regular(n: int, radius: float) -> Polygon:
    """Return a regular polygon with rounded corners."""
    angles = math.pi / 2 + 2 * math.pi * np.arange(n) / n
    sharp = Polygon(np.column_stack([radius * np.cos(angles), radius * np.sin(angles)]))
    return sharp.buffer(-CORNER).buffer(CORNER, quad_segs=64)


POCKETS = {
    "triangle": regular(3, 54 / math.sqrt(3)),
    "square": box(-22, -22, 22, 22).buffer(-CORNER).buffer(CORNER, quad_segs=64),
    "pentagon": regular(5, 27.0),
}


def spiral(pocket: Polygon, feed: float, step: float = SPIRAL_STEP) -> Toolpath:
    """Return the Linear Morph path at one feed."""
    path = plan(
        PocketRequest(
            pocket,
            DIAMETER,
            Heights(5.0, 2.0, 0.0, -DEPTH, DEPTH),
            Feeds(feed, feed / 4, 5000 / 60, 5000 / 60),
            Cutting(step, finishing_lap=False),
            strategy=Strategy.LINEAR_MORPH,
        )
    ).toolpath
    is_cut = (path.roles == Role.CUT) | (path.roles == Role.FINISH)
    return replace(path, feeds=np.where(is_cut, feed, path.feeds))


def contour_parallel(pocket: Polygon, feed: float) -> Toolpath:
    """Return offsets of the wall from the inside outwards, joined by straight steps."""
    rings, center = [], pocket.buffer(-DIAMETER / 2, join_style="mitre")
    while not center.is_empty:
        rings.append(center.exterior)
        center = center.buffer(-CONTOUR_STEP, join_style="mitre")
    start = np.array(rings[-1].coords[0])
    builder = _plunge(start, feed)
    for ring in reversed(rings):
        line = LineString(orient(Polygon(ring)).exterior.coords)
        at = line.project(Point(start))
        along = [line.interpolate(at), *(line.interpolate(s) for s in _after(line, at))]
        start = np.array(along[0].coords[0])
        for point in along:
            builder.line((point.x, point.y, -DEPTH), feed, Role.CUT)
    return builder.build()


def direction_parallel(pocket: Polygon, feed: float) -> Toolpath:
    """Return a zigzag and a lap along the wall."""
    center = pocket.buffer(-DIAMETER / 2)
    x0, y0, x1, y1 = center.bounds
    rows = np.linspace(y0 + 0.01, y1 - 0.01, math.ceil((y1 - y0) / ZIGZAG_STEP) + 1)
    points: list[tuple[float, float]] = []
    for number, y in enumerate(rows):
        ends = sorted(center.intersection(LineString([(x0 - 1, y), (x1 + 1, y)])).coords)
        points += ends if number % 2 == 0 else ends[::-1]
    builder = _plunge(np.array(points[0]), feed)
    for x, y in points[1:]:
        builder.line((x, y, -DEPTH), feed, Role.CUT)
    return builder.build()


def _after(line: LineString, at: float) -> list[float]:
    """Return the stations of a ring's corners in order from `at` once around."""
    steps = np.hypot(*np.diff(np.array(line.coords), axis=0).T)
    stations = np.cumsum(steps)
    return [*stations[stations > at + 1e-6], *stations[stations < at - 1e-6], at]


def _plunge(start: np.ndarray, feed: float) -> ToolpathBuilder:
    """Return a path that has gone straight down at `start`."""
    builder = ToolpathBuilder((*start, 1.0))
    builder.line((*start, -DEPTH), feed / 4, Role.ENTRY)
    return builder


STRATEGIES = {
    "Linear Morph": spiral,
    "contour-parallel": contour_parallel,
    "direction-parallel": direction_parallel,
}


def study(path: Toolpath, step: float = SPIRAL_STEP) -> Study:
    """Return the study of a path with LM15's cutter and spindle."""
    return Study(
        path,
        Setup(
            cutter=Cutter(DIAMETER, flutes=3),
            machine=machines.load("hobby_router"),
            material=MATERIALS["Aluminum 6082-T6"],
            spindle_speed=1500 / 60,
            axial_depth=DEPTH,
            engagement_limit=math.acos(1 - 2 * step / DIAMETER),
        ),
    )


def jumps(measured: Study) -> float:
    """Return the largest change of engagement within `JUMP_LENGTH` after the entry [deg].

    The lowest 1 % of the length is left out: places where the path has just begun.
    """
    cutting = measured.toolpath.roles[measured.engagement.moves] != Role.ENTRY
    stations = measured.stations[cutting]
    angles = np.degrees(measured.engagement.angles[cutting])
    begun = stations > stations[0] + math.pi * DIAMETER
    stations, angles = stations[begun], angles[begun]
    later = np.interp(stations + JUMP_LENGTH, stations, angles)
    return float(np.abs(later - angles).max())


def compare(name: str, pocket: Polygon) -> dict[str, dict[str, float]]:
    """Print LM15's figure 15 for one pocket and return it."""
    found = {}
    for title, make in STRATEGIES.items():
        measured, fast = study(make(pocket, PAPER_FEED)), study(make(pocket, FAST_FEED))
        angles, lengths = np.degrees(measured.engagement.angles), measured.engagement.lengths
        p99 = float(weighted_quantiles(angles, lengths, np.array([0.99]))[0])
        found[title] = {
            "length_mm": round(float(measured.toolpath.lengths.sum()), 0),
            "mean_force_N": round(
                float(np.average(measured.forces.mean, weights=measured.times)), 1
            ),
            "mean_engagement_deg": round(float(np.average(angles, weights=lengths)), 1),
            "p99_engagement_deg": round(p99, 1),
            "jump_deg": round(jumps(measured), 1),
            "eta_100": round(time_ratio(measured.toolpath, measured.motion), 4),
            "eta_3000": round(time_ratio(fast.toolpath, fast.motion), 4),
        }
        print(f"{name:9} {title:18} {found[title]}")
    return found


def with_mode(path: Toolpath, mode: FeedMode) -> Toolpath:
    """Return the thin spiral with its feeds planned."""
    measured = study(path, THIN_STEP)
    limit = measured.setup.engagement_limit
    rules = FeedRules(mode, DIAMETER / 2, limit, link_feed=5000 / 60, machine_speed=5000 / 60)
    return plan_feeds(path, measured.engagement, rules)


def path_by_feed(axes: Axes, study: Study) -> None:
    """Draw the path in the plane, colored by programmed feed."""
    path = study.toolpath
    feeds = path.feeds[study.engagement.moves] * 60
    bounds = (0.0, float(feeds[np.isfinite(feeds)].max(initial=1.0)))
    plots.colored_path(axes, study, feeds, bounds, "programmed feed [mm/min]")


def draw(name: str, pocket: Polygon, folder: Path) -> None:
    """Write the plots of one pocket."""
    from matplotlib.figure import Figure

    rows = (
        plots.path_by_engagement,
        plots.engagement_along_path,
        plots.feed_direction_along_path,
        plots.force_against_time,
    )
    figure = Figure(figsize=(16, 15), layout="constrained")
    axes = figure.subplots(4, 3, height_ratios=(2.2, 1, 1, 1), sharey="row")
    for column, (title, make) in enumerate(STRATEGIES.items()):
        measured = study(make(pocket, PAPER_FEED))
        for row, plot in enumerate(rows):
            plot(axes[row, column], measured)
        axes[0, column].set_title(title)
    figure.savefig(folder / f"engagement-{name}.png", dpi=80)
    path = spiral(pocket, FAST_FEED, THIN_STEP)
    figure = Figure(figsize=(16, 12), layout="constrained")
    axes = figure.subplots(4, 3, height_ratios=(2.2, 1, 1, 1), sharey="row")
    for column, mode in enumerate(FeedMode):
        measured = study(with_mode(path, mode), THIN_STEP)
        measured = Study(measured.toolpath, replace(measured.setup, spindle_speed=15000 / 60))
        path_by_feed(axes[0, column], measured)
        plots.engagement_along_path(axes[1, column], measured)
        plots.velocity_along_path(axes[2, column], measured)
        plots.force_against_time(axes[3, column], measured)
        changes = int((np.diff(measured.toolpath.feeds) != 0).sum())
        axes[0, column].set_title(
            f"{mode.value}: {measured.motion.total:.1f} s, {changes} changes of feed"
        )
    figure.savefig(folder / f"feed-{name}.png", dpi=80)


def main(arguments: list[str]) -> None:
    """Print the comparison and write the plots where asked."""
    results: dict[str, dict] = {}
    for name, pocket in POCKETS.items():
        results[name] = compare(name, pocket)
        path = spiral(pocket, FAST_FEED, THIN_STEP)
        times = {mode.value: study(with_mode(path, mode)).motion.total for mode in FeedMode}
        print(f"{name:9} seconds at F3000 by feed mode: {times}")
        results[name]["feed_mode_s"] = {mode: round(t, 2) for mode, t in times.items()}
        if arguments:
            draw(name, pocket, Path(arguments[0]))
    print(json.dumps(results))


if __name__ == "__main__":
    main(sys.argv[1:])
