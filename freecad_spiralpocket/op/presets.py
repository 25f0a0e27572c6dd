# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of one operation as the default of its job, in FreeCAD's setup sheet.

From there new operations of the job take them, FreeCAD's job editor shows and
removes them, and a job template carries them into other documents.
"""

from __future__ import annotations

from typing import Any

from . import properties
from .compat import PathSetupSheet, parent_job
from .operation import NAME


def keep(obj: Any) -> None:
    """Make the options of the operation `obj` the default of its job."""
    sheet, names = parent_job(obj).SetupSheet, properties.preset_names()
    prototype = PathSetupSheet._RegisteredOps[NAME].prototype(NAME)
    for name in names:
        value = getattr(obj, name)
        prototype.getProperty(name).setupProperty(
            sheet,
            PathSetupSheet.OpPropertyName(NAME, name),
            PathSetupSheet.OpPropertyGroup(NAME),
            value,
        )
