# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window speaks the user's language, also in what the engine says."""

import re
import xml.etree.ElementTree as ElementTree

import FreeCADGui
import pytest
from PySide import QtCore, QtGui
from window import (
    CANCEL,
    action,
    panel,
    press,
    press_toolbar_button,
    pump,
    remarks,
    select,
    settle,
    toolbar,
    wait_for,
    widget,
)

from freecad_spiralpocket.gui.panel.operation_page import FIELDS
from freecad_spiralpocket.gui.resources import RESOURCES
from freecad_spiralpocket.gui.texts import localized as module
from freecad_spiralpocket.gui.texts.localized import in_panel, localized
from freecad_spiralpocket.gui.texts.measures import length, small

FOLDER = RESOURCES / "translations"
LANGUAGES = sorted(file.stem.partition("_")[2] for file in FOLDER.glob("*.ts"))


@pytest.fixture
def marked(monkeypatch):
    """Let a translation be the text in angular quotes, to see what was recognized."""
    monkeypatch.setattr(module, "translate", lambda context, text: f"«{text}»")


@pytest.fixture
def german():
    """Let FreeCAD speak German."""
    FreeCADGui.setLocale("German")
    pump(0.3)
    yield
    FreeCADGui.setLocale("English")
    pump(0.3)


@pytest.mark.parametrize("language", LANGUAGES)
def test_compiled_files_hold_what_the_sources_say(language):
    name = f"SpiralPocket_{language}"
    translator = QtCore.QTranslator()
    assert translator.load(f"{name}.qm", str(FOLDER))
    for context in ElementTree.parse(FOLDER / f"{name}.ts").getroot().iter("context"):
        for message in context.iter("message"):
            text, source = message.findtext("translation"), message.findtext("source")
            if text:
                assert translator.translate(context.findtext("name"), source) == text


def test_four_languages():
    assert LANGUAGES == ["de", "es-ES", "fr", "zh-CN"]


def test_panel_and_command_speak_german(job, floor, german):
    select(floor)
    press_toolbar_button()
    assert widget("strategyLabel").text() == "Strategie"
    assert widget("strategy").currentText() == "Automatisch"
    assert widget("strategy").currentData() == "Automatic"
    assert "Inseln" in widget("strategyNote").text()
    assert "Umläufe" in widget("strategy").toolTip()
    assert action(toolbar()).text() == "Spiraltasche"
    press(CANCEL)


def test_the_engine_speaks_german_in_the_window(german):
    said = (
        "Part, Face7: The 6 mm cutter does not fit the 5.8 mm neck at X12.0 Y-40.5; that part "
        "(12 mm2) stays uncut. A cutter below 5.8 mm reaches it."
    )
    assert localized(said) == (
        "Part, Face7: Der 6-mm-Fräser passt nicht durch die Engstelle von 5.8 mm bei "
        "X12.0 Y-40.5; dieser Teil (12 mm2) bleibt stehen. Ein Fräser unter 5.8 mm kommt hin."
    )


@pytest.mark.parametrize("template", [t for t, _ in module.patterns()])
def test_every_sentence_is_recognized_with_its_figures(marked, template):
    figures = iter(["12.5", "7", "0.25", "3.0"])
    sentence = module._PLACE.sub(
        lambda place: "X1.0 Y-2.0" if place[1] == "at" else next(figures), template
    )
    expected = f"«{sentence}»"
    assert localized(sentence) == expected
    about = localized(f"Part, Face3: {sentence}")
    assert about in (f"Part, Face3: {expected}", f"«Part, Face3: {sentence}»")


def test_messages_name_what_the_panel_shows(job, floor, german):
    select(floor)
    press_toolbar_button()
    widgets = {name: box for box, name, _ in FIELDS}
    widgets.update(StepOver="stepOverPercent", MaxEngagement="maxEngagement")
    form = panel().operation_page.form
    for name, source in module.LABELS.items():
        box = getattr(form, widgets[name])
        label = getattr(form, f"{widgets[name]}Label", box).text()
        assert module.translate(module.PANEL, source) == label
    assert in_panel("Lower ZStockToLeave.") == "„Z-Aufmaß“ verringern."
    widget("stockToLeave").setProperty("rawValue", 50)
    settle()
    status = panel().operation_page.preview.box.status.text()
    for told in (widget("summary").text(), remarks(), status):
        assert "passt nicht" in told and "„XY-Aufmaß“" in told and "StockToLeave" not in told
    press(CANCEL)


def test_messages_name_what_freecads_own_pages_show(job, floor, german):
    select(floor)
    press_toolbar_button()
    shown = [
        label.text()
        for page in panel().featurePages
        for label in page.form.findChildren(QtGui.QLabel)
    ]
    names = [name for form in module.FREECADS_FORMS.values() for name in form.values()]
    assert len(names) == 6
    labels = {n: in_panel(f"Is it {n}?").removeprefix("Is it „").removesuffix("“?") for n in names}
    for name, label in labels.items():
        assert label in shown and label != name
    # which FreeCAD 1.0 calls otherwise than 0.20 and 1.1
    assert in_panel("Set StepDown above 0.") == f"„{labels['StepDown']}“ über 0 setzen."
    assert in_panel("Is it StartPoint?") == "Is it „Startpunkt“?"
    press(CANCEL)


def test_result_names_the_machine_as_its_field_does(job, floor, german):
    select(floor)
    press_toolbar_button()
    settle()
    assert widget("machine").currentText() == "Hobby-Portalfräse"
    assert "Zeit auf Hobby-Portalfräse" in panel().operation_page.result_box.texts
    press(CANCEL)


def test_plots_name_the_material(job, floor, german):
    select(floor)
    press_toolbar_button()
    settle()
    panel().operation_page.plots.button.setChecked(True)
    plots = panel().operation_page.plots.dock
    assert any("Aluminium 6082-T6" in axes._left_title.get_text() for axes in plots._figure.axes)
    press(CANCEL)


def test_figures_have_the_users_decimal_mark(job, floor, german):
    before = QtCore.QLocale()
    QtCore.QLocale.setDefault(QtCore.QLocale("de_DE"))
    try:
        said = "The cutter goes 0.5 mm into the walls. It is at X12.5 Y-3.0."
        assert localized(said).startswith("Der Fräser geht 0,5 mm")
        assert (small(0.25), length(12345)) == ("0,250 mm", "12,35 m")
        select(floor)
        press_toolbar_button()
        settle()
        panel().operation_page.plots.button.setChecked(True)
        plots = panel().operation_page.plots.dock
        assert plots._values_at(2.5).startswith("2,5 s")
        assert plots._figure.axes[0].xaxis.get_major_formatter()(7.5) == "7,5"
        panel().operation_page.compare.button.click()
        cards = panel().operation_page.compare.window.cards
        wait_for(lambda: cards[0].text.text(), 60)
        assert re.search(r"\d,\d s", cards[0].text.text())
        press(CANCEL)
    finally:
        QtCore.QLocale.setDefault(before)


def test_what_is_not_recognized_stays(marked):
    text = "Nobody says this. Not: this."
    assert localized(text) == text


def test_sentences_one_after_the_other_are_all_recognized(marked):
    said = "The link feed is negative. Set LinkFeed to 0 for the horizontal rapid rate."
    first, second = "The link feed is negative.", said[len("The link feed is negative. ") :]
    assert localized(said) == f"«{first}» «{second}»"
    assert localized(f"{first} Unknown words.") == f"«{first}» Unknown words."
    assert localized(f"Unknown words. {first}") == f"Unknown words. «{first}»"


@pytest.mark.parametrize("template", [t for t, _ in module.patterns() if t.endswith(".")])
def test_every_sentence_is_recognized_before_and_after_another(marked, template):
    figures = iter(["12.5", "7", "0.25", "3.0"])
    sentence = module._PLACE.sub(
        lambda place: "X1.0 Y-2.0" if place[1] == "at" else next(figures), template
    )
    other = "That part stays uncut."
    said = f"Part, Face3: {other} {sentence} {other}"
    assert localized(said) == f"Part, Face3: «{other}» «{sentence}» «{other}»"


@pytest.mark.parametrize("language", ["German", "French", "Spanish"])
def test_what_a_strategy_leaves_is_told_in_one_language(language):
    said = (
        "Central Spiral cannot go round islands; there is one at {at}.",
        "Nothing is cut below Z{0}.",
        "Choose the strategy Automatic or Isotherm for this pocket.",
    )
    FreeCADGui.setLocale(language)
    try:
        pump(0.3)
        expected = [
            module.translate(module.CONTEXT, s).replace("{at}", "X52.0 Y45.0").replace("{0}", "10")
            for s in said
        ]
        assert localized(" ".join(said).format(10, at="X52.0 Y45.0")) == " ".join(expected)
        assert not any(s.format(10, at="X52.0 Y45.0") in expected for s in said)
    finally:
        FreeCADGui.setLocale("English")
        pump(0.3)
