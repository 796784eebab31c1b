# SPDX-License-Identifier: MIT
"""The log of frames that the plugin SpearBench keeps for other processes to read (tools/bench/SpearBench/Public/SpearBenchFrames.h)."""

from __future__ import annotations

import mmap
import struct
from pathlib import Path

_HEADER = 32
_ENTRY = struct.Struct("<Qqqq")


class FrameLog:
    """When each frame of an engine began, by the monotonic clock of the machine (nanoseconds of ``time.monotonic_ns()``).

    The engine writes it with ``-SpearBenchFrameLog=PATH``; looking at it does not disturb the engine."""

    ENTRIES = 1 << 16

    def __init__(self, path: Path) -> None:
        self._path = path
        self._map: mmap.mmap | None = None

    @staticmethod
    def argument(path: Path) -> str:
        """What the engine is started with."""
        return f"-SpearBenchFrameLog={path}"

    def count(self) -> int:
        """Frames finished so far."""
        if self._map is None:
            if not self._path.exists() or self._path.stat().st_size < _HEADER + _ENTRY.size * self.ENTRIES:
                return 0
            with self._path.open("rb") as file:
                self._map = mmap.mmap(file.fileno(), 0, prot=mmap.PROT_READ)
        return int(struct.unpack_from("<Q", self._map, 0)[0])

    def entry(self, number: int) -> tuple[int, int, int, int]:
        """Of the frame noted as that number: the engine's frame counter, when it began, when it ended, when its world began to tick."""
        if self._map is None:
            raise LookupError("no frame has been noted yet")
        frame, began, ended, ticked = _ENTRY.unpack_from(self._map, _HEADER + _ENTRY.size * (number % self.ENTRIES))
        return frame, began, ended, ticked

    def began(self, first: int) -> list[int]:
        """When the finished frames from that number on began; the log keeps the last 65,536."""
        count = self.count()
        return [self.entry(number)[1] for number in range(max(first, count - self.ENTRIES + 8), count)]

    def close(self) -> None:
        """Lets go of the file."""
        if self._map is not None:
            self._map.close()
            self._map = None
