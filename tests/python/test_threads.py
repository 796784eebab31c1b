# SPDX-License-Identifier: MIT
"""Threads and Python's lock: a call that waits lets other threads of Python go on, and one that is answered at once does not keep them out."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

import spear


class Worker(threading.Thread):
    """Runs a function, and hands its error to whoever joins."""

    def __init__(self, function: Callable[[], None]) -> None:
        super().__init__(daemon=True)
        self._function = function
        self.error: BaseException | None = None
        self.start()

    def run(self) -> None:
        try:
            self._function()
        except BaseException as error:
            self.error = error

    def finish(self) -> None:
        self.join()
        if self.error is not None:
            raise self.error


@pytest.fixture(params=[True, False], ids=["channel", "rpc"])
def second(request: pytest.FixtureRequest, round_trip: spear.Instance):
    with spear.connect(round_trip.address, channel=request.param) as instance:
        yield instance


def test_a_sleeping_call_does_not_keep_other_threads_out(round_trip: spear.Instance, second: spear.Instance) -> None:
    # This thread holds the engine, the other one waits for it within a call. Only this thread can end that, so if it did not get Python's
    # lock, neither would ever go on.
    started = threading.Event()

    def wait_for_the_engine() -> None:
        with second.begin_frame():
            started.set()
            assert second.get_game().get_default_object("ACameraActor").GetActorScale3D() == spear.FVector(1, 1, 1)
        with second.end_frame():
            pass

    with round_trip.begin_frame():
        round_trip.get_game().get_default_object("AActor")
        worker = Worker(wait_for_the_engine)
        started.wait()
        assert sum(range(100_000)) == 4_999_950_000  # work that takes the lock again and again
    with round_trip.end_frame():
        pass
    worker.finish()


def test_a_future_waited_for_does_not_keep_other_threads_out(round_trip: spear.Instance, second: spear.Instance) -> None:
    with second.begin_frame():
        future = second.get_game().async_.get_default_object("ACameraActor")
        results: list[object] = []
        # Recorded by this thread and not sent yet: the other one waits until this one has closed the block.
        workers = [Worker(lambda: results.append(future.get())) for _ in range(3)]
        assert sum(range(100_000)) == 4_999_950_000
    with second.end_frame():
        pass
    for worker in workers:
        worker.finish()
    assert len(results) == 3 and len(set(results)) == 1


def test_calls_without_end_do_not_keep_other_threads_out(round_trip: spear.Instance, second: spear.Instance) -> None:
    count = [0]
    stop = threading.Event()

    def count_up() -> None:
        while not stop.is_set():
            count[0] += 1

    worker = Worker(count_up)
    with second.begin_frame():
        target = second.get_game().get_default_object("ACameraActor")
        while count[0] < 1000:  # endless if the other thread never got the lock
            target.GetActorScale3D()
    with second.end_frame():
        pass
    stop.set()
    worker.finish()


def test_threads_with_sessions_of_their_own(round_trip: spear.Instance) -> None:
    # Objects, paths and struct classes are shared by all sessions: each must get its own numbers for them.

    def run(number: int) -> None:
        with spear.connect(round_trip.address) as instance:
            for i in range(20):
                with instance.begin_frame():
                    made = instance.get_game().new_object("URoundTrip")
                    made.VectorValue = spear.FVector(number, i, 0)
                    made.TransformValue.Translation.X = 10.0 * number
                    later = made.async_.EchoVector(Value=made.async_.VectorValue.get())
                    assert made.VectorValue.get() == spear.FVector(number, i, 0) and made.TransformValue.Translation.X.get() == 10.0 * number
                with instance.end_frame():
                    instance.get_game().release_object(made)
                assert later.get() == spear.FVector(number, i, 0)

    workers = [Worker(lambda number=number: run(number)) for number in range(4)]  # type: ignore[misc]
    for worker in workers:
        worker.finish()
