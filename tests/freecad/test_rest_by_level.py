# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rest machining where walls are slanted or stepped: every level has its own rest."""

import numpy as np
import Part
import shapely
from FreeCAD import Vector
from sample_parts import (
    DEPTH,
    QUICK,
    add_job,
    add_part,
    area,
    block,
    faces_at,
    motion,
    rectangle,
    set_feeds,
    stepped_block,
)
from solid_oracle import Stock, Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.op import compat
from freecad_spiralpocket.op.rest import share_cleared

LARGE, SMALL = 16.0, 6.0
#: The corners' radius at the floor; as much as the pocket widens up to its top.
CORNER, WIDER = 5.0, 6.0


def drafted(by=WIDER):
    """Return a block with a pocket whose corners become wider upwards as its walls open."""
    low = rectangle(60, 45, CORNER)
    low.translate(Vector(0, 0, -DEPTH))
    high = rectangle(60 + 2 * by, 45 + 2 * by, CORNER + by, -by, -by)
    mouth = area(rectangle(60 + 2 * by, 45 + 2 * by, 0, -by, -by))
    return block(mouth, depth=0.0, below=DEPTH + 4).cut(Part.makeLoft([low, high], True, True))


def job_of(doc, shape, diameter=LARGE):
    """Return a job with a part, and a tool controller for a large and for the small cutter."""
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=diameter)
    large = job.Tools.Group[0]
    small = compat.add_tool_controller(job, SMALL)
    set_feeds(small, 1500.0)
    doc.recompute()
    return job, part, large, small


def cut(job, part, controller, z=-DEPTH, **options):
    return api.add_spiral_pocket(job, [(part, faces_at(part.Shape, z))], controller, **options)


def depths(op):
    """Return the Z along which an operation goes."""
    points = places(motion(op), 0.5)
    level = np.abs(np.diff(points[:, 2])) < 1e-9
    heights = points[1:][level & (points[1:, 2] < -1e-6), 2]
    return sorted(set(heights.round(3).tolist()))


def standing(ops, request, diameter):
    """Return what operations leave of each level that a cutter could reach, and 0.05 mm more."""
    left = []
    for section in request.sections:
        swept = []
        for op, width in ops:
            deep = [p[:2] for p in places(motion(op), 0.2) if p[2] < section.z + 0.001]
            if deep:
                discs = shapely.buffer(shapely.points(np.array(deep)), width / 2, quad_segs=32)
                swept.append(shapely.union_all(discs))
        reach = section.pocket.buffer(-diameter / 2).buffer(diameter / 2, quad_segs=64)
        left.append(reach.difference(shapely.union_all(swept).buffer(0.04)).buffer(-0.01))
    return left


def strikes(shape, ops):
    """Return how high stock stands in the way of the rapids of the last of some operations."""
    box = shape.BoundBox
    stock = Stock(Surface.of(shape), (box.XMin, box.YMin, box.XMax, box.YMax), 0.2)
    *earlier, (last, diameter) = ops
    for op, width in earlier:
        stock.cut(places(motion(op), 0.2), width / 2)
    worst, before = 0.0, None
    for command in motion(last):
        if before is not None:
            centers = places([before, command], 0.2)
            if command.Name == "G0":
                worst = max(worst, _in_the_way(stock, centers, diameter / 2 - 0.3))
            else:
                stock.cut(centers, diameter / 2)
        before = command
    return worst


def _in_the_way(stock, centers, radius):
    """Return how much lower a cutter would make stock at its places."""
    before = stock.heights.copy()
    stock.cut(centers, radius)
    return float((before - stock.heights).max())


def test_levels_that_are_clear_are_not_entered(doc):
    shape = drafted()
    job, part, large, small = job_of(doc, shape)
    first = cut(job, part, large, StepDown=2.0)
    rest = cut(job, part, small, StepDown=2.0, UseRestMachining=True)
    # 2 mm below the top the corners are wider than the large cutter
    assert {-6.0, -4.0, -2.0} <= set(depths(first)) and depths(rest) == [-6.0, -4.0]
    (plan,) = rest.Proxy.plans
    ops = [(first, LARGE), (rest, SMALL)]
    assert all(left.area < 0.05 for left in standing(ops, plan.request, SMALL))
    assert strikes(shape, ops) < 0.02
    assert len(gouges(Surface.of(shape), places(motion(rest), 1.0), SMALL / 2, 0.01)) == 0
    assert plan.report.uncut_area < 0.05
    assert plan.report.rapid_hit == plan.report.link_hit == 0.0
    assert rest.MachiningTime < 0.25 * first.MachiningTime
    share = share_cleared(plan.request)
    assert 0.97 < share < 1.0
    told = "more than 99" if share > 0.99 else f"{int(100 * share)}"
    assert any(f"have cleared {told} % of" in notice for notice in rest.Notices)


def test_steps_that_were_left_higher_are_cut_and_nothing_else(doc):
    shape = drafted()
    job, part, large, small = job_of(doc, shape)
    first = cut(job, part, large, StepDown=3.0)
    rest = cut(job, part, small, StepDown=1.0, UseRestMachining=True)
    # 3 mm below the top the large cutter was there, and the corners are as wide as that
    assert depths(rest) == [-6.0, -5.0, -4.0, -2.0, -1.0]
    (plan,) = rest.Proxy.plans
    ops = [(first, LARGE), (rest, SMALL)]
    assert all(left.area < 0.1 for left in standing(ops, plan.request, SMALL))
    assert strikes(shape, ops) < 0.02
    # nowhere but on the steps, which are 1 and 2 mm wide, and on ways to the next piece
    report = plan.report
    cutting = report.engagement_angles > 0.05
    middle = shapely.box(0, 0, 60, 45).buffer(-CORNER - 1.0)
    assert not shapely.contains_xy(middle, report.engagement_points[cutting, :2]).any()


def test_a_slot_below_a_pocket_that_was_cleared_is_cut_alone(doc):
    job, part, medium, small = job_of(doc, stepped_block(), 12.0)
    cut(job, part, medium, z=-4.0, StepDown=2.0, **QUICK)
    rest = cut(job, part, small, StepDown=2.0, UseRestMachining=True)
    # down to the ledge there is nothing to cut: the corners are as wide as the large cutter
    assert max(depths(rest)) < -4.0
    assert rest.MachiningTime < 0.5 * cut(job, part, small, StepDown=2.0).MachiningTime
    assert rest.Proxy.plans[0].report.uncut_area < 0.05
    assert not any(notice.startswith("No earlier operation") for notice in rest.Notices)


def test_below_a_vertical_pocket_that_was_cleared_in_part_only_corners_are_cut_above(doc):
    shape = block(area(rectangle(60, 45, SMALL)))
    job, part, large, small = job_of(doc, shape)
    first = cut(job, part, large, StepDown=2.0, FinalDepth=-4.0)
    rest = cut(job, part, small, StepDown=2.0, UseRestMachining=True)
    (plan,) = rest.Proxy.plans
    middle = shapely.box(0, 0, 60, 45).buffer(-LARGE)
    angles, points = plan.report.engagement_angles, plan.report.engagement_points
    inside = (angles > 0.05) & shapely.contains_xy(middle, points[:, :2])
    assert inside.any() and points[inside, 2].max() < -4.0
    assert {-2.0, -4.0} < set(depths(rest))
    ops = [(first, LARGE), (rest, SMALL)]
    assert all(left.area < 0.05 for left in standing(ops, plan.request, SMALL))
    assert strikes(shape, ops) < 0.02
    whole = cut(job, part, small, StepDown=2.0)
    assert rest.MachiningTime < 0.6 * whole.MachiningTime


def test_levels_of_a_vertical_pocket_that_were_cleared_wholly_are_not_entered(doc):
    job, part, large, small = job_of(doc, block(area(rectangle(60, 45, LARGE))))
    cut(job, part, large, StepDown=2.0, FinalDepth=-4.0)
    rest = cut(job, part, small, StepDown=2.0, UseRestMachining=True)
    assert max(depths(rest)) < -4.0
