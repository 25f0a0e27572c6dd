# SPDX-License-Identifier: LGPL-2.1-or-later
"""Automatic as a whole: how a pocket lies must not matter; how planning grows; pictures.

    ./dev bench automatic            all of it
    ./dev bench automatic turned     five pockets turned by 15 degrees, mirrored, shifted, scaled
    ./dev bench automatic growth     planning time and memory against the number of islands; a plot
    ./dev bench automatic pictures   pictures of pockets, colored by engagement

Pictures go to build/bench. $SPIRALPOCKET_POCKETS may name a folder of pockets to draw too: one
JSON object each with `outer` and `holes`, rings of [x, y] in mm, `tool`, the cutter's diameter, and
`ae`, the step-over. The last line is one JSON object with the figures.
"""

from __future__ import annotations

import json
import os
import resource
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import matplotlib as mpl
import numpy as np
from shapely import MultiPoint, Point, Polygon, box, union_all
from shapely.affinity import rotate, scale, translate

from freecad_spiralpocket import machines
from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, Plan, PocketRequest
from freecad_spiralpocket.engine.proof.findings import TOUCH
from freecad_spiralpocket.picture import draw

OUT = Path(__file__).parent.parent / "build" / "bench"
#: Numbers of islands, as rows of a square plate.
ROWS = (1, 2, 4, 6, 8, 10, 12, 14)
PITCH, ISLAND = 25.0, 6.0


def rounded(shape: Polygon, radius: float) -> Polygon:
    """Return `shape` with all corners rounded [mm]."""
    shape = shape.buffer(-radius).buffer(radius, quad_segs=32)
    return shape.buffer(radius).buffer(-radius, quad_segs=32)


def pockets() -> dict[str, Polygon]:
    """Return pockets of five kinds: compact, bent, necked, branched, with islands."""
    fork = union_all([box(0, 0, 110, 20), *(box(x, 0, x + 16, 60) for x in (0, 47, 94))])
    holes = union_all([Point(28, 40).buffer(11), Point(80, 52).buffer(8), box(52, 12, 72, 30)])
    return {
        "square": rounded(box(0, 0, 50, 50), 4.0),
        "bent": rounded(box(0, 0, 90, 75).difference(box(30, 30, 90, 75)), 4.0),
        "necked": rounded(
            union_all([box(0, 0, 38, 38), box(60, 0, 98, 38), box(30, 14, 70, 24)]), 4
        ),
        "fork": rounded(fork, 4.0),
        "islands": rounded(box(0, 0, 110, 75), 5.0).difference(holes),
    }


def request(pocket: Polygon, tool: float = 6.0, stepover: float = 2.4) -> PocketRequest:
    """Return the request for a pocket, as deep as five sixths of the cutter."""
    depth = 5.0 / 6.0 * tool
    return PocketRequest(
        pocket,
        tool,
        Heights(tool, tool / 2, 0.0, -depth, depth),
        Feeds(50.0, 12.5, 83.0, 83.0),
        Cutting(stepover),
        tolerance=tool / 600,
        machine=machines.load("hobby_router"),
    )


def faults(made: Plan) -> list[str]:
    """Return what the proof finds wrong with a path."""
    report, tool = made.report, made.request.tool_diameter
    wrong = {
        "gouge": report.gouge > 0.01 * tool / 6,
        "uncut": report.uncut_area > 1e-4 * made.request.pocket.area,
        "rapid": report.rapid_hit > 0,
        "link": report.link_hit > TOUCH,
    }
    return [name for name, is_wrong in wrong.items() if is_wrong]


def variants(pocket: Polygon) -> Iterator[tuple[str, PocketRequest]]:
    """Yield a pocket turned, mirrored, shifted and scaled, with names."""
    for angle in range(0, 360, 15):
        yield f"turned {angle}", request(rotate(pocket, angle, origin=(0, 0)))
    yield "mirrored", request(scale(pocket, -1, 1, origin=(0, 0)))
    yield "shifted", request(translate(pocket, 1234.5, -987.6))
    for factor in (0.1, 10.0):
        grown = scale(pocket, factor, factor, origin=(0, 0))
        yield f"scaled {factor:g}", request(grown, 6.0 * factor, 2.4 * factor)


def turned() -> dict[str, object]:
    """Print how far the time of each pocket spreads over its variants, and what is wrong."""
    spread, wrong = {}, []
    for name, pocket in pockets().items():
        times = []
        for variant, asked in variants(pocket):
            made = plan(asked)
            wrong += [f"{name} {variant}: {fault}" for fault in faults(made)]
            if not variant.startswith("scaled"):
                times.append(made.report.time)
        spread[name] = round(float(np.ptp(times) / np.median(times)), 4)
        print(f"{name:8} {np.median(times):6.1f} s, spread {100 * spread[name]:.1f} %", flush=True)
    for line in wrong:
        print("wrong:", line)
    return {"spread": spread, "wrong": wrong}


def plate(rows: int) -> Polygon:
    """Return a square pocket with rows x rows round islands."""
    side = rows * PITCH
    places = (np.mgrid[:rows, :rows].reshape(2, -1).T + 0.5) * PITCH
    return rounded(box(0, 0, side, side), 4.0).difference(MultiPoint(places).buffer(ISLAND))


def growth() -> dict[str, object]:
    """Print and plot how planning grows with the number of islands."""
    mpl.use("Agg")
    from matplotlib import pyplot as plt

    islands, seconds = [], []
    for rows in ROWS:
        begun = time.process_time()
        made = plan(request(plate(rows)))
        seconds.append(round(time.process_time() - begun, 2))
        islands.append(rows * rows)
        print(
            f"{islands[-1]:4} islands {seconds[-1]:7.2f} s of planning, "
            f"{made.report.time:7.0f} s on the machine {' '.join(faults(made))}",
            flush=True,
        )
    n = np.array(islands, float)
    like = n * np.log(n + np.e)
    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    axes.loglog(islands, seconds, "o-", label="planning and proof")
    axes.loglog(islands, like * seconds[-1] / like[-1], "--", color="gray", label="n log n")
    axes.set_xlabel("islands")
    axes.set_ylabel("time (s)")
    axes.legend()
    figure.savefig(OUT / "growth.png", dpi=100)
    # on Linux in KB
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"peak memory {memory:.0f} MB")
    return {"islands": islands, "planning_s": seconds, "memory_mb": round(memory)}


def pictures() -> dict[str, object]:
    """Draw our pockets and those of $SPIRALPOCKET_POCKETS."""
    asked = {name: request(pocket) for name, pocket in pockets().items()}
    for file in sorted(Path(os.environ.get("SPIRALPOCKET_POCKETS", "/nowhere")).glob("*.json")):
        data = json.loads(file.read_text())
        made = request(Polygon(data["outer"], data["holes"]), data["tool"], data["ae"])
        asked[file.stem] = replace(made, heights=Heights(8.0, 3.0, 0.0, -5.0, 5.0), tolerance=0.01)
    for name, one in asked.items():
        made = plan(one)
        draw([made], OUT / f"automatic-{name}.png", f"{name}: {made.report.time:.1f} s")
    return {"pictures": len(asked)}


def main(wanted: list[str]) -> None:
    """Run the parts that are wanted, all without any."""
    OUT.mkdir(parents=True, exist_ok=True)
    parts = {"turned": turned, "growth": growth, "pictures": pictures}
    found = {}
    for name in wanted or parts:
        print(f"== {name}", flush=True)
        found.update(parts[name]())
    print(json.dumps(found))


if __name__ == "__main__":
    main(sys.argv[1:])
