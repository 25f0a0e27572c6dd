# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conventional milling is climb milling in the mirror: x becomes -x before and after."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

from shapely import Geometry, Polygon
from shapely.affinity import scale
from shapely.geometry.polygon import orient

from .model import PocketRequest, Section

Ground = TypeVar("Ground", bound=Geometry)


def mirrored(shape: Polygon) -> Polygon:
    """Return a polygon in the mirror, counter-clockwise."""
    return orient(_flipped(shape))


def mirrored_request(request: PocketRequest) -> PocketRequest:
    """Return a request with the places that a strategy looks at in the mirror."""
    start, stock, beyond = request.start_point, request.stock, request.beyond
    return replace(
        request,
        pocket=mirrored(request.pocket),
        start_point=None if start is None else (-start[0], start[1]),
        stock=None if stock is None else _flipped(stock),
        beyond=None if beyond is None else _flipped(beyond),
        sections=tuple(_mirrored_section(section) for section in request.sections),
    )


def _mirrored_section(section: Section) -> Section:
    return replace(
        section,
        pocket=mirrored(section.pocket),
        mouth=None if section.mouth is None else mirrored(section.mouth),
        stock=None if section.stock is None else _flipped(section.stock),
    )


def _flipped(shape: Ground) -> Ground:
    return scale(shape, -1.0, 1.0, origin=(0.0, 0.0))
