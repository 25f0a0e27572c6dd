# SPDX-License-Identifier: LGPL-2.1-or-later
"""Posted programs do what the part allows, says LinuxCNC's own interpreter.

The FreeCAD tests leave programs in ``$SPIRALPOCKET_OUT/programs``, each with the
true outlines and heights of the part. `rs274` of linuxcnc-uspace turns a program
into canonical motion, which is checked here against the part alone.
"""

import json
import math
import os
import re
import subprocess
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import shapely
from shapely import LineString, Point, Polygon, box

FOLDER = Path(os.environ.get("SPIRALPOCKET_OUT", "nowhere"), "programs")
PROGRAMS = sorted(FOLDER.glob("*.ngc"))
pytestmark = pytest.mark.skipif(
    "SPIRALPOCKET_OUT" not in os.environ, reason="programs come from the FreeCAD tests: ./dev test"
)

ROUNDED = 2e-4  # mm, of the posted words
GOUGE = 0.01  # mm, that the cutter may pass the wall
ARC_CHORD = np.radians(2)
CANON = re.compile(r"^\s*\d+\s+N\S*\s+(\w+)\((.*)\)\s*$")
#: A machine with one tool; its diameter does not matter without compensation.
TOOL_TABLE = "".join(f"T{n} P{n} D6 Z0 ;\n" for n in range(1, 5))


@dataclass(frozen=True)
class Move:
    """One canonical move: points of shape (n, 3) from its start to its end."""

    rapid: bool
    points: np.ndarray


@dataclass(frozen=True)
class Program:
    """A program as LinuxCNC runs it, and the part it is for."""

    moves: tuple
    part: dict

    @property
    def region(self):
        """Return where the cutter may be below the top, shrunk by its radius."""
        pockets = [Polygon(w[0], w[1:]) for w in (p["wires"] for p in self.part["pockets"])]
        return shapely.unary_union([p.buffer(GOUGE - self.part["radius"]) for p in pockets])


@cache
def interpret(path):
    """Return the canonical commands of a program as (name, numbers)."""
    folder = path.parent
    table, variables = folder / "tools.tbl", folder / "variables.var"
    table.write_text(TOOL_TABLE)
    variables.touch()
    command = ["rs274", "-g", "-t", str(table), "-v", str(variables), str(path)]
    for _ in range(3):  # on a busy machine the interpreter now and then stops early
        done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
        if "PROGRAM_END" in done.stdout:
            break
    lines = [CANON.match(line) for line in done.stdout.splitlines()]
    names = [m.group(1) for m in lines if m]
    assert "PROGRAM_END" in names, f"{done.stdout[-500:]}\n{done.stderr}"
    assert done.returncode == 0, done.stderr
    return [(m.group(1), m.group(2)) for m in lines if m]


@cache
def load(path):
    """Return a program with its moves and its part."""
    moves, here = [], None
    for name, text in interpret(path):
        if name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            there = np.array([float(v) for v in text.split(",")[:3]])
            if here is not None:
                moves.append(Move(name == "STRAIGHT_TRAVERSE", np.array([here, there])))
            here = there
        elif name == "ARC_FEED":
            x, y, cx, cy, turns, z = (float(v) for v in text.split(",")[:6])
            points = arc(here, np.array([x, y, z]), np.array([cx, cy]), int(turns))
            moves.append(Move(False, points))
            here = points[-1]
    return Program(tuple(moves), json.loads(path.with_suffix(".json").read_text()))


def arc(start, end, center, turns):
    """Return points along a helix with the given full turns, positive counter-clockwise."""
    a, b = (math.atan2(*(p[:2] - center)[::-1]) for p in (start, end))
    sweep = (b - a) % math.tau if turns > 0 else -((a - b) % math.tau)
    sweep = sweep or math.copysign(math.tau, turns)
    t = np.linspace(0, 1, max(2, math.ceil(abs(sweep) / ARC_CHORD)) + 1)[:, None]
    radius = np.linalg.norm(start[:2] - center)
    angles = a + t * sweep
    xy = center + radius * np.hstack([np.cos(angles), np.sin(angles)])
    return np.hstack([xy, start[2] + t * (end[2] - start[2])])


def is_near(points, bounds, distance):
    """Return whether points are within `distance` of a box in the plane."""
    low, high = points[:, :2].min(axis=0) - distance, points[:, :2].max(axis=0) + distance
    return bool(np.all(low <= bounds[2:]) and np.all(high >= bounds[:2]))


@pytest.fixture(params=PROGRAMS, ids=lambda path: path.stem)
def program(request):
    """Return one posted program."""
    return load(request.param)


def test_there_are_programs():
    assert len(PROGRAMS) >= 9


def test_it_cuts_to_the_floor_and_never_below(program):
    floors = [p["floor"] for p in program.part["pockets"]]
    lowest = min(m.points[:, 2].min() for m in program.moves)
    assert lowest == pytest.approx(min(floors), abs=ROUNDED)


def test_each_pocket_is_cut_to_its_own_floor(program):
    for pocket in program.part["pockets"]:
        outline = Polygon(pocket["wires"][0])
        shapely.prepare(outline)
        inside = [
            m.points[:, 2].min() for m in program.moves if outline.contains(Point(m.points[-1]))
        ]
        assert min(inside) == pytest.approx(pocket["floor"], abs=ROUNDED)


def test_the_cutter_stays_off_the_walls(program):
    region = program.region
    shapely.prepare(region)
    low = [m.points for m in program.moves if m.points[:, 2].min() < program.part["top"] - ROUNDED]
    assert low
    outside = [p for p in low if not region.covers(LineString(p))]
    assert not outside, f"{len(outside)} moves leave the pocket, the first at {outside[0][0]}"


def test_rapids_touch_no_stock(program):
    top, cutter = program.part["top"], program.part["cutter"]
    cut = []
    for move in program.moves:
        if not move.rapid:
            cut.append(move.points)
        elif (height := move.points[:, 2].min()) < top - ROUNDED:
            swept = LineString(move.points[:, :2]).buffer(cutter - GOUGE)
            low = [p for p in cut if p[:, 2].max() <= height + ROUNDED]
            near = [LineString(p) for p in low if is_near(p, swept.bounds, cutter)]
            air = box(*swept.bounds).buffer(1.0).difference(box(*program.part["stock"]))
            free = shapely.unary_union([air, *(line.buffer(cutter) for line in near)])
            assert free.covers(swept), f"rapid at {move.points[0]} runs into stock"


def test_it_begins_and_ends_at_clearance(program):
    clearance = program.part["clearance"]
    assert program.moves[0].points[-1, 2] == pytest.approx(clearance, abs=ROUNDED)
    assert program.moves[-1].points[-1, 2] == pytest.approx(clearance, abs=ROUNDED)
    level = [m for m in program.moves if m.rapid and np.ptp(m.points[:, 2]) < ROUNDED]
    across = [m for m in level if np.linalg.norm(m.points[0] - m.points[-1]) > ROUNDED]
    assert all(m.points[0, 2] <= clearance + ROUNDED for m in across)


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_it_uses_plain_words_only(path):
    code = re.sub(r"\([^)]*\)", "", path.read_text(encoding="utf-8"))
    motions = set(re.findall(r"\bG0?[0-3]\b", code))
    assert motions <= {"G0", "G1", "G2", "G3"}
    assert not re.search(r"-0\.0+\b|\bR-?[\d.]|nan|inf|e-\d", code)
