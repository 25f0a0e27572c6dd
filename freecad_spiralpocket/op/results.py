# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was measured on the plans, written into the operation's properties.

The exact curve behind each spiral becomes a B-spline edge at the floor of its
pocket, pole by pole and knot by knot, so that it can be measured, used in
sketches and exported to STEP.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import FreeCAD
import numpy as np
import Part

from ..engine.model import Notice, Plan, SplineCurve
from . import properties, request
from .compat import parent_job

#: What is kept in a document keeps so many digits.
SAME = 1e-9


def write(obj: Any, plans: Sequence[Plan], notices: Sequence[Notice]) -> None:
    """Write the figures of all pockets together into the result properties of `obj`."""
    told = {"Notices": [str(n) for n in notices]}
    properties.set_results(obj, {**_figures(obj, plans), **told})
    obj.SpiralCurve = curves_shape(plans)


def are_of(obj: Any, plans: Sequence[Plan]) -> bool:
    """Return whether the figures of `obj` are those of these plans, as after it was opened."""
    return all(
        math.isclose(
            getattr(old := getattr(obj, name), "Value", old), figure, rel_tol=SAME, abs_tol=SAME
        )
        for name, figure in _figures(obj, plans).items()
    )


def _figures(obj: Any, plans: Sequence[Plan]) -> dict[str, float]:
    """Return the figures of all pockets together, by the names of the properties."""
    reports = [p.report for p in plans]
    timed = request.has_feeds(obj.ToolController)
    return {
        "LargestEngagement": float(np.degrees(max(r.engagement_max for r in reports))),
        "UncutArea": sum(r.uncut_area for r in reports),
        "Gouge": max(r.gouge for r in reports),
        "PathLength": sum(r.cut_length for r in reports),
        "MachiningTime": machining_time(plans) if timed else 0.0,
    }


def machining_time(plans: Sequence[Plan]) -> float:
    """Return the time of all pockets and the rapids between them [s]."""
    return start_times(plans)[-1] + plans[-1].report.time if plans else 0.0


def start_times(plans: Sequence[Plan]) -> list[float]:
    """Return when each pocket begins: after those before it and the rapids between them [s]."""
    times = [0.0]
    for before, after in pairwise(plans):
        way = after.toolpath.start[:2] - before.toolpath.points[-1, :2]
        rapid = float(np.hypot(*way)) / after.request.feeds.horizontal_rapid
        times.append(times[-1] + before.report.time + rapid)
    return times[: len(plans)]


def set_cycle_time(obj: Any, plans: Sequence[Plan]) -> None:
    """Replace FreeCAD's estimate, which knows one feed only and no helices."""
    if not plans:
        obj.CycleTime = "00:00:00"
    elif request.has_feeds(obj.ToolController):
        minutes, seconds = divmod(round(machining_time(plans)), 60)
        obj.CycleTime = f"{minutes // 60:02d}:{minutes % 60:02d}:{seconds:02d}"
    job = parent_job(obj)
    if job is not None:
        job.Proxy.getCycleTime()


def curves_shape(plans: Sequence[Plan]) -> Any:
    """Return the exact curves of all plans as one shape, empty if there are none."""
    edges = []
    for plan in plans:
        edges += [edge(curve) for curve in plan.curves]
    return Part.Compound(edges) if edges else Part.Shape()


def edge(curve: SplineCurve) -> Any:
    """Return `curve` as an edge at its height."""
    knots, multiplicities = np.unique(curve.knots, return_counts=True)
    spline = Part.BSplineCurve()
    spline.buildFromPolesMultsKnots(
        [FreeCAD.Vector(x, y, curve.height) for x, y in curve.control_points.tolist()],
        multiplicities.tolist(),
        knots.tolist(),
        False,
        curve.degree,
    )
    return spline.toShape()


def summary(obj: Any) -> list[str]:
    """Return a short report of the operation for the terminal, one line for each figure."""
    limit = max((p.report.engagement_limit for p in obj.Proxy.plans), default=0.0)
    bite = max((p.report.entry_bite for p in obj.Proxy.plans), default=0.0)
    missing, cut = len(obj.Proxy.errors), len(obj.Proxy.plans)
    minutes, seconds = divmod(round(obj.MachiningTime), 60)
    time = f"{minutes} min {seconds:02d} s" if obj.MachiningTime else "unknown, there are no feeds"
    return [
        f"time        {time}",
        f"length      {obj.PathLength.Value / 1000:.2f} m",
        f"engagement  {obj.LargestEngagement.Value:.0f} deg at most, "
        f"{np.degrees(limit):.0f} deg on a straight cut"
        if obj.LargestEngagement.Value
        else "engagement  the whole width, all of it is the way down",
        f"entry       {bite:.2f} mm deep at full width",
        f"uncut       {obj.UncutArea:.2f} mm2 in the cutter's reach",
        *([f"not cut     {missing} of {missing + cut} pockets"] if missing else []),
        f"gouge       {obj.Gouge.Value:.3f} mm",
        *(f"notice      {notice}" for notice in obj.Notices),
    ]
