# SPDX-License-Identifier: LGPL-2.1-or-later
"""Floors that are open at a side: cleared to their edge, and nothing beside them touched."""

import numpy as np
import Part
import pytest
import shapely
from FreeCAD import Vector
from sample_parts import add_job, add_part, faces_at, motion
from solid_oracle import Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError, SelectionError
from freecad_spiralpocket.op import geometry, selection

FLOOR, R = -6.0, 3.0
LEVELS = {"StepDown": 3.0}


def upright(solid, low_x=-1e9, low_y=-1e9):
    """Return the upright edges of a solid beyond a place."""
    edges = [e for e in solid.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.9]
    return [e for e in edges if e.BoundBox.XMin > low_x and e.BoundBox.YMin > low_y]


def plate(*tools):
    shape = Part.makeBox(100, 60, 12, Vector(0, 0, -12))
    for tool in tools:
        shape = shape.cut(tool)
    return shape.Solids[0]


def tool_box(x0, y0, x1, y1, corner=4.0, low_x=-1e9, low_y=0.0):
    box = Part.makeBox(x1 - x0, y1 - y0, 20, Vector(x0, y0, FLOOR))
    return box.makeFillet(corner, upright(box, low_x, low_y)) if corner else box


def notch():
    return plate(tool_box(20, -20, 80, 40))


def boss():
    around = Part.makeBox(300, 300, 20, Vector(-100, -100, FLOOR))
    return plate(around.cut(Part.makeCylinder(12, 40, Vector(50, 30, -20))))


PARTS = {
    "notch": notch,
    "corner": lambda: plate(tool_box(-20, -20, 40, 40, low_x=0.0)),
    "through": lambda: plate(tool_box(40, -20, 60, 80, corner=0)),
    "widening": lambda: plate(
        Part.Face(
            Part.makePolygon(
                [Vector(x, y, FLOOR) for x, y in [(10, -1), (40, 35), (60, 35), (90, -1), (10, -1)]]
            )
        ).extrude(Vector(0, 0, 20))
    ),
    "narrowing": lambda: plate(
        Part.Face(
            Part.makePolygon(
                [Vector(x, y, FLOOR) for x, y in [(35, -1), (20, 40), (80, 40), (65, -1), (35, -1)]]
            )
        ).extrude(Vector(0, 0, 20))
    ),
    "boss": boss,
}


#: Each part with the millimeter of stock that a job adds, some with none and with much.
CASES = [
    *((name, 1.0) for name in PARTS),
    *((name, 0.0) for name in ("notch", "boss")),
    *((name, 20.0) for name in ("widening", "narrowing")),
]


def job_of(doc, *shapes, beside=1.0, diameter=2 * R):
    parts = [add_part(doc, shape) for shape in shapes]
    job = add_job(doc, *parts, diameter=diameter)
    for side in ("ExtXneg", "ExtXpos", "ExtYneg", "ExtYpos"):
        setattr(job.Stock, side, beside)
    doc.recompute()
    return job, parts[0]


def cut(job, part, **options):
    return api.add_spiral_pocket(job, [(part, faces_at(part.Shape, FLOOR))], **(LEVELS | options))


def floor_of(part):
    floor = selection.floor(part, faces_at(part.Shape, FLOOR)[0])
    return geometry.polygon(floor, 0.002)


@pytest.mark.parametrize(("name", "beside"), CASES)
def test_floor_is_cleared_to_its_edge_and_nothing_else_is_cut(doc, name, beside):
    shape = PARTS[name]()
    job, part = job_of(doc, shape, beside=beside)
    op = cut(job, part)
    assert len(gouges(Surface.of(shape), places(motion(op), 1.5), R, 0.01)) == 0
    (plan,) = op.Proxy.plans
    assert plan.report.uncut_area < 0.05
    assert plan.report.rapid_hit == 0
    # all that a disc can reach which keeps off the walls has been swept
    floor = floor_of(part)
    walls = shape.slice(Vector(0, 0, 1), FLOOR + 0.5)
    solid = shapely.Polygon()
    for wire in walls:
        ring = shapely.Polygon([(p.x, p.y) for p in wire.discretize(Deflection=0.001)])
        solid = shapely.symmetric_difference(solid, ring)
    centers = shapely.difference(floor.buffer(R), solid.buffer(R + 0.01, quad_segs=64))
    centers = max(shapely.get_parts(centers), key=lambda p: p.area)
    wanted = shapely.intersection(centers.buffer(R, quad_segs=64), floor)
    deep = [p[:2] for p in places(motion(op), 0.2) if p[2] < FLOOR + 0.001]
    swept = shapely.union_all(shapely.buffer(shapely.points(np.array(deep)), R, quad_segs=32))
    left = shapely.difference(wanted, swept.buffer(0.03)).buffer(-0.01)
    assert left.area < 0.05


def test_another_part_of_the_job_beside_an_open_side_is_kept_off(doc):
    other = Part.makeBox(20, 10, 12, Vector(40, -15, -12))
    job, part = job_of(doc, notch(), other, beside=1.0)
    op = cut(job, part)
    assert len(gouges(Surface.of(other), places(motion(op), 1.0), R, 0.01)) == 0
    assert op.Proxy.plans[0].report.uncut_area < 0.05


def test_a_step_below_is_no_wall_and_one_above_is(doc):
    steps = notch().fuse(Part.makeBox(40, 10, 3, Vector(30, -10, -12)))
    steps = steps.fuse(Part.makeBox(10, 10, 12, Vector(45, -16, -12))).removeSplitter()
    job, part = job_of(doc, steps.Solids[0], beside=1.0)
    op = cut(job, part)
    assert len(gouges(Surface.of(steps), places(motion(op), 1.0), R, 0.01)) == 0
    assert op.Proxy.plans[0].report.uncut_area < 0.05


def test_the_cutter_stays_within_the_floor_if_it_shall(doc):
    job, part = job_of(doc, notch())
    op = cut(job, part, ExtendOpenSides=False)
    (plan,) = op.Proxy.plans
    assert plan.request.stock is None
    assert plan.request.pocket.equals(floor_of(part))
    assert any("stays within the floor" in notice for notice in op.Notices)
    op.ExtendOpenSides = True
    doc.recompute()
    assert op.Proxy.plans[0].request.pocket.bounds[1] < -R
    assert any("runs out of it" in notice for notice in op.Notices)


def test_a_face_without_any_wall_is_no_floor(doc):
    job, part = job_of(doc, plate())
    with pytest.raises(SelectionError, match="no wall rises"):
        api.add_spiral_pocket(job, [(part, faces_at(part.Shape, 0.0))], FinalDepth=-1.0)


def test_slanted_walls_at_an_open_side(doc):
    shape = plate(tool_box(20, -20, 80, 40))
    for x, lean in ((20, -1), (80, 1)):
        wedge = Part.Face(
            Part.makePolygon(
                [
                    Vector(*p)
                    for p in [(x, -1, FLOOR), (x, -1, 1), (x + lean * 3, -1, 1), (x, -1, FLOOR)]
                ]
            )
        )
        shape = shape.cut(wedge.extrude(Vector(0, 41 - 4, 0)))
    shape = shape.Solids[0]
    job, part = job_of(doc, shape)
    op = cut(job, part, StepDown=1.5)
    (plan,) = op.Proxy.plans
    assert len(plan.request.sections) == 4
    assert plan.report.uncut_area < 0.05
    assert len(gouges(Surface.of(shape), places(motion(op), 1.0), R, 0.01)) == 0


@pytest.mark.parametrize("radius", [4.0, 5.0])
def test_a_low_boss_in_an_open_pocket_is_cleared_to_its_top(doc, radius):
    boss = Part.makeCylinder(radius, 3, Vector(20, 20, FLOOR))
    shape = PARTS["corner"]().fuse(boss).removeSplitter()
    job, part = job_of(doc, shape.Solids[0])
    op = cut(job, part, StepDown=5.0)
    solid = Surface.of(part.Shape)
    path = np.array(places(motion(op), 0.5))
    assert len(gouges(solid, path, R, 0.01)) == 0
    low = path[np.abs(path[:, 2] - (FLOOR + 3)) < 0.001]
    swept = shapely.union_all(shapely.buffer(shapely.points(low[:, :2]), R))
    assert swept.contains(shapely.Point(20, 20).buffer(radius - 0.1))


def test_a_side_that_leans_in_below_the_floor_hangs_over_nothing(doc):
    # as the sides of a part with draft, or of a ball: cut along the slot, they reach up to its edge
    shape = plate(tool_box(40, -20, 60, 80, corner=0))
    below = Part.makeBox(200, 100, 40, Vector(-50, -100, -40))
    below.rotate(Vector(0, 0, 0), Vector(1, 0, 0), 15)
    shape = shape.cut(below).Solids[0]
    job, part = job_of(doc, shape)
    op = cut(job, part)
    assert op.UncutArea < 0.05
    assert op.Proxy.plans[0].request.beyond.bounds[1] < -0.1
    assert len(gouges(Surface.of(shape), places(motion(op), 1.0), R, 0.01)) == 0


@pytest.mark.parametrize(
    ("diameter", "said"), [(8.0, "no wider than the 8 mm"), (9.0, "(8|7.99) mm wide")]
)
def test_a_keyway_is_as_narrow_as_across_however_short_it_is(doc, diameter, said):
    bore = Part.makeCylinder(25, 20, Vector(50, 30, -12))
    job, part = job_of(doc, plate(bore, tool_box(46, 50, 54, 58, corner=0)), diameter=diameter)
    with pytest.raises(CutterDoesNotFitError, match=said):
        cut(job, part)
