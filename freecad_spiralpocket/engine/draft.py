# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rough laps within a fraction of a second, to be shown until the proved path is there.

Fronts grow from the most promising start alone, the whole front by one step that
holds the engagement on a circle of its length, on coarse outlines. There is no order,
there are no links and nothing is proved: a draft shows where the laps run and how many
there are. It must never become a toolpath.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from shapely import Polygon

from .checks import check_request
from .floor import Plunge
from .growth.front_rules import FrontRules, engagement_step, rules_of
from .growth.fronts import ROOM, STALLED
from .levels import Level, at_level, levels_of
from .mirroring import mirrored, mirrored_request
from .model import CutMode, Floats, PocketRequest
from .opening.leftovers import is_left
from .opening.open_sides import needed, starts_of
from .opening.outline import outline_of
from .opening.promising import promising
from .opening.starts import island_ring
from .shapes.region import center_regions
from .shapes.shaping import largest, oriented, slim_region

#: Outlines are coarse by this much, over R; chords in a quarter circle.
COARSE, QUADRANT = 0.02, 4
#: Most fronts of a region; a draft that needs more shows the inner ones only.
MOST = 150
#: Radii with which fronts meet walls, over the rules', and what a lap must add by them, over its
#: step and R: smaller ones lead out of slim slots and through necks, but not into every corner.
FILLETS = ((1.0, STALLED), (0.5, 0.5), (0.25, 0.5), (0.1, 0.5))
#: Parts of a front nearer to the wall than this are no laps, over R.
ALONG_WALL = 0.03


@dataclass(frozen=True, slots=True, eq=False)
class DraftOpening:
    """How a region is opened; of use for other step-overs, depths and feeds too.

    Attributes
    ----------
    kind : str
        The name of its `start.Start`.
    visited, omega : shapely.Polygon
        See `start.Start`.
    walls : shapely.Polygon
        The region whose boundary the last laps run along.
    ring : ndarray of shape (n, 2)
        The entry's last lap [mm].
    """

    kind: str
    visited: Polygon
    omega: Polygon
    walls: Polygon
    ring: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Draft:
    """Rough laps of one pocket.

    Attributes
    ----------
    entries : tuple of ndarray of shape (n, 2)
        The entry's last lap of each region [mm].
    laps : tuple of ndarray of shape (n, 2)
        From the inside outwards [mm].
    z : float
        Of the floor, or of the lowest level in which earlier operations have left something [mm].
    """

    entries: tuple[Floats, ...]
    laps: tuple[Floats, ...]
    z: float


def openings(request: PocketRequest) -> list[DraftOpening]:
    """Return how each region of the pocket is opened in a draft.

    Raises
    ------
    SpiralPocketError
        If no part of the pocket can be cut as asked.
    """
    check_request(request)
    found = []
    request = at_level(request, _drawn(request))
    regions = _regions(request)
    if request.cutting.cut_mode is CutMode.CONVENTIONAL:
        request = mirrored_request(request)
    for region in regions:
        starts = starts_of(region, request)
        inner = needed(region, request)
        start, within = promising(starts, inner, request.cutting.stepover)[0]
        reaches_out = start.within is not None or isinstance(start.entry, Plunge)
        walls = within if reaches_out else start.omega
        # stairs depend on the step-over, which a draft lets be dragged
        plain = start if start.plain is None else start.plain
        ring = shapely.get_coordinates(plain.ring)
        found.append(DraftOpening(start.name, plain.visited, start.omega, walls, ring))
    return found


def reopened(opened: list[DraftOpening], request: PocketRequest) -> list[DraftOpening] | None:
    """Return the same openings in walls that have moved a little, sooner than `openings`.

    None where the pocket has other regions now, or one of them cannot be opened like that.
    """
    check_request(request)
    request = at_level(request, _drawn(request))
    regions = _regions(request)
    if len(regions) != len(opened):
        return None
    moved = [_moved(*pair, request) for pair in zip(opened, regions, strict=True)]
    return None if None in moved else [opening for opening in moved if opening is not None]


def _moved(opening: DraftOpening, region: Polygon, request: PocketRequest) -> DraftOpening | None:
    """Return an opening in a region with other walls."""
    kind = opening.kind
    if kind == "outline":
        outline = outline_of(region, request.cutter_radius)
        if outline is None:
            return None
        ring = shapely.get_coordinates(outline.ring)
        return DraftOpening(kind, outline.visited, outline.omega, region, ring)
    if kind == "island ring":
        start = island_ring(region, request)
        if start is None:
            return None
        ring = shapely.get_coordinates(start.ring)
        return DraftOpening(kind, start.visited, start.omega, start.omega, ring)
    visited = shapely.intersection(opening.visited, region)
    if not isinstance(visited, Polygon) or visited.is_empty:
        return None
    return DraftOpening(kind, oriented(visited), region, region, opening.ring)


def _drawn(request: PocketRequest) -> Level:
    """Return the level of a pocket whose laps are drawn."""
    levels = levels_of(request)
    for level in reversed(levels):
        if level.stock is request.stock:
            return level
        radius, left = request.cutter_radius, request.cutting.stock_to_leave
        regions = center_regions(level.pocket, radius, left)
        if any(is_left(region, at_level(request, level)) for region in regions):
            return level
    return levels[-1]


def _regions(request: PocketRequest) -> list[Polygon]:
    """Return where the cutter's center may be, mirrored for conventional milling."""
    is_mirrored = request.cutting.cut_mode is CutMode.CONVENTIONAL
    stock = request.cutting.stock_to_leave
    regions = center_regions(request.pocket, request.cutter_radius, stock)
    return [slim_region(mirrored(r) if is_mirrored else r) for r in regions]


def draft(request: PocketRequest, opened: list[DraftOpening] | None = None) -> Draft:
    """Return rough laps of a pocket.

    Parameters
    ----------
    request : PocketRequest
    opened : list of DraftOpening, optional
        Those of the same pocket, cutter, stock and direction, where they are known.

    Raises
    ------
    SpiralPocketError
        If no part of the pocket can be cut as asked.
    """
    check_request(request)  # openings that are known were of other depths
    opened = openings(request) if opened is None else opened
    rules = rules_of(request)
    laps = [lap for opening in opened for lap in _laps(opening, rules)]
    entries = [opening.ring for opening in opened]
    if request.cutting.cut_mode is CutMode.CONVENTIONAL:
        laps, entries = [p * (-1, 1) for p in laps], [p * (-1, 1) for p in entries]
    return Draft(tuple(entries), tuple(laps), _drawn(request).bottom)


def _laps(opening: DraftOpening, rules: FrontRules) -> list[Floats]:
    """Return the new parts of all fronts, the wall itself at last."""
    coarse = COARSE * rules.cutter_radius
    omega = shapely.simplify(opening.omega, coarse)
    visited = largest(shapely.intersection(shapely.simplify(opening.visited, coarse), omega))
    shapely.prepare(omega)
    wall = shapely.buffer(omega.boundary, ALONG_WALL * rules.cutter_radius, quad_segs=1)
    laps: list[Floats] = []
    for _ in range(MOST):
        grown = _advanced(visited, omega, rules, coarse)
        if grown is None:
            break
        laps += _lines(shapely.difference(grown.boundary, wall))
        visited = grown
    return laps + _lines(opening.walls.boundary)


def _advanced(visited: Polygon, omega: Polygon, rules: FrontRules, coarse: float) -> Polygon | None:
    """Return the visited region after one more lap, None if that adds next to nothing."""
    bend = np.array([2 * np.pi / visited.exterior.length])
    step = float(engagement_step(bend, rules)[0])
    closed = shapely.buffer(visited, step + rules.closing, quad_segs=QUADRANT)
    closed = shapely.buffer(closed, -rules.closing, quad_segs=QUADRANT)
    if shapely.contains_properly(omega, closed):
        return shapely.simplify(largest(closed), coarse)
    grown = shapely.intersection(closed, omega)
    for share, least in FILLETS:
        opened = shapely.buffer(grown, -share * rules.fillet, quad_segs=QUADRANT)
        opened = shapely.buffer(opened, share * rules.fillet, quad_segs=QUADRANT)
        found = shapely.simplify(largest(shapely.union(opened, visited)), coarse)
        if found.area - visited.area >= least * rules.stepover * rules.cutter_radius:
            return found
        rest = shapely.difference(omega, visited)
        if shapely.buffer(rest, -ROOM * rules.fillet, quad_segs=2).is_empty:
            break  # only corners are left
    return None


def _lines(shape: shapely.Geometry) -> list[Floats]:
    parts = shapely.get_parts(
        shapely.line_merge(shape) if shape.geom_type[:5] == "Multi" else shape
    )
    return [shapely.get_coordinates(part) for part in parts if part.length > 0]
