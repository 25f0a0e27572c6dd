# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the engine says, in the user's language.

Engine, documents and programs speak English, whoever opens them. Only the window
translates: a finished sentence is compared with the templates that were collected
from the engine (resources/translations/messages.json), the figures in it go into the
translated template. What is not recognized stays English, sentence by sentence.
"""

from __future__ import annotations

import json
import re
from functools import cache

import FreeCAD
from PySide.QtCore import QT_TRANSLATE_NOOP

from .startup import RESOURCES

translate = FreeCAD.Qt.translate

CONTEXT = "SpiralPocketMessages"

#: What the engine puts into its sentences, or says beside them.
PHRASES = (
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "the pocket"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "rapid"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "link"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "The cutter's diameter"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "The horizontal feed"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "The vertical feed"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "The horizontal rapid rate"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "The vertical rapid rate"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "The tolerance"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "XY stock to leave"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "Z stock to leave"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "with {0} mm of stock to leave"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "Pocket {0} of {1}: {2}"),
)

_PLACE = re.compile(r"\{(\d+|at)\}")
#: How a place reads (`errors.tell`).
_AT = r"(the pocket|X-?[\d.]+ Y-?[\d.]+)"


def localized(text: str) -> str:
    """Return what the engine says in the user's language, as far as it is recognized."""
    lead, text = text[: len(text) - len(text.lstrip())], text.strip()
    for template, pattern in _patterns():
        match = pattern.match(text)
        if match:
            figures = [localized(figure) for figure in match.groups()]
            sentence = _filled(translate(CONTEXT, template), template, figures)
            return lead + sentence + localized(text[match.end() :])
    subject, colon, rest = text.partition(": ")  # "Part, Face3: The cutter does not fit ..."
    return lead + (subject + colon + localized(rest) if colon else text)


def _filled(translated: str, template: str, figures: list[str]) -> str:
    """Return a translated template with the figures in their places."""
    by_place = dict(zip(_PLACE.findall(template), figures, strict=True))
    return _PLACE.sub(lambda place: by_place[place[1]], translated)


@cache
def _patterns() -> list[tuple[str, re.Pattern[str]]]:
    """Return templates and what matches them, those with the most words of their own first."""
    file = RESOURCES / "translations" / "messages.json"
    templates = [*json.loads(file.read_text(encoding="utf-8")), *PHRASES]
    templates.sort(key=lambda template: -len(_PLACE.sub("", template)))
    return [(template, _pattern(template)) for template in templates]


def _pattern(template: str) -> re.Pattern[str]:
    parts = _PLACE.split(template)
    words, places = parts[::2], parts[1::2]
    text = re.escape(words[0])
    for place, word in zip(places, words[1:], strict=True):
        text += (_AT if place == "at" else "(.*?)") + re.escape(word)
    return re.compile(text + (r"(?= |$)" if words[-1] else "$"))
