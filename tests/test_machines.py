# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine presets: ours are sound, the user's own go first, broken ones say what is wrong."""

from __future__ import annotations

import json

import pytest

from freecad_spiralpocket import machines
from freecad_spiralpocket.engine.errors import RequestError
from freecad_spiralpocket.engine.machine import CornerRule

OURS = ["benchtop", "hobby_router", "huron_840d", "ucp710", "vmc"]


def test_presets_are_listed():
    assert machines.names() == OURS


@pytest.mark.parametrize("name", OURS)
def test_preset_is_complete(name):
    data = json.loads((machines.FOLDER / f"{name}.json").read_text())
    assert data["name"]
    assert data["description"]
    assert data["source"]
    assert machines.load(name).name == data["name"]


def test_units_are_those_of_the_keys():
    hobby = machines.load("hobby_router")
    assert hobby.speed == pytest.approx((5000 / 60,) * 3)
    assert hobby.acceleration == (500.0,) * 3
    assert not hobby.has_jerk_limit
    mikron = machines.load("ucp710")
    assert mikron.acceleration[:2] == (2500.0, 3000.0)
    assert mikron.jerk[0] == 5000.0
    benchtop = machines.load("benchtop")
    assert benchtop.corner_rule is CornerRule.JUNCTION_DEVIATION
    assert (benchtop.block_rate, benchtop.look_ahead) == (500.0, 100)


def write(folder, stem, **changes):
    """Write a preset like vmc.json, changed; a change to None leaves the key out."""
    data = json.loads((machines.FOLDER / "vmc.json").read_text()) | changes
    data = {key: value for key, value in data.items() if value is not None}
    (folder / f"{stem}.json").write_text(json.dumps(data))


def test_own_preset_goes_before_ours(tmp_path):
    write(tmp_path, "vmc", name="My mill")
    write(tmp_path, "lathe")
    assert machines.load("vmc", tmp_path).name == "My mill"
    assert machines.load("ucp710", tmp_path).name == "Mikron UCP710"
    assert sorted(machines.names(tmp_path)) == sorted([*OURS, "lathe"])


def test_unknown_machine_names_those_that_are_known():
    with pytest.raises(RequestError, match="no machine 'laser'.*hobby_router"):
        machines.load("laser")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"corner": None}, "lacks 'corner'"),
        ({"speed_mm_per_min": [1, 2]}, "broken"),
        ({"acceleration_mm_per_s2": [1, 0, 1]}, "acceleration must be three positive"),
        ({"corner": {"rule": "magic", "tolerance_mm": 1}}, "magic"),
        ({"corner": {"rule": "corner speed"}}, "lacks 'speed_mm_per_s'"),
    ],
)
def test_broken_preset_says_what_is_wrong(tmp_path, changes, message):
    write(tmp_path, "mine", **changes)
    with pytest.raises(RequestError, match=message):
        machines.load("mine", tmp_path)


def test_file_that_is_no_json_is_refused(tmp_path):
    (tmp_path / "mine.json").write_text("speed = 3")
    with pytest.raises(RequestError, match="mine.json is broken"):
        machines.load("mine", tmp_path)
