# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls that are not vertical: each level goes as far as they let it, and no farther.

Chatelain et al. 2008, section 3.2, figures 19 and 20: a floor of 100 x 60 mm, corners of
10 mm, walls of 10 to 30 degrees. Checked on the commands against the solid itself.
"""

import math

import numpy as np
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
from solid_oracle import Stock, Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError, SpiralPocketError
from freecad_spiralpocket.op import operation

#: Deepest gouge that may be, into the solid's true surface [mm].
GOUGE = 0.01
DEEP = 12.0
TOOL = 16.0
#: Around rasters [mm]: no pixel lies exactly on a wall.
MARGIN = 1.03
#: What stands between the places where the cutter is looked at [mm].
SCALLOP = 0.02


def cut(doc, shape, z, index=0, diameter=TOOL, **options):
    """Return an operation on the floor at `z` of a new part."""
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=diameter)
    return api.add_spiral_pocket(job, [(part, [faces_at(shape, z)[index]])], **options)


def levels(op):
    (plan,) = op.Proxy.plans
    return [round(section.z, 6) for section in plan.request.sections]


def gouges_of(op, shape, step=1.5):
    radius = op.OpToolDiameter.Value / 2
    return gouges(Surface.of(shape), places(motion(op), step), radius, GOUGE)


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


def test_holes_in_the_floor_are_no_islands(doc):
    shape = slanted_block((20, 20, 20, 20), DEPTH, 40.0, 30.0, 6.0)
    shape = shape.cut(Part.makeCylinder(3, 40, Vector(20, 15, -30)))
    op = cut(doc, shape, -DEPTH, diameter=6.0, StepDown=2.0)
    assert all(not section.pocket.interiors for section in op.Proxy.plans[0].request.sections)


@pytest.mark.parametrize("high", [0.0, -2.0])
def test_what_stands_up_through_a_hole_in_the_floor_is_an_island(doc, high):
    shape = block(area(rectangle(50, 30, 5)), below=14.0)
    shape = shape.cut(Part.makeCylinder(8, 40, Vector(25, 15, -DEPTH - 8)))
    shape = shape.fuse(Part.makeCylinder(4, DEPTH + 8 + high, Vector(25, 15, -DEPTH - 8)))
    op = cut(doc, shape, -DEPTH, diameter=6.0, StepDown=3.0)
    assert len(gouges_of(op, shape)) == 0
    heights = Stock(Surface.of(shape), (0.5, 0.5, 49.5, 29.5), 0.7)
    heights.cut(places(motion(op), 0.3), 3.0 + SCALLOP)
    on_floor = heights.left[2:-2, 8:-8][heights.part[2:-2, 8:-8] == -DEPTH]
    assert on_floor.max() < 0.01


def plate_with_a_hole():
    return block(area(rectangle(60, 40, 6)), below=8.0).cut(
        Part.makeCylinder(8, 40, Vector(30, 20, -30))
    )


def half_a_rim(low, high=0.0):
    """Return a wall around half of the hole, `low` wide at the floor and 3 mm at Z `high`."""
    rim = Part.makeCone(8 + low, 11, high + DEPTH, Vector(30, 20, -DEPTH))
    hole = Part.makeCylinder(8, 40, Vector(30, 20, -30))
    return rim.cut(hole).common(Part.makeBox(30, 40, 40, Vector(0, 0, -30)))


WALLS_AT_A_HOLE = {
    "rim": lambda: half_a_rim(3.001),
    "low rim": lambda: half_a_rim(3.001, -2.0),
    "rim with draft": lambda: half_a_rim(4.0),
    "bar into it": lambda: Part.makeBox(14, 8, 14, Vector(34, 16, -14)),
    "web across it": lambda: Part.makeBox(40, 8, 14, Vector(10, 16, -14)),
}


@pytest.mark.parametrize("name", WALLS_AT_A_HOLE)
def test_a_hole_with_a_wall_on_a_part_of_its_rim_is_free_beside_that(doc, name):
    shape = plate_with_a_hole().fuse(WALLS_AT_A_HOLE[name]()).removeSplitter().Solids[0]
    op = cut(doc, shape, -DEPTH, diameter=6.0, StepDown=3.0)
    assert len(gouges_of(op, shape)) == 0
    heights = Stock(Surface.of(shape), (6.5, 6.5, 53.5, 33.5), 0.7)
    heights.cut(places(motion(op), 0.3), 3.0 + SCALLOP)
    # in the sharp corners beside a bar or a web the round cutter leaves a little
    standing = (heights.part <= -DEPTH) & (heights.heights > -DEPTH + 0.01)
    assert standing.sum() * heights.pixel**2 < 1.0 + op.UncutArea


def turned_ledge():
    """Return a ledge all around whose part's own sides lie over the pocket by their boxes."""
    shape = stepped_block()
    shape.rotate(Vector(), Vector(0, 0, 1), 37)
    return shape


def slanted_disc():
    return slanted_block((10, 10, 10, 10), DEPTH, 40.0, 30.0, 6.0).common(
        Part.makeCylinder(27, 40, Vector(20, 15, -30))
    )


def round_bar():
    """Return a lying bar with a pocket, whose walls end on the round."""
    bar = Part.makeCylinder(25, 100, Vector(-30, 15, -22), Vector(1, 0, 0))
    floor = area(rectangle(40, 24, 5, 0, 3))
    floor.translate(Vector(0, 0, -DEPTH))
    return bar.cut(floor.extrude(Vector(0, 0, 2 * DEPTH)))


@pytest.mark.parametrize("shape", [turned_ledge, slanted_disc, round_bar])
def test_the_parts_own_outside_is_no_island(doc, shape):
    solid = shape()
    op = cut(doc, solid, -DEPTH, diameter=6.0, StepDown=2.0)
    assert op.UncutArea < 0.05 and len(gouges_of(op, solid)) == 0
    assert not any("lean over" in notice for notice in op.Notices)


def test_a_slanted_pocket_open_at_a_side_stays_within_its_floor_there(doc):
    shape = slanted_block((20, 20, 20, 20), DEPTH, 40.0, 30.0, 6.0)
    shape = shape.cut(Part.makeBox(40, 60, 40, Vector(30, -15, -30)))
    op = cut(doc, shape, -DEPTH, diameter=6.0, StepDown=2.0, ExtendOpenSides=False)
    (plan,) = op.Proxy.plans
    slope = math.tan(math.radians(20))
    for section in plan.request.sections:
        wider = (section.z + DEPTH) * slope
        wanted = (-wider, -wider, 30, 30 + wider)
        assert section.pocket.bounds == pytest.approx(wanted, abs=0.01)
    assert len(plan.request.sections) == 3
    assert any("open at a side" in notice for notice in op.Notices)
    assert len(gouges_of(op, shape)) == 0


def sloping_block():
    """Return a drafted pocket in a part whose top slopes."""
    above = Part.makeBox(120, 100, 40, Vector(-40, -40, 0))
    above.rotate(Vector(-40, 15, 0), Vector(0, 1, 0), 3)
    return slanted_block((15, 15, 15, 15), DEPTH, 40.0, 30.0, 6.0).cut(above)


def bar_with_draft():
    """Return a drafted pocket in a lying bar."""
    bar = Part.makeCylinder(30, 100, Vector(-30, 15, -28), Vector(1, 0, 0))
    return slanted_block((15, 15, 15, 15), 14.0, 40.0, 20.0, 6.0).common(bar)


@pytest.mark.parametrize(("shape", "depth"), [(sloping_block, DEPTH), (bar_with_draft, 14.0)])
def test_above_a_rim_that_is_not_level_the_pocket_goes_no_narrower(doc, shape, depth):
    solid = shape()
    op = cut(doc, solid, -depth, diameter=6.0, StepDown=2.0)
    assert len(gouges_of(op, solid)) == 0 and op.UncutArea < 0.05
    sections = op.Proxy.plans[0].request.sections
    areas = [section.pocket.area for section in sections]
    assert areas == sorted(areas, reverse=True) and areas[0] > 1.01 * areas[-1]


def test_stock_above_the_part_is_cut_in_the_shape_of_the_rim(doc):
    shape = slanted_block((20, 20, 20, 20), DEPTH, 40.0, 30.0, 6.0)
    part = add_part(doc, shape)
    job = add_job(doc, part)
    job.Stock.ExtZpos = 3.0
    doc.recompute()
    op = api.add_spiral_pocket(job, [(part, faces_at(shape, -DEPTH))], StepDown=2.0)
    tops = [s.pocket.area for s in op.Proxy.plans[0].request.sections if s.z > -0.5]
    rim = (40 + 2 * DEPTH * math.tan(math.radians(20))) * (
        30 + 2 * DEPTH * math.tan(math.radians(20))
    )
    assert len(tops) >= 1 and np.ptp(tops) < 0.01
    assert tops[0] == pytest.approx(rim - (4 - math.pi) * 6**2, rel=1e-3)
