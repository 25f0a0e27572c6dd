# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a control sees of a path: a row of blocks, each a line or an arc with its own limits.

`timing` plans speeds over these arrays alone. The last axis of each array is the row of
blocks; a leading axis, where there is one, holds paths of equal length that are timed
together. Blocks that go nowhere are kept, so that the answer has one time for each move;
they take over the direction of the block before them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..machine import Machine
from ..model import Floats
from ..toolpath import Kind, Toolpath

#: Blocks shorter than this go nowhere [mm].
SHORTEST = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Blocks:
    """Lines and arcs in the order of travel; all arrays (..., n) unless said otherwise.

    Attributes
    ----------
    lengths : ndarray
        [mm]
    enter, leave : ndarray of shape (..., n, 3)
        Unit directions of travel at both ends.
    radii : ndarray
        Radius of curvature [mm], infinite for lines.
    spins : ndarray
        +1 for counter-clockwise arcs, -1 for clockwise ones, 0 for lines.
    speeds : ndarray
        Programmed speed within the machine's [mm/s]; no account of bends.
    accelerations, jerks : ndarray
        Largest along the path [mm/s2], [mm/s3].
    """

    lengths: Floats
    enter: Floats
    leave: Floats
    radii: Floats
    spins: Floats
    speeds: Floats
    accelerations: Floats
    jerks: Floats


def blocks_of_polylines(points: Floats, feeds: Floats, machine: Machine) -> Blocks:
    """Return the blocks of straight paths.

    Parameters
    ----------
    points : ndarray of shape (..., n + 1, 3)
        Corners of each path [mm].
    feeds : ndarray of shape (..., n) or float
        Programmed speeds [mm/s]; infinite for the machine's rapid rate.
    machine : Machine
    """
    steps = np.diff(points, axis=-2)
    lengths = np.linalg.norm(steps, axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        directions = steps / lengths[..., None]
    directions = _fill(directions, lengths > SHORTEST)
    return Blocks(
        lengths=lengths,
        enter=directions,
        leave=directions,
        radii=np.full(lengths.shape, np.inf),
        spins=np.zeros(lengths.shape),
        speeds=np.minimum(feeds, machine.speed_along(directions)),
        accelerations=machine.acceleration_along(directions),
        jerks=machine.jerk_along(directions),
    )


def blocks_of_toolpath(toolpath: Toolpath, machine: Machine) -> Blocks:
    """Return the blocks of `toolpath`, one for each move; rapids run at the machine's rate."""
    is_rapid = toolpath.kinds == Kind.RAPID
    feeds = np.where(is_rapid, np.inf, toolpath.feeds)
    points = np.vstack([toolpath.start[None, :], toolpath.points])
    straight = blocks_of_polylines(points, feeds, machine)
    arcs = np.flatnonzero(toolpath.is_arc)
    if not len(arcs):
        return straight
    lengths, rise = toolpath.lengths[arcs], np.diff(points[:, 2])[arcs]
    slope_sin = rise / lengths
    slope_cos = np.sqrt(np.maximum(0.0, 1.0 - slope_sin**2))
    spins = np.sign(toolpath.sweeps[arcs])
    spokes = np.stack([points[arcs, :2], points[arcs + 1, :2]]) - toolpath.centers[arcs]
    flat_radii = np.hypot(spokes[..., 0], spokes[..., 1])
    tangents = np.stack([-spokes[..., 1], spokes[..., 0]], axis=-1) / flat_radii[..., None]
    tangents *= (spins * slope_cos)[:, None]
    ends = np.dstack([tangents, np.broadcast_to(slope_sin, flat_radii.shape)])
    # an arc's direction turns: it gets what the weaker of x and y can do
    zero = np.zeros_like(slope_sin)
    worst = np.stack(
        [np.stack(d, axis=-1) for d in ((slope_cos, zero, slope_sin), (zero, slope_cos, slope_sin))]
    )
    changed = Blocks(
        lengths=lengths,
        enter=ends[0],
        leave=ends[1],
        radii=flat_radii.mean(axis=0) / np.maximum(slope_cos, SHORTEST) ** 2,
        spins=spins,
        speeds=np.minimum(feeds[arcs], machine.speed_along(worst).min(axis=0)),
        accelerations=machine.acceleration_along(worst).min(axis=0),
        jerks=machine.jerk_along(worst).min(axis=0),
    )
    return _with_rows(straight, arcs, changed)


def _with_rows(blocks: Blocks, rows: NDArray[np.intp], other: Blocks) -> Blocks:
    """Return `blocks` with those at `rows` taken from `other`."""
    merged = {}
    for name in Blocks.__slots__:
        values = getattr(blocks, name).copy()
        values[rows] = getattr(other, name)
        merged[name] = values
    return Blocks(**merged)


def _fill(directions: Floats, known: NDArray[np.bool_]) -> Floats:
    """Return `directions` with the unknown ones taken from the block before, else after."""
    if known.all():
        return directions
    count = known.shape[-1]
    before = np.maximum.accumulate(np.where(known, np.arange(count), -1), axis=-1)
    after = np.minimum.accumulate(np.where(known, np.arange(count), count)[..., ::-1], axis=-1)[
        ..., ::-1
    ]
    source = np.where(before >= 0, before, np.minimum(after, count - 1))
    filled = np.take_along_axis(directions, source[..., None], axis=-2)
    return np.where(np.isfinite(filled), filled, np.eye(3)[0])
