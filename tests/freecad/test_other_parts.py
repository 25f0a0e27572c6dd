# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other parts of a job that stand in a pocket or hang over it are kept off as its own islands."""

import Part
import pytest
from FreeCAD import Vector
from sample_parts import DEPTH, add_job, add_part, area, block, faces_at, motion, rectangle, told
from solid_oracle import Stock, Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError

R = 3.0


def pocket():
    return block(area(rectangle(40, 30, 5)))


def pin(x=20.0, low=-DEPTH, high=4.0, radii=(3.0, 3.0)):
    if radii[0] == radii[1]:
        return Part.makeCylinder(radii[0], high - low, Vector(x, 15, low))
    return Part.makeCone(*radii, high - low, Vector(x, 15, low))


def clamp():
    return Part.makeBox(10, 40, 8, Vector(15, -30, 0))


def cut(doc, *shapes, **options):
    parts = [add_part(doc, shape) for shape in shapes]
    job = add_job(doc, *parts, diameter=2 * R)
    base = [(parts[0], faces_at(parts[0].Shape, -DEPTH))]
    return api.add_spiral_pocket(job, base, StepDown=3.0, **options)


OTHERS = {
    "pin": pin(),
    "low pin": pin(high=-2.0),
    "pin with draft, its foot in the floor": pin(low=-8.0, radii=(8.0, 2.0)),
    "pin in a through hole": pin(low=-10.0),
    "clamp": clamp(),
}


@pytest.mark.parametrize("name", OTHERS)
def test_what_stands_in_the_pocket_is_kept_off_and_cut_round(doc, name):
    other, shape = OTHERS[name], pocket()
    if "through" in name:
        shape = shape.cut(Part.makeCylinder(3, 40, Vector(20, 15, -30)))
    op = cut(doc, shape, other)
    both = Surface.of(Part.makeCompound([shape, other]))
    assert len(gouges(both, places(motion(op), 0.7), R, 0.01)) == 0
    stock = Stock(both, (0.2, 0.2, 39.8, 29.8), 0.4)
    stock.cut(places(motion(op), 0.3), R + 0.02)
    # the corners between the clamp and the wall stay
    standing = (stock.part <= -DEPTH) & (stock.heights > -DEPTH + 0.02)
    assert standing[5:-5, 14:-14].sum() * stock.pixel**2 < (4.5 if name == "clamp" else 0.2)
    assert told(op, "covers 100 mm2" if name == "clamp" else "stands in the pocket")


def test_solids_of_one_part_keep_off_each_other(doc):
    op = cut(doc, Part.makeCompound([pocket(), pin()]))
    assert len(gouges(Surface.of(pin()), places(motion(op), 0.7), R, 0.01)) == 0


def test_other_parts_are_no_islands_that_may_be_left_out(doc):
    op = cut(doc, pocket(), pin(), UseOutline=True)
    assert len(gouges(Surface.of(pin()), places(motion(op), 0.7), R, 0.01)) == 0


def test_a_part_that_covers_the_floor_is_named_as_the_reason(doc):
    lid = Part.makeBox(64, 54, 3, Vector(-12, -12, 0))
    with pytest.raises(CutterDoesNotFitError, match="Another part of the job covers"):
        cut(doc, pocket(), lid)


@pytest.mark.parametrize("other", [pocket(), Part.makeBox(20, 54, 15, Vector(52, -12, -10))])
def test_a_copy_and_a_neighbor_are_nothing_to_keep_off(doc, other):
    op = cut(doc, pocket(), other)
    assert not told(op, "Another part")
    alone = cut(doc, pocket())
    assert op.Proxy.plans[0].request.pocket.equals(alone.Proxy.plans[0].request.pocket)
