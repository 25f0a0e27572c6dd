# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inner curves and spirals about the medial axis [LM15, EAS07]."""
