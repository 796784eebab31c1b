# SPDX-License-Identifier: MIT
"""The clients that are killed, stopped, or lose their engine: which states there are, and getting one into its state."""

from __future__ import annotations

import contextlib
import json
import os
import select
import signal
import socket
import subprocess
import sys
import threading
import time
from dataclasses import dataclass
from pathlib import Path

from engine import BUILD, ENGINE, PATIENCE, PLUGINS, Engine

HERE = Path(__file__).resolve().parent


class NotReached(AssertionError):
    """A client did not come into its state."""


@dataclass(frozen=True)
class State:
    """A state of a transaction (client.cpp and client.py have a function of that name)."""

    name: str
    what: str
    holds: bool = False  # the engine waits for this client
    needs_other: bool = False  # another client holds the engine meanwhile
    proxy: str = ""  # how much of the connection is let through, see Proxy
    flows: bool = False  # something goes on all the time: killed at a random moment of it
    cpp_only: bool = False
    channel_only: bool = False
    ends_well: bool = False  # what is left to do succeeds, whatever happened to the session


STATES = {
    state.name: state
    for state in (
        State("connect_bytes", "connecting: 20 bytes of the hello have arrived", proxy="bytes", cpp_only=True),
        State("connect_hello", "connecting: the welcome has not arrived", proxy="hello", cpp_only=True),
        State("connect_offered", "connecting: shared memory offered, not opened", proxy="offered", cpp_only=True, channel_only=True),
        State("connect_opened", "connecting: shared memory opened, not confirmed", proxy="opened", cpp_only=True, channel_only=True),
        State("idle", "connected, idle"),
        State("begin_open", "begin block open, nothing sent"),
        State("begin_held", "begin block open, engine held by a synchronous call", holds=True),
        State("writing", "a message half written into the ring, not announced", cpp_only=True, channel_only=True),
        State("written_half", "half a message announced in the ring", cpp_only=True, channel_only=True),
        State("written_half_held", "likewise, the game thread reading it", holds=True, cpp_only=True, channel_only=True),
        State("queued", "asynchronous transaction sent and queued", needs_other=True),
        State("between", "begin block run, engine waits for the end block", holds=True),
        State("end_open", "end block open, nothing sent"),
        State("end_held", "end block open, engine held", holds=True),
        State("single_step", "single_step holds the engine", holds=True),
        State("waiting_for_other", "waiting: another client holds the engine", needs_other=True),
        State("latent", "waiting for the future of a latent function"),
        State("running", "the engine runs its operation (60 ms)", flows=True),
        State("receiving", "results of 12 MB on their way", flows=True),
        State("sending", "arguments of 8 MB on their way", flows=True),
        State("flooding", "100 asynchronous calls per frame", flows=True),
        State("stepping", "synchronous transactions, single_step", flows=True),
        State("closing", "closing the session", proxy="closing", ends_well=True),
    )
}

KINDS = ("cpp", "python", "cpp-rpc", "python-rpc", "cpp-nospin")
"""Which client, and how its operations travel."""


def fits(state: State, kind: str) -> bool:
    """Whether a client of that kind can be in that state."""
    return not (state.cpp_only and not kind.startswith("cpp")) and not (state.channel_only and kind.endswith("rpc"))


class Proxy:
    """Between a client and the engine's socket: lets a part of the connection through, then nothing more, so that the client stays where it is.

    Modes: "bytes" 20 bytes to the engine; "hello" everything to the engine, nothing back; "offered" back until the engine has offered shared
    memory, without that offer; "opened" with it, and nothing after; "closing" everything until hold() is called."""

    def __init__(self, engine: Engine, mode: str) -> None:
        self._mode = mode
        self._mark = f"spear-{engine.pid}-".encode()
        self._back = b""
        self._there = 0
        self._offer_passed = False
        self._holds = False
        self.held = threading.Event()  # what was to be held back, is
        path = str(engine.folder / f"proxy-{time.monotonic_ns()}.sock")
        self.address = "unix:" + path
        self._path = path
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(path)
        self._listener.listen()
        self._engine = engine.address.removeprefix("unix:")
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def hold(self) -> None:
        """From now on nothing goes to the client."""
        self._holds = True

    def close(self) -> None:
        self._thread.join(PATIENCE)
        self._listener.close()
        with contextlib.suppress(FileNotFoundError):
            os.unlink(self._path)

    def _run(self) -> None:
        client, _ = self._listener.accept()
        with client, socket.socket(socket.AF_UNIX) as server:
            server.connect(self._engine)
            while True:
                readable, _, _ = select.select([client, server], [], [])
                for source in readable:
                    try:
                        data = source.recv(65536)
                    except ConnectionError:
                        data = b""
                    if not data:
                        return  # both ends are closed, as if there were no proxy
                    passes = self._to_engine(data) if source is client else self._to_client(data)
                    with contextlib.suppress(BrokenPipeError, ConnectionError):
                        (server if source is client else client).sendall(passes)

    def _to_engine(self, data: bytes) -> bytes:
        if self._mode == "bytes":
            data = data[: max(0, 20 - self._there)]
            self.held.set()
        self._there += len(data)
        return data

    def _to_client(self, data: bytes) -> bytes:
        if self._mode == "closing":
            if self._holds:
                self.held.set()
            return b"" if self._holds else data
        if self._mode in ("offered", "opened") and not self._holds:
            offers = self._mark in self._back[-64:] + data
            self._back += data
            if self._offer_passed or (offers and self._mode == "offered"):
                self._holds = True
            elif offers:
                self._offer_passed = True
            if not self._holds:
                return data
        self._holds = True
        self.held.set()
        return b""


class Victim:
    """A client process in a state."""

    def __init__(
        self, state: State, kind: str, engine: Engine | None, *, lease_ms: int = 0, deadline_ms: int = 10_000, launch: bool = False, runtime: Path | None = None,
    ) -> None:
        self.state = state
        self.kind = kind
        self.proxy = Proxy(engine, state.proxy) if state.proxy and engine else None
        environment = {**os.environ, "PYTHONPATH": str(BUILD / "python"), "SPEAR_TEST_DEADLINE": str(deadline_ms), "PYTHONDONTWRITEBYTECODE": "1"}
        if runtime or engine:
            environment["XDG_RUNTIME_DIR"] = str(runtime or engine.runtime)  # type: ignore[union-attr]
        if lease_ms:
            environment["SPEAR_TEST_LEASE"] = str(lease_ms)
        if kind.endswith("-rpc"):
            environment["SPEAR_CHANNEL"] = "off"
        if kind.endswith("-nospin"):
            environment["SPEAR_SPIN"] = "off"
        program = [str(BUILD / "bin" / "robustness-client")] if kind.startswith("cpp") else [sys.executable, str(HERE / "client.py")]
        where = ["--launch", ENGINE, *PLUGINS] if launch else [self.proxy.address if self.proxy else engine.address]  # type: ignore[union-attr]
        name = "idle" if state.name.startswith("connect_") else state.name
        self.process = subprocess.Popen([*program, name, *where], stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment, text=True, bufsize=1)
        self.address = ""
        self.engine_pid = 0

    @property
    def pid(self) -> int:
        return self.process.pid

    def line(self, patience: float = PATIENCE) -> str:
        """Its next line; AssertionError if none comes."""
        assert self.process.stdout
        ready, _, _ = select.select([self.process.stdout], [], [], patience)
        assert ready, f"the client in state {self.state.name} ({self.kind}) says nothing within {patience} s"
        return self.process.stdout.readline()

    def arrive(self, arrange: contextlib.ExitStack, hold: object) -> None:
        """Waits until it is in its state; `hold(address)` gives a context in which another client holds the engine."""
        if self.state.name.startswith("connect_"):
            ends = time.monotonic() + PATIENCE
            while self.proxy and not self.proxy.held.wait(0.05):
                assert self.process.poll() is None, f"{self.state.name} ({self.kind}): ended before it was reached"
                assert time.monotonic() < ends, f"{self.state.name} ({self.kind}): not reached"
            return
        words = self.line().split()
        if words and words[0] == "connected":
            self.address, self.engine_pid = words[1], int(words[2])
            if self.state.needs_other:
                arrange.enter_context(hold(self.address))  # type: ignore[operator]
            if self.proxy:
                self.proxy.hold()
            self.say("go")
            words = self.line().split()
        if not words or words[0] != "ready":
            raise NotReached(f"{self.state.name} ({self.kind}) said {words}")
        self.address, self.engine_pid = words[1], int(words[2])
        if self.state.proxy:
            assert self.proxy and self.proxy.held.wait(PATIENCE)

    def say(self, line: str) -> None:
        """To its standard input; nothing if it has ended."""
        assert self.process.stdin
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.write(line + "\n")
            self.process.stdin.flush()

    def outcome(self, patience: float = PATIENCE) -> dict[str, str]:
        """How it ended: error and message."""
        while True:
            line = self.line(patience)
            assert line, f"{self.state.name} ({self.kind}) ended without an outcome: exit code {self.process.wait()}"
            if line.startswith("{"):
                found: dict[str, str] = json.loads(line)
                return found

    def kill(self) -> int:
        """kill -9. Returns when, in nanoseconds of time.monotonic_ns(), and waits for its end."""
        os.kill(self.pid, signal.SIGKILL)
        when = time.monotonic_ns()
        self.process.wait()
        return when

    def close(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        for stream in (self.process.stdin, self.process.stdout):
            if stream:
                with contextlib.suppress(BrokenPipeError):
                    stream.close()
        if self.proxy:
            self.proxy.close()
