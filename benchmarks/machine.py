# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine time, engagement and proof: against published and independent figures, and how fast.

    ./dev bench machine [--programs FOLDER --readings FILE]

The options may also come from $SPIRALPOCKET_PROGRAMS and $SPIRALPOCKET_READINGS. FOLDER holds
G-code, FILE what an independent program measured on it, one JSON object:

    {"square.spiral.ngc": {
        "pocket": {"outer": [[x, y], ...], "holes": [...], "tool": 6.0, "ae": 2.4},
        "depth": 5.0, "feed": 3000.0,
        "engage_p99_deg": 85.0, "engage_mean_deg": 62.2, "uncut_pct": 0.0, "gouge_mm": 0.005,
        "time_s": {"hobby_router": 42.3, "vmc": 35.3},
        "errors": []}, ...}

with the cutter's diameter and the largest radial depth of cut in mm, engagement after the
entry, feed in mm/min. Programs with errors are left out. The last line is one JSON object.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
from chatelain import circle, residuals, root_mean_square
from shapely import Point, Polygon

from freecad_spiralpocket import gcode, machines
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, PocketRequest
from freecad_spiralpocket.engine.motion.timing import time_of
from freecad_spiralpocket.engine.proof.verify import prove
from freecad_spiralpocket.engine.toolpath import Role, Toolpath, ToolpathBuilder

#: HQS24's programmed feed, m/min.
HQS24_FEED = 10.0
MM_PER_S = 1000 / 60  # of 1 m/min
STRAIGHT = 1000.0  # mm
RADII = (2, 5, 10, 20)  # mm
MOVES, CHORD = 10_000, 0.45  # -, mm
REPEATS = 5


def stop_loss() -> float:
    """Return what one full stop costs at HQS24's feed on its machine [s]."""
    feed = HQS24_FEED * MM_PER_S
    builder = ToolpathBuilder((0, 0, 0))
    builder.line((STRAIGHT, 0, 0), feed, Role.CUT)
    # half of it is lost while stopping, half while starting
    return time_of(builder.build(), machines.load("ucp710")).total - STRAIGHT / feed


def circle_speeds() -> dict[str, float]:
    """Return the speed on circles by radius [mm], on HQS24's machine [m/min]."""
    mikron = machines.load("ucp710")
    feed = HQS24_FEED * MM_PER_S
    return {
        str(r): round(float(time_of(circle(r, feed), mikron).speeds.max()) / MM_PER_S, 2)
        for r in RADII
    }


def request_for(
    pocket: Polygon, tool: float, ae: float, depth: float, feed: float
) -> PocketRequest:
    """Return the request that a program of one level answers, feed in mm/min."""
    return PocketRequest(
        pocket,
        tool,
        Heights(depth + 5, 2.0, 0.0, -depth, depth),
        Feeds(feed / 60, feed / 240, 5000 / 60, 5000 / 60),
        Cutting(ae),
    )


def spiral_of(moves: int) -> tuple[PocketRequest, Toolpath]:
    """Return a round pocket and an Archimedean spiral of as many chords."""
    step, tool = 2.4, 6.0
    # arc length of the spiral r = step * angle / (2 pi), inverted
    lengths = CHORD * np.arange(1, moves + 1)
    angles = np.sqrt(4 * math.pi * lengths / step)
    radii = step * angles / (2 * math.pi)
    builder = ToolpathBuilder((0, 0, 0))
    builder.line((0, 0, -5), 12.5, Role.ENTRY)
    points = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])
    for x, y in points:
        builder.line((x, y, -5.0), 50.0, Role.CUT)
    pocket = Point(0, 0).buffer(radii[-1] + tool / 2 + 0.1, quad_segs=64)
    return request_for(pocket, tool, step, 5.0, 3000.0), builder.build()


def seconds_for_proof_and_time(moves: int) -> float:
    """Return how long engagement, proof and time of a path take, the best of a few [s]."""
    request, path = spiral_of(moves)
    request, best = replace(request, machine=machines.load("vmc")), math.inf
    for _ in range(REPEATS):
        begin = time.perf_counter()
        prove(request, path)
        best = min(best, time.perf_counter() - begin)
    return best


def compare(programs: Path, readings: Path) -> dict[str, float]:
    """Print our figures next to the independent ones and return the largest differences."""
    known = json.loads(readings.read_text())
    largest = {"p99_deg": 0.0, "mean_deg": 0.0, "uncut_pct": 0.0, "gouge_mm": 0.0, "time_pct": 0.0}
    print(f"{'program':24} {'ours less theirs':>16}:", *largest)
    for name, reading in sorted(known.items()):
        if reading.get("errors"):
            print(f"{name:24} left out: {reading['errors'][0][:60]!r}")
            continue
        program = (programs / name).read_text(encoding="utf-8", errors="replace")
        found = _differences(gcode.parse_program(program), reading)
        print(f"{name:24} {'':17}", *(f"{key} {value:+.3f}" for key, value in found.items()))
        for key, value in found.items():
            largest[key] = max(largest[key], abs(value))
    return largest


def _differences(path: Toolpath, reading: dict) -> dict[str, float]:
    """Return our figures less the independent ones."""
    outline = reading["pocket"]
    pocket = Polygon(outline["outer"], outline["holes"])
    request = request_for(pocket, outline["tool"], outline["ae"], reading["depth"], reading["feed"])
    report = prove(request, path)
    times = [
        100 * (time_of(path, machines.load(name)).total / seconds - 1)
        for name, seconds in reading["time_s"].items()
    ]
    return {
        "p99_deg": math.degrees(report.engagement_p99) - reading["engage_p99_deg"],
        "mean_deg": math.degrees(report.engagement_mean) - reading["engage_mean_deg"],
        "uncut_pct": 100 * report.uncut_area / pocket.area - reading["uncut_pct"],
        "gouge_mm": report.gouge - reading["gouge_mm"],
        "time_pct": max(times, key=abs),
    }


def main() -> None:
    """Print the figures."""
    parser = argparse.ArgumentParser(description="Figures of machine time, engagement and proof.")
    for name in ("programs", "readings"):
        default = os.environ.get(f"SPIRALPOCKET_{name.upper()}")
        parser.add_argument(f"--{name}", type=Path, default=default and Path(default))
    args = parser.parse_args()
    rms = root_mean_square(residuals(machines.load("huron_840d")))
    print(f"CS08 table 2: 30 times of the Huron, {rms:.4f} s rms")
    stop, speeds = stop_loss(), circle_speeds()
    print(f"HQS24: a stop at {HQS24_FEED:g} m/min on the UCP710 costs {stop:.3f} s")
    print(f"HQS24: circles of radius {speeds} m/min")
    seconds = seconds_for_proof_and_time(MOVES)
    print(f"engagement, proof and time of {MOVES} moves: {seconds:.2f} s")
    if args.programs and args.readings:
        largest = compare(args.programs, args.readings)
    else:
        print("No independent readings were given (--programs, --readings): nothing to compare.")
        largest = {}
    print(
        json.dumps(
            {
                "cs08_rms_s": round(rms, 4),
                "ucp710_stop_s": round(stop, 3),
                "ucp710_circle_m_per_min": speeds,
                "judge_p99_deg": _rounded(largest.get("p99_deg")),
                "judge_time_pct": _rounded(largest.get("time_pct")),
                "judge_gouge_mm": _rounded(largest.get("gouge_mm")),
                "seconds_10k": round(seconds, 3),
            }
        )
    )


def _rounded(value: float | None) -> float | None:
    """Return `value` with three decimals."""
    return None if value is None else round(value, 3)


if __name__ == "__main__":
    main()
