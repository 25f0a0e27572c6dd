# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finishing the corners that fronts leave, each in as few strokes as the limit allows.

Fronts meet walls with a fillet, so that what lies beyond it stays. A stroke goes to the
smallest fillet whose bite the engagement allows, the last into the corner itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache, partial
from itertools import islice

import numpy as np
import shapely
from shapely import Polygon

from ..shapes.shaping import (
    SLIVER,
    Region,
    are_within,
    clipped,
    closing_of,
    grow_prepared,
    largest,
    opening_of,
    oriented,
    rim_points,
    simplified_region,
    thick_parts,
)
from .front_rules import FrontRules
from .fronts import FLAT, MAX_FRONTS, NECK_FILLETS, advance_narrowly, fronts_from, leads_on

#: Fillet radii tried in the corners, over R; the smallest whose bite keeps below a share of the
#: step-over is taken at once.
CORNER_FILLETS = (0.0, 0.17, 0.27, 0.4, 0.57, 0.77, 1.0, 1.3)
#: These shares before the last stroke and for it: where the wall turns at once, the engagement
#: jumps, so that less may be left for it.
ROUND_BITES, SHARP_BITES = (0.65, 0.65), (0.5, 0.5)
#: A stroke that takes more than this share of a corner is its last.
LAST = 0.98
#: A corner is sharp if the first of the fillets leaves more than this of it, over R.
SHARP = 0.03
#: A front that takes this share of what a step does without fillets is as good, and smooth.
AS_GOOD = 0.6
#: What is farther from a corner does not matter there [mm].
AROUND = 0.1


def levels_from(
    start: Polygon,
    omega: Polygon,
    rules: FrontRules,
    idle: Sequence[Polygon] = (),
    known: Sequence[Polygon] = (),
) -> Iterator[tuple[Polygon, bool]]:
    """Yield the fronts from a start to the end of every corner, and which only finish corners.

    Steps into corners also go through channels that no front enters; beyond one fronts go on.

    The parameters are those of `fronts_from`, which yields the first of these.
    """
    first = 0
    while True:
        last = start
        for last in islice(fronts_from(start, omega, rules, idle, known), first, None):
            yield last, False
        for finer in finish_corners(last, omega, rules):
            yield finer, True
            if leads_on(finer, omega, rules):
                start, first, known = finer, 1, ()
                break
        else:
            return


def finish_corners(visited: Polygon, omega: Polygon, rules: FrontRules) -> Iterator[Polygon]:
    """Yield the levels that take the corners, each in as few steps as the limit allows."""
    for _ in range(MAX_FRONTS):
        rest = thick_parts(shapely.difference(omega, visited))
        if len(rest) == 0:
            return
        shapely.prepare(visited)
        narrow = lru_cache(partial(advance_narrowly, visited, omega, rules))
        pieces = [_corner_step(piece, visited, omega, rules, narrow) for piece in rest]
        wider = shapely.union_all([visited, *pieces])
        # unless points are left out as in other fronts there are more with every level of a channel
        wider = oriented(simplified_region(largest(closing_of(wider, 1e-4)), FLAT))
        if wider.area - visited.area < 1e-4:
            return
        yield wider
        visited = wider


@lru_cache(maxsize=2 * len(CORNER_FILLETS))
def _filleted(omega: Polygon, radius: float) -> Region:
    """Return a region with its corners rounded by a radius [mm]."""
    return opening_of(omega, radius)


def _is_room(piece: Region, visited: Polygon, stepover: float) -> bool:
    """Return whether a piece whose rim is within one step is deeper inside, as one all around."""
    if piece.area < np.pi * stepover**2:
        return False
    return bool(shapely.difference(piece, grow_prepared(visited, stepover)).area > SLIVER)


def _corner_step(
    piece: Polygon,
    visited: Polygon,
    omega: Polygon,
    rules: FrontRules,
    narrow: Callable[[float], Polygon],
) -> Region:
    """Return the part of a corner that the next stroke takes; `narrow` as `advance_narrowly`."""
    tips = shapely.points(shapely.get_coordinates(piece))
    rounded = _filleted(omega, CORNER_FILLETS[1] * rules.cutter_radius)
    sharp = not shapely.dwithin(rounded, tips, SHARP * rules.cutter_radius).all()
    bite, last = SHARP_BITES if sharp else ROUND_BITES
    taken: Region = piece
    x0, y0, x1, y1 = piece.bounds
    around = x0 - AROUND, y0 - AROUND, x1 + AROUND, y1 + AROUND
    for share in CORNER_FILLETS:
        if share > 0:
            shape = _filleted(omega, share * rules.cutter_radius)
            taken = shapely.intersection(clipped(shape, around), piece)
        # a fillet tighter than the corner itself leaves nothing for another stroke
        is_last = taken.area > LAST * piece.area
        limit = (last if is_last else bite) * rules.stepover
        corners = shapely.get_coordinates(taken)
        if taken.area > SLIVER and are_within(visited, corners, limit).all():
            # a channel has no corners but at its mouths
            rim, _ = rim_points(taken, rules.stepover)
            if are_within(visited, rim, rules.stepover).all() and not _is_room(
                taken, visited, rules.stepover
            ):
                return taken
    # deeper than any fillet: an ordinary front, or one step into it that leaves walls at an angle
    wider = grow_prepared(visited, bite * rules.stepover)
    step = shapely.intersection(piece, clipped(wider, around))
    for share in NECK_FILLETS:
        taken = shapely.intersection(narrow(share), piece)
        if taken.area > AS_GOOD * step.area:
            return taken
    return step
