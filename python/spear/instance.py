# SPDX-License-Identifier: MIT
"""Engines: start one, connect to one, and its frames."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import TYPE_CHECKING, Any, NamedTuple

from spear import _native, facts, naming
from spear._native import SYNC
from spear.game import Game
from spear.trace import Trace

if TYPE_CHECKING:
    from typing_extensions import Self


class Traffic(NamedTuple):
    """Messages one way: batches of operations, or answers to them (one each)."""

    messages: int
    bytes: int
    """Of what is in the messages (operations, values, announcements), without the transport's envelope."""


class Statistics(NamedTuple):
    """What a session has moved so far, counted at both ends where messages are written and read.

    Lease, status and the question for these numbers are not counted.
    """

    sent: Traffic
    """By this client."""
    received: Traffic
    """By this client."""
    server_received: Traffic
    """By the server, from this client."""
    server_sent: Traffic
    """By the server, to this client."""
    kept_results: int
    """Results that the engine keeps because futures of this session name them; it hears of dropped futures with the next message."""


class Frame:
    """An open ``begin_frame`` or ``end_frame`` block; a context manager that ``Instance`` gives.

    Leaving it in good order sends what was recorded. Leaving it by an exception sends what was recorded too, closes the whole
    transaction with an empty end block, and lets the exception through. (Paper, section 3.)
    """

    __slots__ = ("_session", "_enter", "_single_step")

    def __init__(self, session: _native.Session, enter: Callable[[], None], single_step: bool) -> None:
        self._session = session
        self._enter = enter
        self._single_step = single_step

    def __enter__(self) -> Self:
        self._enter()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        if kind is None:
            self._session.close_block(self._single_step)
        else:
            self._session.abort_block()


class Instance:
    """A running engine and a session with it. Use it as a context manager, or call :meth:`close`."""

    def __init__(self, session: _native.Session) -> None:
        naming.load()
        self._session = session
        facts.add_instance(self)

    # Frames -------------------------------------------------------------------------------------------------------------

    def begin_frame(self) -> Frame:
        """The first half of a transaction: its work runs at the beginning of a frame, in program order."""
        return Frame(self._session, self._session.begin_block, False)

    def end_frame(self, single_step: bool = False) -> Frame:
        """The second half: its work runs at the end of the same frame.

        With ``single_step`` the engine then advances to the beginning of the next frame and waits there for the next transaction.
        """
        return Frame(self._session, self._session.end_block, single_step)

    def step(self, num_frames: int = 1, single_step: bool = False) -> None:
        """Runs that many empty transactions: at least so many frames pass, exactly so many with ``single_step``."""
        for _ in range(num_frames):
            with self.begin_frame():
                pass
            with self.end_frame(single_step=single_step):
                pass
        self.flush()

    def flush(self) -> None:
        """Waits until everything submitted has run; raises the first failure of a fire-and-forget operation not yet reported."""
        self._session.flush()

    # Worlds and facts ---------------------------------------------------------------------------------------------------

    def get_game(self) -> Game:
        """The primary game world. Needs no block."""
        return Game(self._session)

    def get_worlds(self) -> list[dict[str, Any]]:
        """All worlds: world, name, path, type, is_playing, is_primary. Needs no block."""
        return list(self._session.call("unreal_service.get_worlds", (), {}, SYNC))

    def get_engine_info(self) -> dict[str, Any]:
        """Which engine, version, project, scene and process is at the other end. Needs no block."""
        return dict(self._session.call("engine_service.get_engine_info", (), {}, SYNC))

    def get_schema(self, modules: Sequence[str] = ()) -> dict[str, Any]:
        """The live reflection schema, of all modules or those named. Needs no block."""
        # Millions of dictionaries and lists that all stay: Python's search for cycles in between costs two thirds of the time and finds none.
        collects = gc.isenabled()
        gc.disable()
        try:
            return dict(self._session.call("unreal_service.get_schema", (list(modules),), {}, SYNC))
        finally:
            if collects:
                gc.enable()

    def call(self, entry_point: str, /, *args: Any, **kwargs: Any) -> Any:
        """Calls any entry point by its full name, ``"engine_service.ping"``."""
        return self._session.call(entry_point, args, kwargs, SYNC)

    # Life ---------------------------------------------------------------------------------------------------------------

    @property
    def address(self) -> str:
        """Where the engine listens."""
        return self._session.address

    @property
    def process_id(self) -> int | None:
        """The engine's process if this instance launched it."""
        return self._session.process_id

    @property
    def uses_channel(self) -> bool:
        """Whether operations go through shared memory."""
        return self._session.uses_channel

    def statistics(self) -> Statistics:
        """Messages and bytes that have travelled so far, and results that the engine keeps. Answered also while the engine is held."""
        sent, received, server_received, server_sent, kept = self._session.statistics()
        return Statistics(Traffic(*sent), Traffic(*received), Traffic(*server_received), Traffic(*server_sent), kept)

    def trace(self, file: str | os.PathLike[str], *, operations: bool = False, events_per_thread: int = 0) -> Trace:
        """Records what this program and the engine do until the end of the ``with`` block, for ui.perfetto.dev or chrome://tracing.

        ``operations``: each single operation as well. ``events_per_thread``: room for so many; what finds none is dropped and counted (0: 262144).
        Raises ArgumentError while this program is being recorded already.
        """
        return Trace(self._session, file, operations, events_per_thread)

    def is_running(self) -> bool:
        """Whether the session still stands."""
        return self._session.is_open

    def close(self) -> None:
        """Closes the session; an engine that launch() started ends. Later use raises Disconnected. Closing twice is harmless."""
        self._session.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<spear.Instance {self.address}{'' if self.is_running() else ' (closed)'}>"


def connect(
    address: str = "", *, token: bytes | str = b"", lease: float | str | None = None, deadline: float | None = None, timeout: float = 10.0,
    channel: bool = True, spin: bool = True,
) -> Instance:
    """Connects to a running engine.

    ``address``: ``unix:/path`` or ``tcp://host:port``; empty means the only engine of this user that runs (``spear engine list``).
    ``lease``: seconds without sign of life after which the server takes this program for dead; ``"off"`` for debuggers.
    ``deadline``: seconds any wait may take before it raises; ``timeout``: for connecting. ``channel``: let operations go through shared
    memory if the engine is on this machine; ``spin``: let waits keep a core busy for some microseconds before they sleep (both are also
    turned off by SPEAR_CHANNEL=off and SPEAR_SPIN=off in the environment). Raises EngineNotRunning, VersionMismatch,
    Unauthorized.
    """
    return Instance(_native.connect(
        address=address, token=token.encode() if isinstance(token, str) else token, lease_ms=_lease_ms(lease),
        deadline_ms=0 if deadline is None else max(1, round(deadline * 1000)), timeout_ms=max(1, round(timeout * 1000)), channel=channel, spin=spin,
    ))


def launch(
    scene: str = "apartment", *, executable: str | os.PathLike[str] = "", arguments: Sequence[str] = (), fps: float | None = None,
    fixed_dt: float | None = None, address: str = "", token: bytes | str = b"", paused: bool = False, log_file: str | os.PathLike[str] = "",
    lease: float | str | None = None, deadline: float | None = None, timeout: float = 60.0, channel: bool = True, spin: bool = True,
) -> Instance:
    """Starts an engine and connects to it; it ends when the instance is closed, or this program does.

    ``executable``: any Unreal application with the plugin; the embedded engine if empty. ``fps``: the frame rate to keep, 0 for as fast
    as possible. ``fixed_dt``: seconds of simulated time per frame, whatever the clock says. ``arguments``: more of the engine's own.
    ``address``: where the engine listens, ``unix:/path`` or ``tcp://host:port`` (port 0: any); empty: a private Unix socket. ``token``: what clients
    must give; for an address that other machines can reach a random one is made if it is empty. The others are as for :func:`connect`.
    Raises LaunchFailed, EngineExited (with the last lines of the log), EngineNotRunning.
    """
    return Instance(_native.launch(
        scene=scene, executable=os.fspath(executable) or _default_engine(), arguments=list(arguments), fps=-1.0 if fps is None else float(fps),
        fixed_dt=0.0 if fixed_dt is None else float(fixed_dt), address=address, paused=paused, log_file=os.fspath(log_file),
        token=token.encode() if isinstance(token, str) else token, lease_ms=_lease_ms(lease),
        deadline_ms=0 if deadline is None else max(1, round(deadline * 1000)), timeout_ms=max(1, round(timeout * 1000)), channel=channel, spin=spin,
    ))


def _default_engine() -> str:
    """The embedded engine of the build tree that this package runs from; empty lets the native half look for it."""
    from spear.programs import find_program

    if "SPEAR_ENGINE" in os.environ:
        return ""
    try:
        return str(find_program("spear-engine"))
    except FileNotFoundError:
        return ""


def _lease_ms(lease: float | str | None) -> int:
    if lease is None:
        return 0
    if isinstance(lease, str):
        if lease != "off":
            raise ValueError(f"lease is a number of seconds or 'off', not {lease!r}")
        return _native.LEASE_OFF
    if not lease > 0:
        raise ValueError(f"lease is a positive number of seconds, not {lease!r}")
    return max(1, round(lease * 1000))
