# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof: what it finds on a path, and what it says."""

from dataclasses import replace

import numpy as np
import pytest
from drawn import FEED, FLOOR, R, lines, started
from shapely import Polygon, box
from shapes import FEEDS

from freecad_spiralpocket.engine import repair
from freecad_spiralpocket.engine.machine import MIDDLING, Machine
from freecad_spiralpocket.engine.model import Cutting, Heights, PocketRequest, Report
from freecad_spiralpocket.engine.motion.timing import time_of
from freecad_spiralpocket.engine.proof.findings import tell_engagement
from freecad_spiralpocket.engine.proof.verify import prove
from freecad_spiralpocket.engine.toolpath import Role, Toolpath, ToolpathBuilder

SQUARE = box(0, 0, 40, 40)


def request(pocket: Polygon, stepover: float = 2.4, **changes) -> PocketRequest:
    heights = Heights(15.0, 3.0, 0.0, changes.pop("final_depth", FLOOR), 5.0)
    cutting = Cutting(stepover, **changes)
    return PocketRequest(pocket, 2 * R, heights, FEEDS, cutting)


def ramped(x: float, y: float) -> ToolpathBuilder:
    """Return the beginning of a path that ramps down, over 8 mm to the right and back."""
    builder = ToolpathBuilder((x, y, 5.0))
    builder.rapid(50.0, z=0.0)
    builder.line((x + 8, y, FLOOR), FEED, Role.ENTRY)
    builder.line((x, y, FLOOR), FEED, Role.ENTRY)
    return builder


def clears_square(stepover: float = 2.0) -> Toolpath:
    """Return a path that clears the square: to and back, then along the walls."""
    builder = ramped(3.0, 3.0)
    for i, y in enumerate(np.arange(3.0, 37.0 + 1e-9, stepover)):
        lines(builder, *((3.0, y), (37.0, y))[:: 1 if i % 2 == 0 else -1])
    return lines(builder, (37, 37), (37, 3), (3, 3), (3, 37), (37, 37)).build()


def proved(path: Toolpath, pocket: Polygon = SQUARE, **changes) -> Report:
    return prove(request(pocket, **changes), path)


def said(report: Report) -> str:
    return "\n".join(str(notice) for notice in report.notices)


def test_clean_path_has_nothing_to_say():
    report = proved(clears_square(), stepover=6.0)
    assert report.notices == ()
    assert report.gouge == pytest.approx(0.0, abs=1e-9)
    assert report.uncut_area == 0.0
    assert (report.rapid_hit, report.link_hit, report.over_limit_share) == (0.0, 0.0, 0.0)


def test_length_is_that_of_the_cuts():
    path = clears_square()
    assert proved(path).cut_length == pytest.approx(path.lengths[1:].sum())


def test_time_is_that_of_the_machine():
    path = clears_square()
    at_feed = np.sum(path.lengths / path.feeds)
    agile = Machine("Agile", speed=(1e4,) * 3, acceleration=(1e9,) * 3)
    on_it = prove(replace(request(SQUARE), machine=agile), path)
    assert on_it.time == pytest.approx(at_feed, rel=2e-3)  # it rounds corners a little
    assert proved(path).time == time_of(path, MIDDLING).total > at_feed


def test_engagement_over_the_limit_is_told_in_degrees():
    path = lines(started(3, 3), (37, 3), (37, 20), (3, 20)).build()
    report = proved(path)
    assert np.degrees(report.engagement_max) == pytest.approx(180.0, abs=0.01)
    assert report.engagement_max >= report.engagement_p99 >= report.engagement_mean
    assert "the engagement reaches 180 degrees, the step-over of 40 % allows 78; " in said(report)


@pytest.mark.parametrize("feed", [FEED, FEEDS.horizontal])
def test_what_is_told_of_the_feed_is_true(feed):
    builder = started(3, 3)
    builder.line((37, 3, FLOOR), feed, Role.CUT)
    report = proved(builder.build())
    assert ("The feed is lowered there" in said(report)) == (feed < FEEDS.horizontal)


def test_links_do_not_dilute_the_engagement():
    cut = lines(started(3, 3), (37, 3), (37, 20), (3, 20))
    alone = proved(cut.build())
    linked = proved(lines(cut, (20, 20), (3, 20), (37, 20), role=Role.LINK).build())
    for name in ("engagement_p99", "engagement_mean", "over_limit_share"):
        assert getattr(linked, name) == pytest.approx(getattr(alone, name)), name


@pytest.mark.parametrize("role", [Role.CUT, Role.ENTRY])
def test_no_way_straight_down_goes_into_stock_unseen(role):
    cleared = lines(ramped(3, 3), (37, 3))
    cleared.rapid(50.0, z=1.0)
    cleared.rapid(50.0, 20.0, 3.0)
    cleared.line((20, 3, FLOOR), FEED, role)
    assert proved(cleared.build()).link_hit == 0.0
    cleared.rapid(50.0, z=1.0)
    cleared.rapid(50.0, 20.0, 12.0)
    cleared.line((20, 12, FLOOR), FEED, role)
    report = proved(cleared.build())
    assert report.link_hit == pytest.approx(1.0 - FLOOR)
    assert "runs through standing stock at X20.0 Y12.0" in said(report)


def test_entry_is_not_judged():
    # one and a half circumferences are 28 mm: this slot is all entry
    report = proved(lines(started(3, 20), (31, 20)).build())
    assert report.engagement_max == 0.0
    report = proved(lines(started(3, 20), (37, 20)).build())
    assert np.degrees(report.engagement_max) == pytest.approx(180.0, abs=0.01)


def test_uncut_ground_is_told_with_its_place():
    report = proved(lines(started(3, 3), (37, 3), (37, 37)).build())
    assert "of the floor stay uncut, the largest part at X" in said(report)
    corners = (4 - np.pi) * R**2
    overlap = R**2 + 0.75 * np.pi * R**2
    swept = 2 * (34 * 2 * R + np.pi * R**2) - overlap
    assert report.uncut_area == pytest.approx(1600 - corners - swept, rel=2e-3)


def test_gouge_is_told():
    report = proved(lines(started(20, 20), (37.2, 20)).build())
    assert report.gouge == pytest.approx(0.2)
    assert "cuts 0.200 mm into the wall" in said(report)


@pytest.mark.parametrize(
    ("degrees", "share", "is_told"),
    [(90, 0.5, False), (98, 0.0005, False), (98, 0.002, True), (130, 0.0005, True)],
)
def test_engagement_is_told_that_is_over_the_limit_for_more_than_a_moment(degrees, share, is_told):
    told = tell_engagement(np.radians(degrees), (1.0, 2.0), share, False, request(SQUARE))
    assert bool(told) == is_told


@pytest.mark.parametrize(
    ("tolerance", "x", "told"),
    [
        (0.01, 37.012, "Lower Tolerance"),
        (0.01, 37.016, "Do not run"),
        (0.001, 37.002, "Do not run"),
        (0.02, 37.012, None),
    ],
)
def test_a_gouge_beyond_the_tolerance_is_a_reason_not_to_run_if_such_a_path_is_refused(
    tolerance, x, told
):
    wanted = replace(request(SQUARE), tolerance=tolerance)
    path = lines(started(20, 20), (x, 20)).build()
    text = said(prove(wanted, path))
    assert ("into the wall" in text) == (told is not None)
    assert told is None or told in text
    refused = repair.badness(repair.Proved((), path, prove(wanted, path), frozenset()), wanted)[0]
    assert (refused > 0) == (told == "Do not run")


def test_stock_to_leave_moves_the_wall():
    path = lines(started(20, 20), (36.7, 20)).build()
    assert proved(path, stock_to_leave=0.5).gouge == pytest.approx(0.2)
    assert proved(path, stock_to_leave=0.3).gouge == pytest.approx(0.0, abs=1e-9)
    assert proved(lines(started(20, 20), (37.2, 20)).build(), stock_to_leave=-0.2).gouge < 1e-9


def test_cut_below_the_floor_is_told():
    path = started(20, 20, z=FLOOR - 0.3).build()
    assert proved(path).gouge == pytest.approx(0.3)
    assert proved(path).gouge_place == (20, 20)
    assert "0.300 mm below the floor" in said(proved(path))
    assert proved(started(20, 20).build(), floor_stock=0.2).gouge == pytest.approx(0.2)


def test_floor_that_is_never_reached_is_uncut():
    report = proved(clears_square(), final_depth=FLOOR - 1.0)
    assert report.uncut_area == pytest.approx(40 * 40 - (4 - np.pi) * R**2, rel=1e-2)


def test_rapid_through_stock_is_told():
    builder = lines(started(3, 20), (20, 20))
    builder.rapid(50.0, x=30.0)
    report = proved(builder.build())
    assert report.rapid_hit == pytest.approx(10.0, abs=0.4)
    assert "A rapid move runs through standing stock" in said(report)
    builder = lines(started(3, 20), (20, 20))
    builder.rapid(50.0, x=3.0)
    assert proved(builder.build()).rapid_hit == 0.0


@pytest.mark.parametrize(("place", "hit"), [((10.0, 20.0), 0.0), ((10.0, 20.5), 6.0)])
def test_rapid_plunge_into_stock_is_told(place, hit):
    builder = lines(started(3, 20), (37, 20))
    builder.rapid(50.0, z=1.0)
    builder.rapid(50.0, *place)
    builder.rapid(50.0, z=FLOOR)
    assert proved(builder.build()).rapid_hit == pytest.approx(hit)


def test_rapid_plunge_onto_a_standing_post_is_told():
    builder = started(14, 10)
    builder.arc((6, 10, FLOOR), (10, 10), True, FEED, Role.CUT)
    builder.arc((14, 10, FLOOR), (10, 10), True, FEED, Role.CUT)
    builder.rapid(50.0, z=1.0)
    builder.rapid(50.0, 10.0, 10.0)
    builder.rapid(50.0, z=FLOOR)
    assert proved(builder.build()).rapid_hit > 0.0


def test_link_through_stock_is_told():
    builder = lines(ramped(3, 20), (37, 20), role=Role.CUT)
    assert proved(lines(builder, (3, 20), role=Role.LINK).build()).link_hit == 0.0
    report = proved(lines(builder, (3, 23), (20, 23), role=Role.LINK).build())
    assert report.link_hit > 15.0
    assert "A link move runs through standing stock" in said(report)


def test_entry_bite_is_the_pitch_of_the_helix():
    builder = ToolpathBuilder((22.5, 20, 5.0))
    builder.rapid(50.0, z=0.0)
    for k in range(8):
        x = 17.5 if k % 2 == 0 else 22.5
        builder.arc((x, 20, -0.625 * (k + 1)), (20, 20), True, FEED, Role.ENTRY)
    report = proved(builder.build())
    # the ground ahead was passed last 260 of 360 degrees before, ramps are taken as steps
    assert report.entry_bite == pytest.approx(1.25 * 260 / 360, abs=0.16)


def test_levels_are_judged_alike():
    once, twice = started(3, 3), started(3, 3)
    for builder, depths in ((once, (1,)), (twice, (1, 2))):
        for depth in depths:
            builder.rapid(50.0, z=1.0)
            builder.rapid(50.0, 3.0, 3.0)
            builder.line((3, 3, depth * FLOOR), FEED, Role.ENTRY)
            for i, y in enumerate(np.arange(3.0, 37.0, 2.4)):
                for x in ((3.0, 37.0), (37.0, 3.0))[i % 2]:
                    builder.line((x, y, depth * FLOOR), FEED, Role.CUT)
    one, two = proved(once.build()), proved(twice.build(), final_depth=2 * FLOOR)
    assert two.engagement_max == pytest.approx(one.engagement_max, abs=1e-6)
    assert two.engagement_mean == pytest.approx(one.engagement_mean, abs=1e-3)
    assert two.uncut_area == pytest.approx(one.uncut_area, abs=1e-6)
