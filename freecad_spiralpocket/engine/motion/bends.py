# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast a machine takes the bends of a path: corners, arcs and changes of curvature.

A control that blends may leave the path by its tolerance, so what counts is not each corner
but how the path turns within the length over which the control can round it. Around each
joint of two blocks, windows of growing size are tried: the corners in a window may share one
rounding if that rounding, at the tolerance, is longer than they are apart. The largest radius
found is the one driven. So the chords of a circle are driven as the circle, a corner that is
split by a block of a hundredth is driven as one corner, and a lone corner gets its blend arc.

Speed in a bend is limited by normal acceleration, ``v^2 <= a r``, and by jerk,
``v^3 <= J r^2``, which [HQS24]'s machine feels long before acceleration. Where curvature jumps
by c, normal acceleration needs the time ``v^2 c / J`` to follow; that shifts the path sideways
by ``(v^2 c)^3 / (24 J^2)``, which must stay within the tolerance.
"""

from __future__ import annotations

import numpy as np

from ..machine import CornerRule, Machine
from ..model import Floats
from ..shapes.points import cross
from .blocks import SHORTEST, Blocks

#: Windows around a joint, in blocks before and after.
_WINDOWS = ((0, 0), (0, 1), (1, 0), (1, 1), (1, 2), (2, 1), *((k, k) for k in (2, 3, 5, 8, 13, 21)))
#: Windows in which changes of curvature are measured.
_CHANGE_WINDOWS = (1, 3, 9)
#: Joints that turn less are straight [rad].
_STRAIGHT = 1e-6


def bend_limits(blocks: Blocks, machine: Machine) -> tuple[Floats, Floats]:
    """Return the speeds that the bends of a path allow.

    Parameters
    ----------
    blocks : Blocks
        n blocks in each row.
    machine : Machine

    Returns
    -------
    joints : ndarray of shape (..., n + 1)
        Largest speed at the joints [mm/s], infinite where straight; both ends included.
    arcs : ndarray of shape (..., n)
        Largest speed within each block [mm/s], infinite for lines.
    """
    turns, normals = _turns(blocks)
    across = machine.acceleration_across(normals)
    if machine.corner_rule is CornerRule.BLENDING:
        tolerance = machine.corner_value
        joint_radii, arc_radii = _blended_radii(blocks, turns, tolerance)
        joints = np.sqrt(across * joint_radii)
    else:
        arc_radii = blocks.radii
        joints = _sharp_corner_speeds(blocks, turns, across, machine)
    flat = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    arcs = np.sqrt(machine.acceleration_across(flat).min() * arc_radii)
    if machine.has_jerk_limit:
        arcs = np.minimum(arcs, np.cbrt(machine.jerk_along(flat).min() * arc_radii**2))
        if machine.corner_rule is CornerRule.BLENDING:
            jerks = machine.jerk_along(normals)
            joints = np.minimum(joints, np.cbrt(jerks * joint_radii**2))
            signed = np.sign(_lefts(blocks)) / np.maximum(joint_radii, SHORTEST)
            joints = np.minimum(joints, _change_limits(blocks, turns, signed, jerks, tolerance))
    return joints, arcs


def _turns(blocks: Blocks) -> tuple[Floats, Floats]:
    """Return angle (..., n + 1) and direction (..., n + 1, 3) of the turn at each joint."""
    change = blocks.enter[..., 1:, :] - blocks.leave[..., :-1, :]
    # not from the cosine, which cannot tell angles below 1e-8 apart
    size = np.linalg.norm(change, axis=-1)
    angles = 2.0 * np.arcsin(np.minimum(1.0, size / 2.0))
    with np.errstate(invalid="ignore", divide="ignore"):
        normals = np.where(size[..., None] > 0, change / size[..., None], 0.0)
    pad = [(0, 0)] * (angles.ndim - 1) + [(1, 1)]
    return np.pad(angles, pad), np.pad(normals, [*pad, (0, 0)])


def _lefts(blocks: Blocks) -> Floats:
    """Return at each joint a number that is positive in left turns and negative in right ones."""
    left = cross(blocks.leave[..., :-1, :], blocks.enter[..., 1:, :])
    return np.pad(left, [(0, 0)] * (left.ndim - 1) + [(1, 1)])


def _blended_radii(blocks: Blocks, turns: Floats, tolerance: float) -> tuple[Floats, Floats]:
    """Return the radii of curvature driven at the joints and in the arcs (see the module)."""
    lengths = blocks.lengths
    count = lengths.shape[-1]
    pad = [(0, 0)] * (lengths.ndim - 1)
    at = np.pad(np.cumsum(lengths, axis=-1), [*pad, (1, 0)])
    inside = np.cumsum(lengths / blocks.radii, axis=-1)
    before = np.cumsum(turns, axis=-1) - turns + np.pad(inside, [*pad, (1, 0)])
    after = before + turns
    halves = np.pad(lengths / 2, [*pad, (1, 1)])

    def radii(first: Floats, last: Floats) -> Floats:
        first, last = np.maximum(first, 0), np.minimum(last, count)
        turning = np.minimum(after[..., last] - before[..., first], np.pi)
        span = at[..., last] - at[..., first]
        with np.errstate(divide="ignore", invalid="ignore"):
            reach = tolerance / np.tan(turning / 4)
            outer = np.minimum(halves[..., first], halves[..., last + 1])
            room = span / 2 + outer
            radius = np.minimum(reach, room) / np.tan(turning / 2)
        radius = np.where(turning > _STRAIGHT, radius, np.inf)
        return np.where(span <= 2 * reach, radius, 0.0)

    joints, arcs = np.zeros_like(turns), blocks.radii
    is_arc = bool(np.isfinite(arcs).any())
    index = np.arange(count + 1)
    for before_, after_ in _WINDOWS:
        joints = np.maximum(joints, radii(index - before_, index + after_))
        if is_arc:
            arcs = np.maximum(arcs, radii(index[:-1] - before_, index[1:] + after_))
    return joints, arcs


def _sharp_corner_speeds(blocks: Blocks, turns: Floats, across: Floats, machine: Machine) -> Floats:
    """Return the speeds at corners that are not rounded."""
    value = machine.corner_value
    with np.errstate(divide="ignore", invalid="ignore"):
        if machine.corner_rule is CornerRule.JUNCTION_DEVIATION:
            radii = value * np.cos(turns / 2) / (2 * np.sin(turns / 4) ** 2)
            return np.where(turns > _STRAIGHT, np.sqrt(across * radii), np.inf)
        # the same change of velocity as in a square corner, and chords of a bend as the bend
        steps = value * np.sin(np.pi / 4) / np.sin(turns / 2)
        room = np.pad(blocks.lengths, [(0, 0)] * (turns.ndim - 1) + [(1, 1)])
        bends = np.sqrt(across * (room[..., 1:] + room[..., :-1]) / (2 * turns))
        return np.where(turns > _STRAIGHT, np.minimum(steps, bends), np.inf)


def _change_limits(
    blocks: Blocks, turns: Floats, curvature: Floats, jerks: Floats, tolerance: float
) -> Floats:
    """Return the speeds at which normal acceleration follows the changes of `curvature`.

    `curvature` is signed, at the joints, as driven. A change may be sudden, then the tolerance
    limits it, or spread over a length d, then ``v^3 c / d <= J`` does: whichever allows more.
    """
    pad = [(0, 0)] * (turns.ndim - 1)
    arcs = blocks.spins / blocks.radii
    left, right = np.pad(arcs, [*pad, (1, 0)]), np.pad(arcs, [*pad, (0, 1)])
    is_line = np.pad(blocks.spins == 0, [*pad, (1, 1)], constant_values=True)
    between = _between_lines(blocks, turns, curvature, tolerance)
    left = np.where(is_line[..., :-1], np.pad(between, [*pad, (1, 0)]), left)
    right = np.where(is_line[..., 1:], np.pad(between, [*pad, (0, 1)]), right)
    here = np.where(turns > _STRAIGHT, curvature, (left + right) / 2)
    jump = np.maximum(np.maximum(left, right), here) - np.minimum(np.minimum(left, right), here)
    jerks = np.where(np.isfinite(jerks), jerks, blocks.jerks.min())
    shift = np.cbrt(24 * tolerance * jerks**2)
    at = np.pad(np.cumsum(blocks.lengths, axis=-1), [*pad, (1, 0)])
    count = turns.shape[-1] - 1
    index = np.arange(count + 1)
    with np.errstate(divide="ignore", invalid="ignore"):
        limits = np.sqrt(shift / jump)
        for k in _CHANGE_WINDOWS:
            first, last = np.maximum(index - k, 0), np.minimum(index + k, count)
            change = np.abs(here[..., last] - here[..., first])
            sudden = np.sqrt(shift / change)
            gradual = np.cbrt(jerks * (at[..., last] - at[..., first]) / change)
            limits = np.minimum(limits, np.maximum(sudden, gradual))
    return np.where(np.isnan(limits), np.inf, limits)


def _between_lines(blocks: Blocks, turns: Floats, curvature: Floats, tolerance: float) -> Floats:
    """Return the curvature driven along each line: that of its ends where their roundings meet."""
    a, b = curvature[..., :-1], curvature[..., 1:]
    with np.errstate(divide="ignore"):
        reach = tolerance / np.tan(np.minimum(turns, np.pi) / 4)
        meet = (reach[..., :-1] + reach[..., 1:]) / blocks.lengths - 1
    same = np.where(a * b > 0, np.sign(a) * np.minimum(np.abs(a), np.abs(b)), 0.0)
    return same * np.clip(meet, 0.0, 1.0)
