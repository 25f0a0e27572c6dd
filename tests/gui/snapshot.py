# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document as plain values, to tell whether it is as before."""

import Part


def snapshot(document):
    """Return every property of every object, by names."""
    return {obj.Name: _properties(obj) for obj in document.Objects}


def differences(before, after):
    """Return what differs between two snapshots, as {object: {property: (before, after)}}."""
    return {
        name: {
            p: (one.get(p), two.get(p)) for p in one.keys() | two.keys() if one.get(p) != two.get(p)
        }
        for name in before.keys() | after.keys()
        for one, two in [(before.get(name, {}), after.get(name, {}))]
        if one != two
    }


def _properties(obj):
    values = {p: _plain(getattr(obj, p)) for p in obj.PropertiesList}
    values["Visible"] = obj.ViewObject.Visibility
    return values


def _plain(value):
    if isinstance(value, (list, tuple)):
        return [_plain(v) for v in value]
    if hasattr(value, "PropertiesList"):
        return value.Name
    if hasattr(value, "Commands"):
        return value.toGCode()
    if isinstance(value, Part.Shape):
        return "" if value.isNull() else (value.ShapeType, len(value.Faces), str(value.BoundBox))
    text = repr(value)
    return type(value).__name__ if " at 0x" in text else text
