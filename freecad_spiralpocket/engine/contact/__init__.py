# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of the cutter's rim meets stock along a path, against all motion before it."""
