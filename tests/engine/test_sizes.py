# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutters of any size are planned as well as those that strategies are made for."""

from __future__ import annotations

from dataclasses import replace

import pytest
import shapely
from shapely import LineString, Point
from shapes import ISLANDS, L_SHAPE, SQUARE, lifts
from shapes import request as make_request

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError
from freecad_spiralpocket.engine.laps import automatic as automatic_laps
from freecad_spiralpocket.engine.model import Cutting, Strategy
from freecad_spiralpocket.engine.proof.findings import TOUCH
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.sizes import (
    planned_resized,
    resized,
    resized_path,
    resized_request,
)


@pytest.mark.parametrize("pocket", [L_SHAPE, ISLANDS], ids=["L", "islands"])
@pytest.mark.parametrize("factor", [0.1, 10.0])
def test_pocket_and_cutter_of_another_size_are_planned_as_well(pocket, factor):
    made = make_request(pocket, strategy=Strategy.AUTOMATIC)
    result = plan(resized_request(made, factor))
    assert result.report.uncut_area < 0.01 * factor**2
    assert result.report.gouge <= 0.01 * factor
    assert result.report.rapid_hit == 0
    assert result.report.link_hit <= TOUCH * factor
    assert lifts(result) == 1


@pytest.mark.parametrize("tolerance", [0.002, 0.001, 0.0005])
def test_a_fine_tolerance_is_kept(tolerance):
    boss = shapely.box(0, 0, 50, 30).difference(Point(30, 15).buffer(5, quad_segs=128))
    made = make_request(boss, strategy=Strategy.AUTOMATIC, cutting=Cutting(1.6))
    report = plan(replace(made, tool_diameter=4.0, tolerance=tolerance)).report
    assert report.gouge <= tolerance and report.uncut_area < 0.01


@pytest.mark.parametrize(("radius", "tolerance"), [(0.3, 0.01), (9.0, 0.01), (3.0, 0.1)])
def test_size_and_tolerance_need_not_go_together(radius, tolerance):
    made = make_request(L_SHAPE, strategy=Strategy.AUTOMATIC)
    result = plan(replace(resized_request(made, radius / 3.0), tolerance=tolerance))
    assert result.report.uncut_area < 0.01 * max(1.0, radius / 3.0) ** 2
    assert result.report.gouge <= tolerance + 0.005


@pytest.mark.parametrize(
    "strategy", [s for s in Strategy if s is not Strategy.AUTOMATIC], ids=lambda s: s.name
)
def test_the_smallest_cutters_are_planned_as_any(strategy):
    made = resized_request(make_request(SQUARE, strategy=strategy), 1 / 30)
    report = plan(replace(made, tolerance=0.0005)).report
    assert report.uncut_area < 1e-4 and report.gouge <= 0.001
    assert not [n for n in report.notices if "the path asked for" in n.message]


@pytest.mark.parametrize("strategy", [Strategy.AUTOMATIC, Strategy.ISOTHERM])
def test_errors_of_small_cutters_tell_the_sizes_of_the_pocket(strategy):
    pocket = Point(20, 10).buffer(0.503, quad_segs=64)
    made = replace(resized_request(make_request(pocket, strategy=strategy), 1.0), tolerance=0.001)
    made = replace(made, tool_diameter=1.0, cutting=Cutting(0.4))
    with pytest.raises(CutterDoesNotFitError) as caught:
        plan(made)
    assert caught.value.message.startswith("The 1 mm cutter fits the pocket")
    assert caught.value.place == pytest.approx((20, 10), abs=0.1)


def test_all_else_resized_too_the_path_is_the_same():
    made = make_request(L_SHAPE, strategy=Strategy.AUTOMATIC)
    region = center_regions(made.pocket, made.cutter_radius, 0.0)[0]
    path = planned_resized(automatic_laps.floor_path, region, made, lambda done: None)
    small = planned_resized(
        automatic_laps.floor_path,
        resized(region, 0.125),  # exact in binary: GEOS would else meet other last digits
        resized_request(made, 0.125),
        lambda done: None,
    )
    back = resized_path(small, 8.0)
    assert [p.role for p in back.passes] == [p.role for p in path.passes]
    for one, other in zip(path.passes, back.passes, strict=True):
        assert LineString(one.points).hausdorff_distance(LineString(other.points)) < 1e-9


def test_where_geos_gives_up_another_size_is_tried():
    made = make_request(L_SHAPE, strategy=Strategy.AUTOMATIC)
    region = center_regions(made.pocket, made.cutter_radius, 0.0)[0]
    met = []

    def fails_twice(region, request, tick):
        met.append(request.tool_diameter)
        if len(met) < 3:
            raise shapely.GEOSException("found two shells in EdgeRing list")
        return automatic_laps.floor_path(region, request, tick)

    path = planned_resized(fails_twice, region, made, lambda done: None)
    assert met[0] == made.tool_diameter and len(set(met)) == 3
    within = region.buffer(0.011)
    assert all(within.covers(LineString(part.points)) for part in path.passes)
