# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything that can go wrong, in the machinist's words.

Each error carries three things: what is the matter (the message), a way out
(`hint`, one sentence) and, where there is one, the place on the part (`place`).
A wrong call from Python, such as an array of the wrong shape, is a plain
`ValueError` or `TypeError` instead: it is the programmer's, not the machinist's.

This module imports nothing but from Python itself, so that it can report that a library is missing.
"""

from __future__ import annotations

from collections.abc import Callable
from copy import copy

#: (x, y) [mm].
Place = tuple[float, float]


def tell(message: str, hint: str, place: Place | None) -> str:
    """Return message and hint as one text, ``{at}`` replaced by the place ("X12.3 Y40.0")."""
    at = "the pocket" if place is None else f"X{place[0]:.1f} Y{place[1]:.1f}"
    return f"{message} {hint}".strip().replace("{at}", at)


class SpiralPocketError(Exception):
    """A pocket cannot be cut as asked.

    Parameters
    ----------
    message : str
        What is the matter, a sentence or two; ``{at}`` in it stands for the place.
    hint : str, optional
        What the machinist can do about it, one sentence.
    place : tuple of float, optional
        Where on the part, (x, y) [mm].
    """

    def __init__(self, message: str, hint: str = "", place: Place | None = None) -> None:
        super().__init__(message)
        self._message = message
        self.hint = hint
        self.place = None if place is None else (float(place[0]), float(place[1]))

    def resized(self, factor: float) -> SpiralPocketError:
        """Return the error with all lengths times `factor`; here the place is all."""
        return self.moved(lambda place: (factor * place[0], factor * place[1]))

    def moved(self, to: Callable[[Place], Place]) -> SpiralPocketError:
        """Return the error of the same pocket elsewhere: `to` says where a place is then."""
        error = copy(self)
        error.place = None if self.place is None else to(self.place)
        return error

    def labelled(self, label: str) -> SpiralPocketError:
        """Return the error as that of the pocket with a label."""
        return type(self)(f"{label}: {self.message}", self.hint, self.place)

    @property
    def message(self) -> str:
        """Return what is the matter."""
        return tell(self._message, "", self.place)

    def __str__(self) -> str:
        """Return message and hint as one text."""
        return tell(self._message, self.hint, self.place)

    def __repr__(self) -> str:
        """Return the class and that text."""
        return f"{type(self).__name__}({str(self)!r})"


class RequestError(SpiralPocketError):
    """A value that was asked for makes no sense: a step-over of 0, depths upside down."""


class SelectionError(SpiralPocketError):
    """What was selected is not the floor of a pocket."""


class GeometryError(SpiralPocketError):
    """The pocket's outline is broken: open, crossing itself, without area."""


class CutterDoesNotFitError(SpiralPocketError):
    """The cutter does not go into the pocket anywhere."""


class NotYetError(SpiralPocketError):
    """A sound pocket that the chosen strategy cannot cut (yet)."""


class AlreadyClearedError(SpiralPocketError):
    """Nothing is left in the pocket for this cutter."""


class ProofError(SpiralPocketError):
    """The finished path failed its proof and is therefore not handed out."""


class SetupError(SpiralPocketError):
    """Something around the operation is missing: a library, a job, a tool controller."""


class CancelledError(SpiralPocketError):
    """The user pressed Stop."""

    def __init__(
        self,
        message: str = "Stopped by the user.",
        hint: str = "Recompute the operation to try again.",
        place: Place | None = None,
    ) -> None:
        super().__init__(message, hint, place)


def report_progress(progress: Callable[[float, str], bool] | None, done: float, stage: str) -> None:
    """Tell a `model.Progress`, if there is one, how far all is.

    Raises
    ------
    CancelledError
        If it says so.
    """
    if progress is not None and progress(done, stage):
        raise CancelledError


def told_area(area: float) -> str:
    """Return an area [mm2] as it is told: whole, a small one with two digits."""
    return f"{area:.0f}" if area >= 10 else f"{area:.2g}"


def named(failures: list[tuple[str, SpiralPocketError]], pockets: int) -> list[SpiralPocketError]:
    """Return errors, each once with the labels of the pockets that have it, if not all have it.

    Parameters
    ----------
    failures : list of (str, SpiralPocketError)
        The label of a pocket and what is the matter with it.
    pockets : int
        How many there are.
    """
    labels: dict[str, list[str]] = {}
    errors = {str(error): error for _, error in reversed(failures)}
    for label, error in failures:
        labels.setdefault(str(error), []).append(label)
    result = []
    for text, having_it in labels.items():
        error = errors[text]
        if len(having_it) < pockets and having_it[0] not in error.message:
            error = error.labelled("; ".join(having_it))
        result.append(error)
    return result
