# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paths of a pocket's regions at the floor, by the strategy that is asked for.

They do not depend on each other, so that whoever has several cores may lay them at once:
`planner.plan` takes another `FloorPaths`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from typing import TypeAlias

from shapely import Polygon

from .errors import CancelledError, SpiralPocketError
from .floor import FloorPath
from .growth.too_wide import check_width
from .mirroring import mirrored, mirrored_request
from .model import CutMode, PocketRequest, Strategy, Tick
from .opening.open_sides import needed
from .sizes import planned_resized

#: Lays the paths of regions: called with each and its request, and what is told how far all are,
#: returns for each its path, or what is the matter with it.
FloorPaths: TypeAlias = Callable[
    [Sequence[tuple[Polygon, PocketRequest]], Tick], Sequence[FloorPath | SpiralPocketError]
]


def _by(module: str, region: Polygon, request: PocketRequest, tick: Tick) -> FloorPath:
    """Return the path by a module of `laps`, which is loaded when it is asked for.

    Some need parts of scipy that take as long to load as Automatic takes for a small pocket.
    """
    check_width(needed(region, request), request.cutting.stepover)
    return import_module(f".laps.{module}", __package__).floor_path(region, request, tick)


_STRATEGIES: dict[Strategy, Callable[[Polygon, PocketRequest, Tick], FloorPath]] = {
    Strategy.AUTOMATIC: partial(_by, "automatic"),
    Strategy.LINEAR_MORPH: partial(_by, "linear_morph"),
    Strategy.EXTENDED_ARCHIMEDEAN: partial(_by, "extended_archimedean"),
    Strategy.ISOTHERM: partial(_by, "isotherm"),
    Strategy.CENTRAL_SPIRAL: partial(_by, "central"),
}


def floor_paths(
    asked: Sequence[tuple[Polygon, PocketRequest]], tick: Tick
) -> list[FloorPath | SpiralPocketError]:
    """Return the path of each region or what is the matter with it, laid one after the other."""

    def share(number: int) -> Tick:
        return lambda done: tick((number + done) / len(asked))

    return [floor_path(*each, share(i)) for i, each in enumerate(asked)]


def floor_path(
    region: Polygon, request: PocketRequest, tick: Tick
) -> FloorPath | SpiralPocketError:
    """Return the path of one region, or what is the matter with it.

    For conventional milling it is that of the mirrored region, for climb milling.

    Raises
    ------
    CancelledError
        If `tick` does.
    """
    is_mirrored = request.cutting.cut_mode is CutMode.CONVENTIONAL
    strategy = _STRATEGIES[request.strategy]
    tick(0.0)
    if is_mirrored:
        region, request = mirrored(region), mirrored_request(request)
    if request.strategy is not Strategy.AUTOMATIC:
        part = needed(region, request)
        # a ring about what was cleared before would have an island that is none
        region = part if len(part.interiors) == len(region.interiors) else region
    try:
        return planned_resized(strategy, region, request, tick)
    except CancelledError:
        raise
    except SpiralPocketError as error:
        return error.moved(lambda place: (-place[0], place[1])) if is_mirrored else error
