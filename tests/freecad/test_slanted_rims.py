# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slanted walls beside holes in the floor, the outside of the part, and tops that are not level."""

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
    faces_at,
    motion,
    rectangle,
    slanted_block,
    stepped_block,
)
from slanted import SCALLOP, cut, gouges_of
from solid_oracle import Stock, Surface, places

from freecad_spiralpocket import api


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
