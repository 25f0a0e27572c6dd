# SPDX-License-Identifier: LGPL-2.1-or-later
"""Defaults of new operations: the user's preferences, the job's setup sheet, job templates."""

import json

import FreeCAD
import pytest
from sample_parts import add_job

from freecad_spiralpocket import machines
from freecad_spiralpocket.op import operation, preferences, presets, properties, request
from freecad_spiralpocket.op.compat import PathSetupSheet

#: One value other than the default for every option that a preset may hold.
OTHERS = {
    "Strategy": "Linear Morph",
    "StepOver": 23,
    "MaxEngagement": 70.5,
    "CutMode": "Conventional",
    "StockToLeave": 0.3,
    "ZStockToLeave": 0.1,
    "HelixAngle": 3.0,
    "HelixDiameterLimit": 5.0,
    "Tolerance": 0.02,
    "Machine": "vmc",
    "FeedMode": "Chip thickness",
    "SlowdownPercent": 60,
    "MaxFeedRatio": 1.5,
    "LinkFeed": 4000.0,
    "SlotBite": 0.5,
    "FinishingProfile": False,
    "UseOutline": True,
    "ExtendOpenSides": False,
    "UseRestMachining": True,
}


def values(op):
    """Return the value of every option that a preset may hold."""
    read = {name: getattr(op, name) for name in properties.preset_names()}
    return {name: getattr(value, "Value", value) for name, value in read.items()}


def new(job):
    """Return a new operation, which has no floor and stays without a path."""
    return operation.Create("SpiralPocket", parentJob=job)


def test_every_option_is_tried():
    defaults = {p.name: p.default for p in properties.TABLE}
    assert set(OTHERS) == set(properties.preset_names())
    assert all(value != defaults[name] for name, value in OTHERS.items())


def test_options_become_the_jobs_default(job):
    first = new(job)
    for name, value in OTHERS.items():
        setattr(first, name, value)
    presets.keep(first)
    assert values(new(job)) == pytest.approx(OTHERS)


#: What would be nothing in the decimals that are shown.
FINE = {"Tolerance": 0.002, "SlotBite": 0.1234, "StockToLeave": -0.0625, "ZStockToLeave": 0.003}


@pytest.fixture(params=[0, 3], ids=["mm", "inch"])
def schema(request):
    """Set the units that are shown."""
    FreeCAD.Units.setSchema(request.param)
    yield
    FreeCAD.Units.setSchema(0)


@pytest.mark.parametrize("wanted", [OTHERS, {"UseOutline": False, "FinishingProfile": True}, FINE])
def test_a_job_template_carries_every_option(doc, job, wanted, schema):
    first = new(job)
    for name, value in wanted.items():
        setattr(first, name, value)
    presets.keep(first)
    sheet = job.SetupSheet.Proxy
    attributes = sheet.templateAttributes(includeOps=[operation.NAME])
    text = json.dumps(sheet.encodeTemplateAttributes(attributes))
    other = add_job(doc, doc.getObject("Part"))
    decoded = other.SetupSheet.Proxy.decodeTemplateAttributes(json.loads(text))
    other.SetupSheet.Proxy.setFromTemplate(decoded)
    made = values(new(other))
    assert {name: made[name] for name in wanted} == pytest.approx(wanted)


def test_a_template_of_another_user_is_read_as_far_as_it_is_known(job):
    foreign = {"Machine": "theirs", "Strategy": "Trochoidal", "SlowdownPercent": "60"}
    job.SetupSheet.Proxy.setFromTemplate({operation.NAME: foreign})
    made = new(job)
    assert (made.Machine, made.SlowdownPercent) == ("theirs", 60)
    assert made.Strategy == properties.choices()["Strategy"][0]
    presets.keep(made)
    assert new(job).Machine == "theirs"


@pytest.mark.parametrize("text", ["0.00 in", "fine"])
def test_a_tolerance_that_a_template_has_lost_is_the_default(job, text):
    lengths = {"Tolerance": text, "SlotBite": "0.00 in", "StockToLeave": "0.2"}
    job.SetupSheet.Proxy.setFromTemplate({operation.NAME: lengths})
    made = values(new(job))
    assert {name: made[name] for name in lengths} == pytest.approx(
        {"Tolerance": 0.01, "SlotBite": 0, "StockToLeave": 0.2}
    )


def test_lengths_that_an_older_setup_sheet_holds_are_taken_and_renewed(job):
    name = PathSetupSheet.OpPropertyName(operation.NAME, "SlotBite")
    job.SetupSheet.addProperty("App::PropertyLength", name)
    setattr(job.SetupSheet, name, 0.4)
    made = new(job)
    assert made.SlotBite.Value == 0.4
    made.SlotBite = 0.1234
    presets.keep(made)
    assert getattr(job.SetupSheet, name) == "0.1234 mm"


def test_the_jobs_editor_shows_lengths(job):
    presets.keep(new(job))
    prototype = PathSetupSheet._RegisteredOps[operation.NAME].prototype(operation.NAME)
    name = PathSetupSheet.OpPropertyName(operation.NAME, "Tolerance")
    shown = prototype.getProperty("Tolerance")
    shown.setValue(getattr(job.SetupSheet, name))
    assert shown.displayString() == shown.getValue().getUserPreferred()[0]
    assert shown.getValue().Value == 0.01
    shown.setValue(FreeCAD.Units.Quantity("0.05 mm"))
    group = PathSetupSheet.OpPropertyGroup(operation.NAME)
    assert not shown.setupProperty(job.SetupSheet, name, group, shown.getValue())
    assert new(job).Tolerance.Value == 0.05


def test_a_setup_sheet_of_another_user_is_read_as_far_as_it_is_known(job):
    first = new(job)
    for name, value in OTHERS.items():
        setattr(first, name, value)
    presets.keep(first)
    for name in ("Machine", "Strategy"):
        option = PathSetupSheet.OpPropertyName(operation.NAME, name)
        setattr(job.SetupSheet, option, ["theirs"])
        setattr(job.SetupSheet, option, "theirs")
    strategy = properties.choices()["Strategy"][0]
    assert values(new(job)) == pytest.approx(OTHERS | {"Machine": "theirs", "Strategy": strategy})


def test_preferences_set_new_operations_and_the_setup_sheet_goes_before_them(job, parameters):
    wanted = {name: OTHERS[name] for name in preferences.NAMES}
    defaults = {p.name: p.default for p in properties.TABLE}
    for name, value in wanted.items():
        preferences.write(name, value, defaults[name])
    made = new(job)
    assert {name: values(made)[name] for name in wanted} == pytest.approx(wanted)
    job.SetupSheet.Proxy.setFromTemplate({operation.NAME: {"StepOver": "31"}})
    assert new(job).StepOver == 31


def test_a_preferred_default_is_not_kept(parameters):
    preferences.write("StepOver", 30, 40)
    preferences.write("StepOver", 40, 40)
    assert not parameters.GetContents()


def test_a_preferred_choice_that_is_gone_is_passed_over(job, parameters):
    preferences.write("Machine", "sold_last_year", "hobby_router")
    assert new(job).Machine == "hobby_router"


def test_the_users_own_machines_come_from_a_folder(tmp_path, parameters):
    (tmp_path / "mine.json").write_text((machines.FOLDER / "vmc.json").read_text())
    preferences.write(preferences.MACHINE_FOLDER, str(tmp_path), "")
    folder = preferences.machine_folder()
    assert "mine" in machines.names(folder)
    assert machines.load("mine", folder) == machines.load("vmc")
    assert request.machine("mine") == machines.load("vmc")
    # a file may be edited while FreeCAD runs
    (tmp_path / "mine.json").write_text((machines.FOLDER / "hobby_router.json").read_text())
    assert request.machine("mine") == machines.load("hobby_router")
    preferences.write(preferences.MACHINE_FOLDER, str(tmp_path / "gone"), "")
    assert preferences.machine_folder() is None


def test_another_users_machine_stays_in_the_document(job):
    made = new(job)
    made.Machine = [*properties.MACHINES, "theirs"]
    made.Machine = "theirs"
    made.Proxy.onDocumentRestored(made)
    assert made.Machine == "theirs"
