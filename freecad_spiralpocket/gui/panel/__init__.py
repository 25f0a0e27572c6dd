# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel: its pages, and what stands below them."""
