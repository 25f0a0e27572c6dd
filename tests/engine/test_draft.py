# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drafts: laps in the pocket, found again soon when the walls move a little."""

from dataclasses import replace

import numpy as np
import pytest
import shapely
from shapely import LineString, Point, box

from freecad_spiralpocket.engine.draft import draft, openings, reopened
from freecad_spiralpocket.engine.errors import RequestError
from freecad_spiralpocket.engine.model import CutMode, Cutting, Feeds, Heights, PocketRequest

CLIMB, CONVENTIONAL = CutMode.CLIMB, CutMode.CONVENTIONAL
POCKETS = {
    "square": box(0, 0, 60, 60).buffer(-8).buffer(8),
    "long": box(0, 0, 120, 22).buffer(-8).buffer(8),
    "ring": box(0, 0, 80, 60).buffer(-8).buffer(8) - Point(40, 30).buffer(8),
    "slim": box(0, 0, 60, 14).buffer(-6.9).buffer(6.9),
}


def request(pocket, stock=0.0, mode=CLIMB):
    """Return the request for a pocket."""
    return PocketRequest(
        pocket=pocket,
        tool_diameter=12.0,
        heights=Heights(8.0, 3.0, 0.0, -5.0, 6.0),
        feeds=Feeds(50.0, 12.5, 83.0, 83.0),
        cutting=Cutting(stepover=3.0, stock_to_leave=stock, cut_mode=mode),
    )


@pytest.mark.parametrize("mode", [CLIMB, CONVENTIONAL])
@pytest.mark.parametrize("name", POCKETS)
def test_laps_are_where_the_cutter_fits_and_leave_nothing(name, mode):
    asked = request(POCKETS[name], stock=0.3, mode=mode)
    made = draft(asked)
    room = asked.pocket.buffer(-6.3 + 0.05)
    ways = shapely.MultiLineString([LineString(p) for p in (*made.laps, *made.entries)])
    assert room.contains(ways)
    left = asked.pocket.buffer(-6.3).buffer(6.0) - ways.buffer(6.0)
    assert left.area < 0.02 * asked.pocket.area


@pytest.mark.parametrize("mode", [CLIMB, CONVENTIONAL])
@pytest.mark.parametrize("name", POCKETS)
def test_walls_that_moved_a_little_are_opened_as_before(name, mode):
    before = openings(request(POCKETS[name], mode=mode))
    asked = request(POCKETS[name], stock=0.4, mode=mode)
    again, anew = draft(asked, reopened(before, asked)), draft(asked)
    one, other = (shapely.MultiLineString([LineString(p) for p in d.laps]) for d in (again, anew))
    assert asked.pocket.buffer(-6.4 + 0.05).contains(one)
    assert one.length == pytest.approx(other.length, rel=0.1)
    ends = [np.asarray(d.laps[-1]) for d in (again, anew)]
    assert LineString(ends[0]).hausdorff_distance(LineString(ends[1])) < 0.01


@pytest.mark.parametrize("start", [-5.0, -6.0])
def test_depths_upside_down_are_told_also_where_the_openings_are_known(start):
    asked = request(POCKETS["square"])
    asked_wrongly = replace(asked, heights=replace(asked.heights, start_depth=start))
    with pytest.raises(RequestError, match="upside down"):
        draft(asked_wrongly, openings(asked))


def test_pocket_that_falls_apart_is_not_opened_as_before():
    dumbbell = box(0, 0, 40, 40) | box(30, 13.4, 70, 26.6) | box(60, 0, 100, 40)
    narrow = replace(request(dumbbell), tool_diameter=13.0)
    wide = replace(narrow, cutting=replace(narrow.cutting, stock_to_leave=0.3))
    assert len(openings(narrow)) == 1 and len(openings(wide)) == 2
    assert reopened(openings(narrow), wide) is None
