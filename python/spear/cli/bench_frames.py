# SPDX-License-Identifier: MIT
"""``spear bench frames``: transactions and the engine's frames, and what a client costs the engine."""

from __future__ import annotations

import collections
import contextlib
import json
import os
import platform
import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click

import spear
from spear.cli import bench_actors
from spear.cli.frame_log import FrameLog
from spear.programs import build_directory, find_program

CONSECUTIVE_BAR = 0.999
RATE_BAR = 0.99


@click.command()
@click.option("--transactions", default=10_000, show_default=True, help="Asynchronous transactions in a row, from C++ and from Python each.")
@click.option("--calls", default=10, show_default=True, help="Calls in each of them.")
@click.option("--frame-ms", default=1.0, show_default=True, help="Length of the engine's frames for these.")
@click.option("--rounds", default=6, show_default=True, help="How often the frame rate is measured without and with a client, in turn.")
@click.option("--seconds", default=4.0, show_default=True, help="How long, each time.")
@click.option("--work-ms", default=6.0, show_default=True, help="Computation in each frame of the scene whose frame rate is measured.")
@click.option("--part", "only", type=click.Choice(["transactions", "rate", "actors"]), help="Only this part.")
@click.option("--json", "as_json", is_flag=True, help="For programs.")
def frames(
    transactions: int, calls: int, frame_ms: float, rounds: int, seconds: float, work_ms: float, only: str | None, as_json: bool
) -> None:
    """Whether a client keeps up with the engine's frames, and what it costs the engine. Exit code 1 if a bar is missed.

    Transactions: that many asynchronous ones in a row, nothing waited for; counted are those that ran in the frame right after the one before (bar 99.9 %).
    Rate: frames per second of the apartment with computation in each frame at 60 Hz, with a Python client that makes 100 asynchronous calls per frame, divided by
    those without a client, measured in turn (bar 0.99). Actors: 10,000 of them moved to new places in every frame from Python, in several ways. Frame times are
    the engine's own, by its frame log.

    \b
    Examples:
      spear bench frames
      spear bench frames --part transactions --transactions 2000
      spear bench frames --part rate --rounds 3 --seconds 2
      spear bench frames --json > frames.json
    """
    load_before = os.getloadavg()
    results: dict[str, Any] = {}
    parts = {only} if only else {"transactions", "rate", "actors"}
    steps = 2 * ("transactions" in parts) + 2 * rounds * ("rate" in parts) + ("actors" in parts)
    with click.progressbar(length=steps, label="measuring", show_pos=True, hidden=as_json) as progress:
        if "transactions" in parts:
            results["transactions"] = {}
            with _engine("", 1000.0 / frame_ms) as (instance, log):
                for client in ("cpp", "python"):
                    first = log.count()
                    run = _run_cpp if client == "cpp" else run_transactions
                    found, split = run(instance.address, transactions, calls)
                    times = _distribution(log.began(first)[50:-50])
                    results["transactions"][client] = {**consecutive(found), "split": split, "frame_times_ms": times}
                    progress.update(1)
        if "rate" in parts:
            with _engine("apartment", 60.0) as (instance, log):
                results["rate"] = _measure_rates(instance, log, rounds, seconds, work_ms, progress)
        if "actors" in parts:
            with _engine("", 0.0) as (instance, _):
                results["actors"] = bench_actors.measure(instance)
                progress.update(1)
    results["bars"] = _bars(results)
    results["machine"] = {
        "machine": platform.machine(), "system": platform.platform(), "cores": os.cpu_count(), "cores_allowed": len(os.sched_getaffinity(0)),
        "load_before": load_before, "load_after": os.getloadavg(), "python": platform.python_version(), "spear": spear.__version__,
    }
    if as_json:
        click.echo(json.dumps(results, indent=2))
    else:
        _print(results, transactions, calls, frame_ms, work_ms)
    if not all(results["bars"].values()):
        raise SystemExit(1)


@contextlib.contextmanager
def _engine(scene: str, fps: float) -> Iterator[tuple[spear.Instance, FrameLog]]:
    """An engine with the plugin SpearBench, and its frame log."""
    build = build_directory()
    plugins = build / "bench_plugins" if build else Path("bench_plugins")
    if not (plugins / "SpearBench").is_dir():
        raise FileNotFoundError("The plugin SpearBench was not found. `spear bench` runs from a build tree: build SPEAR (tools/build), or set SPEAR_BUILD_DIR.")
    with tempfile.TemporaryDirectory(prefix="spear-bench-") as folder:
        path = Path(folder) / "frames"
        log = FrameLog(path)
        try:
            with spear.launch(scene=scene, fps=fps, arguments=["--plugin-dir", str(plugins), log.argument(path)]) as instance:
                while log.count() < 100:  # starting is over
                    time.sleep(0.01)
                yield instance, log
        finally:
            log.close()


def _run_cpp(address: str, transactions: int, calls: int) -> tuple[list[int], int]:
    program = [str(find_program("spear-bench")), address, "--transactions", str(transactions), "--calls", str(calls)]
    answer = subprocess.run(program, stdout=subprocess.PIPE, text=True, check=True).stdout
    found = json.loads(answer)
    return found["frames"], found["split"]


def run_transactions(address: str, transactions: int, calls: int) -> tuple[list[int], int]:
    """The frames in which the begin_frame blocks of so many asynchronous transactions ran, and how many end_frame blocks ran in another frame than theirs.

    Nothing is waited for but what opening a block waits for. The twin of tools/bench/frames.cpp."""
    found: list[int] = []
    split = 0
    pending: collections.deque[tuple[Any, Any, list[Any]]] = collections.deque()
    with spear.connect(address) as instance:
        game = instance.get_game()
        counter = game.get_class("USpearBenchFrames").async_
        with instance.begin_frame():
            target = game.new_object("USpearBench")
        with instance.end_frame():
            pass
        instance.flush()
        move = target.async_.Move
        by = spear.FVector(1, 0, 0)
        for _ in range(transactions):
            with instance.begin_frame():
                begin = counter.Frame()
                moves = [move(By=by) for _ in range(calls - 2)]
            with instance.end_frame():
                end = counter.Frame()
            pending.append((begin, end, moves))
            if len(pending) > 2:  # answered before the last block could be opened
                begin, end, _ = pending.popleft()
                found.append(begin.get())
                split += end.get() != found[-1]
        instance.flush()
        for begin, end, _ in pending:
            found.append(begin.get())
            split += end.get() != found[-1]
    return found, split


def consecutive(found: list[int]) -> dict[str, Any]:
    """How many of the transactions ran in the frame after the one before, and by how much the others were late."""
    steps = collections.Counter(after - before for before, after in zip(found, found[1:]))
    return {
        "transactions": len(found), "consecutive": steps[1], "share": steps[1] / max(1, len(found) - 1),
        "frames_missed": {str(step - 1): count for step, count in sorted(steps.items()) if step != 1},
    }


def _measure_rates(instance: spear.Instance, log: FrameLog, rounds: int, seconds: float, work_ms: float, progress: Any) -> dict[str, Any]:
    game = instance.get_game()
    with instance.begin_frame():
        load = game.spawn_actor("ASpearBenchLoad")
        load.Milliseconds.set(work_ms)
    with instance.end_frame():
        pass
    instance.flush()
    rates: dict[str, list[float]] = {"without": [], "with": []}
    times: dict[str, list[float]] = {"without": [], "with": []}
    done = 0
    for _ in range(rounds):
        for side in ("without", "with"):
            first = log.count() + 2
            if side == "without":
                time.sleep(seconds)
            else:
                done += _call(instance.address, seconds)
            began = log.began(first)
            rates[side].append((len(began) - 1) * 1e9 / (began[-1] - began[0]))
            times[side] += [(after - before) / 1e6 for before, after in zip(began, began[1:])]
            progress.update(1)
    ratios = sorted(with_client / without for with_client, without in zip(rates["with"], rates["without"]))
    return {
        "fps": {side: sorted(values)[len(values) // 2] for side, values in rates.items()}, "rounds": rates, "ratio": ratios[len(ratios) // 2], "ratios": ratios,
        "calls_per_frame": 100, "transactions": done, "work_ms": work_ms, "frame_times_ms": {side: _quantiles(values) for side, values in times.items()},
    }


def _call(address: str, seconds: float) -> int:
    """100 asynchronous calls per frame, for so long. Returns the number of transactions."""
    with spear.connect(address) as instance:
        with instance.begin_frame():
            target = instance.get_game().new_object("USpearBench")
        with instance.end_frame():
            pass
        move = target.async_.Move
        by = spear.FVector(1, 0, 0)
        ends = time.monotonic() + seconds
        done = 0
        while time.monotonic() < ends:
            with instance.begin_frame():
                kept = [move(By=by) for _ in range(100)]
            with instance.end_frame():
                pass
            done += 1
        del kept
        return done


def _distribution(began: list[int]) -> dict[str, float]:
    return _quantiles([(after - before) / 1e6 for before, after in zip(began, began[1:])])


def _quantiles(values: list[float]) -> dict[str, float]:
    ordered = sorted(values)
    if not ordered:
        return {}
    return {name: ordered[min(len(ordered) - 1, int(len(ordered) * part))] for name, part in (("median", 0.5), ("p90", 0.9), ("p99", 0.99), ("p999", 0.999), ("max", 1.0))}


def _bars(results: dict[str, Any]) -> dict[str, bool]:
    bars = {}
    for client, row in results.get("transactions", {}).items():
        bars[f"{client}: {CONSECUTIVE_BAR:.1%} of transactions on consecutive frames"] = row["share"] >= CONSECUTIVE_BAR and row["split"] == 0
    if "rate" in results:
        bars[f"frame rate with a client at least {RATE_BAR} of that without"] = results["rate"]["ratio"] >= RATE_BAR
    return bars


def _print(results: dict[str, Any], transactions: int, calls: int, frame_ms: float, work_ms: float) -> None:
    def line(times: dict[str, float]) -> str:
        return " ".join(f"{times[name]:>8.2f}" for name in ("median", "p90", "p99", "p999", "max"))

    head = f"{'frame times, ms':>30} {'median':>8} {'p90':>8} {'p99':>8} {'p99.9':>8} {'max':>8}"
    if "transactions" in results:
        click.echo(f"{transactions} asynchronous transactions of {calls} calls, frames of {frame_ms:g} ms")
        for client, row in results["transactions"].items():
            late = ", ".join(f"{count} late by {frames_missed}" for frames_missed, count in row["frames_missed"].items()) or "none late"
            click.echo(f"  {'C++' if client == 'cpp' else 'Python':<8} {row['share']:>9.3%} on consecutive frames ({late}; {row['split']} split)")
        click.echo(head)
        for client, row in results["transactions"].items():
            click.echo(f"{'C++' if client == 'cpp' else 'Python':>30} {line(row['frame_times_ms'])}")
    if "rate" in results:
        rate = results["rate"]
        click.echo(f"apartment with {work_ms:g} ms of computation per frame at 60 Hz, 100 asynchronous calls per frame from Python")
        fps, ratios = rate["fps"], rate["ratios"]
        click.echo(f"  {fps['with']:.3f} frames per second with, {fps['without']:.3f} without: ratio {rate['ratio']:.4f} (from {ratios[0]:.4f} to {ratios[-1]:.4f})")
        click.echo(head)
        for side, times in rate["frame_times_ms"].items():
            click.echo(f"{side + ' client':>30} {line(times)}")
    if "actors" in results:
        click.echo(f"{results['actors'][0]['actors']:,} actors moved per frame from Python")
        for row in results["actors"]:
            times = f"{row['ms_per_frame']:>8.2f} ms per frame, {row['record_ms']:>8.2f} ms to record it"
            click.echo(f"  {row['what']:<44} {times}, {row['actors_per_second']:>12,.0f} actors/s")
    machine = results["machine"]
    for bar, met in results["bars"].items():
        click.echo(f"{'met   ' if met else 'MISSED'} {bar}")
    click.echo(f"{machine['cores']} cores, {machine['cores_allowed']} allowed, load {machine['load_before'][0]:.1f}, {machine['system']}, Python {machine['python']}")
