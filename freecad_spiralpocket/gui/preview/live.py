# SPDX-License-Identifier: LGPL-2.1-or-later
"""The live preview: draws the outlook of the panel on the part.

Shows drafts until the proved plans are there, and says which it is. What a change has
made stale is shown until there is something newer of every pocket, a fraction of a
second, so that nothing flickers while a value is typed.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np

from ...beside.tasks import Drawn
from ...engine.model import Floats
from ...op import preferences
from ...op.request import has_feeds
from ...op.results import machining_time, start_times
from ..planning.outlook import Outlook
from ..planning.pocket import Pocket
from ..texts.localized import in_panel
from ..texts.measures import feed_unit, switched_off
from .box import PreviewBox
from .colors import OVER_LIMIT, Scale, is_cut
from .scene import DraftItem, PathItem, Scene

translate = FreeCAD.Qt.translate

#: The name under which is kept whether previews are wanted.
LIVE = "Live"


class Preview:
    """An extra of the panel.

    Attributes
    ----------
    items : dict of DraftItem or PathItem
        What is drawn, by the pocket.
    box : PreviewBox
    """

    def __init__(self, page: Any) -> None:
        self._obj, self._outlook = page.obj, Outlook.of(page)
        self._scene = Scene(page.obj.ViewObject)
        self.items: dict[Pocket, Any] = {}
        self._scale = Scale("engagement", 180.0)
        self.box = PreviewBox(self._switch, self._color, self._play)
        self.box.live.setChecked(preferences.read(LIVE, True))
        self.box.set_total(0.0)
        self._outlook.listeners.append(self._update)
        page.preview = self

    def widget(self) -> Any:
        """Return the box."""
        return self.box

    def changed(self) -> None:
        """Wait for the outlook."""

    computed = changed

    def close(self) -> None:
        """Take the preview off the part; the widgets may be gone already."""
        self._scene.close()
        self.items.clear()

    def point_at(self, seconds: float | None) -> None:
        """Show the cutter where it is at a time of the whole cut [s], None for nowhere."""
        point, drawn = self._place(seconds)
        if drawn is None:
            self._scene.place_cutter(None)
        else:
            request = drawn.plan.request
            height = request.heights.start_depth - request.floor
            self._scene.place_cutter(point, request.cutter_radius, height)

    def mark(self, place: tuple[float, float, float], radius: float) -> None:
        """Set the cutter on a place [mm]."""
        self._scene.place_cutter(np.array(place), radius, radius)

    def _update(self) -> None:
        """Draw what the outlook holds."""
        pockets = self._outlook.pockets
        scale = self._wanted_scale()
        recolored, self._scale = scale != self._scale, scale
        waits = any(not (p.is_drafted or p.is_settled) for p in pockets)
        kept = {p: item for p, item in self.items.items() if waits or p in pockets}
        for pocket in pockets:
            item = kept.get(pocket)
            if pocket.drawn is not None and not isinstance(item, PathItem):
                kept[pocket] = _path_item(pocket.drawn, scale)
            elif pocket.error is not None:
                kept.pop(pocket, None)  # no draft of what cannot be cut
            elif pocket.draft is not None and item is None:
                kept[pocket] = DraftItem(pocket.draft)
            elif recolored and isinstance(item, PathItem):
                item.color(scale)
        if list(kept.items()) != list(self.items.items()):
            self.items = kept
            self._scene.show(list(kept.values()))
            self._play(self.box.share)
        self.box.bar.set_scale(scale)
        plans = self._outlook.plans
        is_known = bool(plans) and has_feeds(self._obj.ToolController)
        self.box.set_total(machining_time(plans), is_known=is_known)
        self.box.status.setText(self._status())

    def _wanted_scale(self) -> Scale:
        """Return the scale for all pockets together."""
        quantity = self.box.quantity.currentData()
        requests = [p.request for p in self._outlook.pockets]
        if quantity == "feed":
            feeds = [float(d.trace.feeds[is_cut(d.trace)].max(initial=0)) for d in self._drawn()]
            planned = [r.feeds.horizontal for r in requests]
            unit, _ = feed_unit()
            return Scale(quantity, 60 / unit * max([*feeds, *planned], default=1.0), unit=unit)
        limits = [r.engagement_limit for r in requests if r.engagement_limit > 0]
        limit = float(np.degrees(max(limits, default=np.pi)))
        return Scale(quantity, min(180.0, OVER_LIMIT * limit), limit)

    def _drawn(self) -> list[Drawn]:
        return [p.drawn for p in self._outlook.pockets if p.drawn is not None]

    def _status(self) -> str:
        """Return how far the preview is, or why there is none."""
        outlook = self._outlook
        if not outlook.is_on:
            return translate("SpiralPocket", "Switched off.")
        if outlook.errors:
            return "\n".join(dict.fromkeys(in_panel(str(e)) for e in outlook.errors))
        count, done = len(outlook.pockets), len(self._drawn())
        if not count:
            return "" if self._obj.Active else switched_off()
        if done == count:
            return translate("SpiralPocket", "This is the proved path.")
        if outlook.is_stopped:
            return translate("SpiralPocket", "Draft. Stopped; Apply or the next change goes on.")
        return translate("SpiralPocket", "Draft. The path is being proved: {:.0f} %").format(
            100 * outlook.fraction
        )

    def _switch(self, on: bool) -> None:
        """Go on looking or not, in panels to come as well."""
        preferences.write(LIVE, on, True)
        self._outlook.switch(on)

    def _color(self, quantity: str) -> None:
        self._update()

    def _play(self, share: float) -> None:
        """Show the cut up to a share of its time."""
        pockets = [p for p in self._outlook.pockets if p.drawn is not None]
        plans = [d.plan for d in self._drawn()]
        seconds = share * machining_time(plans)
        for pocket, begin in zip(pockets, start_times(plans), strict=True):
            item = self.items.get(pocket)
            if isinstance(item, PathItem):
                item.play(seconds - begin if share < 1 else np.inf)
        self.point_at(seconds if share < 1 and plans else None)

    def _place(self, seconds: float | None) -> tuple[Floats | None, Drawn | None]:
        """Return where the cutter is at a time of the whole cut, and in which plan."""
        found = None, None
        drawn = self._drawn()
        if seconds is not None:
            for each, begin in zip(drawn, start_times([d.plan for d in drawn]), strict=True):
                if begin <= seconds:  # until the next begins it stands where this one ends
                    found = each.trace.point_at(seconds - begin), each
        return found


def _path_item(drawn: Drawn, scale: Scale) -> PathItem:
    return PathItem(drawn.trace, drawn.areas, drawn.plan.request.floor, scale)
