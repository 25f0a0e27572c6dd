# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is told of depths and walls; rapids stay above the safe height where nothing was cut."""

import pytest
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
    told,
)

from freecad_spiralpocket import api
from freecad_spiralpocket.engine.model import Notice
from freecad_spiralpocket.op import remarks
from freecad_spiralpocket.op.foresight import requests_of


@pytest.fixture
def job(doc):
    return add_job(doc, add_part(doc, block(area(rectangle(24, 18, 4)))))


def cut(job, **options):
    part = job.Document.getObject("Part")
    return api.add_spiral_pocket(job, [(part, faces_at(part.Shape, -DEPTH))], **(QUICK | options))


def test_of_ordinary_depths_nothing_is_told(job):
    op = cut(job)
    assert not any(told(op, words) for words in ("below", "above", "walls"))
    assert requests_of(op)[1] == []


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"FinalDepth": -DEPTH - 1}, "1 mm below the selected floor."),
        ({"ZStockToLeave": -0.5}, "0.5 mm below the selected floor."),
        ({"FinalDepth": -30.0}, "below the stock"),
        ({"StockToLeave": -0.25}, "0.25 mm into the walls"),
        ({"StartDepth": -2.0}, "2 mm above the start depth"),
        ({"StartDepth": -3.0, "SafeHeight": -1.5}, "1.5 mm above the height at which rapids go"),
    ],
)
def test_what_is_probably_not_meant_is_told_before_and_after(job, options, words):
    op = cut(job, **options)
    assert told(op, words)
    _, notices, _ = requests_of(op)
    assert any(words in str(notice) for notice in notices)


def test_islands_that_are_milled_away_are_told(doc, job):
    words = "Islands on 28 mm2 of the floor are milled away."
    assert not told(cut(job, UseOutline=True), "Islands")
    shape = block(area(rectangle(44, 38, 4), circle(3, 22, 19)))
    part = add_part(doc, shape, "Other")
    base = [(part, faces_at(shape, -DEPTH))]
    with_island = add_job(doc, part)
    assert not told(api.add_spiral_pocket(with_island, base), "Islands")
    op = api.add_spiral_pocket(with_island, base, **QUICK, UseOutline=True)
    assert told(op, words) and any(words in str(notice) for notice in requests_of(op)[1])


def test_a_spindle_that_stands_is_told(job):
    job.Tools.Group[0].SpindleSpeed = 0
    op = cut(job)
    assert told(op, "The spindle speed of") and "spindle speed" in str(requests_of(op)[1][0])


def test_a_feed_that_the_machine_does_not_reach_is_told(job):
    job.Tools.Group[0].HorizFeed = 200.0
    words = "12000 mm/min is more than the chosen machine does; the program runs at 5000 mm/min"
    op = cut(job, Machine="hobby_router")
    assert told(op, words) and any(words in str(notice) for notice in requests_of(op)[1])
    assert max(c.Parameters.get("F", 0.0) for c in motion(op) if c.Name != "G0") <= 5000 / 60 + 1e-6
    op.Machine = "vmc"
    op.Document.recompute()
    assert not told(op, "mm/min")


def test_a_floor_below_the_stock_is_told_as_such(job):
    job.Stock.ExtZneg = -5.0
    op = cut(job)
    assert told(op, "The selected floor lies") and not told(op, "goes 0 mm")


@pytest.mark.parametrize(
    ("inset", "words"), [(18.0, "of the pocket lie beside the stock, at X"), (80.0, "lies beside")]
)
def test_a_pocket_beside_the_stock_is_told(job, inset, words):
    assert not told(cut(job), "beside the stock")
    job.Stock.ExtXneg, job.Stock.ExtXpos = -inset, inset
    assert told(cut(job), words)


def test_stock_that_an_earlier_operation_takes_is_not_told(job):
    cut(job)
    assert not told(cut(job, StartDepth=-2.0), "above the start depth")


@pytest.mark.parametrize("heights", [{}, {"SafeHeight": 10.0, "ClearanceHeight": 20.0}])
def test_rapids_stay_above_the_safe_height_until_something_was_cut(job, heights):
    op = cut(job, StepDown=2.0, **heights)
    low = False
    for command in motion(op):
        z = command.Parameters.get("Z")
        if command.Name == "G0" and z is not None and not low:
            assert z >= op.SafeHeight.Value - 1e-6
        low = low or (command.Name != "G0" and z is not None and z < -1e-6)
    assert low


def test_a_short_edge_is_told(job):
    job.Tools.Group[0].Tool.CuttingEdgeHeight = 2
    op = cut(job)
    assert told(op, "cutting edge is 2 mm long")
    op.setExpression("StepDown", None)
    op.StepDown = 1.5
    job.Document.recompute()
    assert not told(op, "cutting edge")


@pytest.mark.parametrize("place", ["SpindleDir", "SpindleDirection"])
@pytest.mark.parametrize("direction", ["Forward", "Reverse", "None"])
def test_the_spindle_is_told_as_it_is_posted(job, tmp_path, place, direction):
    controller = job.Tools.Group[0]
    owner = controller if place == "SpindleDir" else controller.Tool
    if not hasattr(owner, place):
        pytest.skip("tools have no spindle direction here")
    setattr(owner, place, direction)
    op = cut(job)
    words = api.export(job, tmp_path / "part.ngc").split()
    assert told(op, "in reverse") == ("M4" in words)
    assert told(op, "does not start the spindle") == (not {"M3", "M4"} & set(words))


def test_a_tool_that_is_shorter_than_the_pocket_is_deep_is_told(job):
    job.Tools.Group[0].Tool.Length = DEPTH - 1
    assert told(cut(job), f"below the top of the stock, the tool is {DEPTH - 1:g} mm long")


def test_a_rest_is_not_told_as_nothing():
    assert "cleared more than 99 % of" in remarks.rest(0.9999).message
    assert "cleared 98 % of" in remarks.rest(0.9874).message


def test_a_part_that_is_not_in_the_job_is_told(doc, job):
    op = cut(job)
    assert not told(op, "is not in the job's model")
    other = add_part(doc, block(area(rectangle(24, 18, 4))), "Other")
    op.Base = [(other, faces_at(other.Shape, -DEPTH))]
    doc.recompute()
    assert told(op, "Other is not in the job's model.") and op.Path.Commands


def of_pockets(*angles):
    """Return the same notice of many pockets, each with its angle and place."""
    return [
        (f"Part, Face{i}", Notice(f"At {{at}} it reaches {angle} degrees.", "Mind that.", (i, 0.0)))
        for i, angle in enumerate(angles)
    ]


def test_what_is_much_the_same_of_many_pockets_is_told_once():
    (told,) = remarks.labelled(of_pockets(101.5, 99.25, 112, 101.5, 98), 5)
    assert told.message == (
        "Part, Face2: At {at} it reaches 112 degrees. Much the same is told of 4 more pockets "
        "(at X0.0 Y0.0, X1.0 Y0.0, X3.0 Y0.0, X4.0 Y0.0)."
    )
    assert told.place == (2, 0.0) and told.hint == "Mind that."


def test_places_of_very_many_pockets_end_somewhere():
    (told,) = remarks.labelled(of_pockets(*range(100, 150)), 50)
    assert told.message.count(" Y0.0") == remarks.MOST_PLACES
    assert told.message.endswith(", ...).")


def test_without_places_there_are_none():
    told = [(f"Part, Face{i}", Notice(f"It lies {i} mm too high.")) for i in range(5)]
    (notice,) = remarks.labelled(told, 5)
    assert notice.message.endswith("told of 4 more pockets.")


def test_what_is_much_the_same_of_a_few_pockets_is_told_of_each():
    told = of_pockets(101, 99, 112)
    told.insert(2, ("Part, Face1", Notice("Something else.")))
    found = [notice.message for notice in remarks.labelled(told, 3)]
    assert found == [
        "Part, Face0: At {at} it reaches 101 degrees.",
        "Part, Face1: At {at} it reaches 99 degrees.",
        "Part, Face1: Something else.",
        "Part, Face2: At {at} it reaches 112 degrees.",
    ]


def test_one_notice_of_all_pockets_has_no_labels():
    told = [(f"Part, Face{i}", Notice("It lies 3 mm too high.")) for i in range(9)]
    assert remarks.labelled(told, 9) == [Notice("It lies 3 mm too high.")]
