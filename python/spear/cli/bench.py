# SPDX-License-Identifier: MIT
"""``spear bench``: what things cost on this machine, side by side in one run."""

from __future__ import annotations

import contextlib
import json
import os
import platform
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import TracebackType
from typing import Any

import click

import spear
from spear.cli.bench_frames import frames
from spear.programs import build_directory, find_program

BLOCK = 1000
"""Operations of an asynchronous block."""

# What each row is: (name, what it shows). Those of C++ are measured by the program spear-bench.
CPP_ROWS = {
    "floor": "raw Unix socket ping-pong, two processes",
    "floor_one_core": "the same, both on one core",
    "floor_two_cores": "the same, each on a core",
    "memory_spinning": "bare shared memory ping-pong, spinning",
    "memory_sleeping": "bare shared memory ping-pong, futex",
    "direct": "ProcessEvent by C++ in the engine, found by name",
    "direct_bare": "ProcessEvent by C++ in the engine, kept function",
    "cpp_sync": "C++ synchronous call",
    "cpp_sync_no_spin": "C++ synchronous call, spinning off",
    "cpp_sync_no_spin_one_core": "the same, both on one core",
    "cpp_sync_no_spin_two_cores": "the same, each on a core",
    "cpp_sync_rpc": "C++ synchronous call by RPC",
    "cpp_sync_read": "C++ synchronous property read",
    "cpp_async": "C++ asynchronous calls, futures",
    "cpp_send": "C++ asynchronous calls, fire and forget",
    "cpp_async_rpc": "C++ asynchronous calls by RPC, futures",
}
PYTHON_ROWS = {
    "python_sync": "Python synchronous call",
    "python_sync_no_spin": "Python synchronous call, spinning off",
    "python_sync_read": "Python synchronous property read",
    "python_async": "Python asynchronous calls, futures",
    "python_send": "Python asynchronous calls, fire and forget",
}


@click.group()
def bench() -> None:
    """Measure: medians and 99th percentiles, interleaved in one run, with a floor beside them."""


bench.add_command(frames)


@bench.command()
@click.option("--rounds", default=20, show_default=True, help="How often each row is measured, interleaved.")
@click.option("--row", "only", multiple=True, help="Only rows whose name contains this; may be given several times.")
@click.option("--json", "as_json", is_flag=True, help="For programs.")
def calls(rounds: int, only: tuple[str, ...], as_json: bool) -> None:
    """What a reflected call with a vector as argument and result costs, from C++ and from Python.

    Synchronous rows are single calls within an open block; asynchronous ones are blocks of 1000 calls, with the time of one call. "of floor" compares with a raw
    ping-pong over a Unix socket between two processes in the same run; "of direct" with the same call made by C++ code inside the engine.

    \b
    Examples:
      spear bench calls
      spear bench calls --rounds 5 --row floor --row sync
      spear bench calls --json > calls.json
    """
    wanted = [name for name in (*CPP_ROWS, *PYTHON_ROWS) if name in ("floor", "direct") or not only or any(part in name for part in only)]
    samples: dict[str, list[float]] = {name: [] for name in wanted}
    load_before = os.getloadavg()
    with _engine() as instance, _CppRows(instance.address) as cpp, click.progressbar(
        [name for _ in range(rounds) for name in wanted], label="measuring", show_pos=True, hidden=as_json
    ) as progress:
        for name in progress:
            samples[name] += cpp.measure(name) if name in CPP_ROWS else _measure_python(name, instance.address)
    _report(samples, load_before, as_json)


@contextlib.contextmanager
def _engine() -> Iterator[spear.Instance]:
    """An engine with the plugin that is called, and with nothing else to do."""
    build = build_directory()
    plugins = build / "bench_plugins" if build else Path("bench_plugins")
    if not (plugins / "SpearBench").is_dir():
        raise FileNotFoundError("The plugin SpearBench was not found. `spear bench` runs from a build tree: build SPEAR (tools/build), or set SPEAR_BUILD_DIR.")
    with spear.launch(scene="", fps=0, arguments=["--plugin-dir", str(plugins)]) as instance:
        yield instance


class _CppRows:
    """The program spear-bench, asked for one row at a time."""

    def __init__(self, address: str) -> None:
        self._process = subprocess.Popen([find_program("spear-bench"), address], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def __enter__(self) -> _CppRows:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        assert self._process.stdin
        self._process.stdin.close()
        self._process.wait()

    def measure(self, row: str) -> list[float]:
        assert self._process.stdin and self._process.stdout
        self._process.stdin.write(row + "\n")
        self._process.stdin.flush()
        answer = self._process.stdout.readline()
        if not answer.endswith("]}\n"):
            raise click.ClickException(f"spear-bench gave no result for {row}; see above.")
        result: list[float] = json.loads(answer)["us"]
        return result


def _measure_python(row: str, address: str) -> list[float]:
    with spear.connect(address, spin="no_spin" not in row) as instance:
        with instance.begin_frame():
            target = instance.get_game().new_object("USpearBench")
        with instance.end_frame():
            pass
        by = spear.FVector(1, 0, 0)
        if row in ("python_async", "python_send"):
            caller = target.async_ if row == "python_async" else target.send_
            _run_blocks(instance, lambda: caller.Move(By=by))
            started = time.perf_counter()
            _run_blocks(instance, lambda: caller.Move(By=by))
            return [(time.perf_counter() - started) * 1e6 / (10 * BLOCK)]
        clock = time.perf_counter
        times = []
        with instance.begin_frame():
            for _ in range(250):  # as a program would write it: a lambda would cost more than some of what is measured
                if row == "python_sync_read":
                    started = clock()
                    target.Place.X.get()
                    ended = clock()
                else:
                    started = clock()
                    target.Move(By=by)
                    ended = clock()
                times.append((ended - started) * 1e6)
        with instance.end_frame():
            pass
        return times[50:]


def _run_blocks(instance: spear.Instance, call: Callable[[], Any]) -> None:
    for _ in range(10):
        with instance.begin_frame():
            kept = [call() for _ in range(BLOCK)]
        with instance.end_frame():
            pass
        del kept
    instance.flush()


def _report(samples: dict[str, list[float]], load_before: tuple[float, float, float], as_json: bool) -> None:
    rows: dict[str, dict[str, Any]] = {}
    for name, values in samples.items():
        ordered = sorted(values)
        rows[name] = {
            "what": CPP_ROWS.get(name) or PYTHON_ROWS[name], "samples": len(ordered),
            "median_us": ordered[len(ordered) // 2], "p99_us": ordered[min(len(ordered) - 1, int(len(ordered) * 0.99))],
        }
    for name, row in rows.items():
        # Rows with a placement are compared with the floor in the same placement.
        floor = next((f"floor{end}" for end in ("_one_core", "_two_cores") if name.endswith(end) and f"floor{end}" in rows), "floor")
        row["of_floor"] = row["median_us"] / rows[floor]["median_us"]
        row["of_direct"] = row["median_us"] / rows["direct"]["median_us"]
        row["per_second"] = 1e6 / row["median_us"]
    machine = {
        "machine": platform.machine(), "system": platform.platform(), "cores": os.cpu_count(), "cores_allowed": len(os.sched_getaffinity(0)),
        "load_before": load_before, "load_after": os.getloadavg(), "python": platform.python_version(), "spear": spear.__version__,
    }
    if as_json:
        click.echo(json.dumps({"machine": machine, "rows": rows}, indent=2))
        return
    width = max(len(str(row["what"])) for row in rows.values())
    click.echo(f"{'':<{width}}  median us     p99 us   of floor  of direct       per second")
    for row in rows.values():
        click.echo(
            f"{row['what']:<{width}} {row['median_us']:>10.3f} {row['p99_us']:>10.3f} {row['of_floor']:>10.3f} {row['of_direct']:>10.2f} {row['per_second']:>16,.0f}"
        )
    click.echo(f"{machine['cores']} cores, {machine['cores_allowed']} allowed, load {load_before[0]:.1f}, {machine['system']}, Python {machine['python']}")
