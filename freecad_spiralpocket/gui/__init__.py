# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user sees: the command, the task panel, preview, result, plots, comparison.

Here stands what FreeCAD calls; saved documents name `viewprovider`. The packages, from the
lowest up: `qt`, `texts`, `planning`, `fields`, `preview`, `result`, `plots`, `compare`, `panel`.

Imports nothing: FreeCAD loads `startup` and `command` when its window opens,
the rest only when the first operation is made, opened or restored.
"""
