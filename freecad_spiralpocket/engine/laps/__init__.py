# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategies: from a cutter-center region to a spiral, one file each."""
