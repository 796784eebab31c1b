# SPDX-License-Identifier: MIT
"""Feeds an engine garbage, with a fixed seed, while another client works.

    python tests/robustness/fuzz.py --connections 2000 --hostile 100

Socket: streams that a real client has sent, with bytes changed, cut, doubled and replaced, and plain noise. Channel: clients that corrupt the positions, words and
contents of their shared memory at random (the state "hostile" of client.cpp). Meanwhile another client makes synchronous calls and checks each result. Fails
(exit code 1) if the engine ends or stands still, the other client is disturbed, or anything is left behind.
"""

from __future__ import annotations

import argparse
import contextlib
import random
import select
import socket
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from engine import PATIENCE, Engine, running_engine, wait_until  # noqa: E402
from kill import Baseline  # noqa: E402
from victims import State, Victim  # noqa: E402

import spear  # noqa: E402


def record(engine: Engine, channel: bool) -> bytes:
    """What a client sends in a short session: a transaction and a few facts."""
    path = str(engine.folder / "record.sock")
    sent = bytearray()
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(path)
        listener.listen()

        def pass_on() -> None:
            client, _ = listener.accept()
            with client, socket.socket(socket.AF_UNIX) as server:
                server.connect(engine.address.removeprefix("unix:"))
                while True:
                    for source in select.select([client, server], [], [])[0]:
                        data = source.recv(65536)
                        if not data:
                            return
                        if source is client:
                            sent.extend(data)
                        (server if source is client else client).sendall(data)

        thread = threading.Thread(target=pass_on)
        thread.start()
        with spear.connect("unix:" + path, channel=channel) as instance:
            game = instance.get_game()
            with instance.begin_frame():
                thing = game.new_object("USpearBench")
                thing.Move(By=spear.FVector(1, 2, 3))
            with instance.end_frame():
                thing.async_.Move(By=spear.FVector(1, 2, 3))
            instance.flush()
        thread.join(PATIENCE)
    Path(path).unlink()
    return bytes(sent)


def mutate(stream: bytes, rng: random.Random) -> bytes:
    """The stream with something wrong with it."""
    data = bytearray(stream)
    kind = rng.randrange(6)
    if kind == 0:  # some bytes changed
        for _ in range(rng.randrange(1, 12)):
            data[rng.randrange(len(data))] = rng.randrange(256)
    elif kind == 1:  # cut
        del data[rng.randrange(len(data)):]
    elif kind == 2:  # a part twice, or missing
        at, size = rng.randrange(len(data)), rng.randrange(1, 512)
        data[at:at] = data[at:at + size] if rng.random() < 0.5 else b""
        if rng.random() < 0.5:
            del data[at:at + size]
    elif kind == 3:  # numbers that are extreme: segment counts, sizes, pointers
        for _ in range(rng.randrange(1, 4)):
            at = rng.randrange(len(data) // 8) * 8
            data[at:at + 8] = rng.choice((b"\xff" * 8, b"\0" * 8, b"\xff\xff\xff\x7f" * 2, rng.randbytes(8)))
    elif kind == 4:  # noise behind a good beginning
        at = rng.randrange(len(data))
        data[at:] = rng.randbytes(rng.randrange(1, 4096))
    else:
        data = bytearray(rng.randbytes(rng.randrange(1, 4096)))
    return bytes(data)


def fuzz_socket(engine: Engine, connections: int, rng: random.Random) -> None:
    """So many broken connections, some closed at once, some after what the engine says to it."""
    streams = [record(engine, channel) for channel in (True, False)]
    for number in range(connections):
        with socket.socket(socket.AF_UNIX) as one, contextlib.suppress(ConnectionError):
            one.connect(engine.address.removeprefix("unix:"))
            data = mutate(rng.choice(streams), rng)
            at = 0
            while at < len(data):
                size = rng.choice((len(data), 1 + rng.randrange(200)))
                one.sendall(data[at:at + size])
                at += size
            if number % 3 == 0:
                one.shutdown(socket.SHUT_WR)
                one.settimeout(PATIENCE)
                while one.recv(65536):
                    pass
        assert engine.process.poll() is None, engine.text()[-3000:]


def fuzz_channel(engine: Engine, clients: int, rng: random.Random) -> None:
    """So many clients that corrupt their shared memory, three at a time."""
    state = State("hostile", "corrupts its channel", cpp_only=True, channel_only=True)
    for _ in range(0, clients, 3):
        with contextlib.ExitStack() as stack:
            victims = []
            for _ in range(3):
                victim = Victim(state, "cpp", engine, deadline_ms=300)
                stack.callback(victim.close)
                victims.append(victim)
            for victim in victims:
                with contextlib.ExitStack() as nothing:
                    victim.arrive(nothing, None)
                victim.say(str(rng.getrandbits(63)))
            for victim in victims:
                victim.outcome()  # an error or none: it tells, and does not crash
                assert victim.process.wait() == 0
        assert engine.process.poll() is None, engine.text()[-3000:]


@contextlib.contextmanager
def working(engine: Engine) -> Iterator[list[int]]:
    """Another client works meanwhile; gives [calls made so far]. Raises what disturbed it."""
    done = [0]
    stop = threading.Event()
    errors: list[BaseException] = []

    def work() -> None:
        try:
            with spear.connect(engine.address, deadline=PATIENCE) as instance:
                with instance.begin_frame():
                    target = instance.get_game().new_object("USpearBench")
                with instance.end_frame():
                    pass
                by = spear.FVector(1, 0, 0)
                x = 0
                while not stop.is_set():
                    with instance.begin_frame():
                        for _ in range(5):
                            later = target.async_.Move(By=by)
                            x += 2
                            found = target.Move(By=by)
                            assert later.get().X == x - 1 and found.X == x, (later.get(), found, x)
                    with instance.end_frame():
                        pass
                    done[0] += 1
        except BaseException as error:  # noqa: BLE001 (raised below)
            errors.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    try:
        wait_until(lambda: done[0] > 0 or errors, "the other client works", engine)
        yield done
        before = done[0]
        wait_until(lambda: done[0] > before or errors, "the other client goes on", engine)
    finally:
        stop.set()
        thread.join()
    if errors:
        raise errors[0]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--connections", type=int, default=1000, help="broken streams into the socket [1000]")
    parser.add_argument("--hostile", type=int, default=60, help="clients that corrupt their shared memory [60]")
    parser.add_argument("--seed", type=int, default=1, help="[1]")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    with running_engine(arguments=["-SpearLease=1000"]) as engine:
        baseline = Baseline(engine)
        started = time.monotonic()
        with working(engine) as done:
            fuzz_socket(engine, options.connections, rng)
            print(f"socket: {options.connections} broken streams, {done[0]} transactions of the other client meanwhile")
        with working(engine) as done:
            fuzz_channel(engine, options.hostile, rng)
            print(f"channel: {options.hostile} hostile clients, {done[0]} transactions of the other client meanwhile")
        baseline.expect("the fuzzer")
        print(f"engine and other client went on; nothing left behind; {time.monotonic() - started:.1f} s, seed {options.seed}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
