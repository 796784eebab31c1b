# SPDX-License-Identifier: MIT
"""`spear bench frames` in short, without limits of time: what the guarantees say about the frames that transactions run in."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from engine import BUILD, Engine, running_engine  # noqa: E402

import spear  # noqa: E402
from spear.cli.bench_frames import consecutive, run_transactions  # noqa: E402


@pytest.fixture(scope="module")
def engine() -> Iterator[Engine]:
    with running_engine(fps=1000.0) as running:
        yield running


def check(found: list[int], split: int, transactions: int) -> None:
    assert len(found) == transactions
    assert split == 0  # G1: begin and end block in one frame
    assert all(before < after for before, after in zip(found, found[1:]))  # one transaction of a client per frame, in order
    row = consecutive(found)
    assert row["transactions"] == transactions and row["consecutive"] + sum(row["frames_missed"].values()) == transactions - 1


def test_asynchronous_transactions_from_cpp(engine: Engine) -> None:
    program = [str(BUILD / "bin" / "spear-bench"), engine.address, "--transactions", "300", "--calls", "10"]
    answer = json.loads(subprocess.run(program, stdout=subprocess.PIPE, text=True, check=True).stdout)
    check(answer["frames"], answer["split"], 300)


def test_asynchronous_transactions_from_python(engine: Engine) -> None:
    check(*run_transactions(engine.address, 300, 10), 300)


def test_with_the_engine_waiting_each_transaction_has_the_next_frame(engine: Engine) -> None:
    with spear.connect(engine.address) as instance:
        counter = instance.get_game().get_class("USpearBenchFrames").async_
        futures = []
        for number in range(200):
            with instance.begin_frame():
                begin = counter.Frame()
            with instance.end_frame(single_step=number < 199):
                futures.append((begin, counter.Frame()))
        instance.flush()
        found = [begin.get() for begin, _ in futures]
        assert [end.get() for _, end in futures] == found
        assert found == list(range(found[0], found[0] + 200))


def test_a_client_with_work_in_every_frame_and_the_frame_log_agree(engine: Engine) -> None:
    first = engine.log.count()
    with spear.connect(engine.address) as instance:
        target = instance.get_game()
        with instance.begin_frame():
            bench = target.new_object("USpearBench")
        with instance.end_frame():
            pass
        counter = target.get_class("USpearBenchFrames").async_
        frames = []
        for _ in range(50):
            with instance.begin_frame():
                frames.append(counter.Frame())
                kept = [bench.async_.Move(By=spear.FVector(1, 0, 0)) for _ in range(100)]
            with instance.end_frame():
                pass
        instance.flush()
        assert kept[-1].get().X == 5000
        ran = {future.get() for future in frames}
    logged = {engine.log.entry(number)[0] for number in range(first, engine.log.count())}
    assert len(ran) == 50 and ran - {max(ran)} <= logged  # the last may not have been noted yet
