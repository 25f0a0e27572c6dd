# SPDX-License-Identifier: LGPL-2.1-or-later
"""Windows: holes through a part are cleared down to its lower side, told by a wall of theirs."""

import math

import Part
import pytest
from FreeCAD import Vector
from sample_parts import (
    DEPTH,
    QUICK,
    add_job,
    add_part,
    area,
    block,
    circle,
    faces_at,
    motion,
    rectangle,
    slanted_block,
)
from solid_oracle import Stock, Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import SelectionError
from freecad_spiralpocket.op import selection

R, BOTTOM = 3.0, -DEPTH - 4.0


def plate(*outlines):
    """Return a block with holes through it, each from 4 mm below `DEPTH` upwards."""
    shape = block(*outlines)
    for face in outlines:
        through = face.extrude(Vector(0, 0, 40))
        through.translate(Vector(0, 0, -30))
        shape = shape.cut(through)
    return shape.removeSplitter()


def walls_of(shape, x, y):
    """Return the names of all faces that are not level and whose box's middle is at (x, y)."""
    return [
        f"Face{number}"
        for number, face in enumerate(shape.Faces, 1)
        if face.BoundBox.ZLength > 1
        and abs(face.BoundBox.Center.x - x) < 0.1
        and abs(face.BoundBox.Center.y - y) < 0.1
    ]


def cut(doc, shape, names, **options):
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=2 * R)
    return api.add_spiral_pocket(job, [(part, names)], StepDown=5.0, **options)


WINDOW = plate(area(rectangle(40, 30, 5)))
LOFT = slanted_block((10, 10, 10, 10), -BOTTOM, 40.0, 30.0, 6.0)
FLARED = LOFT.common(Part.makeBox(200, 200, -BOTTOM, Vector(-80, -80, BOTTOM)))


@pytest.mark.parametrize("name", ["left", "right", "corner"])
def test_any_wall_tells_of_the_window(doc, name):
    place = {"left": (0, 15), "right": (40, 15), "corner": (2.5, 2.5)}[name]
    op = cut(doc, WINDOW, walls_of(WINDOW, *place)[:1])
    (plan,) = op.Proxy.plans
    assert op.FinalDepth.Value == pytest.approx(BOTTOM)
    assert plan.report.uncut_area < 0.01 and op.Gouge <= op.Tolerance.Value
    assert plan.request.pocket.area == pytest.approx(40 * 30, rel=0.03)
    centers = places(motion(op), 0.5)
    assert len(gouges(Surface.of(WINDOW), centers, R, 0.01)) == 0
    assert centers[:, 2].min() == pytest.approx(BOTTOM, abs=0.001)


def test_several_walls_are_one_window(doc):
    names = [*walls_of(WINDOW, 0, 15), *walls_of(WINDOW, 40, 15), *walls_of(WINDOW, 20, 0)]
    op = cut(doc, WINDOW, names, **QUICK)
    assert len(names) == 3 and len(op.Proxy.plans) == 1


def test_windows_and_floors_are_cut_to_their_own_depths(doc):
    pocket = area(rectangle(20, 20, 5, 40, 0)).extrude(Vector(0, 0, 20))
    pocket.translate(Vector(0, 0, -DEPTH / 2))
    wide = Part.makeBox(90, 44, -BOTTOM, Vector(-12, -12, BOTTOM))
    hole = area(rectangle(30, 20, 5)).extrude(Vector(0, 0, 40))
    hole.translate(Vector(0, 0, -30))
    shape = wide.cut(hole).cut(pocket)
    names = [walls_of(shape, 0, 10)[0], *faces_at(shape, -DEPTH / 2)]
    op = cut(doc, shape, names, **QUICK)
    assert [plan.request.floor for plan in op.Proxy.plans] == pytest.approx([BOTTOM, -DEPTH / 2])
    assert len(gouges(Surface.of(shape), places(motion(op), 1.0), R, 0.01)) == 0


def test_a_round_hole_is_a_window_too(doc):
    shape = plate(area(circle(12)))
    (name,) = walls_of(shape, 0, 0)
    op = cut(doc, shape, [name])
    assert op.Proxy.plans[0].report.uncut_area < 0.01


def test_a_ledge_above_stays(doc):
    """A counterbore: the window below it, and its ledge as a pocket of its own."""
    wide = area(rectangle(50, 40, 6, -5, -5)).extrude(Vector(0, 0, 20))
    wide.translate(Vector(0, 0, -3))
    shape = plate(area(rectangle(40, 30, 5))).cut(wide)
    low = [n for n in walls_of(shape, 0, 15) if shape.getElement(n).BoundBox.ZMax < -2.9]
    op = cut(doc, shape, low)
    surface = Surface.of(shape)
    assert len(gouges(surface, places(motion(op), 0.7), R, 0.01)) == 0
    stock = Stock(surface, (0.5, 0.5, 39.5, 29.5), 0.5)
    stock.cut(places(motion(op), 0.3), R + 0.02)
    left = (stock.heights > BOTTOM + 0.01)[4:-4, 4:-4]
    assert not left.any()


def test_leaning_walls_of_a_window_are_followed(doc):
    lean = -BOTTOM * math.tan(math.radians(10)) / 2
    op = cut(doc, FLARED, walls_of(FLARED, 40 + lean, 15))
    assert len(op.Proxy.plans[0].request.sections) == 2
    assert len(gouges(Surface.of(FLARED), places(motion(op), 0.7), R, 0.01)) == 0
    assert op.Proxy.plans[0].report.uncut_area < 0.05


def test_a_chamfer_at_the_lower_edge_is_kept_off(doc):
    low = [
        edge
        for edge in WINDOW.Edges
        if abs(edge.BoundBox.ZMax - BOTTOM) < 1e-6
        and edge.BoundBox.XMin > -1
        and edge.BoundBox.XMax < 41
    ]
    shape = WINDOW.makeChamfer(1.0, low)
    (name,) = walls_of(shape, 0, 15)
    op = cut(doc, shape, [name])
    assert op.FinalDepth.Value == pytest.approx(BOTTOM)
    assert len(gouges(Surface.of(shape), places(motion(op), 0.7), R, 0.01)) == 0
    assert any("lean over the floor" in notice for notice in op.Notices)


def test_a_hole_that_ends_above_the_parts_lower_side_is_told(doc):
    """A groove in its wall: the upper wall ends at the groove's ceiling."""
    groove = area(rectangle(44, 34, 6, -2, -2)).extrude(Vector(0, 0, 2))
    groove.translate(Vector(0, 0, -8))
    shape = WINDOW.cut(groove)
    faces = walls_of(shape, 0, 15)
    (upper,) = (n for n in faces if shape.getElement(n).BoundBox.ZMin > -6.1)
    op = cut(doc, shape, [upper], **QUICK)
    assert op.FinalDepth.Value == pytest.approx(-6)
    assert any("to Z-10; the cutter goes down to Z-6." in notice for notice in op.Notices)


def test_walls_of_blind_pockets_and_of_the_part_are_none(doc):
    shape = block(area(rectangle(40, 30, 5)))
    for place in ((0, 15), (-12, 15)):
        with pytest.raises(SelectionError, match="a wall, not a floor"):
            cut(doc, shape, walls_of(shape, *place))


def test_a_floor_that_is_hardly_out_of_level_is_no_wall_of_a_hole_in_it(doc):
    """As IGES files have them."""
    shape = block(area(rectangle(40, 30, 5))).cut(Part.makeCylinder(5, 40, Vector(20, 15, -30)))
    tilted = shape.copy()
    tilted.rotate(Vector(20, 15, 0), Vector(0, 1, 0), math.degrees(5e-5))
    (name,) = faces_at(shape, -DEPTH)
    face = tilted.getElement(name)
    assert face.BoundBox.ZLength > 1e-3
    part = add_part(doc, tilted)
    assert not selection.floor(part, name).is_window
    assert api.floors(part) == [name]


def test_holes_are_no_pockets_unless_they_are_chosen(doc):
    assert api.floors(add_part(doc, WINDOW)) == []


def test_windows_that_end_at_different_heights_go_together(doc):
    shape = plate(area(rectangle(30, 20, 5)), area(rectangle(24, 18, 4, 50, 0)))
    step = Part.makeBox(60, 60, 2.0, Vector(40, -20, BOTTOM))
    shape = shape.cut(step)
    names = [walls_of(shape, 0, 10)[0], walls_of(shape, 62, 0)[0], walls_of(shape, 62, 18)[0]]
    op = cut(doc, shape, names, **QUICK)
    assert [plan.request.floor for plan in op.Proxy.plans] == pytest.approx([BOTTOM, BOTTOM + 2.0])
    assert len(gouges(Surface.of(shape), places(motion(op), 1.0), R, 0.01)) == 0
