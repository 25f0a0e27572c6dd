# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where icons, forms and translations lie."""

from __future__ import annotations

from pathlib import Path

RESOURCES = Path(__file__).resolve().parents[2] / "resources"
