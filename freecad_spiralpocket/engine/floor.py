# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a strategy makes of one cutter-center region: an entry and passes, in the plane.

A floor path is the same at every level; only the entry's way down depends on
how deep the level is. It is for climb milling, outwards counter-clockwise.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from .model import Floats, SplineCurve
from .toolpath import Role


@dataclass(frozen=True, slots=True, eq=False)
class Helix:
    """A helical entry that ends with one flat turn.

    Attributes
    ----------
    center : ndarray of shape (2,)
        [mm]
    radius : float
        Of the cutter center's circle [mm].
    start_angle : float
        Where it ends, [rad] from the X axis.
    """

    center: Floats
    radius: float
    start_angle: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class Stairs:
    """Where the loops of a slot along the wall run, and how deep each goes (stairs.py).

    Attributes
    ----------
    lines : ndarray of shape (k, n, 2)
        Of each loop, the highest first, counter-clockwise, point beside point; the last along
        the wall. Their first points are not repeated [mm].
    drops : ndarray of shape (k,)
        How much deeper each is than the one before, over the depth.
    inner : ndarray of shape (n, 2)
        Beside these: laps go on from here as if all outside of it were cleared [mm].
    """

    lines: Floats
    drops: Floats
    inner: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Slot:
    """An entry along a closed ring, in flat levels joined by short ramps.

    Attributes
    ----------
    ring : ndarray of shape (n, 2)
        Counter-clockwise; begins where the entry ends, the first point is not repeated [mm].
    bite : float
        Largest axial depth of one level [mm].
    stairs : Stairs or None
        Where its loops run, if not all along the ring; it ends on the inner line then.
    wall : ndarray of shape (n, 2) or None
        Where the last loop runs, point beside point of the ring, if it runs out into corners
        [mm]; with stairs their last line does.
    ahead : float
        How much longer its first loop is than it must be, to begin where it was asked to [mm].
    """

    ring: Floats
    bite: float
    stairs: Stairs | None = None
    wall: Floats | None = None
    ahead: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class Groove:
    """An entry forth and back about a line or a tree of lines, one flat level each way.

    Attributes
    ----------
    ring : ndarray of shape (n, 2)
        Slim, counter-clockwise; begins at the tip where the entry ends, the first point is not
        repeated [mm].
    tips : tuple of float
        Where along the ring the other tips are, in order [mm].
    feet : tuple of float
        Between each of them and the next: where the way from one to the other is nearest to the
        first point, along the tree [mm]. One fewer.
    trunk : float
        Distance from the first point to the nearest of these, or to the only other tip [mm].
    bite : float
        Largest axial depth of one level [mm].
    """

    ring: Floats
    tips: tuple[float, ...]
    feet: tuple[float, ...]
    trunk: float
    bite: float


@dataclass(frozen=True, slots=True, eq=False)
class Plunge:
    """An entry straight down in the air beside the stock.

    Attributes
    ----------
    place : ndarray of shape (2,)
        [mm]
    """

    place: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Pass:
    """One uninterrupted motion at the floor.

    Attributes
    ----------
    points : ndarray of shape (n, 2)
        It goes on to each of these in turn [mm]. For `Role.AIR`: lift, go over to the last, and
        down again.
    role : Role
    """

    points: Floats
    role: Role


#: Ways down to the floor.
WayDown: TypeAlias = Helix | Slot | Groove | Plunge


@dataclass(frozen=True, slots=True)
class Descent:
    """How far down a way down leads at one level, and how steeply.

    Attributes
    ----------
    top, bottom : float
        Z of the stock's top and of the level's floor [mm].
    angle : float
        Of helix and ramps [rad], in ``(0, pi/2)``.
    """

    top: float
    bottom: float
    angle: float

    @property
    def depth(self) -> float:
        """Return how far down it leads [mm]."""
        return self.top - self.bottom


@dataclass(frozen=True, slots=True, eq=False)
class FloorPath:
    """All motion in one region at one level.

    Attributes
    ----------
    entry : WayDown
    passes : tuple of Pass or WayDown
        In order, the first from the end of the entry. A way down among them: lift, go over, and
        down there.
    curve : SplineCurve or None
        The exact curve behind the spiral, where the strategy has one.
    """

    entry: WayDown
    passes: tuple[Pass | WayDown, ...]
    curve: SplineCurve | None = None
