# SPDX-License-Identifier: LGPL-2.1-or-later
"""One table makes, defaults, presets and migrates the operation's properties."""

import pytest

from freecad_spiralpocket.engine.model import CutMode, Strategy
from freecad_spiralpocket.op import operation, properties
from freecad_spiralpocket.op.compat import PathSetupSheet

PROTOTYPE_TYPES = {
    "App::PropertyAngle",
    "App::PropertyBool",
    "App::PropertyDistance",
    "App::PropertyEnumeration",
    "App::PropertyFloat",
    "App::PropertyInteger",
    "App::PropertyLength",
    "App::PropertyPercent",
    "App::PropertyString",
    "App::PropertyStringList",
    "App::PropertyVectorDistance",
    "Part::PropertyPartShape",
}


@pytest.fixture
def op(job):
    """Return a new operation; it has no floor and stays without a path."""
    return operation.Create("SpiralPocket", parentJob=job)


@pytest.mark.parametrize("row", properties.TABLE, ids=lambda row: row.name)
def test_a_new_operation_has_the_property_as_the_table_says(op, row):
    assert op.getTypeIdOfProperty(row.name) == row.type
    assert op.getGroupOfProperty(row.name) == row.group
    assert op.getDocumentationOfProperty(row.name) == row.tooltip
    value = getattr(op, row.name)
    value = getattr(value, "Value", value)
    if row.name == "SchemaVersion":
        assert value == properties.SCHEMA_VERSION
    elif row.default is not None and row.name != "Notices":
        assert value == pytest.approx(row.default)
    if row.choices:
        assert op.getEnumerationsOfProperty(row.name) == list(row.choices)


@pytest.mark.parametrize("row", properties.TABLE, ids=lambda row: row.name)
def test_rows_use_types_that_the_job_editor_knows(row):
    assert row.type in PROTOTYPE_TYPES


def test_tooltips_are_sentences_without_full_stop():
    assert all(row.tooltip[0].isupper() and row.tooltip[-1] != "." for row in properties.TABLE)


def test_rows_are_no_newer_than_the_schema():
    assert max(row.since for row in properties.TABLE) == properties.SCHEMA_VERSION
    assert len({row.name for row in properties.TABLE}) == len(properties.TABLE)


def test_choices_follow_the_engine():
    assert properties.choices()["Strategy"] == tuple(s.value for s in Strategy)
    assert properties.choices()["CutMode"] == tuple(m.value for m in CutMode)


def test_results_and_schema_version_cannot_be_edited(op):
    for row in properties.TABLE:
        modes = {"ReadOnly": row.group == properties.RESULT, "Hidden": row.name == "SchemaVersion"}
        assert {m: m in op.getEditorMode(row.name) for m in modes} == modes


def test_enumerations_are_offered_with_coolant_and_translations():
    names = dict(operation.ObjectSpiralPocket.opPropertyEnumerations())
    raw = operation.ObjectSpiralPocket.opPropertyEnumerations("raw")
    assert set(names) == set(raw) == {"CoolantMode", *properties.choices()}
    assert names["CutMode"] == [data for _, data in raw["CutMode"]] == ["Climb", "Conventional"]


def test_the_setup_sheet_knows_the_operation_and_its_options():
    registered = PathSetupSheet._RegisteredOps[operation.NAME]
    places = ("UseStartPoint", "StartPoint")  # a place on one part is no preset
    wanted = [name for name in properties.option_names() if name not in places]
    assert list(registered.properties()) == wanted
    prototype = registered.prototype(operation.NAME)
    assert {row.name for row in properties.TABLE} <= set(prototype.properties)
    assert prototype.getProperty("CutMode").getEnumValues() == ["Climb", "Conventional"]


def test_a_preset_of_the_setup_sheet_sets_new_operations(job):
    sheet = job.SetupSheet
    preset = {operation.NAME: {"StepOver": "25", "HelixAngle": "3 deg", "CutMode": "Conventional"}}
    sheet.Proxy.setFromTemplate(preset)
    made = operation.Create("SpiralPocket", parentJob=job)
    assert (made.StepOver, made.HelixAngle.Value, made.CutMode) == (25, 3.0, "Conventional")


def test_a_preset_survives_a_job_template(job):
    job.SetupSheet.Proxy.setFromTemplate({operation.NAME: {"StepOver": "25"}})
    attributes = job.SetupSheet.Proxy.templateAttributes(includeOps=[operation.NAME])
    assert attributes[operation.NAME] == {"StepOver": "25"}


def test_migration_adds_what_an_older_release_lacked_and_keeps_the_rest(op):
    op.StepOver, op.CutMode, op.HelixAngle = 33, "Conventional", 2
    op.removeProperty("Tolerance")
    op.removeProperty("SchemaVersion")
    op.CutMode = ["Conventional"]  # as if the other choice came later
    op.Proxy.onDocumentRestored(op)
    assert op.Tolerance.Value == pytest.approx(0.01)
    assert op.SchemaVersion == properties.SCHEMA_VERSION
    assert op.getEnumerationsOfProperty("CutMode") == ["Climb", "Conventional"]
    assert (op.StepOver, op.CutMode, op.HelixAngle.Value) == (33, "Conventional", 2)


def test_migration_adds_the_second_schemas_properties(op):
    for name in ("MaxEngagement", "UseStartPoint", "StartPoint"):
        op.removeProperty(name)
    op.StepOver, op.SchemaVersion = 33, 1
    op.Proxy.onDocumentRestored(op)
    assert (op.StepOver, op.MaxEngagement.Value, op.UseStartPoint) == (33, 0, False)
    assert tuple(op.StartPoint) == (0, 0, 0)


def test_migration_leaves_a_current_document_alone(op):
    op.purgeTouched()
    op.Proxy.onDocumentRestored(op)
    assert "Touched" not in op.State
