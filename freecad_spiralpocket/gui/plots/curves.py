# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curves of the plots: what the cutter and the machine do along the time of a cut."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from PySide.QtCore import QT_TRANSLATE_NOOP

from ...beside.tasks import Drawn
from ...engine.model import CutMode, Floats
from ...engine.motion.force import MATERIALS, Cutter, cutting_forces
from ...engine.toolpath import Role
from ...op.results import start_times

#: The material that forces are told for, until the part has one of its own.
MATERIAL = QT_TRANSLATE_NOOP("SpiralPocket", "Aluminum 6082-T6")
FLUTES = 2  # where the tool does not say


@dataclass(frozen=True, eq=False)
class Curves:
    """Curves over the time of the whole cut, n samples.

    Attributes
    ----------
    clock : ndarray of shape (n,)
        [s]
    engagement : ndarray of shape (n,)
        [deg]; nan on links and rapids, so that a curve rests while nothing is to be cut.
    limit : float
        [deg]
    feed, velocity : ndarray of shape (n,)
        Programmed, and of the machine [mm/min]; rapids are left out of the feed (nan).
    force : ndarray of shape (n,) or None
        Mean over a revolution [N], nan as `engagement`; None without a spindle speed.
    """

    clock: Floats
    engagement: Floats
    limit: float
    feed: Floats
    velocity: Floats
    force: Floats | None


def curves_of(pockets: Sequence[Drawn], tool_controller: Any) -> Curves:
    """Return the curves of pockets that are cut one after the other."""
    tool = tool_controller.Proxy.getTool(tool_controller)
    flutes = int(getattr(tool, "Flutes", 0) or FLUTES)
    spindle_speed = float(tool_controller.SpindleSpeed) / 60
    parts, forces = [], []
    for drawn, begin in zip(pockets, start_times([d.plan for d in pockets]), strict=True):
        trace, request = drawn.trace, drawn.plan.request
        # a stretch has the values of its end; the first vertex those of the first stretch
        ends = np.maximum(np.arange(len(trace.clock)) - 1, 0)
        angles = trace.angles[ends]
        feeds = np.where(trace.roles[ends] == 0, np.nan, trace.feeds[ends])
        rests = np.isin(trace.roles[ends], (Role.AIR, Role.LINK)) & (angles <= 0)
        told = np.where(rests, np.nan, np.degrees(angles))
        parts.append((begin + trace.clock, told, feeds * 60, trace.speeds * 60))
        if spindle_speed > 0:
            cut = cutting_forces(
                angles,
                trace.speeds,
                request.axial_depth,
                Cutter(request.tool_diameter, flutes),
                MATERIALS[MATERIAL],
                spindle_speed,
                climb=request.cutting.cut_mode is CutMode.CLIMB,
            )
            forces.append(np.where(rests, np.nan, np.where(angles > 0, cut.mean, 0.0)))
    clock, engagement, feed, velocity = (np.concatenate(c) for c in zip(*parts, strict=True))
    limit = float(np.degrees(max(d.plan.request.engagement_limit for d in pockets)))
    force = np.concatenate(forces) if forces else None
    return Curves(clock, engagement, limit, feed, velocity, force)
