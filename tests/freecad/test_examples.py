# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sample rib is what its script builds, and the demo machines it."""

import importlib.util
from pathlib import Path

import FreeCAD
import Part
import pytest
from sample_parts import add_part
from sample_programs import write

from freecad_spiralpocket.op import geometry
from freecad_spiralpocket.op.floors import find_floors

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
    floors = list(find_floors(add_part(doc, shipped)))
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
    op = module("demo").main(out_dir / "demo")
    try:
        named = [w.split()[-1] for w in capsys.readouterr().out.splitlines() if "wrote" in w]
        assert {Path(n).suffix for n in named} == {".FCStd", ".png", ".ngc", ".gcode"}
        assert all(Path(n).stat().st_size > 10_000 for n in named)
        assert len(op.Proxy.plans) == POCKETS and not op.Proxy.errors
        ((model, names),) = op.Base
        floors = [model.Shape.getElement(name) for name in names]
        write(out_dir / "programs", "rib", op, [(f, f.BoundBox.ZMin) for f in floors])
    finally:
        FreeCAD.closeDocument(op.Document.Name)
