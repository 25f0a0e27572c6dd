# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutting force, power and removal rate from the engagement, by a mechanistic model.

An end mill's edge element of height dz cuts a chip of thickness ``h = f sin(phi)`` (f feed
for each tooth) and feels a tangential, a radial and an axial force, each with a part that
grows with the chip and one from rubbing: ``dF = (K_c h + K_e) dz``. The helix makes the
edge lag behind by ``z tan(beta) / r``; the integral over the height is closed. Runout,
deflection and ploughing at the floor are left out: figures compare paths, they do not size
a spindle.

The engaged arc is taken to end where the finished side is: at pi for climb milling, at 0 for
conventional milling.

Reference: Y. Altintas, "Manufacturing Automation", 2nd ed. (2012), section 2.8.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..model import Floats

#: Engagement angles of the table, and positions of the cutter within one tooth pitch.
_ANGLES, _POSITIONS = 181, 60
#: A straight edge is cut as one of this helix angle [rad].
_LEAST_HELIX = 1e-3


@dataclass(frozen=True, slots=True)
class Cutter:
    """An end mill.

    Attributes
    ----------
    diameter : float
        [mm]
    flutes : int
    helix_angle : float
        [rad], in ``[0, pi/2)``.
    """

    diameter: float
    flutes: int = 2
    helix_angle: float = np.radians(30.0)


@dataclass(frozen=True, slots=True)
class Material:
    """What a material asks of an edge: tangential, radial, axial.

    Attributes
    ----------
    cutting : tuple of 3 float
        For each chip area [N/mm2].
    edge : tuple of 3 float
        For each edge length [N/mm].
    source : str
        Where the figures were measured.
    """

    cutting: tuple[float, float, float]
    edge: tuple[float, float, float]
    source: str


_REVIEW = (
    "Milling force model for aviation aluminum alloy, Chin. J. Mech. Eng. (2021), "
    "doi 10.1186/s10033-021-00536-9, table 5, reference "
)

#: Carbide end mills, dry.
MATERIALS = {
    "Aluminum 6082-T6": Material((631.0, 99.0, 273.0), (13.0, 10.0, 2.8), _REVIEW + "[189]"),
    "Aluminum 7075-T6": Material((767.01, 168.8, 222.0), (27.7, 26.6, 0.7), _REVIEW + "[190]"),
}


@dataclass(frozen=True, slots=True, eq=False)
class Forces:
    """Of the cutter on the stock at k places.

    Attributes
    ----------
    mean, peak : ndarray of shape (k,)
        Of the force's magnitude over one revolution [N].
    power : ndarray of shape (k,)
        Of the spindle [W].
    """

    mean: Floats
    peak: Floats
    power: Floats


def cutting_forces(
    angles: Floats,
    feeds: Floats,
    axial_depth: float,
    cutter: Cutter,
    material: Material,
    spindle_speed: float,
    *,
    climb: bool = True,
) -> Forces:
    """Return forces and spindle power for engagement angles and feeds.

    Parameters
    ----------
    angles : ndarray of shape (k,)
        Engagement angles [rad], in ``[0, pi]``.
    feeds : ndarray of shape (k,)
        True speeds of the cutter center [mm/s].
    axial_depth : float
        [mm], positive.
    cutter : Cutter
    material : Material
    spindle_speed : float
        [1/s], positive.
    climb : bool
        Climb or conventional milling.

    Returns
    -------
    Forces

    Raises
    ------
    ValueError
        If `axial_depth` or `spindle_speed` is not positive.
    """
    for name, value in (("axial_depth", axial_depth), ("spindle_speed", spindle_speed)):
        if not value > 0:
            raise ValueError(f"{name} must be positive, got {value}")
    angles, feeds = np.asarray(angles, float), np.asarray(feeds, float)
    chips = feeds / (cutter.flutes * spindle_speed)
    table = np.linspace(0.0, np.pi, _ANGLES)
    from_chips, from_edges = _force_table(table, axial_depth, cutter, material, climb)
    squares = [
        np.sum(a * b, axis=-1)
        for a, b in ((from_chips, from_chips), (from_chips, from_edges), (from_edges, from_edges))
    ]
    place = np.clip(angles / np.pi, 0.0, 1.0) * (_ANGLES - 1)
    index = np.minimum(place.astype(int), _ANGLES - 2)
    share = (place - index)[:, None]
    a, b, c = (q[index] * (1 - share) + q[index + 1] * share for q in squares)
    magnitude = np.sqrt(np.maximum(0.0, chips[:, None] ** 2 * a + 2 * chips[:, None] * b + c))
    return Forces(
        mean=magnitude.mean(axis=1),
        peak=magnitude.max(axis=1),
        power=_power(angles, chips, axial_depth, cutter, material, spindle_speed),
    )


def removal_rates(angles: Floats, feeds: Floats, axial_depth: float, diameter: float) -> Floats:
    """Return the volume that is cut in each second, shape (n,) [mm3/s].

    Parameters
    ----------
    angles, feeds : ndarray of shape (n,)
        Engagement [rad] and feed [mm/s].
    axial_depth, diameter : float
        Full axial depth, and D [mm].
    """
    return np.asarray(feeds) * axial_depth * diameter / 2 * (1 - np.cos(angles))


def _power(
    angles: Floats,
    chips: Floats,
    axial_depth: float,
    cutter: Cutter,
    material: Material,
    spindle_speed: float,
) -> Floats:
    """Return the mean spindle power [W]: the tangential force is closed over a revolution."""
    work = chips * material.cutting[0] * (1 - np.cos(angles)) + material.edge[0] * angles
    tangential = cutter.flutes * axial_depth / (2 * np.pi) * work
    return tangential * np.pi * cutter.diameter * spindle_speed / 1000


def _force_table(
    angles: Floats, axial_depth: float, cutter: Cutter, material: Material, climb: bool
) -> tuple[Floats, Floats]:
    """Return forces for each feed per tooth, and from rubbing, (angles, positions, 3)."""
    lag = np.tan(max(cutter.helix_angle, _LEAST_HELIX)) / (cutter.diameter / 2)
    total = lag * axial_depth
    first = (np.pi - angles if climb else np.zeros_like(angles))[:, None]
    last = (np.full_like(angles, np.pi) if climb else angles)[:, None]
    pitch = 2 * np.pi / cutter.flutes
    positions = pitch * np.arange(_POSITIONS) / _POSITIONS
    chips = np.zeros((len(angles), _POSITIONS, 3))
    edges = np.zeros_like(chips)
    # all teeth whose edges may be in the cut, also those that lag by more than a turn
    for tooth in range(cutter.flutes * (1 + int(np.ceil(total / (2 * np.pi))))):
        tip = positions[None, :] + tooth * pitch
        low, high = np.clip(tip - total, first, last), np.clip(tip, first, last)
        upper, lower = _integrals(high, material), _integrals(low, material)
        chips += upper[0] - lower[0]
        edges += upper[1] - lower[1]
    return chips / lag, edges / lag


def _integrals(theta: Floats, material: Material) -> tuple[Floats, Floats]:
    """Return the antiderivatives of the force over the edge's angle: from chips, from rubbing."""
    (kt, kr, ka), (et, er, ea) = material.cutting, material.edge
    s, c = np.sin(theta), np.cos(theta)
    half, flat = s * s / 2, (theta - s * c) / 2
    chips = np.stack([-kt * half - kr * flat, kt * flat - kr * half, -ka * c], axis=-1)
    edges = np.stack([-et * s + er * c, -et * c - er * s, ea * theta], axis=-1)
    return chips, edges
