# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program reader: motion, units, modes, arcs, and what it refuses."""

from __future__ import annotations

import math

import numpy as np
import pytest

from freecad_spiralpocket.engine.errors import RequestError
from freecad_spiralpocket.engine.toolpath import Kind, Role
from freecad_spiralpocket.gcode import parse_program


def test_modal_words_comments_and_line_numbers():
    path = parse_program("%\nN10 G21 G90 (metric)\nG0 X1 Y2 Z5\nZ1 ; down\nG1 Z-2 F600\nX4\n")
    np.testing.assert_allclose(path.start, [1, 2, 5])
    np.testing.assert_allclose(path.points, [[1, 2, 1], [1, 2, -2], [4, 2, -2]])
    assert list(path.kinds) == [Kind.RAPID, Kind.LINE, Kind.LINE]
    assert list(path.roles) == [Role.AIR, Role.ENTRY, Role.CUT]
    assert path.feeds[2] == pytest.approx(10.0)


def test_inches_and_increments():
    path = parse_program("G20 G91\nG0 X1\nG1 X1 F10\nG1 Y-1")
    np.testing.assert_allclose(path.points, [[50.8, 0, 0], [50.8, -25.4, 0]])
    assert path.feeds[0] == pytest.approx(254 / 60)


def test_full_circle_becomes_two_halves():
    path = parse_program("G0 X10 Y0 Z0\nG3 X10 Y0 I-10 J0 F100")
    assert path.lengths.sum() == pytest.approx(20 * math.pi)
    assert len(path) == 2
    np.testing.assert_allclose(path.points[0], [-10, 0, 0], atol=1e-12)


@pytest.mark.parametrize("words", ["J5", "I0 J5", "I5", "X0 Y0 I3 J4"])
def test_full_circle_needs_no_end_and_no_word_that_is_0(words):
    path = parse_program(f"G0 X0 Y0 Z0\nG2 {words} F100")
    assert path.lengths.sum() == pytest.approx(10 * math.pi)
    np.testing.assert_allclose(path.points[-1], [0, 0, 0], atol=1e-12)


def test_long_helical_arc_keeps_its_slope():
    path = parse_program("G0 X10 Y0 Z0\nG2 X0 Y10 Z-3 I-10 J0 F100")
    assert np.all(path.kinds == Kind.ARC_CW)
    np.testing.assert_allclose(path.sweeps, -3 * math.pi / 4)
    np.testing.assert_allclose(path.points[:, 2], [-1.5, -3])


@pytest.mark.parametrize(("radius", "turn"), [(5.0, 0.5), (-5.0, 1.5)])
def test_radius_word_takes_the_short_or_the_long_way(radius, turn):
    path = parse_program(f"G0 X5 Y0 Z0\nG3 X0 Y5 R{radius} F100")
    assert abs(path.sweeps).sum() == pytest.approx(turn * math.pi)


@pytest.mark.parametrize("unit", ["G21", "G20"])
def test_radius_word_may_be_short_by_its_rounding_only(unit):
    mm = 1.0 if unit == "G21" else 25.4
    words = f"{unit} G0 X0 Y0 Z0\nG2 X{10 / mm:.9f} F100 R"
    path = parse_program(f"{words}{4.997 / mm:.9f}")
    np.testing.assert_allclose(path.centers, [[5, 0]], atol=1e-6)
    for radius in (4.98, 2.0, -4.98):
        with pytest.raises(RequestError, match="Line 2.* does not reach its end"):
            parse_program(f"{words}{radius / mm:.9f}")


@pytest.mark.parametrize("dwell", ["G4 X2", "G04 X2.", "G4 P2", "G4 P2000"])
def test_dwelling_moves_nothing(dwell):
    path = parse_program(f"G0 X0 Y0 Z0\nG1 X1 F100\n{dwell}\nY3")
    assert path.points.tolist() == [[1, 0, 0], [1, 3, 0]]


def test_ways_in_the_machines_coordinates_are_left_out():
    path = parse_program("G0 X5 Y5 Z9\nG1 Z1 F100\nG53 G0 Z0\nG28 G91 X0 Y0\nG90 G0 Z9")
    assert path.points.tolist() == [[5, 5, 1], [5, 5, 9]]


def test_absolute_centers():
    path = parse_program("G90.1\nG0 X15 Y0 Z0\nG3 X10 Y5 I10 J0 F100")
    np.testing.assert_allclose(path.centers, [[10, 0]])


@pytest.mark.parametrize(
    ("program", "message"),
    [
        ("G0 X1\nG81 Z-1 R1 F100", "Line 2.*G81"),
        ("G0 X1\nG1 X2", "Line 2.*feed"),
        ("G18\nG0 X1", "Line 1.*G18"),
        ("M3 S1000", "no motion"),
        ("G0 X1\nG1 X#1 F100", "Line 2.*#1"),
        ("G0 X1\nG1 X[1+2] Y3 F100", r"Line 2.*\["),
        ("G0 X1\nM98 P100", "Line 2.*subprograms"),
    ],
)
def test_what_is_not_understood_is_refused(program, message):
    with pytest.raises(RequestError, match=message):
        parse_program(program)
