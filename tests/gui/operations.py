# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests ask of operations that were made in the window."""


def only_operation(job):
    """Return the job's one operation."""
    (operation,) = job.Operations.Group
    return operation


def cut_moves(operation):
    """Return the number of feed moves in the operation's path."""
    return sum(c.Name in ("G1", "G2", "G3") for c in operation.Path.Commands)
