# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls that come out of the part's side at some height, above which none goes around."""

import Part
import pytest
from FreeCAD import Vector
from sample_parts import add_job, add_part, faces_at, motion, rectangle
from solid_oracle import Surface, gouges, places

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
