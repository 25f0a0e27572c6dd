# SPDX-License-Identifier: LGPL-2.1-or-later
"""The live preview: on the part, and its box in the panel."""
