# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a region is opened, and the way down: helix, slot, groove, round walls, from the air."""
