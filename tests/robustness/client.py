# SPDX-License-Identifier: MIT
"""client.py STATE ADDRESS | STATE --launch ENGINE [ARGUMENT...]: the Python twin of client.cpp, which see: goes into one state of a transaction,
says so, and is killed there, stopped, or loses its engine."""

from __future__ import annotations

import json
import os
import sys
import threading
import time
from collections.abc import Callable

import spear

LEASE = os.environ.get("SPEAR_TEST_LEASE")
DEADLINE = float(os.environ.get("SPEAR_TEST_DEADLINE", "10000")) / 1000


def say(line: str) -> None:
    os.write(1, (line + "\n").encode())


class Run:
    """What a state has to work with."""

    def __init__(self, instance: spear.Instance) -> None:
        self.instance = instance
        self.game = instance.get_game()
        with instance.begin_frame():
            self.bench = self.game.new_object("USpearBench")
        with instance.end_frame():
            pass
        self.frames = self.game.get_class("USpearBenchFrames")
        self.system = self.game.get_class("UKismetSystemLibrary")
        self.by = spear.FVector(1, 0, 0)

    def say_where(self, word: str) -> None:
        say(f"{word} {self.instance.address} {self.instance.process_id or 0}")

    def say_ready(self) -> None:
        self.say_where("ready")

    def connected(self) -> None:
        """Before the state: waits until the test has arranged what it needs."""
        self.say_where("connected")
        sys.stdin.readline()

    def ready(self) -> None:
        """The state is reached: waits for a line on standard input."""
        self.say_ready()
        sys.stdin.readline()

    def ready_when_blocked(self) -> None:
        """The next call of this thread blocks: says "ready" when it does."""
        stat = f"/proc/self/task/{threading.get_native_id()}/stat"

        def watch() -> None:
            while True:
                with open(stat) as file:
                    if file.read().rpartition(") ")[2][0] == "S":
                        break
                time.sleep(0.001)
            self.say_ready()

        threading.Thread(target=watch, daemon=True).start()

    def transact(self, begin: Callable[[], object], single_step: bool = False) -> None:
        with self.instance.begin_frame():
            begin()
        with self.instance.end_frame(single_step=single_step):
            pass

    def move(self) -> object:
        return self.bench.Move(By=self.by)


def idle(run: Run) -> None:
    run.ready()
    run.transact(run.move)


def begin_open(run: Run) -> None:
    with run.instance.begin_frame():
        moved = run.bench.async_.Move(By=run.by)
        run.ready()
    with run.instance.end_frame():
        pass
    moved.get()


def begin_held(run: Run) -> None:
    with run.instance.begin_frame():
        run.move()
        run.ready()
        run.move()
    with run.instance.end_frame():
        pass


def between(run: Run) -> None:
    with run.instance.begin_frame():
        run.move()
    run.ready()
    with run.instance.end_frame():
        run.move()


def end_open(run: Run) -> None:
    with run.instance.begin_frame():
        pass
    with run.instance.end_frame():
        moved = run.bench.async_.Move(By=run.by)
        run.ready()
    moved.get()


def end_held(run: Run) -> None:
    with run.instance.begin_frame():
        pass
    with run.instance.end_frame():
        run.move()
        run.ready()
        run.move()


def single_step(run: Run) -> None:
    run.transact(lambda: None, single_step=True)
    run.instance.flush()
    run.ready()
    run.transact(run.move)


def queued(run: Run) -> None:
    run.connected()
    with run.instance.begin_frame():
        moved = run.bench.async_.Move(By=run.by)
    with run.instance.end_frame():
        pass
    run.ready()
    moved.get()


def waiting_for_other(run: Run) -> None:
    run.connected()
    with run.instance.begin_frame():
        run.ready_when_blocked()
        run.move()
    with run.instance.end_frame():
        pass


def latent(run: Run) -> None:
    with run.instance.begin_frame():
        delay = run.system.async_.Delay(Duration=1000.0)
    with run.instance.end_frame():
        pass
    run.instance.flush()
    run.ready_when_blocked()
    delay.get()


def running(run: Run) -> None:
    with run.instance.begin_frame():
        run.move()
        run.ready_when_blocked()
        while True:
            run.frames.Work(Milliseconds=60.0)


def receiving(run: Run) -> None:
    with run.instance.begin_frame():
        calls = run.game.new_object("URoundTripCalls")
        run.say_ready()
        while True:
            calls.Bytes(Count=12 << 20)


def sending(run: Run) -> None:
    text = "x" * (8 << 20)
    run.say_ready()
    while True:
        run.instance.call("engine_service.ping", text)


def flooding(run: Run) -> None:
    said = False
    while True:
        with run.instance.begin_frame():
            kept = [run.bench.async_.Move(By=run.by) for _ in range(100)]
        with run.instance.end_frame():
            pass
        del kept
        if not said:
            run.say_ready()
            said = True


def stepping(run: Run) -> None:
    said = False
    while True:
        run.transact(run.move, single_step=True)
        if not said:
            run.say_ready()
            said = True


def closing(run: Run) -> None:
    with run.instance.begin_frame():
        run.move()
        run.connected()
        run.ready_when_blocked()
        run.instance.close()


STATES: dict[str, Callable[[Run], None]] = {
    state.__name__: state
    for state in (
        idle, begin_open, begin_held, between, end_open, end_held, single_step, queued, waiting_for_other, latent, running, receiving, sending, flooding,
        stepping, closing,
    )
}


def main() -> None:
    state = STATES[sys.argv[1]]
    lease = int(LEASE) / 1000 if LEASE else None
    error = message = ""
    try:
        if sys.argv[2] == "--launch":
            instance = spear.launch(scene="", fps=100, executable=sys.argv[3], arguments=sys.argv[4:], lease=lease, deadline=DEADLINE)
        else:
            instance = spear.connect(sys.argv[2], lease=lease, deadline=DEADLINE)
        state(Run(instance))
    except spear.Error as caught:
        error, message = type(caught).__name__, str(caught)
    say(json.dumps({"error": error, "message": message}))


if __name__ == "__main__":
    main()
