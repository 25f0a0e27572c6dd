# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a front may go in one step: as far as the engagement allows.

On a straight front that is the step-over, on a convex one less, because the cutter meets
more stock there. With the cleared edge's radius ``rho = R + 1 / curvature`` the step is
``a = R - rho - R cos(limit) + sqrt(rho^2 - R^2 sin(limit)^2)``: constant engagement on a
growing disc, exactly.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..model import Floats, PocketRequest
from ..stepover import over_limit, radial_depth

#: Where the stock bends away from the cutter the step may be so much over the step-over.
WIDEST = 1.15
#: No step of a straight front is wider than this over R, and none at all than the second: laps that
#: meet would leave stock between them, and reentrant kinks could not be rounded within reach.
MEETING, FARTHEST = 0.88, 0.92
#: Least radius of reentrant curves, over R.
CLOSING = 1.33
#: Where a front rounds into a wall the cutter is engaged by so much more, over what clearly passes
#: the limit.
ROUNDED = 0.8
#: The front is new where it is farther than this from the region before [mm].
NEW = 0.012


@dataclass(frozen=True, slots=True)
class FrontRules:
    """What governs the growth.

    Attributes
    ----------
    cutter_radius : float
        R [mm].
    limit : float
        Largest engagement angle [rad], in ``(0, pi)``; see `step_limit`.
    closing : float
        Least radius of reentrant curves [mm].
    fillet : float
        Radius with which fronts meet walls [mm].
    """

    cutter_radius: float
    limit: float
    closing: float
    fillet: float

    @property
    def stepover(self) -> float:
        """Return the step of a straight front [mm]."""
        return radial_depth(self.limit, self.cutter_radius)


def step_limit(engagement_limit: float) -> float:
    """Return the engagement angle up to which fronts may make use of the limit [rad]."""
    return min(engagement_limit, float(np.arccos(1 - MEETING)))


def rules_of(request: PocketRequest) -> FrontRules:
    """Return what governs the growth of fronts."""
    radius = request.cutter_radius
    limit = step_limit(request.engagement_limit)
    return FrontRules(radius, limit, CLOSING * radius, radius * _fillet(limit))


def _fillet(limit: float) -> float:
    """Return the radius with which fronts meet walls, over R.

    The stock there is a disc of that radius and R, cleared by the last front, and the cutter
    steps over it by as much as on a straight front.
    """
    angle = limit + ROUNDED * (over_limit(limit) - limit)
    stepover, height = radial_depth(limit, 1.0), float(np.cos(angle))
    return stepover * (stepover + 2 * height) / (2 * (1 - stepover - height))


def engagement_step(curvature: Floats, rules: FrontRules) -> Floats:
    """Return the step that keeps the engagement at the limit.

    Parameters
    ----------
    curvature : ndarray of shape (n,)
        Of the front, positive where convex [1/mm].
    rules : FrontRules

    Returns
    -------
    ndarray of shape (n,)
        [mm], in ``(0, WIDEST * stepover]``, at most `FARTHEST` R.
    """
    r, s = rules.cutter_radius, rules.cutter_radius * np.sin(rules.limit)
    k = np.where(np.abs(curvature) < 1e-6, 1e-6, curvature)
    widest = min(WIDEST * rules.stepover, FARTHEST * r)
    # stock that is tighter than this may be taken as deeply as anything is
    rho = np.where(k < 0, np.minimum(r + 1 / k, -s), r + 1 / k)
    root = np.sqrt(rho**2 - s**2)
    # rho - root without cancellation
    return np.minimum(rules.stepover - s**2 / (rho + np.copysign(root, rho)), widest)
