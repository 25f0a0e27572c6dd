# SPDX-License-Identifier: LGPL-2.1-or-later
"""The CAM operation: from a change in the document to a new path, or to none and the reason.

FreeCAD's own base class keeps the old path when an operation fails, and posts
it. Here every recompute starts by clearing the path; whatever goes wrong leaves
it empty but for a comment. Errors are kept on the proxy for whoever started the
recompute (`errors`, never saved), logged, and shown in the property `Notices`.

Nothing here needs shapely or scipy until a path is computed, so that documents
open where they are missing. FreeCAD does not call ``__init__`` when it restores
a document: what the proxy holds has its initial value in the class.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, Any

import FreeCAD
import Part
import Path

from ..engine.dependencies import require_libraries
from ..engine.errors import CancelledError, SetupError, SpiralPocketError
from ..engine.model import Plan, Progress
from . import commands, properties, results, selection, setup_sheet
from .compat import (
    KeepsNothing,
    PathLog,
    PathOp,
    PathSetupSheet,
    evaluate_constants,
    parent_job,
    tool_name,
    tool_shape,
    unreadable_job,
)
from .rest_watch import RestWatch, names_before
from .tools import UNSUITABLE_TOOLS

if TYPE_CHECKING:
    from .known import Known
    from .pockets import Planner

#: The name under which the setup sheet keeps presets; also that of new operations.
NAME = "SpiralPocket"


class ObjectSpiralPocket(KeepsNothing, PathOp.ObjectOp):
    """Proxy of the operation.

    Attributes
    ----------
    errors : list of SpiralPocketError
        Of the last recompute; transient.
    plans : list of Plan
        Of the last recompute, one for each pocket that was cut; transient.
    progress_factory : callable or None
        ``progress_factory(label)`` returns a context manager that yields a `Progress`; set on
        the class by the graphical side, if there is one.
    planner : Planner or None
        What plans the pockets, see `pockets`; set on the class by the graphical side.
    known : Known or None
        What the panel knows of the model, while it has the path made; transient.
    before : tuple of str or None
        The names of all operations before this one at the last recompute; transient.
    """

    progress_factory: Callable[[str], AbstractContextManager[Progress | None]] | None = None
    planner: Planner | None = None
    errors: list[SpiralPocketError] | tuple[()] = ()
    plans: list[Plan] | tuple[()] = ()
    known: Known | None = None
    before: tuple[str, ...] | None = None
    _earlier: list[Plan] | tuple[()] = ()

    def opFeatures(self, obj: Any) -> int:  # noqa: N802
        """Return which of the base class' properties and pages there are."""
        return (
            PathOp.FeatureTool
            | PathOp.FeatureDepths
            | PathOp.FeatureHeights
            | PathOp.FeatureStepDown
            | PathOp.FeatureFinishDepth
            | PathOp.FeatureBaseFaces
            | PathOp.FeatureCoolant
        )

    def initOperation(self, obj: Any) -> None:  # noqa: N802
        """Add the properties; `obj` may be the setup sheet's prototype."""
        properties.create(obj)
        if hasattr(obj, "DoNotSetDefaultValues"):
            setup_sheet.mend(obj)

    def opSetDefaultValues(self, obj: Any, job: Any) -> None:  # noqa: N802
        """Set the defaults and what the user prefers; presets of the setup sheet follow."""
        properties.set_defaults(obj)
        properties.set_preferred(obj)
        setup_sheet.renew(job.SetupSheet, obj, NAME)

    def opOnDocumentRestored(self, obj: Any) -> None:  # noqa: N802
        """Bring documents of older releases up to date."""
        properties.migrate(obj)

    @classmethod
    def opPropertyEnumerations(cls, dataType: str = "data") -> Any:  # noqa: N802, N803
        """Return the choices of all enumerations, as the base class does."""
        inherited = PathOp.ObjectOp.opPropertyEnumerations(dataType)
        translate = FreeCAD.Qt.translate
        pairs = {
            name: [(translate("SpiralPocket", choice), choice) for choice in choices]
            for name, choices in properties.choices().items()
        }
        if dataType == "raw":
            return {**inherited, **pairs}
        index = 0 if dataType == "translated" else 1
        return [*inherited, *((name, [p[index] for p in own]) for name, own in pairs.items())]

    def isToolSupported(self, obj: Any, tool: Any) -> bool:  # noqa: N802
        """Return whether `tool` can clear a pocket."""
        return tool_shape(tool) not in UNSUITABLE_TOOLS

    def opRejectAddBase(self, obj: Any, base: Any, sub: str) -> bool:  # noqa: N802
        """Refuse edges, vertices and whole bodies."""
        return not sub.startswith("Face")

    def sanitizeBase(self, obj: Any) -> bool:  # noqa: N802
        """Leave faces that are gone in the list: each is an error of its own when cutting.

        The base class would forget all faces when one is gone, and fails on 1.0 and later.
        """
        return False

    def updateDepths(self, obj: Any, ignoreErrors: bool = False) -> bool:  # noqa: N802, N803
        """Derive the depths from the stock and the deepest floor.

        The base class takes the highest floor, and fails on a face that is gone or without a stock.
        """
        if not self._setBaseAndStock(obj, ignoreErrors) or self.stock is None:
            return False
        values = selection.depth_limits(obj.Base, self.stock.Shape.BoundBox)
        properties.set_results(obj, values)
        return True

    @classmethod
    def revive(cls, obj: Any) -> None:
        """Take an operation over that was saved by a FreeCAD without the add-on.

        That keeps all but the proxy, which saves nothing; the path may be older than the part.
        """
        obj.Proxy = cls.__new__(cls)
        obj.Proxy.onDocumentRestored(obj)
        obj.touch()

    def execute(self, obj: Any) -> None:
        """Make the path anew.

        Overrides the base class, which returns early with the old path in place when there is
        no job or no tool, and keeps it when `opExecute` raises.
        """
        self.errors, self.plans, self._earlier = [], [], self.plans or self._earlier
        self.before = names_before(obj)
        obj.Path = Path.Path()
        obj.SpiralCurve = Part.Shape()
        properties.clear_results(obj)
        try:
            evaluate_constants(obj, properties.option_names())
            if obj.Active:
                self.check_setup(obj)
            super().execute(obj)
        except SpiralPocketError as error:
            self._fail(obj, error)
        finally:
            results.set_cycle_time(obj, self.plans)
        for error in self.errors:
            log = PathLog.info if isinstance(error, CancelledError) else PathLog.error
            told = str(error)
            log(f"{told}\n" if told.startswith(obj.Label) else f"{obj.Label}: {told}\n")

    def addBase(self, obj: Any, base: Any, sub: str) -> None:  # noqa: N802 - FreeCAD's name
        """Add a face, by the name that it has in the job's model.

        FreeCAD takes the assembly that a part is in for the part, and keeps the face's name, which
        is that of another face there.
        """
        super().addBase(obj, *selection.in_model(parent_job(obj), base, sub))

    def opExecute(self, obj: Any) -> None:  # noqa: N802
        """Plan every pocket; the base class puts `commandlist` into the path."""
        require_libraries()
        from .pockets import Pockets  # needs shapely

        pockets = Pockets(obj, self._earlier, self.known)
        factory = type(self).progress_factory
        with factory(obj.Label) if factory else nullcontext() as progress:
            pockets.plan(progress, type(self).planner)
        self.plans, self.errors = pockets.plans, pockets.errors
        if not self.plans:
            raise self.errors[0]
        self.commandlist += commands.without_last_lift(pockets.commands())
        results.write(obj, self.plans, pockets.notices())

    def check_setup(self, obj: Any) -> None:
        """Raise where the base class would return without a path.

        Raises
        ------
        SetupError
        """
        job = required_job(obj)
        if not job.Model.Group:
            raise SetupError(f"{job.Label} has no model.", "Add the part to the job's model.")
        if job.Stock is None:
            raise SetupError(f"{job.Label} has no stock.", "Set one up in the job's editor.")
        tool_controller = obj.ToolController
        if tool_controller is None:
            raise SetupError(
                f"{obj.Label} has no tool controller.", "Choose one with an end mill in it."
            )
        if tool_controller.ToolNumber == 0:
            raise SetupError(
                f"{tool_controller.Label} has tool number 0, which stands for no tool.",
                "Give it the number of an end mill, 1 or higher.",
            )
        tool = tool_controller.Proxy.getTool(tool_controller)
        if not tool or float(tool.Diameter) <= 0:
            raise SetupError(
                f"{tool_controller.Label} has no tool, or one without a diameter.",
                "Put an end mill into the tool controller.",
            )
        if not self.isToolSupported(obj, tool):
            raise SetupError(
                f"{tool_name(tool)} is not an end mill; it cannot clear a pocket.",
                "Choose a tool controller with an end mill in it.",
            )

    def _fail(self, obj: Any, error: SpiralPocketError) -> None:
        """Leave no path but a comment, and say why."""
        if not self.errors:
            self.errors = [error]
        obj.Path = Path.Path([commands.comment(f"{obj.Label}: no path. {error.message}")])
        properties.set_results(obj, {"Notices": [str(e) for e in self.errors]})


def required_job(obj: Any) -> Any:
    """Return the job that an operation is in.

    Raises
    ------
    SetupError
        If there is none.
    """
    job = parent_job(obj)
    if job is not None:
        return job
    lost = unreadable_job(obj)
    if lost is not None:
        raise SetupError(
            f"This FreeCAD cannot read {lost.Label}, which another version has saved.",
            "Open the document in that version, or make a new job here.",
        )
    raise SetupError(f"{obj.Label} is not in a job.", "Drag it into the job's operations.")


def SetupProperties() -> list[str]:  # noqa: N802 - the name FreeCAD calls
    """Return the names of the properties that a preset of the setup sheet may hold."""
    return properties.preset_names()


def Create(name: str, obj: Any = None, parentJob: Any = None) -> Any:  # noqa: N802, N803
    """Create the operation in `parentJob`, or in the only job of the active document.

    Nothing is left in the document if that fails.
    """
    document = parentJob.Document if parentJob else FreeCAD.ActiveDocument
    made = obj is None
    if made:
        obj = document.addObject("Path::FeaturePython", name)
    try:
        obj.Proxy = ObjectSpiralPocket(obj, name, parentJob)
    except BaseException:
        if made:
            document.removeObject(obj.Name)
        raise
    return obj


PathSetupSheet.RegisterOperation(NAME, Create, SetupProperties)
FreeCAD.addDocumentObserver(RestWatch(ObjectSpiralPocket))
