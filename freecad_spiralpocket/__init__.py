# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spiral Pocket: clears pockets with one smooth, engagement-limited spiral.

Importing the package imports nothing else: `engine` is pure numpy, scipy and
shapely, `op` and `api` need FreeCAD, `gui` needs its user interface.
"""

__version__ = "0.2.0"
