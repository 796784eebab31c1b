# SPDX-License-Identifier: MIT
"""Short versions of kill.py and fuzz.py: that the engine goes on, that clients are told, and that nothing is left. How fast is for kill.py alone to say."""

from __future__ import annotations

import contextlib
import os
import random
import signal
import socket
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

import fuzz  # noqa: E402
import kill  # noqa: E402
from engine import PATIENCE, Engine, running_engine, wait_until  # noqa: E402
from victims import STATES, NotReached, State, Victim, fits  # noqa: E402

PAIRS = [(state, kind) for state in STATES.values() for kind in ("cpp", "python-rpc") if fits(state, kind)]


@pytest.fixture(scope="module")
def engine() -> Iterator[Engine]:
    with running_engine() as running:
        yield running


@pytest.fixture(scope="module")
def baseline(engine: Engine) -> kill.Baseline:
    return kill.Baseline(engine)


@pytest.mark.parametrize("state,kind", PAIRS, ids=lambda value: value.name if isinstance(value, State) else value)
def test_a_killed_client_leaves_a_running_engine_and_nothing_else(engine: Engine, baseline: kill.Baseline, state: State, kind: str) -> None:
    kill.kill_client(engine, state, kind, baseline, random.Random(state.name), whole=False)


@pytest.mark.parametrize("name", ["idle", "begin_held", "between", "end_held", "single_step", "waiting_for_other", "receiving"])
def test_a_stopped_client_loses_its_session_and_is_told(engine: Engine, baseline: kill.Baseline, name: str) -> None:
    for lease_ms in (250, 2500, 25_000):
        try:
            kill.stop_client(engine, STATES[name], "cpp", baseline, lease_ms, whole=False)
            return
        except NotReached:  # a machine so busy that the lease ended before the client was stopped
            continue
    pytest.fail("the client never came into its state")


def test_a_client_stopped_for_less_than_its_lease_goes_on(engine: Engine) -> None:
    victim = Victim(STATES["begin_held"], "cpp", engine, lease_ms=600_000)
    try:
        victim.arrive(contextlib.ExitStack(), None)
        os.kill(victim.pid, signal.SIGSTOP)
        os.kill(victim.pid, signal.SIGCONT)
        victim.say("go")
        assert victim.outcome()["error"] == ""
    finally:
        victim.close()


@pytest.mark.parametrize("name,launched", [("begin_held", True), ("single_step", True), ("latent", False), ("waiting_for_other", False), ("connect_hello", False)])
def test_a_client_whose_engine_is_killed_is_told(name: str, launched: bool) -> None:
    kill.kill_engine(STATES[name], "cpp", launched, 60_000)


def test_a_killed_program_takes_its_engine_along_and_the_next_one_cleans_up(tmp_path: Path) -> None:
    folder = tmp_path / "spear"
    victim = Victim(STATES["begin_held"], "cpp", None, launch=True, runtime=tmp_path)
    try:
        victim.arrive(contextlib.ExitStack(), None)
        assert {path.suffix for path in folder.iterdir()} == {".sock", ".json", ".log"}
        victim.kill()
        wait_until(lambda: not Path(f"/proc/{victim.engine_pid}").exists(), "the engine ends with its program")
    finally:
        victim.close()
    next_one = Victim(STATES["idle"], "cpp", None, launch=True, runtime=tmp_path)
    try:
        next_one.arrive(contextlib.ExitStack(), None)
        left = [path.name for path in folder.iterdir() if f"-{victim.engine_pid}." in path.name or f"-{victim.pid}-" in path.name]
        assert all(name.endswith(".log") for name in left), left  # kept for a day: it may say why
        next_one.say("go")
        assert next_one.outcome()["error"] == ""
        next_one.process.wait()
        assert [path for path in folder.iterdir() if path.suffix != ".log"] == []
    finally:
        next_one.close()


def test_garbage_into_the_socket_disturbs_nobody(engine: Engine, baseline: kill.Baseline) -> None:
    with fuzz.working(engine):
        fuzz.fuzz_socket(engine, 150, random.Random(1))
    baseline.expect("broken connections")


def test_corrupted_shared_memory_disturbs_nobody(engine: Engine, baseline: kill.Baseline) -> None:
    with fuzz.working(engine):
        fuzz.fuzz_channel(engine, 9, random.Random(2))
    baseline.expect("hostile clients")


def test_a_connection_that_says_nothing_is_given_up() -> None:
    with running_engine(arguments=["-SpearLease=100"]) as engine, socket.socket(socket.AF_UNIX) as silent:
        silent.connect(engine.address.removeprefix("unix:"))
        silent.sendall(b"\0\0\0\0")
        silent.settimeout(PATIENCE)
        assert silent.recv(1) == b""  # the engine has closed it
