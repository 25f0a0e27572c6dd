# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sample rib is what its script builds, and the demo machines it."""

import importlib.util
from pathlib import Path

import Part
import pytest
from sample_parts import add_part

from freecad_spiralpocket.op import geometry, selection

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
POCKETS = 9


def module(name):
    """Return a script of examples/ as a module."""
    spec = importlib.util.spec_from_file_location(f"example_{name}", EXAMPLES / f"{name}.py")
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


@pytest.fixture(scope="module")
def shipped():
    """Return the shipped rib."""
    return Part.read(str(EXAMPLES / "rib.step"))


def test_the_shipped_rib_is_the_one_that_the_script_builds(shipped):
    built = module("rib").build()
    assert shipped.isValid() and len(shipped.Solids) == 1
    assert len(shipped.Faces) == len(built.Faces)
    assert shipped.Volume == pytest.approx(built.Volume, rel=1e-6)


def test_the_rib_has_nine_rounded_pockets(doc, shipped):
    rib = module("rib")
    floors = list(selection.find_floors(add_part(doc, shipped)))
    assert len(floors) == POCKETS
    sides = sorted(sum(e.Curve.TypeId == "Part::GeomLine" for e in f.face.Edges) for f in floors)
    assert sides == [3, 3, 4, 4, 4, 4, 4, 4, 4]
    for floor in floors:
        arcs = [e.Curve.Radius for e in floor.face.Edges if e.Curve.TypeId == "Part::GeomCircle"]
        assert arcs == pytest.approx([rib.CORNER_RADIUS] * len(arcs))
        assert len(arcs) in (3, 4)
        assert floor.z == pytest.approx(rib.FLOOR) and not floor.open_edges
        assert geometry.polygon(floor, 0.002).area == pytest.approx(floor.face.Area, rel=1e-4)


def test_the_demo_writes_what_it_names(out_dir, capsys):
    import FreeCAD

    before = set(FreeCAD.listDocuments())
    folder = out_dir / "demo"
    module("demo").main(folder)
    for name in set(FreeCAD.listDocuments()) - before:
        FreeCAD.closeDocument(name)
    named = [line.split()[-1] for line in capsys.readouterr().out.splitlines() if "wrote" in line]
    assert {Path(n).suffix for n in named} == {".FCStd", ".png", ".ngc", ".gcode"}
    assert all(Path(n).stat().st_size > 10_000 for n in named)
