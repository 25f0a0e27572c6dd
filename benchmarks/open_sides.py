# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets that are open at a side: cut from within, or peeled from the air beside the stock.

    ./dev bench open_sides

Times of each on two machines, and a picture of what Automatic takes, in build/bench. The last
line is one JSON object with the times in seconds: [from within, from the air, taken].
"""

from __future__ import annotations

import json
from pathlib import Path
from unittest import mock

from shapely import Point, Polygon, box, union_all
from shapely.geometry.polygon import orient

from freecad_spiralpocket import machines
from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.errors import SpiralPocketError
from freecad_spiralpocket.engine.floor import Plunge
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, Plan, PocketRequest
from freecad_spiralpocket.engine.opening import open_sides
from freecad_spiralpocket.picture import draw

OUT = Path(__file__).parent.parent / "build" / "bench"
RADIUS, BEYOND = 3.0, 9.0
PLATE = box(0, 0, 100, 60)
DISC = Point(50, 30).buffer(40, quad_segs=32)
RAPIDS = {"hobby_router": 5000 / 60, "vmc": 15000 / 60}


def pockets() -> dict[str, tuple[Polygon, Polygon]]:
    """Return pockets with the air beside the stock that they reach into, and the stock."""
    below = box(20 - BEYOND, -BEYOND, 80 + BEYOND, 1)
    left, front = box(-BEYOND, -BEYOND, 1, 40 + BEYOND), box(-BEYOND, -BEYOND, 50 + BEYOND, 1)
    low, high = (box(30 - BEYOND, y - BEYOND, 60 + BEYOND, y + BEYOND) for y in (0, 60))
    around = PLATE.buffer(BEYOND, join_style="mitre")
    return {
        "notch": (with_air(rounded(box(20, -30, 80, 40)), below), PLATE),
        "corner": (with_air(rounded(box(-40, -40, 50, 40)), left, front), PLATE),
        "through": (with_air(box(30, 0, 60, 60), low, high), PLATE),
        "boss": (orient(around.difference(Point(50, 30).buffer(15))), PLATE),
        "round boss": (orient(DISC.buffer(BEYOND).difference(Point(55, 30).buffer(12))), DISC),
    }


def rounded(shape: Polygon) -> Polygon:
    """Return a polygon with corners of 4 mm."""
    return shape.buffer(-4).buffer(4, quad_segs=32)


def with_air(inside: Polygon, *beside: Polygon) -> Polygon:
    """Return what of a shape lies in the plate, with the air of the shapes beside it."""
    parts = [inside.intersection(PLATE), *(one.difference(PLATE) for one in beside)]
    return orient(union_all(parts))


def request(pocket: Polygon, stock: Polygon, machine: str) -> PocketRequest:
    """Return the request for a pocket, 5 mm deep with a 6 mm cutter."""
    rapid = RAPIDS[machine]
    return PocketRequest(
        pocket,
        2 * RADIUS,
        Heights(8.0, 3.0, 0.0, -5.0, 5.0),
        Feeds(50.0, 12.5, rapid, rapid),
        Cutting(2.4),
        machine=machines.load(machine),
        stock=stock,
    )


def only(asked: PocketRequest, *, from_air: bool) -> float | None:
    """Return the time where all starts are in the air, or none is [s]."""
    every = open_sides.starts_of

    def chosen(region: Polygon, of: PocketRequest) -> list[object]:
        return [s for s in every(region, of) if isinstance(s[0].entry, Plunge) == from_air]

    with mock.patch("freecad_spiralpocket.engine.laps.automatic.starts_of", chosen):
        try:
            return round(plan(asked).report.time, 1)
        except SpiralPocketError:
            return None


def main() -> None:
    """Measure and draw all."""
    OUT.mkdir(parents=True, exist_ok=True)
    found: dict[str, dict[str, list[float | None]]] = {}
    drawn: list[Plan] = []
    for machine in RAPIDS:
        for name, (pocket, stock) in pockets().items():
            asked = request(pocket, stock, machine)
            made = plan(asked)
            times = [only(asked, from_air=False), only(asked, from_air=True)]
            found.setdefault(machine, {})[name] = [*times, round(made.report.time, 1)]
            print(machine, name, "within, air, taken [s]:", *found[machine][name], flush=True)
            if machine == "hobby_router":
                drawn.append(made)
    for name, made in zip(pockets(), drawn, strict=True):
        target = OUT / f"open-{name.replace(' ', '-')}.png"
        draw([made], target, f"{name}: {made.report.time:.1f} s")
    print(json.dumps(found))


if __name__ == "__main__":
    main()
