# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loops that come nearer to the wall level by level: engaged as a lap, and nothing stays."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import LineString, Point, Polygon, box, union_all
from shapes import DUMBBELL, L_SHAPE, SQUARE, lifts, request, rounded

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.floor import Descent, Slot, Stairs
from freecad_spiralpocket.engine.growth.corners import levels_from
from freecad_spiralpocket.engine.growth.front_rules import WIDEST, rules_of
from freecad_spiralpocket.engine.growth.fronts import FLAT
from freecad_spiralpocket.engine.growth.strokes import Stroke
from freecad_spiralpocket.engine.laps import automatic
from freecad_spiralpocket.engine.model import Cutting, Entry, Heights
from freecad_spiralpocket.engine.opening import starts, wall_slot
from freecad_spiralpocket.engine.opening.slot import slot_path
from freecad_spiralpocket.engine.opening.stairs import leaves_crumbs, stairs_of
from freecad_spiralpocket.engine.opening.start import slot_bite
from freecad_spiralpocket.engine.shapes.polyline import closed_line
from freecad_spiralpocket.engine.shapes.shaping import simplified_region
from freecad_spiralpocket.engine.toolpath import Role

R = 3.0
DEEP = Heights(8.0, 3.0, 1.0, -5.0, 7.0)
ROUND = Point(0, 0).buffer(30, quad_segs=128)
LONG = rounded(box(0, 0, 150, 30), 4.0)
POCKETS = {"square": SQUARE, "L": L_SHAPE, "dumbbell": DUMBBELL, "round": ROUND, "long": LONG}


def region_of(pocket: Polygon) -> Polygon:
    return shapely.simplify(pocket.buffer(-R, quad_segs=64), 0.001)


def stairs(pocket: Polygon, **changes) -> tuple[Stairs | None, Polygon]:
    asked = request(pocket, **{"heights": DEEP, **changes})
    region = region_of(pocket)
    ring = np.array(shapely.geometry.polygon.orient(region).exterior.coords)[:-1]
    found = stairs_of(ring, region, slot_bite(asked), asked, 0.0)
    return found and found[0], region


def distances(made: Stairs) -> np.ndarray:
    """Return how far each line and the inner one are off the wall, point by point."""
    lines = np.concatenate([made.lines, made.inner[None]])
    return np.hypot(*np.moveaxis(lines - made.lines[-1], 2, 0))


@pytest.mark.parametrize("name", POCKETS)
def test_last_loop_runs_along_the_wall_and_each_is_nearer_to_it_than_the_one_above(name):
    made, region = stairs(POCKETS[name])
    assert closed_line(made.lines[-1]).hausdorff_distance(region.exterior) < 1e-9
    off = distances(made)
    assert (np.diff(off[:-1], axis=0) <= 1e-9).all()
    assert made.drops.sum() == pytest.approx(1)
    for line in made.lines:
        assert region.buffer(1e-6).covers(Polygon(line))


@pytest.mark.parametrize(
    ("stepover", "depth"), [(2.4, 6.0), (2.4, 5.0), (1.8, 4.0), (2.6, 9.0), (1.5, 12.0)]
)
def test_loops_are_no_more_engaged_than_laps_and_remove_no_more_than_the_widest(stepover, depth):
    heights = replace(DEEP, start_depth=1.0, final_depth=1.0 - depth, step_down=20.0)
    asked = request(LONG, heights=heights, cutting=Cutting(stepover))
    made, _ = stairs(LONG, heights=heights, cutting=Cutting(stepover))
    rules = rules_of(asked)
    # at a straight wall
    off = distances(made)[:, np.argmin(np.hypot(*(made.lines[-1] - (75, 3)).T))]
    above = 0.0
    for drop, before, here in zip(made.drops, [off[0], *off[:-2]], off[:-1], strict=True):
        rib = before - here
        angle = math.pi * drop + math.acos(1 - rib / R) * above
        assert angle <= rules.limit + 1e-6
        assert 2 * R * drop + rib * above <= WIDEST * rules.stepover + 1e-6
        assert drop * depth <= slot_bite(asked) + 1e-9
        above += drop
    # the first lap, a step-over from the inner line, meets what they leave
    lap = off[-1] + rules.stepover
    left = made.drops * np.arccos(np.clip((R + off[:-1] - lap) / R, -1, 1))
    assert left.sum() <= rules.limit + 2e-3
    # and reaches over it to what is cleared down to the floor
    assert lap - R <= R


def test_on_a_disc_lines_are_circles():
    made, _ = stairs(ROUND)
    for off in distances(made):
        assert np.ptp(off) < 0.01
    assert distances(made)[0].max() > R


def test_lines_meet_in_corners():
    made, region = stairs(LONG)
    off = distances(made)
    for corner in [(3, 3), (147, 3), (147, 27), (3, 27)]:
        near = np.hypot(*(made.lines[-1] - corner).T) < 0.5
        assert near.any() and off[:, near].max() < 0.1
    assert region.buffer(1e-6).covers(LineString(made.inner))


def test_where_no_lap_goes_between_all_loops_run_along_the_wall():
    rooms = box(-60, -25, -12, 25).union(box(12, -25, 60, 25))
    made, _ = stairs(rounded(rooms.union(box(-13, -6.5, 13, 6.5)), 3.5))
    off = distances(made)
    narrow = np.abs(made.lines[-1][:, 0]) < 6
    assert narrow.any() and off[:, narrow].max() < 1e-9
    assert off.max() > 1


def test_no_stairs_where_one_level_does():
    made, _ = stairs(LONG, entry=Entry(slot_bite=6.0))
    assert made is None


@pytest.mark.parametrize("name", POCKETS)
@pytest.mark.parametrize("angle", [2.0, 5.0])
def test_each_loop_is_cut_whole_at_its_level(name, angle):
    made, region = stairs(POCKETS[name])
    bite = 1.8
    ring = made.lines[-1]
    down = Descent(1.0, -5.0, math.radians(angle))
    path = slot_path(Slot(ring, bite, made), down)
    floors = down.top - down.depth * np.cumsum(made.drops)
    for line, floor in zip(made.lines, floors, strict=True):
        deep = path[:, 2] <= floor + 1e-6
        cut = LineString(path[deep][:, :2])
        # the next ramp may begin before the loop is closed; it goes below that level at once
        far = shapely.distance(cut, shapely.points(line)).max()
        assert far < 0.02
    assert region.buffer(1e-6).covers(LineString(path[:, :2]))
    flat = np.hypot(*np.diff(path[:, :2], axis=0).T)
    slope = -np.diff(path[:, 2])
    assert (slope >= -1e-9).all()
    assert slope.max() <= flat[np.argmax(slope)] * math.tan(down.angle) * 1.1
    np.testing.assert_allclose(path[-1], [*made.inner[0], -5.0], atol=1e-6)


@pytest.mark.parametrize("pocket", [SQUARE, L_SHAPE, LONG], ids=["square", "L", "long"])
@pytest.mark.parametrize("last", [2.0, 4.0])
def test_a_thin_last_level_is_opened_in_fewer_loops_as_gently(pocket, last):
    """What is as deep as the others takes as long; what is left of a pocket's depth does not."""
    reports = []
    for depth in (6.0, 6.0 + last, 12.0):
        heights = Heights(8.0, 3.0, 0.0, -depth, 6.0)
        reports.append(plan(request(pocket, heights=heights)).report)
    one, thin, two = reports
    assert thin.time < two.time - 0.05 * one.time
    assert thin.uncut_area == 0 and thin.gouge < 0.01
    assert thin.engagement_p99 < one.engagement_p99 + math.radians(1)
    assert thin.over_limit_share <= one.over_limit_share + 1e-3


def test_thin_level_is_cut_by_the_loop_along_the_wall():
    made, region = stairs(SQUARE)
    path = slot_path(Slot(made.lines[-1], 1.8, made), Descent(-4.5, -5.0, math.radians(5)))
    length = np.hypot(*np.diff(path[:, :2], axis=0).T).sum()
    assert length < 1.5 * region.exterior.length
    floor = LineString(path[path[:, 2] < -5 + 1e-6][:, :2])
    assert shapely.distance(floor, shapely.points(made.lines[-1])).max() < 0.01


def test_crumbs_are_found_where_the_first_lap_is_too_far():
    made, _ = stairs(SQUARE)
    inner = Polygon(made.inner)
    near, far = (
        Stroke(np.array(inner.buffer(-d).exterior.coords)[:-1], 1, True, False) for d in (1.5, 3.5)
    )
    assert not leaves_crumbs(made, [near], R)
    assert leaves_crumbs(made, [far], R)
    assert leaves_crumbs(made, [], R)


@pytest.mark.parametrize("name", ["square", "L", "long"])
def test_pocket_is_cut_sooner_whole_and_as_gently(name, monkeypatch):
    asked = request(POCKETS[name], heights=DEEP)
    result = plan(asked)
    monkeypatch.setattr(wall_slot, "stairs_of", lambda *_: None)
    plain = plan(asked)
    assert result.report.time < 0.97 * plain.report.time
    assert result.report.uncut_area < 1e-3
    assert result.report.gouge <= 0.01
    assert result.report.link_hit == 0 and lifts(result) == 1
    assert result.report.over_limit_share < 0.002
    assert result.report.engagement_p99 < result.report.engagement_limit + math.radians(7)


def test_wall_is_cut_in_one_at_the_full_depth():
    path = plan(request(LONG, heights=DEEP)).toolpath
    # where moves along the long wall pass its middle
    entry = (path.roles == Role.ENTRY) & (path.starts[:, 0] < 75) & (path.points[:, 0] >= 75)
    share = (75 - path.starts[entry, 0]) / (path.points - path.starts)[entry, 0]
    _, y, z = (path.starts[entry] + share[:, None] * (path.points - path.starts)[entry]).T
    near = y < 12
    assert near.sum() == 4
    assert z[near & (y < 3.01)] == pytest.approx(-5.0)


@settings(max_examples=8, deadline=None)
@given(
    wide=st.floats(28, 70),
    high=st.floats(28, 70),
    radius=st.floats(3.1, 12),
    stepover=st.floats(1.2, 2.6),
    depth=st.floats(2.5, 9),
)
def test_rectangles_of_any_size_are_cut_whole(wide, high, radius, stepover, depth):
    pocket = rounded(box(0, 0, wide, high), radius)
    heights = replace(DEEP, start_depth=0.0, final_depth=-depth, step_down=10.0)
    report = plan(request(pocket, heights=heights, cutting=Cutting(stepover))).report
    assert report.uncut_area < 0.02
    assert report.gouge <= 0.01 and report.link_hit == 0
    assert report.entry_bite <= 1.8 + 1e-6
    assert report.engagement_p99 < report.engagement_limit + math.radians(12)


def test_no_stairs_where_no_lap_begins_at_their_end():
    """Their floor is not clear: at a fine step-over the first lap begins far from a corner."""
    pocket = union_all([box(0, 0, 120, 25), box(0, 0, 25, 49), box(95, 0, 120, 49)])
    pocket = rounded(pocket, 5.9)
    asked = request(
        pocket,
        tool_diameter=10.0,
        cutting=Cutting(1.0),
        heights=Heights(6.0, 3.0, 1.0, -4.12, 6.0),
    )
    made = plan(asked)
    assert made.report.notices == ()
    assert lifts(made) == 1


def test_plug_has_no_more_points_than_a_front():
    asked = request(SQUARE, heights=DEEP)
    (start,) = (s for s in starts.candidates(region_of(SQUARE), asked) if s.plain)
    few, count = shapely.get_num_coordinates(
        [simplified_region(start.visited, FLAT), start.visited]
    )
    assert few > 0.95 * count


def test_slot_without_stairs_is_only_grown_where_it_may_be_faster(monkeypatch):
    cross = box(-25, -6, 25, 6).union(box(-6, -25, 6, 25))
    asked = request(box(-40, -40, 40, 40).difference(cross), heights=DEEP)
    grown = []

    def counted(start, *rest):
        grown.append(start)
        return levels_from(start, *rest)

    monkeypatch.setattr(automatic, "levels_from", counted)
    made = plan(asked)
    few = len(grown)
    # all links spared: what stairs save never makes up for them
    monkeypatch.setattr(automatic, "SPARED", np.inf)
    assert plan(asked).report.time == made.report.time
    assert len(grown) - few == few + 1
