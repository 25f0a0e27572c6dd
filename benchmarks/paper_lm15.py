# SPDX-License-Identifier: LGPL-2.1-or-later
"""[LM15]: the exact spiral, and its section 5 against conventional paths.

Triangle, square and pentagon for a 6 mm cutter, as the paper's, which prints no dimensions; and two
non-convex pockets for its section 3.2. What the paper states is printed beside what is found:
it shows forces and ratios as bars only. At its 100 mm/min the simulated machine slows for no path;
the ratios are told apart at 3000 mm/min.

    ./dev bench paper_lm15 [FOLDER]     with a folder, a picture is written there
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np
import shapely
from feed_modes import DIAMETER, POCKETS, SPIRAL_STEP, compare
from paper_pockets import pocket
from scipy.interpolate import BSpline
from shapely import LineString, Point, Polygon, box

from freecad_spiralpocket.engine.floor import Slot
from freecad_spiralpocket.engine.laps import linear_morph
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, PocketRequest, Strategy
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.shapes.splines import (
    periodic_beziers,
    sample_beziers,
    spiral_beziers,
)

#: Parameters at which the spiral is compared with equation 3.
PARAMETERS = 10_000
#: Planning is timed this often; the least counts.
REPEATS = 5


def figures() -> dict[str, dict]:
    """Print the paper's figures next to ours, and return ours."""
    found: dict[str, dict] = {"exact": {}, "paths": {}}
    shapes = {name: (shape, DIAMETER, SPIRAL_STEP) for name, shape in POCKETS.items()}
    shapes |= {name: (pocket(name), 10.0, 2.5) for name in ("hug", "big")}
    print("The spiral (paper: exact, C2, less than 0.1 s; section 3.2 only sketched)")
    for name, (shape, diameter, step) in shapes.items():
        found["exact"][name] = exactness(shape, diameter, step)
        print(f"{name:9} {found['exact'][name]}")
    print("The paths (paper: LM has no jumps, and a higher eta than conventional paths)")
    for name, shape in POCKETS.items():
        found["paths"][name] = compare(name, shape)
    found["shown"] = shown(found)
    print(found["shown"])
    return found


def request_for(shape: Polygon, diameter: float, step: float) -> PocketRequest:
    """Return a request for a pocket 2 mm deep, as the paper's."""
    return PocketRequest(
        shape,
        diameter,
        Heights(5.0, 2.0, 0.0, -2.0, 2.0),
        Feeds(50.0, 12.5, 83.0, 83.0),
        Cutting(step),
        strategy=Strategy.LINEAR_MORPH,
    )


def exactness(shape: Polygon, diameter: float, step: float) -> dict[str, float | int | str]:
    """Return how exact, smooth and quick the spiral of one pocket is."""
    request = request_for(shape, diameter, step)
    region = center_regions(shape, diameter / 2, 0.0)[0]
    seconds = []
    for _ in range(REPEATS):
        began = time.process_time()
        path = linear_morph.floor_path(region, request, lambda done: None)
        seconds.append(time.process_time() - began)
    curve = path.curve
    spline = BSpline(curve.knots, curve.control_points, curve.degree)
    u = np.linspace(0.0, 1.0, PARAMETERS, endpoint=False)
    error = np.abs(spline(u) - equation_3(region, request, u)).max()
    spiral = LineString(path.passes[0].points)
    swept = [LineString(p.points).buffer(diameter / 2) for p in path.passes[:2]]
    entry = path.entry
    if isinstance(entry, Slot):
        swept.append(LineString(np.vstack([entry.ring, entry.ring[:1]])).buffer(diameter / 2))
    else:
        swept.append(Point(entry.center).buffer(entry.radius + diameter / 2))
    left = region.buffer(diameter / 2 - 0.02).difference(shapely.union_all(swept))
    return {
        "inner_curve": "slender" if isinstance(entry, Slot) else "circle",
        "control_points": len(curve.control_points),
        "error_mm": float(f"{error:.1e}"),
        "c2_jump": float(f"{curvature_jump(spline):.1e}"),
        "crossings": int(not spiral.is_simple),
        "uncut_mm2": round(left.area, 3),
        "seconds": round(min(seconds), 3),
    }


def equation_3(region: Polygon, request: PocketRequest, u: np.ndarray) -> np.ndarray:
    """Return ``(1 - u) d_in(m u) + u d_out(m u)``, both curves as scipy's periodic splines."""
    morph = linear_morph.morph_of(region, request)
    b = morph.breaks
    turns, _ = spiral_beziers(b, morph.inner, morph.outer, request.cutting.stepover)
    knots = np.concatenate([b[-4:-1] - 1, b, b[1:4] + 1])
    around = np.arange(len(b) + 2) % (len(b) - 1)
    d_in, d_out = (BSpline(knots, c[around], 3) for c in (morph.inner, morph.outer))
    lap = (u * turns) % 1.0
    return (1 - u)[:, None] * d_in(lap) + u[:, None] * d_out(lap)


def curvature_jump(spline: BSpline) -> float:
    """Return the largest jump of the second derivative at a knot, over its largest value."""
    second = spline.derivative(2)
    inner = np.unique(spline.t)[1:-1]
    gap = np.diff(np.unique(spline.t)).min() * 1e-7
    jump = np.abs(second(inner + gap) - second(inner - gap)).max()
    return float(jump / np.abs(second(inner)).max())


def shown(found: dict[str, dict]) -> dict[str, bool]:
    """Return which of the paper's statements hold."""
    spirals = [found["exact"][name] for name in POCKETS]
    paths = found["paths"].values()
    conventional = ("contour-parallel", "direction-parallel")

    def beats(key: str) -> bool:
        return all(p["Linear Morph"][key] > p[other][key] for p in paths for other in conventional)

    return {
        "exact_to_1e-9_mm": all(f["error_mm"] < 1e-9 for f in found["exact"].values()),
        "c2": all(f["c2_jump"] < 1e-4 for f in found["exact"].values()),
        "below_0.1_s": all(f["seconds"] < 0.1 for f in spirals),
        "no_jumps_of_engagement": all(
            p["Linear Morph"]["jump_deg"] < min(p[o]["jump_deg"] for o in conventional)
            for p in paths
        ),
        "eta_above_conventional": beats("eta_3000"),
    }


def draw(folder: Path) -> None:
    """Write a picture of the spirals in a convex and in non-convex pockets."""
    from matplotlib.figure import Figure

    rooms = box(-60, -22, -14, 22).union(box(18, -16, 52, 16)).union(box(-20, -7, 24, 7))
    tee = box(0, 0, 90, 26).union(box(32, -40, 58, 4))
    figure = Figure(figsize=(15, 5.2), layout="constrained")
    for axes, shape in zip(figure.subplots(1, 3), (POCKETS["pentagon"], tee, rooms), strict=True):
        request = request_for(shape, DIAMETER, 2.4)
        (region,) = center_regions(shape, DIAMETER / 2, 0.0)
        morph = linear_morph.morph_of(region, request)
        path = linear_morph.floor_path(region, request, lambda done: None)
        axes.plot(*shape.exterior.xy, color="black", linewidth=1.5)
        ring = sample_beziers(periodic_beziers(morph.breaks, morph.inner), 0.01)
        axes.plot(*ring.T, color="tab:red", linewidth=1.5)
        axes.plot(*path.passes[0].points.T, color="tab:blue", linewidth=0.8)
        axes.plot(*path.passes[1].points.T, color="tab:green", linewidth=0.8)
        axes.set_aspect("equal")
        axes.axis("off")
    figure.savefig(folder / "linear-morph.png", dpi=70)


if __name__ == "__main__":
    figures()
    if sys.argv[1:]:
        draw(Path(sys.argv[1]))
