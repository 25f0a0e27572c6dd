# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets that are copies of each other: what is planned for one holds for all of them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import Point, box
from shapely.affinity import rotate, scale, translate
from shapely.geometry.polygon import orient
from shapes import DUMBBELL, L_SHAPE, PENTAGON, RING, SQUARE, request

from freecad_spiralpocket.engine import copies, plan
from freecad_spiralpocket.engine.errors import CutterDoesNotFitError
from freecad_spiralpocket.engine.model import CutMode, Cutting, Section, Strategy
from freecad_spiralpocket.engine.proof.verify import prove

#: Without a symmetry of its own.
HOOK = box(0, 0, 40, 30).difference(box(14, 10, 27, 31)).difference(Point(34, 6).buffer(2))


def displaced(shape, turn, x, y):
    """Return a shape turned [rad] and moved."""
    return orient(translate(rotate(shape, turn, origin=(0, 0), use_radians=True), x, y))


@given(st.floats(-math.pi, math.pi), st.floats(-300, 300), st.floats(-300, 300))
def test_a_displaced_pocket_is_a_copy(turn, x, y):
    way = copies.displacement(request(HOOK), request(displaced(HOOK, turn, x, y)))
    corners = np.array(HOOK.exterior.coords)
    there = np.array(displaced(HOOK, turn, x, y).exterior.coords)
    apart = np.linalg.norm(way.points(corners)[:, None] - there[None], axis=2).min(axis=1)
    assert apart.max() < 2 * copies.SAME


@pytest.mark.parametrize("turn", [0.0, 0.7, math.pi / 2, math.pi])
@pytest.mark.parametrize("mode", CutMode)
@pytest.mark.parametrize(
    ("pocket", "strategy"),
    [
        (HOOK, Strategy.AUTOMATIC),
        (RING, Strategy.AUTOMATIC),
        (PENTAGON, Strategy.LINEAR_MORPH),
        (L_SHAPE, Strategy.EXTENDED_ARCHIMEDEAN),
    ],
)
def test_what_is_moved_passes_the_proof_with_the_same_figures(pocket, strategy, mode, turn):
    cutting = Cutting(stepover=2.4, cut_mode=mode)
    first = request(pocket, strategy=strategy, cutting=cutting)
    other = request(displaced(pocket, turn, 120.0, -35.0), strategy=strategy, cutting=cutting)
    own = plan(first)
    moved = copies.moved(own, first, other)
    proof, report = prove(other, moved.toolpath), moved.report
    assert moved.request is other
    for name in ("time", "cut_length", "engagement_max", "engagement_p99", "gouge", "uncut_area"):
        assert getattr(report, name) == pytest.approx(getattr(proof, name), rel=1e-4, abs=1e-5)
    assert report.time == pytest.approx(own.report.time, rel=0.02)
    if report.gouge > 0:
        away = other.pocket.boundary.distance(Point(report.gouge_place))
        assert away == pytest.approx(other.cutter_radius - report.gouge, abs=1e-4)
    assert report.uncut.difference(other.pocket.buffer(0.01)).is_empty
    assert Point(report.engagement_points[0]).within(other.pocket)
    assert len(moved.curves) == len(own.curves)
    for before, after in zip(own.curves, moved.curves, strict=True):
        reach = np.linalg.norm(after.control_points - [120.0, -35.0], axis=1)
        assert reach == pytest.approx(np.linalg.norm(before.control_points, axis=1))


def test_the_first_of_all_copies_is_their_original():
    pockets = [
        SQUARE,
        HOOK,
        translate(SQUARE, 100.1, 3),
        displaced(HOOK, 2.0, 5, 5),
        rotate(SQUARE, 45),
    ]
    assert copies.originals([request(p) for p in pockets]) == [0, 1, 0, 1, 0]


@pytest.mark.parametrize(
    "other",
    [
        request(scale(HOOK, -1.0, 1.0)),
        request(translate(HOOK, 60.0), tool_diameter=5.0),
        request(HOOK.buffer(1e-4)),
        request(translate(HOOK, 60.0), strategy=Strategy.ISOTHERM),
        request(translate(HOOK, 60.0), cutting=Cutting(2.4, CutMode.CONVENTIONAL)),
        request(translate(HOOK, 60.0), stock=translate(box(0, 0, 40, 30), 60.0)),
        request(translate(HOOK, 60.0), sections=(Section(-5.0, translate(HOOK, 60.0)),)),
        request(translate(HOOK, 60.0), start_point=(65.0, 5.0)),
    ],
)
def test_what_differs_is_no_copy(other):
    assert copies.displacement(request(HOOK), other) is None
    with pytest.raises(ValueError, match="no copies"):
        copies.moved(CutterDoesNotFitError("", ""), request(HOOK), other)


@pytest.mark.parametrize("far", [60.0, 60.1])
def test_stock_start_point_and_levels_must_be_displaced_alike(far):
    def placed(x):
        wide = HOOK.buffer(1.0, join_style="mitre")
        sections = (Section(-2.0, translate(wide, x)), Section(-5.0, translate(HOOK, 60.0)))
        return request(
            translate(HOOK, 60.0) if x else HOOK,
            stock=translate(box(0, 0, 20, 30), x),
            beyond=translate(box(30, 0, 40, 30), x),
            start_point=(5.0 + x, 5.0),
            sections=sections if x else (Section(-2.0, wide), Section(-5.0, HOOK)),
        )

    assert (copies.displacement(placed(0.0), placed(far)) is not None) == (far == 60.0)


def test_an_error_is_told_at_the_copys_own_place():
    first, other = request(DUMBBELL), request(displaced(DUMBBELL, math.pi / 2, 200.0, 0.0))
    error = CutterDoesNotFitError("Too narrow at {at}.", "Take a smaller one.", (30.0, 10.0))
    moved = copies.moved(error, first, other)
    assert isinstance(moved, CutterDoesNotFitError) and moved.hint == error.hint
    assert moved.place == pytest.approx((190.0, 30.0)) or moved.place == pytest.approx(
        (210.0, -30.0)
    )
    assert error.place == (30.0, 10.0)
    assert "X30.0" not in moved.message
