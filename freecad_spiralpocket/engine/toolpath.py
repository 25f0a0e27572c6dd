# SPDX-License-Identifier: LGPL-2.1-or-later
"""A toolpath: the ordered moves of the cutter center, as arrays.

One row per move. A move goes from where the last one ended (the first from
`start`) to `points[i]`, straight or along an arc about a vertical axis of at
most half a turn, climbing or sinking evenly. Arrays instead of move objects
keep the proof and the machine-time model vectorised over 10^5 moves.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from .model import Floats
from .shapes.arcs import fit_arcs


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


@dataclass(frozen=True, slots=True, eq=False)
class _Way:
    """A polyline (n, 3) [mm], whose first point is where the cutter was before."""

    points: Floats
    feed: float
    role: Role
    tolerance: float


#: One move: kind, role, point, center, feed.
_Row: TypeAlias = tuple[int, int, float, float, float, float, float, float]


class ToolpathBuilder:
    """Collects moves one after the other; skips those that go nowhere.

    Polylines become lines and arcs all at once, when the path is built.
    """

    #: Shorter moves are dropped [mm]: posts round to 3 or 4 decimals, and a move of no length
    #: upsets dressups and controllers.
    SHORTEST = 1e-4

    def __init__(self, start: Sequence[float]) -> None:
        self._start = np.array(start, float)
        self._here = self._start.copy()
        self._entries: list[_Row | _Way] = []

    def __len__(self) -> int:
        """Return the number of entries so far: moves, and polylines that are several moves."""
        return len(self._entries)

    @property
    def here(self) -> Floats:
        """Return where the cutter is now, shape (3,) [mm]."""
        return self._here.copy()

    def _add(self, kind: Kind, role: Role, point: Floats, center: Floats, feed: float) -> None:
        if math.dist(point, self._here) < self.SHORTEST:
            return
        self._entries.append((int(kind), int(role), *point, *center, float(feed)))
        self._here = point

    def rapid(
        self,
        feed: float,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
    ) -> None:
        """Move to (x, y, z) [mm] at the rapid rate `feed` [mm/s]; a coordinate not given stays."""
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
        self.along_slope(np.column_stack([points, np.full(len(points), z)]), feed, role, tolerance)

    def along_slope(self, points: Floats, feed: float, role: Role, tolerance: float) -> None:
        """Move along `points`, shape (n, 3) [mm], level or of an even slope, in lines and arcs.

        Seen from above they keep within `tolerance` [mm] of the polyline from here on.
        """
        points = np.vstack([self._here, points])
        apart = np.hypot(*np.diff(points[:, :2], axis=0).T) > self.SHORTEST
        points = points[np.concatenate([[True], apart])]
        if len(points) < 2:
            return
        self._entries.append(_Way(points, float(feed), role, tolerance))
        self._here = points[-1]

    def arc(
        self,
        point: Sequence[float] | Floats,
        center: Sequence[float] | Floats,
        ccw: bool,
        feed: float,
        role: Role,
    ) -> None:
        """Move along an arc of at most half a turn, evenly up or down.

        Parameters
        ----------
        point : sequence of float
            Its end (x, y, z) [mm].
        center : sequence of float
            (x, y) [mm], as far from both ends.
        ccw : bool
            Whether it turns counter-clockwise.
        feed : float
            [mm/s]
        role : Role
        """
        kind = Kind.ARC_CCW if ccw else Kind.ARC_CW
        self._add(kind, role, np.array(point, float), np.array(center, float), feed)

    def build(self) -> Toolpath:
        """Return the collected moves."""
        return self.build_with_entries()[0]

    def build_with_entries(self) -> tuple[Toolpath, NDArray[np.intp]]:
        """Return the collected moves, and the number of the entry that each came from."""
        single: list[tuple[float, ...]] = []
        ways: dict[float, dict[int, _Way]] = {}
        for i, entry in enumerate(self._entries):
            if isinstance(entry, _Way):
                ways.setdefault(entry.tolerance, {})[i] = entry
            else:
                single.append((i, *entry))
        table = np.array(single, float).reshape(-1, 9)
        rows, entries = [table[:, 1:]], [table[:, 0].astype(np.intp)]
        for tolerance, alike in ways.items():
            fitted, which = _fitted(list(alike.values()), tolerance)
            rows.append(fitted)
            entries.append(np.array(list(alike), np.intp)[which])
        entry_of = np.concatenate(entries)
        order = np.argsort(entry_of, kind="stable")
        table = np.concatenate(rows)[order]
        toolpath = Toolpath(
            start=self._start,
            kinds=table[:, 0].astype(np.int8),
            roles=table[:, 1].astype(np.int8),
            points=table[:, 2:5].copy(),
            centers=table[:, 5:7].copy(),
            feeds=table[:, 7].copy(),
        )
        return toolpath, entry_of[order]


def _fitted(ways: Sequence[_Way], tolerance: float) -> tuple[Floats, NDArray[np.intp]]:
    """Return the moves along polylines, shape (m, 8), and the number of the polyline of each."""
    points = np.concatenate([way.points for way in ways])
    counts = np.array([len(way.points) for way in ways])
    pieces = fit_arcs(points[:, :2], tolerance, np.cumsum(counts) - counts)
    which = np.repeat(np.arange(len(ways)), counts)[pieces.ends]
    bent = np.where(pieces.ccw, Kind.ARC_CCW, Kind.ARC_CW)
    kinds = np.where(np.isnan(pieces.centers[:, 0]), Kind.LINE, bent)
    rest = np.array([(way.role, way.feed) for way in ways], float)[which]
    moves = [kinds, rest[:, 0], points[pieces.ends], pieces.centers, rest[:, 1]]
    return np.column_stack(moves), which
