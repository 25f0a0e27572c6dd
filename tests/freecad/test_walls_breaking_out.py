# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls that come out of the part's side at some height, above which none goes around."""

import Part
import pytest
from FreeCAD import Vector
from sample_parts import add_job, add_part, faces_at, motion, rectangle
from solid_oracle import Stock, Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import GeometryError
from freecad_spiralpocket.op import slices

FLOOR, TOP, SLOPE = 9.0, 28.0, 4 / 21


def breaking_out(beside):
    """Return a drafted pocket in a block whose side is so far from its floor [mm]."""
    high = TOP + 2
    wider = (high - FLOOR) * SLOPE
    foot = rectangle(30, 40, 7, 10, 16)
    foot.translate(Vector(0, 0, FLOOR))
    mouth = rectangle(30 + 2 * wider, 40 + 2 * wider, 7 + wider, 10 - wider, 16 - wider)
    mouth.translate(Vector(0, 0, high))
    return Part.makeBox(100, 56 + beside, TOP).cut(Part.makeLoft([foot, mouth], True, True))


def cut(doc, shape, **options):
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=8.0)
    return api.add_spiral_pocket(job, [(part, faces_at(shape, FLOOR)[:1])], **options)


def bridge():
    """Return what goes across the middle of the pocket."""
    return Part.makeBox(100, 7, 5, Vector(0, 30, TOP - 5))


def with_a_window():
    """Return a pocket under a bridge, with vertical walls and a window at its back."""
    pocket = Part.Face(rectangle(30, 40, 7, 10, 16)).extrude(Vector(0, 0, TOP))
    pocket.translate(Vector(0, 0, FLOOR))
    window = Part.makeBox(26, 20, 20, Vector(12, 50, 19.5))
    return Part.makeBox(100, 60, TOP).cut(pocket).cut(window).fuse(bridge()).removeSplitter()


@pytest.mark.parametrize("step_down", [8.0, 5.0, 3.0])
@pytest.mark.parametrize(
    "shape",
    [with_a_window, lambda: breaking_out(1.5).fuse(bridge()).removeSplitter()],
    ids=["window", "draft"],
)
def test_both_sides_of_a_bridge_are_cleared_whose_wall_ends_on_one(doc, shape, step_down):
    shape = shape()
    op = cut(doc, shape, StepDown=step_down)
    surface, centers = Surface.of(shape), places(motion(op), 0.4)
    assert len(gouges(surface, centers, 4.0, 0.01)) == 0
    heights = Stock(surface, (10.5, 16.5, 39.5, 55.5), 0.5)
    heights.cut(centers, 4.02)
    standing = (heights.part == FLOOR) & (heights.heights > FLOOR + 0.01)
    # in the sharp corners beside the bridge
    assert standing.sum() * heights.pixel**2 < 20.0
    told = next(notice for notice in op.Notices if "lean over the floor" in notice)
    assert float(told.split("; ")[1].split()[0]) == pytest.approx(210, abs=1)


@pytest.mark.parametrize("beside", [1.0, 1.5, 2.489, 3.0])
def test_a_wall_that_comes_out_of_the_side_is_found_to_end_there(doc, beside):
    shape = breaking_out(beside)
    op = cut(doc, shape, StepDown=8.0)
    centers = places(motion(op), 1.0)
    assert len(gouges(Surface.of(shape), centers, 4.0, 0.01)) == 0


def test_a_level_just_where_a_wall_comes_out_is_cut(doc):
    shape = breaking_out(1.0)
    op = cut(doc, shape, StartDepth=FLOOR + 4 / SLOPE, StepDown=5.25)
    assert FLOOR + 1 / SLOPE in [round(s.z, 6) for s in op.Proxy.plans[0].request.sections]


def test_a_wall_that_is_missing_is_told_all_the_same():
    walls = [f for f in breaking_out(1.0).Faces if not isinstance(f.Surface, Part.Cone)]
    with pytest.raises(GeometryError, match="not closed at X.*Repair"):
        slices.section(walls, FLOOR + 1 / SLOPE, 0.005)
