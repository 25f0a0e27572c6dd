# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations of ours that a FreeCAD without the add-on has saved, without their proxies.

Loads nothing: documents are looked at before anything of ours is needed.
"""

from __future__ import annotations

from typing import Any

#: A property that no operation of FreeCAD's own has.
MARK = "SpiralCurve"


def lost(document: Any) -> list[Any]:
    """Return the operations of ours in a document that have lost their proxies."""
    return [
        obj
        for obj in document.findObjects("Path::Feature")
        if getattr(obj, "Proxy", obj) is None and MARK in obj.PropertiesList
    ]
