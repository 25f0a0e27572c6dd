# SPDX-License-Identifier: LGPL-2.1-or-later
"""No name of a widget outlives it, and what others leave behind does no harm."""

from types import SimpleNamespace

import FreeCADGui
import pytest
from PySide import QtCore, QtGui
from window import IS_LEGACY, VERSION

from freecad_spiralpocket.gui.panel.operation_page import FORM
from freecad_spiralpocket.gui.qt import names
from freecad_spiralpocket.gui.qt.names import shiboken

TRIES = 200


def delete(widget):
    """Let Qt delete a widget, as it does with a panel that closes."""
    widget.deleteLater()
    QtCore.QCoreApplication.sendPostedEvents(widget, QtCore.QEvent.DeferredDelete)


def test_loaded_form_has_a_name_that_ends_with_it():
    form = names.load_form(FORM)
    assert form.objectName() == "SpiralPocketPanel"
    assert form.strategy.parent() is form.optionsFrame
    every = [form, *vars(form).values()]
    assert all(map(shiboken.isValid, every))
    delete(form)
    assert not any(map(shiboken.isValid, every))


@pytest.mark.parametrize("what", ["form", "startPointX"])
@pytest.mark.parametrize(
    ("kind", "offset"), [(QtGui.QWidget, 0), (QtGui.QWidget, 16), (QtGui.QTableWidgetItem, 0)]
)
def test_name_that_others_left_is_not_taken_for_a_new_widget(monkeypatch, what, kind, offset):
    """FreeCAD's loader hands on what PySide finds at the address, or 16 bytes before it."""
    load = FreeCADGui.PySideUic.loadUi
    known = load(str(FORM))
    every = {**vars(known), "form": known}
    widgets = {key: (shiboken.getCppPointer(w)[0], type(w)) for key, w in every.items()}
    for name in {id(w): w for w in every.values()}.values():
        shiboken.invalidate(name)
    stale = shiboken.wrapInstance(widgets[what][0] - offset, kind)
    loads = []

    def known_once(path):
        loads.append(path)
        if len(loads) > 1:
            return load(path)
        form = shiboken.wrapInstance(*widgets.pop("form"))
        for key, widget in widgets.items():
            setattr(form, key, shiboken.wrapInstance(*widget))
        return form

    monkeypatch.setattr(names.FreeCADGui, "PySideUic", SimpleNamespace(loadUi=known_once))
    form = names.load_form(FORM)
    assert not shiboken.isValid(stale) or kind is QtGui.QTableWidgetItem
    assert form.objectName() == "SpiralPocketPanel"
    assert isinstance(form.strategy, QtGui.QComboBox)
    assert isinstance(form.startPointX, QtGui.QAbstractSpinBox)
    assert form.startPointX.objectName() == "startPointX"
    delete(form)


def test_widget_that_python_made_keeps_its_name():
    label = QtGui.QLabel("x")
    assert names.renamed(label) is label and shiboken.isValid(label)


@pytest.mark.skipif(
    IS_LEGACY or VERSION == "1.0", reason="this PySide keeps but one name of an address"
)
def test_name_of_what_was_just_before_a_new_widget_is_forgotten():
    """Its second address, the painting device's, is the widget's first; else FreeCAD aborts."""
    parent = QtGui.QWidget()
    label = QtGui.QLabel("x", parent)
    stale = shiboken.wrapInstance(shiboken.getCppPointer(label)[0] - 16, QtGui.QLabel)
    assert shiboken.isValid(stale) and stale is not label
    names.forget_namesakes()
    assert shiboken.isValid(label) and not shiboken.isValid(stale)
    delete(parent)
    assert not shiboken.isValid(label)


@pytest.mark.skipif(
    IS_LEGACY or VERSION == "1.0", reason="this PySide keeps but one name of an address"
)
def test_name_that_others_left_is_forgotten_where_a_new_widget_is():
    """Else FreeCAD aborts when the widget goes."""
    parent, left = QtGui.QWidget(), {}
    for _ in range(TRIES):
        label = QtGui.QLabel("x")
        address = shiboken.getCppPointer(label)[0]
        if address in left:
            break
        label = None
        # as FreeCAD names a widget that has gone
        left[address] = shiboken.wrapInstance(address, QtGui.QWidget)
    stale = left.pop(address)
    label.setParent(parent)
    assert shiboken.isValid(stale) and stale is not label
    names.forget_namesakes()
    assert shiboken.isValid(label) and not shiboken.isValid(stale)
    for name in left.values():
        shiboken.invalidate(name)
    delete(parent)
    assert not shiboken.isValid(label)
