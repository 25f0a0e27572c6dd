# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the tests that run inside FreeCAD."""

import FreeCAD
import pytest


@pytest.fixture
def doc():
    """Return an empty document that is closed after the test."""
    document = FreeCAD.newDocument("Test")
    name = document.Name
    yield document
    if name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)
