# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isotherms: the choice of laps, how they lie, the whole path."""

from __future__ import annotations

import math

import numpy as np
import pytest
from heated import (
    FINS,
    FOUR_POSTS,
    ROUND_RING,
    SIX_POSTS,
    STEP,
    TWO_ISLANDS,
    TWO_LOBES,
    laps_of,
    pairs,
    path_of,
    turning,
)
from hypothesis import HealthCheck, given, settings
from scipy.interpolate import RegularGridInterpolator
from shapely import LineString, Point, box
from shapes import (
    CIRCLE,
    DUMBBELL,
    L_SHAPE,
    PENTAGON,
    RING,
    SQUARE,
    TRIANGLE,
    convex_pockets,
    no_tick,
)
from shapes import request as make_request

from freecad_spiralpocket.engine.errors import CutterDoesNotFitError, NotYetError
from freecad_spiralpocket.engine.floor import Helix, Pass
from freecad_spiralpocket.engine.heat.family import distances, points_of
from freecad_spiralpocket.engine.heat.poisson import HeatField
from freecad_spiralpocket.engine.laps import isotherm
from freecad_spiralpocket.engine.model import Cutting, Strategy
from freecad_spiralpocket.engine.planner import plan
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.toolpath import Role


def temperatures(field: HeatField, points: np.ndarray) -> np.ndarray:
    """Return the temperatures at points inside the region, linear in each cell."""
    x, y = field.xy
    return RegularGridInterpolator((x, y), np.nan_to_num(field.values).T)(points)


@pytest.mark.parametrize("pocket", [SQUARE, TRIANGLE, L_SHAPE, RING, TWO_LOBES, TWO_ISLANDS])
def test_laps_are_nested_and_no_farther_apart_than_the_step_over(pocket):
    family, wall = laps_of(pocket)
    for lap, inner in pairs(wall):
        assert family.region.buffer(0.011).covers(lap.region)
        for one in inner:
            if not isinstance(one.entry, Helix):
                assert lap.region.buffer(1e-6).covers(one.region)
        if inner:
            regions = [one.region for one in inner]
            assert distances(points_of(lap.region), regions).max() < 1.05 * STEP


def test_refitted_laps_keep_to_their_isotherms():
    family, wall = laps_of(PENTAGON, deviation=0.1)
    for lap, _ in pairs(wall):
        if not math.isnan(lap.level):
            points = points_of(lap.region)
            slope = np.hypot(*family.field.gradient(points).T)
            off = np.abs(temperatures(family.field, points) - lap.level) / np.maximum(slope, 0.5)
            assert off.max() < 0.1 + 0.05


def test_raw_isotherms_are_kept_as_a_choice():
    family, wall = laps_of(PENTAGON, deviation=0.0)
    level = wall.inner[0].level
    np.testing.assert_allclose(
        temperatures(family.field, points_of(wall.inner[0].region)), level, rtol=0.05
    )


@pytest.mark.parametrize("small", [6.25, 6.75, 7.25, 7.5])
def test_no_lap_lies_in_the_disc_that_opens_it(small):
    bulge = Point(16, 0).buffer(small).union(box(0, -0.8 * small, 16, 0.8 * small))
    _, wall = laps_of(Point(0, 0).buffer(12.0).union(bulge))
    cores = [(lap, core) for lap, inner in pairs(wall) for core in inner if core.entry]
    assert len(cores) == 2 and all(isinstance(core.entry, Helix) for _, core in cores)
    assert not any(core.region.contains(lap.region) for lap, core in cores)


def test_an_evenly_heated_plate_has_a_spiral_about_each_summit_and_laps_around_both():
    _, wall = laps_of(TWO_LOBES)
    cores = [lap for lap, _ in pairs(wall) if lap.entry is not None]
    assert len(cores) == 2
    assert all(isinstance(core.entry, Helix) for core in cores)
    assert cores[0].entry.center[0] * cores[1].entry.center[0] < 0
    assert max(len(inner) for _, inner in pairs(wall)) == 2


@pytest.mark.parametrize(
    "pocket", [CIRCLE, SQUARE, L_SHAPE, RING, ROUND_RING, DUMBBELL, TWO_LOBES, TWO_ISLANDS]
)
def test_everything_is_cleared_and_nothing_gouged(pocket):
    report = plan(make_request(pocket, strategy=Strategy.ISOTHERM)).report
    assert report.uncut_area < 1e-3
    assert report.gouge < 0.01
    assert report.rapid_hit < 0.1
    assert report.link_hit < 0.1


@settings(max_examples=8, deadline=None, suppress_health_check=list(HealthCheck))
@given(convex_pockets())
def test_any_convex_pocket_gets_laps_inside_its_region(pocket):
    regions = center_regions(pocket, 3.0, 0.0)
    try:
        path = isotherm.floor_path(regions[0], make_request(pocket), no_tick)
    except CutterDoesNotFitError:
        assert regions[0].buffer(-0.2).is_empty
        return
    fence = regions[0].buffer(0.01)
    for part in path.passes:
        if isinstance(part, Pass) and part.role in (Role.CUT, Role.FINISH):
            assert fence.covers(LineString(part.points))


def test_laps_about_islands_are_begun_beside_them():
    region, path = path_of(SIX_POSTS)
    fence = region.buffer(0.02)
    parts = [p for p in path.passes if isinstance(p, Pass) and len(p.points) > 1]
    assert all(fence.covers(LineString(p.points)) for p in parts)


@pytest.mark.parametrize("pocket", [L_SHAPE, RING, DUMBBELL, TWO_LOBES, TWO_ISLANDS])
def test_laps_beside_saddles_have_no_sharp_corners(pocket):
    _, path = path_of(pocket)
    spirals = [p for p in path.passes if isinstance(p, Pass) and p.role is Role.CUT]
    assert max(turning(p.points).max() for p in spirals) < 35


@pytest.mark.parametrize("pocket", [RING, ROUND_RING, TWO_ISLANDS, FOUR_POSTS, SIX_POSTS])
def test_nothing_turns_back_round_islands_nor_on_the_way_to_them(pocket):
    _, path = path_of(pocket)
    parts = [p.points for p in path.passes if isinstance(p, Pass) and p.role is not Role.FINISH]
    along = np.vstack(parts)
    steps = np.hypot(*np.diff(along, axis=0).T)
    assert turning(along[np.append(True, steps > 1e-3)]).max() < 35


def test_too_many_laps_are_refused(monkeypatch):
    monkeypatch.setattr(isotherm, "MOST_LAPS", 4)
    with pytest.raises(NotYetError, match="more than 4 laps"):
        path_of(SQUARE)


def test_rooms_joined_by_a_neck_hardly_wider_than_the_cutter_are_cut_as_one():
    rooms = box(0, 0, 40, 40).union(box(44, 0, 84, 40)).union(box(39, 16.99, 45, 23.01))
    result = plan(make_request(rooms, strategy=Strategy.ISOTHERM))
    assert result.report.uncut_area == 0 and result.report.gouge < 0.01


def test_deep_fins_are_cut_by_wide_laps_too():
    cutting = Cutting(0.6 * 6.0)
    result = plan(make_request(FINS, strategy=Strategy.ISOTHERM, cutting=cutting))
    assert result.report.uncut_area < 0.01 and result.report.gouge < 0.01
