# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where icons, forms and translations lie, and the icon's name."""

from __future__ import annotations

from pathlib import Path

RESOURCES = Path(__file__).resolve().parents[2] / "resources"
#: The icon's name in the folder that `startup` registers.
ICON = "SpiralPocket"
