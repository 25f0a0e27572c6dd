# SPDX-License-Identifier: LGPL-2.1-or-later
"""Automatic at small step-overs: corners of plugs and ends of strokes are as gentle as the rest."""

from __future__ import annotations

import math
from itertools import islice

import pytest
import shapely
from shapely import Point, Polygon, box
from shapely.affinity import rotate
from shapes import SQUARE, rounded
from shapes import request as make_request

from freecad_spiralpocket.engine import floor_paths, plan
from freecad_spiralpocket.engine.errors import NotYetError
from freecad_spiralpocket.engine.growth.front_rules import ROUNDED, rules_of
from freecad_spiralpocket.engine.growth.fronts import fronts_from
from freecad_spiralpocket.engine.model import Cutting, Strategy
from freecad_spiralpocket.engine.shapes.shaping import oriented
from freecad_spiralpocket.engine.stepover import over_limit

#: Slim corners: a plug's laps turn sharply there.
KITE = rounded(Polygon([(-68, 16), (-55, 30), (14, 13), (26, -28), (6, -56)]), 4.5)
#: Walls of an island from which strokes start and at which they end.
ISLAND = rounded(box(0, 0, 52, 40), 4.0).difference(rotate(box(14, 12, 30, 24), 30))
#: All that may pass 1.15 times the limit and 4 degrees, and how far all but a hundredth may [rad].
OVER, ABOVE = 0.003, math.radians(9)


@pytest.mark.parametrize("pocket", [KITE, ISLAND], ids=["kite", "island"])
@pytest.mark.parametrize("share", [0.1, 0.2])
def test_engagement_is_kept_at_small_stepovers(pocket, share):
    cutting = Cutting(stepover=share * 6.0)
    report = plan(make_request(pocket, strategy=Strategy.AUTOMATIC, cutting=cutting)).report
    assert report.over_limit_share < OVER
    assert report.engagement_p99 < report.engagement_limit + ABOVE
    assert report.uncut.area < 1e-3


@pytest.mark.parametrize("stepover", [0.3, 0.6, 1.2, 2.4, 2.6])
def test_where_fronts_round_into_walls_engagement_passes_the_limit_by_so_much(stepover):
    rules = rules_of(make_request(SQUARE, cutting=Cutting(stepover=stepover)))
    cleared = Point(0, 0).buffer(rules.fillet + 3.0, quad_segs=512)
    rim = shapely.LineString(Point(rules.fillet + rules.stepover, 0).buffer(3.0, 512).boundary)
    left = shapely.difference(rim, cleared)
    # the half ahead of the cutter
    angle = rules.limit + ROUNDED * (over_limit(rules.limit) - rules.limit)
    assert left.length / 2 / 3.0 == pytest.approx(angle, rel=1e-2)


@pytest.mark.parametrize("hole", [18.0, 22.0])
def test_what_stands_in_a_ring_of_bosses_is_cut_step_by_step(hole):
    turns = [math.radians(45 * i) for i in range(8)]
    bosses = [Point(36 * math.cos(turn), 36 * math.sin(turn)).buffer(12) for turn in turns]
    omega = oriented(box(-60, -60, 60, 60).difference(shapely.union_all(bosses)))
    visited = oriented(omega.difference(Point(0, 0).buffer(hole)))
    rules = rules_of(make_request(box(-63, -63, 63, 63), cutting=Cutting(stepover=0.9)))
    # the ground between the bosses is narrower than the fillets of fronts
    fronts = list(islice(fronts_from(visited, omega, rules), 200))
    assert len(fronts) < 1.5 * hole / rules.stepover
    assert omega.difference(fronts[-1]).area < 1.0


@pytest.mark.parametrize("strategy", Strategy)
def test_a_pocket_of_thousands_of_laps_is_refused_before_any_is_laid(strategy, monkeypatch):
    monkeypatch.setattr(floor_paths, "import_module", None)
    asked = make_request(SQUARE, strategy=strategy, cutting=Cutting(stepover=19 / 2500))
    with pytest.raises(NotYetError, match="more than 2000 step-overs wide"):
        plan(asked)
