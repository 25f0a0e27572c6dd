# SPDX-License-Identifier: LGPL-2.1-or-later
"""All strategies, and FreeCAD's own Adaptive, side by side on one pocket.

Each is planned beside the window and shown as soon as it is proved; closing the
window ends what is still under way. A strategy that is chosen is set in the panel,
whose preview then has its path already.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ...engine.model import PocketRequest, Strategy
from ..qt.names import forget_namesakes
from ..texts.measures import area
from .card import PICTURE, Card

translate = FreeCAD.Qt.translate

COLUMNS = 3
#: What the system draws around a window at most, in pixels.
FRAME = QtCore.QSize(16, 48)


def screen_size() -> QtCore.QSize:
    """Return how much room windows have on the screen that FreeCAD is on."""
    screen = FreeCADGui.getMainWindow().windowHandle().screen()
    return screen.availableGeometry().size()


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
        size = QtCore.QSize(60 + columns * (PICTURE.width() + 30), 110 + 350 * rows)
        self.dialog.resize(size.boundedTo(screen_size() - FRAME))

    def show(self, pockets: Sequence[tuple[str, PocketRequest]]) -> None:
        """Compare on one of these pockets, at first the largest; begin anew if it is another.

        Each comes with what its floor is called.
        """
        requests = [request for _, request in pockets]
        if requests == self._requests and self._is_begun:
            return
        self._requests, self._is_begun = requests, True
        blocker = QtCore.QSignalBlocker(self.pocket)
        chosen = self.pocket.currentIndex()
        self.pocket.clear()
        for number, (label, request) in enumerate(pockets, start=1):
            text = translate("SpiralPocket", "Pocket {} ({}), {}")
            self.pocket.addItem(text.format(number, label, area(request.pocket.area)))
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
                "what clearly passes it, or stays uncut, is red. ★ the fastest that keeps it on "
                "99 % of the way and leaves nothing uncut.",
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
        """Mark the fastest of those that keep the limit and cut all, if any does."""
        sound = [c for c in self.cards if c.is_sound]
        least = min((c.seconds for c in sound), default=None)
        for card in self.cards:
            card.emphasize(card in sound and card.seconds == least)

    def _end(self) -> None:
        """Give up all jobs and take the cards away."""
        for card in self.cards:
            card.close()
        self.cards = []
        while self._grid.count():
            self._grid.takeAt(0)
