# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closing lap: it comes to the wall without a corner, and goes all along it."""

import time

import numpy as np
import pytest
import shapely
from shapely import LineString, Point, Polygon, box
from shapes import CIRCLE, SQUARE, request

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.laps.closing import corner_fillet
from freecad_spiralpocket.engine.links.linking import come_to_wall
from freecad_spiralpocket.engine.machine import MIDDLING
from freecad_spiralpocket.engine.model import Strategy
from freecad_spiralpocket.engine.motion.blocks import blocks_of_toolpath
from freecad_spiralpocket.engine.shapes.polyline import ring_from
from freecad_spiralpocket.engine.toolpath import Role

ISLANDS = box(0, 0, 80, 60).difference(Point(25, 30).buffer(8).union(Point(58, 30).buffer(6)))
CASES = [
    (Strategy.LINEAR_MORPH, CIRCLE),
    (Strategy.CENTRAL_SPIRAL, CIRCLE),
    (Strategy.CENTRAL_SPIRAL, Point(0, 0).buffer(20).union(Point(9, 0).buffer(20))),
    (Strategy.ISOTHERM, CIRCLE),
    (Strategy.ISOTHERM, ISLANDS),
]


@pytest.mark.parametrize(("strategy", "pocket"), CASES)
def test_cutter_does_not_stop_where_it_comes_to_the_wall(strategy, pocket):
    path = plan(request(pocket, strategy=strategy)).toolpath
    finish = path.roles == Role.FINISH
    begins = np.flatnonzero(finish[1:] & ~finish[:-1] & (path.roles[:-1] == Role.CUT)) + 1
    assert len(begins) == 1 + (len(pocket.interiors) if strategy is Strategy.ISOTHERM else 0)
    blocks = blocks_of_toolpath(path, MIDDLING)
    cosines = (blocks.leave[:-1] * blocks.enter[1:]).sum(axis=1)
    for first in begins:
        assert np.degrees(np.arccos(np.clip(cosines[first - 2 : first + 3], -1, 1))).max() < 20


@pytest.mark.parametrize("aside", [(0.0, -0.01), (0.0, -0.2), (0.0, 0.0)])
def test_lap_goes_all_along_the_wall(aside):
    region = SQUARE.buffer(-3.0)
    line = LineString(region.exterior)
    lap = ring_from(np.array(line.coords)[:-1], np.array([22.0, region.bounds[3]]))
    way = come_to_wall(lap, lap[0] + aside, region, 3.0)
    assert np.allclose(way[0], lap[0] + aside)
    wall = shapely.points(shapely.get_coordinates(shapely.segmentize(line, 0.5)))
    assert shapely.distance(wall, LineString(way)).max() < 1e-9
    assert region.buffer(1e-3).covers(LineString(way))


@pytest.mark.parametrize("depth", [9.0, 15.0, 16.5, 18.0, 24.0])
def test_fillet_of_the_corners_goes_through_every_neck(depth):
    # a wide fillet left a dent in each wall of the neck that its corners did not tell of
    notch = LineString([(0, 40), (0, 15 + 7 - depth)]).buffer(7, quad_segs=32)
    region = LineString([(-19, 0), (19, 0)]).buffer(15, quad_segs=64).difference(notch)
    fillet = corner_fillet(region.buffer(-3).buffer(3, quad_segs=32), 2.4)
    assert isinstance(region.buffer(-fillet), Polygon)


def test_arcs_that_shrink_to_their_center_take_no_time():
    angles = np.sort(np.random.default_rng(1).uniform(0, 2 * np.pi, 1500))
    circle = 6.302 * np.column_stack([np.cos(angles), np.sin(angles)])
    cells = [Polygon(circle + np.array([20 * i, 0])) for i in range(12)]
    region = shapely.union_all([*cells, box(0, -0.7, 220, 0.7)])
    began = time.process_time()
    assert corner_fillet(region, 3.6) > 0
    assert time.process_time() - began < 1.0
