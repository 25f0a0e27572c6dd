# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rest machining: a smaller cutter takes what earlier operations left, and no more."""

import FreeCAD
import numpy as np
import Part
import pytest
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
    polygon,
    rectangle,
    set_feeds,
)
from solid_oracle import Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import AlreadyClearedError
from freecad_spiralpocket.op import compat
from freecad_spiralpocket.op.foresight import requests_of
from freecad_spiralpocket.op.rest import AROUND, share_cleared

LARGE, SMALL = 16.0, 6.0

#: Two rooms and a channel too narrow for the large cutter.
DUMBBELL = [(0, 0), (40, 0), (40, 15), (60, 15), (60, 0), (100, 0), (100, 40), (60, 40)]
DUMBBELL += [(60, 25), (40, 25), (40, 40), (0, 40)]


def job_of(doc, shape):
    """Return a job with a part, and a tool controller for each cutter."""
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=LARGE)
    large = job.Tools.Group[0]
    small = compat.add_tool_controller(job, SMALL)
    set_feeds(small, 1500.0)
    doc.recompute()
    return job, part, large, small


def cut(job, part, controller, **options):
    base = [(part, faces_at(part.Shape, -DEPTH))]
    return api.add_spiral_pocket(job, base, controller, **options)


def swept(op, diameter, z=-DEPTH):
    """Return the ground that an operation clears down to the floor, or to another height."""
    deep = [p[:2] for p in places(motion(op), 0.2) if p[2] < z + 0.001]
    return shapely.union_all(
        shapely.buffer(shapely.points(np.array(deep)), diameter / 2, quad_segs=32)
    )


def reachable(outline, diameter):
    ground = outline if isinstance(outline, shapely.Polygon) else shapely.Polygon(outline)
    return ground.buffer(-diameter / 2).buffer(diameter / 2, quad_segs=64)


@pytest.mark.parametrize(
    ("outline", "mode"),
    [([(0, 0), (60, 0), (60, 45), (0, 45)], "Climb"), (DUMBBELL, "Conventional")],
)
def test_the_small_cutter_takes_what_the_large_one_left(doc, outline, mode):
    shape = block(area(polygon(outline)))
    job, part, large, small = job_of(doc, shape)
    first = cut(job, part, large)
    rest = cut(job, part, small, UseRestMachining=True, CutMode=mode)
    assert rest.MachiningTime < 0.85 * first.MachiningTime
    both = shapely.union(swept(first, LARGE), swept(rest, SMALL))
    left = shapely.difference(reachable(outline, SMALL), both.buffer(0.03)).buffer(-0.01)
    assert left.area < 0.05
    assert len(gouges(Surface.of(shape), places(motion(rest), 1.5), SMALL / 2, 0.01)) == 0
    (plan,) = rest.Proxy.plans
    assert plan.report.uncut_area < 0.05 and plan.report.rapid_hit == 0
    assert any("% of this pocket" in notice for notice in rest.Notices)


def test_nothing_that_was_left_is_passed_in_the_air(doc):
    # the engagement that the report tells is that in the stock which stands, as an own sweep has it
    job, part, large, small = job_of(doc, block(area(polygon(DUMBBELL))))
    first = swept(cut(job, part, large), LARGE)
    (plan,) = cut(job, part, small, UseRestMachining=True).Proxy.plans
    report = plan.report
    centers = shapely.points(report.engagement_points[:, :2])
    inside = shapely.contains(first.buffer(-0.1), shapely.buffer(centers, SMALL / 2))
    assert inside.any() and report.engagement_angles[inside].max() == 0.0
    assert report.engagement_max > np.radians(45)


def test_what_comes_later_or_is_not_active_has_cleared_nothing(doc):
    job, part, large, small = job_of(doc, block(area(rectangle(40, 40))))
    rest = cut(job, part, small, UseRestMachining=True)
    whole = rest.MachiningTime
    assert any(notice.startswith("No earlier operation") for notice in rest.Notices)
    first = cut(job, part, large)
    doc.recompute([rest], True)
    assert rest.MachiningTime == whole
    job.Operations.Group = [first, rest]
    first.Active = False
    rest.touch()
    doc.recompute()
    assert rest.MachiningTime == whole
    first.Active = True
    first.touch()
    doc.recompute()
    rest.touch()
    doc.recompute()
    assert rest.MachiningTime < whole / 2


def test_it_is_told_that_a_round_tool_before_does_not_count(doc, monkeypatch):
    job, part, large, small = job_of(doc, block(area(rectangle(40, 40))))
    cut(job, part, large)
    monkeypatch.setattr("freecad_spiralpocket.op.rest.tool_shape", lambda _: "ballend")
    rest = cut(job, part, small, UseRestMachining=True)
    assert any("round ones leave ridges" in notice for notice in rest.Notices)


def test_what_did_not_reach_the_floor_or_left_stock_on_the_wall_is_rest(doc):
    job, part, large, small = job_of(doc, block(area(rectangle(40, 40, 9.0))))
    first = cut(job, part, large, ZStockToLeave=0.3)
    rest = cut(job, part, small, UseRestMachining=True)
    assert any(notice.startswith("No earlier operation") for notice in rest.Notices)
    whole = rest.MachiningTime
    first.ZStockToLeave, first.StockToLeave = 0.0, 0.3
    doc.recompute()
    rest.touch()
    doc.recompute()
    # one lap along the wall
    assert 0.05 * whole < rest.MachiningTime < whole / 2
    assert rest.Proxy.plans[0].report.engagement_max < np.radians(60)


def test_a_pocket_that_was_cleared_wholly_is_told(doc):
    job, part, large, small = job_of(doc, block(area(rectangle(40, 40, 9.0))))
    cut(job, part, large)
    before = len(job.Operations.Group)
    with pytest.raises(AlreadyClearedError, match="as far as this cutter reaches"):
        cut(job, part, small, UseRestMachining=True)
    assert len(job.Operations.Group) == before


def test_what_is_foreseen_of_a_cleared_pocket_does_not_promise_a_cut(doc):
    # the panel shows it together with the error that the cutter reaches nothing of the rest
    job, part, _, small = job_of(doc, block(area(rectangle(40, 40, 0.0))))
    cut(job, part, small)
    again = cut(job, part, small)
    again.UseRestMachining = True
    (told,) = [str(n) for n in requests_of(again).notices if "of this pocket" in str(n)]
    assert told.endswith("what this cutter reaches of the rest is cut.")
    doc.recompute()
    assert [type(e) for e in again.Proxy.errors] == [AlreadyClearedError]


def test_paths_of_other_operations_count(doc):
    """A profile's arcs and lines, written by hand: a groove along the wall."""
    import Path

    job, part, large, small = job_of(doc, block(area(rectangle(60, 40, 9.0))))
    other = doc.addObject("Path::FeaturePython", "Other")
    other.addProperty("App::PropertyLink", "ToolController")
    other.addProperty("App::PropertyBool", "Active")
    other.ToolController, other.Active = large, True
    job.Operations.addObject(other)
    box = part.Shape.BoundBox
    x0, x1 = box.XMin + 12 + LARGE / 2, box.XMax - 12 - LARGE / 2
    y = (box.YMin + box.YMax) / 2
    words = [f"G0 X{x0} Y{y} Z5", f"G1 Z{-DEPTH}", f"G1 X{x1}", "G0 Z5"]
    other.Path = Path.Path([Path.Command(line) for line in words])
    job.Operations.Group = [other]
    rest = cut(job, part, small, UseRestMachining=True)
    assert any("% of this pocket" in notice for notice in rest.Notices)
    (plan,) = rest.Proxy.plans
    assert plan.report.uncut_area < 0.05
    # the groove is where the cutter goes down
    down = next(p for p in places(motion(rest), 1.0) if p[2] < -0.1)
    assert abs(down[1] - y) < (LARGE - SMALL) / 2 and x0 - 5 < down[0] < x1 + 5


def flared(width, height, by, around=12):
    """Return a block with a rectangular pocket that is wider by `by` on all sides at its top."""

    def outline(off, z):
        x, y = width + off, height + off
        corners = [(-off, -off), (x, -off), (x, y), (-off, y), (-off, -off)]
        return Part.makePolygon([Vector(*corner, z) for corner in corners])

    margin = by + around
    block = Part.makeBox(width + 2 * margin, height + 2 * margin, 20, Vector(-margin, -margin, -20))
    return block.cut(Part.makeLoft([outline(0, -DEPTH), outline(by, 0)], True))


def test_slanted_walls_count_level_by_level(doc):
    shape = flared(50, 40, 3)
    job, part, large, small = job_of(doc, shape)
    cut(job, part, large, StepDown=3.0)
    rest = cut(job, part, small, StepDown=3.0, UseRestMachining=True)
    assert len(gouges(Surface.of(shape), places(motion(rest), 1.5), SMALL / 2, 0.01)) == 0
    assert rest.Proxy.plans[0].report.uncut_area < 0.05
    # only corners
    wanted = rest.Proxy.plans[0].request
    assert all(wanted.to_clear(s.pocket).area < 0.1 * s.pocket.area for s in wanted.sections)
    with pytest.raises(AlreadyClearedError):
        cut(job, part, small, StepDown=3.0, UseRestMachining=True)


def test_slanted_walls_that_were_cut_in_wider_steps_keep_steps(doc):
    shape = flared(50, 40, 3)
    job, part, large, _ = job_of(doc, shape)
    cut(job, part, large, StepDown=DEPTH)
    rest = cut(job, part, large, StepDown=DEPTH / 2, UseRestMachining=True)
    upper, _ = rest.Proxy.plans[0].request.sections
    before = swept(job.Operations.Group[0], LARGE)
    standing = reachable(upper.pocket, LARGE).difference(before.buffer(0.05))
    assert standing.area > 10
    assert rest.Proxy.plans[0].request.stock.buffer(0.01).covers(standing)
    assert standing.difference(swept(rest, LARGE, upper.z)).buffer(-0.05).is_empty


def test_walls_that_flare_far_beyond_the_floor_are_stock(doc):
    job, part, large, small = job_of(doc, flared(20, 20, 150))
    first = cut(job, part, large, StepDown=DEPTH)
    rest = cut(job, part, small, StepDown=DEPTH, UseRestMachining=True)
    rest.StepDown = DEPTH / 3
    (asked,) = requests_of(rest)[0]
    top = asked.sections[0]
    assert top.pocket.bounds[0] < -AROUND * SMALL - SMALL
    standing = reachable(top.pocket, SMALL).difference(swept(first, LARGE).buffer(0.1))
    assert asked.stock.buffer(0.01).covers(standing)


def end_higher(job, first, rest):
    first.setExpression("FinalDepth", None)
    first.FinalDepth = -DEPTH / 2


def reorder(job, first, rest):
    job.Operations.Group = [rest, first]


CHANGES = {
    "shallower": end_higher,
    "another cutter": lambda job, first, rest: setattr(first.ToolController.Tool, "Diameter", 12),
    "inactive": lambda job, first, rest: setattr(first, "Active", False),
    "behind": reorder,
    "gone": lambda job, first, rest: job.Document.removeObject(first.Name),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_rest_is_cut_anew_when_the_operations_before_change(doc, name):
    job, part, large, small = job_of(doc, block(area(rectangle(40, 30))))
    first = cut(job, part, large, **QUICK)
    rest = cut(job, part, small, UseRestMachining=True)
    before = share_cleared(rest.Proxy.plans[0].request)
    CHANGES[name](job, first, rest)
    doc.recompute()
    doc.recompute()  # a tool's own shape follows its diameter one step behind
    assert "Touched" not in rest.State
    now = share_cleared(rest.Proxy.plans[0].request)
    assert now > before + 0.01 if name == "another cutter" else now < 0.001


def test_a_rest_that_is_behind_a_rest_follows_too(doc):
    job, part, large, small = job_of(doc, block(area(rectangle(40, 30))))
    first = cut(job, part, large, **QUICK)
    cut(job, part, small, UseRestMachining=True)
    smaller = compat.add_tool_controller(job, 3.0)
    set_feeds(smaller, 1500.0)
    last = cut(job, part, smaller, UseRestMachining=True)
    cleared = last.Proxy.plans[0].request.stock
    first.Active = False
    doc.recompute()
    assert not any("Touched" in op.State for op in job.Operations.Group)
    # the middle one clears all now, as before
    assert last.Proxy.plans[0].request.stock.symmetric_difference(cleared).area < 1


def test_nothing_is_to_be_computed_where_nothing_has_changed(doc, tmp_path):
    job, part, large, small = job_of(doc, block(area(rectangle(40, 30))))
    first = cut(job, part, large, **QUICK)
    rest = cut(job, part, small, UseRestMachining=True)
    path = rest.Path.toGCode()
    later = cut(job, part, small, **QUICK)
    assert "Touched" not in rest.State
    later.StepOver = 20
    doc.recompute()
    assert "Touched" not in rest.State
    doc.saveAs(str(tmp_path / "rest.FCStd"))
    again = FreeCAD.openDocument(str(tmp_path / "rest.FCStd"))
    try:
        opened = again.getObject(rest.Name)
        assert "Touched" not in opened.State and opened.Path.toGCode() == path
        again.getObject(first.Name).Active = False
        again.recompute()
        assert opened.Proxy.plans[0].request.stock is None
    finally:
        FreeCAD.closeDocument(again.Name)


def test_a_program_cuts_what_is_left_now(doc, tmp_path):
    job, part, large, small = job_of(doc, block(area(rectangle(40, 30))))
    first = cut(job, part, large)
    rest = cut(job, part, small, UseRestMachining=True)
    before = motion(rest)
    assert rest.Proxy.plans[0].request.stock is not None
    first.Active = False
    api.export(job, tmp_path / "rest.ngc")
    assert rest.Proxy.plans[0].request.stock is None
    assert [c.toGCode() for c in motion(rest)] != [c.toGCode() for c in before]
