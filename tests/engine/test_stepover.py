# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cosine law between step-over and engagement angle."""

import math

import numpy as np
import pytest

from freecad_spiralpocket.engine.stepover import engagement_angle, radial_depth

RADIUS = 4.0


@pytest.mark.parametrize(
    ("share", "degrees"), [(0, 0), (0.25, 60), (0.5, 90), (0.75, 120), (1, 180)]
)
def test_known_pairs(share, degrees):
    assert math.degrees(engagement_angle(2 * share * RADIUS, RADIUS)) == pytest.approx(degrees)
    assert radial_depth(math.radians(degrees), RADIUS) == pytest.approx(2 * share * RADIUS)


def test_many_depths_at_once_are_those_of_each():
    angles = np.linspace(0.0, math.pi, 50)
    assert radial_depth(angles, RADIUS).tolist() == [radial_depth(a, RADIUS) for a in angles]


def test_more_than_a_slot_is_a_slot():
    assert engagement_angle(2.1 * RADIUS, RADIUS) == pytest.approx(math.pi)
