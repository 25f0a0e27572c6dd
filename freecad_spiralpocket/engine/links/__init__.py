# SPDX-License-Identifier: LGPL-2.1-or-later
"""In which order strokes are cut, and how the cutter gets from one to the next."""
