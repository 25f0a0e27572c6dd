# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fronts that grow with the engagement held, and the strokes and spirals that cut what is new."""
