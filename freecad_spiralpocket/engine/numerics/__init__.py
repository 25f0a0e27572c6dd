# SPDX-License-Identifier: LGPL-2.1-or-later
"""What numpy lacks, without the time that scipy takes to load: filters, graphs, nearest points."""
