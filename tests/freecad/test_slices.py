# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections of faces: their rings close, or the place where one does not is told."""

import math
from itertools import pairwise

import numpy as np
import Part
import pytest
from FreeCAD import Vector
from shapely import Point, Polygon, box

from freecad_spiralpocket.engine.errors import GeometryError
from freecad_spiralpocket.op import geometry, slices, triangles

SAG = 0.005
PEG = (20.0, 10.0)


def walls_of_a_peg(gap=0.0):
    """Return the walls of a peg, 10 mm wide and high, two of which miss each other by `gap`."""
    x, y = PEG
    corners = [(x + gap, y), (x + 10, y), (x + 10, y + 10), (x, y + 10), (x, y)]
    walls = []
    for (x0, y0), (x1, y1) in pairwise(corners):
        foot = Part.makeLine(Vector(x0, y0, 0), Vector(x1, y1, 0))
        walls.append(foot.extrude(Vector(0, 0, 10)))
    return walls


@pytest.mark.parametrize("share", [0.0, 0.5, 0.9])
def test_gaps_as_narrow_as_those_of_a_floor_close(share):
    (ring,) = slices.section(walls_of_a_peg(share * geometry.GAP), 5.0, SAG)
    assert Polygon(ring).symmetric_difference(box(20, 10, 30, 20)).area < 0.01


@pytest.mark.parametrize("first", range(4))
@pytest.mark.parametrize("gap", [1.1 * geometry.GAP, 0.05, 2.0])
def test_a_wider_gap_is_told_with_its_place(gap, first):
    walls = walls_of_a_peg(gap)
    with pytest.raises(GeometryError, match=r"Z5 is not closed at X2.*Repair") as caught:
        slices.section(walls[first:] + walls[:first], 5.0, SAG)
    assert Point(caught.value.place).distance(Point(PEG)) < 1.01 * gap


def test_rings_may_end_beyond_the_ground_that_is_looked_at():
    walls = walls_of_a_peg()
    inside = slices.section(walls, 5.0, SAG, box(0, 0, 40, 40))
    assert len(inside) == 1
    assert slices.section(walls[1:], 5.0, SAG, box(0, 0, 19, 40)) == []
    with pytest.raises(GeometryError):
        slices.section(walls[1:], 5.0, SAG, box(0, 0, 25, 40))


def test_a_piece_that_freecad_leaves_out_is_found_a_hair_higher():
    # where a fillet's rim wavers: at one height the section of a face is empty
    walls = walls_of_a_peg()

    class Skipping:
        """A face whose section lacks a piece at the first height that is asked for."""

        def __init__(self, face):
            self._face, self.heights = face, []

        def __getattr__(self, name):
            return getattr(self._face, name)

        def slice(self, normal, z):
            self.heights.append(z)
            return self._face.slice(normal, z) if len(self.heights) > 1 else []

    skipping = Skipping(walls[1])
    (ring,) = slices.section([walls[0], skipping, *walls[2:]], 5.0, SAG)
    assert Polygon(ring).area == pytest.approx(100)
    assert max(abs(z - 5.0) for z in skipping.heights) < 0.005


def ring(inner, outer):
    disc, hole = (Point(0, 0).buffer(r, quad_segs=256) for r in (outer, inner))
    return disc.difference(hole)


def bored_ball():
    """Return a ball, a height, and where its face leans out above that."""
    ball = Part.makeSphere(12).cut(Part.makeCylinder(4, 40, Vector(0, 0, -20)))
    return ball, -5.0, ring(math.sqrt(12**2 - 5**2), 12)


def slotted_torus():
    slot = Part.makeBox(70, 6, 40, Vector(-35, -3, -2))
    half = math.sqrt(6**2 - 4**2)
    outside, inside = ring(20 + half, 26), ring(14, 20 - half)
    return Part.makeTorus(20, 6).cut(slot), -4.0, outside.union(inside)


@pytest.mark.parametrize("shape", [bored_ball, slotted_torus])
def test_what_hangs_over_a_place_is_found_without_the_rest_of_the_face(shape):
    solid, z, leaning = shape()
    place = box(4, 8, 14, 24)
    bent = [face for face in solid.Faces if not isinstance(face.Surface, Part.Plane)]
    found_on = [slices.overhang(face, place, z) for face in bent]
    wanted = leaning.intersection(place)
    found = slices.shadow(found_on, z).intersection(place)
    # what hardly looks up is taken too
    assert wanted.area > 1.0 and wanted.difference(found).area < 0.1
    assert found.difference(wanted.buffer(0.1)).area < 0.1
    reach = np.concatenate(found_on).reshape(-1, 3)[:, :2]
    assert reach.min(axis=0)[1] > 0 and reach[:, 0].min() > 0


def test_what_looks_up_above_a_place_needs_no_triangles():
    solid = Part.makeTorus(20, 6)
    assert not len(slices.overhang(solid.Faces[0], box(-30, -30, 30, 30), 2.0))


def test_a_face_that_ends_at_a_height_hangs_over_nothing_there():
    side = Part.makeLine(Vector(0, 0, 0), Vector(10, 0, 0)).extrude(Vector(0, 3, 5))
    found = slices.overhang(side, box(-5, -5, 15, 15), -1.0)
    assert len(found)
    assert slices.shadow([found], 5.0).is_empty
    assert slices.shadow([found], 4.0).area == pytest.approx(10 * 0.6, rel=0.1)


@pytest.mark.parametrize("minor", [0.5, 2.0, 6.0])
def test_turned_faces_become_triangles_within_the_sag(minor):
    torus = Part.makeTorus(20, minor).Faces[0]
    parts = [torus, Part.makeSphere(minor).Faces[0]]
    block = Part.makeBox(60, 60, 40, Vector(-30, -30, -20))
    parts += [
        f
        for f in block.cut(Part.makeTorus(20, minor)).Faces
        if not isinstance(f.Surface, Part.Plane)
    ]
    for face in parts:
        assert triangles.is_patch(face)
        found = triangles.looking_down(face)
        assert len(found) < 30000
        middles = found.mean(axis=1)[:: max(1, len(found) // 200)]
        for x, y, z in middles:
            u, v = face.Surface.parameter(Vector(x, y, z))
            assert (face.Surface.value(u, v) - Vector(x, y, z)).Length < 1.2 * triangles.SAG
            assert face.normalAt(u, v).z < 0.3


def test_a_face_with_a_hole_is_no_patch():
    ball = Part.makeSphere(12).cut(Part.makeCylinder(2, 40, Vector(5, 0, -20)))
    (face,) = [f for f in ball.Faces if isinstance(f.Surface, Part.Sphere)]
    assert not triangles.is_patch(face)
