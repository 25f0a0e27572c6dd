# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sample part: a wing rib with nine pockets, as thin-walled aircraft parts have them.

A plate with a curved upper and lower side, six bays between vertical webs, two
of them split by a horizontal web, one by a diagonal one: rectangles, trapezoids
and triangles with a corner radius of 10 mm. Run by FreeCAD it writes `rib.step`
beside itself:

    freecadcmd examples/rib.py
"""

import math
import sys
from itertools import pairwise
from pathlib import Path

import FreeCAD
import Part
from FreeCAD import Vector

LENGTH = 600.0  # mm, all of them
THICKNESS = 15.0
FLOOR = 3.0
FLANGE = 6.0
WEB = 5.0
CORNER_RADIUS = 10.0
NAME = "rib.step"

#: The upper and lower side, (x, y) [mm].
UPPER = [(0, 96), (120, 122), (250, 128), (380, 114), (500, 88), (LENGTH, 58)]
LOWER = [(0, 14), (120, 3), (250, 0), (380, 3), (500, 12), (LENGTH, 24)]
#: Where the vertical webs stand, x of their middle [mm].
WEBS = (92.0, 186.0, 290.0, 392.0, 486.0)


def build():
    """Return the rib as a solid, its lower face on Z0."""
    solid = outline().extrude(Vector(0, 0, THICKNESS))
    for corners in pockets():
        tool = Part.Face(rounded(corners)).extrude(Vector(0, 0, THICKNESS))
        tool.translate(Vector(0, 0, FLOOR))
        solid = solid.cut(tool)
    return solid.removeSplitter()


def side(points):
    """Return the curve through `points`."""
    curve = Part.BSplineCurve()
    curve.interpolate([Vector(x, y, 0) for x, y in points])
    return curve


def outline():
    """Return the rib's outline as a face."""
    upper, lower = side(UPPER), side(LOWER)
    ends = [
        Part.makeLine(lower.EndPoint, upper.EndPoint),
        Part.makeLine(upper.StartPoint, lower.StartPoint),
    ]
    return Part.Face(Part.Wire([lower.toShape(), ends[0], upper.toShape(), ends[1]]))


def height(curve, x):
    """Return y of `curve` at `x`."""
    line = Part.Line(Vector(x, -1e3, 0), Vector(x, 1e3, 0))
    return curve.intersectCC(line)[0].Y


def pockets():
    """Yield the corners of each pocket before rounding, counter-clockwise."""
    upper, lower = side(UPPER), side(LOWER)
    edges = [FLANGE - WEB / 2, *WEBS, LENGTH - FLANGE + WEB / 2]
    for bay, (left, right) in enumerate(pairwise(edges)):
        x0, x1 = left + WEB / 2, right - WEB / 2
        b0, b1 = (height(lower, x) + FLANGE for x in (x0, x1))
        t0, t1 = (height(upper, x) - FLANGE for x in (x0, x1))
        if bay == 2:  # the deepest bay: two rectangles, one above the other
            bottom, top = max(b0, b1, height(lower, 250) + FLANGE), min(t0, t1)
            middle = (bottom + top) / 2
            for low, high in ((bottom, middle - WEB / 2), (middle + WEB / 2, top)):
                yield [(x0, low), (x1, low), (x1, high), (x0, high)]
        elif bay == 3:  # two triangles on both sides of a diagonal web
            yield from triangles((x0, b0), (x1, b1), (x1, t1), (x0, t0))
        elif bay == 1:  # a trapezoid above a rectangle
            bottom, middle = max(b0, b1), (b0 + t0) / 2 - 6
            yield [(x0, bottom), (x1, bottom), (x1, middle), (x0, middle)]
            yield [(x0, middle + WEB), (x1, middle + WEB), (x1, t1), (x0, t0)]
        else:
            yield [(x0, b0), (x1, b1), (x1, t1), (x0, t0)]


def triangles(lower_left, lower_right, upper_right, upper_left):
    """Yield the two halves of a quadrilateral on both sides of a web from its lower left."""
    along = Vector(upper_right[0] - lower_left[0], upper_right[1] - lower_left[1], 0).normalize()
    slope = along.y / along.x
    rise = WEB / 2 / along.x  # half the web, measured upright
    run = WEB / 2 / along.y  # and lengthwise
    yield [
        (lower_left[0] + run, lower_left[1]),
        lower_right,
        (upper_right[0], lower_left[1] + slope * (upper_right[0] - lower_left[0]) - rise),
    ]
    yield [
        (lower_left[0], lower_left[1] + rise),
        (upper_right[0] - run, upper_right[1]),
        upper_left,
    ]


def rounded(corners):
    """Return the polygon as a wire with all corners rounded."""
    points = [Vector(x, y, 0) for x, y in corners]
    starts, ends, arcs = [], [], []
    for i, corner in enumerate(points):
        back = (points[i - 1] - corner).normalize()
        ahead = (points[(i + 1) % len(points)] - corner).normalize()
        half = back.getAngle(ahead) / 2
        bisector = (back + ahead).normalize()
        reach = CORNER_RADIUS / math.tan(half)
        middle = corner + bisector * (CORNER_RADIUS / math.sin(half) - CORNER_RADIUS)
        starts.append(corner + back * reach)
        ends.append(corner + ahead * reach)
        arcs.append(Part.Arc(starts[-1], middle, ends[-1]).toShape())
    edges = []
    for i, arc in enumerate(arcs):
        edges += [arc, Part.makeLine(ends[i], starts[(i + 1) % len(points)])]
    return Part.Wire(edges)


def main():
    """Write the STEP file."""
    document = FreeCAD.newDocument("Rib", hidden=True)
    part = document.addObject("Part::Feature", "Rib")
    part.Shape = build()
    path = Path(__file__).resolve().parent / NAME
    Part.export([part], str(path))
    print(f"wrote {path}: {len(part.Shape.Faces)} faces, {part.Shape.Volume / 1000:.0f} cm3")
    sys.stdout.flush()
    FreeCAD.closeDocument(document.Name)


if __name__ in ("__main__", "rib"):  # freecadcmd names a script after its file
    main()
