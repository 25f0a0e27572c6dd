# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the tests that run inside FreeCAD."""

import FreeCAD
import pytest


@pytest.fixture
def doc():
    """Return an empty document that is closed after the test."""
    document = FreeCAD.newDocument("Test")
    yield document
    if document.Name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(document.Name)


@pytest.fixture(scope="module")
def module_doc():
    """Return an empty document that is shared by the tests of a module, which only read it."""
    document = FreeCAD.newDocument("Shared")
    yield document
    FreeCAD.closeDocument(document.Name)
