# SPDX-License-Identifier: LGPL-2.1-or-later
"""CS08: times of a square and a circle, of the spiral by C and feed, of a part with nine pockets.

The paper prints neither the size of its square pocket nor its conventional path. Ours is a
square of 10 inches cut with steps of 1/4 inch, which gives a spiral about as long as the
paper's (its times fit ``length / feed + constant`` with 380 to 398 inches). Such spirals need
laps that are up to twice as thick in the corners, which is more than the strategy's default
(`central.THICKEST`); figures for both are printed. The conventional path is contour-parallel
at the same step-over.
"""

from __future__ import annotations

import numpy as np
from chatelain import INCH, residuals, root_mean_square
from paper_pockets import rib, rounded
from shapely import Polygon, box

from freecad_spiralpocket import machines
from freecad_spiralpocket.engine.laps import central
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, PocketRequest
from freecad_spiralpocket.engine.polyline import ring_from
from freecad_spiralpocket.engine.region import center_regions, polygons_of
from freecad_spiralpocket.engine.timing import polyline_seconds

FEEDS = (200, 300, 350, 400, 450, 500, 600)  # inch/min
#: Table 1: seconds of the spiral, and gain over the conventional path [%], by C [%].
TABLE_1 = {
    20: ((141.6, 99.2, 88.0, 80.1, 74.3, 70.0, 64.0), (9.10, 10.4, 10.8, 10.9, 10.6, 10.0, 9.1)),
    30: ((138.5, 96.28, 84.8, 76.6, 70.5, 65.9, 60.0), (11.4, 12.9, 13.4, 13.9, 14.1, 14.0, 13.2)),
    40: ((136.4, 94.27, 83.0, 74.8, 68.7, 64.0, 57.7), (13.4, 15.2, 15.6, 15.8, 16.0, 16.0, 15.7)),
    50: ((136.5, 94.04, 82.1, 74.7, 68.6, 64.0, 57.6), (19.5, 21.5, 21.8, 21.7, 21.4, 21.1, 20.4)),
    60: ((134.9, 92.71, 81.4, 73.4, 67.6, 63.1, 57.0), (18.2, 20.1, 20.5, 20.2, 19.6, 18.7, 17.3)),
    70: ((133.6, 91.93, 81.1, 73.4, 68.0, 64.0, 58.6), (19.8, 21.5, 21.5, 21.0, 20.1, 18.7, 15.9)),
}
SIDE, CORNER, DIAMETER = 10 * INCH, 8.0, 16.0
STEP = 0.25 * INCH
#: Thickness in the corners over the step-over with which the paper's lengths come out.
PAPER_THICKEST = 2.0
#: Feed for the part with nine pockets [inch/min].
RIB_FEED = 600
MACHINE = machines.load("huron_840d")


def no_tick(done: float) -> None:
    """Never cancel."""


def seconds(points: np.ndarray, feed: float) -> float:
    """Return the time of a plane path at a feed in inch/min."""
    flat = np.column_stack([points, np.zeros(len(points))])
    return float(polyline_seconds(flat, feed * INCH / 60, MACHINE)) + MACHINE.start_overhead


def length(points: np.ndarray) -> float:
    """Return the length of a plane path [inch]."""
    return float(np.hypot(*np.diff(points, axis=0).T).sum()) / INCH


def spiral(region: Polygon, ratio: float | None, thickest: float = PAPER_THICKEST) -> np.ndarray:
    """Return the spiral in a cutter-center region with its closing lap."""
    feed = FEEDS[-1] * INCH / 60
    request = PocketRequest(
        region,
        DIAMETER,
        Heights(8, 3, 0, -5, 5),
        Feeds(feed, feed / 4, 500.0, 500.0),
        Cutting(STEP),
        machine=MACHINE,
    )
    path = central.floor_path(region, request, no_tick, ratio, thickest)
    return np.vstack([part.points for part in path.passes[:2]])


def contour_parallel(region: Polygon) -> np.ndarray:
    """Return laps parallel to the wall, from the inside outwards, joined by straight moves."""
    laps, center = [], np.array(region.centroid.coords[0])
    while not region.is_empty:
        for part in polygons_of(region):
            laps.append(ring_from(np.asarray(part.exterior.coords)[:-1], center, (1.0, 0.0)))
        region = region.buffer(-STEP, join_style="mitre")
    return np.vstack(laps[::-1])


def center_region(pocket: Polygon) -> Polygon:
    """Return where the cutter's center may be."""
    return center_regions(pocket, DIAMETER / 2, 0.0)[0]


def table_1(thickest: float) -> dict:
    """Print table 1 next to ours and return what it shows."""
    half = SIDE / 2
    region = center_region(rounded(box(-half, -half, half, half), CORNER))
    parallel = contour_parallel(region)
    conventional = np.array([seconds(parallel, f) for f in FEEDS])
    print(f"table 1 with laps up to {thickest:.2f} steps thick; feeds {FEEDS} in/min")
    print(f"  contour-parallel: {length(parallel):.0f} in")
    ours, gains, stops = {}, {}, {}
    for c, (times, paper) in TABLE_1.items():
        path = spiral(region, c / 100, thickest)
        ours[c] = np.array([seconds(path, f) for f in FEEDS])
        gains[c] = 100 * (1 - ours[c] / conventional)
        stops[c] = round(float(ours[c][-1]) - 60 * length(path) / FEEDS[-1], 2)
        rows = {"paper [s]": times, "ours [s]": ours[c], "paper [%]": paper, "ours [%]": gains[c]}
        print(f"  C {c} %, {length(path):.0f} in")
        for name, row in rows.items():
            print(f"    {name:10}", *(f"{value:7.1f}" for value in row))
    best = [min(ours, key=lambda c, i=i: ours[c][i]) for i in range(len(FEEDS))]
    at_best = [round(float(gains[c][i]), 1) for i, c in enumerate(best)]
    print("  best C by feed [%]:", best, " its gain [%]:", at_best)
    print("  lost to changes of speed at 600 in/min by C [s]:", stops)
    return {
        "best_c_pct": best[-1],
        "best_c_by_feed_pct": best,
        "gain_pct_min": min(at_best),
        "gain_pct_max": max(at_best),
        "lost_s_by_c": stops,
    }


def nine_pockets(thickest: float) -> float:
    """Print the times of a part with nine pockets, figures 17 and 18; return the gain [%]."""
    regions = [center_region(pocket) for pocket in rib()]
    spirals = sum(seconds(spiral(r, None, thickest), RIB_FEED) for r in regions)
    parallel = sum(seconds(contour_parallel(r), RIB_FEED) for r in regions)
    gain = 100 * (1 - spirals / parallel)
    print(f"nine pockets with laps up to {thickest:.2f} steps thick, C by simulation:")
    print(f"  {spirals:.1f} s, contour-parallel {parallel:.1f} s: {gain:.1f} % (paper: over 16 %)")
    return round(gain, 1)


def figures() -> dict:
    """Print the tables next to ours and return the figures."""
    rms = root_mean_square(residuals(MACHINE))
    print(f"table 2: 30 times of a square and a circle with one set of limits: {rms:.4f} s rms")
    default = table_1(central.THICKEST)
    return {
        "table2_rms_s": round(rms, 4),
        **table_1(PAPER_THICKEST),
        "rib_gain_pct": nine_pockets(PAPER_THICKEST),
        "default_gain_pct_min": default["gain_pct_min"],
        "default_best_c_pct": default["best_c_pct"],
        "default_rib_gain_pct": nine_pockets(central.THICKEST),
    }
