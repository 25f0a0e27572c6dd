# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a large cutter leaves of a pocket, cut by a small one: the rest alone, or all of it.

    ./dev bench rest_machining

Times on two machines, and a picture of each on the router, in build/bench. The last line is one
JSON object with the times in seconds: [all by the small cutter, all by the large one, the rest].
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

from open_sides import RAPIDS
from shapely import MultiPolygon, Point, Polygon, box
from shapely.geometry.polygon import orient

from freecad_spiralpocket import machines
from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.contact.swept import cut_into_pieces
from freecad_spiralpocket.engine.model import Cutting, Feeds, Heights, PocketRequest
from freecad_spiralpocket.engine.proof.coverage import uncut_floor
from freecad_spiralpocket.engine.shapes.region import polygons_of
from freecad_spiralpocket.picture import draw

OUT = Path(__file__).parent.parent / "build" / "bench"
#: Diameters of the cutters [mm], step-over over them, thinnest rest and stock around [mm].
LARGE, SMALL, STEPOVER, SKIN, AROUND = 16.0, 6.0, 0.4, 0.015, 60.0


def pockets() -> dict[str, Polygon]:
    """Return pockets that the large cutter does not clear wholly."""
    rooms = box(0, 0, 45, 45).union(box(70, 0, 115, 45)).union(box(44, 17, 71, 28))
    posts = box(0, 0, 100, 60).difference(Point(30, 30).buffer(9)).difference(box(60, 20, 75, 40))
    return {
        "square": box(0, 0, 60, 60),
        "rooms": orient(rooms),
        "posts": orient(posts),
        "L": orient(box(0, 0, 80, 30).union(box(0, 0, 30, 80))),
    }


def request(pocket: Polygon, diameter: float, machine: str) -> PocketRequest:
    """Return the request for a pocket, 5 mm deep."""
    rapid = RAPIDS[machine]
    return PocketRequest(
        pocket,
        diameter,
        Heights(8.0, 3.0, 0.0, -5.0, 5.0),
        Feeds(50.0, 12.5, rapid, rapid),
        Cutting(STEPOVER * diameter),
        machine=machines.load(machine),
    )


def main() -> None:
    """Measure and draw all."""
    OUT.mkdir(parents=True, exist_ok=True)
    found: dict[str, dict[str, list[float]]] = {}
    for machine in RAPIDS:
        for name, pocket in pockets().items():
            whole = request(pocket, SMALL, machine)
            rough = plan(request(pocket, LARGE, machine))
            pieces = cut_into_pieces(rough.toolpath, LARGE / 2, 0.0, 5.0)
            rest = uncut_floor(pocket, pieces, -5.0, LARGE / 2, 0.0)
            rest = rest.buffer(-SKIN).buffer(SKIN + 0.005)
            around = box(*pocket.bounds).buffer(AROUND, join_style="mitre")
            stock = polygons_of(around.difference(pocket.difference(rest)))
            made = plan(replace(whole, stock=MultiPolygon(stock)))
            times = [plan(whole).report.time, rough.report.time, made.report.time]
            found.setdefault(machine, {})[name] = [round(t, 1) for t in times]
            print(machine, name, "small, large, rest [s]:", *found[machine][name], flush=True)
            if machine == "hobby_router":
                draw([made], OUT / f"rest-{name}.png", f"{name}: {made.report.time:.1f} s")
    print(json.dumps(found))


if __name__ == "__main__":
    main()
