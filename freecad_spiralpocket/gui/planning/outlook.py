# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the next recompute will bring, kept up to date while values are typed.

A change is looked at a moment later, once: the requests of the pockets are foreseen,
those that stayed the same keep what they have. Of the others a draft is made at once
and, when nothing has changed for a while, the proved plan. The newest request wins;
what is under way for an older one is ended. The document is only read.

Preview, result, plots and comparison of one panel share one outlook and listen to it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide import QtCore

from ...beside.tasks import Drawn
from ...engine.dependencies import require_libraries
from ...engine.errors import CancelledError, SpiralPocketError, named
from ...engine.model import Notice, Plan, PocketRequest
from ...op.known import Known
from . import lanes
from .pocket import Pocket

SOON = 8  # ms after a change until it is looked at, so that several changes are one
QUIET = 300  # ms without a change after which proofs begin
AGAIN = 50  # ms, how often is asked whether the drafts are done
TOGETHER = 500  # ms, so long drafts of some pockets wait for those of the others: the window
# draws once, which takes longer than a draft
MOST_KNOWN = 500  # things about the model that are kept


class Outlook:
    """The pockets of an operation as they will be; an extra of the panel without widgets.

    Attributes
    ----------
    pockets : list of Pocket
        One for each selected face that makes a sound request.
    problems : list of (str, SpiralPocketError)
        What keeps other pockets, or all, from being planned, with their labels.
    notices : list of Notice
        What is to be told of the pockets before they are planned.
    listeners : list of callable
        Called after every change of what can be seen here.
    known : Known
        What was read off the model.
    is_on, is_stopped : bool
        Whether it looks at all; whether proofs wait for the next change, as Stop was pressed.
    """

    def __init__(self, page: Any) -> None:
        self._obj = page.obj
        self.pockets: list[Pocket] = []
        self.problems: list[tuple[str, SpiralPocketError]] = []
        self.notices: list[Notice] = []
        self.listeners: list[Callable[[], None]] = []
        self.is_on, self.is_stopped = True, False
        self.known = Known()
        self._is_closed = False
        self._soon, self._quiet, self._news = (QtCore.QTimer() for _ in range(3))
        for timer, slot in (
            (self._soon, self._look),
            (self._quiet, self._prove),
            (self._news, self.tell),
        ):
            timer.setSingleShot(True)
            timer.timeout.connect(slot)

    @classmethod
    def of(cls, page: Any) -> Outlook:
        """Return the outlook of a panel's page, one for all that ask."""
        if getattr(page, "outlook", None) is None:
            page.outlook = cls(page)
        return page.outlook

    def widget(self) -> None:
        """Return nothing: others show what is here."""

    def changed(self) -> None:
        """Look at the operation soon."""
        self.is_stopped = False
        if self._is_closed:
            return
        if self.is_on:
            self._soon.start(SOON)
            self._quiet.start(QUIET)
        else:
            self._news.start(SOON)  # the path is out of date

    def computed(self) -> None:
        """Look again at once; after Stop nothing goes on until the next change."""
        self.changed()
        if self.is_behind:  # a message box may follow, behind which nothing old must stand
            self._soon.stop()
            self._look()
        self.is_stopped = was_stopped(self._obj)
        if self.is_stopped:
            self._quiet.stop()
            for pocket in self.pockets:
                pocket.close()

    def switch(self, on: bool) -> None:
        """Go on looking, or stop and forget everything."""
        self.is_on = on
        if on:
            self.changed()
        else:
            self._clear()
            self.tell()

    def close(self) -> None:
        """End what is under way."""
        self._is_closed = True
        self.listeners.clear()
        self._clear()

    def tell(self) -> None:
        """Tell the listeners."""
        for listener in list(self.listeners):
            listener()

    @property
    def plans(self) -> list[Plan]:
        """Return the proved plans of all pockets that can be cut, empty while one is missing."""
        return [d.plan for d in self.drawn]

    @property
    def drawn(self) -> list[Drawn]:
        """Return these plans drawn."""
        if not all(p.is_settled for p in self.pockets):
            return []
        return [p.drawn for p in self.pockets if p.drawn is not None]

    @property
    def errors(self) -> list[SpiralPocketError]:
        """Return what keeps pockets from being cut, and which if not all of several."""
        return named(self.failures, len(self.pockets) + len(self.problems))

    @property
    def failures(self) -> list[tuple[str, SpiralPocketError]]:
        """Return the labels of all pockets that cannot be cut, and why."""
        return [*self.problems, *((p.label, p.error) for p in self.pockets if p.error)]

    @property
    def are_several(self) -> bool:
        """Return whether several pockets are selected."""
        return len(self.pockets) + len(self.problems) > 1

    @property
    def fraction(self) -> float:
        """Return the share of the proofs that is done."""
        return sum(p.fraction for p in self.pockets) / max(1, len(self.pockets))

    @property
    def is_behind(self) -> bool:
        """Return whether a change has not been looked at yet."""
        return self._soon.isActive()

    @property
    def is_settled(self) -> bool:
        """Return whether nothing more will come without a change."""
        waits = any(t.isActive() for t in (self._soon, self._quiet, self._news))
        return not waits and (self.is_stopped or all(p.is_settled for p in self.pockets))

    def _tell_soon(self) -> None:
        """Tell the listeners, together with what else comes in a moment."""
        if all(p.is_drafted or p.is_settled for p in self.pockets):
            self._news.start(0)
        elif not self._news.isActive():
            self._news.start(TOGETHER)

    def _clear(self) -> None:
        for timer in (self._soon, self._quiet, self._news):
            timer.stop()
        for pocket in self.pockets:
            pocket.close()
        self.pockets, self.problems, self.notices = [], [], []

    def _look(self) -> None:
        """Foresee the requests; keep the pockets that stayed the same."""
        if self.known.count > MOST_KNOWN:
            self.known = Known()
        try:
            require_libraries()
            from ...op.foresight import requests_of

            found, self.notices, labels = [], [], []
            if self._obj.Active:
                found, self.notices, labels = requests_of(self._obj, self.known)
        except SpiralPocketError as error:
            found, self.notices, labels = [error], [], [""]
        pairs = list(zip(labels, found, strict=True))
        self.problems = [(label, f) for label, f in pairs if isinstance(f, SpiralPocketError)]
        old = {(p.request, p.original): p for p in self.pockets}
        self.pockets = []
        sound = [(label, f) for label, f in pairs if isinstance(f, PocketRequest)]
        for (label, wanted), original in zip(sound, _originals(sound), strict=True):
            pocket = old.pop((wanted, original), None)
            pocket = pocket or Pocket(wanted, original, self._tell_soon)
            pocket.label = label
            self.pockets.append(pocket)
        for pocket in old.values():
            pocket.close()
        for pocket in self.pockets:
            pocket.draw()
        if all(p.is_settled for p in self.pockets):
            self._quiet.stop()
        self.tell()
        lanes.proofs.warm_up()

    def _prove(self) -> None:
        """Let the proofs begin, the small pockets first, when the drafts leave them a core."""
        if not all(p.is_drafted or p.is_settled for p in self.pockets):
            self._quiet.start(AGAIN)
            return
        for pocket in sorted(self.pockets, key=lambda p: p.request.pocket.area):
            pocket.prove()
        self.tell()


def _originals(found: Sequence[tuple[str, PocketRequest]]) -> list[PocketRequest]:
    """Return for each labelled request that of the first pocket which it is a copy of."""
    if len(found) < 2:
        return [wanted for _, wanted in found]
    from ...engine import copies  # needs shapely

    wanted = [request for _, request in found]
    return [wanted[i] for i in copies.originals(wanted)]


def was_stopped(obj: Any) -> bool:
    """Return whether an operation has no path as Stop was pressed; an Undo brings it back."""
    return not obj.Path.Length and any(isinstance(e, CancelledError) for e in obj.Proxy.errors)
