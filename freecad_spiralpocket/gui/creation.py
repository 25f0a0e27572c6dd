# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes a new operation in a job and opens its panel, or says why not.

Whatever goes wrong, the transaction is aborted and the document is as before.
"""

from __future__ import annotations

from typing import Any

import FreeCAD

from ..engine.dependencies import require_libraries
from ..engine.errors import SpiralPocketError
from ..op import operation
from ..op.compat import PathOp
from .compat import PathUtils
from .texts import messages
from .viewprovider import ViewProvider

translate = FreeCAD.Qt.translate


def create_in_chosen_job() -> None:
    """Make an operation in the job of what is selected, or the only one; else ask which."""
    job = PathUtils.UserInput.chooseJob(PathUtils.GetJobs())
    if job is None:  # the user cancelled the question
        return
    try:
        require_libraries()
        obj = create(job)
    except SpiralPocketError as error:
        messages.show(error)
        return
    if obj is not None:
        obj.ViewObject.Document.setEdit(obj.ViewObject, 0)


def create(job: Any) -> Any:
    """Return a new operation in `job`, None if the user chose no tool controller.

    The transaction stays open, for the panel to go on in it.

    Raises
    ------
    SpiralPocketError
        If it cannot be made; the document is as before.
    """
    document = job.Document
    document.openTransaction(translate("SpiralPocket", "Create Spiral Pocket"))
    try:
        obj = operation.Create(operation.NAME, parentJob=job)
        ViewProvider(obj.ViewObject, is_new=True)
        obj.ViewObject.Visibility = True
    except PathUtils.PathNoTCExistsException as error:
        abort(document)
        raise messages.no_tool_controller(job) from error
    except PathOp.PathNoTCException:
        abort(document)
        return None
    except BaseException:
        abort(document)
        raise
    return obj


def abort(document: Any) -> None:
    """Take back everything since the transaction was opened."""
    document.abortTransaction()
    if FreeCAD.getActiveTransaction():  # nothing was changed: the document has none to abort
        FreeCAD.closeActiveTransaction(True)
    document.recompute()
