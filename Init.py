# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this file at its start, with and without a window.

There is nothing to do: the operation registers itself when it is imported, and
importing it here would make every start of FreeCAD slower.
"""
