# SPDX-License-Identifier: LGPL-2.1-or-later
"""HQS24: what refitting isotherms with C2 Hermite quartic patches does to curvature and time.

The paper prints no coordinates; the pockets are approximations (paper_pockets.py). Its raw
side is made as it describes: linear elements on about 12,000 nodes, contours as they come
(plate.py). Our own isotherms, from a second-order grid, are shown raw and refitted beside it.
Raw and refitted spirals go through the same laps. One turn here is a closed lap, of those about
the hottest place: the paper spirals from one only. Quantiles
of curvature are over points, raw ones as they come and refitted ones evenly spaced.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import shapely
from paper_pockets import pocket
from plate import PlateContours
from shapely import LineString, Polygon
from shapely.affinity import scale

from freecad_spiralpocket import machines
from freecad_spiralpocket.engine.floor import Pass, Slot
from freecad_spiralpocket.engine.heat.family import Family, family_of
from freecad_spiralpocket.engine.heat.isotherms import mover, refitted
from freecad_spiralpocket.engine.heat.nested import Lap, path_through
from freecad_spiralpocket.engine.laps.isotherm import laps_of
from freecad_spiralpocket.engine.links.estimates import motion_of
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, PocketRequest
from freecad_spiralpocket.engine.motion.timing import polyline_seconds
from freecad_spiralpocket.engine.shapes.polyline import points_at
from freecad_spiralpocket.engine.shapes.region import INSET, center_regions
from freecad_spiralpocket.engine.toolpath import Role

#: Cutter and largest deviation [mm]; programmed feed [mm/s]; largest distance of laps [mm].
DIAMETER, DEVIATION, FEED = 10.0, 0.5, 10_000 / 60
DISTANCE = 7.5
#: The paper's second pocket takes 17 isotherms, and laps of its take four times as long as those
#: of a pocket as small as ours: it must be about so many times as large.
SCALES = {"big": 1.0, "hug": 3.0}
#: Raw contours of a pocket a third as large, its 17 laps a third as far apart, are as rough as the
#: paper's; then its laps take a quarter of the time.
ROUGH, ROUGH_SCALE, ROUGH_DISTANCE = "hug", 1.0, 2.5
MACHINE = machines.load("ucp710")
#: Distance of the points of refitted paths [mm]: the paper has 360 on turns of about 700 mm.
SPACING = 2.0
#: Cut95 and Cut99 of the whole spiral, raw and refitted (table 4).
WHOLE = {"big": ((0.24, 0.14), (1.30, 0.97))}
#: Three laps from inside out: where among all, Cut95, Cut99, seconds saved [%] (tables 3, 5, 6).
TURNS = {
    "big": {
        "internal": (0.85, None, None, 17),
        "intermediate": (0.5, None, None, 16),
        "external": (0.1, None, None, 10),
    },
    "hug": {
        "internal": (13 / 16, (0.44, 0.10), (1.51, 0.12), 19),
        "intermediate": (9 / 16, (0.45, 0.07), (1.05, 0.13), 20),
        "external": (2 / 16, (0.38, 0.07), (1.07, 0.08), 24),
    },
}


def no_tick(done: float) -> None:
    """Never cancel."""


def family(name: str, size: float, distance: float = DISTANCE) -> tuple[Family, Polygon]:
    """Return the raw isotherms of a pocket of a size, and its cutter-center region."""
    shape = scale(pocket(name), size, size, origin=(0, 0))
    region = center_regions(shape, DIAMETER / 2, 0.0)[0]
    request = PocketRequest(
        shape,
        DIAMETER,
        Heights(8, 3, 0, -5, 5),
        Feeds(FEED, 10, 500, 500),
        Cutting(distance, finishing_lap=False),
    )
    return family_of(region, request, 3.0, 0.0), region


def smoothed(lap: Lap, patches: list[int]) -> Lap:
    """Return a lap and all inside of it refitted; adds the numbers of patches."""
    inner = tuple(smoothed(one, patches) for one in lap.inner)
    if np.isnan(lap.level):
        return replace(lap, inner=inner)
    wall = lap.level == 0
    region, count = refitted(
        shapely.segmentize(lap.region, 0.5) if wall else lap.region, INSET if wall else DEVIATION
    )
    if not wall:
        patches.append(count)
    entry = lap.entry
    if isinstance(entry, Slot):
        entry = Slot(np.asarray(region.exterior.coords)[:-1], entry.bite)
    return Lap(region, lap.level, inner, entry)


def isotherms_of(lap: Lap) -> list[Lap]:
    """Return the isotherms among a lap and all inside of it, the hottest branch first."""
    below = [one for inner in lap.inner for one in isotherms_of(inner)]
    return ([] if np.isnan(lap.level) or lap.level == 0 else [lap]) + below


def hottest(lap: Lap) -> list[Lap]:
    """Return the isotherms from a lap inwards to the hottest place, as the paper's one spiral."""
    found = []
    while True:
        if not np.isnan(lap.level) and lap.level != 0:
            found.append(lap)
        if not lap.inner:
            return found
        lap = lap.inner[0]


def spirals(lap: Lap, found: Family, region: Polygon) -> list[np.ndarray]:
    """Return the spirals through all laps as they are cut."""
    request = found.request
    path = path_through(lap, region, request, motion_of(request), mover(found.field), no_tick)
    return [p.points for p in path.passes if isinstance(p, Pass) and p.role is Role.CUT]


def curvatures(path: np.ndarray) -> np.ndarray:
    """Return the curvature at inner points of a polyline: turning over length [1/mm]."""
    steps = np.diff(path, axis=0)
    steps = steps[np.hypot(*steps.T) > 1e-9]
    lengths = np.hypot(*steps.T)
    cross = steps[:-1, 0] * steps[1:, 1] - steps[:-1, 1] * steps[1:, 0]
    turning = np.abs(np.arctan2(cross, (steps[:-1] * steps[1:]).sum(axis=1)))
    return turning / ((lengths[:-1] + lengths[1:]) / 2)


def cuts(paths: list[np.ndarray]) -> list[float]:
    """Return Cut95 and Cut99 of paths over their points [1/mm]."""
    values = np.concatenate([curvatures(path) for path in paths])
    return [round(float(q), 3) for q in np.quantile(values, [0.95, 0.99])]


def sampled(path: np.ndarray) -> np.ndarray:
    """Return a refitted path at even points, as the paper does."""
    line = LineString(path)
    at = np.linspace(0, line.length, math.ceil(line.length / SPACING) + 1)
    return points_at(line, at)


def seconds(path: np.ndarray) -> float:
    """Return the time of a path on the paper's machine [s]."""
    return float(polyline_seconds(np.column_stack([path, 0 * path[:, 0]]), FEED, MACHINE))


def _saved(raw: float, fitted: float) -> float:
    return round(100 * (1 - fitted / raw), 1)


def whole(name: str, raw: list[np.ndarray], fitted: list[np.ndarray]) -> dict:
    """Print table 4 for spirals raw and refitted."""
    (raw95, raw99), (fit95, fit99) = cuts(raw), cuts([sampled(path) for path in fitted])
    paper = WHOLE.get(name)
    print(f"    whole: Cut95 {raw95} -> {fit95}" + (f" (paper {paper[0]})" if paper else ""))
    print(f"           Cut99 {raw99} -> {fit99}" + (f" (paper {paper[1]})" if paper else ""))
    times = [sum(map(seconds, paths)) for paths in (raw, fitted)]
    print(f"           time  {times[0]:.1f} -> {times[1]:.1f} s, {_saved(*times)} % saved")
    return {"cut95": [raw95, fit95], "cut99": [raw99, fit99], "time_saved_pct": _saved(*times)}


def turns(name: str, raw: list[Lap], fitted: list[Lap]) -> dict:
    """Print tables 3, 5 and 6 for three laps, raw and refitted."""
    found = {}
    for place, (share, cut95, cut99, saved) in TURNS[name].items():
        i = round(share * (len(raw) - 1))
        both = [np.asarray(laps[i].region.exterior.coords) for laps in (raw, fitted)]
        (raw95, raw99), (fit95, fit99) = cuts(both[:1]), cuts([sampled(both[1])])
        times = [seconds(lap) for lap in both]
        print(
            f"    {place} turn: Cut95 {raw95} -> {fit95}" + (f" (paper {cut95})" if cut95 else "")
        )
        print(f"      Cut99 {raw99} -> {fit99}" + (f" (paper {cut99})" if cut99 else ""))
        print(f"      {times[0]:.2f} -> {times[1]:.2f} s, {_saved(*times)} % saved (paper {saved})")
        found[place] = {
            "cut95": [raw95, fit95],
            "cut99": [raw99, fit99],
            "time_saved_pct": _saved(*times),
        }
    return found


def deviation(raw: list[Lap], fitted: list[Lap]) -> float:
    """Return the largest distance of raw contours' points from refitted laps [mm]."""
    return max(
        float(
            shapely.distance(
                LineString(f.region.exterior.coords), shapely.points(r.region.exterior.coords)
            ).max()
        )
        for r, f in zip(raw, fitted, strict=True)
    )


def compare(name: str, found: Family, region: Polygon) -> dict:
    """Print the comparison for one pocket and one source of isotherms."""
    raw, patches = laps_of(found, no_tick), []
    fitted = smoothed(raw, patches)
    lines = [isotherms_of(lap) for lap in (raw, fitted)]
    off = deviation(*lines)
    count = [len(lap.region.exterior.coords) for lap in lines[0]]
    print(
        f"    {len(count)} isotherms of up to {max(count)} points -> up to {max(patches)} patches"
    )
    print(f"    largest deviation {off:.3f} mm of {DEVIATION} mm")
    return {
        "isotherms": len(count),
        "points_max": max(count),
        "patches_max": max(patches),
        "deviation_mm": round(off, 3),
        "whole": whole(name, *(spirals(lap, found, region) for lap in (raw, fitted))),
        "turns": turns(name, *(hottest(lap) for lap in (raw, fitted))),
    }


def figures() -> dict:
    """Print the tables next to ours and return the figures."""
    results = {}
    for name, size in SCALES.items():
        found, region = family(name, size)
        plate = PlateContours(found.region)
        print(f"{name}, linear elements on {plate.count} nodes:")
        results[name] = compare(name, replace(found, contours=plate), region)
        print(f"{name}, our grid of {found.field.inside.sum()} nodes:")
        results[name]["own"] = compare(name, found, region)
    found, region = family(ROUGH, ROUGH_SCALE, ROUGH_DISTANCE)
    print(f"{ROUGH} of size {ROUGH_SCALE}, laps {ROUGH_DISTANCE} mm apart, linear elements:")
    rough = replace(found, contours=PlateContours(found.region))
    results[ROUGH]["rough"] = compare(ROUGH, rough, region)
    results["shown"] = shown(results)
    print(results["shown"])
    return results


def shown(results: dict[str, dict]) -> dict[str, bool]:
    """Return which of the paper's statements hold for its linear elements, refitted our way."""
    pairs, saved = [], []
    for name in SCALES:
        papers = {"whole": WHOLE.get(name, (None, None))}
        papers |= {place: row[1:3] for place, row in TURNS[name].items()}
        ours = {"whole": results[name]["whole"], **results[name]["turns"]}
        for place, (cut95, cut99) in papers.items():
            pairs += [(ours[place]["cut95"], cut95), (ours[place]["cut99"], cut99)]
        saved += [turn["time_saved_pct"] for turn in results[name]["turns"].values()]
    both = [(ours, paper) for ours, paper in pairs if paper]
    return {
        "curvature_falls_as_far": all(ours[1] <= paper[1] for ours, paper in both),
        "curvature_falls_by_as_much": all(o[1] / o[0] <= p[1] / p[0] + 0.005 for o, p in both),
        "10_percent_saved_each_turn": min(saved) >= 10,
        "within_0.5_mm": all(results[name]["deviation_mm"] <= DEVIATION for name in SCALES),
    }
