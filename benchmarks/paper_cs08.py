# SPDX-License-Identifier: LGPL-2.1-or-later
"""CS08: times of a square and a circle, of the spiral by C and feed, of a part with nine pockets.

The paper prints neither the size of its square pocket nor its conventional path. Ours is a
square of 10 inches cut with steps of 1/4 inch, which gives a spiral about as long as the
paper's (its times fit ``length / feed + constant`` with 380 to 398 inches). The conventional path
is contour-parallel at the same step-over. The paper's is none in particular: its times and gains
imply one that takes up to 9 % longer at one C than at another.

Two spirals are compared with it. Section 2.3 of the paper divides every ray from the last circle
to the wall into as many turns as the shortest ray has step-overs; laps in the corners of a square
are then 1.5 to 2 steps thick, the more the larger C is, and the paper lowers the feed there.
The strategy's own laps are no thicker than those of the conventional path in a corner
(`central.THICKEST`). What is gained without thicker corners is less; both are printed.
"""

from __future__ import annotations

import math

import numpy as np
import shapely
from chatelain import INCH, residuals, root_mean_square
from paper_pockets import rib, rounded
from shapely import LineString, Polygon, box

from freecad_spiralpocket import machines
from freecad_spiralpocket.engine.laps import central
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, PocketRequest
from freecad_spiralpocket.engine.motion.timing import polyline_seconds
from freecad_spiralpocket.engine.shapes.polyline import ring_from
from freecad_spiralpocket.engine.shapes.region import center_regions, polygons_of

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
#: The paper limits the thickness in corners only by the number of turns, section 2.3.
PAPER_THICKEST = math.inf
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


def thickness(points: np.ndarray, toward: tuple[float, float]) -> float:
    """Return the thickest lap along the ray from the origin, over the step-over.

    The distance of neighboring laps on a ray is the paper's measure, section 2.4.
    """
    ray = LineString([(0.0, 0.0), np.array(toward) * SIDE])
    met = shapely.get_coordinates(shapely.intersection(LineString(points), ray))
    return float(np.diff(np.sort(np.hypot(*met.T))).max()) / STEP


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
    print(f"table 1 with {named(thickest)}; feeds {FEEDS} in/min")
    print(f"  contour-parallel: {length(parallel):.0f} in")
    ours, gains, stops, thick = {}, {}, {}, {}
    for c, (times, paper) in TABLE_1.items():
        path = spiral(region, c / 100, thickest)
        ours[c] = np.array([seconds(path, f) for f in FEEDS])
        gains[c] = 100 * (1 - ours[c] / conventional)
        stops[c] = round(float(ours[c][-1]) - 60 * length(path) / FEEDS[-1], 2)
        implied = np.array(times) / (1 - np.array(paper) / 100)
        rows = {
            "conventional, implied [s]": implied,
            "paper [s]": times,
            "ours [s]": ours[c],
            "paper [%]": paper,
            "ours [%]": gains[c],
        }
        thick[c] = round(thickness(path, (1.0, 1.0)), 2)
        print(f"  C {c} %, {length(path):.0f} in, corners {thick[c]} steps thick")
        for name, row in rows.items():
            print(f"    {name:25}", *(f"{value:7.1f}" for value in row))
    best = [min(ours, key=lambda c, i=i: ours[c][i]) for i in range(len(FEEDS))]
    at_best = [round(float(gains[c][i]), 1) for i, c in enumerate(best)]
    theirs = [min(TABLE_1, key=lambda c, i=i: TABLE_1[c][0][i]) for i in range(len(FEEDS))]
    print("  best C by feed [%]:", best, " its gain [%]:", at_best, " paper:", theirs)
    print("  lost to changes of speed at 600 in/min by C [s]:", stops)
    return {
        "best_c_pct": best[-1],
        "best_c_by_feed_pct": best,
        "paper_best_c_by_feed_pct": theirs,
        "gain_pct_min": min(at_best),
        "gain_pct_max": max(at_best),
        "gain_pct_min_by_c": {c: round(float(gain.min()), 1) for c, gain in gains.items()},
        "corner_steps_by_c": thick,
        "lost_s_by_c": stops,
    }


def named(thickest: float) -> str:
    """Return what limits the thickness of laps, in words."""
    if math.isinf(thickest):
        return "rays divided as in the paper"
    return f"laps up to {thickest:.2f} steps thick"


def nine_pockets(thickest: float) -> float:
    """Print the times of a part with nine pockets, figures 17 and 18; return the gain [%]."""
    regions = [center_region(pocket) for pocket in rib()]
    spirals = sum(seconds(spiral(r, None, thickest), RIB_FEED) for r in regions)
    parallel = sum(seconds(contour_parallel(r), RIB_FEED) for r in regions)
    gain = 100 * (1 - spirals / parallel)
    print(f"nine pockets with {named(thickest)}, C by simulation:")
    print(f"  {spirals:.1f} s, contour-parallel {parallel:.1f} s: {gain:.1f} % (paper: over 16 %)")
    return round(gain, 1)


def figures() -> dict:
    """Print the tables next to ours and return the figures."""
    rms = root_mean_square(residuals(MACHINE))
    print(f"table 2: 30 times of a square and a circle with one set of limits: {rms:.4f} s rms")
    default, paper = table_1(central.THICKEST), table_1(PAPER_THICKEST)
    gain = nine_pockets(PAPER_THICKEST)
    shown = {
        "table_2_to_0.03_s": rms < 0.03,
        "optimum_from_50_to_70_percent": all(50 <= c <= 70 for c in paper["best_c_by_feed_pct"]),
        "9_percent_at_every_feed": paper["gain_pct_min"] >= 9,
        "16_percent_on_nine_pockets": gain >= 16,
        "9_percent_with_default_corners": default["gain_pct_min"] >= 9,
    }
    print(shown)
    return {
        "shown": shown,
        "table2_rms_s": round(rms, 4),
        **paper,
        "rib_gain_pct": gain,
        "default_gain_pct_min": default["gain_pct_min"],
        "default_gain_pct_max": default["gain_pct_max"],
        "default_best_c_pct": default["best_c_pct"],
        "default_rib_gain_pct": nine_pockets(central.THICKEST),
    }
