# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the operation's properties become the engine's request."""

import math

import FreeCAD
import pytest
from sample_parts import QUICK, small_job

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import RequestError


def cut(doc, **values):
    """Return an operation in a new job for the small part."""
    job, part, face = small_job(doc)
    return api.add_spiral_pocket(job, [(part, [face])], **{**QUICK, **values})


def request_of(op):
    """Return the request that the operation's one pocket was planned by."""
    (plan,) = op.Proxy.plans
    return plan.request


def test_step_over_is_a_share_of_the_diameter(doc):
    op = cut(doc, StepOver=30)
    assert request_of(op).cutting.stepover == pytest.approx(0.3 * op.OpToolDiameter.Value)


def test_largest_engagement_rules_over_step_over(doc):
    op = cut(doc, StepOver=30, MaxEngagement="70 deg")
    wanted = op.OpToolDiameter.Value / 2 * (1 - math.cos(math.radians(70)))
    assert request_of(op).cutting.stepover == pytest.approx(wanted)
    assert math.degrees(request_of(op).engagement_limit) == pytest.approx(70)


@pytest.mark.parametrize("angle", [-10, 181])
def test_an_engagement_that_cannot_be(doc, angle):
    with pytest.raises(RequestError, match=f"engagement of {angle} degrees"):
        cut(doc, MaxEngagement=angle)


def test_start_point_is_used_when_asked_for(doc):
    op = cut(doc)
    center = op.Base[0][0].Shape.BoundBox.Center
    for use, expected in ((False, None), (True, (center.x, center.y))):
        op.UseStartPoint, op.StartPoint = use, FreeCAD.Vector(center.x, center.y, 50)
        doc.recompute()
        assert request_of(op).start_point == (expected and pytest.approx(expected))
        assert not any("start point" in notice for notice in op.Notices)


def test_start_point_outside_all_pockets_is_told(doc):
    op = cut(doc, UseStartPoint=True, StartPoint=(1000, 0, 0))
    assert request_of(op).start_point is None
    assert any("start point at X1000.0 Y0.0" in notice for notice in op.Notices)
