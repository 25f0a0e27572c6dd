# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isotherms: the field against closed forms, the refit, the choice of laps, the whole path."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline, RegularGridInterpolator
from shapely import LineString, MultiPoint, MultiPolygon, Point, Polygon, box
from shapes import (
    CIRCLE,
    DUMBBELL,
    HEIGHTS,
    L_SHAPE,
    PENTAGON,
    RING,
    SQUARE,
    TRIANGLE,
    convex_pockets,
)
from shapes import request as make_request

from freecad_spiralpocket.engine.errors import CutterDoesNotFitError, NotYetError
from freecad_spiralpocket.engine.floor import FloorPath, Helix, Pass, Slot
from freecad_spiralpocket.engine.heat.family import distances, evened, family_of, points_of
from freecad_spiralpocket.engine.heat.hermite_quartic import ClosedFit, ClosedQuartic
from freecad_spiralpocket.engine.heat.hot_slots import hot_slot
from freecad_spiralpocket.engine.heat.isotherms import mover, outer_room, rooms_at
from freecad_spiralpocket.engine.heat.kinks import softened
from freecad_spiralpocket.engine.heat.poisson import HeatField, solve
from freecad_spiralpocket.engine.heat.turns import EASE, Ring, match, rise, turn
from freecad_spiralpocket.engine.laps import isotherm
from freecad_spiralpocket.engine.model import Cutting, Plan, Strategy
from freecad_spiralpocket.engine.planner import plan
from freecad_spiralpocket.engine.shapes.region import center_regions
from freecad_spiralpocket.engine.shapes.skeleton import medial_axis
from freecad_spiralpocket.engine.toolpath import Kind, Role

STEP = 2.4
#: Two lobes of one size with a wide waist: two summits and a saddle.
TWO_LOBES = Point(-26, 0).buffer(24).union(Point(26, 0).buffer(24)).union(box(-26, -14, 26, 14))
ROUND_RING = Point(0, 0).buffer(40, quad_segs=64).difference(Point(0, 0).buffer(14, quad_segs=64))
TWO_ISLANDS = box(0, 0, 90, 60).difference(Point(25, 30).buffer(8)).difference(box(55, 20, 70, 38))
CROSS = box(-45, -35, 45, 35).difference(box(-25, -5, 25, 5).union(box(-5, -22, 5, 22)))
FOUR_POSTS = box(0, 0, 120, 80).difference(
    MultiPoint([(30, 25), (90, 25), (30, 55), (90, 55)]).buffer(8.0)
)
#: Between posts laps close about islands that are far from most of the laps inside.
SIX_POSTS = box(0, 0, 100, 67).difference(
    MultiPoint([(20 + 30 * i, 20 + 27 * k) for i in range(3) for k in range(2)]).buffer(5.0)
)


def no_tick(done: float) -> None:
    """Never cancel."""


def laps_of(pocket: Polygon, deviation: float | None = None):
    region = center_regions(pocket, 3.0, 0.0)[0]
    family = family_of(region, make_request(pocket), 3.0, deviation)
    return family, isotherm.laps_of(family, no_tick)


def path_of(pocket: Polygon, **changes):
    region = center_regions(pocket, 3.0, 0.0)[0]
    return region, isotherm.floor_path(region, make_request(pocket, **changes), no_tick)


def pairs(lap):
    """Yield each lap with the laps inside of it."""
    yield lap, lap.inner
    for inner in lap.inner:
        yield from pairs(inner)


def ring_temperature(r: np.ndarray, inner: float, outer: float) -> np.ndarray:
    """Return the closed form in an annulus."""
    free = (outer**2 - r**2) / 4
    return free + (inner**2 - outer**2) / 4 * np.log(r / outer) / np.log(inner / outer)


def temperatures(field: HeatField, points: np.ndarray) -> np.ndarray:
    """Return the temperatures at points inside the region, linear in each cell."""
    x, y = field.xy
    return RegularGridInterpolator((x, y), np.nan_to_num(field.values).T)(points)


def errors(region: Polygon, center, exact, spacings) -> list[float]:
    found = []
    for spacing in spacings:
        field = solve(region, spacing)
        x, y = np.meshgrid(*field.xy)
        r = np.hypot(x - center[0], y - center[1])
        found.append(float(np.abs(field.values - exact(r))[field.inside].max()))
    return found


def test_field_in_a_disc_is_exact():
    disc = Point(0.3, 0.2).buffer(10, quad_segs=2000)
    assert errors(disc, (0.3, 0.2), lambda r: (100 - r**2) / 4, [0.7])[0] < 1e-4


def test_field_in_an_annulus_converges_with_second_order():
    center = (0.3, 0.2)
    annulus = Point(center).buffer(10, quad_segs=2000)
    annulus = annulus.difference(Point(center).buffer(3, quad_segs=2000))
    coarse, middle, fine = errors(
        annulus, center, lambda r: ring_temperature(r, 3, 10), [0.5, 0.25, 0.125]
    )
    assert coarse / middle > 3.4
    assert middle / fine > 3.4
    assert fine < 1e-3


def test_points_move_along_gradient_lines_to_the_isotherm_asked_for():
    disc = Point(0, 0).buffer(20, quad_segs=500)
    field = solve(disc, 0.4)
    angles = np.linspace(0, 2 * np.pi, 40)
    spokes = np.column_stack([np.cos(angles), np.sin(angles)])
    moved = mover(field)(18 * spokes, (400 - 18**2) / 4, (400 - 15**2) / 4)
    np.testing.assert_allclose(moved, 15 * spokes, atol=0.02)


def wavy(phase: float, waves: int, depth: float) -> np.ndarray:
    t = np.linspace(0, 2 * np.pi, 600, endpoint=False)
    r = 1 + depth * np.cos(waves * t + phase)
    return np.column_stack([40 * r * np.cos(t), 25 * r * np.sin(t)])


@settings(max_examples=20, deadline=None)
@given(st.floats(0, 6.28), st.integers(2, 5), st.floats(0, 0.25), st.sampled_from([0.5, 0.1, 0.02]))
def test_refitted_curve_keeps_the_bound_and_is_c2_all_round(phase, waves, depth, deviation):
    points = wavy(phase, waves, depth)
    curve = ClosedFit(points).within(deviation)
    ring = LineString(curve.sample(0.05))
    assert max(ring.distance(Point(p)) for p in points[::7]) <= 1.01 * deviation + 1e-4
    spline, breaks, eps = spline_of(curve), curve.breaks[:-1], 1e-8
    for order in (0, 1, 2):
        before, after = spline(breaks - eps, order), spline(breaks + eps, order)
        assert np.abs(after - before).max() < 1e-4 * (1 + np.abs(after).max())


def spline_of(curve: ClosedQuartic) -> BSpline:
    """Return a curve as scipy's B-spline: periodic, each knot twice."""
    ends = np.concatenate([curve.breaks[-3:-1] - 1.0, curve.breaks, curve.breaks[1:3] + 1.0])
    knots = np.repeat(ends, 2)
    index = np.arange(len(knots) - 5) % len(curve.controls)
    return BSpline(knots, curve.controls[index], 4, extrapolate="periodic")


def hermite_form(curve: ClosedQuartic) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return points and tangents at the breaks, and the bulge w of each patch.

    On a patch, with u from 0 to 1 and tangents times its span, the curve is the cubic Hermite
    curve plus ``u^2 (1 - u)^2 w``.
    """
    spline, spans = spline_of(curve), np.diff(curve.breaks)[:, None]
    points, tangents = spline(curve.breaks), spline(curve.breaks, 1)
    middle = spline((curve.breaks[:-1] + curve.breaks[1:]) / 2)
    cubic = (points[:-1] + points[1:]) / 2 + spans * (tangents[:-1] - tangents[1:]) / 8
    return points, tangents, 16.0 * (middle - cubic)


def test_patches_are_those_of_the_paper():
    curve = ClosedFit(wavy(0.4, 3, 0.2)).within(0.1)
    points, tangents, bulges = hermite_form(curve)
    u = np.linspace(0, 1, 9)[:, None]
    for i, span in enumerate(np.diff(curve.breaks)):
        p0, p1 = points[i], points[i + 1]
        t0, t1 = span * tangents[i], span * tangents[i + 1]
        # alpha and beta of HQS24 eq. 6, from w = alpha (P0 - P1) + beta (T0 - T1)
        alpha, beta = np.linalg.solve(np.column_stack([p0 - p1, t0 - t1]), bulges[i])
        a0 = 1 + (alpha - 3) * u**2 + 2 * (1 - alpha) * u**3 + alpha * u**4
        b0 = u + (beta - 2) * u**2 + (1 - 2 * beta) * u**3 + beta * u**4
        b1 = -(beta + 1) * u**2 + (2 * beta + 1) * u**3 - beta * u**4
        paper = a0 * p0 + (1 - a0) * p1 + b0 * t0 + b1 * t1
        ours = spline_of(curve)(curve.breaks[i] + span * u[:, 0])
        np.testing.assert_allclose(paper, ours, atol=1e-8)


def test_fewer_patches_for_a_wider_bound():
    counts = [len(ClosedFit(wavy(0, 4, 0.2)).within(d).breaks) for d in (1.0, 0.3, 0.1, 0.03)]
    assert counts == sorted(counts)
    assert counts[0] < 20


def test_turns_join_with_equal_tangent_and_curvature():
    u = np.array([0.0, 1.0])
    h = 1e-4
    assert (rise(u) == u).all()
    np.testing.assert_allclose([rise(np.array(h)), 1 - rise(np.array(1 - h))], 0, atol=h**2)
    np.testing.assert_allclose(
        rise(u * (1 - 2 * EASE) + EASE), [EASE / 2 / (1 - EASE)] * 1 + [1 - EASE / 2 / (1 - EASE)]
    )


def test_turn_between_circles_is_one_even_turn_of_a_spiral():
    angles = np.linspace(0, 2 * np.pi, 400)
    spokes = np.column_stack([np.cos(angles), np.sin(angles)])
    inner, outer = Ring.of(10 * spokes), Ring.of(12 * spokes)
    places = np.arange(100) * outer.length / 100
    matched = match(inner, outer, places, outer.at(places) * 10 / 12)
    points, _ = turn(inner, outer, matched, 3.0, 0.25)
    radii = np.hypot(*points.T)
    assert radii[0] == pytest.approx(10, abs=1e-2)
    assert radii[-1] == pytest.approx(12, abs=1e-2)
    assert (np.diff(radii) > -1e-3).all()
    np.testing.assert_allclose(points[0] / radii[0], points[-1] / radii[-1], atol=1e-2)


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


def test_partners_of_a_slim_ring_are_on_its_own_leg():
    line = LineString([(0, 0), (20, 0), (20, 15)])
    inner, outer = (Ring.of(np.array(line.buffer(off).exterior.coords)[::-1]) for off in (0.1, 1.0))
    places = np.linspace(0.0, outer.length, 200, endpoint=False)
    points, ahead = outer.at(places), outer.ahead(places)
    # what leads to the ring leads a little too far now and then
    far = np.where(np.arange(200) % 7 == 3, 1.2, 0.9)
    matched = match(inner, outer, places, points + far[:, None] * ahead @ [[0, 1], [-1, 0]])
    off = inner.at(matched.inner) - outer.at(matched.outer)
    assert np.hypot(*off.T).max() < 1.5


@pytest.mark.parametrize("small", [6.25, 6.75, 7.25, 7.5])
def test_no_lap_lies_in_the_disc_that_opens_it(small):
    bulge = Point(16, 0).buffer(small).union(box(0, -0.8 * small, 16, 0.8 * small))
    _, wall = laps_of(Point(0, 0).buffer(12.0).union(bulge))
    cores = [(lap, core) for lap, inner in pairs(wall) for core in inner if core.entry]
    assert len(cores) == 2 and all(isinstance(core.entry, Helix) for _, core in cores)
    assert not any(core.region.contains(lap.region) for lap, core in cores)


def entries_of(path: FloorPath) -> list:
    return [path.entry, *(p for p in path.passes if not isinstance(p, Pass))]


def test_an_evenly_heated_plate_has_a_spiral_about_each_summit_and_laps_around_both():
    _, wall = laps_of(TWO_LOBES)
    cores = [lap for lap, _ in pairs(wall) if lap.entry is not None]
    assert len(cores) == 2
    assert all(isinstance(core.entry, Helix) for core in cores)
    assert cores[0].entry.center[0] * cores[1].entry.center[0] < 0
    assert max(len(inner) for _, inner in pairs(wall)) == 2


def test_fingers_that_no_isotherm_leads_through_are_opened_by_slots_at_last():
    # so deep that a slot takes longer than laps would that creep along a finger
    deep = replace(HEIGHTS, final_depth=-12.0, step_down=13.0)
    pocket = box(0, 0, 67, 18).union(box(14, 0, 32, 62))
    changes = {"tool_diameter": 12.0, "cutting": Cutting(5.4), "heights": deep}
    result = plan(make_request(pocket, strategy=Strategy.ISOTHERM, **changes))
    assert result.report.uncut_area == 0 and result.report.gouge < 0.01


def test_a_summit_in_a_slit_without_room_for_a_helix_is_opened_by_a_slot():
    pocket = box(0, 0, 30, 30).union(box(29, 12, 70, 18.2)).union(box(60, 0, 70, 30))
    result = plan(make_request(pocket, strategy=Strategy.ISOTHERM))
    assert result.report.uncut_area == 0 and result.report.gouge < 0.01
    hole = Point(0, 0).buffer(3.05)
    with pytest.raises(CutterDoesNotFitError, match="no room for its helix"):
        plan(make_request(hole, strategy=Strategy.ISOTHERM))


@pytest.mark.parametrize("pocket", [TWO_LOBES, L_SHAPE, TWO_ISLANDS, SIX_POSTS, FOUR_POSTS])
def test_one_slot_opens_all_rooms_and_nothing_is_lifted_over(pocket):
    _, path = path_of(pocket)
    assert isinstance(path.entry, Slot)
    assert entries_of(path) == [path.entry]
    assert all(p.role is not Role.AIR for p in path.passes)


@pytest.mark.parametrize(("pocket", "step"), [(CROSS, 1.8), (CROSS, 0.6), (SIX_POSTS, 0.6)])
def test_laps_lead_to_the_slot_where_it_is_close_to_walls_or_steps_are_fine(pocket, step):
    plan_ = plan(make_request(pocket, strategy=Strategy.ISOTHERM, cutting=Cutting(step)))
    assert lifts_of(plan_) == 0
    assert plan_.report.uncut_area < 1e-3


#: Channels in which a slot fits that keeps off walls less than elsewhere.
CELLS = MultiPoint([(0, 0), (20, 0), (40, 0)]).buffer(8.6).union(box(0, -3.7, 40, 3.7))


def test_a_hot_slot_leads_through_channels_that_are_narrower_than_it_likes():
    region = center_regions(CELLS, 3.0, 0.0)[0]
    slot = hot_slot(region, medial_axis(region), make_request(CELLS))
    assert all(slot.distance(Point(x, 0)) < 3.0 for x in (0, 20, 40))
    plan_ = plan(make_request(CELLS, strategy=Strategy.ISOTHERM))
    assert lifts_of(plan_) == 0
    assert plan_.report.uncut_area < 1e-3


#: Channels hardly wider than the cutter; others in which a lap goes up one side and down the other.
FINS = box(0, 0, 70, 35.4).difference(MultiPolygon([box(7, y, 63, y + 6) for y in (8, 20.7)]))
LADDER = box(0, 0, 70, 46.1).difference(
    MultiPolygon([box(8.7, 8.7, 30.65, 37.4), box(39.35, 8.7, 61.3, 37.4)])
)


@pytest.mark.parametrize(("pocket", "share"), [(FINS, 0.4), (LADDER, 0.4), (LADDER, 0.6)])
def test_narrow_channels_between_islands_are_opened_by_the_slot(pocket, share):
    cutting = Cutting(share * 6.0)
    plan_ = plan(make_request(pocket, strategy=Strategy.ISOTHERM, cutting=cutting))
    assert lifts_of(plan_) == 0
    assert plan_.report.uncut_area < 1e-3


def arc(x: float, y: float, radius: float, start: float, end: float) -> list[tuple[float, float]]:
    """Return points of a counter-clockwise arc."""
    angles = np.linspace(start, end, 40)
    return list(zip(x + radius * np.cos(angles), y + radius * np.sin(angles), strict=True))


def test_a_hot_slot_leads_along_all_ridges_that_cross():
    loops = arc(44, 112, 28, -0.37, 3.74)[::-1] + arc(36, 32, 32, 2.13, 5.7)
    ampersand = LineString([(104, 0), *loops, (95, 58)])
    pocket = ampersand.buffer(7)
    region = center_regions(pocket, 3.0, 0.0)[0]
    slot = hot_slot(region, medial_axis(region), make_request(pocket))
    along = [ampersand.interpolate(share, normalized=True) for share in np.linspace(0, 1, 100)]
    assert max(slot.distance(place) for place in along) < 3.0


#: A room with a small one behind a neck, and another that is hardly narrower before it.
THREE_ROOMS = shapely.union_all(
    [Point(x, y).buffer(r) for x, y, r in ((40, -1, 30), (-4, 11.5, 16.5), (51, -35.5, 18.5))]
)
THREE_ROOMS = THREE_ROOMS.buffer(-3).buffer(6).buffer(-3)


def test_a_hot_slot_goes_on_to_small_rooms_where_it_is_to():
    region = center_regions(THREE_ROOMS, 3.0, 0.0)[0]
    slot = hot_slot(region, medial_axis(region), make_request(THREE_ROOMS), all_rooms=True)
    assert all(slot.distance(Point(x, y)) < 3.0 for x, y in ((40, -1), (-4, 11.5), (51, -35.5)))


@pytest.mark.parametrize("share", [0.1, 0.4])
def test_small_rooms_behind_necks_are_cut_without_lifts(share):
    plan_ = plan(
        make_request(THREE_ROOMS, strategy=Strategy.ISOTHERM, cutting=Cutting(share * 6.0))
    )
    assert lifts_of(plan_) == 0
    assert plan_.report.uncut_area < 1e-3


def test_lifts_count_where_laps_about_all_summits_are_weighed():
    rings = [Point(x, 0).buffer(14).exterior for x in (-13, 13)]
    pocket = shapely.union_all(rings).buffer(4.9)
    _, path = path_of(pocket)
    # to all the noise on so even a ridge they are shorter, but the cutter is lifted 150 times
    assert entries_of(path) == [path.entry]


def test_laps_about_all_summits_are_taken_where_those_about_a_slot_crowd():
    bosses = [Point(x, y).buffer(4.5) for x in (12.2, 67.8) for y in (12.2, 47.8)]
    pocket = box(0, 0, 80, 60).difference(MultiPolygon(bosses))
    region, path = path_of(pocket)
    # about the slot they would be more than four times as long as evenly spaced ones
    assert length_of(path) < 2.5 * region.area / STEP


def lifts_of(plan_: Plan) -> int:
    """Return how often the cutter is lifted before the end."""
    rapid = plan_.toolpath.kinds == Kind.RAPID
    return int((rapid[1:] & ~rapid[:-1]).sum()) - 1


def test_even_laps_are_the_same_on_a_finer_grid():
    region = center_regions(TWO_ISLANDS, 3.0, 0.0)[0]
    request = make_request(TWO_ISLANDS)
    slot = hot_slot(region, medial_axis(region), request)
    family = family_of(region, request, 0.5, 0.0, slot)
    coarse, room = evened(family, outer_room(family))
    fine, finer_room = evened(family, outer_room(family), 2)
    assert fine.field.spacing == coarse.field.spacing / 2
    (one,) = rooms_at(coarse, room, 0.5 * family.heat)
    (other,) = rooms_at(fine, finer_room, 0.5 * family.heat)
    assert one.region.area == pytest.approx(other.region.area, rel=0.01)


@pytest.mark.parametrize("pocket", [TWO_LOBES, L_SHAPE, TWO_ISLANDS])
def test_a_hot_slot_gives_shorter_laps_than_an_even_heat(pocket):
    _, wall = laps_of(pocket)
    _, path = path_of(pocket, cutting=Cutting(STEP, finishing_lap=False))
    creeping = sum(lap.region.length for lap, _ in pairs(wall))
    assert length_of(path) < 0.95 * creeping


def length_of(path: FloorPath) -> float:
    """Return the length of all that is cut [mm]."""
    cuts = [p for p in path.passes if isinstance(p, Pass) and p.role is Role.CUT]
    return sum(LineString(p.points).length for p in cuts)


@pytest.mark.parametrize("pocket", [TWO_LOBES, TWO_ISLANDS, SIX_POSTS])
def test_a_hot_slot_keeps_off_walls_and_is_in_one_piece(pocket):
    region = center_regions(pocket, 3.0, 0.0)[0]
    slot = hot_slot(region, medial_axis(region), make_request(pocket))
    assert slot.is_valid
    assert not slot.interiors
    assert slot.distance(region.boundary) > 0.25 * STEP


@pytest.mark.parametrize("pocket", [CIRCLE, SQUARE, TRIANGLE, PENTAGON])
def test_a_compact_pocket_has_no_ridge(pocket):
    region = center_regions(pocket, 3.0, 0.0)[0]
    assert hot_slot(region, medial_axis(region), make_request(pocket)) is None


def test_field_about_a_hot_disc_is_exact():
    center, inner, outer, heat = (0.3, 0.2), 3.0, 10.0, 40.0
    disc, hot = (Point(center).buffer(r, quad_segs=2000) for r in (outer, inner))
    field = solve(disc, 0.125, hot, heat)
    x, y = np.meshgrid(*field.xy)
    r = np.hypot(x - center[0], y - center[1])
    exact = ring_temperature(r, inner, outer) + heat * np.log(r / outer) / np.log(inner / outer)
    assert np.abs(field.values - exact)[field.inside].max() < 1e-2


def test_a_hot_slot_is_nowhere_a_hairline():
    # between the boss and both walls beside it there is 1 mm for the center
    bosses = [Point(x, y).buffer(5) for x, y in ((14, 14), (46, 26))]
    pocket = box(0, 0, 60, 40).difference(shapely.union_all(bosses))
    request = make_request(pocket, tool_diameter=8.0, cutting=Cutting(1.6))
    region = center_regions(pocket, 4.0, 0.0)[0]
    core = hot_slot(region, medial_axis(region), request).buffer(-0.05 * 1.6)
    assert isinstance(core, Polygon)
    assert not core.is_empty


def test_a_level_ridge_round_an_island_is_opened_by_a_slot():
    _, path = path_of(ROUND_RING)
    assert isinstance(path.entry, Slot)
    assert Polygon(path.entry.ring).contains(Point(0, 0))
    assert all(isinstance(p, Pass) for p in path.passes)


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


def turning(points: np.ndarray) -> np.ndarray:
    """Return how far a path turns at each of its inner points [deg]."""
    steps = np.diff(points, axis=0)
    heading = np.arctan2(*steps[np.hypot(*steps.T) > 1e-6].T[::-1])
    return np.degrees(np.abs((np.diff(heading) + np.pi) % (2 * np.pi) - np.pi))


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


@settings(max_examples=30, deadline=None)
@given(st.floats(20, 170), st.floats(0.02, 1.0))
def test_a_kink_is_spread_and_no_point_moved_too_far(corner, most):
    s = np.arange(0, 12, 0.2)[:, None]
    ahead = np.array([math.cos(math.radians(corner)), math.sin(math.radians(corner))])
    path = np.vstack([np.array([-12, 0]) + s * [1, 0], s * ahead, [12 * ahead]])
    soft = softened(path, 3.0, most)
    np.testing.assert_array_equal(soft[[0, -1]], path[[0, -1]])
    line = LineString(path)
    assert max(line.distance(Point(p)) for p in soft) <= most
    if most > 0.6:  # room enough for the widest
        assert turning(soft).max() < corner / 2


def test_a_path_without_kinks_stays_as_it_is():
    angles = np.linspace(0, 6, 400)
    arc = 5 * np.column_stack([np.cos(angles), np.sin(angles)])
    np.testing.assert_array_equal(softened(arc, 3.0, 0.3), arc)


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


def test_a_hot_slot_that_runs_into_a_corner_is_in_the_plate():
    corners = [(-11.4, 14.1), (16.2, -10.5), (10.5, -23.6), (9.4, -23.4), (-17.7, 10.5)]
    pocket = Polygon(corners)
    region = center_regions(pocket, 3.0, 0.0)[0]
    request = make_request(pocket, strategy=Strategy.ISOTHERM)
    slot = hot_slot(region, medial_axis(region), request)
    family = family_of(region, request, 4 * STEP, None, slot)
    assert family.region.covers(slot)
    assert plan(request).report.uncut_area < 1e-3
