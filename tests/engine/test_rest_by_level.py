# SPDX-License-Identifier: LGPL-2.1-or-later
"""Levels that were cleared before to a different extent each: every one has its own rest."""

from dataclasses import replace

import numpy as np
import pytest
import shapely
from oracle import walk
from shapely import Polygon, box
from shapely.affinity import translate
from shapes import opened, rounded
from shapes import request as make_request

from freecad_spiralpocket.engine import copies, plan, planner
from freecad_spiralpocket.engine.contact.air import Stock
from freecad_spiralpocket.engine.contact.engagement import along_path, engagement_of
from freecad_spiralpocket.engine.draft import draft
from freecad_spiralpocket.engine.errors import AlreadyClearedError, GeometryError
from freecad_spiralpocket.engine.levels import at_level, levels_of
from freecad_spiralpocket.engine.mirroring import mirrored_request
from freecad_spiralpocket.engine.model import CutMode, Heights, Section, Strategy
from freecad_spiralpocket.engine.proof.verify import prove
from freecad_spiralpocket.engine.sizes import resized_request
from freecad_spiralpocket.engine.toolpath import Role, ToolpathBuilder

R, LARGE = 3.0, 8.0
TOPS = (0.0, -2.0, -4.0)
#: From the top down; each lies within the one above it.
POCKETS = [rounded(box(-by, -by, 50 + by, 40 + by), 4.0) for by in (2.0, 1.0, 0.0)]
AROUND = box(-100, -100, 150, 140)


def stock_of(pocket, cleared):
    """Return what stands of and around a pocket."""
    rest = pocket.difference(cleared).buffer(-0.015).buffer(0.02)
    return AROUND.difference(pocket.difference(rest))


def levels_request(stocks, **changes):
    """Return a request for the three levels in these stocks, from the top down."""
    floors = zip((*TOPS[1:], -6.0), POCKETS, stocks, strict=True)
    sections = tuple(Section(z, pocket, stock=stock) for z, pocket, stock in floors)
    changes.setdefault("strategy", Strategy.AUTOMATIC)
    return make_request(
        POCKETS[-1],
        sections=sections,
        heights=Heights(8.0, 3.0, 0.0, -6.0, 2.0),
        stock=shapely.union_all(stocks),
        **changes,
    )


#: What a larger cutter has cleared of each level.
CLEARED = {
    "nothing above": (POCKETS[0], POCKETS[1], opened(POCKETS[2], LARGE)),
    "nothing between": (opened(POCKETS[0], LARGE), POCKETS[1], opened(POCKETS[2], LARGE)),
    "nothing below": (opened(POCKETS[0], LARGE), POCKETS[1], POCKETS[2]),
    "none of the floor": (POCKETS[0], opened(POCKETS[1], LARGE), Polygon()),
}


def depths(made):
    """Return the Z at which something is cut along the level."""
    path = made.toolpath
    level = (path.roles == Role.CUT) & (np.abs(path.starts[:, 2] - path.points[:, 2]) < 1e-9)
    return set(path.points[level, 2].round(6).tolist())


@pytest.mark.parametrize("mode", CutMode)
@pytest.mark.parametrize("name", CLEARED)
def test_only_levels_with_a_rest_are_entered_and_it_is_cut(name, mode):
    cleared = CLEARED[name]
    asked = levels_request([stock_of(*each) for each in zip(POCKETS, cleared, strict=True)])
    asked = replace(asked, cutting=replace(asked.cutting, cut_mode=mode))
    made = plan(asked)
    wanted = [
        opened(p, R).difference(c).buffer(-0.03) for p, c in zip(POCKETS, cleared, strict=True)
    ]
    bottoms = (*TOPS[1:], -6.0)
    assert depths(made) == {z for z, w in zip(bottoms, wanted, strict=True) if not w.is_empty}
    centers = walk(made.toolpath, 0.3)[0]
    for z, left in zip(bottoms, wanted, strict=True):
        deep = centers[centers[:, 2] < z + 1e-6, :2]
        swept = shapely.union_all(shapely.buffer(shapely.points(deep), R, quad_segs=32))
        assert left.difference(swept.buffer(0.02)).area < 0.01
    report = made.report
    assert report.gouge <= asked.tolerance and report.uncut_area < 0.01
    assert report.rapid_hit == report.link_hit == 0.0


def test_nothing_left_at_any_level_is_told():
    with pytest.raises(AlreadyClearedError, match="UseRestMachining"):
        plan(levels_request([stock_of(p, p) for p in POCKETS]))


def test_crowds_of_points_are_left_out_between_upright_walls():
    pocket = shapely.segmentize(rounded(box(0, 0, 50, 40), 4.0), 0.002)
    upper, lower = stock_of(pocket, pocket), stock_of(pocket, box(0, 0, 20, 40))
    sections = Section(-2.0, pocket, stock=upper), Section(-5.0, pocket, stock=lower)
    heights = Heights(8.0, 3.0, 0.0, -5.0, 3.0)
    asked = make_request(pocket, sections=sections, heights=heights, stock=lower)
    slim = planner._without_crowds(asked)
    assert len(slim.pocket.exterior.coords) < 1000 < len(pocket.exterior.coords)
    assert [s.pocket for s in slim.sections] == [slim.pocket, slim.pocket]
    leaning = replace(asked, sections=(replace(sections[0], mouth=pocket.buffer(1.0)), sections[1]))
    assert planner._without_crowds(leaning) is leaning


def test_the_same_ground_with_other_rests_has_other_paths():
    pocket, (top, floor) = box(0, 0, 50, 40), (-2.0, -5.0)
    rests = [stock_of(pocket, opened(pocket, LARGE)), stock_of(pocket, box(0, 0, 20, 40))]
    sections = (Section(top, pocket, stock=rests[0]), Section(floor, pocket, stock=rests[1]))
    heights = Heights(8.0, 3.0, 0.0, floor, 3.0)
    asked = make_request(pocket, sections=sections, heights=heights, stock=rests[1])
    made = plan(replace(asked, strategy=Strategy.AUTOMATIC))
    path = made.toolpath
    level = np.abs(path.starts[:, 2] - path.points[:, 2]) < 1e-9
    above, below = (path.lengths[level & (path.points[:, 2] == z)].sum() for z in (top, floor))
    assert below > 1.5 * above > 0
    assert not any("instead of" in notice.message for notice in made.report.notices)
    assert made.report.uncut_area < 0.01


def straight(z, role):
    """Return a path straight down at the left of the pocket, and across its middle."""
    builder = ToolpathBuilder((5.0, 20.0, 8.0))
    builder.rapid(80.0, z=z)
    builder.line((45.0, 20.0, z), 50.0, role)
    return builder.build()


@pytest.mark.parametrize(("z", "hit"), [(-2.0, False), (-1.0, False), (-2.5, True), (-6.0, True)])
def test_the_proof_knows_what_stands_at_each_height(z, hit):
    asked = levels_request([stock_of(POCKETS[0], POCKETS[0]), AROUND, AROUND])
    report = prove(asked, straight(z, Role.LINK))
    assert (report.link_hit > 1.0) == hit
    assert (report.rapid_hit > 1.0) == hit


def test_what_was_cleared_above_weighs_nothing():
    # 2 mm stand below ground that was cleared: a third of a full cut of 6 mm
    stocks = [stock_of(POCKETS[0], POCKETS[0]), stock_of(POCKETS[1], POCKETS[1]), AROUND]
    stock = Stock.at_levels(levels_of(levels_request(stocks)))
    path = straight(-6.0, Role.CUT)
    weighed, whole = (
        along_path(path, R, axial_depth=6.0, stock=each) for each in (stock, Stock.of(AROUND))
    )
    far = whole.points[:, 0] > 20
    assert weighed.angles[far] == pytest.approx(whole.angles[far] / 3, abs=1e-6)
    assert weighed.bites[far] == pytest.approx(2.0, abs=1e-6)
    assert weighed.radial_depths[far] == pytest.approx(whole.radial_depths[far])


def test_motion_that_repeats_in_another_stock_is_measured_again():
    asked = levels_request([stock_of(POCKETS[0], POCKETS[0]), AROUND, AROUND])
    builder = ToolpathBuilder((5.0, 20.0, 8.0))
    for z in (-2.0, -4.0):
        builder.rapid(80.0, z=5.0)
        builder.rapid(80.0, 5.0, 20.0)
        builder.rapid(80.0, z=z + 2.0)
        builder.line((13.0, 20.0, z), 10.0, Role.ENTRY)
        builder.line((45.0, 20.0, z), 50.0, Role.CUT)
    found = engagement_of(builder.build(), asked)
    far = found.points[:, 0] > 20
    assert found.angles[far & (found.points[:, 2] == -2.0)].max() == 0.0
    assert found.angles[far & (found.points[:, 2] == -4.0)].min() > 3.0


def test_layers_alike_are_one_and_each_goes_up_to_the_next():
    lower = stock_of(POCKETS[2], POCKETS[2])
    stock = Stock.at_levels(levels_of(levels_request([AROUND, AROUND, lower])))
    assert stock.bottoms.tolist() == [-4.0, -6.0]
    found = [stock.at(z) for z in (5.0, -4.0, -4.001, -4.1, -6.0, -7.0)]
    assert found == [AROUND, AROUND, AROUND, lower, lower, lower]


def test_a_level_alone_is_the_request_where_all_have_the_same_stock():
    asked = levels_request([stock_of(*each) for each in zip(POCKETS, POCKETS, strict=True)])
    alone = at_level(asked, levels_of(asked)[1])
    assert alone.pocket is POCKETS[1] and alone.stock is asked.sections[1].stock
    plain = replace(asked, sections=tuple(replace(s, stock=None) for s in asked.sections))
    assert all(at_level(plain, level) is plain for level in levels_of(plain))


def test_in_the_mirror_and_in_another_size_the_stock_is_the_pocket_s():
    asked = levels_request([stock_of(p, opened(p, LARGE)) for p in POCKETS])
    for other, factor in ((mirrored_request(asked), 1.0), (resized_request(asked, 2.0), 4.0)):
        for section, was in zip(other.sections, asked.sections, strict=True):
            left = section.stock.intersection(section.pocket).area
            assert left == pytest.approx(factor * was.stock.intersection(was.pocket).area)


@pytest.mark.parametrize("off", [0.0, 0.1])
def test_copies_have_the_same_rest_at_every_level(off):
    stocks = [stock_of(p, opened(p, LARGE)) for p in POCKETS]
    asked = levels_request(stocks)
    moved = [
        replace(
            s, pocket=translate(s.pocket, 90.0), stock=translate(s.stock, 90.0 + off * (i == 1))
        )
        for i, s in enumerate(asked.sections)
    ]
    other = replace(
        asked, pocket=moved[-1].pocket, stock=translate(asked.stock, 90.0), sections=tuple(moved)
    )
    assert (copies.displacement(asked, other) is not None) == (off == 0.0)


@pytest.mark.parametrize("mode", CutMode)
def test_a_draft_is_of_the_lowest_level_with_a_rest(mode):
    cleared = zip(POCKETS, CLEARED["nothing between"], strict=True)
    asked = levels_request([stock_of(*each) for each in cleared])
    asked = replace(asked, cutting=replace(asked.cutting, cut_mode=mode))
    assert draft(asked).z == -6.0
    floor = replace(asked.sections[-1], stock=stock_of(POCKETS[-1], POCKETS[-1]))
    above = replace(asked, sections=(*asked.sections[:-1], floor))
    laps = draft(above)
    assert laps.z == -2.0 and laps.laps
    wide = POCKETS[0].buffer(-R + 0.1)
    assert all(wide.covers(shapely.LineString(lap)) for lap in laps.laps)


def test_broken_stock_of_a_level_is_refused():
    asked = levels_request([AROUND, AROUND, AROUND])
    bow = Polygon([(0, 0), (30, 30), (30, 0), (0, 30)])
    top = replace(asked.sections[0], stock=bow)
    with pytest.raises(GeometryError, match="the stock is broken"):
        plan(replace(asked, sections=(top, *asked.sections[1:])))
