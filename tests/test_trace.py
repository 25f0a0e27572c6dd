# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window draws of a plan is the plan: same way, same time, same ground."""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely
from shapely import Point, Polygon, box

sys.path.insert(0, str(Path(__file__).parent / "engine"))
import shapes

from freecad_spiralpocket.beside.tasks import Tasks
from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.draft import draft, openings
from freecad_spiralpocket.engine.model import CutMode, Cutting
from freecad_spiralpocket.engine.toolpath import Role
from freecad_spiralpocket.trace import areas_of, loaded_level, pieces_without_holes, trace_of


@pytest.fixture(scope="module")
def square():
    """Return a plan of a square pocket."""
    return plan(shapes.request(shapes.SQUARE))


def test_trace_is_as_long_and_takes_as_long_as_the_path(square):
    trace = trace_of(square)
    length = np.linalg.norm(np.diff(trace.points, axis=0), axis=1).sum()
    assert length == pytest.approx(square.toolpath.lengths.sum(), rel=2e-3)
    assert trace.clock[-1] == pytest.approx(square.report.time, rel=1e-6)
    assert (np.diff(trace.clock) >= 0).all()
    assert trace.points[-1] == pytest.approx(square.toolpath.points[-1])


def test_trace_goes_through_every_corner_with_the_role_of_its_move(square):
    trace, path = trace_of(square), square.toolpath
    gaps = np.linalg.norm(trace.points[:, None] - path.points[None], axis=2).min(axis=0)
    assert gaps.max() < 1e-6
    assert set(trace.roles.tolist()) == set(path.roles.tolist())
    assert (trace.angles[trace.roles == Role.AIR] == 0).all()
    cut = trace.angles[trace.roles == Role.CUT]
    assert cut.max() == pytest.approx(square.report.engagement_angles.max(), rel=0.05)


def test_areas_make_up_the_floor():
    ring = plan(shapes.request(shapes.RING))
    areas = areas_of(ring)
    total = sum(Polygon(r).area for r in (*areas.cleared, *areas.left))
    assert total == pytest.approx(shapes.RING.area, rel=2e-3)
    assert len(areas.walls) == 2 and len(areas.islands) == 1


@pytest.mark.parametrize("holes", [0, 1, 3])
def test_pieces_have_no_holes_and_the_same_area(holes):
    polygon = box(0, 0, 40, 10)
    for i in range(holes):
        polygon = polygon.difference(Point(8 + 11 * i, 5).buffer(3))
    pieces = [Polygon(r) for r in pieces_without_holes([polygon])]
    assert shapely.union_all(pieces).symmetric_difference(polygon).area < 1e-9
    assert sum(p.area for p in pieces) == pytest.approx(polygon.area)


@pytest.mark.parametrize("pocket", [shapes.SQUARE, shapes.L_SHAPE, shapes.RING])
def test_draft_stays_where_the_center_may_be_and_ends_at_the_wall(pocket):
    request = shapes.request(pocket)
    made = draft(request)
    room = pocket.buffer(-request.cutter_radius)
    laps = shapely.multilinestrings([shapely.linestrings(lap) for lap in made.laps])
    assert room.buffer(0.1).contains(laps)
    assert room.boundary.buffer(0.1).difference(laps.buffer(0.2)).area < 0.05 * room.length


@pytest.mark.parametrize(
    "pocket", [shapes.SQUARE, shapes.L_SHAPE, shapes.RING, shapely.box(0, 0, 90, 16)]
)
@pytest.mark.parametrize("stepover", [0.9, 2.4])
def test_laps_of_a_draft_are_a_step_apart_at_most(pocket, stepover):
    request = shapes.request(pocket, cutting=Cutting(stepover=stepover))
    made = draft(request)
    room = pocket.buffer(-request.cutter_radius)
    lines = shapely.multilinestrings([shapely.linestrings(p) for p in made.laps])
    visited = [shapely.Polygon(p).buffer(0.6 * stepover) for p in made.entries]
    near = shapely.union_all([lines.buffer(0.6 * stepover), *visited])
    # what is left are corners
    assert room.difference(near).area < 0.02 * room.area


def test_known_openings_give_the_same_draft_at_any_stepover():
    wide = shapes.request(shapes.RING, cutting=Cutting(stepover=3.0))
    known = draft(wide, openings(shapes.request(shapes.RING)))
    fresh = draft(wide)
    assert len(known.laps) == len(fresh.laps)
    for a, b in zip(known.laps, fresh.laps, strict=True):
        np.testing.assert_array_equal(a, b)


def test_draft_of_conventional_milling_is_not_mirrored_away():
    cutting = Cutting(stepover=2.4, cut_mode=CutMode.CONVENTIONAL)
    made = draft(shapes.request(shapes.L_SHAPE, cutting=cutting))
    points = np.concatenate(made.laps)
    assert points.min() > 0


def test_draft_of_a_pocket_in_other_stock_is_made_anew():
    tasks = Tasks()
    closed = shapes.request(box(0, 0, 60, 24))
    opened = replace(closed, stock=box(-20, -20, 50, 50), beyond=box(50, 0, 60, 24))
    for asked in (closed, opened, closed):
        (made,) = tasks.draft(asked, lambda *_: False).entries
        (fresh,) = draft(asked).entries
        np.testing.assert_array_equal(made, fresh)


def test_a_picture_from_above_shows_a_full_level_not_a_thin_last_one():
    heights = np.repeat([-6.0, -12.0, -14.0], 5)
    assert loaded_level(heights, np.repeat([1.3, 1.3, 0.4], 5)) == pytest.approx(-12.0)
    assert loaded_level(heights, np.repeat([1.3, 1.3, 1.2], 5)) == pytest.approx(-14.0)
    deep = replace(shapes.HEIGHTS, final_depth=-12.0, step_down=5.0)
    result = plan(shapes.request(shapes.SQUARE, heights=deep))
    report = result.report
    cut = result.toolpath.roles[report.engagement_moves] == Role.CUT
    shown = loaded_level(report.engagement_points[cut, 2], report.engagement_angles[cut])
    assert shown == pytest.approx(-10.0)
