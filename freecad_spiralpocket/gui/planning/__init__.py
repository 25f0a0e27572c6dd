# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets planned beside the window: lanes of workers, and the outlook on the next path."""
