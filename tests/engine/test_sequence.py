# SPDX-License-Identifier: LGPL-2.1-or-later
"""The searched sequence of runs: allowed, complete, not slower, the same each time."""

import numpy as np
import pytest
import shapely
import shapes
from hypothesis import given
from hypothesis import strategies as st
from shapely import Point, box

from freecad_spiralpocket.engine import plan
from freecad_spiralpocket.engine.laps import automatic
from freecad_spiralpocket.engine.links.cleared import ENDS, NEVER
from freecad_spiralpocket.engine.links.estimates import link_seconds
from freecad_spiralpocket.engine.links.linking import hermite_links
from freecad_spiralpocket.engine.links.ordering import Step
from freecad_spiralpocket.engine.links.passes import ASIDE, SLIM, passes_of, slim
from freecad_spiralpocket.engine.links.sequence import in_better_sequence
from freecad_spiralpocket.engine.model import Strategy

#: Rows of bosses, with bays in which nearest first leaves rests behind; bays along a wall, and
#: bosses before them.
BOSSES = box(0, 0, 110, 70).difference(
    shapely.union_all([Point(x, y).buffer(7) for x in (20, 43, 66, 89) for y in (20, 49)])
)
BAYS = shapes.rounded(
    box(0, 0, 110, 60)
    - shapely.union_all([box(x, 42, x + 6, 61) for x in (20, 50, 80)])
    - shapely.union_all([Point(x, 16).buffer(5) for x in (20, 45, 70, 95)]),
    4.0,
)


@pytest.fixture(scope="module", params=[BOSSES, BAYS], ids=["bosses", "bays"])
def nearest_first(request):
    """Return what `in_better_sequence` is given for a pocket: steps, runs, situation."""
    given = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            automatic,
            "in_better_sequence",
            lambda steps, runs, situation, _: given.append((steps, runs, situation)) or steps,
        )
        plan(shapes.request(request.param, strategy=Strategy.AUTOMATIC))
    return given[0]


def searched(steps, runs, situation):
    return in_better_sequence(steps, runs, situation, lambda: None)


def test_every_run_is_cut_once_after_those_it_needs(nearest_first):
    done = set()
    for step in searched(*nearest_first):
        assert nearest_first[1][step.run].needs <= done
        done.add(step.run)
    assert len(done) == len(nearest_first[1]) == len(nearest_first[0])


def test_links_take_less_time(nearest_first):
    motion = nearest_first[2].motion
    before = link_seconds(nearest_first[0], motion)
    assert link_seconds(searched(*nearest_first), motion) < before


def test_runs_join(nearest_first):
    here = nearest_first[2].here
    steps = searched(*nearest_first)
    assert any(step.link is not None for step in steps)
    for step in steps:
        if step.link is not None:
            way = np.vstack([step.link, step.points]) if len(step.link) else step.points
            assert np.hypot(*(way[0] - here)) < 0.05
            assert np.hypot(*np.diff(way, axis=0).T).max() < 2.0
        here = step.points[-1]


def test_it_is_the_same_each_time(nearest_first):
    once, again = searched(*nearest_first), searched(*nearest_first)
    assert [step.run for step in once] == [step.run for step in again]


def test_a_link_is_free_when_what_it_needs_is_done(nearest_first):
    steps, _, situation = nearest_first
    ends = np.array([step.points[0] for step in steps])
    headings = np.tile([1.0, 0.0], (len(ends), 1))
    paths = hermite_links(situation.here, situation.heading, ends, headings, situation.radius)
    needed = situation.cleared.needed(paths).reshape(-1, paths.shape[2])
    paths = paths.reshape(-1, *paths.shape[2:])
    rng = np.random.default_rng(5)
    for i in rng.choice(len(paths), 60, replace=False):
        cleared = situation.cleared.copied()
        for stroke in set(needed[i][needed[i] >= 0].tolist()):
            cleared.finish(stroke)
        if (needed[i] == NEVER).any():
            assert not cleared.are_free(paths[i])
        else:
            # at the ends the edge of free ground is enough
            off = np.hypot(*(paths[i][:, None] - paths[i][[0, -1]]).T).min(axis=0)
            away = paths[i][off > ENDS * cleared.pixel]
            assert cleared.free[cleared.cells(away)].all()


@pytest.mark.parametrize("heading", [0.0, 0.7, 2.0])
@pytest.mark.parametrize("aside", [-0.005, 0.002, 0.005])
@pytest.mark.parametrize("back", [0.0, 0.003])
def test_steps_aside_of_micrometers_are_no_moves(heading, aside, back):
    request = shapes.request(box(0, 0, 40, 40))
    x = np.linspace(0, 6, 121)
    before = np.column_stack([x - 6, 0.02 * (x - 6) ** 2])
    after = np.column_stack([x - back, 0.02 * x**2 + aside])
    c, s = np.cos(heading), np.sin(heading)
    points = np.vstack([before, after]) @ np.array([[c, s], [-s, c]])
    slimmed = slim(points, request)
    steps = np.diff(slimmed, axis=0)
    headings = np.unwrap(np.arctan2(*steps.T[::-1]))
    assert np.abs(np.diff(headings)).max() < np.radians(5)
    np.testing.assert_array_equal(slimmed[[0, -1]], points[[0, -1]])
    off = shapely.distance(shapely.LineString(slimmed), shapely.points(points))
    assert off.max() < 2 * SLIM * request.tolerance


@given(st.floats(2.0, 40.0), st.floats(0.0, 0.2), st.floats(0.0, 2 * np.pi))
def test_a_chord_round_a_bend_of_the_wall_is_cut_inside(bend, off, heading):
    """What is cut leaves the region by next to nothing, and nothing else of it is moved."""
    request = shapes.request(box(-60, -60, 60, 60))
    region = box(-60, -60, 60, 60) - Point(0, 0).buffer(bend, quad_segs=256)
    turn = heading + np.linspace(-0.6, 0.6, 60)
    chord = (bend - off) / np.cos(turn[20:41] - heading)
    radii = np.hstack([np.full(20, bend + 0.01), chord, np.full(19, bend + 0.01)])
    points = radii[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
    (done,) = passes_of([Step(np.empty((0, 2)), points, 0)], region, request)
    out = shapely.distance(shapely.points(done.points), region)
    assert out.max() <= 1.01 * ASIDE * request.tolerance
    kept = shapely.distance(shapely.points(points), region) < 0.9 * ASIDE * request.tolerance
    off_path = shapely.distance(shapely.points(points), shapely.LineString(done.points))
    assert off_path[kept].max() < 2 * SLIM * request.tolerance
