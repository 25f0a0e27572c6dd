# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user sees: the command, the task panel, messages and progress.

Imports nothing: FreeCAD loads `startup` and `command` when its window opens,
the rest only when the first operation is made, opened or restored.
"""
