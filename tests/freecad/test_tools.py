# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which tools clear a pocket, which leave ridges, and whose floors count as cleared."""

from types import SimpleNamespace

import Path
import pytest
from sample_parts import QUICK, set_feeds, small_job

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.errors import SetupError
from freecad_spiralpocket.op import compat, rest
from freecad_spiralpocket.op.tools import FLAT_TOOLS, ROUND_TOOLS, UNSUITABLE_TOOLS

#: All that 0.20 offers, by what becomes of them.
LEGACY = {
    FLAT_TOOLS: ["EndMill"],
    ROUND_TOOLS: ["BallEndMill"],
    UNSUITABLE_TOOLS: [
        *("CenterDrill", "ChamferMill", "CornerRound", "CounterBore", "CounterSink", "Drill"),
        *("Engraver", "FlyCutter", "Reamer", "SlotCutter", "Tap"),
    ],
}


def legacy_controller(job, kind):
    """Return a new tool controller of `job` with a legacy tool, as 0.20 makes it."""
    tool = Path.Tool()
    tool.Name, tool.ToolType, tool.Diameter = f"My {kind}", kind, 6.0
    with compat.active_document(job.Document):
        controller = compat.PathToolController.Create("Legacy", tool, 5)
    job.Proxy.addToolController(controller)
    set_feeds(controller, 1500.0)
    return controller


def test_no_tool_is_of_two_kinds():
    names = [*FLAT_TOOLS, *ROUND_TOOLS, *UNSUITABLE_TOOLS]
    assert len(set(names)) == len(names)


@pytest.mark.parametrize(
    ("kinds", "name"), [(kinds, name) for kinds, names in LEGACY.items() for name in names]
)
def test_a_legacy_tool_is_of_the_kind_of_the_tool_bit_of_its_form(kinds, name):
    assert compat.tool_shape(SimpleNamespace(ToolType=name)) in kinds


def test_a_new_end_mill_is_flat(doc):
    job, _, _ = small_job(doc)
    assert compat.tool_shape(job.Tools.Group[0].Tool) in FLAT_TOOLS


@pytest.mark.skipif(not compat.IS_LEGACY, reason="legacy tools are gone")
def test_legacy_tools_in_a_job(doc):
    job, part, face = small_job(doc)
    base = [(part, [face])]
    named = [name for names in LEGACY.values() for name in names]
    assert sorted(Path.Tool().getToolTypes()) == sorted(named)
    with pytest.raises(SetupError, match="My ChamferMill is not an end mill"):
        api.add_spiral_pocket(job, base, legacy_controller(job, "ChamferMill"), **QUICK)
    ball = api.add_spiral_pocket(job, base, legacy_controller(job, "BallEndMill"), **QUICK)
    assert any("My BallEndMill is not flat" in notice for notice in ball.Notices)


def test_only_flat_cutters_have_cleared_a_floor(doc, monkeypatch):
    job, part, face = small_job(doc)
    base = [(part, [face])]
    api.add_spiral_pocket(job, base, **QUICK)
    last = api.add_spiral_pocket(job, base, **QUICK)
    assert len(list(rest.cutters_before(last))) == 1
    for shape in (*ROUND_TOOLS, *UNSUITABLE_TOOLS, "", "custom", "mine"):
        monkeypatch.setattr(rest, "tool_shape", lambda tool, shape=shape: shape)
        assert not list(rest.cutters_before(last)), shape
