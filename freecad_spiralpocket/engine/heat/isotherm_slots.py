# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where isotherms are opened: cores in the middle, and slots along level ridges.

About a summit laps shrink to a helix. Along a ridge that is level, as in a long room, a
neck, a finger or all round an island, isotherms are no guide: laps would creep along it
by one step-over each, and what is left of the ridge at last is noise. A room that is thin
enough for the cutter to clear it from its outline is opened by a slot along that, if this
is shorter than the laps that it saves.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np
import shapely
from shapely import Polygon

from ..floor import Helix, Slot
from ..model import Floats
from ..opening.entry import NARROWEST, NoRoomForHelixError, fit_helix_radius
from ..opening.start import slot_bite
from ..shapes.polyline import ring_points
from ..shapes.region import grow, polygons_of, widest_disc
from ..shapes.shaping import SLIVER, largest
from .family import Enclosed, Family, distances, points_of
from .isotherms import isotherms
from .nested import Lap

#: A core is opened by a slot where a helix would need more laps than this times its levels.
SLOT_PAYS = 2.0
#: One half as wide as this over R is opened by a slot if that saves a lap: the tips of such narrow
#: laps would cut at full width.
NARROW = 0.6
#: The cutter, once round a core, clears what is nearer than this over R.
CLEARED = 0.97
#: Sought is one a little thinner than that.
THIN = 0.96
#: Detail that does not matter there [mm].
THIN_SLACK = 0.02
#: A place that is so much too far from the outline shows that a region is not thin [mm].
DEEPER = 0.05
#: Steps of the search for it.
BISECTIONS = 6
#: Where there is no room for a helix a slot goes about all that is nearer than this over R.
IN_SLIT = 0.5
#: A neck's outline is no longer than this over the distance of its middle.
LONGEST = 6.0
#: Slots in necks reach into the rooms by these shares of the step-over, and their ends are rounded
#: by these over R: the first that is thin enough is taken.
OVERLAPS, ROUNDINGS = (1.0, 0.6, 0.3), (0.3, 0.1, 0.03)


def core_of(family: Family, room: Enclosed) -> Lap | None:
    """Return how the innermost part of a room is opened; None if there are laps to come."""
    request, region = family.request, room.region
    radius = request.cutter_radius
    center, _ = room.peak(family.field)
    ring = np.asarray(region.exterior.coords)
    far = float(np.hypot(*(ring - center).T).max())
    free = family.region.boundary.distance(shapely.Point(center))
    reach = min(radius, free) + family.stepover
    if not region.interiors and far <= reach:
        try:
            width = fit_helix_radius(family.region, center, radius, request.entry)
        except NoRoomForHelixError:
            core = _core_in_slit(family, room, center)
            if core.region.exterior.length < 2 * math.pi * NARROWEST * radius:
                raise
            return core
        if far <= width + family.stepover:
            return Lap(_disc(center, width), math.nan, (), Helix(center, width))
    if not _is_thin(region, _width(family, region), center):
        return None
    narrow = region.boundary.distance(shapely.Point(center)) < NARROW * radius
    worth = pays(family, far - reach) or (narrow and far - reach > family.stepover)
    if not region.interiors and not worth:
        return None
    return Lap(region, room.level, (), Slot(ring[:-1], slot_bite(request)))


def _core_in_slit(family: Family, room: Enclosed, center: Floats) -> Lap:
    """Return a core in a place too narrow for a helix: a slot about all that is near by."""
    disc = _disc(center, IN_SLIT * family.request.cutter_radius)
    region = largest(shapely.intersection(family.region, disc))
    ring = np.asarray(region.exterior.coords)
    return Lap(region, room.level, (), Slot(ring[:-1], slot_bite(family.request)))


def _disc(center: Floats, radius: float) -> Polygon:
    """Return a disc about a center of shape (2,) [mm]."""
    angles = np.linspace(0.0, 2 * np.pi, 193)[:-1]
    return Polygon(center + radius * np.column_stack([np.cos(angles), np.sin(angles)]))


def _is_thin(region: Polygon, width: float, deep: Floats) -> bool:
    """Return whether all of a region is within `width` [mm] of its outer boundary.

    `deep`, shape (2,), is a place of it: where that is too far away, nothing else need be measured.
    """
    place = shapely.Point(deep)
    if region.exterior.distance(place) > width + DEEPER and region.contains(place):
        return False
    rough = shapely.simplify(region, THIN_SLACK)
    swept = shapely.buffer(rough.exterior, width, quad_segs=16)
    return bool(shapely.difference(rough, swept).area < SLIVER)


def _width(family: Family, core: Polygon) -> float:
    """Return how far from its outer ring a core may reach to be opened by a slot [mm]."""
    width = CLEARED * family.request.cutter_radius
    # an inner ring of the core is a lap of its own
    return min(width, family.stepover) if core.interiors else width


def pays(family: Family, way: float) -> bool:
    """Return whether a slot is shorter than laps that creep so far along a ridge [mm]."""
    levels = math.ceil(family.request.axial_depth / slot_bite(family.request))
    return way / family.stepover > SLOT_PAYS * levels


def core_share(family: Family, room: Enclosed, share: float, hottest: float) -> float:
    """Return a share before `share` at which a core can be opened by a slot, or `share`.

    A step over the ridge would leave the ridge's summits, which are noise where it is level.

    Parameters
    ----------
    family : Family
    room : Enclosed
    share : float
        Of the way from the room's temperature to the hottest, in ``(0, 1)``.
    hottest : float
        [mm2]
    """
    count = len(room.region.interiors)
    deep, _ = room.peak(family.field)
    if _is_thin(room.region, _width(family, room.region), deep):
        return share

    def parts(of: float) -> list[Polygon]:
        level = room.level + of * (hottest - room.level)
        return isotherms(family, room, level)

    def is_whole(found: list[Polygon]) -> bool:
        return len(found) == 1 and len(found[0].interiors) == count

    def is_thin(core: Polygon) -> bool:
        return _is_thin(core, THIN * _width(family, core), deep)

    last = parts(share)
    if is_whole(last) and not is_thin(last[0]):
        return share
    low, high, core = 0.0, share, None
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        inner = parts(middle)
        if not is_whole(inner):
            high, core = middle, None
        elif is_thin(inner[0]):
            high, core = middle, inner[0]
        else:
            low = middle
    if core is None or core_of(family, replace(room, region=core)) is None:
        return share
    return high


def slots_for(
    family: Family,
    room: Enclosed,
    rooms: list[Polygon],
    must_pay: bool,
    *,
    any_shape: bool = False,
) -> list[Lap]:
    """Return slots that open all that is out of reach of the rooms; none if they cannot.

    In a neck or a finger of even width the isotherms are exponentially far apart; laps would
    creep along it. There the ridge is opened by a slot at once, if it is thin enough.

    Parameters
    ----------
    family : Family
    room : Enclosed
    rooms : list of shapely.Polygon
        Inside of it, as the next isotherm leaves them.
    must_pay : bool
        Whether each slot has to be shorter than the laps that it saves.
    any_shape : bool
        Whether slots may be longer than necks, or have sharp ends: in a slit hardly wider than the
        cutter no other fits.
    """
    request, step = family.request, family.stepover
    reached = shapely.buffer(shapely.union_all(rooms), step, quad_segs=8)
    laps = []
    for piece in polygons_of(shapely.difference(room.region, reached)):
        if piece.area < SLIVER:
            continue
        far = distances(points_of(piece), rooms).max()
        # a neck is about twice as long as its middle is far from the rooms; else it is no neck
        is_neck = any_shape or piece.length <= LONGEST * far
        if not is_neck or (must_pay and not pays(family, far)):
            return []
        slot = _slot_about(family, room, piece, (0.0,) if any_shape else ROUNDINGS)
        if slot is None:
            return []
        ring = ring_points(slot.exterior)
        laps.append(Lap(slot, math.nan, (), Slot(ring, slot_bite(request))))
    return laps


def _slot_about(
    family: Family, room: Enclosed, piece: Polygon, roundings: Sequence[float]
) -> Polygon | None:
    """Return a region to open by a slot that covers `piece` and meets the rooms beside it."""
    radius = family.request.cutter_radius
    around = shapely.box(*piece.buffer(2 * family.stepover).bounds)
    beside = shapely.intersection(room.region, around)
    piece = shapely.simplify(piece, THIN_SLACK / 2)
    # a region that covers the piece has its widest disc inside, and a region that is thin has none
    if widest_disc(piece, DEEPER)[1] > radius:
        return None
    for share, rounding in product(OVERLAPS, roundings):
        wide = shapely.intersection(beside, grow(piece, share * family.stepover))
        round_ = rounding * radius
        parts = polygons_of(grow(grow(wide, -round_), round_))
        if not parts or parts[0].interiors:
            continue
        left = shapely.difference(piece, grow(parts[0], family.stepover / 2))
        middle = shapely.get_coordinates(shapely.point_on_surface(parts[0]))[0]
        if left.area < SLIVER and _is_thin(parts[0], CLEARED * radius, middle):
            return parts[0]
    return None
