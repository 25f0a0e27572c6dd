# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets like those of the papers, which print pictures but no coordinates.

$SPIRALPOCKET_POCKETS may name a folder with pockets to take instead: NAME.json, one object with
`outer` and `holes`, rings of [x, y] in mm.
"""

from __future__ import annotations

import json
import os
from pathlib import Path

from shapely import Point, Polygon, box, union_all


def rounded(shape: Polygon, convex: float, reentrant: float = 0.0) -> Polygon:
    """Return `shape` with its convex and reentrant corners rounded [mm]."""
    shape = shape.buffer(-convex).buffer(convex, quad_segs=32)
    return shape.buffer(reentrant).buffer(-reentrant, quad_segs=32)


def big() -> Polygon:
    """Return a pocket like Bieterman's: long, two wavy bays, about 310 x 72 mm [HQS24 fig. 7]."""
    bays = [Point(115, 99).buffer(35, quad_segs=64), Point(214, -27).buffer(34, quad_segs=64)]
    return rounded(box(0, 0, 310, 72).difference(union_all(bays)), 12.0, 12.0)


def hug() -> Polygon:
    """Return a pocket like Huang's: two lobes, a notch between them [HQS24 fig. 14]."""
    lobes = [Point(x, 0).buffer(30, quad_segs=64) for x in (-32, 32)]
    notch = Polygon([(-14, 34), (14, 34), (3.5, -4), (-3.5, -4)])
    heart = union_all([*lobes, box(-32, -30, 32, 10)]).difference(notch)
    return rounded(heart, 8.0, 7.0)


def rib() -> list[Polygon]:
    """Return nine pockets of a wing rib, corners of radius 10 [CS08 fig. 17]."""
    outlines = (
        [(0, 0), (120, 0), (120, 90), (0, 70)],
        [(0, 0), (130, 0), (130, 110), (0, 90)],
        [(0, 0), (130, 0), (130, 115), (0, 110)],
        [(0, 0), (110, 0), (110, 115), (0, 115)],
        [(0, 0), (150, 0), (150, 110), (0, 115)],
        [(0, 0), (100, 0), (100, 100), (0, 110)],
        [(0, 0), (140, 0), (140, 80), (0, 100)],
        [(0, 0), (90, 0), (90, 65), (0, 80)],
        [(0, 0), (150, 0), (0, 65)],
    )
    return [rounded(Polygon(outline), 10.0) for outline in outlines]


_MADE = {"big": big, "hug": hug}


def pocket(name: str) -> Polygon:
    """Return the pocket `name`: from $SPIRALPOCKET_POCKETS if it is there, or ours."""
    folder = os.environ.get("SPIRALPOCKET_POCKETS")
    file = Path(folder) / f"{name}.json" if folder else None
    if file is None or not file.is_file():
        return _MADE[name]()
    data = json.loads(file.read_text(encoding="utf-8"))
    return Polygon(data["outer"], data.get("holes", []))
