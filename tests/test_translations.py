# SPDX-License-Identifier: LGPL-2.1-or-later
"""The .ts files: nearly all texts are translated, with every place for a figure kept."""

import importlib.util
import json
import re
from pathlib import Path

import pytest

FOLDER = Path(__file__).parent.parent / "resources" / "translations"
#: Share of the texts that may be new since the last ``./dev translate``.
NEW = 0.1
PLACE = re.compile(r"\{[^}]*\}")

_spec = importlib.util.spec_from_file_location("update", FOLDER / "update.py")
update = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(update)

TEXTS = {*update.collect(), *((update.MESSAGES, text) for text in update.engine_sentences())}


def translations(language):
    """Return the translations of one language by context and source."""
    return update.read(FOLDER / f"SpiralPocket_{language}.ts")


def test_texts_are_found_in_forms_code_tooltips_and_the_engine():
    for text in (
        ("SpiralPocketPanel", "Coolant"),
        ("SpiralPocketPreferences", "Defaults of new operations"),
        ("SpiralPocket_Create", "Spiral Pocket"),
        ("SpiralPocket", "Climb"),
        ("App::Property", "Ramp angle of the helical entry"),
        ("SpiralPocketMessages", "A step-over of {0} mm is wider than the {1} mm cutter."),
        ("SpiralPocketMessages", "Proving the path"),
    ):
        assert text in TEXTS


@pytest.mark.parametrize("language", update.LANGUAGES)
def test_nearly_all_texts_are_translated(language):
    missing = TEXTS - translations(language).keys()
    assert len(missing) <= NEW * len(TEXTS), "run ./dev translate and fill in: " + str(missing)


@pytest.mark.parametrize("language", update.LANGUAGES)
def test_translations_keep_the_places_for_figures(language):
    for (_, source), text in translations(language).items():
        assert sorted(PLACE.findall(source)) == sorted(PLACE.findall(text)), text


@pytest.mark.parametrize("language", update.LANGUAGES)
def test_figures_fit_into_their_places(language):
    for (context, source), text in translations(language).items():
        if context != update.MESSAGES and "{" in source:
            figures = [1.5 if ":" in place else "x" for place in PLACE.findall(source)]
            assert "{" not in text.format(*figures)


def test_templates_are_those_of_the_engine():
    templates = json.loads((FOLDER / "messages.json").read_text(encoding="utf-8"))
    missing = set(update.engine_sentences()) - set(templates)
    assert len(missing) <= NEW * len(templates), "run ./dev translate: " + str(missing)
