# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of what `./dev bench comparison` has measured, one of each shape, all methods in it.

    ./dev bench comparison_pictures [FOLDER]      docs/images if none is given

The last line is one JSON object: how large each picture is [kB].
"""

from __future__ import annotations

import json
import pickle
import sys
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from freecad_spiralpocket import picture
from freecad_spiralpocket.engine.model import Plan
from freecad_spiralpocket.engine.toolpath import Kind

ROOT = Path(__file__).resolve().parents[1]
LARGEST = 200_000  # bytes
WIDTH, MARGIN = 16.0, 1.0  # in, mm
#: Pockets longer than this over their height stand two in a row, others four.
LONG = 2.0


def draw(kept: dict[str, list[Plan]], target: Path) -> int:
    """Draw all methods on a shape; return the size of the file [bytes]."""
    first = next(plans for plans in kept.values() if plans)
    bounds = np.array([p.request.pocket.bounds for p in first])
    low, high = bounds[:, :2].min(axis=0), bounds[:, 2:].max(axis=0)
    width, height = high - low
    columns = 2 if width > LONG * height else 4
    rows = -(-len(kept) // columns)
    cell = WIDTH / columns
    figure = Figure(figsize=(WIDTH, rows * (cell * height / width + 0.35)), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False)
    limit = np.degrees(first[0].report.engagement_limit)
    norm = Normalize(0, 180)
    for axes in panels.flat:
        axes.axis("off")
    for axes, (method, plans) in zip(panels.flat, kept.items(), strict=False):
        axes.set_title(method if plans else f"{method}: refused", fontsize=12)
        axes.set_aspect("equal")
        for plan in plans:
            draw_pocket(axes, plan, norm)
        axes.set_xlim(low[0] - MARGIN, high[0] + MARGIN)
        axes.set_ylim(low[1] - MARGIN, high[1] + MARGIN)
    lines = LineCollection([], cmap=picture.COLOR_MAP, norm=norm)
    bar = figure.colorbar(lines, ax=panels, shrink=0.8, aspect=40, pad=0.01)
    bar.set_label("engagement angle [deg]")
    bar.ax.axhline(limit, color="black", lw=2)
    for quality in range(85, 25, -10):
        figure.savefig(target, dpi=90, pil_kwargs={"quality": quality})
        if target.stat().st_size <= LARGEST:
            break
    return target.stat().st_size


def draw_pocket(axes: Any, plan: Plan, norm: Any) -> None:
    """Draw one pocket: what is cut in color, rapids at depth dashed, what stays in red."""
    picture.draw_pocket(axes, plan)
    picture.draw_moves(axes, plan)
    path = plan.toolpath
    low = path.points[:, 2] < path.points[:, 2].min() + picture.SAME_HEIGHT
    for i in np.flatnonzero(low & (path.kinds == Kind.RAPID)):
        both = np.vstack([path.starts[i, :2], path.points[i, :2]])
        axes.plot(*both.T, color=picture.RAPID_COLOR, lw=0.6, ls="--")
    segments, angles = picture.measured_stretches(plan)
    lines = LineCollection(segments, cmap=picture.COLOR_MAP, norm=norm, lw=1.0, zorder=4)
    lines.set_array(np.degrees(angles))
    axes.add_collection(lines)


def main(folder: Path) -> None:
    """Draw all shapes that were measured."""
    sizes = {}
    for file in sorted((ROOT / "build" / "bench").glob("comparison-*.pickle")):
        with file.open("rb") as stream:
            kept = pickle.load(stream)
        size = draw(kept, folder / f"{file.stem}.jpg")
        sizes[file.stem.partition("-")[2]] = round(size / 1000)
    print(json.dumps(sizes))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if sys.argv[1:] else ROOT / "docs" / "images")
