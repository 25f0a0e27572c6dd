# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings a 3D view to a place without turning it."""

from __future__ import annotations

import math
from typing import Any

from pivy import coin


def zoom_to(view: Any, place: tuple[float, float, float], size: float) -> None:
    """Let a FreeCAD view show the surroundings of a place.

    Parameters
    ----------
    view : object
    place : tuple of float
        [mm]
    size : float
        Height of what is to be seen [mm].
    """
    camera = view.getCameraNode()
    if isinstance(camera, coin.SoOrthographicCamera):
        camera.height = size
        distance = camera.focalDistance.getValue()
    else:
        distance = size / 2 / math.tan(camera.heightAngle.getValue() / 2)
        camera.focalDistance = distance
    ahead = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1))
    camera.position = coin.SbVec3f(*place) - ahead * distance
