# SPDX-License-Identifier: LGPL-2.1-or-later
"""All strategies, and FreeCAD's own Adaptive, side by side on one pocket.

Each is planned beside the window and shown as soon as it is proved; closing the
window ends what is still under way. A strategy that is chosen is set in the panel,
whose preview then has its path already.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ..beside.tasks import Drawn
from ..engine.errors import SpiralPocketError
from ..engine.model import PocketRequest, Strategy
from . import planning
from .comparepicture import picture_of
from .lane import Job
from .localized import in_panel
from .names import forget_namesakes
from .outlook import Outlook
from .previewcolors import OVER_LIMIT, Scale
from .resulttext import area, as_table, decimal, duration, length, small
from .themecolors import theme

translate = FreeCAD.Qt.translate

PICTURE = QtCore.QSize(250, 170)
COLUMNS = 3
OVER = "#d9432f"  # what clearly passes the limit is written in this color


class Compare:
    """An extra of the panel: the button, and the window that it opens."""

    def __init__(self, page: Any) -> None:
        self._page = page
        self._outlook = Outlook.of(page)
        self.window: Comparison | None = None
        self.button = QtGui.QPushButton(translate("SpiralPocket", "Compare..."))
        self.button.setToolTip(translate("SpiralPocket", "All strategies side by side"))
        self.button.clicked.connect(self._open)
        self._outlook.listeners.append(self._update)
        page.compare = self

    def widget(self) -> None:
        """Return nothing: the button stands in the result box."""
        self._page.result_box.buttons.addWidget(self.button)

    def changed(self) -> None:
        """Wait for the outlook."""

    computed = changed

    def close(self) -> None:
        """Close the window."""
        window, self.window = self.window, None
        if window is not None:
            window.close_for_good()

    def _open(self, *_: Any) -> None:
        self.close()
        self.window = Comparison(self._page.form.strategy)
        self.window.dialog.show()
        self._update()

    def _update(self) -> None:
        if self.window is not None:
            self.window.show([p.request for p in self._outlook.pockets])


class Comparison:
    """The window; `strategies` is the panel's combo box."""

    def __init__(self, strategies: Any) -> None:
        self._strategies = strategies
        self._requests: list[PocketRequest] = []
        self._is_begun = False
        self.cards: list[Card] = []
        self.dialog = QtGui.QDialog(FreeCADGui.getMainWindow())
        self.dialog.setObjectName("SpiralPocketCompare")
        self.dialog.setWindowTitle(translate("SpiralPocket", "Compare strategies"))
        self.pocket = QtGui.QComboBox()
        self.pocket.currentIndexChanged.connect(lambda *_: self._begin())
        self.heading = QtGui.QLabel()
        self.heading.setWordWrap(True)
        self._grid = QtGui.QGridLayout()
        scroll, inside = QtGui.QScrollArea(), QtGui.QWidget()
        inside.setLayout(self._grid)
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QtGui.QFrame.NoFrame)
        scroll.setWidget(inside)
        buttons = QtGui.QDialogButtonBox(QtGui.QDialogButtonBox.Close)
        buttons.rejected.connect(self.dialog.reject)
        layout = QtGui.QVBoxLayout(self.dialog)
        for widget in (self.pocket, self.heading, scroll, buttons):
            layout.addWidget(widget)
        self.dialog.finished.connect(lambda *_: self._end())
        columns = min(COLUMNS, len(Strategy) + 1)
        rows = -(-(len(Strategy) + 1) // columns)
        self.dialog.resize(60 + columns * (PICTURE.width() + 30), min(860, 110 + 350 * rows))

    def show(self, requests: list[PocketRequest]) -> None:
        """Compare on one of these pockets, at first the largest; begin anew if it is another."""
        if requests == self._requests and self._is_begun:
            return
        self._requests, self._is_begun = requests, True
        blocker = QtCore.QSignalBlocker(self.pocket)
        chosen = self.pocket.currentIndex()
        self.pocket.clear()
        for number, request in enumerate(requests, start=1):
            text = translate("SpiralPocket", "Pocket {}, {}")
            self.pocket.addItem(text.format(number, area(request.pocket.area)))
        largest = int(np.argmax([r.pocket.area for r in requests])) if requests else -1
        self.pocket.setCurrentIndex(chosen if 0 <= chosen < len(requests) else largest)
        self.pocket.setVisible(len(requests) > 1)
        blocker.unblock()
        self._begin()

    def close_for_good(self) -> None:
        """End what is under way and give up the window."""
        self._end()
        self.dialog.close()
        self.dialog.setParent(None)
        self.dialog.deleteLater()

    def _begin(self) -> None:
        self._end()
        index = self.pocket.currentIndex()
        if not 0 <= index < len(self._requests):
            self.heading.setText(
                translate("SpiralPocket", "No pocket: the first line of the panel says why.")
            )
            return
        request = self._requests[index]
        machine = translate("SpiralPocket", request.machine.name)
        self.heading.setText(
            translate(
                "SpiralPocket",
                "With the same cutter, step-over and feeds on {}. Limit of engagement {:.0f}°; "
                "what clearly passes it is red. ★ the fastest that keeps it.",
            ).format(machine, np.degrees(request.engagement_limit))
        )
        for at in range(self._strategies.count()):
            strategy = Strategy(self._strategies.itemData(at))
            self._add(
                Card(
                    self._strategies.itemText(at),
                    "plan",
                    replace(request, strategy=strategy),
                    lambda i=at: self._strategies.setCurrentIndex(i),
                    self._mark_fastest,
                )
            )
        name = translate("SpiralPocket", "FreeCAD's Adaptive")
        self._add(Card(name, "adaptive", request, None, self._mark_fastest))
        forget_namesakes()
        for card in self.cards:
            card.begin()

    def _add(self, card: Card) -> None:
        self._grid.addWidget(card.frame, *divmod(len(self.cards), COLUMNS))
        self.cards.append(card)

    def _mark_fastest(self) -> None:
        """Mark the fastest of those that keep the limit, if any does."""
        done = [c for c in self.cards if c.seconds is not None]
        fair = [c for c in done if c.keeps_limit] or done
        for card in self.cards:
            card.emphasize(card in fair and card.seconds == min(c.seconds for c in fair))

    def _end(self) -> None:
        """Give up all jobs and take the cards away."""
        for card in self.cards:
            card.close()
        self.cards = []
        while self._grid.count():
            self._grid.takeAt(0)


class Card:
    """One way to cut the pocket: picture, figures, and a button to take it."""

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
        self.keeps_limit = False
        self._task, self._request, self._changed = task, request, changed
        self._job: Job | None = None
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
        known = planning.known(self._request) if is_plan else None
        if known is not None:
            self._show(known)
            return
        submit = planning.prove if is_plan else lambda r: planning.proofs.submit(self._task, r)
        self._job = submit(self._request)
        self._job.listeners.append(self._hear)
        self._hear(self._job)

    def emphasize(self, fastest: bool) -> None:
        """Write the name, of the fastest with a star."""
        self._title.setText(f"<b>{self.name}</b>{' ★' if fastest else ''}")
        self._title.setToolTip(
            translate("SpiralPocket", "the fastest that keeps the limit of engagement")
            if fastest
            else ""
        )

    def close(self) -> None:
        """Give the job up."""
        if self._job is not None:
            self._job.listeners.remove(self._hear)
            planning.proofs.give_up(self._job)
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
        self.keeps_limit = not _passes(report.engagement_p99, report.engagement_limit)
        self.button.setEnabled(self._choose is not None)
        self._changed()


def _figures(drawn: Drawn) -> str:
    """Return the figures of a plan as a table."""
    report = drawn.plan.report
    limit = report.engagement_limit
    figures = [
        (translate("SpiralPocket", "Time"), f"<b>{_seconds(report.time)}</b>"),
        (translate("SpiralPocket", "Cutting length"), length(report.cut_length)),
        (translate("SpiralPocket", "Largest engagement"), _angle(report.engagement_max, limit)),
        (translate("SpiralPocket", "99 % of it below"), _angle(report.engagement_p99, limit)),
        (
            translate("SpiralPocket", "Mean engagement"),
            f"{np.degrees(report.engagement_mean):.0f}°",
        ),
        (translate("SpiralPocket", "Left uncut in reach"), small(report.uncut_area, power=2)),
    ]
    return as_table(figures)


def _seconds(time: float) -> str:
    """Return a time so fine that short ones can be told apart."""
    return f"{decimal(time, 1)} s" if time < 60 else duration(time)


def _angle(angle: float, limit: float) -> str:
    """Return an engagement angle, colored if it clearly passes the limit."""
    text = f"{np.degrees(angle):.0f}°"
    return f'<span style="color:{OVER}">{text}</span>' if _passes(angle, limit) else text


def _passes(angle: float, limit: float) -> bool:
    """Return whether an engagement angle clearly passes the limit."""
    from ..engine.proof.findings import over_limit  # needs shapely

    return angle > over_limit(limit)
