# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the proof found, in the machinist's words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import MultiPolygon, Polygon

from ..errors import told_area
from ..model import Notice, PocketRequest
from ..shapes.region import polygons_of
from ..stepover import over_limit
from .wall_steps import WallStep

#: Uncut area over that of the cutter's disc that is worth telling.
TOLD_UNCUT = 1e-3
#: A gouge is small that passes the tolerance by no more than the first [mm] and this share of it.
GOUGE_SLACK, GOUGE_SHARE = 0.005, 0.5
#: Engagement above the limit is not told that is so over no more than this share of the cut, and
#: by no more than so much [rad].
BRIEFLY, PEAK = 1e-3, np.radians(30.0)
#: A smaller notch is not told [mm2].
TOLD_NOTCH = 1.0
#: Air moves may touch stock over this length [mm].
TOUCH = 0.1

Place = tuple[float, float] | None


def gouge_allowed(request: PocketRequest) -> float:
    """Return up to how deep a gouge is told, but no reason not to run the path [mm]."""
    return request.tolerance + min(GOUGE_SLACK, GOUGE_SHARE * request.tolerance)


def tell_gouge(depth: float, place: Place, request: PocketRequest) -> list[Notice]:
    """Tell how far the cutter passes the wall [mm]."""
    if depth <= request.tolerance:
        return []
    hint = "Lower Tolerance if the wall must be truer."
    if depth > gouge_allowed(request):
        hint = "Do not run this path; try another strategy or step-over."
    return [Notice(f"At {{at}} the cutter cuts {depth:.3f} mm into the wall.", hint, place)]


def tell_too_deep(depth: float, request: PocketRequest) -> list[Notice]:
    """Tell how far the cutter passes the floor [mm]."""
    if depth <= request.tolerance:
        return []
    return [
        Notice(
            f"The cutter goes {depth:.3f} mm below the floor.",
            "Do not run this path; check the final depth and the floor stock.",
        )
    ]


def uncut_allowed(request: PocketRequest) -> float:
    """Return how much ground may stay uncut without being told [mm2]."""
    return float(TOLD_UNCUT * np.pi * request.cutter_radius**2)


def tell_uncut(
    uncut: MultiPolygon, missed: shapely.Geometry, request: PocketRequest
) -> list[Notice]:
    """Tell how much of the floor stays uncut, but for what is `missed`, that the cutter reaches."""
    parts = polygons_of(shapely.difference(uncut, missed))
    area = sum(part.area for part in parts)
    if area <= uncut_allowed(request):
        return []
    largest = parts[0].representative_point()
    return [
        Notice(
            f"{told_area(area)} mm2 of the floor stay uncut, the largest part at {{at}}.",
            "A smaller step-over may clear it.",
            (float(largest.x), float(largest.y)),
        )
    ]


def tell_steps(step: WallStep) -> list[Notice]:
    """Tell how large the steps on slanted walls are, if there are any."""
    if step.width == 0:
        return []
    return [
        Notice(
            f"Walls that are not vertical keep steps up to {step.width:.2g} mm wide and "
            f"{step.height:.3g} mm high, the widest at {{at}}.",
            "A smaller StepDown makes them smaller; a finishing operation removes them.",
            step.place,
        )
    ]


def tell_notches(pieces: Sequence[Polygon], cutter: float) -> list[Notice]:
    """Tell of notches in the walls that are too narrow for the cutter [mm]."""
    pieces = [piece for piece in pieces if piece.area > TOLD_NOTCH]
    if not pieces:
        return []
    area = told_area(sum(piece.area for piece in pieces))
    largest = max(pieces, key=lambda piece: piece.area)
    at = largest.representative_point()
    return [
        Notice(
            f"Above the floor the pocket has notches that the {cutter:g} mm cutter does not fit, "
            f"the largest at {{at}}; these ({area} mm2) stay uncut.",
            "Cut them by a smaller cutter.",
            (float(at.x), float(at.y)),
        )
    ]


def tell_engagement(
    angle: float, place: Place, share: float, is_slowed: bool, request: PocketRequest
) -> list[Notice]:
    """Tell where the engagement is largest, if that is clearly above the limit, and matters.

    A corner in which it is so for a millimeter shows in the figures of the report alone.

    Parameters
    ----------
    angle : float
        The largest engagement angle [rad].
    place : tuple of float or None
        Where it is, (x, y) [mm].
    share : float
        Of the cut, clearly passes the limit, in [0, 1].
    is_slowed : bool
        Whether the feed is lowered there.
    request : PocketRequest
    """
    limit = request.engagement_limit
    if angle <= over_limit(limit) or (share <= BRIEFLY and angle <= limit + PEAK):
        return []
    percent = 100 * request.cutting.stepover / request.tool_diameter
    hint = "Take a lower feed or a smaller SlotBite if that is too heavy for the cutter."
    if is_slowed:
        hint = "The feed is lowered there; take a lower one if that is too heavy for the cutter."
    return [
        Notice(
            f"At {{at}} the engagement reaches {np.degrees(angle):.0f} degrees, the step-over of "
            f"{percent:.3g} % allows {np.degrees(limit):.0f}; {100 * share:.2g} % of the cut "
            "clearly pass that.",
            hint,
            place,
        )
    ]


def tell_hits(kind: str, length: float, place: Place) -> list[Notice]:
    """Tell how far moves of a kind ("rapid", "link") run through standing stock [mm].

    Less than `TOUCH` is the end of a link that meets its cut a sample too early.
    """
    if length <= TOUCH:
        return []
    return [
        Notice(
            f"A {kind} move runs through standing stock at {{at}}, {length:.2g} mm in all.",
            "Do not run this path; try another strategy or step-over.",
            place,
        )
    ]
