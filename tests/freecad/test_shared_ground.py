# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ground that several pockets share is cut once, and never left to one that is not cut."""

import Part
import pytest
from FreeCAD import Vector
from sample_parts import add_job, add_part, box, faces_at, motion
from solid_oracle import Stock, Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.beside import crew
from freecad_spiralpocket.engine.errors import NotYetError
from freecad_spiralpocket.op.operation import ObjectSpiralPocket

R = 3.0


def tray():
    """Return a tray with four compartments at Z-14 and ribs between them up to Z-6."""
    shape = box(-6, -6, -18, 92, 72, 18).cut(box(0, 0, -14, 80, 60, 20))
    ribs = box(38.5, 0, -14, 3, 60, 8).fuse(box(0, 28.5, -14, 80, 3, 8))
    return shape.fuse(ribs).removeSplitter()


def stepped():
    """Return a pocket at Z-4 with one at Z-9 in it, and another beside both."""
    shape = box(-6, -6, -18, 132, 72, 18).cut(box(0, 0, -4, 80, 60, 20))
    return shape.cut(box(20, 15, -9, 40, 30, 20)).cut(box(90, 0, -6, 30, 60, 20))


def cut(doc, shape, *heights, **options):
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=2 * R)
    names = [name for z in heights for name in faces_at(shape, z)]
    return api.add_spiral_pocket(job, [(part, names)], **{"StepDown": 4.0, **options})


def assert_all_is_cut(op, shape, bounds, floor):
    surface, centers = Surface.of(shape), places(motion(op), 0.5)
    assert len(gouges(surface, centers, R, 0.01)) == 0
    stock = Stock(surface, bounds, 0.5)
    stock.cut(centers, R + 0.03)
    left = (stock.left > 0.01) & (stock.part > floor - 0.1)
    assert left.sum() * 0.25 < 4 * 4 * R**2  # the corners of four compartments


def test_what_is_above_low_ribs_is_cut_by_the_first_pocket_alone(doc):
    op = cut(doc, tray(), -14.0)
    plans = op.Proxy.plans
    assert [plan.request.heights.start_depth for plan in plans] == [0.0, -6.0, -6.0, -6.0]
    assert len({plan.request.floor for plan in plans}) == 1
    lengths = [plan.report.cut_length for plan in plans]
    assert max(lengths[1:]) < 0.4 * lengths[0]
    assert not [notice for notice in op.Notices if "ledges" in notice]
    assert_all_is_cut(op, tray(), (0.5, 0.5, 79.5, 59.5), -14.0)


@pytest.mark.parametrize("heights", [(-9.0, -6.0, -4.0), (-4.0, -9.0, -6.0)])
def test_of_pockets_in_each_other_the_upper_one_goes_first(doc, heights):
    op = cut(doc, stepped(), *heights)
    plans = op.Proxy.plans
    order = [plan.request.floor for plan in plans]
    assert order.index(-4.0) < order.index(-9.0)
    assert order.index(-6.0) == heights.index(-6.0)  # it stays where it was
    begins = {plan.request.floor: plan.request.heights.start_depth for plan in plans}
    assert begins == {-4.0: 0.0, -6.0: 0.0, -9.0: -4.0}
    assert_all_is_cut(op, stepped(), (0.5, 0.5, 79.5, 59.5), -9.0)


@pytest.mark.parametrize("step_down", [4.0, 7.0, 20.0])
def test_steps_on_a_slanted_rib_are_no_wider_where_the_pockets_share_it(doc, step_down):
    """Each side of the ridge leans 4.5 mm from its foot at Z-14 to its edge at Z-6."""
    corners = [Vector(x, 0, z) for x, z in ((35.5, -14), (44.5, -14), (40, -6), (35.5, -14))]
    ridge = Part.Face(Part.makePolygon(corners)).extrude(Vector(0, 60, 0))
    plain = box(-6, -6, -18, 92, 72, 18).cut(box(0, 0, -14, 80, 60, 20))
    op = cut(doc, plain.fuse(ridge).removeSplitter(), -14.0, StepDown=step_down)
    assert len(op.Proxy.plans) == 2
    told = [notice for notice in op.Notices if "keep steps up to" in notice]
    widths = [float(notice.split("keep steps up to ")[1].split()[0]) for notice in told]
    assert widths and max(widths) < 9.1


def test_nothing_is_left_to_a_pocket_that_is_not_cut(doc, monkeypatch):
    seen = []

    def planner(requests, progress):
        seen.append([request.heights.start_depth for request in requests])
        first = requests[0].pocket.centroid
        return [
            NotYetError("Not this one.")
            if first.x < 38 and first.y < 28 and request is requests[0]
            else plan
            for request, plan in zip(requests, crew.plan_together(requests), strict=True)
        ]

    monkeypatch.setattr(ObjectSpiralPocket, "planner", staticmethod(planner))
    op = cut(doc, tray(), -14.0)
    assert len(op.Proxy.plans) == 3 and len(op.Proxy.errors) == 1
    starts = [plan.request.heights.start_depth for plan in op.Proxy.plans]
    assert starts == [0.0, -6.0, -6.0]


def test_the_start_depth_that_is_told_is_the_operations_own(doc):
    op = cut(doc, tray(), -14.0)
    assert not [text for text in op.Notices if "start depth" in text]
