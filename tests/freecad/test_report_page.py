# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report page of an operation in a document."""

import json

import FreeCAD
import pytest

from freecad_spiralpocket import cli, report

pytest.importorskip("matplotlib", reason="matplotlib is not installed")

POCKET = {"outer": [[0, 0], [24, 0], [24, 18], [0, 18]], "holes": [], "tool": 6.0, "ae": 1.5}


@pytest.fixture
def document(tmp_path):
    """Return a saved document with a job and an operation."""
    outline = tmp_path / "pocket.json"
    outline.write_text(json.dumps(POCKET))
    path = tmp_path / "job.FCStd"
    arguments = [outline, "--set", "Strategy=Linear Morph", "--spindle", "9000", "--fcstd", path]
    cli.run(cli.parser().parse_args([str(a) for a in arguments]))
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    return path


def test_document_tells_tool_depth_and_step_over(document, capsys):
    assert report.main([str(document)]) == 0
    printed = capsys.readouterr().out
    # 25 % of 6 mm: a straight cut is engaged by 60 degrees
    assert "Engagement limit                         60.0 deg" in printed
    assert "data:image/png" in document.with_suffix(".html").read_text()
    assert not FreeCAD.listDocuments()


def test_unknown_operation_is_told(document, capsys):
    assert report.main([str(document), "--operation", "Drilling"]) == 1
    assert "--operation" in capsys.readouterr().err
