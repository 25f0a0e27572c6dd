# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done later is done once, in time, and by timers that stay."""

from window import pump

from freecad_spiralpocket.gui.qt import later


def test_calls_come_once_and_in_time():
    calls = []
    later.later(60, lambda: calls.append("second"))
    later.later(0, lambda: calls.append("first"))
    assert calls == []
    pump(0.2)
    assert calls == ["first", "second"]
    pump(0.1)
    assert calls == ["first", "second"]


def test_a_call_may_ask_for_another():
    calls = []
    later.later(0, lambda: later.later(0, lambda: calls.append(1)))
    pump(0.1)
    assert calls == [1]


def test_timers_are_used_again():
    pump(0.05)
    known = list(later._ALARMS)
    for _ in range(20):
        later.later(0, lambda: None)
        pump(0.01)
    assert known == later._ALARMS[: len(known)]
    assert len(later._ALARMS) <= len(known) + 1
