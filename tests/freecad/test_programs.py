# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the programs that tests/output runs through LinuxCNC's interpreter.

Beside each program lies what it may do, taken from the part and not from the path.
"""

import FreeCAD
import Part
import pytest
from sample_parts import (
    DEPTH,
    add_job,
    add_part,
    area,
    block,
    circle,
    faces_at,
    motion,
    polygon,
    rectangle,
    spline,
)
from sample_programs import write

from freecad_spiralpocket import api

KIDNEY = [(0, 0), (30, -8), (60, 0), (66, 20), (45, 22), (30, 14), (15, 22), (-6, 20)]


def two_depths():
    shape = block(area(rectangle(30, 20, 5)), area(rectangle(1, 1, 0, 70, 0)))
    return shape.cut(Part.makeCylinder(9, 10, FreeCAD.Vector(50, 10, -3)))


def boss():
    shape = Part.makeBox(60, 40, DEPTH + 4, FreeCAD.Vector(0, 0, -DEPTH - 4))
    around = Part.makeBox(80, 60, DEPTH + 1, FreeCAD.Vector(-10, -10, -DEPTH))
    return shape.cut(around.cut(Part.makeCylinder(8, 20, FreeCAD.Vector(25, 20, -10)))).Solids[0]


#: The part, the heights of the floors to cut, and the operation's values.
PROGRAMS = {
    "rectangle": (lambda: block(area(rectangle(40, 28, 5))), [-DEPTH], {}),
    "levels": (
        lambda: block(area(rectangle(30, 24, 5))),
        [-DEPTH],
        {"StepDown": 2.5, "FinishDepth": 0.4, "Strategy": "Linear Morph"},
    ),
    "conventional": (
        lambda: block(area(rectangle(30, 24, 5))),
        [-DEPTH],
        {"CutMode": "Conventional", "StockToLeave": 0.3, "ZStockToLeave": 0.2},
    ),
    "circle": (lambda: block(area(circle(14))), [-DEPTH], {"Strategy": "Linear Morph"}),
    "spline": (lambda: block(area(spline(KIDNEY))), [-DEPTH], {}),
    "inward arc": (
        lambda: block(area(rectangle(60, 40)).cut(area(circle(15, 30, 45))).Faces[0]),
        [-DEPTH],
        {},
    ),
    "island": (lambda: block(area(circle(22), circle(5, 3, 2))), [-DEPTH], {}),
    "triangle": (
        lambda: block(area(polygon([(0, 0), (50, 0), (20, 40)]))),
        [-DEPTH],
        {"Strategy": "Linear Morph"},
    ),
    "two depths": (two_depths, [-DEPTH, -3], {"StepDown": 4}),
    "boss": (boss, [-DEPTH], {"StepDown": 3}),
}
#: Floors without outer walls, and how far the cutter's edge may leave them [mm].
OPEN = {"boss": 14.0}


@pytest.mark.parametrize("name", PROGRAMS)
def test_program_is_written(doc, out_dir, name):
    build, heights, values = PROGRAMS[name]
    part = add_part(doc, build())
    job = add_job(doc, part)
    names = [faces_at(part.Shape, z)[0] for z in heights]
    op = api.add_spiral_pocket(job, [(part, names)], **values)
    assert motion(op) and not op.Proxy.errors
    floors = [(part.Shape.getElement(n), z) for n, z in zip(names, heights, strict=True)]
    write(out_dir / "programs", name.replace(" ", "-"), op, floors, OPEN.get(name, 0.0))
