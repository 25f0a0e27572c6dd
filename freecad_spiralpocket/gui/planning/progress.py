# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress with a Stop button while a path is computed.

A recompute blocks FreeCAD's window, though the pockets are planned beside it
(`planning`). The dialog lets it draw and listens to Stop, which ends the planning
wherever it is; as it is modal to the whole application nothing else can be clicked:
a document closed in the middle of a recompute would crash FreeCAD. The document
is not touched here. The dialog appears only for work that takes longer.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ...engine.model import Progress
from ...op.operation import ObjectSpiralPocket
from ..texts.localized import localized
from . import lanes

translate = FreeCAD.Qt.translate

SHOW_AFTER = 500  # ms
UPDATE_EVERY = 0.05  # s, at most this often the window is drawn
STEPS = 1000


def install() -> None:
    """Give every spiral pocket this dialog, and have it planned beside the window."""
    ObjectSpiralPocket.planner = staticmethod(lanes.plan_all)
    ObjectSpiralPocket.progress_factory = staticmethod(progress_dialog)


@contextmanager
def progress_dialog(label: str) -> Iterator[Progress]:
    """Yield the callback that shows how far `label` is and tells whether to stop."""
    dialog = QtGui.QProgressDialog(
        label, translate("SpiralPocket", "Stop"), 0, STEPS, FreeCADGui.getMainWindow()
    )
    dialog.setObjectName("SpiralPocketProgress")
    dialog.setWindowTitle(translate("SpiralPocket", "Spiral Pocket"))
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setAutoClose(False)
    dialog.setAutoReset(False)
    dialog.setMinimumDuration(2 * SHOW_AFTER)
    dialog.setValue(0)
    show_at, next_update = time.monotonic() + SHOW_AFTER / 1000, 0.0

    def report(fraction: float, stage: str) -> bool:
        nonlocal next_update
        if time.monotonic() >= next_update:
            dialog.setValue(int(STEPS * min(1.0, max(0.0, fraction))))
            if time.monotonic() >= show_at and not dialog.isVisible():
                dialog.show()  # of its own accord it does so only when the value changes
            if dialog.isVisible():  # and modal: nothing but Stop can happen here
                dialog.setLabelText(f"{label}\n{localized(stage)}")
                QtCore.QCoreApplication.processEvents()
            next_update = time.monotonic() + UPDATE_EVERY
        return dialog.wasCanceled()

    try:
        yield report
    finally:
        dialog.close()
        dialog.setParent(None)  # gone with its last name here
