# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets that reach out of the stock: cleared to the edge, begun in the air, proved against it."""

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from shapely import Point, box
from shapely.geometry.polygon import orient
from shapes import HEIGHTS, assert_ways_down_are_fed, lifts, rounded
from shapes import request as make_request

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.contact.air import Stock
from freecad_spiralpocket.engine.contact.engagement import along_path
from freecad_spiralpocket.engine.floor import Plunge
from freecad_spiralpocket.engine.model import CutMode, Cutting, Strategy
from freecad_spiralpocket.engine.opening import open_sides
from freecad_spiralpocket.engine.proof.verify import prove
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.toolpath import Role, ToolpathBuilder

R = 3.0
OUT = 3 * R  # beyond the stock
PLATE = box(0, 0, 100, 60)
DISC = Point(0, 0).buffer(40, quad_segs=32)


def with_air(inside, *beside):
    """Return a pocket in the plate with the air beside it, boxes that overlap it."""
    return orient(shapely.union_all([inside, *(box(*b).difference(PLATE) for b in beside)]))


NOTCH = with_air(
    rounded(box(20, -30, 80, 40), 4.0).intersection(PLATE), (20 - OUT, -OUT, 80 + OUT, 1)
)
CORNER = with_air(
    rounded(box(-40, -40, 50, 40), 4.0).intersection(PLATE),
    (-OUT, -OUT, 50 + OUT, 1),
    (-OUT, -OUT, 1, 40 + OUT),
)
THROUGH = with_air(
    box(30, 0, 60, 60), (30 - OUT, -OUT, 60 + OUT, 1), (30 - OUT, 59, 60 + OUT, 60 + OUT)
)
NARROW = box(30, -OUT, 36.5, 40)
BOSS = orient(PLATE.buffer(OUT, join_style="mitre").difference(Point(50, 30).buffer(15)))
ROUND_BOSS = orient(DISC.buffer(OUT).difference(Point(5, 0).buffer(12)))
POCKETS = {
    "notch": (NOTCH, PLATE),
    "corner": (CORNER, PLATE),
    "through": (THROUGH, PLATE),
    "narrow": (NARROW, PLATE),
    "boss": (BOSS, PLATE),
    "round boss": (ROUND_BOSS, DISC),
}


def request(name, **changes):
    pocket, stock = POCKETS[name]
    return make_request(pocket, stock=stock, strategy=Strategy.AUTOMATIC, **changes)


def assert_sound(made):
    report = made.report
    assert report.uncut_area < 0.01 and report.gouge <= 0.01
    assert report.rapid_hit == 0 and report.link_hit == 0
    assert report.engagement_p99 <= report.engagement_limit + math.radians(9)
    assert lifts(made) == 1
    assert_ways_down_are_fed(made)


@pytest.mark.parametrize("mode", CutMode)
@pytest.mark.parametrize("name", POCKETS)
def test_pocket_is_cleared_to_the_edge_of_the_stock(name, mode):
    assert_sound(plan(request(name, cutting=Cutting(2.4, cut_mode=mode))))


@pytest.mark.parametrize("mode", CutMode)
def test_between_levels_the_cutter_is_lifted_and_fed_down(mode):
    heights = replace(HEIGHTS, step_down=2.5)
    made = plan(request("round boss", cutting=Cutting(2.4, cut_mode=mode), heights=heights))
    assert lifts(made) == 2
    assert_ways_down_are_fed(made)
    assert made.report.gouge <= 0.01 and made.report.uncut_area < 0.01


@pytest.fixture
def peeled(monkeypatch):
    """Leave no start but those in the air."""
    every = open_sides.starts_of

    def from_air(region, asked):
        return [pair for pair in every(region, asked) if isinstance(pair[0].entry, Plunge)]

    monkeypatch.setattr("freecad_spiralpocket.engine.laps.automatic.starts_of", from_air)


@pytest.mark.parametrize("name", sorted(POCKETS.keys() - {"narrow"}))
def test_peeling_begins_in_the_air(name, peeled):
    made = plan(request(name))
    assert_sound(made)
    assert made.report.entry_bite == 0
    path = made.toolpath
    first = int(np.flatnonzero(path.roles == Role.ENTRY)[0])
    assert POCKETS[name][1].distance(Point(path.points[first, :2])) >= R


@pytest.mark.parametrize("name", POCKETS)
def test_what_begins_within_hardly_leaves_the_stock(name):
    asked = request(name)
    region = center_regions(asked.pocket, R, 0.0)[0]
    inner = open_sides.needed(region, asked)
    assert region.buffer(0.01).covers(inner)
    wanted = region.buffer(R).intersection(asked.stock)
    assert wanted.difference(inner.buffer(R, quad_segs=64)).buffer(-0.02).is_empty
    assert inner.difference(asked.stock.buffer(0.03 * R)).is_empty


def test_round_a_boss_it_stays_inside():
    asked = request("round boss")
    inner = open_sides.needed(center_regions(asked.pocket, R, 0.0)[0], asked)
    assert DISC.buffer(-0.5 * R).covers(inner)


@pytest.mark.parametrize("strategy", [s for s in Strategy if s is not Strategy.LINEAR_MORPH])
def test_every_strategy_clears_it(strategy):
    report = plan(make_request(NOTCH, stock=PLATE, strategy=strategy)).report
    assert report.uncut_area < 0.05 and report.gouge <= 0.01
    assert report.rapid_hit == 0 and report.link_hit == 0


def straight(y, *more):
    """Return the toolpath of a straight run along y, which begins and ends outside of the plate."""
    builder = ToolpathBuilder((-20.0, y, 5.0))
    builder.rapid(100.0, z=-5.0)
    for x, at in [(120.0, y), *more]:
        builder.line((x, at, -5.0), 20.0, Role.CUT)
    return builder.build()


@pytest.mark.parametrize("depth", [0.3, 1.2, 3.0, 4.5, 6.0])
def test_engagement_beside_the_stock_is_that_of_the_closed_form(depth):
    engagement = along_path(straight(depth - R), R, axial_depth=5.0, stock=Stock.of(PLATE))
    inside = (engagement.points[:, 0] > 10) & (engagement.points[:, 0] < 90)
    wanted = math.acos(1 - depth / R)
    assert engagement.angles[inside] == pytest.approx(wanted, abs=1e-6)
    beside = (engagement.points[:, 0] < -R) | (engagement.points[:, 0] > 100 + R)
    assert engagement.angles[beside].max() == 0


@pytest.mark.parametrize("depth", [0.5, 2.4])
def test_engagement_round_a_disc_is_that_of_the_closed_form(depth):
    radius = 40 + R - depth
    builder = ToolpathBuilder((radius, 0.0, -5.0))
    for turn in np.radians(np.arange(-5.0, -360.0, -5.0)):  # climb round a boss: clockwise
        builder.line((radius * math.cos(turn), radius * math.sin(turn), -5.0), 20.0, Role.CUT)
    engagement = along_path(builder.build(), R, axial_depth=5.0, stock=Stock.of(DISC))
    # from the inward direction to where the rim leaves the disc; the leading half takes that much
    wanted = math.acos((radius**2 + R**2 - 40**2) / (2 * radius * R))
    bearing = np.degrees(np.arctan2(*engagement.points[:, 1::-1].T))
    steady = (bearing > -170) & (bearing < -20)
    assert np.median(engagement.angles[steady]) == pytest.approx(wanted, abs=0.02)


def test_a_rapid_down_is_seen_in_the_stock_only():
    asked = make_request(NOTCH, stock=PLATE)
    assert prove(asked, straight(-R - 0.01)).rapid_hit == 0
    builder = ToolpathBuilder((50.0, 1.0, 5.0))
    builder.rapid(100.0, z=-5.0)
    assert prove(asked, builder.build()).rapid_hit > 0
