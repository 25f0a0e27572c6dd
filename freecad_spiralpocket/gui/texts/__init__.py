# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said to the user: in words, in the user's language and unit."""
