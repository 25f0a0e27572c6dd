# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this file when its window starts; all of it is in `freecad_spiralpocket.gui`."""

from freecad_spiralpocket.gui import startup

startup.start()
