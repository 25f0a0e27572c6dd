# SPDX-License-Identifier: LGPL-2.1-or-later
"""[EAS07]: coverage, spacing of laps and curvature of links, on pockets with and without islands.

The paper prints two pictures and no figures. What it claims is measured: the region is covered,
laps keep the distance b, links have a curvature linear in the arc length. With
$SPIRALPOCKET_POCKETS, all pockets of that folder are cut as well (`tool` and `ae` are the
cutter's diameter and the step-over).

    ./dev bench paper_eas07 [FOLDER]     with a folder, a picture is written there
"""

from __future__ import annotations

import json
import os
import sys
import time
from itertools import pairwise
from pathlib import Path

import numpy as np
import shapely
from paper_pockets import pocket
from shapely import LineString, Point, Polygon, box

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.laps import extended_archimedean
from freecad_spiralpocket.engine.middle_line.archimedean import Spiral
from freecad_spiralpocket.engine.middle_line.clothoids import ClothoidPath
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, PocketRequest, Strategy
from freecad_spiralpocket.engine.shapes.region import center_regions

#: Uncut floor that does not count, over the pocket's area: strokes thinner than 0.03 mm are
#: not worth a move.
SLIVERS = 5e-5
#: Spacing is good within this share of b; curvature within this of a line [1/mm].
SPACING, LINEAR = 0.01, 1e-6
#: Step of the differences that find a link's curvature from its points [mm].
STEP = 0.02


def pockets() -> dict[str, tuple[Polygon, float, float]]:
    """Return pockets with the cutter's diameter and the step-over [mm]."""
    bend = Polygon([(0, 0), (90, 0), (90, 32), (34, 32), (34, 90), (0, 90)])
    rooms = box(-60, -22, -14, 22).union(box(18, -16, 52, 16)).union(box(-20, -7, 24, 7))
    fingers = box(0, 0, 120, 22).union(
        shapely.union_all([box(x, 20, x + 15, 62) for x in (6, 38, 70, 99)])
    )
    posts = box(0, 0, 110, 70).difference(
        shapely.union_all([Point(28, 36).buffer(10), box(56, 20, 72, 44), Point(90, 48).buffer(7)])
    )
    found = {
        "square": (box(0, 0, 50, 50), 6.0, 2.4),
        "bend": (bend, 6.0, 2.4),
        "rooms": (rooms, 6.0, 2.4),
        "fingers": (fingers, 6.0, 2.4),
        "ring": (Point(0, 0).buffer(44).difference(Point(0, 0).buffer(15)), 6.0, 2.4),
        "posts": (posts, 6.0, 2.4),
        "hug": (pocket("hug"), 10.0, 2.5),
        "big": (pocket("big"), 10.0, 2.5),
    }
    folder = os.environ.get("SPIRALPOCKET_POCKETS")
    for file in sorted(Path(folder).glob("*.json")) if folder else []:
        data = json.loads(file.read_text(encoding="utf-8"))
        shape = Polygon(data["outer"], data.get("holes", []))
        diameter = float(data.get("tool", 6.0))
        found[file.stem] = (shape, diameter, float(data.get("ae", 0.4 * diameter)))
    return found


def figures() -> dict[str, dict]:
    """Print what the paper claims next to what is found, and return it."""
    print("claims: covered, laps b apart (within 1 %), curvature of links linear and continuous")
    found: dict[str, dict] = {}
    for name, (shape, diameter, step) in pockets().items():
        found[name] = measure(shape, diameter, step)
        print(f"{name:10} {found[name]}")
    found["shown"] = shown(found)
    print(found["shown"])
    return found


def request_for(shape: Polygon, diameter: float, step: float) -> PocketRequest:
    """Return a request for a pocket 5 mm deep."""
    return PocketRequest(
        shape,
        diameter,
        Heights(8.0, 3.0, 0.0, -5.0, 5.0),
        Feeds(50.0, 12.5, 83.0, 83.0),
        Cutting(step),
        strategy=Strategy.EXTENDED_ARCHIMEDEAN,
    )


def measure(shape: Polygon, diameter: float, step: float) -> dict[str, float | int]:
    """Return what comes of one pocket."""
    request = request_for(shape, diameter, step)
    began = time.process_time()
    layouts = [
        extended_archimedean.lay(region, request, lambda done: None)
        for region in center_regions(shape, diameter / 2, 0.0)
    ]
    seconds = time.process_time() - began
    report = plan(request).report
    spirals = [(s, t.points) for o in layouts for s, t in zip(o.spirals, o.steps, strict=False)]
    links = [link for o in layouts for link in o.links if link is not None]
    ways = [t.link for o in layouts for t in o.steps[: len(o.spirals)]]
    others = sum(way is None or len(way) > 0 for way in ways) - len(links)
    apart = [
        spacing(s, points) / min(step, extended_archimedean.WIDEST * diameter) - 1
        for s, points in spirals
    ]
    # a spiral of one turn has no turn before
    off = np.abs(np.concatenate([*apart, [0.0]]))
    return {
        "spirals": len(spirals),
        "clothoid_links": len(links),
        "other_links": others,
        "uncut_share": float(f"{report.uncut_area / shape.area:.1e}"),
        "gouge_mm": round(report.gouge, 4),
        "spacing_within_1_percent": round(float((off <= SPACING).mean()), 4),
        "spacing_p99_percent": round(100 * float(np.quantile(off, 0.99)), 2),
        "curvature_error": float(f"{max([nonlinearity(k) for k in links], default=0.0):.1e}"),
        "curvature_jump": float(f"{max([jump(k) for k in links], default=0.0):.1e}"),
        "over_limit_share": round(report.over_limit_share, 4),
        "seconds": round(seconds, 2),
    }


def spacing(spiral: Spiral, points: np.ndarray) -> np.ndarray:
    """Return distances of the second to the last turn to the turn before, point by point [mm].

    The turn that closes a spiral comes ever nearer to the one before, on purpose.
    """
    last = spiral.rings[-1]
    along = shapely.line_locate_point(last, shapely.points(points)) / last.length
    turns = np.unwrap(2 * np.pi * along) / (2 * np.pi)
    turns -= turns[0]
    sectors = 8
    found = [np.empty(0)]
    for k in range(sectors, sectors * spiral.center.laps):
        here = points[(turns >= k / sectors) & (turns < (k + 1) / sectors)]
        inside = (turns >= k / sectors - 1.2) & (turns < (k + 1) / sectors - 0.8)
        before = LineString(points[inside])
        found.append(shapely.distance(shapely.points(here), before))
    return np.concatenate(found)


def nonlinearity(link: ClothoidPath) -> float:
    """Return how far the curvature of a link's pieces is from linear in the arc length [1/mm]."""
    return max(float(np.abs(k - np.polyval(np.polyfit(s, k, 1), s)).max()) for s, k in pieces(link))


def jump(link: ClothoidPath) -> float:
    """Return the largest jump of curvature between the pieces of a link [1/mm]."""
    fits = [np.polyfit(s, k, 1) for s, k in pieces(link)]
    inner = link.joints[1:-1]
    return max(
        (
            abs(float(np.polyval(a, s) - np.polyval(b, s)))
            for a, b, s in zip(fits, fits[1:], inner, strict=False)
        ),
        default=0.0,
    )


def pieces(link: ClothoidPath) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return arc lengths and curvatures, by differences of points, of each piece of a link."""
    found = []
    joints = link.joints
    for a, b in pairwise(joints):
        # the places about one are apart from those about the next
        h = min(STEP, (b - a) / 100, STEP / (1 + np.abs(link.curvatures).max()))
        s = np.linspace(a + 2 * h, b - 2 * h, 21)
        around = link.points_at(np.sort((s[:, None] + h * np.arange(-2, 3)).ravel()))
        p = around.reshape(len(s), 5, 2) - around[10:11]
        first = (p[:, 0] - 8 * p[:, 1] + 8 * p[:, 3] - p[:, 4]) / (12 * h)
        second = (-p[:, 0] + 16 * p[:, 1] - 30 * p[:, 2] + 16 * p[:, 3] - p[:, 4]) / (12 * h * h)
        cross = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
        found.append((s, cross / np.hypot(*first.T) ** 3))
    return found


def shown(found: dict[str, dict]) -> dict[str, bool]:
    """Return which claims hold on every pocket."""
    each = list(found.values())
    return {
        "covered": all(f["uncut_share"] < SLIVERS and f["gouge_mm"] <= 0.01 for f in each),
        "spacing_within_1_percent": all(f["spacing_within_1_percent"] >= 0.99 for f in each),
        "links_linear_to_1e-6": all(f["curvature_error"] < LINEAR for f in each),
        "links_continuous": all(f["curvature_jump"] < LINEAR for f in each),
        "below_1_s": all(f["seconds"] < 1.0 for f in each),
    }


def draw(folder: Path) -> None:
    """Write a picture of the spirals, links and strokes in three pockets."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(15, 5.2), layout="constrained")
    shapes = pockets()
    for axes, name in zip(figure.subplots(1, 3), ("rooms", "bend", "posts"), strict=True):
        shape, diameter, step = shapes[name]
        request = request_for(shape, diameter, step)
        (region,) = center_regions(shape, diameter / 2, 0.0)
        layout = extended_archimedean.lay(region, request, lambda done: None)
        for ring in (shape.exterior, *shape.interiors):
            axes.plot(*ring.xy, color="black", linewidth=1.5)
        for center in layout.opening.centers:
            axes.plot(*center.curve.xy, color="tab:red", linewidth=2.5, marker=".", markersize=4)
        axes.plot(*layout.opening.start.ring.xy, color="tab:red", linewidth=0.8)
        for i, cut in enumerate(layout.steps):
            spiral = i < len(layout.spirals)
            if cut.link is not None and len(cut.link) > 1:
                axes.plot(*cut.link.T, color="tab:orange", linewidth=1.8 if spiral else 0.6)
            color = "tab:blue" if spiral else "tab:green"
            axes.plot(*cut.points.T, color=color, linewidth=0.8)
        axes.set_aspect("equal")
        axes.axis("off")
    figure.savefig(folder / "extended-archimedean.png", dpi=70)


if __name__ == "__main__":
    figures()
    if sys.argv[1:]:
        draw(Path(sys.argv[1]))
