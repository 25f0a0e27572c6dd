# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plots along the time of a cut."""
