# SPDX-License-Identifier: LGPL-2.1-or-later
"""Islands lower than the wall are cut to their tops where no wall goes around at that height."""

import pytest
from sample_parts import add_job, add_part, box, faces_at, motion
from solid_oracle import Stock, Surface, gouges, places

from freecad_spiralpocket import api

R, FLOOR, RIB = 3.0, -16.0, -11.0


def housing(*more):
    """Return a housing with a rib on its floor, and what is cut off its walls taken away."""
    walls = box(-3, -3, -20, 86, 56, 20).cut(box(0, 0, FLOOR, 80, 50, 40))
    shape = walls.fuse(box(30, 15, -20, 2, 35, 20 + RIB))
    for cut in more:
        shape = shape.cut(cut)
    return shape.removeSplitter()


PARTS = {
    "closed": housing(),
    "window beside the rib": housing(box(-4, 20, -13, 5, 9, 4)),
    "window above the rib": housing(box(-4, 20, -9, 5, 9, 4)),
    "low wall": housing(box(-4, -4, -14, 5, 60, 30)),
    "low corner": housing(box(-4, -4, -8, 20, 20, 30)),
}


@pytest.mark.parametrize("name", PARTS)
def test_the_rib_is_cut_to_its_top(doc, name):
    shape = PARTS[name]
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=2 * R)
    (floor,) = faces_at(shape, FLOOR)
    op = api.add_spiral_pocket(job, [(part, [floor])], StepDown=4.0)
    assert RIB in [round(section.z, 6) for section in op.Proxy.plans[0].request.sections]
    surface, centers = Surface.of(shape), places(motion(op), 0.4)
    assert len(gouges(surface, centers, R, 0.01)) == 0
    stock = Stock(surface, (1.0, 1.0, 79.0, 49.0), 0.5)
    stock.cut(centers, R + 0.02)
    on_rib = stock.heights[2 * 16 : 2 * 46, 2 * 29 : 2 * 31]
    assert on_rib.size and (on_rib < RIB + 0.01).all()
