# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts, jobs and document snapshots for the tests that run inside FreeCAD."""

import math
import re

import FreeCAD
import Part
from FreeCAD import Vector

from freecad_spiralpocket.op.compat import PathJob

DEPTH = 6.0  # mm below Z0, where the tops of all parts are
#: The strategy that is done soonest, for tests to which it does not matter.
QUICK = {"Strategy": "Linear Morph"}


def rectangle(width, height, radius=0.0, x=0.0, y=0.0):
    """Return a wire with rounded corners, its lower left corner at (x, y)."""
    solid = Part.makeBox(width, height, 1, Vector(x, y, 0))
    upright = [e for e in solid.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.9]
    if radius:
        solid = solid.makeFillet(radius, upright)
    return next(f for f in solid.Faces if f.BoundBox.ZMax < 1e-6).OuterWire


def circle(radius, x=0.0, y=0.0):
    """Return a circle as a wire."""
    return Part.Wire(Part.makeCircle(radius, Vector(x, y, 0)))


def spline(points):
    """Return a closed smooth curve through `points` as a wire."""
    curve = Part.BSplineCurve()
    curve.interpolate([Vector(x, y, 0) for x, y in points], True)
    return Part.Wire(curve.toShape())


def polygon(points):
    """Return a polygon as a wire."""
    corners = [Vector(x, y, 0) for x, y in points]
    return Part.makePolygon([*corners, corners[0]])


def area(outer, *holes):
    """Return a face at Z0 from wires."""
    face = Part.Face(outer)
    for hole in holes:
        face = face.cut(Part.Face(hole))
    return face.Faces[0]


def block(*areas, depth=DEPTH, margin=12.0, below=4.0):
    """Return a block whose top is at Z0, with a pocket of `depth` for each of `areas`."""
    box = FreeCAD.BoundBox()
    for face in areas:
        box.add(face.BoundBox)
    solid = Part.makeBox(
        box.XLength + 2 * margin,
        box.YLength + 2 * margin,
        depth + below,
        Vector(box.XMin - margin, box.YMin - margin, -depth - below),
    )
    for face in areas:
        tool = face.copy()
        tool.translate(Vector(0, 0, -depth))
        solid = solid.cut(tool.extrude(Vector(0, 0, depth + 1)))
    return solid.Solids[0]


def faces_at(shape, z, looking=1.0):
    """Return the names of the level faces at height `z`, by their X, that look up (or down)."""
    found = [
        (face.BoundBox.XMin, f"Face{number}")
        for number, face in enumerate(shape.Faces, start=1)
        if face.BoundBox.ZLength < 1e-6
        and abs(face.BoundBox.ZMin - z) < 1e-6
        and face.normalAt(0, 0).z * looking > 0.9
    ]
    return [name for _, name in sorted(found)]


def vertical_face(shape):
    """Return the name of a wall."""
    return next(
        f"Face{number}"
        for number, face in enumerate(shape.Faces, start=1)
        if abs(face.normalAt(0, 0).z) < 1e-6
    )


def box(x, y, z, width, depth, height):
    """Return a box from one corner on."""
    return Part.makeBox(width, depth, height, Vector(x, y, z))


def add_part(doc, shape, name="Part"):
    """Return a new object of `doc` with `shape`."""
    part = doc.addObject("Part::Feature", name)
    part.Shape = shape
    return part


def add_job(doc, *parts, diameter=6.0, feed=1500.0):
    """Return a new job with one end mill, its feeds in mm/min, and stock flush with Z0."""
    doc.recompute()
    job = PathJob.Create("Job", list(parts), None)
    job.Stock.ExtZpos = 0
    tool_controller = job.Tools.Group[0]
    tool_controller.Tool.Diameter = diameter
    set_feeds(tool_controller, feed)
    for _ in range(3):  # the tool's own shape follows its diameter only after some recomputes
        doc.recompute()
    return job


def set_feeds(tool_controller, feed):
    """Set all speeds of a tool controller from its horizontal feed [mm/min]."""
    tool_controller.SpindleSpeed = 12000
    tool_controller.HorizFeed = feed / 60
    tool_controller.VertFeed = feed / 4 / 60
    for name in ("HorizRapid", "VertRapid"):
        tool_controller.setExpression(name, None)  # else the setup sheet's rates come back
        setattr(tool_controller, name, 5000 / 60)


def small_job(doc, diameter=6.0):
    """Return a job for a block with one small pocket, the part and the floor's name."""
    part = add_part(doc, block(area(rectangle(24, 18, 4))))
    job = add_job(doc, part, diameter=diameter)
    return job, part, faces_at(part.Shape, -DEPTH)[0]


def motion(op):
    """Return the commands of an operation's path that move."""
    return [c for c in op.Path.Commands if not c.Name.startswith("(")]


def told(op, words):
    """Return whether a notice of an operation has these words."""
    return any(words in notice for notice in op.Notices)


def gcode(op):
    """Return the operation's path as text without its label."""
    return "\n".join(c.toGCode() for c in motion(op))


def snapshot(doc):
    """Return what the document says about its objects, as text by object and property.

    Shapes are left out; values, expressions and states are in.
    """
    result = {}
    for obj in doc.Objects:
        for name in obj.PropertiesList:
            if "Shape" not in obj.getTypeIdOfProperty(name) and name != "Proxy":
                value = str(getattr(obj, name, None))
                result[obj.Name, name] = re.sub(" at 0x[0-9a-f]+", "", value)
        result[obj.Name, "(expressions)"] = str(obj.ExpressionEngine)
        result[obj.Name, "(state)"] = str(obj.State)
    return result


def slanted_block(angles=(10, 15, 20, 30), depth=18.0, width=100.0, height=60.0, radius=10.0):
    """Return a block with a pocket whose walls open upwards (Chatelain et al. 2008, figure 19).

    Parameters
    ----------
    angles : sequence of float
        Of the walls at low X, high X, low Y and high Y to the vertical [deg]; negative ones lean
        over the floor.
    depth, width, height, radius : float
        Of the pocket, its floor and its corners [mm]; the top is at Z0, the floor's corner at
        X0 Y0.
    """
    left, right, front, back = (depth * math.tan(math.radians(a)) for a in angles)
    floor = rectangle(width, height, radius)
    floor.translate(Vector(0, 0, -depth))
    mouth = rectangle(width + left + right, height + front + back, radius, -left, -front)
    pocket = Part.makeLoft([floor, mouth], True, True)
    box = pocket.BoundBox
    corner = Vector(box.XMin - 12, box.YMin - 12, -depth - 4)
    return Part.makeBox(box.XLength + 24, box.YLength + 24, depth + 4, corner).cut(pocket)


def with_island(shape, low, high=0.0, x=50.0, y=30.0, radii=(12.0, 7.0)):
    """Return `shape` with a cone from Z `low` to `high` fused to it."""
    return shape.fuse(Part.makeCone(*radii, high - low, Vector(x, y, low))).removeSplitter()


def filleted_foot(shape, z, radius):
    """Return `shape` with its floor at `z` joined to the walls by fillets."""
    name = faces_at(shape, z)[0]
    return shape.makeFillet(radius, shape.getElement(name).OuterWire.Edges)


def stepped_block(low=(40.0, 24.0), high=(64.0, 44.0), ledge=-4.0, depth=DEPTH):
    """Return a block with a pocket that widens on a ledge all around."""
    wide = area(rectangle(*high, 6, -high[0] / 2, -high[1] / 2))
    narrow = area(rectangle(*low, 5, -low[0] / 2, -low[1] / 2))
    narrow.translate(Vector(0, 0, -depth))
    return block(wide, depth=-ledge, below=depth + ledge + 4).cut(
        narrow.extrude(Vector(0, 0, depth))
    )
