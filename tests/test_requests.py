# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every field of a request is minded where its fields are taken one by one.

A new field fails here until it has another value to be told by in `OTHERS`, and is minded by
each of these modules or named among what need not be.
"""

import sys
from dataclasses import fields, replace
from pathlib import Path

import pytest
from shapely import Point, box

sys.path.insert(0, str(Path(__file__).parent / "engine"))
from shapes import FEEDS, HEIGHTS, request

from freecad_spiralpocket import machines
from freecad_spiralpocket.beside.tasks import Tasks
from freecad_spiralpocket.engine import draft
from freecad_spiralpocket.engine.copies import displacement
from freecad_spiralpocket.engine.mirroring import mirrored_request
from freecad_spiralpocket.engine.model import (
    CutMode,
    Cutting,
    Entry,
    FeedMode,
    FeedPlan,
    PocketRequest,
    Section,
    Strategy,
)
from freecad_spiralpocket.engine.sizes import resized_request

#: No shape here is its own mirror image.
POCKET = box(0, 0, 40, 30).difference(box(20, 20, 41, 31))
WIDER = POCKET.union(box(-2, 0, 1, 12))
LEFT, BESIDE = box(3, 3, 18, 25), box(0, 0, 2, 7)
LEVEL = Section(-2.0, WIDER, WIDER.union(box(-3, 0, 0, 9)), LEFT)
REQUEST = request(
    POCKET,
    entry=Entry(max_diameter=4.0, slot_bite=1.0),
    feed_plan=FeedPlan(link_feed=70.0),
    machine=machines.load("vmc"),
    start_point=(9.0, 8.0),
    stock=LEFT,
    beyond=BESIDE,
    sections=(LEVEL, Section(HEIGHTS.final_depth, POCKET)),
)
#: For each field another value.
OTHERS = {
    "pocket": POCKET.difference(Point(9, 8).buffer(2)),
    "tool_diameter": 5.0,
    "heights": replace(HEIGHTS, final_depth=-4.0),
    "feeds": replace(FEEDS, vertical=10.0),
    "cutting": Cutting(stepover=2.4, cut_mode=CutMode.CONVENTIONAL),
    "entry": Entry(max_diameter=3.0),
    "strategy": Strategy.ISOTHERM,
    "tolerance": 0.02,
    "feed_plan": FeedPlan(FeedMode.CHIP_THICKNESS),
    "machine": machines.load("hobby_router"),
    "start_point": (10.0, 8.0),
    "stock": box(3, 3, 17, 25),
    "beyond": box(0, 0, 2, 6),
    "sections": (Section(HEIGHTS.final_depth, POCKET),),
}
OTHERS_OF_A_LEVEL = {
    "z": -1.5,
    "pocket": POCKET.union(box(-1, 0, 1, 12)),
    "mouth": None,
    "stock": box(3, 3, 17, 25),
}
CHANGES = [(False, name) for name in OTHERS] + [(True, name) for name in OTHERS_OF_A_LEVEL]

#: What is no place, so the same in the mirror.
SAME_IN_THE_MIRROR = {
    *("tool_diameter", "heights", "feeds", "cutting", "entry", "strategy", "tolerance"),
    *("feed_plan", "machine"),
}
#: What has no length in it.
OF_NO_SIZE = {"strategy"}
#: What a draft does not ask for: it does with the opening that it has.
NO_MATTER_HOW_OPENED = {
    *("heights", "feeds", "strategy", "tolerance", "feed_plan", "machine", "sections"),
}


def changed(record, other):
    """Return the fields in which two records differ."""
    names = [field.name for field in fields(record)]
    return {name for name in names if getattr(record, name) != getattr(other, name)}


def with_another(is_of_level, name):
    """Return the request with another value of a field of it, or of its first level's."""
    if not is_of_level:
        return replace(REQUEST, **{name: OTHERS[name]})
    level = replace(LEVEL, **{name: OTHERS_OF_A_LEVEL[name]})
    return replace(REQUEST, sections=(level, *REQUEST.sections[1:]))


def test_every_field_has_another_value():
    assert list(OTHERS) == [field.name for field in fields(PocketRequest)]
    assert list(OTHERS_OF_A_LEVEL) == [field.name for field in fields(Section)]
    assert all(with_another(*change) != REQUEST for change in CHANGES)


def test_places_are_turned_over_in_the_mirror():
    other = mirrored_request(REQUEST)
    assert changed(REQUEST, other) == set(OTHERS) - SAME_IN_THE_MIRROR
    assert changed(LEVEL, other.sections[0]) == set(OTHERS_OF_A_LEVEL) - {"z"}


def test_lengths_are_resized():
    other = resized_request(REQUEST, 2.0)
    assert changed(REQUEST, other) == set(OTHERS) - OF_NO_SIZE
    assert changed(LEVEL, other.sections[0]) == set(OTHERS_OF_A_LEVEL)


@pytest.mark.parametrize(("is_of_level", "name"), CHANGES)
def test_copies_differ_in_nothing(is_of_level, name):
    assert displacement(REQUEST, REQUEST) is not None
    assert displacement(REQUEST, with_another(is_of_level, name)) is None


@pytest.mark.parametrize(("is_of_level", "name"), CHANGES)
def test_drafts_open_a_pocket_anew_where_that_matters(is_of_level, name, monkeypatch):
    asked = []
    monkeypatch.setattr(draft, "openings", lambda request: asked.append(request) or [])
    monkeypatch.setattr(draft, "draft", lambda request, opened: None)
    tasks, other = Tasks(), with_another(is_of_level, name)
    for each in (REQUEST, REQUEST, other):
        tasks.draft(each, None)
    is_kept = is_of_level or name in NO_MATTER_HOW_OPENED
    assert asked == ([REQUEST] if is_kept else [REQUEST, other])
