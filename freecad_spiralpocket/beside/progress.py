# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far several pockets are that are planned at once."""

from __future__ import annotations


def stage_among(done: int, count: int, stage: str) -> str:
    """Return what is being done, with the number of the pocket if there are several."""
    return stage if count == 1 else f"Pocket {min(done + 1, count)} of {count}: {stage}"
