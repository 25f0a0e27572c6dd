# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result box: figures, and remarks with their places."""
