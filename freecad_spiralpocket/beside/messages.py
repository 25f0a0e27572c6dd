# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a process beside FreeCAD sends: messages, each a length of eight bytes and a pickle."""

from __future__ import annotations

import pickle
import struct
from typing import Any, TypeAlias

#: A kind and what belongs to it; see `beside.process`.
Message: TypeAlias = tuple[Any, ...]

_HEAD = struct.Struct("<Q")
LONGEST = 1 << 32  # bytes of a message: more is no message of ours


def framed(*message: Any) -> bytes:
    """Return a message as it is sent."""
    data = pickle.dumps(message, pickle.HIGHEST_PROTOCOL)
    return _HEAD.pack(len(data)) + data


class Mailbox:
    """Puts messages together that come in pieces."""

    def __init__(self) -> None:
        self._received = bytearray()

    def put(self, piece: bytes) -> None:
        """Take a piece of what is sent."""
        self._received += piece

    def take(self) -> Message | None:
        """Return the next message that is there whole, None if there is none.

        Raises
        ------
        ValueError
            If what came is no message.
        """
        if len(self._received) < _HEAD.size:
            return None
        (length,) = _HEAD.unpack_from(self._received)
        if length > LONGEST:
            raise ValueError("no message of a process beside FreeCAD")
        end = _HEAD.size + length
        if len(self._received) < end:
            return None
        message: Message = pickle.loads(bytes(self._received[_HEAD.size : end]))
        del self._received[:end]
        return message
