# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the choices of the panel read, in the user's language.

What a choice is called in the document never changes; only the text does. A
strategy also has a line on what it is for.
"""

from __future__ import annotations

from contextlib import suppress

import FreeCAD
from PySide.QtCore import QT_TRANSLATE_NOOP

from ...engine.errors import RequestError
from ...op import request

translate = FreeCAD.Qt.translate

#: What each strategy is for, by the value of the engine's `Strategy`.
STRATEGY_NOTES = {
    "Automatic": QT_TRANSLATE_NOOP(
        "SpiralPocket",
        "Any pocket, with islands and necks: holds the engagement, least time on the machine",
    ),
    "Linear Morph": QT_TRANSLATE_NOOP(
        "SpiralPocket",
        "One exact B-spline from the middle to the wall, for pockets without islands",
    ),
    "Extended Archimedean": QT_TRANSLATE_NOOP(
        "SpiralPocket",
        "Even laps about the pocket's middle line, for long and branched pockets",
    ),
    "Isotherm": QT_TRANSLATE_NOOP(
        "SpiralPocket",
        "Laps like lines of equal temperature, smooth everywhere, for compact pockets",
    ),
    "Central Spiral": QT_TRANSLATE_NOOP(
        "SpiralPocket",
        "A round spiral that turns into the wall's shape, for compact pockets",
    ),
}


def choice_text(name: str, value: str) -> str:
    """Return how the choice `value` of the property `name` reads."""
    if name == "Machine":
        with suppress(RequestError):  # the file of a machine of the user's is gone or broken
            value = request.machine(value).name
    return translate("SpiralPocket", value)


def strategy_note(strategy: str) -> str:
    """Return what a strategy is for, "" for one without a note."""
    return translate("SpiralPocket", STRATEGY_NOTES[strategy]) if strategy in STRATEGY_NOTES else ""
