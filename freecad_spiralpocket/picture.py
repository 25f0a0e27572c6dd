# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of planned pockets: the path in the plane, colored by engagement.

Shows the deepest level of each pocket, but for a thin last one, on which the cutter is
loaded less, in the outline of its top where walls are slanted, as measured on the finished
path: where the color stays below the mark on the color bar, the cutter is loaded no more
than on a straight cut at the step-over. Needs matplotlib, which FreeCAD's own packages carry;
everything is drawn without a window.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import shapely
from numpy.typing import NDArray

from .engine.errors import SetupError
from .engine.levels import Level, levels_of
from .engine.model import Floats, Plan
from .engine.shapes.region import polygons_of
from .engine.toolpath import Kind, Role
from .trace import loaded_level

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from shapely import Polygon

#: Longest side of the drawing and its resolution.
WIDTH, DPI = 16.0, 130  # in, 1/in
#: Heights closer than this are one level [mm].
SAME_HEIGHT = 1e-3
#: A smaller engagement is none [rad].
UNLOADED = np.radians(1)
#: Angles per drawn chord of an arc [rad].
ARC_STEP = np.radians(6)

WALL, ISLAND, SLOPE, OUTLINE = "#f4f4f2", "#cfcfca", "#dcdcd7", "#30302e"
ENTRY_COLOR, LINK_COLOR, IDLE_COLOR, RAPID_COLOR = "#d6248f", "#5b6770", "#a9c4de", "#9a9a9a"
COLOR_MAP = "turbo"
#: The color bar reaches at least this multiple of the limit: at the limit the path is yellow, what
#: is red is overloaded.
LIMIT_SHARE = 1.6


def check(path: str | os.PathLike[str]) -> None:
    """Check that pictures can be drawn, and into such a file.

    Raises
    ------
    SetupError
    """
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure  # noqa: F401
    except ImportError as error:
        raise SetupError(
            "Drawing the path needs the Python library matplotlib, which this FreeCAD lacks.",
            "Install it with the Addon Manager or pip, or leave the picture out.",
        ) from error
    kind = Path(path).suffix.lstrip(".").lower()
    if kind not in FigureCanvasAgg.get_supported_filetypes():
        raise SetupError(f"Cannot write {path}: it is no picture's name.", "Name a .png file.")


def draw(plans: Sequence[Plan], path: str | os.PathLike[str], title: str = "") -> None:
    """Draw the pockets into a picture file.

    Parameters
    ----------
    plans : sequence of Plan
        At least one.
    path : path-like
        Its ending chooses the format: png, svg, pdf.
    title : str, optional

    Raises
    ------
    SetupError
        If matplotlib is missing or the file cannot be written.
    """
    check(path)
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=_size(plans), dpi=DPI, layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    for plan in plans:
        draw_pocket(axes, plan)
        draw_moves(axes, plan)
    _draw_rapids(axes, plans)
    _draw_engagement(figure, axes, plans)
    _finish(axes, title)
    try:
        figure.savefig(path, bbox_inches="tight")  # labels beside wide axes are cut off else
    except OSError as error:
        raise SetupError(
            f"Cannot write {path}: {error.strerror}.", "Choose another file."
        ) from error


def _size(plans: Sequence[Plan]) -> tuple[float, float]:
    """Return the figure's size [in] for the pockets' common bounds."""
    bounds = np.array([_mouth(p).bounds for p in plans])
    width, height = bounds[:, 2:].max(axis=0) - bounds[:, :2].min(axis=0)
    scale = min(WIDTH / width, 0.6 * WIDTH / height)
    return max(8.0, width * scale + 2.0), max(4.0, height * scale + 1.2)


def draw_pocket(axes: Axes, plan: Plan) -> None:
    """Draw what is around the path: walls, air beside the stock, islands, what stays uncut."""
    pocket, mouth = plan.request.pocket, _mouth(plan)
    axes.fill(*np.array(mouth.exterior.coords).T, facecolor=SLOPE, edgecolor=OUTLINE, lw=0.6)
    axes.fill(*np.array(pocket.exterior.coords).T, facecolor=WALL, edgecolor=OUTLINE, lw=1.2)
    if plan.request.stock is not None:
        for part in polygons_of(shapely.difference(pocket, plan.request.stock)):
            axes.fill(*np.array(part.exterior.coords).T, facecolor="white", edgecolor=SLOPE, lw=1.2)
            for standing in part.interiors:
                axes.fill(*np.array(standing.coords).T, facecolor=WALL, edgecolor=SLOPE, lw=1.2)
    for island in pocket.interiors:
        axes.fill(*np.array(island.coords).T, facecolor=ISLAND, edgecolor=OUTLINE, lw=1.2, zorder=3)
    uncut = plan.report.uncut
    for part in uncut.geoms:
        axes.fill(*np.array(part.exterior.coords).T, color="#d73027", alpha=0.35, zorder=2)


def _mouth(plan: Plan) -> Polygon:
    """Return the outline of a pocket at its top."""
    sections = plan.request.sections
    return (sections[0].mouth or sections[0].pocket) if sections else plan.request.pocket


def draw_moves(axes: Axes, plan: Plan) -> None:
    """Draw entries, links, and below the colored path what cuts nothing."""
    roles, heights, level = plan.toolpath.roles, plan.toolpath.points[:, 2], _shown(plan)
    deepest = np.abs(heights - level.bottom) < SAME_HEIGHT
    downwards = heights < level.top + SAME_HEIGHT
    downwards &= heights > level.bottom - SAME_HEIGHT
    for role, color, width, label, order in (
        (Role.ENTRY, ENTRY_COLOR, 1.6, "entry", 5),
        (Role.LINK, LINK_COLOR, 0.6, "link at depth", 3.5),
        (Role.CUT, IDLE_COLOR, 0.9, "cut without load", 3.4),
        (Role.FINISH, IDLE_COLOR, 0.9, "cut without load", 3.4),
    ):
        chosen = np.flatnonzero((roles == role) & (downwards if role == Role.ENTRY else deepest))
        if len(chosen):
            axes.plot(*_polyline(plan, chosen).T, color=color, lw=width, label=label, zorder=order)


def _shown(plan: Plan) -> Level:
    """Return the lowest level on which the cutter is loaded as on others."""
    report, roles = plan.report, plan.toolpath.roles
    height = plan.toolpath.points[:, 2].min()
    is_cut = np.isin(roles[report.engagement_moves], (Role.CUT, Role.FINISH))
    if is_cut.any():
        height = loaded_level(report.engagement_points[is_cut, 2], report.engagement_angles[is_cut])
    return min(levels_of(plan.request), key=lambda level: abs(level.bottom - height))


def _polyline(plan: Plan, chosen: NDArray[np.int64]) -> Floats:
    """Return the chosen moves as points, shape (n, 2), with a gap after each."""
    moves = plan.toolpath
    starts, ends = moves.starts[chosen, :2], moves.points[chosen, :2]
    centers, sweeps, is_arc = moves.centers[chosen], moves.sweeps[chosen], moves.is_arc[chosen]
    gap = np.full((1, 2), np.nan)
    parts = []
    for start, end, center, sweep, arc in zip(starts, ends, centers, sweeps, is_arc, strict=True):
        points = _arc(start, center, sweep) if arc else np.vstack([start, end])
        parts += [points, gap]
    return np.concatenate(parts)


def _arc(start: Floats, center: Floats, sweep: float) -> Floats:
    first = np.arctan2(*(start - center)[::-1])
    angles = first + np.linspace(0, sweep, max(2, int(abs(sweep) / ARC_STEP) + 1))
    return center + np.hypot(*(start - center)) * np.c_[np.cos(angles), np.sin(angles)]


def _draw_rapids(axes: Axes, plans: Sequence[Plan]) -> None:
    """Draw rapids in the plane, within pockets and from one to the next."""
    lines, here = [], None
    for plan in plans:
        moves = plan.toolpath
        if here is not None:
            lines.append(np.array([here, moves.start[:2]]))
        ends = zip(moves.starts[:, :2], moves.points[:, :2], moves.kinds, strict=True)
        lines += [np.array([a, b]) for a, b, kind in ends if kind == Kind.RAPID]
        here = moves.points[-1, :2]
    lines = [line for line in lines if np.hypot(*(line[1] - line[0])) > SAME_HEIGHT]
    for number, line in enumerate(lines):
        label = "rapid" if number == 0 else None
        axes.plot(*line.T, color=RAPID_COLOR, lw=0.9, ls=(0, (4, 3)), label=label, zorder=4)


def _draw_engagement(figure: Figure, axes: Axes, plans: Sequence[Plan]) -> None:
    from matplotlib.collections import LineCollection
    from matplotlib.colors import Normalize

    parts = [measured_stretches(p) for p in plans]
    segments = np.concatenate([s for s, _ in parts])
    angles = np.degrees(np.concatenate([a for _, a in parts]))
    limit = np.degrees(max(p.report.engagement_limit for p in plans))
    top = max(limit * LIMIT_SHARE, float(angles.max(initial=0.0)))
    lines = LineCollection(
        list(segments), cmap=COLOR_MAP, norm=Normalize(0, top), lw=1.1, zorder=4, capstyle="round"
    )
    lines.set_array(angles)
    axes.add_collection(lines)
    beside = axes.inset_axes((1.03, 0.0, 0.012, 1.0))
    bar = figure.colorbar(lines, cax=beside)
    bar.set_label("engagement angle [deg]")
    beside.axhline(limit, color="black", lw=2)
    beside.set_title(f"limit {limit:.0f}", fontsize=9)


def measured_stretches(plan: Plan) -> tuple[Any, Any]:
    """Return the stretches between measured places on the lowest level and their angles."""
    points, angles = plan.report.engagement_points, plan.report.engagement_angles
    if len(points) < 2:
        return np.empty((0, 2, 2)), np.empty(0)
    low = np.abs(points[:, 2] - _shown(plan).bottom) < SAME_HEIGHT
    step = np.hypot(*np.diff(points[:, :2], axis=0).T)
    near = step < plan.request.cutter_radius
    loaded = angles[1:] > UNLOADED
    chosen = np.flatnonzero(low[:-1] & low[1:] & near & loaded)
    return np.stack([points[chosen, :2], points[chosen + 1, :2]], axis=1), angles[chosen + 1]


def _finish(axes: Axes, title: str) -> None:
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.margins(0.02)
    axes.set_xlabel("X [mm]")
    axes.set_ylabel("Y [mm]")
    axes.spines[["top", "right"]].set_visible(False)
    if title:
        axes.set_title(title, loc="left", fontsize=12)
    handles, labels = axes.get_legend_handles_labels()
    unique = dict(zip(labels, handles, strict=True))
    axes.legend(
        unique.values(),
        unique.keys(),
        loc="lower right",
        bbox_to_anchor=(1.0, 1.0),
        ncols=4,
        frameon=False,
        borderaxespad=0.2,
    )
