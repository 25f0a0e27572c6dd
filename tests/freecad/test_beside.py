# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD without a window plans an operation's pockets in processes of its own Python too."""

import time

import sample_parts as parts

from freecad_spiralpocket import api
from freecad_spiralpocket.beside import crew
from freecad_spiralpocket.beside.interpreters import Interpreters
from freecad_spiralpocket.op.operation import ObjectSpiralPocket


def test_a_process_plans_a_share(doc, monkeypatch):
    block = parts.block(*(parts.area(parts.rectangle(16 + i, 14, x=26 * i)) for i in range(3)))
    part = parts.add_part(doc, block)
    job = parts.add_job(doc, part)
    begun, planned = [], []
    plan_one = crew._Helper._has_done

    def has_done(helper, process, number):
        begun.append(number)
        planned.append(plan_one(helper, process, number))
        return planned[-1]

    def progress(fraction, stage):
        # the pockets are small: wait for a process to be there
        until = time.monotonic() + 60
        while not begun and time.monotonic() < until:
            time.sleep(0.01)
        return False

    monkeypatch.setattr(crew._Helper, "_has_done", has_done)
    paths = []
    for helpers in (0, 1):

        def planner(requests, _, helpers=helpers):
            return crew.plan_together(requests, progress if helpers else None, helpers)

        monkeypatch.setattr(ObjectSpiralPocket, "planner", staticmethod(planner))
        floors = [(part, name) for name in parts.faces_at(block, -parts.DEPTH)]
        operation = api.add_spiral_pocket(job, floors, **parts.QUICK)
        assert operation.PathLength.Value > 0
        paths.append(parts.gcode(operation))
        assert bool(begun) == bool(helpers)
    assert Interpreters.best() is not None
    assert any(planned)
    assert len(paths[0]) > 1000 and paths[0] == paths[1]
