# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the shapes of tools are good for, by the names of `compat.tool_shape`."""

from __future__ import annotations

#: Tools that leave a flat floor wherever they have been. Of a shape of the user's own nobody knows.
FLAT_TOOLS = ("endmill",)
#: Tools that cut with their side, but leave ridges on the floor;
ROUND_TOOLS = ("ballend", "taperedballnose")
#: or only where steps are wider than their flat end.
BULL_NOSES = ("bullnose", "torus")
#: Tools that cannot clear a pocket at all.
UNSUITABLE_TOOLS = (
    "chamfer",
    "dovetail",
    "drill",
    "fillet",
    "flycutter",
    "probe",
    "radius",
    "reamer",
    "slittingsaw",
    "tap",
    "threadmill",
    "vbit",
)
