# SPDX-License-Identifier: LGPL-2.1-or-later
"""A dock with plots along the time: engagement, feed, velocity, force.

A line follows the mouse through all of them while the cutter stands on the part where
it is at that time. The dock belongs to the panel and goes with it. Drawn by matplotlib,
FreeCAD's own; imported when the dock opens.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ...engine.errors import SetupError
from ..compat import chinese_fonts
from ..qt.names import forget_namesakes
from ..qt.theme import theme
from ..texts.measures import decimal, feed_unit
from .curves import MATERIAL, Curves

translate = FreeCAD.Qt.translate

NAME = "SpiralPocketPlots"
LINE, SECOND, LIMIT = "#3b8ee0", "#e08a2e", "#d9432f"
HEIGHT = 280  # pixels, when it opens


class PlotDock:
    """The dock.

    Parameters
    ----------
    hovered : callable
        Called with the time under the mouse [s], None when it leaves the plots.

    Raises
    ------
    SetupError
        If matplotlib is missing.
    """

    def __init__(self, hovered: Callable[[float | None], None]) -> None:
        try:
            from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
            from matplotlib.figure import Figure
        except ImportError as error:
            raise SetupError(
                translate("SpiralPocket", "Plots need the Python library matplotlib."),
                translate("SpiralPocket", "Install it with the Addon Manager or pip."),
            ) from error
        self._hovered = hovered
        self._curves: Curves | None = None
        self._background: Any = None
        self._figure = Figure(layout="constrained")
        self.canvas = FigureCanvasQTAgg(self._figure)
        self.dock = QtGui.QDockWidget(
            translate("SpiralPocket", "Spiral Pocket plots"), FreeCADGui.getMainWindow()
        )
        self.dock.setObjectName(NAME)
        self.dock.setWidget(self.canvas)
        self.canvas.setMinimumHeight(HEIGHT - 100)
        self.canvas.mpl_connect("draw_event", self._drawn)
        self.canvas.mpl_connect("motion_notify_event", self._moved)
        self.canvas.mpl_connect("axes_leave_event", lambda event: self.point_at(None))
        window = FreeCADGui.getMainWindow()
        window.addDockWidget(QtCore.Qt.BottomDockWidgetArea, self.dock)
        window.resizeDocks([self.dock], [HEIGHT], QtCore.Qt.Vertical)
        forget_namesakes()

    def show(self, curves: Curves | None) -> None:
        """Draw curves, or nothing."""
        self._curves = curves
        self._figure.clear()
        worn = theme()
        text, background = worn.text.name(), worn.background.name()
        self._figure.set_facecolor(background)
        self._lines: list[Any] = []
        self._note: Any = None
        with _lettering():
            if curves is not None:
                self._plot(curves, text, background)
            else:
                nothing = translate(
                    "SpiralPocket", "No path: the first line of the panel says why."
                )
                self._figure.text(0.5, 0.5, nothing, color=text, ha="center", va="center")
        self._background = None
        self.canvas.draw_idle()

    def close(self) -> None:
        """Take the dock away."""
        self._hovered = lambda seconds: None
        FreeCADGui.getMainWindow().removeDockWidget(self.dock)
        self.dock.setParent(None)
        self.dock.deleteLater()

    def point_at(self, seconds: float | None) -> None:
        """Move the line to a time, and the cutter."""
        self._hovered(seconds)
        if self._background is None or self._curves is None:
            return
        self.canvas.restore_region(self._background)
        if seconds is not None:
            for line in self._lines:
                line.set_xdata([seconds, seconds])
                line.axes.draw_artist(line)
            self._note.set_text(self._values_at(seconds))
            self._note.axes.draw_artist(self._note)
        self.canvas.blit(self._figure.bbox)

    def _plot(self, curves: Curves, text: str, background: str) -> None:
        factor, unit = feed_unit()
        rows = [
            (translate("SpiralPocket", "Engagement [°]"), curves.engagement),
            (translate("SpiralPocket", "Programmed feed [{}]").format(unit), curves.feed / factor),
            (
                translate("SpiralPocket", "The machine's velocity [{}]").format(unit),
                curves.velocity / factor,
            ),
        ]
        if curves.force is not None:
            force = translate("SpiralPocket", "Mean cutting force in {} [N]")
            rows.append((force.format(translate("SpiralPocket", MATERIAL)), curves.force))
        all_axes = self._figure.subplots(2, 2, sharex=True).ravel(order="F")
        for unused in all_axes[len(rows) :]:
            unused.set_axis_off()
        for axes, (label, values) in zip(all_axes, rows, strict=False):
            axes.plot(curves.clock, values, color=LINE, lw=0.8)
            axes.set_facecolor(background)
            axes.set_title(label, color=text, fontsize="small", loc="left", pad=3)
            axes.tick_params(colors=text, labelsize="small")
            axes.grid(color=text, alpha=0.15)
            axes.set_ylim(0, None)
            for axis in (axes.xaxis, axes.yaxis):
                axis.set_major_formatter(_tick)
            for side in axes.spines.values():
                side.set_color(text)
                side.set_alpha(0.4)
            self._lines.append(axes.axvline(0, color=SECOND, lw=1, animated=True))
        all_axes[0].axhline(curves.limit, color=LIMIT, lw=1, ls="--")
        top = max(float(np.nanmax(curves.engagement, initial=0.0)), curves.limit)
        all_axes[0].set_ylim(0, min(185.0, 1.15 * top))
        all_axes[0].set_xlim(0, float(curves.clock[-1]))
        for axes in all_axes[1 : len(rows) : 2]:
            axes.set_xlabel(translate("SpiralPocket", "Time [s]"), color=text, fontsize="small")
        if curves.force is None:
            all_axes[2].tick_params(labelbottom=True)
            all_axes[3].text(
                0.0, 0.9, translate("SpiralPocket", "No force: no spindle speed in the tool "
                "controller"), transform=all_axes[3].transAxes, color=text, va="top",
                fontsize="small",
            )  # fmt: skip
        self._note = all_axes[0].text(
            1.0, 1.04, "", transform=all_axes[0].transAxes, color=text, animated=True,
            ha="right", va="bottom", fontsize="small",
            bbox={"facecolor": background, "edgecolor": "none", "pad": 1.0},
        )  # fmt: skip

    def _values_at(self, seconds: float) -> str:
        """Return the values at a time, as they are written beside the line."""
        curves = self._curves
        assert curves is not None
        at = min(int(np.searchsorted(curves.clock, seconds)), len(curves.clock) - 1)
        texts = [f"{decimal(seconds, 1)} s", f"{np.nan_to_num(curves.engagement[at]):.0f}°"]
        factor, unit = feed_unit()
        texts.append(f"{curves.velocity[at] / factor:.0f} {unit}")
        if curves.force is not None:
            texts.append(f"{np.nan_to_num(curves.force[at]):.0f} N")
        return "   ".join(texts)

    def _drawn(self, event: Any) -> None:
        """Keep the picture without the line, to draw it on."""
        self._background = self.canvas.copy_from_bbox(self._figure.bbox)

    def _moved(self, event: Any) -> None:
        if event.inaxes is not None and self._curves is not None:
            self.point_at(float(np.clip(event.xdata, 0.0, self._curves.clock[-1])))


def _lettering() -> Any:
    """Return the context in which texts are made that may be Chinese: matplotlib's font is not."""
    import matplotlib
    from matplotlib.font_manager import fontManager

    known = {font.name for font in fontManager.ttflist}
    others = [family for family in chinese_fonts() if family in known]
    return matplotlib.rc_context({"font.family": [*matplotlib.rcParams["font.family"], *others]})


def _tick(value: float, position: int | None = None) -> str:
    """Return a number at an axis with the user's decimal mark."""
    return f"{value:g}".replace(".", str(QtCore.QLocale().decimalPoint()))
