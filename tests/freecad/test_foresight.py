# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the preview plans is what the next recompute plans, and reading it changes nothing."""

import FreeCAD
import pytest
from sample_parts import QUICK, small_job

from freecad_spiralpocket.engine.errors import RequestError, SetupError
from freecad_spiralpocket.op import operation
from freecad_spiralpocket.op.compat import parent_job, supplied_tool_controller
from freecad_spiralpocket.op.foresight import requests_of


def planned(op):
    """Return the requests of the last recompute."""
    return [plan.request for plan in op.Proxy.plans]


@pytest.fixture
def fresh(doc):
    """Return an operation that was never computed."""
    job, _, face = small_job(doc)
    with supplied_tool_controller(job.Tools.Group[0]):
        op = operation.Create("SpiralPocket", parentJob=job)
    op.Base = [(job.Model.Group[0], (face,))]
    for name, value in QUICK.items():
        setattr(op, name, value)
    return op


def test_of_a_new_operation(fresh):
    foreseen, *_ = requests_of(fresh)
    fresh.Document.recompute()
    assert foreseen == planned(fresh)


def test_reading_touches_nothing(fresh):
    fresh.Document.recompute()
    before = fresh.Content
    requests_of(fresh)
    assert fresh.Content == before
    assert "Touched" not in fresh.State


@pytest.mark.parametrize(
    ("name", "expression"),
    [
        ("StepDown", "OpToolDiameter / 3"),
        ("StockToLeave", "OpToolDiameter / 20"),
        ("FinalDepth", "OpFinalDepth + 1 mm"),
        ("StockToLeave", "0.1 mm * 3"),
        ("SlowdownPercent", "50 + 5"),
        ("StepOver", "33.7"),
        ("StepOver", "33.5 mm / 1 mm"),
        ("Strategy", "2"),
        ("UseOutline", "1"),
        ("StartPoint.x", "OpToolDiameter / 2"),
    ],
)
def test_with_an_expression(fresh, name, expression):
    fresh.UseStartPoint, fresh.StartPoint = True, FreeCAD.Vector(9, 10, 0)
    fresh.setExpression(name, expression)
    foreseen, *_ = requests_of(fresh)
    fresh.Document.recompute()
    assert foreseen == planned(fresh)


def test_with_another_tool_and_more_stock(fresh):
    fresh.Document.recompute()
    job = parent_job(fresh)
    job.Tools.Group[0].Tool.Diameter = 4
    job.Stock.ExtZpos = 2
    job.Stock.recompute()
    foreseen, *_ = requests_of(fresh)
    assert foreseen[0].tool_diameter == 4
    fresh.touch()
    fresh.Document.recompute()
    assert foreseen == planned(fresh)


def test_broken_setup_is_told(fresh):
    fresh.ToolController.ToolNumber = 0
    with pytest.raises(SetupError, match="number 0"):
        requests_of(fresh)


def test_broken_expression_is_told(fresh):
    other = fresh.Document.addObject("App::FeaturePython", "Other")
    other.addProperty("App::PropertyLength", "Size")
    fresh.setExpression("StockToLeave", "Other.Size")
    other.removeProperty("Size")
    with pytest.raises(RequestError, match="StockToLeave"):
        requests_of(fresh)
