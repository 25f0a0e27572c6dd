# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sequence of runs with shorter links than nearest first has: searched, not taken as it comes.

Going to the nearest run each time leaves rests here and there that are fetched one by
one in the end. How long a link takes from each run to each other is estimated, and which
runs must be done before it is free. Then blocks of neighbors in the sequence change
places as long as that saves time (3-opt without reversals, for strokes are cut one way
only). What comes of it is a proposal: ordering.py makes the links.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from ..growth.stroke_runs import Run
from ..model import Floats
from ..shapes.points import unit
from .cleared import NEVER
from .estimates import link_seconds
from .linking import hermite_links, link_times
from .ordering import Situation, Step, order

#: Links are estimated to so many of the nearest ways to begin other runs.
NEAREST = 25
#: Lengths of their handles, over the distance and over R.
HANDLES = ((0.25, 0.8, 2.0), (2.0,))
#: So many links between two runs are kept at most: the fastest, and slower ones that need less.
KEPT = 4
#: What no such link leads to is as far as so many stops, and this times the distance.
STOPS, ROUND = 4.0, 1.4
#: Blocks of so many runs are moved, behind or before one of so many nearest.
BLOCKS, BESIDE = (1, 2, 3, 4, 6, 9), 10
#: Runs that are looked at, at most.
MOST = 400_000
#: What saves less saves nothing [s].
GAIN = 1e-6


class Links:
    """How long links take, about, and what must be done before them.

    Sets of runs are the bits of a number here: they are compared 100,000 times.

    Parameters
    ----------
    runs : sequence of Run
    ends, headings : ndarray of shape (1 + len(runs), 2)
        Where the entry and each run end [mm], and the unit directions there.
    situation : Situation

    Attributes
    ----------
    needs : list of int
        What must be done before each run.
    """

    def __init__(
        self, runs: Sequence[Run], ends: Floats, headings: Floats, situation: Situation
    ) -> None:
        motion = situation.motion
        self._cleared, self._motion = situation.cleared, motion
        counts = [len(r.ways) - r.spare for r in runs]
        starts = np.concatenate([r.starts[:n] for r, n in zip(runs, counts, strict=True)])
        arriving = np.concatenate([r.headings[:n] for r, n in zip(runs, counts, strict=True)])
        home = np.repeat(np.arange(len(runs)), counts)
        self._bit_of = {stroke: 1 << i for i, run in enumerate(runs) for stroke in run.strokes}
        away = np.hypot(*np.moveaxis(starts - ends[:, None], -1, 0))
        distances = np.full((len(ends), len(runs)), np.inf)
        np.minimum.at(distances, (np.arange(len(ends))[:, None], home), away)
        stops = STOPS * motion.cut_feed / motion.acceleration
        self.needs = [_bits(run.needs) for run in runs]
        self._by_distance: list[list[float]] = (
            stops + ROUND * distances / motion.link_feed
        ).tolist()
        self._known: list[dict[int, list[tuple[float, int]]]] = []
        for i, (end, heading) in enumerate(zip(ends, headings, strict=True)):
            near = [w for w in np.argsort(away[i], kind="stable") if home[w] != i - 1][:NEAREST]
            paths = hermite_links(
                end, heading, starts[near], arriving[near], situation.radius, HANDLES
            )
            needed = situation.cleared.needed(paths)
            seconds = link_times(paths, motion)
            seconds[(needed == NEVER).any(axis=-1)] = np.inf
            found: dict[int, list[tuple[float, int]]] = {}
            for w, here, strokes in zip(near, seconds, needed, strict=True):
                to = int(home[w])
                found.setdefault(to, []).extend(self._fastest(here, strokes, to))
            self._known.append({to: sorted(links) for to, links in found.items()})

    def seconds(self, before: int, run: int, done: int) -> float:
        """Return how long the link to a run takes from the one before, -1 for the entry [s].

        Where none is free that is known, there may be a longer way round.
        """
        for seconds, needs in self._known[before + 1].get(run, ()):
            if not needs & ~done:
                return seconds
        return self._by_distance[before + 1][run]

    def learn(self, steps: Sequence[Step]) -> None:
        """Take over how long the links of steps that follow each other really take."""
        before, done = -1, 0
        for step in steps:
            seconds, needs = link_seconds([step], self._motion), done
            if step.link is not None:
                needs = self._needs(self._cleared.needed(step.link)) if len(step.link) else 0
            links = self._known[before + 1].setdefault(step.run, [])
            # what was to be free and faster was not
            links[:] = [(s, n) for s, n in links if s >= seconds or n & ~done]
            links.append((seconds, needs & done))
            links.sort()
            before, done = step.run, done | 1 << step.run

    def _needs(self, strokes: NDArray[np.int32]) -> int:
        """Return what must be done before strokes are, negative ones being none."""
        needs = 0
        for stroke in set(strokes.tolist()):
            needs |= self._bit_of.get(stroke, 0)
        return needs

    def _fastest(
        self, seconds: Floats, strokes: NDArray[np.int32], run: int
    ) -> list[tuple[float, int]]:
        """Return the fastest of some links to a run, and slower ones that need less.

        Parameters
        ----------
        seconds : ndarray of shape (h,)
        strokes : ndarray of int, shape (h, n)
            Which stroke must be done at each point; negative for none.
        run : int
        """
        kept: list[tuple[float, int]] = []
        for i in np.argsort(seconds, kind="stable").tolist():
            if not np.isfinite(seconds[i]) or len(kept) == KEPT:
                break
            needs = self._needs(strokes[i])
            if needs >> run & 1 or any(not less & ~needs for _, less in kept):
                continue
            kept.append((float(seconds[i]), needs))
            if not needs:
                break
        return kept

    def nearest(self, before: int) -> list[int]:
        """Return all runs, the nearest to the end of one first."""
        away = self._by_distance[before + 1]
        return sorted((r for r in range(len(away)) if r != before), key=lambda r: away[r])


def _bits(numbers: Iterable[int]) -> int:
    return sum(1 << n for n in numbers)


def in_better_sequence(
    steps: Sequence[Step],
    runs: Sequence[Run],
    situation: Situation,
    tick: Callable[[], None],
) -> Sequence[Step]:
    """Return all runs in a sequence whose links take less time, the given steps if none is found.

    Parameters
    ----------
    steps : sequence of Step
        All runs, in an order in which they can be cut.
    runs : sequence of Run
    situation : Situation
    tick : callable
        Is called once a run; may raise.

    Notes
    -----
    Deterministic: the moves are counted, not timed.
    """
    ends, headings = [situation.here], [situation.heading]
    for step in sorted(steps, key=lambda step: step.run):
        ends.append(step.points[-1])
        headings.append(unit(step.points[-1] - step.points[-2]))
    links = Links(runs, np.array(ends), np.array(headings), situation)
    links.learn(steps)
    known = [step.run for step in steps]
    search = _Search(known, links)
    while search.has_improved():
        pass
    if search.sequence == known:
        return steps
    found = order(runs, situation, tick, search.sequence, steps)
    return min(steps, found, key=lambda steps: link_seconds(steps, situation.motion))


class _Search:
    """A sequence and how long its links take; blocks of it change places."""

    def __init__(self, sequence: Sequence[int], links: Links) -> None:
        self.sequence, self._links, self._left = list(sequence), links, MOST
        self._after = [links.nearest(run)[:BESIDE] for run in range(-1, len(sequence))]
        self._before: list[list[int]] = [[] for _ in sequence]
        for before, nearest in enumerate(self._after, start=-1):
            for run in nearest:
                self._before[run].append(before)
        self._note()

    def _note(self) -> None:
        """Note where each run is, what is done before it, and how long the links take up to it."""
        self._at = {run: at for at, run in enumerate([-1, *self.sequence], start=-1)}
        self._done, self._spent, before = [0], [0.0], -1
        for run in self.sequence:
            seconds = self._links.seconds(before, run, self._done[-1])
            self._spent.append(self._spent[-1] + seconds)
            self._done.append(self._done[-1] | 1 << run)
            before = run

    def has_improved(self) -> bool:
        """Try all moves once, take those that save time; return whether any did."""
        has_improved = False
        for length in BLOCKS:
            for begin in range(len(self.sequence) - length + 1):
                for low, middle, high in self._moves(begin, begin + length):
                    if self._left <= 0:
                        return False
                    if self._saves(low, middle, high):
                        seq = self.sequence
                        seq[low:high] = seq[middle:high] + seq[low:middle]
                        self._note()
                        has_improved = True
                        break
        return has_improved

    def _moves(self, begin: int, end: int) -> list[tuple[int, int, int]]:
        """Return the ways to move a block behind or before a run that is near.

        As the bounds of two blocks that change places.
        """
        first, last = self.sequence[begin], self.sequence[end - 1]
        places = {self._at[run] + 1 for run in self._before[first]}
        places |= {self._at[run] for run in self._after[last + 1]}
        return [
            (place, begin, end) if place < begin else (begin, end, place)
            for place in sorted(places)
            if not begin <= place <= end
        ]

    def _saves(self, low: int, middle: int, high: int) -> bool:
        """Return whether it saves time if [low, middle) and [middle, high) change places."""
        seq, links = self.sequence, self._links
        until = min(high + 1, len(seq))
        left = self._spent[until] - self._spent[low] - GAIN
        done, before = self._done[low], seq[low - 1] if low else -1
        for run in (*seq[middle:high], *seq[low:middle], *seq[high:until]):
            self._left -= 1
            if links.needs[run] & ~done:
                return False
            left -= links.seconds(before, run, done)
            if left <= 0:
                return False
            done |= 1 << run
            before = run
        return True
