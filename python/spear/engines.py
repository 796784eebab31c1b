# SPDX-License-Identifier: MIT
"""Engines of this user that run on this machine: what ``spear engine list`` shows and ``spear.connect()`` chooses from."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from spear import _native
from spear.errors import Error


@dataclass(frozen=True)
class RunningEngine:
    """An engine that listens."""

    address: str
    process_id: int
    engine: str = ""
    """Kind and version, "embedded 5.5.0"."""
    project: str = ""
    scene: str = ""
    frame: int = 0
    """The engine's frame counter."""
    uptime: float = 0.0
    """Seconds since it began to listen."""
    sessions: int = 0
    """Clients that are connected."""
    error: str = ""
    """Why it does not answer; what is above is empty then."""


def list_engines(timeout: float = 2.0) -> list[RunningEngine]:
    """All engines of this user on this machine, on Unix sockets and on TCP, asked at the same time for at most so many seconds each.

    Engines list themselves in ``$XDG_RUNTIME_DIR/spear`` or ``/tmp/spear-<uid>``; entries of engines that were killed are removed here.
    """
    listed = _native.list_engines()
    if not listed:
        return []
    with ThreadPoolExecutor(min(16, len(listed))) as pool:
        return list(pool.map(lambda one: _ask(one[0], one[1], round(timeout * 1000)), sorted(listed, key=lambda one: one[1])))


def _ask(address: str, process_id: int, timeout_ms: int) -> RunningEngine:
    try:
        answer = _native.describe_engine(address, timeout_ms)
    except Error as error:
        return RunningEngine(address, process_id, error=error.message)
    fields = ("engine", "project", "scene", "frame", "uptime", "sessions")
    return RunningEngine(address, process_id, **{name: answer[name] for name in fields})
