# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a path does, measured on its moves alone: gouge, ground left, loads, strikes in the air."""
