# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs are computed from what stands in the document when they are written."""

import FreeCAD
import pytest
from sample_parts import QUICK, small_job

from freecad_spiralpocket import api


@pytest.fixture
def op(doc):
    """Return an operation with a path."""
    job, part, face = small_job(doc)
    return api.add_spiral_pocket(job, [(part, [face])], **QUICK)


@pytest.fixture
def job(op):
    """Return its job."""
    return op.Document.getObject("Job")


class Dressup:
    """The proxy of a dressup that leaves a path as it is."""

    def __init__(self, base):
        obj = base.Document.addObject("Path::FeaturePython", "Dressup")
        obj.addProperty("App::PropertyLink", "Base", "Path", "")
        obj.Base, obj.Proxy = base, self

    def execute(self, obj):
        obj.Path = obj.Base.Path


def stretch(part):
    """Make a part twice as long."""
    longer = FreeCAD.Matrix()
    longer.scale(2, 1, 1)
    part.Shape = part.Shape.transformGeometry(longer)


def test_what_was_saved_without_the_addon_is_computed_anew(op, tmp_path):
    file, far = str(tmp_path / "job.FCStd"), op.Path.BoundBox.XMax
    op.Proxy = None  # as FreeCAD has it then
    op.Document.saveAs(file)
    FreeCAD.closeDocument(op.Document.Name)
    document = FreeCAD.openDocument(file)
    try:
        stretch(document.getObject("Part"))
        again = document.getObject("SpiralPocket")
        assert again.Proxy is None
        api.export(document.getObject("Job"), tmp_path / "part.ngc")
        assert again.Path.BoundBox.XMax > 1.5 * far
    finally:
        FreeCAD.closeDocument(document.Name)


@pytest.mark.parametrize("is_dressed", [False, True])
def test_stock_that_has_changed_counts(op, job, tmp_path, is_dressed):
    if is_dressed:
        Dressup(op)
        job.Operations.Group = [op.Document.getObject("Dressup")]
        op.Document.recompute()
    job.Stock.ExtZpos = 15
    op.Document.recompute()
    api.export(job, tmp_path / "part.ngc")
    assert op.Path.Commands[1].Parameters["Z"] > job.Stock.Shape.BoundBox.ZMax


def test_what_is_as_it_was_keeps_its_plan(op, job, tmp_path):
    (plan,) = op.Proxy.plans
    api.export(job, tmp_path / "part.ngc")
    assert op.Proxy.plans[0] is plan


def test_a_post_that_writes_to_its_file_leaves_none_behind(job, tmp_path, monkeypatch):
    (tmp_path / "filing_post.py").write_text(
        "def export(objects, name, args):\n"
        "    with open(name, 'w', encoding='utf-8') as file:\n"
        "        file.write('G21\\nG90\\n(Größe)\\nM2\\n')\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    folder = tmp_path / "working"
    folder.mkdir()
    monkeypatch.chdir(folder)
    assert api.export(job, "part.nc", "filing") == "G21\nG90\n(Größe)\nM2\n"
    assert [file.name for file in folder.iterdir()] == ["part.nc"]
