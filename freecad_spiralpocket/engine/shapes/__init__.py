# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines and regions of the plane: polylines, arcs, splines, offsets, the medial axis."""
