# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isotherms as nested laps, and one path of any tree of nested laps [HQS24]."""
