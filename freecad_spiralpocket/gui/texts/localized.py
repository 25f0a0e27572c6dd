# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the engine says, in the user's language.

Engine, documents and programs speak English, whoever opens them. Only the window
translates: a finished sentence is compared with the templates that were collected
from the engine (resources/translations/messages.json), the figures in it go into the
translated template. What is not recognized stays English, sentence by sentence.

The engine names properties, as scripts know them; the panel has labels in their place.
"""

from __future__ import annotations

import json
import re
from functools import cache
from xml.etree import ElementTree

import FreeCAD
from PySide.QtCore import QT_TRANSLATE_NOOP, QFile, QLocale

from ..resources import RESOURCES
from .measures import in_user_unit

translate = FreeCAD.Qt.translate

CONTEXT = "SpiralPocketMessages"

#: What the engine puts into its sentences, or says beside them.
PHRASES = (
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "the pocket"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "feeds"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "horizontal feed"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "vertical feed"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "rapid"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "link"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "the path asked for failed its proof"),
    QT_TRANSLATE_NOOP("SpiralPocketMessages", "the path asked for would leave {0} mm2 standing"),
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

#: The form of the panel, and its labels for the properties that the engine names.
PANEL = "SpiralPocketPanel"
LABELS = {
    "StepOver": "Step over percent",
    "MaxEngagement": "Engagement angle",
    "CutMode": "Cut mode",
    "StockToLeave": "XY stock to leave",
    "ZStockToLeave": "Z stock to leave",
    "HelixAngle": "Helix ramp angle",
    "HelixDiameterLimit": "Helix max diameter",
    "SlowdownPercent": "Slow-down percent",
    "MaxFeedRatio": "Max feed ratio",
    "Tolerance": "Tolerance",
    "LinkFeed": "Link feed",
    "SlotBite": "Slot bite",
    "ExtendOpenSides": "Extend open sides",
    "UseRestMachining": "Use rest machining",
    "UseOutline": "Ignore islands",
}
START_POINT = "StartPoint"
#: FreeCAD's own pages, and their widgets with the labels for the properties that the engine names.
FREECADS_FORMS = {
    ":/panels/PageDepthsEdit.ui": {
        "startDepthLabel": "StartDepth",
        "finalDepthLabel": "FinalDepth",
        "stepDownLabel": "StepDown",
        "finishDepthLabel": "FinishDepth",
    },
    ":/panels/PageHeightsEdit.ui": {"label_7": "SafeHeight", "label_9": "ClearanceHeight"},
}
_OF_FREECAD = [name for widgets in FREECADS_FORMS.values() for name in widgets.values()]
#: Their names, also where no space parts words, as in Chinese.
_NAMES = re.compile(rf"(?<![A-Za-z])({'|'.join([*LABELS, START_POINT, *_OF_FREECAD])})(?![A-Za-z])")
_NUMBER = re.compile(r"-?\d+\.\d+")

_PLACE = re.compile(r"\{(\d+|at)\}")
#: A label before a sentence, or a sentence before another.
_LABEL_OR_SENTENCE = re.compile(r".*?(?:: |\.(?= [A-Z0-9]))")
#: A figure, or a phrase: all but the end of a sentence and the begin of another.
_FIGURE = r"((?:(?!\. [A-Z0-9]).)*?)"
#: How a place reads (`errors.tell`).
_AT = r"(the pocket|X-?[\d.]+ Y-?[\d.]+)"


def in_panel(text: str) -> str:
    """Return what the engine says in the user's language and unit, with the panel's labels."""
    return in_user_unit(_NAMES.sub(lambda name: _label(name[1]), localized(text)))


def _label(name: str) -> str:
    if name in LABELS:
        label = translate(PANEL, LABELS[name])
    elif name == START_POINT:  # whose boxes have labels of their own
        label = translate("SpiralPocket", "Start point")
    else:
        label = translate("Form", _freecads_labels().get(name, name))
    return label if label == name else translate("SpiralPocket", '"{}"').format(label)


@cache
def _freecads_labels() -> dict[str, str]:
    """Return how FreeCAD's own pages call their properties: one version as "Start Depth"."""
    labels = {}
    for name, widgets in FREECADS_FORMS.items():
        file = QFile(name)
        if not file.open(QFile.ReadOnly):
            continue
        for widget in ElementTree.fromstring(bytes(file.readAll())).iter("widget"):
            if widget.get("name") in widgets:
                text = widget.findtext("property[@name='text']/string")
                labels[widgets[widget.get("name")]] = text
        file.close()
    return labels


def localized(text: str) -> str:
    """Return what the engine says in the user's language, as far as it is recognized."""
    lead, text = text[: len(text) - len(text.lstrip())], text.strip()
    for template, pattern in patterns():
        match = pattern.match(text)
        if match:
            figures = [_figure(figure) for figure in match.groups()]
            sentence = _filled(translate(CONTEXT, template), template, figures)
            return lead + sentence + localized(text[match.end() :])
    mark = _LABEL_OR_SENTENCE.match(text)  # "Part, Face3: The cutter does not fit ..."
    return lead + (mark[0] + localized(text[mark.end() :]) if mark else text)


def _figure(text: str) -> str:
    """Return a number with the user's decimal mark, or words in the user's language."""
    if _NUMBER.fullmatch(text):
        return text.replace(".", str(QLocale().decimalPoint()))
    return localized(text)


def _filled(translated: str, template: str, figures: list[str]) -> str:
    """Return a translated template with the figures in their places."""
    by_place = dict(zip(_PLACE.findall(template), figures, strict=True))
    return _PLACE.sub(lambda place: by_place[place[1]], translated)


@cache
def patterns() -> list[tuple[str, re.Pattern[str]]]:
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
        text += (_AT if place == "at" else _FIGURE) + re.escape(word)
    return re.compile(text + (r"(?= |$)" if words[-1] else "$"))
