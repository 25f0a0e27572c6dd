# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pocket with slanted walls, cut by the outline of its floor and level by level.

After Chatelain et al. 2008, section 3.2: a floor of 100 x 60 mm, corners of 10 mm, walls of
10, 15, 20 and 30 degrees, with a drafted island. Their figure 19 cuts down inside the floor's
outline and leaves all stock above the slopes; figure 20 follows the slopes. Printed for
several step downs and for every strategy: levels, planning and machine time, what stays on the
walls, and how deep the cutter gets into them: in 3D, against the walls themselves at the height
of each place of the path. Strategies that refuse islands cut the pocket without it. With a file
name as argument the levels are drawn there.
"""

import json
import math
import sys
import time

import numpy as np
import shapely
from shapely import Point, Polygon, box

from freecad_spiralpocket.engine import PocketRequest, plan
from freecad_spiralpocket.engine.errors import SpiralPocketError
from freecad_spiralpocket.engine.levels import floors, levels_of
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, Plan, Section, Strategy
from freecad_spiralpocket.engine.toolpath import Kind

WIDTH, HEIGHT, RADIUS, DEPTH = 100.0, 60.0, 10.0, 24.0  # mm
ANGLES = (10.0, 15.0, 20.0, 30.0)  # of the walls at low X, high X, low Y, high Y [deg]
ISLAND, ISLAND_RADII = (50.0, 30.0), (12.0, 6.0)  # center, radii at the floor and at the top
TOOL, STEPOVER = 12.0, 0.4
FEEDS = Feeds(50.0, 12.5, 83.0, 83.0)
STEP_DOWNS = (24.0, 12.0, 6.0, 3.0)
DRAWN = 6.0
#: Places along the path, and heights on its ramps, are so far apart [mm].
STEP, RAMP = 0.2, 0.1
#: A smaller engagement is none [deg].
UNLOADED = 1.0


def free_at(z: float, island: bool = True) -> Polygon:
    """Return what the part leaves free at height `z`, with or without its island."""
    left, right, front, back = ((z + DEPTH) * math.tan(math.radians(a)) for a in ANGLES)
    outer = box(-left, -front, WIDTH + right, HEIGHT + back)
    outer = outer.buffer(-RADIUS).buffer(RADIUS, quad_segs=64)
    low, high = ISLAND_RADII
    radius = low + (high - low) * (z + DEPTH) / DEPTH
    return outer.difference(Point(ISLAND).buffer(radius, quad_segs=64)) if island else outer


def request(
    step_down: float,
    slanted: bool = True,
    strategy: Strategy = Strategy.AUTOMATIC,
    island: bool = True,
) -> PocketRequest:
    """Return the request, by the walls' sections or by the floor's outline alone."""
    heights = Heights(15.0, 3.0, 0.0, -DEPTH, step_down)
    tops = [0.0, *floors(heights)]
    shapes = [free_at(z, island) for z in tops]
    sections = zip(tops[1:], shapes[1:], shapes[:-1], strict=True)
    return PocketRequest(
        shapes[-1],
        TOOL,
        heights,
        FEEDS,
        Cutting(STEPOVER * TOOL),
        strategy=strategy,
        sections=tuple(Section(*each) for each in sections) if slanted else (),
    )


def stock_left(wanted: PocketRequest, island: bool = True) -> float:
    """Return the volume that stays above the slopes [mm3]."""
    left = 0.0
    for level in levels_of(wanted):
        middles = np.linspace(level.bottom, level.top, 21)
        areas = [free_at(z, island).area - level.pocket.area for z in middles]
        left += (level.top - level.bottom) * float(np.mean(areas))
    return left


def depth_in_walls(made: Plan, island: bool) -> float:
    """Return how far the cutter gets into the walls, looked at along the whole path in 3D [mm].

    No wall leans over the floor, so at each place the walls are nearest at the cutter's tip. On
    ramps they are taken from a little farther down.
    """
    stations, worst = [], 0.0
    path = made.toolpath
    for kind, start, end, center in zip(
        path.kinds, path.starts, path.points, path.centers, strict=True
    ):
        if start[2] >= 0 and end[2] >= 0:
            continue
        stations.append(places(Kind(kind), start, end, center))
    points = np.vstack(stations)
    points = points[points[:, 2] < -1e-9]
    levels = np.array([level.bottom for level in levels_of(made.request)])
    flat = np.abs(points[:, 2][:, None] - levels).min(axis=1) < 1e-6
    heights = np.where(flat, points[:, 2], np.floor(points[:, 2] / RAMP) * RAMP)
    for z in np.unique(np.round(heights, 6)):
        here = shapely.points(points[np.abs(heights - z) < 1e-5, :2])
        walls = free_at(max(z, -DEPTH), island)
        shapely.prepare(walls.boundary)
        off = shapely.distance(walls.boundary, here)
        off = np.where(shapely.contains(walls, here), off, -off)
        worst = max(worst, TOOL / 2 - float(off.min()))
    return worst


def places(kind: Kind, start: np.ndarray, end: np.ndarray, center: np.ndarray) -> np.ndarray:
    """Return places along a move, shape (n, 3) [mm]."""
    u, v = start[:2] - center, end[:2] - center
    turn, length = 0.0, float(np.linalg.norm(end - start))
    if kind in (Kind.ARC_CW, Kind.ARC_CCW):
        side = 1 if kind is Kind.ARC_CCW else -1
        angle = side * math.atan2(u[0] * v[1] - u[1] * v[0], u @ v) % (2 * math.pi)
        turn = side * (angle or 2 * math.pi)
        length = abs(turn) * float(np.hypot(*u))
    share = np.linspace(0.0, 1.0, math.ceil(length / STEP) + 1)[:, None]
    found = start + share * (end - start)
    if turn:
        angle = math.atan2(u[1], u[0]) + share[:, 0] * turn
        found[:, :2] = center + np.hypot(*u) * np.column_stack([np.cos(angle), np.sin(angle)])
    return found


def row(name: str, wanted: PocketRequest, island: bool = True) -> float:
    """Print what comes of a request; return how far the cutter gets into the walls [mm]."""
    start = time.process_time()
    made = plan(wanted)
    seconds, report = time.process_time() - start, made.report
    deep = depth_in_walls(made, island)
    print(
        f"{name:>32} {len(levels_of(wanted)):6d} {seconds:6.1f} s {report.time:6.0f} s "
        f"{report.step_width:4.1f} x {report.step_height:4.1f} mm "
        f"{stock_left(wanted, island) / 1000:5.1f} cm3 {deep:6.4f} mm",
        flush=True,
    )
    return deep


def main() -> None:
    """Print the tables, then one JSON object; draw the levels if asked."""
    print(
        f"{'':>32} {'levels':>6} {'planned':>8} {'machine':>8} {'steps':>14} {'left':>9} "
        f"{'in walls':>9}"
    )
    for slanted in (False, True):
        for step_down in STEP_DOWNS:
            row(
                f"{step_down:.0f} mm, by {'sections' if slanted else 'the floor'}",
                request(step_down, slanted),
            )
    found = {}
    for strategy in Strategy:
        for island in (True, False):
            name = f"{strategy.value}, {'island' if island else 'no island'}"
            try:
                found[name] = round(row(name, request(DRAWN, True, strategy, island), island), 4)
            except SpiralPocketError as error:
                print(f"{name:>32} refused: {error.message}")
    print(json.dumps({"depth_in_walls_mm": found, "largest_mm": max(found.values())}))
    if len(sys.argv) > 1:
        draw(sys.argv[1])


def draw(path: str) -> None:
    """Draw the levels from above, colored by engagement, and all of them from the side."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.collections import LineCollection
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

    made = plan(request(DRAWN))
    levels = levels_of(made.request)
    figure = Figure(figsize=(14, 6.4), layout="constrained")
    FigureCanvasAgg(figure)
    grid = figure.add_gridspec(2, len(levels), height_ratios=(1.0, 1.15))
    x0, y0, x1, y1 = levels[0].mouth.bounds
    norm = Normalize(0, 1.6 * math.degrees(made.report.engagement_limit))
    for column, level in enumerate(levels):
        axes = figure.add_subplot(grid[0, column])
        _fill(axes, level.mouth, "#cfcfca")
        _fill(axes, level.pocket, "#f4f4f2")
        lines, angles = _stretches(made.report, level.bottom)
        drawn = LineCollection(lines, cmap="turbo", norm=norm, lw=0.9)
        drawn.set_array(angles)
        axes.add_collection(drawn)
        axes.set(aspect="equal", xlim=(x0 - 2, x1 + 2), ylim=(y0 - 2, y1 + 2))
        axes.set_title(f"level {column + 1}, Z{level.bottom:g}", fontsize=10)
        axes.tick_params(labelsize=7)
    figure.colorbar(drawn, ax=figure.axes, shrink=0.9, aspect=12, label="engagement angle [deg]")
    _draw_side(figure.add_subplot(grid[1, :]), levels)
    figure.savefig(path, dpi=88)


def _stretches(report, z):
    """Return the loaded stretches of path at one height and their angles [deg]."""
    points, angles = report.engagement_points, np.degrees(report.engagement_angles)
    here = np.abs(points[:, 2] - z) < 1e-3
    near = np.hypot(*np.diff(points[:, :2], axis=0).T) < TOOL / 2
    loaded = angles[1:] > UNLOADED
    chosen = np.flatnonzero(here[:-1] & here[1:] & near & loaded)
    return np.stack([points[chosen, :2], points[chosen + 1, :2]], axis=1), angles[chosen + 1]


def _fill(axes, area, color):
    rings = [area.exterior, *area.interiors]
    axes.fill(*np.array(rings[0].coords).T, facecolor=color, edgecolor="#30302e", lw=0.8)
    for ring in rings[1:]:
        axes.fill(*np.array(ring.coords).T, facecolor="#9c9c96", edgecolor="#30302e", lw=0.8)


def _draw_side(axes, levels):
    """Draw the part and the steps along the line through the island, Y upwards as X."""
    y0, y1 = levels[0].mouth.bounds[1::2]
    across = np.linspace(y0 - 8, y1 + 8, 2001)
    spots = [Point(ISLAND[0], y) for y in across]
    heights = np.linspace(-DEPTH, 0.0, 241)
    free = np.array([[free_at(z).contains(p) for p in spots[::5]] for z in heights])
    part = np.where(free.any(axis=0), heights[np.argmax(free, axis=0)], 0.0)
    part = np.interp(across, across[::5], part)
    stock = np.zeros(len(across))
    for level in levels:
        stock[[level.pocket.contains(p) for p in spots]] = level.bottom
        axes.axhline(level.bottom, color="#b8b8b2", lw=0.6, ls=(0, (4, 3)), zorder=0)
    axes.fill_between(
        across, part, np.maximum(part, stock), color="#e8a33d", label="steps that stay"
    )
    axes.fill_between(across, -DEPTH - 6, part, color="#9c9c96", label="part")
    axes.set(aspect="equal", xlabel="Y [mm]", ylabel="Z [mm]")
    axes.set_xlim(across[0], across[-1])
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False, fontsize=9)
    axes.set_title(f"all levels from the side, at X{ISLAND[0]:g}", fontsize=10)


if __name__ == "__main__":
    main()
