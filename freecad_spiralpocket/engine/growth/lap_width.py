# SPDX-License-Identifier: LGPL-2.1-or-later
"""How wide laps had best be: a little wider than the step-over where that saves a pass.

What stands between two walls is cut in a whole number of passes, an odd one too: the last lap
ends where nothing is left. If the last pass would take but a thin rib, and all the others may be
so little wider that they take it among them, it is saved.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import shapely
from shapely import Polygon

from ..shapes.shaping import Region, grow_prepared, opening_of
from .front_rules import MEETING, FrontRules

#: A lap may be wider by this to leave no ribs; as much as feeds allow without slowing down.
STRETCH = 1.05
#: The widths that are tried, over the step-over.
WIDTHS = (1.01, 1.02, 1.03, 1.04, STRETCH)
#: They must save this share of the passes' length, beyond what wider laps save anywhere.
WORTH = 0.01
#: Plugs of more passes have no rib that matters.
MOST = 24
#: A hole holds no stock that is wide enough for less than the cutter by this, half its width [mm].
IDLE = 0.003
#: Points of the stock's outline that matter less than this over R are left out.
COARSE = 0.015


def widened(rules: FrontRules, share: float) -> FrontRules:
    """Return rules with a step-over that is so much wider."""
    limit = np.arccos(max(-1.0, 1 - share * (1 - np.cos(rules.limit))))
    return replace(rules, limit=float(limit))


def best_width(visited: Polygon, omega: Polygon, rules: FrontRules) -> FrontRules:
    """Return the rules by which the stock in the holes of a region is cut in the least passes.

    Parameters
    ----------
    visited : shapely.Polygon
        Where the cutter's center has been.
    omega : shapely.Polygon
        The region to grow in.
    rules : FrontRules
    """
    stock = shapely.union_all([_stock(hole, rules) for hole in _plugs(visited, omega)])
    stock = shapely.simplify(stock, COARSE * rules.cutter_radius)
    plain = _passes(stock, rules.stepover)
    if not 0 < plain < math.inf:
        return rules
    # wider laps than some would leave stock where they meet
    widths = [w for w in WIDTHS if w * rules.stepover <= MEETING * rules.cutter_radius]
    saved = [plain / _passes(stock, w * rules.stepover) - w for w in widths]
    best = int(np.argmax([WORTH, *saved]))
    return rules if best == 0 else widened(rules, widths[best - 1])


def ribs_in(visited: Polygon, omega: Polygon, rules: FrontRules) -> float:
    """Return the area of the stock in ribs so thin that a wider lap would have taken them [mm2]."""
    thin, area = (STRETCH - 1) * rules.stepover, 0.0
    for hole in _plugs(visited, omega):
        stock = _stock(hole, rules)
        area += stock.area - opening_of(stock, thin).area
    # along slopes and in corners the opening takes a little too
    return area


def _plugs(visited: Polygon, omega: Polygon) -> list[Polygon]:
    holes = [Polygon(ring) for ring in visited.interiors]
    return [hole for hole in holes if omega.contains(hole)]


def _stock(hole: Polygon, rules: FrontRules) -> Region:
    """Return what stands in a hole: the cutter reaches over its rim."""
    return grow_prepared(hole, IDLE - rules.cutter_radius)


def _passes(stock: Region, step: float) -> float:
    """Return the length of the passes that take a plug [mm], infinite if there are very many.

    Each takes a step from one side of it, so on a line from wall to wall there is one for each
    half step from the outside to the middle.
    """
    length, number = 0.0, 0
    rest = stock
    while not rest.is_empty:
        if number > MOST:
            return math.inf
        length += rest.length / 2
        number += 1
        rest = shapely.buffer(stock, -number * step / 2, quad_segs=4)
    return length
