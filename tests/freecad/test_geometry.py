# SPDX-License-Identifier: LGPL-2.1-or-later
"""Floors become polygons that stay inside the pocket and miss no more than the sag."""

from itertools import pairwise

import FreeCAD
import numpy as np
import Part
import pytest
import shapely
from FreeCAD import Vector
from sample_parts import (
    DEPTH,
    add_part,
    area,
    block,
    circle,
    faces_at,
    polygon,
    rectangle,
    spline,
)

from freecad_spiralpocket.engine.errors import SelectionError
from freecad_spiralpocket.op import geometry, selection
from freecad_spiralpocket.op.floors import find_floors

SAG = 0.005
ROUNDING = 1e-7

#: A kidney: a smooth outline with an inward bulge.
KIDNEY = [(0, 0), (30, -8), (60, 0), (66, 20), (45, 22), (30, 14), (15, 22), (-6, 20)]
FLOORS = {
    "rounded rectangle": lambda: area(rectangle(50, 30, 6)),
    "circle": lambda: area(circle(17)),
    "round island": lambda: area(circle(25), circle(6, 3, 2)),
    "spline": lambda: area(spline(KIDNEY)),
    "spline island": lambda: area(
        rectangle(70, 50, 8, -20, -20), spline([(0, 0), (12, -4), (24, 0), (20, 10), (8, 6)])
    ),
    "polygon": lambda: area(polygon([(0, 0), (40, 0), (50, 25), (20, 35), (-5, 20)])),
    "island touching the wall": lambda: area(rectangle(50, 36, 6), circle(6, 25, 6)),
    "islands touching": lambda: area(rectangle(50, 36, 6), circle(6, 18, 18), circle(7, 31, 18)),
    "inward arc": lambda: area(rectangle(60, 40)).cut(area(circle(15, 30, 45))).Faces[0],
}


def cusp():
    """Return an area with an arc that leaves an edge where it touches it."""
    low, lean, high = Vector(40, 0, 0), Vector(40 - 50**0.5, 10 - 50**0.5, 0), Vector(30, 10, 0)
    corners = [high, Vector(30, 30, 0), Vector(0, 30, 0), Vector(0, 0, 0), low]
    lines = [Part.makeLine(a, b) for a, b in pairwise(corners)]
    return Part.Face(Part.Wire([Part.Arc(low, lean, high).toShape(), *lines]))


FLOORS["cusp"] = cusp
#: Of the tips between an arc and what touches it a little is lost.
CUSPS = ("cusp", "island touching the wall", "islands touching")


def floor_of(doc, shape, index=0, z=-DEPTH):
    part = add_part(doc, shape)
    return selection.floor(part, faces_at(shape, z)[index])


def true_outline(face, per_edge=400):
    """Return points on all edges of `face`."""
    points = []
    for edge in face.Edges:
        for t in np.linspace(*edge.ParameterRange, per_edge):
            point = edge.valueAt(t)
            points.append((point.x, point.y))
    return shapely.points(np.array(points))


def depth_in_material(face, polygon, per_segment=7):
    """Return how far the polygon's outline leaves the true face at most [mm]."""
    worst = 0.0
    for ring in (polygon.exterior, *polygon.interiors):
        ends = np.array(ring.coords)
        for f in np.linspace(0, 1, per_segment, endpoint=False):
            for x, y in ends[:-1] * (1 - f) + ends[1:] * f:
                vertex = Vector(x, y, face.BoundBox.ZMin)
                if not face.isInside(vertex, ROUNDING, True):
                    worst = max(worst, face.distToShape(Part.Vertex(vertex))[0])
    return worst


@pytest.mark.parametrize("name", FLOORS)
def test_polygon_stays_inside_the_floor(doc, name):
    floor = floor_of(doc, block(FLOORS[name]()))
    assert depth_in_material(floor.face, geometry.polygon(floor, SAG)) <= ROUNDING


@pytest.mark.parametrize("name", sorted(set(FLOORS) - set(CUSPS)))
def test_polygon_misses_no_more_than_the_sag(doc, name):
    floor = floor_of(doc, block(FLOORS[name]()))
    outline = geometry.polygon(floor, SAG).boundary
    assert shapely.distance(true_outline(floor.face), outline).max() <= 1.1 * SAG


@pytest.mark.parametrize("name", CUSPS)
def test_cusp_loses_no_more_than_its_tip(doc, name):
    floor = floor_of(doc, block(FLOORS[name]()))
    lost = floor.face.Area - geometry.polygon(floor, SAG).area
    assert 0 <= lost <= SAG * 60  # the arcs' radii and lengths


@pytest.mark.parametrize("name", FLOORS)
def test_rings_run_with_the_pocket_on_their_left(doc, name):
    found = geometry.polygon(floor_of(doc, block(FLOORS[name]())), SAG)
    assert found.exterior.is_ccw and not any(ring.is_ccw for ring in found.interiors)


@pytest.mark.parametrize("turn", ["mirrored", "turned", "moved"])
def test_placed_and_mirrored_parts_give_the_same_area(doc, turn):
    shape = block(FLOORS["round island"]())
    if turn == "mirrored":
        shape = shape.mirror(Vector(), Vector(1, 0, 0))
    elif turn == "turned":
        shape.rotate(Vector(5, 5, 0), Vector(0, 0, 1), 33)
    else:
        shape.Placement = FreeCAD.Placement(Vector(100, -40, 0), FreeCAD.Rotation(90, 0, 0))
    floor = floor_of(doc, shape)
    found = geometry.polygon(floor, SAG)
    assert depth_in_material(floor.face, found) <= ROUNDING
    assert found.area == pytest.approx(np.pi * (25**2 - 6**2), rel=1e-3)


def test_finer_sag_gives_more_of_the_area(doc):
    floor = floor_of(doc, block(FLOORS["round island"]()))
    missing = [floor.face.Area - geometry.polygon(floor, sag).area for sag in (0.08, 0.02, 0.005)]
    assert missing[0] > missing[1] > missing[2] > 0
    assert missing[0] / missing[2] == pytest.approx(16, rel=0.3)  # in step with the sag


def test_straight_walls_are_exact(doc):
    floor = floor_of(doc, block(FLOORS["polygon"]()))
    assert geometry.polygon(floor, SAG).area == pytest.approx(floor.face.Area, abs=1e-9)


def test_use_outline_leaves_out_islands(doc):
    floor = floor_of(doc, block(FLOORS["round island"]()))
    found = geometry.polygon(floor, SAG, use_outline=True)
    assert not found.interiors
    assert found.area == pytest.approx(np.pi * 25**2, rel=1e-3)


def test_a_drilled_hole_in_the_floor_is_no_island(doc):
    import Part

    shape = block(area(circle(25), circle(6, 8, 2)))
    shape = shape.cut(Part.makeCylinder(4, 50, Vector(-10, 0, -40)))
    found = geometry.polygon(floor_of(doc, shape), SAG)
    assert len(found.interiors) == 1
    assert not found.contains(shapely.Point(8, 2)) and found.contains(shapely.Point(-10, 0))


def test_an_island_on_a_fillet_is_an_island(doc):
    shape = block(area(rectangle(60, 50), circle(10, 30, 25)))
    rim = [
        e for e in shape.Edges if abs(e.BoundBox.ZMax + DEPTH) < 1e-6 and e.BoundBox.XLength < 21
    ]
    rim = [e for e in rim if e.Curve.TypeId == "Part::GeomCircle"]
    floor = floor_of(doc, shape.makeFillet(1.5, rim))
    found = geometry.polygon(floor, SAG)
    assert not floor.open_edges
    assert shapely.Polygon(found.interiors[0]).area == pytest.approx(np.pi * 11.5**2, rel=1e-3)


def test_a_pocket_open_at_a_side_says_so(doc):
    import Part

    shape = Part.makeBox(40, 30, 10, Vector(0, 0, -10))
    shape = shape.cut(Part.makeBox(30, 20, DEPTH, Vector(-1, 5, -DEPTH)))
    assert floor_of(doc, shape).open_edges == 1


UNUSUAL_PARTS = {
    "closed shell": lambda solid: solid.Shells[0],
    "loose faces": lambda solid: Part.Compound([face.copy() for face in solid.Faces]),
    "loose faces that look anywhere": lambda solid: Part.Compound(
        [face.copy().reversed() if n % 2 else face.copy() for n, face in enumerate(solid.Faces)]
    ),
    "inside out": lambda solid: solid.reversed(),
}


@pytest.mark.parametrize("part", UNUSUAL_PARTS.values(), ids=UNUSUAL_PARTS.keys())
def test_a_closed_part_need_not_be_a_solid(doc, part):
    solid = block(area(rectangle(50, 30, 6), circle(6, 20, 15)))
    shape = part(solid)
    floors = [i for i, f in enumerate(shape.Faces) if f.BoundBox.ZMax == pytest.approx(-DEPTH)]
    floor = selection.floor(add_part(doc, shape), f"Face{floors[0] + 1}")
    assert not floor.open_edges and floor.face.normalAt(0, 0).z > 0 and floor.solid.isClosed()
    expected = geometry.polygon(floor_of(doc, solid), SAG)
    assert shapely.symmetric_difference(geometry.polygon(floor, SAG), expected).area < ROUNDING


def test_find_floors_finds_closed_pockets_only(doc):
    import Part

    shape = block(area(circle(12)), area(circle(9, 40, 0)))
    shape = shape.cut(Part.makeBox(10, 200, 2, Vector(20, -100, -2)))  # an open slot
    names = [f.name for f in find_floors(add_part(doc, shape))]
    assert sorted(names) == sorted(faces_at(shape, -DEPTH))


@pytest.mark.parametrize(
    ("face", "words"),
    [
        (lambda s: faces_at(s, 0)[0], "not the floor of a pocket"),
        (lambda s: faces_at(s, -DEPTH - 4, looking=-1)[0], "looks down"),
        (lambda s: "Edge1", "not a face"),
        (lambda s: "Face99", "not there any more"),
        (lambda s: "?Face3", "not there any more"),
    ],
)
def test_what_is_no_floor_is_named(doc, face, words):
    shape = block(area(rectangle(30, 20, 4)))
    with pytest.raises(SelectionError, match=words):
        selection.floor(add_part(doc, shape), face(shape))


def test_a_cone_and_a_slope_are_not_level(doc):
    import Part

    cone = add_part(doc, Part.makeCone(10, 5, 10))
    wedge = add_part(doc, Part.makeWedge(0, 0, 0, 4, 0, 20, 10, 20, 6, 10))
    curved = next(n for n, f in enumerate(cone.Shape.Faces, 1) if f.BoundBox.ZLength > 1)
    with pytest.raises(SelectionError, match="not flat"):
        selection.floor(cone, f"Face{curved}")
    sloped = next(
        n for n, f in enumerate(wedge.Shape.Faces, 1) if 0.1 < abs(f.normalAt(0, 0).z) < 0.99
    )
    with pytest.raises(SelectionError, match="not level"):
        selection.floor(wedge, f"Face{sloped}")
