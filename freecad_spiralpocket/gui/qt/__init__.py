# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt's objects as Python holds them here: names, timers, the theme's colors."""
