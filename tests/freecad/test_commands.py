# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths become commands that every post, dressup and simulator understands."""

import importlib
import math
from itertools import pairwise

import numpy as np
import pytest

from freecad_spiralpocket.engine.toolpath import Role, ToolpathBuilder
from freecad_spiralpocket.op import commands

FEED, RAPID = 20.0, 80.0


def built(*moves):
    """Return the commands of a path from (0, 0, 5): moves are (method, arguments)."""
    builder = ToolpathBuilder((0.0, 0.0, 5.0))
    for method, *arguments in moves:
        getattr(builder, method)(*arguments)
    return commands.from_toolpath(builder.build())


def test_first_motion_rises_to_clearance_then_goes_over():
    first = built(("rapid", RAPID, 1, 2, 5))[:2]
    assert [(c.Name, c.Parameters) for c in first] == [
        ("G0", {"Z": 5}),
        ("G0", {"X": 0, "Y": 0, "Z": 5}),
    ]


def test_moves_carry_all_coordinates_and_feeds_in_mm_per_second():
    made = built(("rapid", RAPID, 1, 2), ("line", (1, 2, -1), FEED, Role.ENTRY))[2:]
    assert made[0].Parameters == {"X": 1, "Y": 2, "Z": 5}
    assert made[1].Parameters == {"X": 1, "Y": 2, "Z": -1, "F": FEED}


def test_feeds_can_be_left_out():
    builder = ToolpathBuilder((0, 0, 0))
    builder.line((1, 0, 0), FEED, Role.CUT)
    made = commands.from_toolpath(builder.build(), with_feeds=False)
    assert not any("F" in c.Parameters for c in made)


@pytest.mark.parametrize(("ccw", "name"), [(True, "G3"), (False, "G2")])
def test_arcs_are_given_by_their_center_from_the_rounded_start(ccw, name):
    start = (1 / 3, 0.0, 5.0)
    made = built(
        ("line", start, FEED, Role.CUT), ("arc", (2 / 3, 1, 4), (0.5, 0.5), ccw, FEED, Role.CUT)
    )[-1]
    assert made.Name == name
    x, y = round(1 / 3, commands.DECIMALS) + made.Parameters["I"], made.Parameters["J"]
    assert (x, y) == pytest.approx((0.5, 0.5), abs=1e-9)


def test_moves_that_vanish_when_posted_are_left_out():
    made = built(
        ("line", (1, 0, 5), FEED, Role.CUT),
        ("line", (1.0003, 0, 5), FEED, Role.CUT),
        ("arc", (1.0004, 0.0002, 5), (1.0002, 0.1), True, FEED, Role.CUT),
        ("line", (2, 0, 5), FEED, Role.CUT),
    )
    assert [c.x for c in made if c.Name == "G1"] == [1, 2]
    assert not [c for c in made if c.Name in ("G2", "G3")]


def test_an_arc_of_which_only_the_height_is_left_becomes_a_line():
    made = built(("arc", (0.0002, 0.0002, 4), (0.0001, 0.0), True, FEED, Role.ENTRY))[-1]
    assert made.Name == "G1" and made.z == 4


@pytest.mark.parametrize(("unit", "decimals"), [(1, 3), (1, 4), (1, 5), (25.4, 3), (25.4, 4)])
def test_no_arc_ends_where_it_begins_in_any_post(unit, decimals):
    """A controller would go once all the way round."""
    random = np.random.default_rng(decimals)
    for _ in range(400):
        chord, radius = 10 ** random.uniform(-7, -0.5), 10 ** random.uniform(-0.5, 2)
        turn, place = random.uniform(0, 2 * np.pi), random.uniform(-50, 50, 2)
        if random.random() < 0.5:  # just where one rounds up and one down
            place = unit * (np.round(place / unit, 3) + 0.5e-3)
        angles = turn + np.array([0, 2 * np.arcsin(min(1, chord / 2 / radius))])
        center = place - radius * np.array([np.cos(turn), np.sin(turn)])
        begin, end = center + radius * np.column_stack([np.cos(angles), np.sin(angles)])
        made = built(
            ("line", (*begin, 5), FEED, Role.CUT), ("arc", (*end, 5), center, True, FEED, Role.CUT)
        )
        last, before = made[-1], made[-2]
        if last.Name == "G3":
            ends = np.array([[before.x, before.y], [last.x, last.y]]) / unit
            assert np.ptp(np.round(ends, decimals), axis=0).any()
        # what is a line instead is one but for a thousandth of a millimeter
        elif chord > 0.05:
            assert last.Name == "G3"


def geom():
    """Return FreeCAD's own geometry of commands, by which its dressups go."""
    try:
        return importlib.import_module("Path.Geom")
    except ImportError:  # before 1.0
        return importlib.import_module("PathScripts.PathGeom")


@pytest.mark.parametrize("ccw", [True, False])
@pytest.mark.parametrize("radius", [0.01, 0.03, 0.06, 0.1, 0.3, 2.0])
def test_dressups_see_every_arc_as_it_is(radius, ccw):
    for turn in np.radians([1, 5, 20, 45, 90, 130, 160, 175, 179, 179.9, 180]):
        sign = 1 if ccw else -1
        angles = 0.3 + np.array([0.0, sign * turn])
        (x, y), end = radius * np.column_stack([np.cos(angles), np.sin(angles)])
        start = ("line", (x, y, 5), FEED, Role.CUT)
        made = built(start, ("arc", (*end, 5), (0.0, 0.0), ccw, FEED, Role.CUT))
        length = 0.0
        for before, command in pairwise(made[2:]):
            edge = geom().edgeForCmd(command, before.Placement.Base)
            length += edge.Length if edge else 0.0
        assert length == pytest.approx(radius * turn, rel=0.004, abs=0.005), np.degrees(turn)


@pytest.mark.parametrize(("radius", "turn"), [(0.06, 90), (0.01, 170), (0.1, 30), (0.15, 14)])
def test_lines_instead_of_an_arc_keep_to_it_and_turn_softly(radius, turn):
    place = radius * math.cos(math.radians(turn)), radius * math.sin(math.radians(turn))
    start, arc = (radius, 0, 5), ((*place, 5), (0, 0), True, FEED, Role.CUT)
    made = built(("line", start, FEED, Role.CUT), ("arc", *arc))[3:]
    ends = np.array([start[:2], *((c.x, c.y) for c in made)])
    assert {c.Name for c in made} == {"G1"} and ends[-1] == pytest.approx(place)
    assert np.hypot(*ends.T) == pytest.approx(radius, abs=1e-6)
    middles = (ends[1:] + ends[:-1]) / 2
    assert np.hypot(*middles.T) == pytest.approx(radius, abs=3.1e-4)
    ways = np.degrees(np.unwrap(np.arctan2(*np.diff(ends, axis=0).T[::-1])))
    assert np.abs(np.diff(ways)).max() < 16


def test_nothing_is_a_negative_zero():
    made = built(("line", (-1e-9, -1e-9, 1), FEED, Role.CUT))[-1]
    assert not any(np.signbit(v) for v in made.Parameters.values())


def test_comments_hold_no_parentheses_and_only_ascii():
    text = commands.comment("Tasche (für\nden Test); 3 ° weit").toGCode()
    assert text == "(Tasche [f?r den Test], 3 ? weit)"


def test_joined_pockets_repeat_no_rapid_and_end_without_the_lift():
    one = built(("line", (1, 0, -1), FEED, Role.CUT), ("rapid", RAPID, None, None, 5))
    two = commands.join([one, one])
    assert [c.Name for c in two].count("G1") == 2
    pairs = list(pairwise(two))
    assert not any(a.Parameters == b.Parameters for a, b in pairs)
    assert commands.without_last_lift(two)[-1].Name == "G1"
