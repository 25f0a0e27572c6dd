# SPDX-License-Identifier: LGPL-2.1-or-later
"""The papers' plots of a toolpath: engagement, feed direction, force, velocity, curvature.

Each function draws one `Study` (or several, to compare) into matplotlib axes. [LM15] figures
9 to 15, [CS08] figures 15 and 16, [HQS24] figures 11 to 13. Nothing here needs a window.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .engine.motion import analysis
from .engine.toolpath import Kind
from .study import Study

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LINE, LIGHT, LIMIT_COLOR, SECOND = "#1f5fa8", "#a9c4e4", "#c0392b", "#e08214"
#: Longest step between samples that is drawn as cutting, in cutter diameters.
_GAP = 0.5


def path_by_engagement(axes: Axes, study: Study) -> None:
    """Draw the path in the plane, colored by engagement angle."""
    angles = np.degrees(study.engagement.angles)
    colored_path(axes, study, angles, (0.0, 180.0), "engagement angle [deg]")


def engagement_along_path(axes: Axes, study: Study) -> None:
    """Draw the engagement angle over the arc length."""
    x, y = _broken(study, study.stations, np.degrees(study.engagement.angles))
    axes.plot(x, y, color=LINE, lw=0.7)
    if np.isfinite(study.setup.engagement_limit):
        limit = np.degrees(study.setup.engagement_limit)
        axes.axhline(limit, color=LIMIT_COLOR, lw=1, ls="--", label=f"limit {limit:.0f} deg")
        _legend(axes)
    axes.set(xlabel="arc length [mm]", ylabel="engagement angle [deg]", ylim=(0, 185))


def feed_direction_along_path(axes: Axes, study: Study) -> None:
    """Draw the feed direction, 2 pi more for each turn, over the arc length."""
    stations, directions = analysis.feed_direction(study.toolpath)
    axes.plot(stations, np.degrees(directions), color=LINE, lw=0.8)
    axes.set(xlabel="arc length [mm]", ylabel="feed direction [deg]")


def velocity_along_path(axes: Axes, study: Study) -> None:
    """Draw the machine's speed and the programmed feed over the arc length."""
    motion, path = study.motion, study.toolpath
    axes.plot(motion.distances, motion.speeds * 60, color=LINE, lw=0.7, label="machine")
    ends = np.cumsum(path.lengths)
    feeds = np.where(path.kinds == Kind.RAPID, np.nan, path.feeds) * 60
    axes.step(np.r_[0.0, ends], np.r_[feeds[:1], feeds], color=SECOND, lw=0.7, label="programmed")
    _legend(axes)
    axes.set(xlabel="arc length [mm]", ylabel="feed [mm/min]", ylim=(0, None))


def force_against_time(axes: Axes, study: Study) -> None:
    """Draw mean and peak force over the time."""
    x, peak = _broken(study, study.clock, study.forces.peak)
    _, mean = _broken(study, study.clock, study.forces.mean)
    axes.plot(x, peak, color=LIGHT, lw=0.6, label="peak of a revolution")
    axes.plot(x, mean, color=LINE, lw=0.7, label="mean of a revolution")
    _legend(axes)
    axes.set(xlabel="time [s]", ylabel="force [N]", ylim=(0, None))


def curvature_histogram(axes: Axes, study: Study) -> None:
    """Draw how much of the length has which absolute curvature, with Cut95 and Cut99."""
    curvature, lengths = study.curvature
    cuts = analysis.weighted_quantiles(curvature, lengths, [0.95, 0.99])
    top = max(1e-3, 1.5 * float(np.nan_to_num(cuts[1], posinf=10.0)))
    bins = np.linspace(0, top, 60).tolist()
    shares = lengths / max(lengths.sum(), 1e-9) * 100
    axes.hist(np.minimum(curvature, top), bins=bins, weights=shares, color=LINE)
    for cut, name, style in zip(cuts, ("Cut95", "Cut99"), ("--", ":"), strict=True):
        axes.axvline(cut, color=LIMIT_COLOR, ls=style, label=f"{name} {cut:.3f}")
    axes.set_yscale("log")
    _legend(axes)
    axes.set(xlabel="absolute curvature [1/mm]", ylabel="share of the length [%]")


def engagement_histogram(axes: Axes, study: Study) -> None:
    """Draw how much of the length and of the time has which engagement."""
    angles, bins = np.degrees(study.engagement.angles), list(range(0, 181, 3))
    for weights, name, color in (
        (study.engagement.lengths, "length", LINE),
        (study.times, "time", SECOND),
    ):
        share = weights / max(float(weights.sum()), 1e-9) * 100
        axes.hist(angles, bins, weights=share, histtype="step", color=color, label=f"of the {name}")
    _legend(axes)
    axes.set(xlabel="engagement angle [deg]", ylabel="share [%]")


def _legend(axes: Axes) -> None:
    """Write the legend above the axes, where it hides nothing."""
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.98), ncols=2, frameon=False)


def colored_path(
    axes: Axes, study: Study, values: np.ndarray, bounds: tuple[float, float], label: str
) -> None:
    """Draw the stretches between neighboring samples, colored by the later one's value."""
    from matplotlib.collections import LineCollection

    xy = study.engagement.points[:, :2]
    near = np.flatnonzero(_steps(study) < _GAP * study.setup.cutter.diameter)
    segments = np.stack([xy[near], xy[near + 1]], axis=1)
    lines = LineCollection(list(segments), cmap="turbo", lw=0.9, capstyle="round")
    lines.set_array(values[near + 1])
    lines.set_clim(*bounds)
    axes.add_collection(lines)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set(xlabel="X [mm]", ylabel="Y [mm]")
    axes.figure.colorbar(lines, ax=axes, label=label)


def _steps(study: Study) -> np.ndarray:
    """Return the distances of neighboring samples [mm]."""
    return np.linalg.norm(np.diff(study.engagement.points, axis=0), axis=1)


def _broken(study: Study, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return a curve with breaks where the cutter was out of the stock between samples."""
    breaks = np.flatnonzero(_steps(study) > _GAP * study.setup.cutter.diameter) + 1
    return np.insert(x, breaks, np.nan), np.insert(y, breaks, np.nan)
