# SPDX-License-Identifier: MIT
"""Proves that calls leave nothing behind: the memory of client and engine over a million calls of every kind.

    PYTHONPATH=build/release/python build/venv/bin/python tests/soak/memory.py [--calls 1000000] [--kind PART ...] [--no-channel]

For every kind of call: some to warm up, then four equal parts, after each of which garbage is collected on both sides and memory is read: what
the allocators have given out (bytes in use of both processes, Python's own blocks of the client) and what the processes hold (RSS). Caches and
buffers grow once; what leaks grows in every part. So the growth that counts is that of the part with the least, and the exit code is 1 if it is
more than a quarter of a byte per call (a leak is 16 bytes at least) for any kind. (tests/python/test_memory.py runs the same with few calls.)
"""

from __future__ import annotations

import argparse
import contextlib
import ctypes
import gc
import os
import sys
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

import spear

BLOCK = 1000
"""Operations of a transaction at most."""
PARTS = 4


@dataclass
class Reading:
    """Bytes, but for ``blocks``: allocations of Python."""

    client: int
    blocks: int
    client_rss: int
    engine: int
    engine_rss: int


@dataclass
class Growth:
    """What one kind of call did to memory."""

    kind: str
    calls: int
    seconds: float
    readings: list[Reading] = field(repr=False)

    @property
    def part(self) -> int:
        """Calls between two readings."""
        return max(1, self.calls // PARTS)

    def total(self, what: str) -> int:
        """From the first reading to the last."""
        return int(getattr(self.readings[-1], what) - getattr(self.readings[0], what))

    def steady(self, what: str) -> float:
        """Per call, in the part that grew least."""
        values = [getattr(reading, what) for reading in self.readings]
        return min(after - before for before, after in zip(values, values[1:])) / self.part

    def leaks(self) -> list[str]:
        """What grew in every part, in words."""
        limit = 0.25 + 2000 / self.part  # bytes per call
        found = [f"{what}: {self.steady(what):.2f} bytes per call" for what in ("client", "engine") if self.steady(what) > limit]
        if self.steady("blocks") > 0.01 + 50 / self.part:
            found.append(f"Python: {self.steady('blocks'):.3f} blocks per call")
        if self.part >= 100_000:
            found += [f"{what}: {self.steady(what):.2f} bytes per call" for what in ("client_rss", "engine_rss") if self.steady(what) > 1]
        return found


class _Mallinfo(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")]


_mallinfo = ctypes.CDLL(None).mallinfo2
_mallinfo.restype = _Mallinfo


def _rss(process: int | str) -> int:
    text = Path(f"/proc/{process}/smaps_rollup").read_text(encoding="ascii")
    return 1024 * int(next(line.split()[1] for line in text.splitlines() if line.startswith("Anonymous:")))


class Soak:
    """An engine with the test module RoundTrip, and every kind of call."""

    def __init__(self, instance: spear.Instance, engine_process: int) -> None:
        self.instance = instance
        self.game = instance.get_game()
        self.engine_process = engine_process
        self.memory = self.game.get_class("URoundTripCalls")
        with self.block():
            self.things = self.game.new_object("URoundTrip")
            self.calls = self.game.new_object("URoundTripCalls")
            self.actor = self.game.spawn_actor("ACameraActor")
            self.things.ActorValue = self.actor
            gone = self.game.spawn_actor("ACameraActor")
            self.game.destroy_actor(gone)
        self.gone = gone
        self.kinds: dict[str, Callable[[int], object]] = {
            name.removeprefix("do_").replace("_", " "): getattr(self, name) for name in dir(type(self)) if name.startswith("do_")
        }

    @contextlib.contextmanager
    def block(self) -> Iterator[None]:
        """A transaction with work in its first half."""
        with self.instance.begin_frame():
            yield
        with self.instance.end_frame():
            pass

    def read(self) -> Reading:
        """Collects garbage on both sides and looks."""
        with self.block():
            self.memory.CollectNow()
            engine = self.memory.AllocatedBytes()
        self.instance.flush()
        gc.collect()
        client = _mallinfo()
        return Reading(client.uordblks + client.hblkhd, sys.getallocatedblocks(), _rss("self"), engine, _rss(self.engine_process))

    def measure(self, kind: str, calls: int) -> Growth:
        """Makes so many calls of a kind, and about a quarter as many before them to warm up."""
        work = self.kinds[kind]
        work(max(calls // PARTS, 3 * BLOCK))
        self.read()
        readings = [self.read()]
        started = time.perf_counter()
        for _ in range(PARTS):
            work(max(1, calls // PARTS))
            readings.append(self.read())
        return Growth(kind, calls, time.perf_counter() - started, readings)

    def in_blocks(self, calls: int, work: Callable[[], object]) -> None:
        """Makes so many calls, in transactions of a thousand."""
        while calls > 0:
            with self.block():
                for _ in range(min(BLOCK, calls)):
                    work()
            calls -= BLOCK

    def lists_in_blocks(self, calls: int, work: Callable[[], Any], use: Callable[[list[Any]], object]) -> None:
        """The same with all results of a transaction kept until ``use`` has had them, after it."""
        while calls > 0:
            with self.block():
                kept = [work() for _ in range(min(BLOCK, calls))]
            use(kept)
            calls -= BLOCK

    # Calls of functions ------------------------------------------------------------------------------------------------------

    def do_synchronous_calls(self, calls: int) -> None:
        value = spear.FVector(1, 2, 3)
        self.in_blocks(calls, lambda: self.things.EchoVector(Value=value))

    def do_calls_of_static_functions(self, calls: int) -> None:
        self.in_blocks(calls, lambda: self.memory.Add(A=1, B=2))

    def do_calls_by_a_path(self, calls: int) -> None:
        self.in_blocks(calls, lambda: self.things.ActorValue.GetActorScale3D())

    def do_asynchronous_calls_with_get(self, calls: int) -> None:
        value = spear.FVector(1, 2, 3)
        self.lists_in_blocks(calls, lambda: self.things.async_.EchoVector(Value=value), lambda kept: [future.get() for future in kept])

    def do_asynchronous_calls_without_get(self, calls: int) -> None:
        self.lists_in_blocks(calls, lambda: self.things.async_.EchoString(Value="a text of some length, so that it is allocated"), len)

    def do_futures_dropped_at_once(self, calls: int) -> None:
        self.in_blocks(calls, lambda: self.things.async_.EchoString(Value="a text of some length, so that it is allocated"))

    def do_fire_and_forget(self, calls: int) -> None:
        value = spear.FVector(1, 2, 3)
        self.in_blocks(calls, lambda: self.things.send_.EchoVector(Value=value))

    def do_calls_for_many_objects(self, calls: int) -> None:
        actors = [self.actor] * 100
        scales = np.ones((100, 3))
        futures: list[Any] = []

        def work() -> None:
            self.game.call_many(actors, "GetActorScale3D")
            self.game.send_.call_many(actors, "SetActorScale3D", NewScale3D=scales)
            futures[:] = self.game.async_.call_many(actors, "GetActorScale3D")

        self.in_blocks(max(1, calls // 300), work)

    # Variables ---------------------------------------------------------------------------------------------------------------

    def do_variables_read(self, calls: int) -> None:
        def work() -> None:
            self.things.Int32Value.get()
            self.things.TransformValue.Translation.X.get()
            self.things.VectorValue.get()

        self.in_blocks(calls // 3, work)

    def do_variables_written(self, calls: int) -> None:
        value = spear.FVector(1, 2, 3)

        def work() -> None:
            self.things.Int32Value = 5
            self.things.async_.VectorValue.set(value)
            self.things.send_.StringValue = "a text of some length, so that it is allocated"

        self.in_blocks(calls // 3, work)

    # Values of every kind ----------------------------------------------------------------------------------------------------

    def do_texts(self, calls: int) -> None:
        self.in_blocks(calls, lambda: self.things.EchoString(Value="a text of some length, so that it is allocated"))

    def do_arrays_of_numbers(self, calls: int) -> None:
        array, numbers = np.arange(100, dtype=np.int32), list(range(100))

        def work() -> None:
            self.things.EchoIntArray(Value=array)
            self.things.EchoIntArray(Value=numbers)

        self.in_blocks(calls // 2, work)

    def do_structs_in_arrays_and_maps(self, calls: int) -> None:
        vectors = [spear.FVector(i, i, i) for i in range(5)]

        def work() -> None:
            self.things.EchoVectorArray(Value=vectors)
            self.things.EchoRecord(Value={"Count": 3})
            self.things.EchoTransform(Value=spear.FTransform())
            self.things.EchoStringMap(Value={"a": 1, "b": 2})

        self.in_blocks(calls // 4, work)

    def do_outputs_and_enums(self, calls: int) -> None:
        def work() -> None:
            self.calls.Split(Text="left|right")
            self.things.EchoEnum(Value="Fast")

        self.in_blocks(calls // 2, work)

    def do_objects_as_results(self, calls: int) -> None:
        def work() -> None:
            self.things.ActorValue.get()
            self.actor.get_class()
            self.things.EchoActor(Value=self.actor)

        self.in_blocks(calls // 3, work)

    def do_nulls(self, calls: int) -> None:
        self.in_blocks(calls, lambda: self.things.ObjectValue.get_or_none())

    # Futures as arguments ----------------------------------------------------------------------------------------------------

    def do_futures_as_arguments(self, calls: int) -> None:
        def work() -> None:
            future = self.things.async_.EchoVector(Value=spear.FVector(1, 2, 3))
            self.things.async_.EchoVector(Value=future)
            self.things.send_.EchoVectorArray(Value=[future, spear.FVector(1, 2, 3)])
            self.things.async_.ActorValue.get().object.send_.SetActorScale3D(NewScale3D=future)

        self.in_blocks(calls // 5, work)

    # Failures ----------------------------------------------------------------------------------------------------------------

    def do_failing_calls(self, calls: int) -> None:
        def work() -> None:
            for call in (self.things.NoSuchFunction, self.things.EchoVector, self.gone.GetActorScale3D, self.things.NoSuchVariable.get):
                try:
                    call()
                except spear.Error:
                    pass
                else:
                    raise AssertionError(f"{call} did not fail")

        self.in_blocks(calls // 4, work)

    def do_calls_that_cannot_be_sent(self, calls: int) -> None:
        value = object()

        def work() -> None:
            with contextlib.suppress(spear.WrongType):
                self.things.EchoVector(Value=value)
                raise AssertionError("an object() was sent")

        self.in_blocks(calls, work)

    def do_failing_futures(self, calls: int) -> None:
        def use(kept: list[Any]) -> None:
            for future in kept[::2]:
                with contextlib.suppress(spear.DependencyFailed):
                    future.get()

        self.lists_in_blocks(calls, lambda: self.things.async_.EchoVector(Value=self.gone.async_.GetActorScale3D()), use)

    def do_failing_fire_and_forget(self, calls: int) -> None:
        while calls > 0:
            try:
                for _ in range(10):
                    self.in_blocks(min(100, calls), self.gone.send_.K2_DestroyActor)
                    calls -= 100
                self.instance.flush()
            except spear.StaleObject:
                pass
            with contextlib.suppress(spear.StaleObject):
                self.instance.flush()

    def do_blocks_left_by_exceptions(self, calls: int) -> None:
        for _ in range(calls // 10):
            try:
                with self.block():
                    for _ in range(10):
                        self.things.async_.EchoString(Value="a text of some length, so that it is allocated")
                    raise KeyError
            except KeyError:
                pass

    # Objects that come and go ------------------------------------------------------------------------------------------------

    def do_actors_spawned_and_destroyed(self, calls: int) -> None:
        def work() -> None:
            self.game.destroy_actor(self.game.spawn_actor("ACameraActor"))
            self.game.send_.destroy_actor(self.game.async_.spawn_actor("ACameraActor"))

        while calls > 0:
            self.in_blocks(min(BLOCK, calls) // 4, work)
            with self.block():
                self.memory.CollectNow()
            calls -= BLOCK

    def do_objects_made_and_released(self, calls: int) -> None:
        def work() -> None:
            self.game.release_object(self.game.new_object("URoundTripCalls"))
            self.game.send_.release_object(self.game.async_.new_object("URoundTripCalls"))

        while calls > 0:
            self.in_blocks(min(BLOCK, calls) // 4, work)
            with self.block():
                self.memory.CollectNow()
            calls -= BLOCK

    # Frames, threads, sessions ------------------------------------------------------------------------------------------------

    def do_empty_transactions(self, calls: int) -> None:
        for _ in range(calls // 20):
            with self.block():
                pass

    def do_facts_without_a_block(self, calls: int) -> None:
        for _ in range(calls // 5):
            self.actor.is_valid()
            self.game.get_class("AActor")
            self.instance.get_worlds()

    def do_threads(self, calls: int) -> None:
        def run() -> None:
            with self.block():
                kept = [self.things.async_.EchoString(Value="a text of some length, so that it is allocated") for _ in range(100)]
                self.things.EchoInt32(Value=5)
            del kept

        for _ in range(max(1, calls // 1000)):
            thread = threading.Thread(target=run)
            thread.start()
            thread.join()

    def do_sessions(self, calls: int) -> None:
        for _ in range(max(1, calls // 5000)):
            with spear.connect(self.instance.address, channel=self.instance.uses_channel) as instance:
                with instance.begin_frame():
                    made = instance.get_game().new_object("URoundTrip")
                    made.EchoVector(Value=spear.FVector(1, 2, 3))
                    made.async_.EchoString(Value="kept until the session ends")
                    made.TransformValue.get()
                with instance.end_frame():
                    pass


def main() -> int:
    """The command."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--calls", type=int, default=1_000_000, help="of each kind (default: %(default)s)")
    parser.add_argument("--kind", action="append", default=[], help="only kinds whose name contains this; may be given several times")
    parser.add_argument("--no-channel", action="store_true", help="by RPC")
    arguments = parser.parse_args()
    build = Path(os.environ.get("SPEAR_BUILD_DIR", Path(__file__).resolve().parents[2] / "build" / "release"))
    if arguments.no_channel:
        os.environ["SPEAR_CHANNEL"] = "off"
    with spear.launch(scene="", fps=0, fixed_dt=0.01, arguments=["--plugin-dir", str(build / "test_plugins")]) as instance:
        soak = Soak(instance, instance.process_id or 0)
        kinds = [kind for kind in soak.kinds if not arguments.kind or any(part in kind for part in arguments.kind)]
        print(f"{'growth in bytes':<34} {'calls':>9} {'client':>10} {'its RSS':>10} {'engine':>10} {'its RSS':>10} {'steady per call':>17} {'seconds':>8}")
        leaks = []
        for kind in kinds:
            growth = soak.measure(kind, arguments.calls)
            steady = f"{growth.steady('client'):.3f} / {growth.steady('engine'):.3f}"
            print(f"{kind:<34} {growth.calls:>9} {growth.total('client'):>10} {growth.total('client_rss'):>10} {growth.total('engine'):>10} "
                  f"{growth.total('engine_rss'):>10} {steady:>17} {growth.seconds:>8.1f}", flush=True)
            leaks += [f"{kind}: {leak}" for leak in growth.leaks()]
    print("\n".join(leaks) if leaks else "Nothing grew steadily.")
    return 1 if leaks else 0


if __name__ == "__main__":
    sys.exit(main())
