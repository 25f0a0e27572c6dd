# SPDX-License-Identifier: LGPL-2.1-or-later
"""A toolpath: the ordered moves of the cutter center, as arrays.

One row per move. A move goes from where the last one ended (the first from
`start`) to `points[i]`, straight or along an arc about a vertical axis of at
most half a turn, climbing or sinking evenly. Arrays instead of move objects
keep the proof and the machine-time model vectorised over 10^5 moves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from .arcs import fit_arcs
from .model import Floats


class Kind(IntEnum):
    """Shape of a move; the names follow G0, G1, G2 and G3."""

    RAPID = 0
    LINE = 1
    ARC_CW = 2
    ARC_CCW = 3


class Role(IntEnum):
    """What a move is for."""

    AIR = 0  # above the stock, at rapid rate
    ENTRY = 1  # into the stock
    CUT = 2  # clearing
    FINISH = 3  # the closing lap along a wall
    LINK = 4  # at depth, through cleared ground


@dataclass(frozen=True, slots=True, eq=False)
class Toolpath:
    """Moves of the cutter center.

    Attributes
    ----------
    start : ndarray of shape (3,)
        Where the first move begins [mm].
    kinds, roles : ndarray of int8, shape (n,)
        `Kind` and `Role` of each move.
    points : ndarray of shape (n, 3)
        Where each move ends [mm].
    centers : ndarray of shape (n, 2)
        Center of each arc [mm]; nan for straight moves.
    feeds : ndarray of shape (n,)
        Programmed speed [mm/s]; the rapid rate for rapids.
    """

    start: Floats
    kinds: NDArray[np.int8]
    roles: NDArray[np.int8]
    points: Floats
    centers: Floats
    feeds: Floats

    def __len__(self) -> int:
        """Return the number of moves."""
        return len(self.kinds)

    @property
    def starts(self) -> Floats:
        """Return where each move begins, shape (n, 3) [mm]."""
        return np.vstack([self.start[None, :], self.points])[:-1]

    @property
    def is_arc(self) -> NDArray[np.bool_]:
        """Return which moves are arcs, shape (n,)."""
        return self.kinds >= Kind.ARC_CW

    @property
    def sweeps(self) -> Floats:
        """Return the signed angle of each arc [rad], counter-clockwise positive; 0 for lines.

        In ``(0, 2 pi)`` by magnitude: an arc that ends where it begins is no move.
        """
        a = self.starts[:, :2] - self.centers
        b = self.points[:, :2] - self.centers
        turn = np.arctan2(b[:, 1], b[:, 0]) - np.arctan2(a[:, 1], a[:, 0])
        ccw = np.mod(turn, 2 * np.pi)
        sweep = np.where(self.kinds == Kind.ARC_CCW, ccw, ccw - 2 * np.pi)
        return np.where(self.is_arc, sweep, 0.0)

    @property
    def lengths(self) -> Floats:
        """Return the length of each move, shape (n,) [mm]."""
        d = self.points - self.starts
        flat = np.hypot(d[:, 0], d[:, 1])
        radii = np.hypot(*(self.points[:, :2] - self.centers).T)
        flat = np.where(self.is_arc, radii * np.abs(self.sweeps), flat)
        return np.hypot(flat, d[:, 2])

    def mirrored(self) -> Toolpath:
        """Return the toolpath with X reversed: climb becomes conventional."""
        turned = {int(Kind.ARC_CW): Kind.ARC_CCW, int(Kind.ARC_CCW): Kind.ARC_CW}
        kinds = np.array([turned.get(k, k) for k in self.kinds.tolist()], np.int8)
        return replace(
            self,
            start=self.start * (-1, 1, 1),
            kinds=kinds,
            points=self.points * (-1, 1, 1),
            centers=self.centers * (-1, 1),
        )


class ToolpathBuilder:
    """Collects moves one after the other; skips those that go nowhere."""

    #: Shorter moves are dropped [mm]: posts round to 3 or 4 decimals, and a move of no length
    #: upsets dressups and controllers.
    SHORTEST = 1e-4

    def __init__(self, start: Sequence[float]) -> None:
        self._start = np.array(start, float)
        self._here = self._start.copy()
        self._rows: list[tuple[int, int, float, float, float, float, float, float]] = []

    def __len__(self) -> int:
        """Return the number of moves so far."""
        return len(self._rows)

    @property
    def here(self) -> Floats:
        """Return where the cutter is now, shape (3,) [mm]."""
        return self._here.copy()

    def _add(self, kind: Kind, role: Role, point: Floats, center: Floats, feed: float) -> None:
        if np.linalg.norm(point - self._here) < self.SHORTEST:
            return
        self._rows.append((int(kind), int(role), *point, *center, float(feed)))
        self._here = point

    def rapid(
        self,
        feed: float,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
    ) -> None:
        """Move at the rapid rate `feed` [mm/s]; a coordinate not given stays."""
        point = np.array(
            [h if v is None else v for h, v in zip(self._here, (x, y, z), strict=True)], float
        )
        self._add(Kind.RAPID, Role.AIR, point, np.full(2, np.nan), feed)

    def line(self, point: Sequence[float], feed: float, role: Role) -> None:
        """Move straight to `point`, (x, y, z) [mm], at `feed` [mm/s]."""
        self._add(Kind.LINE, role, np.array(point, float), np.full(2, np.nan), feed)

    def along(self, points: Floats, z: float, feed: float, role: Role, tolerance: float) -> None:
        """Move along `points`, shape (n, 2) [mm], at height `z`, in lines and arcs.

        They keep within `tolerance` [mm] of the polyline from here on.
        """
        points = np.vstack([self._here[:2], points])
        apart = np.hypot(*np.diff(points, axis=0).T) > self.SHORTEST
        points = points[np.concatenate([[True], apart])]
        if len(points) < 2:
            return
        fitted = fit_arcs(points, tolerance)
        for end, center, ccw in zip(fitted.ends, fitted.centers, fitted.ccw, strict=True):
            if np.isnan(center[0]):
                self.line((*points[end], z), feed, role)
            else:
                self.arc((*points[end], z), center, bool(ccw), feed, role)

    def arc(
        self,
        point: Sequence[float],
        center: Sequence[float] | Floats,
        ccw: bool,
        feed: float,
        role: Role,
    ) -> None:
        """Move along an arc of at most half a turn about `center`, (x, y) [mm]."""
        kind = Kind.ARC_CCW if ccw else Kind.ARC_CW
        self._add(kind, role, np.array(point, float), np.array(center, float), feed)

    def build(self) -> Toolpath:
        """Return the collected moves."""
        rows = np.array(self._rows, float).reshape(-1, 8)
        return Toolpath(
            start=self._start,
            kinds=rows[:, 0].astype(np.int8),
            roles=rows[:, 1].astype(np.int8),
            points=rows[:, 2:5].copy(),
            centers=rows[:, 5:7].copy(),
            feeds=rows[:, 7].copy(),
        )
