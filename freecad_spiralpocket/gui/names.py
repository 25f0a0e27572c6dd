# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python's names for Qt's objects, so that no name outlives what it names.

PySide finds the name of an object by its address. A name that it made itself it gives up
when the object goes. FreeCAD names the forms it loads and the buttons of a task dialog by
itself, holds these names for ever and never gives them up: what is made at the same address
later then has the wrong name, and calls fail, or two names, and PySide frees one of them
twice when the object goes, which aborts FreeCAD.
"""

from __future__ import annotations

from collections import defaultdict
from importlib import import_module
from typing import Any

from PySide import QtCore, QtGui

#: The property by which PySide learns that an object goes.
WATCHED = b"_PySideInvalidatePtr"

shiboken = import_module(
    "shiboken6" if QtCore.QObject.__module__.startswith("PySide6") else "shiboken2"
)


def renamed(widget: Any) -> Any:
    """Return PySide's own name for a widget, with the same attributes; another is invalid then."""
    if shiboken.createdByPython(widget) or WATCHED in map(bytes, widget.dynamicPropertyNames()):
        return widget
    attributes = dict(vars(widget))
    holder = QtCore.QChildEvent(QtCore.QEvent.ChildAdded, widget)  # holds the widget, not its name
    shiboken.invalidate(widget)
    name = holder.child()
    for key, value in attributes.items():
        setattr(name, key, value)
    return name


def rename_attributes(holder: Any) -> dict[Any, Any]:
    """Rename the widgets that are attributes of an object; return the new names by the old ones."""
    widgets = {k: w for k, w in vars(holder).items() if isinstance(w, QtGui.QWidget)}
    names = {widget: renamed(widget) for widget in set(widgets.values())}
    for key, widget in widgets.items():
        setattr(holder, key, names[widget])
    return names


def forget_namesakes() -> None:
    """Let PySide forget what has the address of an object that Python has made: it is gone.

    To be called after widgets were made, for the names that others have left.
    """
    names = defaultdict(set)
    for name in shiboken.getAllValidWrappers():
        if isinstance(name, QtCore.QObject):
            names[shiboken.getCppPointer(name)[0]].add(name)
    for namesakes in names.values():
        made = {name for name in namesakes if shiboken.createdByPython(name)}
        if made:
            for name in namesakes - made:
                shiboken.invalidate(name)
