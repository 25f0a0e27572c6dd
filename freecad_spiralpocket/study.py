# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything that is known about a toolpath on a machine, gathered along its length and time.

One record for plots and reports: motion, engagement, forces, and the papers' figures.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from shapely import Polygon

from .engine.contact.air import Stock
from .engine.contact.engagement import Engagement, along_path
from .engine.machine import Machine
from .engine.model import Floats
from .engine.motion import analysis
from .engine.motion.force import Cutter, Forces, Material, cutting_forces, removal_rates
from .engine.motion.stations import stations_of
from .engine.motion.timing import MachineTime, time_of
from .engine.toolpath import Toolpath


@dataclass(frozen=True)
class Setup:
    """What a study is made for.

    Attributes
    ----------
    cutter : Cutter
    machine : Machine
    material : Material
    spindle_speed : float
        [1/s]
    axial_depth : float
        Of a full cut [mm].
    top : float
        Z of the top of the stock [mm].
    stock : shapely.Polygon or None
        Its outline; None: it is everywhere.
    engagement_limit : float
        [rad]; nan where none is known.
    climb : bool
    """

    cutter: Cutter
    machine: Machine
    material: Material
    spindle_speed: float
    axial_depth: float
    top: float = 0.0
    stock: Polygon | None = None
    engagement_limit: float = np.nan
    climb: bool = True


@dataclass(frozen=True)
class Study:
    """A toolpath and what was measured on it; samples are the places of the engagement."""

    toolpath: Toolpath
    setup: Setup

    @cached_property
    def motion(self) -> MachineTime:
        """Return the motion of the machine."""
        return time_of(self.toolpath, self.setup.machine)

    @cached_property
    def engagement(self) -> Engagement:
        """Return the engagement of all moves below the top of the stock."""
        setup = self.setup
        return along_path(
            self.toolpath,
            setup.cutter.diameter / 2,
            axial_depth=setup.axial_depth,
            top=setup.top,
            stock=Stock.of(setup.stock),
        )

    @cached_property
    def stations(self) -> Floats:
        """Return the arc lengths of the samples [mm]."""
        return stations_of(self.toolpath, self.engagement.moves, self.engagement.points)

    @cached_property
    def clock(self) -> Floats:
        """Return when the machine is at the samples [s]."""
        return self.motion.clock_at(self.stations)

    @cached_property
    def speeds(self) -> Floats:
        """Return how fast the machine is at the samples [mm/s]."""
        return self.motion.speed_at(self.stations)

    @cached_property
    def times(self) -> Floats:
        """Return the time that each sample stands for [s]."""
        return analysis.sample_times(self.toolpath, self.engagement, self.motion)

    @cached_property
    def forces(self) -> Forces:
        """Return the forces at the samples, at the machine's true speed."""
        setup = self.setup
        return cutting_forces(
            self.engagement.angles,
            self.speeds,
            setup.axial_depth,
            setup.cutter,
            setup.material,
            setup.spindle_speed,
            climb=setup.climb,
        )

    @cached_property
    def removal(self) -> Floats:
        """Return the removal rate at the samples [mm3/s]."""
        depth, diameter = self.setup.axial_depth, self.setup.cutter.diameter
        return removal_rates(self.engagement.angles, self.speeds, depth, diameter)

    @cached_property
    def curvature(self) -> tuple[Floats, Floats]:
        """Return absolute curvatures [1/mm] and the lengths that have them [mm]."""
        return analysis.absolute_curvature(self.toolpath)

    def figures(self) -> dict[str, str]:
        """Return the study's figures as a reader wants them, name and value with unit."""
        angles, lengths = np.degrees(self.engagement.angles), self.engagement.lengths
        p99, largest = analysis.weighted_quantiles(angles, lengths, [0.99, 1.0])
        cut95, cut99 = analysis.weighted_quantiles(*self.curvature, [0.95, 0.99])
        cutting = self.times[self.engagement.angles > 0]
        mean_force = _mean(self.forces.mean[self.engagement.angles > 0], cutting)
        limit = np.degrees(self.setup.engagement_limit)
        return {
            "Machine": self.setup.machine.name,
            "Time": f"{self.motion.total:.1f} s",
            "Length": f"{self.toolpath.lengths.sum():.0f} mm in {len(self.toolpath)} moves",
            "Programmed over machine time (eta)": f"{self._eta:.3f}",
            "Engagement limit": "not known" if np.isnan(limit) else f"{limit:.1f} deg",
            "Engagement, mean over the length": f"{_mean(angles, lengths):.1f} deg",
            "Engagement, 99 % of the length below": f"{p99:.1f} deg",
            "Engagement, largest": f"{largest:.1f} deg",
            "Curvature, Cut95 and Cut99": f"{cut95:.3f} and {cut99:.3f} 1/mm",
            "Mean force while cutting": f"{mean_force:.0f} N",
            "Largest force": f"{self.forces.peak.max(initial=0.0):.0f} N",
            "Largest spindle power": f"{self.forces.power.max(initial=0.0):.0f} W",
            "Largest removal rate": f"{self.removal.max(initial=0.0) * 0.06:.1f} cm3/min",
        }

    @property
    def _eta(self) -> float:
        return analysis.time_ratio(self.toolpath, self.motion)


def _mean(values: Floats, weights: Floats) -> float:
    """Return the weighted mean, 0 of nothing."""
    total = float(weights.sum())
    return float((values * weights).sum() / total) if total > 0 else 0.0
