# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the tests that run inside FreeCAD."""

import FreeCAD
import pytest
from sample_parts import add_job, add_part, area, block, rectangle


@pytest.fixture
def doc():
    """Return an empty document that is closed after the test."""
    document = FreeCAD.newDocument("Test")
    name = document.Name
    yield document
    if name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


@pytest.fixture
def job(doc):
    """Return a job for a block with one pocket, without operations."""
    return add_job(doc, add_part(doc, block(area(rectangle(20, 20, 4)))))
