# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel's fields: what is typed, and the properties that it is tied to."""
