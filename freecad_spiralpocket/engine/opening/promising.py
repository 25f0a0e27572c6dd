# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which starts are worth growing: those from which no place is hopelessly far.

How far that is depends on how soon the cutter is down there: at deep levels, or with a small bite,
a helix may be through long before a slot is, and what it leaves in corners costs less.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import Polygon

from ..floor import Helix
from ..model import Floats
from ..numerics.nearest import nearest
from ..shapes.shaping import Region
from .start import Start

#: A start is hopeless whose farthest wall is farther than this over the nearest one's; a helix by
#: so much more than that, times the square of what it saves on the way down, over all laps.
HOPELESS, SOONER = 1.5, 2.0
#: So few levels are always worth simulating.
FEW = 14
#: Places within a region at which that is looked at, along each side.
GRID = 40


def promising(
    starts: list[tuple[Start, Polygon]],
    region: Polygon,
    stepover: float,
    entries: Sequence[float] = (),
) -> list[tuple[Start, Polygon]]:
    """Return the starts from which the farthest place is not hopelessly far, the nearest first.

    But the slot along the wall comes before all others: it mostly is the fastest, and what is
    compared with the fastest is given up sooner.

    Fronts from elsewhere would need so many more levels, each with its strokes and links, that
    simulating them is not worth the time; unless all places are within a few step-overs.

    Parameters
    ----------
    starts : list of tuple of Start and shapely.Polygon
        Each with the region that is cut from there.
    region : shapely.Polygon
        What is to be cut.
    stepover : float
        [mm]
    entries : sequence of float, optional
        How long the way down of each takes, over what all laps take at least.
    """
    if len(starts) == 1:
        return starts
    x0, y0, x1, y1 = region.bounds
    x, y = np.meshgrid(np.linspace(x0, x1, GRID), np.linspace(y0, y1, GRID))
    inner = np.column_stack([x.ravel(), y.ravel()])
    inner = inner[shapely.contains_xy(region, inner)]
    places = np.vstack([inner, _sampled(region.boundary, 2.0)])
    visited = [
        shapely.union_all([start.visited, *start.idle]) if start.idle else start.visited
        for start, _ in starts
    ]
    far = np.array([_farthest(places, ground) for ground in visited])
    nearest_one, few = float(far.min()), FEW * stepover
    down = np.array(entries or [0.0] * len(starts))
    kept = far <= max(HOPELESS * nearest_one, few)
    is_helix = np.array([isinstance(start.entry, Helix) for start, _ in starts])
    saved = np.where(is_helix, np.maximum(down[kept].min() - down, 0.0), 0.0)
    farthest = np.maximum(HOPELESS * (1 + SOONER * saved**2) * nearest_one, few)
    others = np.array([start.within is None for start, _ in starts])
    order = np.lexsort((far, others))
    return [starts[i] for i in order if far[i] <= farthest[i]]


def _sampled(line: shapely.Geometry, spacing: float) -> Floats:
    """Return points along lines, at most `spacing` apart [mm]."""
    slim = shapely.simplify(line, 0.05, preserve_topology=False)
    return shapely.get_coordinates(shapely.segmentize(slim, spacing))


def _farthest(places: Floats, visited: Region) -> float:
    """Return how far the farthest of the places is from what is visited [mm]."""
    outside = places[~shapely.contains_xy(visited, places)]
    if len(outside) == 0:
        return 0.0
    return float(nearest(_sampled(visited.boundary, 1.0), outside)[0].max())
