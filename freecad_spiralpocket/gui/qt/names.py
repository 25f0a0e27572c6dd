# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python's names for Qt's objects, so that no name outlives what it names.

PySide finds the name of an object by its address. A name that it made itself it gives up
when the object goes. FreeCAD names the forms it loads and the buttons of a task dialog by
itself, holds these names for ever and never gives them up: what is made at the same address
later then has the wrong name, and calls fail, or two names, and PySide frees one of them
twice when the object goes, which aborts FreeCAD. A widget has the address of a painting
device inside it as well: what is made there is mistaken in the same way, and a call to the
wrong name reads what is no object at all.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from types import SimpleNamespace
from typing import Any

import FreeCADGui
from PySide import QtCore

#: The property by which PySide learns that an object goes.
WATCHED = b"_PySideInvalidatePtr"

#: No two Qt objects are so near to each other, in bytes; a widget's second address is 16 on.
APART = 32

shiboken = import_module(
    "shiboken6" if QtCore.QObject.__module__.startswith("PySide6") else "shiboken2"
)


def load_form(path: Any) -> Any:
    """Return the widgets of a ``.ui`` file; each attribute is the widget of that name."""
    return _loaded(FreeCADGui.PySideUic.loadUi, str(path))


@contextmanager
def rightly_named() -> Iterator[None]:
    """Let the forms that FreeCAD loads within this have their names like those of `load_form`."""
    loader = FreeCADGui.PySideUic
    FreeCADGui.PySideUic = SimpleNamespace(
        **{**vars(loader), "loadUi": partial(_loaded, loader.loadUi)}
    )
    try:
        yield
    finally:
        FreeCADGui.PySideUic = loader


def _loaded(load: Callable[..., Any], *arguments: Any) -> Any:
    """Load a form and return its widgets.

    A name that was there before the widget that has it is of something that has gone.
    """
    older = shiboken.getAllValidWrappers()  # kept, so that no other name has the identity of one
    identities = set(map(id, older))
    form = load(*arguments)
    while id(form) in identities:  # there is no way to it: another is made, elsewhere
        shiboken.invalidate(form)
        form = load(*arguments)
    while id(name := _holding(form).child()) in identities:
        shiboken.invalidate(name)
    form = renamed(form)  # before its children have names, which would end with the former name
    while stale := [w for w in form.findChildren(QtCore.QObject) if id(w) in identities]:
        for name in stale:
            shiboken.invalidate(name)
    for key, name in list(vars(form).items()):
        if id(name) in identities:
            shiboken.invalidate(name)
            setattr(form, key, form.findChild(QtCore.QObject, key))
    return form


def renamed(widget: Any) -> Any:
    """Return PySide's own name for a widget, with the same attributes; another is invalid then."""
    if shiboken.createdByPython(widget) or WATCHED in map(bytes, widget.dynamicPropertyNames()):
        return widget
    attributes = dict(vars(widget))
    event = _holding(widget)
    shiboken.invalidate(widget)
    name = event.child()
    for key, value in attributes.items():
        setattr(name, key, value)
    return name


def forget_namesakes() -> None:
    """Let PySide forget what lies where an object is that Python has made: it is gone.

    To be called after widgets were made, for the names that others have left.
    """
    made, others = [], []
    for name in shiboken.getAllValidWrappers():
        if isinstance(name, QtCore.QObject):
            (made if shiboken.createdByPython(name) else others).append(name)
    addresses = sorted(map(_address, made))
    for name in others:
        address = _address(name)
        k = bisect_left(addresses, address - APART + 1)
        if k < len(addresses) and addresses[k] < address + APART:
            shiboken.invalidate(name)


def _holding(widget: Any) -> QtCore.QChildEvent:
    """Return what holds the widget, not its name; its ``child()`` is the name that PySide finds."""
    return QtCore.QChildEvent(QtCore.QEvent.ChildAdded, widget)


def _address(name: Any) -> int:
    """Return where the object is that a name stands for."""
    return int(shiboken.getCppPointer(name)[0])
