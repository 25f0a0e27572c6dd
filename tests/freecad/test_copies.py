# SPDX-License-Identifier: LGPL-2.1-or-later
"""Copies of a pocket in one part are planned once and have the same path, each at its place."""

import numpy as np
import pytest
from FreeCAD import Vector
from sample_parts import DEPTH, QUICK, add_job, add_part, area, block, faces_at, motion, rectangle
from solid_oracle import Surface, gouges, places

from freecad_spiralpocket import api
from freecad_spiralpocket.beside import crew
from freecad_spiralpocket.op.operation import ObjectSpiralPocket

RADIUS = 3.0


def ell(x, y, turn):
    """Return an L of 30 x 24 mm with rounded corners, turned by an angle [deg] about (x, y)."""
    tall, wide = (rectangle(12, 24, 4, x, y), rectangle(30, 11, 4, x, y))
    face = area(tall).fuse(area(wide)).removeSplitter().Faces[0]
    face.rotate(Vector(x, y, 0), Vector(0, 0, 1), turn)
    return face


PLACES = [(0, 0, 0), (45, 3, 0), (60, 60, 72), (15, 75, 180)]


@pytest.fixture
def asked(monkeypatch):
    """Return a list of how many pockets were planned each time."""
    numbers = []

    def planner(requests, progress):
        numbers.append(len(requests))
        return crew.plan_together(requests, progress)

    monkeypatch.setattr(ObjectSpiralPocket, "planner", staticmethod(planner))
    return numbers


@pytest.fixture
def plate(doc):
    part = add_part(doc, block(*(ell(*place) for place in PLACES)))
    return part, add_job(doc, part, diameter=2 * RADIUS)


def test_copies_are_planned_once_and_cut_as_one(plate, asked):
    part, job = plate
    made = api.add_spiral_pocket(job, [(part, faces_at(part.Shape, -DEPTH))], StepDown=6.0)
    assert asked == [1]
    plans = made.Proxy.plans
    assert len(plans) == 4
    assert len({len(plan.toolpath) for plan in plans}) == 1
    assert max(plan.report.uncut_area for plan in plans) < 0.01
    middles = [plan.request.pocket.centroid for plan in plans]
    for plan, middle in zip(plans, middles, strict=True):
        away = np.hypot(*(plan.toolpath.points[:, :2] - [middle.x, middle.y]).T)
        first = np.hypot(*(plans[0].toolpath.points[:, :2] - [middles[0].x, middles[0].y]).T)
        assert away == pytest.approx(first, abs=1e-5)
    assert len(gouges(Surface.of(part.Shape), places(motion(made), 0.5), RADIUS, 0.01)) == 0


def test_what_was_selected_before_does_not_change_the_path(plate, asked):
    part, job = plate
    names = faces_at(part.Shape, -DEPTH)
    made = api.add_spiral_pocket(job, [(part, names[:1])], **QUICK)
    made.Base = [(part, names)]
    job.Document.recompute()
    assert asked == [1, 0]
    made.Base = [(part, names[1:])]
    job.Document.recompute()
    fresh = api.add_spiral_pocket(job, [(part, names[1:])], **QUICK)
    assert asked == [1, 0, 1, 1]
    assert [(c.Name, c.x, c.y, c.z) for c in motion(made)] == [
        (c.Name, c.x, c.y, c.z) for c in motion(fresh)
    ]


def test_what_cannot_be_cut_is_told_of_each_copy(doc, asked):
    narrow = [area(rectangle(20, 5, 1, 0, y)) for y in (0, 20)]
    part = add_part(doc, block(area(rectangle(30, 20, 4, 40, 0)), *narrow))
    job = add_job(doc, part)
    made = api.add_spiral_pocket(job, [(part, faces_at(part.Shape, -DEPTH))], **QUICK)
    assert asked == [2]
    assert len(made.Proxy.plans) == 1
    told = [text for text in made.Notices if "not cut" in text]
    assert ["Y2.5" in text for text in told] == [True, False]
    assert "Y22.5" in told[1]
