# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls that are not vertical: each level goes as far as they let it, and no farther.

Chatelain et al. 2008, section 3.2, figures 19 and 20: a floor of 100 x 60 mm, corners of
10 mm, walls of 10 to 30 degrees. Checked on the commands against the solid itself.
"""

import math

import Part
import pytest
from FreeCAD import Vector
from sample_parts import (
    DEPTH,
    add_job,
    add_part,
    area,
    block,
    circle,
    faces_at,
    filleted_foot,
    gcode,
    motion,
    rectangle,
    slanted_block,
    stepped_block,
    with_island,
)
from slanted import GOUGE, SCALLOP, TOOL, cut, gouges_of
from solid_oracle import Stock, Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError, SpiralPocketError
from freecad_spiralpocket.op import operation

DEEP = 12.0
#: Around rasters [mm]: no pixel lies exactly on a wall.
MARGIN = 1.03


def levels(op):
    (plan,) = op.Proxy.plans
    return [round(section.z, 6) for section in plan.request.sections]


PARTS = {
    "slanted": lambda: (slanted_block(depth=DEEP), -DEEP, 4.0),
    "island": lambda: (with_island(slanted_block(depth=DEEP), -DEEP), -DEEP, 4.0),
    "one deep level": lambda: (slanted_block(depth=DEEP), -DEEP, 2 * DEEP),
    "fillet": lambda: (filleted_foot(block(area(rectangle(44, 32, 9))), -DEPTH, 2.0), -DEPTH, 2.0),
    "ledge": lambda: (stepped_block(), -DEPTH, 3.0),
}


#: These refuse islands.
WITHOUT_ISLANDS = ("Linear Morph", "Central Spiral")
STRATEGIES = ("Automatic", "Extended Archimedean", "Isotherm", *WITHOUT_ISLANDS)
CASES = [(n, s) for n in PARTS for s in STRATEGIES if n != "island" or s not in WITHOUT_ISLANDS]


@pytest.mark.parametrize(("name", "strategy"), CASES)
def test_nothing_is_gouged_and_only_the_declared_steps_stay(doc, name, strategy, record_property):
    shape, z, step_down = PARTS[name]()
    diameter = TOOL if z == -DEEP else 8.0
    op = cut(doc, shape, z, diameter=diameter, StepDown=step_down, Strategy=strategy)
    (plan,) = op.Proxy.plans
    report, radius = plan.report, op.OpToolDiameter.Value / 2
    # round the ledge's corners the center goes on an arc of 1 mm: wider steps leave more there
    surface, centers = Surface.of(shape), places(motion(op), 0.3)
    assert len(gouges(surface, centers[::5], radius, GOUGE)) == 0
    x0, y0, x1, y1 = (plan.request.sections[0].mouth or plan.request.pocket).bounds
    stock = Stock(surface, (x0 - MARGIN, y0 - MARGIN, x1 + MARGIN, y1 + MARGIN), 0.7)
    stock.cut(centers, radius + SCALLOP)
    left = float(stock.left[stock.part < -0.01].max())
    tops = [0.0, *levels(op)[:-1]]
    width = max(stock.width_left(top - 0.02) for top in tops)
    record_property(
        "steps",
        f"{report.step_width:.2f} x {report.step_height:.2f} mm declared, "
        f"{width:.2f} x {left:.2f} mm left",
    )
    assert left <= report.step_height + 0.05
    assert width <= report.step_width + 1.5 * stock.pixel
    assert report.uncut_area < 0.05 and report.gouge <= op.Tolerance.Value
    assert report.rapid_hit == report.link_hit == 0.0
    told = [notice for notice in op.Notices if "keep steps" in notice]
    assert len(told) == (report.step_width > 0)


@pytest.mark.parametrize("strategy", WITHOUT_ISLANDS)
def test_a_drafted_island_is_refused_by_what_cannot_go_round_it(doc, strategy):
    shape, z, step_down = PARTS["island"]()
    with pytest.raises(SpiralPocketError, match="cannot go round islands"):
        cut(doc, shape, z, StepDown=step_down, Strategy=strategy)


def test_each_level_follows_the_slopes(doc):
    angles = (10, 15, 20, 30)
    op = cut(doc, slanted_block(angles, DEEP), -DEEP, StepDown=4.0)
    (plan,) = op.Proxy.plans
    assert levels(op) == [-4.0, -8.0, -12.0]
    for section in plan.request.sections:
        left, right, front, back = ((section.z + DEEP) * math.tan(math.radians(a)) for a in angles)
        wanted = (-left, -front, 100 + right, 60 + back)
        assert section.pocket.bounds == pytest.approx(wanted, abs=0.002)


@pytest.mark.parametrize("strategy", ["Automatic", "Linear Morph"])
def test_smaller_steps_down_leave_smaller_steps(doc, strategy):
    shape = slanted_block((20, 20, 20, 20), DEPTH, 40.0, 30.0, 6.0)
    part = add_part(doc, shape)
    job = add_job(doc, part)
    widths = []
    for step_down in (DEPTH, DEPTH / 3):
        op = api.add_spiral_pocket(
            job, [(part, faces_at(shape, -DEPTH))], StepDown=step_down, Strategy=strategy
        )
        widths.append(op.Proxy.plans[0].report.step_width)
        assert len(gouges_of(op, shape)) == 0
    # a corner recedes by both walls at once
    slope = math.tan(math.radians(20))
    assert widths[0] == pytest.approx(3 * widths[1], rel=0.02)
    assert DEPTH * slope < widths[0] < 1.01 * math.sqrt(2) * DEPTH * slope


def test_levels_end_on_ledges_and_low_islands(doc):
    shape = with_island(stepped_block(), -DEPTH, -2.5, 0.0, 0.0, (6.0, 5.0))
    op = cut(doc, shape, -DEPTH, diameter=6.0, StepDown=3.0)
    assert levels(op) == [-2.5, -4.0, -6.0]
    assert len(gouges_of(op, shape)) == 0
    heights = Stock(Surface.of(shape), (-31, -21, 31, 21), 0.5)
    heights.cut(places(motion(op), 0.5), 3.0)
    inside = heights.left[2:-2, 2:-2]
    assert inside[heights.part[2:-2, 2:-2] == -4.0].max() < 0.01


def test_a_ledge_that_is_selected_too_is_left_to_its_own_pocket(doc):
    shape = stepped_block()
    part = add_part(doc, shape)
    job = add_job(doc, part)
    both = [(part, [faces_at(shape, -DEPTH)[0], faces_at(shape, -4.0)[0]])]
    op = api.add_spiral_pocket(job, both, StepDown=3.0)
    deep, ledge = sorted(op.Proxy.plans, key=lambda plan: plan.request.floor)
    assert not deep.request.sections and not ledge.request.sections
    assert deep.request.pocket.area < ledge.request.pocket.area


def test_vertical_walls_keep_their_path(doc, monkeypatch):
    shape = block(area(rectangle(50, 36, 6), circle(5, 25, 18)))
    part = add_part(doc, shape)
    job = add_job(doc, part)
    base = [(part, faces_at(shape, -DEPTH))]
    sliced = gcode(api.add_spiral_pocket(job, base, StepDown=2.5))
    monkeypatch.setattr("freecad_spiralpocket.op.sections.fitted", lambda wanted, *_: wanted)
    assert gcode(api.add_spiral_pocket(job, base, StepDown=2.5)) == sliced


def sheared(by, wider=0.0, radius=5.0):
    """Return a block with a slanted hole for a pocket, wider at its floor all around."""
    size = 30 + 2 * wider
    low = rectangle(size, size, radius, by - wider, -wider)
    low.translate(Vector(0, 0, -DEPTH))
    hole = Part.makeLoft([low, rectangle(30, 30, 5)], True, True)
    return Part.makeBox(100, 70, DEPTH + 4, Vector(-20, -20, -DEPTH - 4)).cut(hole)


@pytest.mark.parametrize("step_down", [DEPTH, DEPTH / 2], ids=["one level", "two"])
@pytest.mark.parametrize(("by", "wider", "radius"), [(26, 0, 5), (6, 0, 5), (0, 2, 7), (0, 0.1, 5)])
def test_flat_walls_that_lean_over_are_kept_off_whole(doc, by, wider, radius, step_down):
    """GEOS lost half of them, as two triangles whose edges nearly coincide."""
    shape = sheared(by, wider, radius)
    try:
        op = cut(doc, shape, -DEPTH, diameter=6.0, StepDown=step_down)
    except CutterDoesNotFitError:
        assert by == 26  # 4 mm of it are free from above
        return
    assert len(gouges_of(op, shape, 0.7)) == 0


def test_walls_leaning_over_the_floor_are_kept_clear_of(doc):
    shape = slanted_block((10, -12, 10, 10), DEPTH, 50.0, 36.0, 6.0)
    op = cut(doc, shape, -DEPTH, diameter=6.0, StepDown=2.0)
    assert len(gouges_of(op, shape)) == 0
    lean = DEPTH * math.tan(math.radians(12))
    for section in op.Proxy.plans[0].request.sections:
        assert section.pocket.bounds[2] == pytest.approx(50 - lean, abs=0.01)
    assert any("lean over the floor" in notice for notice in op.Notices)


@pytest.mark.parametrize("radius", [20.0, 45.0])
@pytest.mark.parametrize(
    "groove",
    [
        lambda r: Part.makeCylinder(r + 1.5, 1.6, Vector(0, 0, -5)),
        lambda r: Part.makeTorus(r, 1.5, Vector(0, 0, -4)),
    ],
    ids=["square", "round"],
)
def test_a_groove_in_the_wall_hangs_over_nothing(doc, groove, radius):
    plain = block(area(circle(radius)))  # of which a mesh takes no minutes
    op = cut(doc, plain.cut(groove(radius)), -DEPTH, diameter=8.0, StepDown=DEPTH + 1.0)
    assert op.UncutArea < 0.05 and len(gouges_of(op, plain)) == 0
    assert not any("lean over" in notice for notice in op.Notices)


def test_an_overhung_floor_is_refused_with_the_reason(doc):
    shape = slanted_block((-60, -60, -60, -60), DEPTH, 24.0, 24.0, 1.0)
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=6.0)
    op = operation.Create("Op", parentJob=job)
    op.Base = [(job.Model.Group[0], faces_at(shape, -DEPTH))]
    doc.recompute()
    (error,) = op.Proxy.errors
    assert "cutter" in error.message


def test_a_hole_drilled_across_a_wall_is_no_way_under_it(doc):
    shape = block(area(rectangle(50, 36, 6)))
    across = Part.makeCylinder(4, 30, Vector(45, 18, -DEPTH / 2), Vector(1, 0, 0))
    shape = shape.cut(across)
    op = cut(doc, shape, -DEPTH, diameter=6.0, StepDown=1.0)
    assert len(gouges_of(op, shape)) == 0
    for section in op.Proxy.plans[0].request.sections:
        assert section.pocket.bounds[2] < 50.01


BRIDGES = {
    "beside the middle": lambda: Part.makeBox(8, 40, 2, Vector(40, -5, -3)),
    "in the middle": lambda: Part.makeBox(8, 40, 2, Vector(26, -5, -3)),
    "round": lambda: Part.makeCylinder(4, 40, Vector(30, -5, -2), Vector(0, 1, 0)),
    "two": lambda: Part.makeBox(6, 40, 2, Vector(16, -5, -3)).fuse(
        Part.makeBox(6, 40, 3, Vector(38, -5, -3))
    ),
}


@pytest.mark.parametrize("name", BRIDGES)
def test_all_sides_of_a_bridge_are_cleared_and_it_is_kept_clear_of(doc, name):
    shape = block(area(rectangle(60, 30, 5))).fuse(BRIDGES[name]()).removeSplitter()
    op = cut(doc, shape, -DEPTH, diameter=6.0, StepDown=2.0)
    assert len(gouges_of(op, shape)) == 0 and op.UncutArea < 0.05
    heights = Stock(Surface.of(shape), (0.5, 0.5, 59.5, 29.5), 0.5)
    heights.cut(places(motion(op), 0.3), 3.0 + SCALLOP)
    standing = (heights.part == -DEPTH) & (heights.heights > -DEPTH + 0.01)
    # in the corners between bridge and walls, four on each bridge
    assert standing.sum() * heights.pixel**2 < 20.0
    told = next(notice for notice in op.Notices if "lean over the floor" in notice)
    assert float(told.split("; ")[1].split()[0]) < 31 * 15
