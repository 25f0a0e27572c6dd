# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls a little later, by timers that never go.

A single shot of Qt's makes a timer that goes when it is through. If it lay where something is that
FreeCAD holds a name for still (names.py), that name would be ended with it, and freed twice.
"""

from __future__ import annotations

from collections.abc import Callable

from PySide import QtCore

from .names import forget_namesakes

#: All timers; also those that are waiting, for a signal does not keep whom it tells.
_ALARMS: list[_Alarm] = []


class _Alarm:
    """A timer, and what it calls."""

    def __init__(self) -> None:
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._ring)
        self._function: Callable[[], object] | None = None
        forget_namesakes()

    @property
    def is_idle(self) -> bool:
        return self._function is None

    def set(self, milliseconds: int, function: Callable[[], object]) -> None:
        self._function = function
        self._timer.start(milliseconds)

    def _ring(self) -> None:
        function, self._function = self._function, None
        if function is not None:
            function()


def later(milliseconds: int, function: Callable[[], object]) -> None:
    """Call a function when so much time has passed, and what is under way is done [ms]."""
    alarm = next((alarm for alarm in _ALARMS if alarm.is_idle), None)
    if alarm is None:
        alarm = _Alarm()
        _ALARMS.append(alarm)
    alarm.set(milliseconds, function)
