# SPDX-License-Identifier: LGPL-2.1-or-later
"""Leaves programs for tests/output, with what they may do taken from the part alone."""

import json

from freecad_spiralpocket import api
from freecad_spiralpocket.op.compat import parent_job

OUTLINE_DEFLECTION = 5e-4  # mm


def true_outline(face):
    """Return the face's wires as lists of points on the true curves."""
    wires = [face.OuterWire, *(w for w in face.Wires if not w.isSame(face.OuterWire))]
    return [[(p.x, p.y) for e in w.OrderedEdges for p in edge_points(e)] for w in wires]


def edge_points(edge):
    points = edge.discretize(Deflection=OUTLINE_DEFLECTION)
    return points[::-1] if edge.Orientation == "Reversed" else points


def box_around(points, margin):
    """Return the corners of the box around points, larger by `margin` on all sides."""
    (x0, x1), (y0, y1) = ((min(v) - margin, max(v) + margin) for v in zip(*points, strict=True))
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def write(folder, name, op, floors, beside=0.0):
    """Write the program of the operation's job and what it may do.

    Floors that are open all around may be left by `beside` [mm].
    """
    folder.mkdir(parents=True, exist_ok=True)
    stock = parent_job(op).Stock.Shape.BoundBox
    outlines = [true_outline(face) for face, _ in floors]
    if beside:
        outlines = [[box_around(outer, beside), *islands] for outer, *islands in outlines]
    limits = {
        "radius": op.OpToolDiameter.Value / 2 + op.StockToLeave.Value,
        "cutter": op.OpToolDiameter.Value / 2,
        "top": op.StartDepth.Value,
        "clearance": op.ClearanceHeight.Value,
        "stock": [stock.XMin, stock.YMin, stock.XMax, stock.YMax],
        "pockets": [
            {"wires": wires, "floor": z + op.ZStockToLeave.Value}
            for wires, (_, z) in zip(outlines, floors, strict=True)
        ],
    }
    api.export(parent_job(op), folder / f"{name}.ngc", "linuxcnc", "--precision=4")
    (folder / f"{name}.json").write_text(json.dumps(limits), encoding="utf-8")
