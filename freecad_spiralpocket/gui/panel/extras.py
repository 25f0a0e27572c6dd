# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands below the pages of the panel: live preview, result, buttons.

The page makes one of each factory in `FACTORIES` when a panel opens, hands its
widget to the panel, tells it of changes, and closes it with the panel. The
page knows nothing more of them, they know the page (`page.obj`, `page.form`).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from ..compare.button import Compare
from ..planning.outlook import Outlook
from ..plots.button import Plots
from ..preview.live import Preview
from ..result.box import ResultBox


class Extra(Protocol):
    """What the page asks of an extra."""

    def widget(self) -> Any:
        """Return the widget to show, with its title, None for nothing; called once."""

    def changed(self) -> None:
        """Note that an input of the operation was changed, by a field or elsewhere.

        Comes with every key stroke: start a timer, compute nothing here.
        """

    def computed(self) -> None:
        """Note that the panel opened, or that Apply or OK has computed the path."""

    def close(self) -> None:
        """Give up everything that reaches out of the panel; the widgets go by themselves.

        Called once, also when the operation is gone.
        """


#: From the top to the bottom; each is called with the page.
FACTORIES: list[Callable[[Any], Extra]] = [Outlook.of, Preview, ResultBox, Plots, Compare]
