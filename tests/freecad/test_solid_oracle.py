# SPDX-License-Identifier: LGPL-2.1-or-later
"""The second opinion in three dimensions sees what it is asked for."""

import math

import numpy as np
import pytest
from sample_parts import DEPTH, slanted_block
from solid_oracle import Surface, gouges

RADIUS, TOO_DEEP = 3.0, 0.01


@pytest.mark.parametrize("angle", [0.0, 20.0, -12.0], ids=["upright", "slanted", "leaning"])
@pytest.mark.parametrize("height", [0.0, DEPTH / 2], ids=["floor", "half way"])
def test_a_cutter_that_passes_a_wall_is_seen_and_one_beside_it_is_not(angle, height):
    surface = Surface.of(slanted_block((0, angle, 0, 0), DEPTH, 40.0, 30.0, 5.0))
    slope = math.tan(math.radians(angle))
    wall = 40.0 + slope * (height if slope > 0 else DEPTH)  # what leans in is in the way below
    for off, seen in ((0.05, 1), (-0.05, 0)):
        center = np.array([[wall - RADIUS + off, 15.0, height - DEPTH]])
        assert len(gouges(surface, center, RADIUS, TOO_DEEP)) == seen
