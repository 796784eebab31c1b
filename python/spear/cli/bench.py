# SPDX-License-Identifier: MIT
"""``spear bench``: what things cost on this machine, side by side in one run."""

from __future__ import annotations

import json
import os
import platform
import socket
import threading
import time
from collections.abc import Callable
from typing import Any

import click


@click.group()
def bench() -> None:
    """Measure: medians and 99th percentiles, interleaved in one run, with a floor beside them."""


@bench.command()
@click.option("--address", help="A running engine; one is started if this is not given.")
@click.option("--rounds", default=20, show_default=True, help="How often each row is measured, interleaved.")
@click.option("--json", "as_json", is_flag=True, help="For programs.")
def calls(address: str | None, rounds: int, as_json: bool) -> None:
    """What calls cost from Python. The floor is a one-byte ping-pong between two threads over a Unix socket."""
    import spear

    rows: dict[str, list[float]] = {}

    def measure(name: str, operations: int, work: Callable[[], None]) -> None:
        started = time.perf_counter()
        work()
        rows.setdefault(name, []).append((time.perf_counter() - started) / operations * 1e6)

    with spear.connect(address) if address else spear.launch(scene="apartment", fps=0) as instance:
        game = instance.get_game()
        with instance.begin_frame():
            actor = game.spawn_actor("ACoordinateAxes")
        with instance.end_frame():
            pass
        vector = spear.FVector(1, 2, 3)

        def synchronous() -> None:
            for _ in range(100):
                actor.K2_GetActorLocation()

        def asynchronous() -> None:
            call = actor.async_
            futures = [call.K2_GetActorLocation() for _ in range(1000)]
            futures[-1].get()

        with _Floor() as floor, click.progressbar(range(rounds), label="measuring", show_pos=True, hidden=as_json) as progress:
            for _ in progress:
                measure("floor: socket ping-pong", 100, floor.run)
                measure("server thread: engine_service.ping", 100, lambda: _repeat(100, lambda: instance.call("engine_service.ping", "x")))
                with instance.begin_frame():
                    actor.K2_GetActorLocation()  # holds the frame, so that what follows measures calls and not frames
                    measure("synchronous call, vector result", 100, synchronous)
                    measure("synchronous call, vector argument", 100, lambda: _repeat(100, lambda: actor.SetActorScale3D(NewScale3D=vector)))
                    measure("synchronous property read", 100, lambda: _repeat(100, actor.RootComponent.RelativeLocation.X.get))
                    measure("asynchronous calls, 1000 in a block", 1000, asynchronous)
                with instance.end_frame():
                    pass
    _report(rows, as_json)


def _repeat(count: int, work: Callable[[], Any]) -> None:
    for _ in range(count):
        work()


class _Floor:
    """A ping-pong partner over a Unix socket."""

    def __enter__(self) -> _Floor:
        self._here, there = socket.socketpair()
        threading.Thread(target=self._answer, args=(there,), daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        self._here.close()

    @staticmethod
    def _answer(there: socket.socket) -> None:
        with there:
            while data := there.recv(1):
                there.sendall(data)

    def run(self) -> None:
        for _ in range(100):
            self._here.sendall(b"x")
            self._here.recv(1)


def _report(rows: dict[str, list[float]], as_json: bool) -> None:
    summary = {}
    for name, values in rows.items():
        ordered = sorted(values)
        summary[name] = {"median_us": ordered[len(ordered) // 2], "p99_us": ordered[min(len(ordered) - 1, int(len(ordered) * 0.99))]}
    load = os.getloadavg()
    machine: dict[str, object] = {"machine": platform.machine(), "system": platform.platform(), "cores": os.cpu_count(), "load": load, "python": platform.python_version()}
    if as_json:
        click.echo(json.dumps({"machine": machine, "rows": summary}, indent=2))
        return
    width = max(map(len, summary))
    floor = next(iter(summary.values()))["median_us"]
    click.echo(f"{'':<{width}}  median us     p99 us   of floor")
    for name, row in summary.items():
        click.echo(f"{name:<{width}} {row['median_us']:>10.2f} {row['p99_us']:>10.2f} {row['median_us'] / floor:>10.2f}")
    click.echo(f"{machine['cores']} cores, load {load[0]:.1f}, {machine['system']}, Python {machine['python']}")
