# SPDX-License-Identifier: LGPL-2.1-or-later
# runs in: freecadcmd
"""The five strategies and FreeCAD's Adaptive, offset and zigzag on the same pockets.

    ./dev bench comparison [SHAPE...]      all shapes if none is named
    ./dev bench comparison_pictures        draws what this has left in build/bench

All run with the same cutter, depth, step-over and feeds, and all are measured by the same proof.
FreeCAD's operations are computed in a document that is closed afterwards, with their defaults
but for step-over and pattern. Figures of the rib are of its nine pockets together. The table
is written to build/bench/comparison.md after each shape; the last line is one JSON object.
"""

from __future__ import annotations

import json
import pickle
import sys
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import FreeCAD
import numpy as np
import Part
from feed_modes import POCKETS
from paper_pockets import big, hug
from shapely import Polygon

from freecad_spiralpocket import machines, report
from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.errors import CancelledError, SpiralPocketError
from freecad_spiralpocket.engine.model import Plan, PocketRequest, Strategy
from freecad_spiralpocket.engine.motion.analysis import absolute_curvature, weighted_quantiles
from freecad_spiralpocket.engine.motion.timing import time_of
from freecad_spiralpocket.engine.proof.findings import over_limit
from freecad_spiralpocket.engine.proof.verify import prove
from freecad_spiralpocket.engine.shapes.arcs import fit_arcs
from freecad_spiralpocket.engine.toolpath import Toolpath
from freecad_spiralpocket.op import compat, foresight, operation
from freecad_spiralpocket.op.floors import find_floors

if compat.IS_LEGACY:
    from PathScripts import PathAdaptive as Adaptive
    from PathScripts import PathPocketShape as PocketShape
else:
    from Path.Op import Adaptive, PocketShape

ROOT = Path(__file__).resolve().parents[1]
OUT = ROOT / "build" / "bench"
STEP_OVER = 40  # percent of the cutter's diameter
FEED, RAPID = 3000 / 60, 5000 / 60  # mm/s
#: Presets whose times are shown; strategies plan for the first.
MACHINES = {"vmc": "VMC", "hobby_router": "router", "ucp710": "UCP710"}
#: One strategy may plan all pockets of a shape for so long, in CPU time [s].
LONGEST = 150.0
#: Outlines become lines and arcs that keep this near to them [mm].
FITTED = 0.001


@dataclass(frozen=True)
class Shape:
    """A part with pockets: one round a polygon, or the sample rib."""

    diameter: float
    depth: float
    pocket: Polygon | None = None

    def solid(self) -> Any:
        """Return the part, its top wherever it is."""
        if self.pocket is None:
            return Part.read(str(ROOT / "examples" / "rib.step"))
        x0, y0, x1, y1 = self.pocket.bounds
        corner = FreeCAD.Vector(x0 - 10, y0 - 10, -self.depth - 4)
        block = Part.makeBox(x1 - x0 + 20, y1 - y0 + 20, self.depth + 4, corner)
        tool = Part.Face(wire(self.pocket))
        tool.translate(FreeCAD.Vector(0, 0, -self.depth))
        return block.cut(tool.extrude(FreeCAD.Vector(0, 0, self.depth + 1)))


SHAPES = {name: Shape(6.0, 2.0, pocket) for name, pocket in POCKETS.items()}
SHAPES |= {"hug": Shape(10.0, 5.0, hug()), "big": Shape(10.0, 5.0, big()), "rib": Shape(12.0, 12.0)}


def wire(polygon: Polygon) -> Any:
    """Return the outline of a polygon as lines and arcs."""
    points = np.array(polygon.exterior.coords)
    fitted = fit_arcs(points, FITTED)
    edges, begin = [], 0
    for end, center in zip(fitted.ends, fitted.centers, strict=True):
        a, b = (FreeCAD.Vector(*points[i], 0) for i in (begin, end))
        if np.isnan(center[0]):
            edges.append(Part.makeLine(a, b))
        else:
            chord = points[(begin + end) // 2] - center
            radius = np.hypot(*(points[begin] - center))
            middle = FreeCAD.Vector(*(center + chord * radius / np.hypot(*chord)), 0)
            edges.append(Part.Arc(a, middle, b).toShape())
        begin = end
    return Part.Wire(edges)


def make_job(shape: Shape) -> Any:
    """Return a job for the part in a new document."""
    document = FreeCAD.newDocument("Comparison")
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape.solid()
    document.recompute()
    job = compat.PathJob.Create("Job", [part], None)
    job.Stock.ExtZpos = 0
    controller = job.Tools.Group[0]
    compat.set_end_mill(controller, shape.diameter)
    controller.HorizFeed, controller.VertFeed = FEED, FEED / 4
    job.SetupSheet.HorizRapid = job.SetupSheet.VertRapid = RAPID
    for _ in range(3):  # the tool's own shape follows its diameter only after some recomputes
        document.recompute()
    return job


def new(create: Any, job: Any, face: str) -> Any:
    """Return a new operation on one face, not yet computed."""
    with compat.supplied_tool_controller(job.Tools.Group[0]):
        op = create("Operation", parentJob=job)
    op.ToolController = job.Tools.Group[0]
    op.Base = [(job.Model.Group[0], (face,))]
    op.StepOver = STEP_OVER
    return op


def request_of(job: Any, face: str) -> PocketRequest:
    """Return what our operation would ask for on a face."""
    op = new(operation.Create, job, face)
    (found,) = foresight.requests_of(op).requests
    job.Document.removeObject(op.Name)
    return replace(found, machine=machines.load(next(iter(MACHINES))))


def planned(strategy: Strategy, job: Any, requests: dict[str, PocketRequest]) -> list[Plan]:
    """Return the plans of all pockets by one strategy."""
    until = time.process_time() + LONGEST

    def late(done: float, stage: str) -> bool:
        return time.process_time() > until

    return [plan(replace(r, strategy=strategy), late) for r in requests.values()]


def computed(create: Any, pattern: str, job: Any, requests: dict[str, PocketRequest]) -> list[Plan]:
    """Return what FreeCAD's operation makes of all pockets, proved as ours is."""
    found = []
    for face, request in requests.items():
        op = new(create, job, face)
        if pattern:
            setattr(op, next(n for n in PATTERNS if hasattr(op, n)), pattern)
        job.Document.recompute()
        path = report.from_operation(op).toolpath
        job.Document.removeObject(op.Name)
        found.append(Plan(request, path, prove(request, path)))
    return found


#: What FreeCAD's Pocket calls its pattern, in 1.1 and before.
PATTERNS = ("ClearingPattern", "OffsetPattern")
METHODS = {s.value: lambda *a, s=s: planned(s, *a) for s in Strategy} | {
    "FreeCAD Adaptive": lambda *a: computed(Adaptive.Create, "", *a),
    "FreeCAD Pocket, offset": lambda *a: computed(PocketShape.Create, "Offset", *a),
    "FreeCAD Pocket, zigzag": lambda *a: computed(PocketShape.Create, "ZigZag", *a),
}


def figures(plans: list[Plan]) -> dict[str, Any]:
    """Return the figures of one method on one shape."""
    parts = [absolute_curvature(p.toolpath) for p in plans]
    curvature, lengths = (np.concatenate(each) for each in zip(*parts, strict=True))
    cut95, cut99 = weighted_quantiles(curvature, lengths, [0.95, 0.99])
    reports = [p.report for p in plans]
    return {
        "times": {m: round(sum(seconds(p.toolpath, m) for p in plans), 1) for m in MACHINES},
        "length": round(sum(r.cut_length for r in reports)),
        "largest": round(float(np.degrees(max(r.engagement_max for r in reports)))),
        "p99": round(float(np.degrees(max(r.engagement_p99 for r in reports)))),
        "over": any(r.engagement_p99 > over_limit(r.engagement_limit) for r in reports),
        "cut95": round(float(cut95), 2),
        "cut99": round(float(cut99), 2),
        "uncut": round(sum(r.uncut_area for r in reports), 2),
        "gouge": round(max(r.gouge for r in reports), 3),
        "rapid_hit": round(sum(r.rapid_hit for r in reports), 1),
    }


def seconds(path: Toolpath, machine: str) -> float:
    """Return the time of a path on a preset machine [s]."""
    return float(time_of(path, machines.load(machine)).total)


def measure(name: str) -> dict[str, Any]:
    """Return the figures of all methods on a shape, and leave its plans in a file."""
    job = make_job(SHAPES[name])
    faces = sorted(find_floors(job.Model.Group[0]), key=lambda f: f.face.BoundBox.XMin)
    requests = {f.name: request_of(job, f.name) for f in faces}
    results: dict[str, Any] = {}
    kept: dict[str, Any] = {}
    for method, make in METHODS.items():
        began = time.process_time()
        kept[method] = []
        try:
            kept[method] = make(job, requests)
            results[method] = figures(kept[method])
        except CancelledError:
            results[method] = {"refused": f"stopped after {LONGEST:.0f} s of planning"}
        except SpiralPocketError as error:
            results[method] = {"refused": error.message}
        spent = round(time.process_time() - began, 1)
        print(f"{name}: {method}: {results[method]} in {spent} s", flush=True)
    FreeCAD.closeDocument(job.Document.Name)
    limit = round(float(np.degrees(next(iter(requests.values())).engagement_limit)))
    (OUT / f"comparison-{name}.pickle").write_bytes(pickle.dumps(kept))
    return {"limit": limit, "pockets": len(requests), "methods": results}


def table(name: str, found: dict[str, Any]) -> str:
    """Return the figures of a shape as a section of a page."""
    shape, many = SHAPES[name], found["pockets"] > 1
    lines = [
        f"## {name}",
        "",
        f"{shape.diameter:g} mm cutter, {shape.depth:g} mm deep, limit {found['limit']}°"
        + (f", {found['pockets']} pockets together." if many else "."),
        "",
        f"![{name}](images/comparison-{name}.jpg)",
        "",
        "| | " + " | ".join(f"{m} s" for m in MACHINES.values()) + " | length m "
        "| largest ° | p99 ° | Cut95 1/mm | Cut99 1/mm | uncut mm² |",
        "|---|" + "---:|" * (len(MACHINES) + 6),
    ]
    for method, row in found["methods"].items():
        if "refused" in row:
            lines.append(f"| {method} | refused |" + " |" * (len(MACHINES) + 5))
            continue
        times = " | ".join(f"{row['times'][m]:.1f}" for m in MACHINES)
        p99 = f"**{row['p99']}**" if row["over"] else f"{row['p99']}"
        lines.append(
            f"| {method} | {times} | {row['length'] / 1000:.2f} | {row['largest']} | {p99} "
            f"| {row['cut95']:.2f} | {row['cut99']:.2f} | {row['uncut']:.2f} |"
        )
    refused = {m: row["refused"] for m, row in found["methods"].items() if "refused" in row}
    lines += ["", *(f"{method}: {why}" for method, why in refused.items())] if refused else []
    return "\n".join(lines) + "\n"


def main(wanted: list[str]) -> None:
    """Compare on the shapes that are wanted."""
    OUT.mkdir(parents=True, exist_ok=True)
    found: dict[str, Any] = {}
    for name in wanted or SHAPES:
        found[name] = measure(name)
        page = "\n".join(table(*each) for each in found.items())
        (OUT / "comparison.md").write_text(page, encoding="utf-8")
    print(json.dumps(found))


if __name__ == "__main__":
    main(sys.argv[1:])
