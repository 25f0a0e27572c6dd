# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own boxes in the panel: they write what they show, rounded, also where nobody typed.

FreeCAD writes all boxes of a page, or of the tool controller's editor, with every change. A box
that has been shown since holds the number in its text: 0.025 m/s as 0.03 m/s. And a property that
an expression gives is overwritten in the middle of the recompute, when its box follows: the step
down of a cutter of 4.1234 mm by 4.12 mm, so that the path is not the one that was foreseen. Here a
box whose text is the one that was shown is left alone, and an expression has the last word.
"""

from __future__ import annotations

import weakref
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

import FreeCAD

from .field import expression, set_property


def write_no_rounded_feeds(editor: Any) -> None:
    """Let the editor of a tool controller (1.1) leave the feeds alone that nobody has entered."""
    found = weakref.ref(editor)

    def write() -> None:
        editor = found()
        with _left_alone(editor):
            type(editor).updateToolController(editor)

    editor.updateToolController = write


def write_no_rounded_depths(page: Any) -> None:
    """Let a page of depths or heights leave alone what nobody has entered there."""
    write_all = page.getFields

    def write(obj: Any) -> None:
        with _left_alone(page):
            write_all(obj)
        for box in _boxes_of(page):
            text = expression(obj, box.prop)
            if text:
                set_property(obj, box.prop, FreeCAD.Units.Quantity(obj.evalExpression(text)).Value)

    page.getFields = write


def _boxes_of(holder: Any) -> Iterable[Any]:
    """Return FreeCAD's boxes for quantities of a page or an editor."""
    return [each for each in vars(holder).values() if hasattr(each, "lastWidgetText")]


@contextmanager
def _left_alone(holder: Any) -> Iterator[None]:
    """Keep the boxes from writing that show what was shown in them last."""
    same = [b for b in _boxes_of(holder) if b.valid and b.widget.text() == b.lastWidgetText]
    for box in same:
        box.valid = False
    try:
        yield
    finally:
        for box in same:
            box.valid = True
