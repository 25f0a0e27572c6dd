# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of figures that the command lines take."""

from __future__ import annotations

import argparse
import math


def positive(text: str) -> float:
    """Return a number above 0."""
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is not a number above 0")
    return value


def positive_whole(text: str) -> int:
    """Return a whole number above 0."""
    value = positive(text)
    if value != int(value):
        raise argparse.ArgumentTypeError(f"{text} is not a whole number")
    return int(value)
