# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the comparison calls FreeCAD's Adaptive is what FreeCAD's operation makes."""

import math

import pytest
from sample_parts import small_job

from freecad_spiralpocket import api
from freecad_spiralpocket.adaptive import plan_adaptive
from freecad_spiralpocket.op.compat import IS_LEGACY, supplied_tool_controller
from freecad_spiralpocket.op.foresight import requests_of


def make_adaptive(job, model, face, stepover):
    """Return FreeCAD's own operation on a face, computed."""
    if IS_LEGACY:
        from PathScripts import PathAdaptive as Adaptive
    else:
        from Path.Op import Adaptive
    with supplied_tool_controller(job.Tools.Group[0]):
        op = Adaptive.Create("Adaptive", parentJob=job)
    op.Base = [(model, (face,))]
    op.StepOver = stepover
    job.Document.recompute()
    return op


def fed_length(path):
    """Return the length of all straight feed moves [mm]."""
    here, total = {"X": 0.0, "Y": 0.0, "Z": 0.0}, 0.0
    for command in path.Commands:
        there = {**here, **{k: v for k, v in command.Parameters.items() if k in here}}
        if command.Name == "G1":
            total += math.dist(here.values(), there.values())
        here = there
    return total


def test_moves_are_those_of_freecads_operation(doc):
    job, part, face = small_job(doc)
    ours = api.add_spiral_pocket(job, [(part, [face])], StepOver=40, Strategy="Linear Morph")
    (request,), *_ = requests_of(ours)
    made = plan_adaptive(request).toolpath
    theirs = make_adaptive(job, job.Model.Group[0], face, 40)
    fed = made.kinds == 1
    assert made.lengths[fed].sum() == pytest.approx(fed_length(theirs.Path), rel=0.02)
    box = theirs.Path.BoundBox
    cut = made.points[fed]
    assert cut[:, 0].max() == pytest.approx(box.XMax, abs=0.05)
    assert cut[:, 1].max() == pytest.approx(box.YMax, abs=0.05)
    assert cut[:, 2].min() == pytest.approx(theirs.FinalDepth.Value)
