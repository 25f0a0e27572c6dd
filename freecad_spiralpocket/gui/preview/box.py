# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview's box in the panel: on or off, colors, legend, player, and how far it is."""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD
from PySide import QtCore, QtGui

from ..compat import check_box_signal, freecad_icon
from ..texts.measures import duration, feed_unit
from .legend import ColorBar, Swatches

translate = FreeCAD.Qt.translate

STEPS = 1000  # of the slider
FRAME = 40  # ms
PLAY, PAUSE = "\N{BLACK RIGHT-POINTING TRIANGLE}", "\N{HEAVY VERTICAL BAR}" * 2
PLAY_TIME = 12.0  # s, how long the whole cut plays


class PreviewBox(QtGui.QWidget):
    """The widgets; what they do is told to the callbacks.

    Parameters
    ----------
    switched : callable
        Called with whether the preview is wanted.
    colored : callable
        Called with the quantity, "engagement" or "feed".
    moved : callable
        Called with the share of the cut [0, 1] at which the slider is.
    """

    def __init__(
        self,
        switched: Callable[[bool], None],
        colored: Callable[[str], None],
        moved: Callable[[float], None],
    ) -> None:
        super().__init__()
        self.setWindowTitle(translate("SpiralPocket", "Preview"))
        self.setWindowIcon(QtGui.QIcon(freecad_icon("Simulator")))
        self.setObjectName("SpiralPocketPreviewBox")
        self._total, self._is_known = 0.0, False
        self.live = QtGui.QCheckBox(translate("SpiralPocket", "Live"))
        self.live.setToolTip(translate("SpiralPocket", "Draw the path anew while values change"))
        self.live.setChecked(True)
        self.quantity = QtGui.QComboBox()
        self.quantity.addItem(translate("SpiralPocket", "Engagement [°]"), "engagement")
        feed = translate("SpiralPocket", "Feed [{}]").format(feed_unit()[1])
        self.quantity.addItem(feed, "feed")
        self.quantity.setToolTip(translate("SpiralPocket", "What the colors of the cut show"))
        self.quantity.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToContents)
        self.bar = ColorBar()
        self.play = QtGui.QToolButton()
        self.play.setCheckable(True)
        self.play.setMinimumWidth(2 * self.play.fontMetrics().height())
        self.play.setToolTip(translate("SpiralPocket", "Play the cut"))
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setRange(0, STEPS)
        self.slider.setValue(STEPS)
        self.slider.setToolTip(translate("SpiralPocket", "How far the cut is shown"))
        for widget in (self.quantity, self.play, self.slider):  # which have no words of their own
            widget.setAccessibleName(widget.toolTip())
        self.clock = QtGui.QLabel()
        self.status = QtGui.QLabel()
        self.status.setWordWrap(True)
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._advance)
        self._lay_out()
        self._show_playing(False)
        check_box_signal(self.live).connect(lambda *_: switched(self.live.isChecked()))
        self.quantity.currentIndexChanged.connect(lambda *_: colored(self.quantity.currentData()))
        self.slider.valueChanged.connect(lambda value: self._move(value, moved))
        self.play.toggled.connect(self._show_playing)

    def set_total(self, seconds: float, *, is_known: bool = True) -> None:
        """Show how long the whole cut takes, if that is known; 0 greys the player."""
        self._total, self._is_known = seconds, is_known
        for widget in (self.play, self.slider):
            widget.setEnabled(seconds > 0)
        if not seconds:
            self.play.setChecked(False)
        self._show_clock()

    @property
    def share(self) -> float:
        """Return the share of the cut at which the slider is, in [0, 1]."""
        return self.slider.value() / STEPS

    def _lay_out(self) -> None:
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        top, player = QtGui.QHBoxLayout(), QtGui.QHBoxLayout()
        top.addWidget(self.live)
        top.addWidget(self.quantity, 1)  # without a label: a panel may be narrow
        for widget in (self.play, self.slider, self.clock):
            player.addWidget(widget)
        layout.addLayout(top)
        layout.addWidget(self.bar)
        layout.addWidget(Swatches())
        layout.addLayout(player)
        layout.addWidget(self.status)

    def _move(self, value: int, moved: Callable[[float], None]) -> None:
        self._show_clock()
        moved(value / STEPS)

    def _show_clock(self) -> None:
        if self._total and self._is_known:
            self.clock.setText(f"{duration(self.share * self._total) if self.share else '0 s'}")
        else:
            self.clock.setText("")

    def _show_playing(self, plays: bool) -> None:
        self.play.setText(PAUSE if plays else PLAY)  # not the style's icons: black in dark themes
        if plays:
            if self.slider.value() == STEPS:
                self.slider.setValue(0)
            self._timer.start(FRAME)
        else:
            self._timer.stop()

    def _advance(self) -> None:
        step = round(STEPS * FRAME / 1000 / PLAY_TIME)
        self.slider.setValue(min(STEPS, self.slider.value() + step))
        if self.slider.value() == STEPS:
            self.play.setChecked(False)
