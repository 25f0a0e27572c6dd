# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the machine goes along a path: time under acceleration and jerk, feeds, forces."""
