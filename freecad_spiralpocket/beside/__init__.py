# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in other processes than FreeCAD's own, which know neither FreeCAD nor Qt.

`process` is what runs there, `tasks` what it can do, `interpreters` finds a Python to run
it; `crew` plans the pockets of an operation in several of them where there is no window.
The window has its own way to lead them (`gui.planning.workers`). Imports nothing.
"""
