# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview's colors, for the part and for the legend alike.

A cut is colored by a quantity on a scale from blue over green to red; what is not cut
has one color each. All are bright enough for FreeCAD's dark background and dark
enough for its light one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ...engine.model import Floats
from ...engine.toolpath import Role

if TYPE_CHECKING:
    from ...trace import Trace

#: Colors of the scale at equal distances, red, green, blue in [0, 1]: matplotlib's turbo, without
#: its dark ends and with its bright middle darker, as yellow is not seen on a light part.
SCALE = np.array(
    [
        (0.27, 0.35, 0.86),
        (0.16, 0.60, 0.98),
        (0.08, 0.74, 0.70),
        (0.22, 0.78, 0.25),
        (0.62, 0.74, 0.05),
        (0.93, 0.62, 0.08),
        (0.96, 0.42, 0.10),
        (0.80, 0.13, 0.03),
    ]
)
ENTRY, LINK, AIR, DRAFT = (
    (0.93, 0.16, 0.66),
    (0.56, 0.46, 0.8),
    (0.62, 0.62, 0.62),
    (0.36, 0.6, 0.9),
)
CLEARED, LEFT, ISLAND, CUTTER = (
    (0.52, 0.62, 0.75),
    (0.92, 0.2, 0.16),
    (0.68, 0.5, 0.32),
    (0.95, 0.75, 0.2),
)

#: The scale of engagement reaches to this multiple of the limit: at the limit it is yellow, what is
#: red is overloaded.
OVER_LIMIT = 1.6


@dataclass(frozen=True)
class Scale:
    """What a color stands for.

    Attributes
    ----------
    quantity : str
        "engagement" [deg] or "feed".
    top : float
        Value of the last color; the first stands for 0.
    mark : float or None
        A value that is marked: the limit.
    unit : float
        What feeds are counted in [mm/min].
    """

    quantity: str
    top: float
    mark: float | None = None
    unit: float = 1.0

    def values(self, trace: Trace) -> Floats:
        """Return the quantity of each stretch of a trace."""
        if self.quantity == "engagement":
            return np.degrees(trace.angles)
        return trace.feeds * 60 / self.unit

    def colors(self, trace: Trace) -> Floats:
        """Return the color of each stretch, shape (n, 3)."""
        return colors_at(self.values(trace) / max(self.top, 1e-9))


def is_cut(trace: Trace) -> NDArray[np.bool_]:
    """Return which stretches are meant to cut, the entry apart."""
    return (trace.roles == Role.CUT) | (trace.roles == Role.FINISH)


def colors_at(shares: Floats) -> Floats:
    """Return the scale's colors at shares of it, shape (n, 3)."""
    places = np.linspace(0.0, 1.0, len(SCALE))
    return np.column_stack([np.interp(shares, places, channel) for channel in SCALE.T])


def packed(colors: Floats) -> NDArray[np.uint32]:
    """Return colors as Coin packs them, 0xRRGGBBAA, opaque."""
    r, g, b = (np.clip(colors, 0.0, 1.0) * 255).astype(np.uint32).T
    return (r << 24) | (g << 16) | (b << 8) | np.uint32(255)
