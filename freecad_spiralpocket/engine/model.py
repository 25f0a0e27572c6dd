# SPDX-License-Identifier: LGPL-2.1-or-later
"""The records that flow through the engine, from the request to the report.

`PocketRequest` goes in; a strategy turns each cutter-center region into a
`FloorPath` in the plane (floor.py); the levels turn that into a `Toolpath`
(toolpath.py); the proof measures it; `Plan` with its `Report` comes out. Records are frozen
and hold numpy arrays and shapely polygons; nobody changes one in place.

Units are mm, s and rad; feeds are mm/s as in FreeCAD. The spindle turns
clockwise (M3). Climb: uncut stock on the right of the direction of travel,
so an outward spiral runs counter-clockwise.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .errors import tell
from .stepover import engagement_angle

if TYPE_CHECKING:
    from shapely import Geometry, MultiPolygon, Polygon

    from .machine import Machine
    from .toolpath import Toolpath

Floats = NDArray[np.float64]

#: Called with the finished fraction [0, 1] and the name of the stage; returns True to cancel.
Progress = Callable[[float, str], bool]

#: Called by a strategy now and then with the finished fraction of its own work; raises
#: `CancelledError` if the user cancelled.
Tick = Callable[[float], None]


class CutMode(Enum):
    """On which side of the cutter the stock stands."""

    CLIMB = "Climb"
    CONVENTIONAL = "Conventional"


class FeedMode(Enum):
    """How the feed follows the engagement; the value is what the machinist reads."""

    CONSTANT = "Constant"
    LINEAR_SLOWDOWN = "Linear slow-down"
    CHIP_THICKNESS = "Chip thickness"


class Strategy(Enum):
    """How the laps are made; the value is what the machinist reads."""

    AUTOMATIC = "Automatic"
    LINEAR_MORPH = "Linear Morph"
    EXTENDED_ARCHIMEDEAN = "Extended Archimedean"
    ISOTHERM = "Isotherm"
    CENTRAL_SPIRAL = "Central Spiral"

    @property
    def has_closing_lap(self) -> bool:
        """Return whether it ends with a lap of its own along the wall, or not, as is asked for.

        The laps and strokes of the others finish the walls.
        """
        return self not in (Strategy.AUTOMATIC, Strategy.EXTENDED_ARCHIMEDEAN)


@dataclass(frozen=True, slots=True)
class Heights:
    """Heights and depths of the operation, Z [mm], with FreeCAD's meanings.

    Attributes
    ----------
    clearance, safe : float
        Rapids across the part run at `clearance`, down to `safe` above the cut.
    start_depth, final_depth : float
        Top and floor of the pocket, ``final_depth < start_depth <= safe``.
    step_down : float
        Largest axial depth of a level, positive.
    finish_depth : float
        Axial depth of one last thin level, 0 for none.
    """

    clearance: float
    safe: float
    start_depth: float
    final_depth: float
    step_down: float
    finish_depth: float = 0.0


@dataclass(frozen=True, slots=True)
class Feeds:
    """Feeds and rapids of the tool controller [mm/s], positive."""

    horizontal: float
    vertical: float
    horizontal_rapid: float
    vertical_rapid: float


@dataclass(frozen=True, slots=True)
class FeedPlan:
    """How the feed follows the engagement (see `feed`).

    Attributes
    ----------
    mode : FeedMode
    slowed : float
        Ratio of the slowed feed (Linear slow-down), in ``(0, 1]``.
    largest_ratio : float
        Largest ratio to the programmed feed (Chip thickness), 1 or more.
    link_feed : float
        Of moves at depth through cleared ground [mm/s]; 0 for the horizontal rapid rate.
    """

    mode: FeedMode = FeedMode.CONSTANT
    slowed: float = 0.75
    largest_ratio: float = 2.0
    link_feed: float = 0.0


@dataclass(frozen=True, slots=True)
class Cutting:
    """How the cutter is to be loaded.

    Attributes
    ----------
    stepover : float
        Largest radial depth of cut of a straight cut [mm], in ``(0, D]``.
    cut_mode : CutMode
    stock_to_leave, floor_stock : float
        What stays on walls and floor [mm]; negative cuts into them.
    finishing_lap : bool
        Close with a lap along the exact wall; without it the last lap rounds the corners off.
    """

    stepover: float
    cut_mode: CutMode = CutMode.CLIMB
    stock_to_leave: float = 0.0
    floor_stock: float = 0.0
    finishing_lap: bool = True


@dataclass(frozen=True, slots=True)
class Entry:
    """How the cutter goes down.

    Attributes
    ----------
    helix_angle : float
        Ramp angle of the helix [rad], in ``(0, pi/2)``.
    max_diameter : float
        Limit of the diameter of the cutter center's circle [mm]; 0 or more than the cutter's
        diameter: as wide as fits without leaving a post.
    slot_bite : float
        Axial depth of each level in which a slot is opened [mm]; 0: the depth that removes as
        much per time as the step-over at the full depth does, and at most 0.3 D.
    """

    helix_angle: float = np.radians(5.0)
    max_diameter: float = 0.0
    slot_bite: float = 0.0


@dataclass(frozen=True, slots=True)
class Section:
    """What walls leave free at one level, where they are not vertical or the stock is not.

    Attributes
    ----------
    z : float
        Floor of the level [mm].
    pocket : shapely.Polygon
        Free at `z` and at every height above that the cutter's body passes, islands as holes
        [mm]. Levels are nested: none reaches beyond the one above it.
    mouth : shapely.Polygon or None
        Free at the top of the level; what it has more than `pocket` stays as a step on the wall.
        None where the walls of this level are vertical.
    stock : shapely.Polygon or MultiPolygon or None
        Where material stands from `z` up to the level above, before the first move [mm]: no less
        than stands higher up. None for `PocketRequest.stock`.
    """

    z: float
    pocket: Polygon
    mouth: Polygon | None = None
    stock: Polygon | MultiPolygon | None = None


@dataclass(frozen=True, slots=True)
class PocketRequest:
    """One pocket, one cutter, one way to cut it.

    Attributes
    ----------
    pocket : shapely.Polygon
        The floor as it shall be, islands as holes, XY [mm].
    tool_diameter : float
        Cutter diameter D [mm].
    heights, feeds, cutting, entry
        See their records.
    strategy : Strategy
    tolerance : float
        Largest deviation of the emitted path from the exact curve [mm].
    feed_plan : FeedPlan
    machine : Machine or None
        On which machine the time is to be least; None for a middling one.
    start_point : tuple of float or None
        Where the cutter shall go down, (x, y) [mm], as near as it can; None: where it is best.
    stock : shapely.Polygon or MultiPolygon or None
        Where material stands before the first move, down to the floor, seen from above [mm]. What
        is outside of it is air: beside the stock, where the pocket may reach to at open sides,
        and where it was cleared before. None: there is stock everywhere. Where sections have their
        own this is what is left to cut at any of them.
    beyond : shapely.Polygon or MultiPolygon or None
        Ground of the pocket beyond its open sides, which may be cut but need not be [mm].
    sections : tuple of Section
        The levels from the top down, where walls are slanted or stepped or other stock stands at
        some; the last is the floor with `pocket` itself. Empty where all levels are alike: then
        the heights give them.
    """

    pocket: Polygon
    tool_diameter: float
    heights: Heights
    feeds: Feeds
    cutting: Cutting
    entry: Entry = Entry()
    strategy: Strategy = Strategy.AUTOMATIC
    tolerance: float = 0.01
    feed_plan: FeedPlan = FeedPlan()
    machine: Machine | None = None
    start_point: tuple[float, float] | None = None
    stock: Polygon | MultiPolygon | None = None
    beyond: Polygon | MultiPolygon | None = None
    sections: tuple[Section, ...] = ()

    @property
    def floor(self) -> float:
        """Return the Z of the lowest level [mm]."""
        return self.heights.final_depth + self.cutting.floor_stock

    @property
    def axial_depth(self) -> float:
        """Return the axial depth of a full cut [mm]: a step down, or all of a shallow pocket."""
        return min(self.heights.step_down, self.heights.start_depth - self.floor)

    @property
    def link_feed(self) -> float:
        """Return the feed of links at depth [mm/s]."""
        return self.feed_plan.link_feed or self.feeds.horizontal_rapid

    def to_clear(self, ground: Geometry) -> Geometry:
        """Return what of some ground of the pocket shall be cleared: stock, not beyond it."""
        ground = ground if self.beyond is None else ground.difference(self.beyond)
        ground = ground if self.stock is None else ground.intersection(self.stock)
        # where edges meet lines may come of it
        return ground.buffer(0) if ground.geom_type == "GeometryCollection" else ground

    @property
    def cutter_radius(self) -> float:
        """Return R [mm]."""
        return self.tool_diameter / 2

    @property
    def engagement_limit(self) -> float:
        """Return the engagement angle of a straight cut at the step-over [rad]."""
        return engagement_angle(self.cutting.stepover, self.cutter_radius)


@dataclass(frozen=True, slots=True, eq=False)
class SplineCurve:
    """A clamped B-spline in the plane.

    Attributes
    ----------
    degree : int
    knots : ndarray of shape (n + degree + 1,)
        Non-decreasing, in [0, 1].
    control_points : ndarray of shape (n, 2)
        [mm]
    height : float
        Z at which it is cut last [mm]; strategies leave it at 0.
    """

    degree: int
    knots: Floats
    control_points: Floats
    height: float = 0.0


@dataclass(frozen=True, slots=True)
class Notice:
    """Something the machinist should know about a path that was made all the same.

    The fields are those of `errors.SpiralPocketError`.
    """

    message: str
    hint: str = ""
    place: tuple[float, float] | None = None

    def __str__(self) -> str:
        """Return message and hint as one text."""
        return tell(self.message, self.hint, self.place)


@dataclass(frozen=True, slots=True, eq=False)
class Report:
    """What was measured on the finished toolpath, independent of how it was made.

    Attributes
    ----------
    time : float
        On the request's machine [s].
    cut_length : float
        Of all moves at cutting feed below the start depth [mm].
    engagement_limit, engagement_max, engagement_p99, engagement_mean : float
        Engagement angle [rad]: what was asked; largest, not passed over 99 % of the length, and
        mean over the length, at the floors after the entry.
    over_limit_share : float
        Share of that length where the engagement clearly passes the limit, in [0, 1].
    rapid_hit, link_hit : float
        Length of rapids and of links through standing stock [mm]; 0 as it should be.
    entry_bite : float
        Height of stock straight ahead on the way down, not passed over 99 % of its length [mm].
    engagement_points : ndarray of shape (k, 3)
        Where the engagement was measured [mm], in the order of travel.
    engagement_angles : ndarray of shape (k,)
        [rad]
    engagement_moves : ndarray of int, shape (k,)
        Move of the toolpath each place is on.
    uncut : shapely.MultiPolygon
        What the cutter could reach and left standing.
    gouge : float
        How far the cutter's edge passes the wall (less the stock to leave) or the floor
        [mm], 0 or more.
    gouge_place : tuple of float or None
        Where the cutter's center is then, (x, y) [mm].
    hit_moves : frozenset of int
        Moves of rapids and links that touch standing stock.
    step_width, step_height : float
        Of the largest steps that stay on slanted walls between the levels [mm]; 0 for none.
    notices : tuple of Notice
    """

    time: float
    cut_length: float
    engagement_limit: float
    engagement_max: float
    engagement_p99: float
    engagement_mean: float
    over_limit_share: float
    rapid_hit: float
    link_hit: float
    entry_bite: float
    engagement_points: Floats
    engagement_angles: Floats
    engagement_moves: NDArray[np.int64]
    uncut: MultiPolygon
    gouge: float
    gouge_place: tuple[float, float] | None = None
    hit_moves: frozenset[int] = frozenset()
    step_width: float = 0.0
    step_height: float = 0.0
    notices: tuple[Notice, ...] = ()

    @property
    def uncut_area(self) -> float:
        """Return the area left standing [mm2]."""
        return float(self.uncut.area)


@dataclass(frozen=True, slots=True, eq=False)
class Plan:
    """The answer to a request: the toolpath and what is known about it."""

    request: PocketRequest
    toolpath: Toolpath
    report: Report
    curves: tuple[SplineCurve, ...] = field(default=())
