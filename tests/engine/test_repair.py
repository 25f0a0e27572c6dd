# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair: faulty strategies are put in place of sound ones, and what comes of it."""

import dataclasses

import numpy as np
import pytest
from shapely import LineString, Polygon, box
from shapely.ops import substring
from shapes import HEIGHTS, SQUARE, rounded
from shapes import request as request_of

from freecad_spiralpocket.engine import floor_paths, plan, planner
from freecad_spiralpocket.engine.errors import NotYetError, ProofError
from freecad_spiralpocket.engine.floor import FloorPath, Pass
from freecad_spiralpocket.engine.laps import linear_morph
from freecad_spiralpocket.engine.model import CutMode, Cutting, Strategy
from freecad_spiralpocket.engine.repair import (
    OTHERS,
    STEPOVERS,
    Proved,
    badness,
    other_settings,
    with_lifts,
)
from freecad_spiralpocket.engine.toolpath import Kind, Role

STEPOVER = 2.4
FAR = np.array([[38.0, 8.0]])  # in the square's corner, which stands until the last laps


def sound(region, request, tick):
    return linear_morph.floor_path(region, request, tick)


def begins_with(*passes):
    """Return a strategy whose paths run `passes` after the entry."""

    def strategy(region, request, tick):
        path = sound(region, request, tick)
        return dataclasses.replace(path, passes=(*passes, *path.passes))

    return strategy


def back(path):
    """Return the way to a far place and back to where the first pass begins."""
    return np.vstack([FAR, path.passes[0].points[:1]])


def strays(region, request, tick):
    """Cut soundly, but link through the stock and back first."""
    path = sound(region, request, tick)
    return dataclasses.replace(path, passes=(Pass(back(path), Role.LINK), *path.passes))


def strays_twice(region, request, tick):
    """Link twice over the same stock: the first clears the way for the second."""
    path = sound(region, request, tick)
    links = (Pass(back(path), Role.LINK), Pass(back(path), Role.LINK))
    return dataclasses.replace(path, passes=(*links, *path.passes))


def leaves_half(region, request, tick):
    """Forget all but the first half of the spiral."""
    path = sound(region, request, tick)
    points = path.passes[0].points
    return FloorPath(path.entry, (Pass(points[: len(points) // 2], Role.CUT),))


def leaves_an_edge(region, request, tick):
    """Cut all but a strip along one side, whatever the step-over."""
    x0, y0, x1, y1 = region.bounds
    return sound(region.intersection(box(x0, y0, x1 - 5.0, y1)), request, tick)


def gouges(region, request, tick):
    """Cut 0.5 mm into the wall at the end."""
    path = sound(region, request, tick)
    x1, y = region.bounds[2], region.centroid.y
    into = Pass(np.array([[x1 - 1, y], [x1 + 0.5, y], [x1 - 1, y]]), Role.CUT)
    return dataclasses.replace(path, passes=(*path.passes[:2], into))


def only_if_as_asked(faulty):
    """Return a strategy that is faulty at the step-over that was asked for."""

    def strategy(region, request, tick):
        asked = request.cutting.stepover == STEPOVER
        return (faulty if asked else sound)(region, request, tick)

    return strategy


@pytest.fixture
def use(monkeypatch):
    """Return a function that plans the square by a strategy in Automatic's place."""

    def plan_by(strategy, other=sound, last=None, **changes):
        monkeypatch.setitem(floor_paths._STRATEGIES, Strategy.AUTOMATIC, strategy)
        monkeypatch.setitem(floor_paths._STRATEGIES, Strategy.LINEAR_MORPH, other)
        monkeypatch.setitem(floor_paths._STRATEGIES, Strategy.EXTENDED_ARCHIMEDEAN, last or other)
        return plan(request_of(SQUARE, strategy=Strategy.AUTOMATIC, **changes))

    return plan_by


def refuses(region, request, tick):
    raise NotYetError("Not this one.")


@pytest.mark.parametrize("mode", CutMode)
def test_a_link_through_stock_becomes_a_lift(use, mode):
    cutting = dataclasses.replace(request_of(SQUARE).cutting, cut_mode=mode)
    plain = use(sound, cutting=cutting)
    made = use(strays, other=strays, cutting=cutting)
    assert made.report.link_hit == made.report.rapid_hit == 0.0
    assert made.report.notices == plain.report.notices
    lifts = made.toolpath.kinds == Kind.RAPID
    assert lifts.sum() == (plain.toolpath.kinds == Kind.RAPID).sum() + 2
    assert made.report.uncut_area == pytest.approx(plain.report.uncut_area, abs=1e-3)


def test_a_link_that_only_touches_stock_is_cut_at_its_ends(use):
    def touches(region, request, tick):
        """Cut soundly, but take the last 0.4 mm of the first lap for a link."""
        path = sound(region, request, tick)
        first = LineString(path.passes[0].points)
        begin, end = (substring(first, *s).coords for s in ((0, 0.4), (0.4, first.length)))
        link, rest = Pass(np.array(begin), Role.LINK), Pass(np.array(end), Role.CUT)
        return dataclasses.replace(path, passes=(link, rest, *path.passes[1:]))

    plain, made = use(sound), use(touches, other=refuses)
    assert made.report.link_hit == made.report.rapid_hit == 0.0
    rapids = [(p.toolpath.kinds == Kind.RAPID).sum() for p in (plain, made)]
    assert rapids[0] == rapids[1]
    assert made.report.uncut_area == pytest.approx(plain.report.uncut_area, abs=1e-3)


def test_it_becomes_a_lift_at_every_level(use):
    made = use(strays, heights=dataclasses.replace(HEIGHTS, step_down=2.0))
    assert made.report.link_hit == made.report.rapid_hit == 0.0


def test_a_link_that_ends_in_stock_is_planned_again(use):
    made = use(only_if_as_asked(begins_with(Pass(FAR, Role.LINK))))
    assert made.report.link_hit == made.report.rapid_hit == 0.0
    assert made.report.uncut_area < 0.01


def test_what_fails_at_every_stepover_is_planned_by_the_other_strategy(use):
    made = use(begins_with(Pass(FAR, Role.LINK)))
    assert made.report.link_hit == made.report.rapid_hit == 0.0
    assert len(made.curves) == 1
    (told,) = [n for n in made.report.notices if "failed its proof" in n.message]
    assert "is cut by Linear Morph instead of Automatic" in told.message


def test_what_stays_in_stock_is_refused_with_its_place(use):
    faulty = begins_with(Pass(FAR, Role.LINK))
    with pytest.raises(ProofError, match="through standing stock") as caught:
        use(faulty, other=faulty)
    assert caught.value.place == pytest.approx(FAR[0])


def test_a_gouge_is_cured_by_a_smaller_stepover(use):
    made = use(only_if_as_asked(gouges))
    assert made.report.gouge <= made.request.tolerance
    (told,) = [n for n in made.report.notices if "failed its proof" in n.message]
    assert "a step-over of 2.23 mm instead of 2.4 mm" in told.message
    assert told.hint.startswith("Set StepOver to 37")


def test_a_gouge_above_a_fine_tolerance_is_none_the_less(use):
    proved = Proved((), None, use(sound).report, frozenset())
    fine = dataclasses.replace(request_of(SQUARE), tolerance=0.001)
    report = dataclasses.replace(proved.report, gouge=0.002)
    assert badness(dataclasses.replace(proved, report=report), fine)[0] > 0


def test_a_gouge_that_stays_is_refused(use):
    with pytest.raises(ProofError, match="into a wall or the floor"):
        use(gouges, other=gouges)


def test_ground_left_is_cured_by_a_smaller_stepover(use):
    made = use(only_if_as_asked(leaves_half))
    assert made.report.uncut_area < 0.01


def test_it_is_cured_too_where_a_closing_lap_is_not_wanted_that_automatic_has_not(use):
    made = use(only_if_as_asked(leaves_half), cutting=Cutting(STEPOVER, finishing_lap=False))
    assert made.report.uncut_area < 6.0  # corners: what stands in for Automatic leaves these


def test_what_a_smaller_stepover_leaves_as_it_was_goes_to_the_other_strategy_at_once(use):
    planned = []

    def leaves_it(region, request, tick):
        planned.append(request.cutting.stepover)
        return leaves_an_edge(region, request, tick)

    made = use(leaves_it)
    assert made.report.uncut_area == 0.0
    assert planned == [STEPOVER, pytest.approx(STEPOVERS[0] * STEPOVER)]


@pytest.mark.parametrize("faulty", [gouges, begins_with(Pass(FAR, Role.LINK)), leaves_an_edge])
def test_what_the_other_strategy_refuses_goes_to_the_last(use, faulty):
    made = use(faulty, other=refuses, last=sound)
    assert made.report.uncut_area < 0.01
    (told,) = [n for n in made.report.notices if "the path asked for" in n.message]
    assert "by Extended Archimedean instead of Automatic" in told.message
    assert ("mm2 standing" in told.message) == (faulty is leaves_an_edge)


def test_ground_that_stays_is_told_with_place_and_area(use):
    made = use(leaves_half, other=leaves_half)
    assert made.report.uncut_area > 100
    (told,) = [n for n in made.report.notices if "stay uncut" in n.message]
    assert told.place is not None and "mm2" in told.message


def test_only_the_room_that_is_sick_is_planned_again(use, monkeypatch):
    planned = []

    def strategy(region, request, tick):
        planned.append((region.centroid.x > 0, request.cutting.stepover))
        faulty = gouges if planned[-1] == (True, STEPOVER) else sound
        return faulty(region, request, tick)

    rooms = [rounded(box(x, 0, x + 30, 24), 4.0) for x in (-40, 10)]
    both = rooms[0].union(rooms[1]).union(box(-12, 10, 12, 14))  # a neck too narrow for the cutter
    monkeypatch.setitem(floor_paths._STRATEGIES, Strategy.AUTOMATIC, strategy)
    made = plan(request_of(both, strategy=Strategy.AUTOMATIC))
    assert made.report.gouge <= made.request.tolerance
    assert sorted(planned) == [(False, 2.4), (True, pytest.approx(0.93 * 2.4)), (True, 2.4)]


def test_a_sound_path_is_proved_once(use, monkeypatch):
    proofs = []
    prove = planner.prove
    monkeypatch.setattr(planner, "prove", lambda *args: proofs.append(1) or prove(*args))
    made = use(sound)
    proved = Proved((), made.toolpath, made.report, frozenset())
    assert len(proofs) == 1 and not any(badness(proved, made.request))


def test_ground_in_a_room_without_a_path_is_no_fault(use, monkeypatch):
    proofs = []
    prove = planner.prove
    monkeypatch.setattr(planner, "prove", lambda *args: proofs.append(1) or prove(*args))

    def strategy(region, request, tick):
        return (refuses if region.centroid.x > 0 else sound)(region, request, tick)

    rooms = [rounded(box(x, 0, x + 30, 24), 4.0) for x in (-40, 10)]
    both = rooms[0].union(rooms[1]).union(box(-12, 10, 12, 14))
    monkeypatch.setitem(floor_paths._STRATEGIES, Strategy.AUTOMATIC, strategy)
    made = plan(request_of(both, strategy=Strategy.AUTOMATIC))
    assert made.report.uncut_area > 100 and len(proofs) == 1


def test_other_strategies_come_last():
    asked = request_of(SQUARE, strategy=Strategy.LINEAR_MORPH)
    tried = other_settings(asked)
    assert [t.cutting.stepover for t in tried] == pytest.approx([2.232, 1.92, 1.536, 2.4])
    assert [t.strategy for t in tried][-1] is Strategy.AUTOMATIC
    tried = other_settings(request_of(SQUARE, strategy=Strategy.AUTOMATIC))
    assert tuple(t.strategy for t in tried[3:]) == OTHERS


@pytest.mark.parametrize("share", [0.5, 0.9])
def test_wide_laps_that_leave_stock_where_they_meet_are_laid_closer(share):
    pocket = Polygon([(0, 0), (100, 0), (100, 35), (35, 35), (35, 100), (0, 100)])
    asked = request_of(rounded(pocket, 4.0), strategy=Strategy.AUTOMATIC)
    width = share * asked.tool_diameter
    made = plan(
        dataclasses.replace(asked, cutting=dataclasses.replace(asked.cutting, stepover=width))
    )
    assert made.report.uncut_area < 0.01
    assert "instead of" in made.report.notices[0].message


def test_step_over_that_automatic_does_not_use_whole_is_told():
    asked = request_of(SQUARE, strategy=Strategy.AUTOMATIC)
    told = [
        [n.message for n in plan(dataclasses.replace(asked, cutting=Cutting(width))).report.notices]
        for width in (0.44 * asked.tool_diameter, 0.6 * asked.tool_diameter)
    ]
    assert told[0] == [] and "step-over of 60 % Automatic uses 44" in told[1][0]


def test_a_link_behind_another_is_lifted_too(use):
    plain, made = use(sound), use(strays_twice, other=strays_twice)
    assert made.report.link_hit == made.report.rapid_hit == 0.0
    lifts = made.toolpath.kinds == Kind.RAPID
    assert lifts.sum() == (plain.toolpath.kinds == Kind.RAPID).sum() + 4


def test_a_link_at_the_very_end_is_left_out():
    points = np.array([[1.0, 2.0], [3.0, 4.0]])
    cut, link = Pass(points, Role.CUT), Pass(points, Role.LINK)
    path = FloorPath(None, (cut, link, cut, link))
    roles = [part.role for part in with_lifts(path, {1, 3}).passes]
    assert roles == [Role.CUT, Role.AIR, Role.CUT]
