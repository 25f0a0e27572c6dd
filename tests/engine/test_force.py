# SPDX-License-Identifier: LGPL-2.1-or-later
"""The force model against a plain summation, closed forms and what must be so."""

from __future__ import annotations

import math

import numpy as np
import pytest

from freecad_spiralpocket.engine.motion.force import (
    MATERIALS,
    Cutter,
    Material,
    cutting_forces,
    removal_rates,
)

ALUMINUM = MATERIALS["Aluminum 6082-T6"]
SPEED, DEPTH = 100.0, 4.0  # 1/s, mm


def summed(angle, feed, cutter, material, climb, slices=400, positions=240):
    """Return mean and peak force by adding up thin slices of every tooth."""
    first, last = (math.pi - angle, math.pi) if climb else (0.0, angle)
    chip = feed / (cutter.flutes * SPEED)
    z = (np.arange(slices) + 0.5) * DEPTH / slices
    lag = np.tan(cutter.helix_angle) / (cutter.diameter / 2) * z
    magnitudes = []
    for turn in np.arange(positions) * 2 * math.pi / positions:
        force = np.zeros(3)
        for tooth in range(cutter.flutes):
            phi = np.mod(turn + tooth * 2 * math.pi / cutter.flutes - lag, 2 * math.pi)
            phi = phi[(phi >= first) & (phi <= last)]
            h = chip * np.sin(phi)
            t, r, a = (
                (k * h + e) * DEPTH / slices
                for k, e in zip(material.cutting, material.edge, strict=True)
            )
            force += [
                (-t * np.cos(phi) - r * np.sin(phi)).sum(),
                (t * np.sin(phi) - r * np.cos(phi)).sum(),
                a.sum(),
            ]
        magnitudes.append(np.linalg.norm(force))
    return np.mean(magnitudes), np.max(magnitudes)


@pytest.mark.parametrize("climb", [True, False])
@pytest.mark.parametrize("degrees", [25.0, 80.0, 180.0])
@pytest.mark.parametrize(("flutes", "helix"), [(2, 30.0), (4, 45.0), (1, 60.0)])
def test_forces_agree_with_adding_up_slices(degrees, flutes, helix, climb):
    cutter = Cutter(6.0, flutes, math.radians(helix))
    angle, feed = math.radians(degrees), 40.0
    forces = cutting_forces([angle], [feed], DEPTH, cutter, ALUMINUM, SPEED, climb=climb)
    mean, peak = summed(angle, feed, cutter, ALUMINUM, climb)
    assert forces.mean[0] == pytest.approx(mean, rel=0.02)
    assert forces.peak[0] == pytest.approx(peak, rel=0.03)


def test_helix_of_more_than_a_turn_is_a_steady_force():
    # lag of exactly one tooth pitch: as much edge in the cut at every moment
    cutter = Cutter(6.0, 2, math.atan(math.pi * 3.0 / DEPTH))
    forces = cutting_forces([1.0], [40.0], DEPTH, cutter, ALUMINUM, SPEED)
    assert forces.peak[0] == pytest.approx(forces.mean[0], rel=1e-6)


def test_power_is_specific_energy_times_removal_rate_plus_rubbing():
    cutter, angles = Cutter(6.0, 3), np.radians([30.0, 90.0, 180.0])
    feeds = np.full(3, 40.0)
    power = cutting_forces(angles, feeds, DEPTH, cutter, ALUMINUM, SPEED).power
    chips = ALUMINUM.cutting[0] * removal_rates(angles, feeds, DEPTH, 6.0)
    rubbing = ALUMINUM.edge[0] * DEPTH * cutter.flutes * SPEED * 3.0 * angles
    np.testing.assert_allclose(power, (chips + rubbing) / 1000)


def test_removal_rate_of_a_straight_cut():
    angle = math.acos(1 - 2.4 / 3.0)
    assert removal_rates(angle, 50.0, 5.0, 6.0) == pytest.approx(2.4 * 5.0 * 50.0)


def test_no_engagement_no_force():
    forces = cutting_forces([0.0], [50.0], DEPTH, Cutter(6.0), ALUMINUM, SPEED)
    assert (forces.mean[0], forces.peak[0], forces.power[0]) == pytest.approx((0, 0, 0))


def test_force_grows_with_engagement_and_feed():
    angles, cutter = np.linspace(0.0, np.pi, 50), Cutter(6.0, 3)
    for feed in (10.0, 60.0):
        mean = cutting_forces(angles, np.full(50, feed), DEPTH, cutter, ALUMINUM, SPEED).mean
        assert np.all(np.diff(mean[angles < 2.0]) > 0)
    slow, fast = (
        cutting_forces([1.0], [f], DEPTH, cutter, ALUMINUM, SPEED).peak[0] for f in (20.0, 40.0)
    )
    assert slow < fast < 2 * slow  # rubbing does not grow


def test_straight_flutes_are_allowed():
    forces = cutting_forces([1.0], [50.0], DEPTH, Cutter(6.0, 2, 0.0), ALUMINUM, SPEED)
    edge = Material((*ALUMINUM.cutting[:2], 0.0), (*ALUMINUM.edge[:2], 0.0), "")
    flat = cutting_forces([1.0], [50.0], DEPTH, Cutter(6.0, 2, 0.0), edge, SPEED)
    chip = 50.0 / (2 * SPEED)
    t, r = (
        k * chip * math.sin(1.0) + e for k, e in zip(edge.cutting[:2], edge.edge[:2], strict=True)
    )
    # one edge at a time: the largest force is where the chip is thickest
    assert flat.peak[0] == pytest.approx(DEPTH * math.hypot(t, r), rel=0.05)
    assert forces.peak[0] > flat.peak[0]


def test_every_material_names_its_source():
    assert all("doi" in material.source for material in MATERIALS.values())


@pytest.mark.parametrize(("depth", "speed"), [(0.0, 10.0), (1.0, 0.0)])
def test_values_that_make_no_sense_are_refused(depth, speed):
    with pytest.raises(ValueError, match="must be positive"):
        cutting_forces([1.0], [1.0], depth, Cutter(6.0), ALUMINUM, speed)
