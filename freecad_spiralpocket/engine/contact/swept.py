# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ground a toolpath sweeps, as short straight and circular pieces in the order of time.

Engagement and proof ask one question over and over: which earlier motion passed
near this point, and how deep? `Pieces` answers it: every move below the top of the
stock, cut so that a piece is short (its bounding box is tight) and nearly flat (a
ramp becomes bands, each at its upper height, which never claims more cleared ground
than there is). Rapids are among them, marked: they must not cut and clear nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..model import Floats
from ..numerics.ragged import rows_of
from ..toolpath import Kind, Toolpath

#: Heights closer than this are one height [mm]: posts round to 3 decimals.
SAME_HEIGHT = 2e-3
#: A piece that rises or falls by less is level [mm], however short: a ramp along a bent line has
#: hundreds, which must not pass for as many levels.
LEVEL = 1e-6
#: A ramp is cut into bands of this share of a full axial depth.
RAMP_BAND = 1 / 32
#: Arcs are cut to at most this sweep [rad] and lines to this many cutter radii.
LONGEST_SWEEP = np.pi / 4
LONGEST_LINE = 8.0


@dataclass(frozen=True, slots=True, eq=False)
class Pieces:
    """Swept pieces in the order of time.

    Attributes
    ----------
    starts, ends : ndarray of shape (n, 2)
        [mm]
    bottoms : ndarray of shape (n, 2)
        Z at start and end [mm].
    heights : ndarray of shape (n,)
        Z down to which the piece clears all of its ground: the upper of its ends, the lower
        where it goes straight down [mm].
    moves : ndarray of int, shape (n,)
        The move each piece belongs to.
    rapid : ndarray of bool, shape (n,)
    centers : ndarray of shape (n, 2)
        Of arcs [mm]; nan for lines.
    radii, angles, sweeps : ndarray of shape (n,)
        Of arcs: radius [mm], start angle and signed sweep [rad]; 0 for lines.
    """

    starts: Floats
    ends: Floats
    bottoms: Floats
    heights: Floats
    moves: NDArray[np.int64]
    rapid: NDArray[np.bool_]
    centers: Floats
    radii: Floats
    angles: Floats
    sweeps: Floats

    def __len__(self) -> int:
        """Return the number of pieces."""
        return len(self.moves)

    @property
    def is_arc(self) -> NDArray[np.bool_]:
        """Return which pieces are arcs, shape (n,)."""
        return self.sweeps != 0.0

    @property
    def is_level(self) -> NDArray[np.bool_]:
        """Return which pieces stay at one height, shape (n,)."""
        return np.abs(self.bottoms[:, 1] - self.bottoms[:, 0]) < LEVEL

    @property
    def lengths(self) -> Floats:
        """Return the length in the plane, shape (n,) [mm]."""
        flat = np.hypot(*(self.ends - self.starts).T)
        return np.where(self.is_arc, self.radii * np.abs(self.sweeps), flat)

    @property
    def sags(self) -> Floats:
        """Return how far arcs rise above their chords, shape (n,) [mm]; 0 for lines."""
        return self.radii * (1 - np.cos(self.sweeps / 2))

    @property
    def bounds(self) -> Floats:
        """Return bounding boxes (xmin, ymin, xmax, ymax), shape (n, 4) [mm]."""
        sag = self.sags[:, None]
        low = np.minimum(self.starts, self.ends) - sag
        high = np.maximum(self.starts, self.ends) + sag
        return np.hstack([low, high])

    def select(self, chosen: NDArray[np.generic]) -> Pieces:
        """Return the chosen pieces (indices or a mask), in their order."""
        return Pieces(*(getattr(self, name)[chosen] for name in self.__slots__))

    def positions(self, index: NDArray[np.int64], fraction: Floats) -> Floats:
        """Return where the cutter center is at a fraction in [0, 1] of pieces, shape (k, 2)."""
        a, b = self.starts[index], self.ends[index]
        straight = a + fraction[:, None] * (b - a)
        turn = self.angles[index] + fraction * self.sweeps[index]
        spoke = self.radii[index, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1)
        return np.where(self.is_arc[index, None], self.centers[index] + spoke, straight)

    def directions(self, index: NDArray[np.int64], fraction: Floats) -> Floats:
        """Return the direction of travel at a fraction of pieces, shape (k,) [rad]."""
        d = self.ends[index] - self.starts[index]
        turn = self.angles[index] + fraction * self.sweeps[index]
        around = turn + np.copysign(np.pi / 2, self.sweeps[index])
        return np.where(self.is_arc[index], around, np.arctan2(d[:, 1], d[:, 0]))


def cut_into_pieces(
    toolpath: Toolpath, cutter_radius: float, top: float, axial_depth: float
) -> Pieces:
    """Cut the moves below `top` into pieces.

    Parameters
    ----------
    toolpath : Toolpath
    cutter_radius : float
        [mm], sets the length of the longest piece.
    top : float
        Z of the top of the stock [mm]; what does not go below it cuts nothing.
    axial_depth : float
        Axial depth of a full cut [mm], sets the bands of ramps.

    Returns
    -------
    Pieces
        Moves straight down become pieces of no length.
    """
    starts, ends = toolpath.starts, toolpath.points
    low = np.minimum(starts[:, 2], ends[:, 2])
    cutting = np.flatnonzero(low < top - SAME_HEIGHT)
    a, b = starts[cutting], ends[cutting]
    arc, sweeps = toolpath.is_arc[cutting], toolpath.sweeps[cutting]
    centers = toolpath.centers[cutting]
    spokes = a[:, :2] - centers
    radii = np.where(arc, np.hypot(spokes[:, 0], spokes[:, 1]), 0.0)
    angles = np.where(arc, np.arctan2(spokes[:, 1], spokes[:, 0]), 0.0)
    flat = np.where(arc, 0.0, np.hypot(*(b - a)[:, :2].T))
    moving = arc | (flat > 0)
    ramp = np.where(moving, np.abs(b[:, 2] - a[:, 2]), 0.0)
    n = np.maximum.reduce(
        [
            np.ceil(ramp / (RAMP_BAND * axial_depth) - 1e-6),
            np.ceil(np.abs(sweeps) / LONGEST_SWEEP - 1e-6),
            np.ceil(flat / (LONGEST_LINE * cutter_radius) - 1e-6),
            np.ones(len(cutting)),
        ]
    ).astype(np.int64)
    row, part = rows_of(n)
    f0, f1 = part / n[row], (part + 1) / n[row]
    whole = Pieces(
        starts=a[row, :2],
        ends=b[row, :2],
        bottoms=np.stack([a[row, 2] + f * (b[row, 2] - a[row, 2]) for f in (f0, f1)], axis=1),
        heights=np.zeros(len(row)),
        moves=cutting[row],
        rapid=toolpath.kinds[cutting[row]] == Kind.RAPID,
        centers=centers[row],
        radii=radii[row],
        angles=angles[row],
        sweeps=sweeps[row],
    )
    every = np.arange(len(row))
    pieces = Pieces(
        starts=whole.positions(every, f0),
        ends=whole.positions(every, f1),
        bottoms=whole.bottoms,
        heights=np.where(moving[row], whole.bottoms.max(axis=1), whole.bottoms.min(axis=1)),
        moves=whole.moves,
        rapid=whole.rapid,
        centers=whole.centers,
        radii=whole.radii,
        angles=whole.angles + f0 * whole.sweeps,
        sweeps=whole.sweeps / n[row],
    )
    return pieces.select(pieces.bottoms.min(axis=1) < top - SAME_HEIGHT)
