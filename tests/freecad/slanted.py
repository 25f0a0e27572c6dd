# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets with slanted walls are cut, and gouges looked for in the solid."""

from sample_parts import add_job, add_part, faces_at, motion
from solid_oracle import Surface, gouges, places

from freecad_spiralpocket import api

#: Deepest gouge that may be, into the solid's true surface [mm].
GOUGE = 0.01
TOOL = 16.0
#: What stands between the places where the cutter is looked at [mm].
SCALLOP = 0.02


def cut(doc, shape, z, index=0, diameter=TOOL, **options):
    """Return an operation on the floor at `z` of a new part."""
    part = add_part(doc, shape)
    job = add_job(doc, part, diameter=diameter)
    return api.add_spiral_pocket(job, [(part, [faces_at(shape, z)[index]])], **options)


def gouges_of(op, shape, step=1.5):
    """Return where an operation's path cuts into a solid."""
    radius = op.OpToolDiameter.Value / 2
    return gouges(Surface.of(shape), places(motion(op), step), radius, GOUGE)
