# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is cut above ledges, ribs and bosses beside a selected floor, and what is none of it."""

import math

import numpy as np
import Part
import pytest
from FreeCAD import Vector
from sample_parts import add_job, add_part, box, faces_at, motion
from solid_oracle import Stock, Surface, gouges, places

from freecad_spiralpocket import api

R, A, B, RIB = 4.0, -14.0, -17.0, -4.0


def side_by_side(gap, joint):
    """Return a plate with two pockets, A deep and B, joined above the rib by a gap that wide."""
    shape = box(0, 0, -24, 100, 50, 24)
    shape = shape.cut(box(10, 10, A, 30, 30, 20)).cut(box(60, 10, B, 30, 30, 20))
    return shape.cut(box(35, 25 - gap / 2, joint, 30, gap, 20)).removeSplitter()


def machined(doc, shape, *heights, **options):
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=2 * R)
    names = [name for z in heights for name in faces_at(shape, z)]
    return api.add_spiral_pocket(job, [(part, names)], StepDown=5.0, **options)


def centers(op):
    """Return the places of the cutter's center below the plate's top."""
    found = places(motion(op), 0.4)
    return found[found[:, 2] < -0.01]


@pytest.mark.parametrize("gap", [4.0, 20.0])
@pytest.mark.parametrize("start", [0.0, 3.0])
def test_pocket_beside_that_is_not_selected_is_left_alone(doc, gap, start):
    shape = side_by_side(gap, RIB)
    op = machined(doc, shape, A, StartDepth=start)
    reached = centers(op)
    # a little way into the mouth of the narrow one
    assert reached[:, 0].max() < (36.6 if gap < 2 * R else 56.1)
    assert len(gouges(Surface.of(shape), reached, R, 0.01)) == 0
    assert not [notice for notice in op.Notices if "engagement" not in notice]
    floor = Stock(Surface.of(shape), (10.5, 10.5, 39.5, 39.5), 0.5)
    floor.cut(reached, R + 0.02)
    assert (floor.heights > A + 0.01).sum() * 0.25 < 4 * R**2  # the corners


def slot(x0, y0, x1, y1, width, z):
    """Return a slot with round ends as a solid from `z` up."""
    length = math.hypot(x1 - x0, y1 - y0)
    whole = box(0, -width / 2, z, length, width, 60)
    whole.rotate(Vector(), Vector(0, 0, 1), math.degrees(math.atan2(y1 - y0, x1 - x0)))
    whole.translate(Vector(x0, y0, 0))
    ends = [Part.makeCylinder(width / 2, 60, Vector(x, y, z)) for x, y in ((x0, y0), (x1, y1))]
    return whole.fuse(ends).removeSplitter()


def test_channel_hardly_wider_than_the_cutter_keeps_no_steps(doc):
    shape = box(90, 50, -44, 150, 170, 44)
    shape = shape.cut(box(120, 105, -20, 38, 90, 40)).cut(box(128, 98, -28, 22, 104, 60))
    shape = shape.cut(slot(120, 70, 210, 95, 30, -34)).cut(slot(150, 110, 180, 92, 6.3, -26))
    part = add_part(doc, shape.removeSplitter())
    job = add_job(doc, part)
    (floor,) = faces_at(part.Shape, -28.0)
    op = api.add_spiral_pocket(job, [(part, [floor])], StepDown=6.0)
    assert not [notice for notice in op.Notices if "keep steps" in notice]
    areas = {section.pocket.area for section in op.Proxy.plans[0].request.sections}
    assert len(areas) == 3  # of floor, channel and ledge


def test_stock_above_a_hub_beside_an_open_side_is_no_step(doc):
    hub = Part.makeCylinder(45, 40, Vector(0, 0, -40))
    at = 52 / math.sqrt(2)
    lug = Part.makeCylinder(12, 14, Vector(at, at, -40))
    shape = hub.fuse(lug).cut(Part.makeCylinder(7.5, 30, Vector(at, at, -31))).removeSplitter()
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=10.0)
    job.Stock.ExtZpos = 1.0
    doc.recompute()
    op = api.add_spiral_pocket(job, [(part, faces_at(shape, -26.0))], StepDown=10.0)
    assert len(gouges(Surface.of(shape), places(motion(op), 0.4), 5.0, 0.01)) == 0
    assert not [notice for notice in op.Notices if "keep steps" in notice]


def test_both_are_cut_where_both_are_selected(doc):
    shape = side_by_side(20.0, RIB)
    reached = centers(machined(doc, shape, A, B))
    surface = Surface.of(shape)
    assert len(gouges(surface, reached, R, 0.01)) == 0
    stock = Stock(surface, (41.0, 16.0, 59.0, 34.0), 0.5)
    stock.cut(reached, R + 0.02)
    assert (stock.heights < RIB + 0.01).all()
    assert np.isclose(reached[reached[:, 0] > 65][:, 2].min(), B)


def test_holes_in_a_ledge_are_passed_over(doc):
    shape = box(0, 0, -20, 90, 60, 20).cut(box(5, 5, -5, 80, 50, 20))
    shape = shape.cut(box(10, 15, -12, 30, 30, 20))
    shape = shape.cut(Part.makeCylinder(9, 40, Vector(62, 30, -30))).removeSplitter()
    op = machined(doc, shape, -12.0)
    above = op.Proxy.plans[0].request.sections[0].pocket
    assert above.area == pytest.approx(80 * 50) and not above.interiors
    (told,) = [notice for notice in op.Notices if "ledges" in notice]
    assert "Above Z-5 also 3100 mm2" in told


def test_narrow_ledges_are_not_told(doc):
    shape = box(0, 0, -20, 90, 60, 20).cut(box(5, 5, -5, 80, 50, 20))
    shape = shape.cut(box(10, 10, -12, 70, 40, 20)).removeSplitter()
    told = machined(doc, shape, -12.0).Notices
    assert not [notice for notice in told if "ledges" in notice]


def test_plateaus_are_floors_where_the_part_is_higher_elsewhere(doc):
    shape = box(0, 0, -16, 96, 96, 16)
    for i in range(16):
        x, y = divmod(i, 4)
        shape = shape.cut(box(8 + 20 * x, 8 + 20 * y, -5 - 2 * ((x + y) % 2), 20, 20, 20))
    shape = shape.removeSplitter()
    op = machined(doc, shape, -5.0, -7.0)
    assert not op.Proxy.errors
    reached, surface = centers(op), Surface.of(shape)
    assert len(gouges(surface, reached, R, 0.01)) == 0
    stock = Stock(surface, (8.5, 8.5, 87.5, 87.5), 0.5)
    stock.cut(reached, R + 0.02)
    plateaus = stock.part > -5.1
    assert (stock.left[plateaus] > 0.01).sum() * 0.25 < R**2  # the corners
    (told,) = [notice for notice in op.Notices if "open at a side" in notice]
    assert told.count("Face") == 8


def test_low_boss_is_cut_with_the_pocket_around_it(doc):
    shape = box(0, 0, -20, 80, 60, 20).cut(box(8, 8, -14, 64, 44, 30))
    shape = shape.fuse(box(30, 20, -14, 20, 12, 6)).removeSplitter()
    op = machined(doc, shape, -14.0, -8.0)
    assert not op.Proxy.errors
    stock = Stock(Surface.of(shape), (30.5, 20.5, 49.5, 31.5), 0.5)
    stock.cut(centers(op), R + 0.02)
    assert stock.left.max() < 0.01


def notched(width, depth=9.0):
    """Return a plate with a pocket A deep that has a notch 8 deep in its wall, so wide."""
    shape = box(0, 0, -24, 100, 50, 24).cut(box(10, 10, A, 60, 30, 20))
    return shape.cut(box(70, 25 - width / 2, -8, depth, width, 20)).removeSplitter()


@pytest.mark.parametrize("width", [3.0, 6.0, 7.9])
def test_a_notch_narrower_than_the_cutter_costs_no_level_and_is_told(doc, width):
    part = add_part(doc, notched(width))
    job = add_job(doc, part, diameter=2 * R)
    (floor,) = faces_at(part.Shape, A)
    op = api.add_spiral_pocket(job, [(part, [floor])], StepDown=20.0)
    (plan,) = op.Proxy.plans
    assert [section.z for section in plan.request.sections] == [A]
    (told,) = [notice for notice in op.Notices if "stay uncut" in notice]
    assert "notches that the 8 mm cutter does not fit" in told
    assert float(told.split("(")[1].split()[0]) == pytest.approx(9 * width, abs=0.5)
    assert not any("keep steps" in notice for notice in op.Notices)
    # levels that end there anyway tell of its neck, once
    op.StepDown = 4.0
    doc.recompute()
    assert len([notice for notice in op.Notices if "uncut" in notice]) == 1
    assert "neck" in next(notice for notice in op.Notices if "uncut" in notice)


@pytest.mark.parametrize(("width", "depth"), [(8.5, 9.0), (30.0, 2.0), (6.0, 0.5)])
def test_a_notch_that_the_cutter_gets_into_is_cut_to_its_own_height(doc, width, depth):
    op = machined(doc, notched(width, depth), A)
    (plan,) = op.Proxy.plans
    assert -8.0 in [round(section.z, 6) for section in plan.request.sections]
