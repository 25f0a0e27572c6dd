# SPDX-License-Identifier: LGPL-2.1-or-later
"""One way to cut the pocket that is compared: its picture and figures."""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from ...beside.tasks import Drawn
from ...engine.errors import SpiralPocketError
from ...engine.model import PocketRequest
from ...engine.stepover import over_limit
from ..planning import lanes
from ..planning.lane import Job
from ..preview.colors import OVER_LIMIT, Scale
from ..qt.theme import theme
from ..result.figures import uncut_of
from ..texts.localized import in_panel
from ..texts.measures import alarming, area, as_table, decimal, duration, length
from .picture import picture_of

translate = FreeCAD.Qt.translate

PICTURE = QtCore.QSize(250, 170)


class Card:
    """One way to cut the pocket: picture, figures, and a button to take it.

    Attributes
    ----------
    job : Job or None
        Which plans it; None where that is known.
    """

    def __init__(
        self,
        name: str,
        task: str,
        request: PocketRequest,
        choose: Callable[[], None] | None,
        changed: Callable[[], None],
    ) -> None:
        self.name = name
        self.seconds: float | None = None
        self.is_sound = False
        self._task, self._request, self._changed = task, request, changed
        self.job: Job | None = None
        self.frame = QtGui.QFrame()
        self.frame.setFrameShape(QtGui.QFrame.StyledPanel)
        self._title, self.picture, self.text = QtGui.QLabel(), QtGui.QLabel(), QtGui.QLabel()
        self.picture.setFixedSize(PICTURE)
        self.picture.setAlignment(QtCore.Qt.AlignCenter)
        self.text.setWordWrap(True)
        self.text.setMinimumWidth(PICTURE.width())
        self.text.setAlignment(QtCore.Qt.AlignTop)
        self.button = QtGui.QPushButton(translate("SpiralPocket", "Use this"))
        self.button.setEnabled(False)
        self._choose = choose
        if choose is not None:
            self.button.clicked.connect(lambda *_: choose())
        layout = QtGui.QVBoxLayout(self.frame)
        layout.addWidget(self._title)
        layout.addWidget(self.picture, 0, QtCore.Qt.AlignHCenter)
        layout.addWidget(self.text)
        layout.addStretch()
        layout.addWidget(self.button)
        self.button.setVisible(choose is not None)
        self.emphasize(False)

    def begin(self) -> None:
        """Show what is known, or have it planned."""
        is_plan = self._task == "plan"
        known = lanes.known(self._request) if is_plan else None
        if known is not None:
            self._show(known)
            return
        submit = lanes.prove if is_plan else lambda r: lanes.proofs.submit(self._task, r)
        self.job = submit(self._request)
        self.job.listeners.append(self._hear)
        self._hear(self.job)

    def emphasize(self, fastest: bool) -> None:
        """Write the name, of the fastest with a star."""
        self._title.setText(f"<b>{self.name}</b>{' ★' if fastest else ''}")
        self._title.setToolTip(
            translate(
                "SpiralPocket",
                "the fastest that keeps the limit of engagement on 99 % of the way and leaves "
                "nothing uncut",
            )
            if fastest
            else ""
        )

    def close(self) -> None:
        """Give the job up."""
        if self.job is not None:
            self.job.listeners.remove(self._hear)
            lanes.proofs.give_up(self.job)
        self.frame.deleteLater()

    def _hear(self, job: Job) -> None:
        if job.crash:
            FreeCAD.Console.PrintError(job.crash + "\n")
            self.text.setText(translate("SpiralPocket", "An error, see the Report view."))
        elif job.is_done:
            self._show(job.error or job.result)
        else:
            waiting = translate("SpiralPocket", "Planning... {:.0f} %")
            self.picture.setText(waiting.format(100 * job.fraction))

    def _show(self, outcome: Drawn | SpiralPocketError) -> None:
        if isinstance(outcome, SpiralPocketError):
            self.picture.setText(translate("SpiralPocket", "No path"))
            self.text.setText(in_panel(str(outcome)))
            return
        limit = float(np.degrees(outcome.plan.request.engagement_limit))
        scale = Scale("engagement", min(180.0, OVER_LIMIT * limit), limit)
        fineness = self.picture.devicePixelRatioF()
        self.picture.setPixmap(picture_of(outcome, scale, PICTURE, theme(), fineness))
        self.text.setText(_figures(outcome))
        report = outcome.plan.report
        self.seconds = report.time
        passes = _passes(report.engagement_p99, report.engagement_limit)  # corners peak in all
        self.is_sound = not passes and not uncut_of([outcome.plan])
        self.button.setEnabled(self._choose is not None)
        self._changed()


def _figures(drawn: Drawn) -> str:
    """Return the figures of a plan as a table."""
    report = drawn.plan.report
    limit = report.engagement_limit
    uncut = area(report.uncut_area)
    figures = [
        (translate("SpiralPocket", "Time"), f"<b>{_seconds(report.time)}</b>"),
        (translate("SpiralPocket", "Cutting length"), length(report.cut_length)),
        (translate("SpiralPocket", "Largest engagement"), _angle(report.engagement_max, limit)),
        (translate("SpiralPocket", "99 % of it below"), _angle(report.engagement_p99, limit)),
        (
            translate("SpiralPocket", "Mean engagement"),
            f"{np.degrees(report.engagement_mean):.0f}°",
        ),
        (
            translate("SpiralPocket", "Left uncut in reach"),
            alarming(uncut) if uncut_of([drawn.plan]) else uncut,
        ),
    ]
    return as_table(figures)


def _seconds(time: float) -> str:
    """Return a time so fine that short ones can be told apart."""
    return f"{decimal(time, 1)} s" if time < 60 else duration(time)


def _angle(angle: float, limit: float) -> str:
    """Return an engagement angle, colored if it clearly passes the limit."""
    text = f"{np.degrees(angle):.0f}°"
    return alarming(text) if _passes(angle, limit) else text


def _passes(angle: float, limit: float) -> bool:
    """Return whether an engagement angle clearly passes the limit, as it is shown: in degrees."""
    return round(np.degrees(angle)) > np.degrees(over_limit(limit))
