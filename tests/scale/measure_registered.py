#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Registers a code base as large as the real engine in the embedded engine, and measures it against the engine alone.

Makes the synthetic code base (make_code_base.py --compilable), compiles it as a plugin beside a finished build tree, without optimisation, and
loads it. Compares the live dump of all its modules with the offline one, and measures start, connect, live dump, memory and calls,
the engine alone and with the code base in turns. Compiling takes 10 minutes of one core or more; what is compiled already stays in --work.

examples:
  measure_registered.py --work build/registered                      # 3,000 headers, 15,000 functions, 55,000 properties
  measure_registered.py --work build/registered --compile-only --jobs 2
  measure_registered.py --work build/registered_small --headers 120 --functions 700 --properties 2400 --json figures.json

Exit codes: 0 measured and live = offline, 1 a step failed or the dumps differ, 2 wrong arguments.
"""

from __future__ import annotations

import argparse
import filecmp
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE.parent / "acceptance"))

import helpers  # noqa: E402

Json = Any
#: Rows of the program spear-bench that say what C++ pays: by the channel, and ProcessEvent inside the engine.
CPP_ROWS = {"direct": "C++ in the engine, ProcessEvent by name", "cpp_sync": "C++ synchronous call", "cpp_sync_rpc": "C++ synchronous call by RPC", "cpp_async": "C++ asynchronous call"}


class Failed(Exception):
    """A step did not do what it should."""


# Making -----------------------------------------------------------------------------------------------------------------


def run(what: str, command: list[str | Path], **options: Any) -> None:
    """Runs a program to its end; Failed if it fails."""
    print(f"{what} ...", file=sys.stderr, flush=True)
    if code := subprocess.run([str(part) for part in command], check=False, **options).returncode:
        raise Failed(f"{what}: {' '.join(map(str, command))} ended with exit code {code}")


def make(work: Path, size: list[str]) -> tuple[Path, dict[str, int]]:
    """The code base; files that are the same as before keep their time, so that nothing is compiled in vain."""
    base, fresh = work / "base", work / "fresh"
    shutil.rmtree(fresh, ignore_errors=True)
    run("make the code base", [sys.executable, HERE / "make_code_base.py", "--compilable", *size, "-o", fresh], stdout=subprocess.DEVNULL)
    wanted = {file.relative_to(fresh) for file in fresh.rglob("*") if file.is_file()}
    for old in [file for file in base.rglob("*") if file.is_file() and file.relative_to(base) not in wanted]:
        old.unlink()
    for name in wanted:
        if not (base / name).is_file() or not filecmp.cmp(fresh / name, base / name, shallow=False):
            (base / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.move(fresh / name, base / name)
    shutil.rmtree(fresh)
    made = json.loads((base / ".synthetic-code-base.json").read_text())
    return base, {key: value for key, value in made.items() if isinstance(value, int) and not isinstance(value, bool) and key != "seed"}


def compile_base(work: Path, build: Path, base: Path, jobs: int) -> tuple[Path, float]:
    """The build tree of the code base, and the seconds that took."""
    tree = work / "tree"
    started = time.monotonic()
    run("configure", ["cmake", "-G", "Ninja", "-S", HERE / "registered", "-B", tree, f"-DSPEAR_BASE={base}", f"-DSPEAR_BUILD={build}", "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O0 -g0"],
        stdout=subprocess.DEVNULL)
    run("compile", ["cmake", "--build", tree, f"-j{jobs}"], stdout=sys.stderr)
    return tree, time.monotonic() - started


# Engines ----------------------------------------------------------------------------------------------------------------


class Engine:
    """A running engine: its process, its address, and the seconds from the start of the process to the first connection and to the first answer."""

    def __init__(self, process: subprocess.Popen[bytes], address: str, connected: float, answered: float):
        self.process, self.address, self.connected, self.answered = process, address, connected, answered

    def forget_peak(self) -> None:
        """The peak of memory() counts from here on."""
        Path(f"/proc/{self.process.pid}/clear_refs").write_text("5")

    def memory(self) -> dict[str, float]:
        """Resident memory in MiB, now and at its peak."""
        found = {}
        for line in Path(f"/proc/{self.process.pid}/status").read_text().splitlines():
            if line.startswith(("VmRSS", "VmHWM")):
                found["now" if line.startswith("VmRSS") else "peak"] = int(line.split()[1]) / 1024
        return found


@contextmanager
def engine(build: Path, tree: Path | None) -> Iterator[Engine]:
    """The engine of a build tree with the plugin of `spear bench`, and with the code base if it is given."""
    import spear

    with tempfile.TemporaryDirectory(prefix="spear-registered-") as folder:
        address = f"unix:{folder}/engine.sock"
        plugins = [part for place in [build / "bench_plugins", *([tree / "big_base_plugins"] if tree else [])] for part in ("--plugin-dir", str(place))]
        environment = {**os.environ, "LD_LIBRARY_PATH": str(tree / "lib")} if tree else None
        command = [str(build / "bin" / "spear-engine"), "--scene", "apartment", "--fps", "0", f"-SpearAddress={address}", *plugins]
        log = Path(folder) / "log"
        with log.open("wb") as output:
            started = time.perf_counter()
            process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, cwd=folder, env=environment)
        try:
            while True:
                if process.poll() is not None:
                    raise Failed(f"the engine ended with exit code {process.returncode}:\n{log.read_text(errors='replace')[-4000:]}")
                if Path(folder, "engine.sock").exists():
                    # The server listens before the scene is loaded; it answers when the first frame runs.
                    with spear.connect(address, timeout=60) as instance:
                        connected = time.perf_counter() - started
                        instance.get_worlds()
                        answered = time.perf_counter() - started
                    break
                time.sleep(0.002)
            yield Engine(process, address, connected, answered)
            if tree and "BigCore" not in Path(f"/proc/{process.pid}/maps").read_text():
                raise Failed(f"the engine runs without the code base:\n{log.read_text(errors='replace')[-4000:]}")
        finally:
            process.terminate()
            try:
                process.wait(30)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


# Figures ----------------------------------------------------------------------------------------------------------------


def once(work: Callable[[], Any]) -> float:
    """Microseconds of one call."""
    started = time.perf_counter()
    work()
    return (time.perf_counter() - started) * 1e6


def median(work: Callable[[], Any], times: int) -> float:
    """The median of so many calls, in microseconds."""
    return statistics.median(once(work) for _ in range(times))


def asynchronous(call: Callable[[], Any], times: int = 20000) -> float:
    """Microseconds for each of many futures, the last one waited for."""
    started = time.perf_counter()
    futures = [call() for _ in range(times)]
    futures[-1].get()
    return (time.perf_counter() - started) / times * 1e6


def refused(work: Callable[[], Any]) -> None:
    """Runs what has to fail because it names a class that does not exist."""
    import spear

    try:
        work()
    except spear.UnknownClass:
        return
    raise Failed("a class that does not exist was found")


def calls(instance: Any, schema: Json | None) -> dict[str, float]:
    """Calls of the engine's own functions; with a schema of the code base, those of its functions too."""
    found: dict[str, float] = {}
    with instance.begin_frame():
        game = instance.get_game()
        axes = game.spawn_actor("ACoordinateAxes")
        axes.GetActorScale3D()
        found["Python synchronous call, us"] = median(axes.GetActorScale3D, 2000)
        found["Python asynchronous call, us"] = asynchronous(axes.async_.GetActorScale3D)
        found["Python synchronous property read, us"] = median(axes.CustomTimeDilation.get, 2000)
        unused = ("AInfo", "APawn", "AController", "UMeshComponent", "UTexture2D", "UMaterialInterface", "ALight")
        found["class by a name not used before, us"] = statistics.median(once(lambda name=name: game.get_class(name)) for name in unused)  # type: ignore[misc]
        found["class by a name that does not exist, us"] = median(lambda: refused(lambda: game.get_class("ANobodyHasThis")), 9)
        if schema:
            found |= calls_of_code_base(game, schema)
    with instance.end_frame():
        pass
    return found


def callable_functions(class_: Json) -> list[str]:
    """Its functions that anyone can call without arguments."""
    return [f["name"] for f in class_["functions"] if not f["parameters"] and "Native" in f["flags"] and not {"Net", "Event", "Private", "Protected"} & set(f["flags"])]


def calls_of_code_base(game: Any, schema: Json) -> dict[str, float]:
    """Calls among thousands of functions: one again and again, and the first call of each."""
    from spear.codegen.names import python_name

    firsts: list[float] = []
    spawns: list[float] = []
    actors = []
    for class_ in schema["classes"]:
        names = [python_name(name) for name in callable_functions(class_) if not name.endswith("_")]  # those need the stubs of the code base
        if not class_["name"].startswith("A") or {"Abstract", "Interface", "Deprecated"} & set(class_["flags"]) or not names:
            continue
        started = time.perf_counter()
        actors.append((game.spawn_actor(class_["name"]), names))
        spawns.append((time.perf_counter() - started) * 1e6)
        for name in names:
            firsts.append(once(lambda function=getattr(actors[-1][0], name): function()))  # type: ignore[misc]
    if not firsts:
        raise Failed("the code base has no actor with a function without parameters")
    actor, names = actors[len(actors) // 2]
    found = {
        f"first spawn of each of {len(spawns)} classes of the code base, us": statistics.median(spawns),
        f"first call of each of {len(firsts)} functions of the code base, us": statistics.median(firsts),
        "the slowest of these first calls, us": max(firsts),
        "Python synchronous call of the code base, us": median(getattr(actor, names[0]), 2000),
        "Python asynchronous call of the code base, us": asynchronous(getattr(actor.async_, names[0])),
    }
    for actor, _ in actors:
        game.destroy_actor(actor)
    return found


def cpp_calls(build: Path, address: str) -> dict[str, float]:
    """What the program spear-bench measures: calls from C++."""
    asked = "".join(f"{row}\n" for row in CPP_ROWS)
    answers = subprocess.run([build / "bin" / "spear-bench", address], input=asked, check=True, capture_output=True, text=True).stdout.splitlines()
    return {f"{what}, us": statistics.median(json.loads(answer)["us"]) for what, answer in zip(CPP_ROWS.values(), answers, strict=True)}


def measure(build: Path, tree: Path | None) -> tuple[dict[str, float], Json]:
    """All figures of one engine, and its live dump."""
    import spear

    with engine(build, tree) as running:
        found = {"start of the process to the first connection, s": running.connected, "start of the process to the first answer, s": running.answered, "memory after the start, MiB": running.memory()["now"]}
        connects = []
        for _ in range(20):
            started = time.perf_counter()
            instance = spear.connect(running.address)
            connects.append((time.perf_counter() - started) * 1e3)
            instance.close()
        found |= {"connect, ms": statistics.median(connects), "connect, slowest of 20, ms": max(connects)}
        with spear.connect(running.address) as instance:
            running.forget_peak()
            started = time.perf_counter()
            schema = instance.get_schema()
            found["live dump, s"] = time.perf_counter() - started
            found |= {"memory after the live dump, MiB": running.memory()["now"], "memory, peak of the live dump, MiB": running.memory()["peak"]}
            found |= calls(instance, of_code_base(schema) if tree else None)
        found |= cpp_calls(build, running.address)
    return found, schema


# Live = offline ---------------------------------------------------------------------------------------------------------


def of_code_base(schema: Json) -> Json:
    """The part of a live dump that the code base brought."""
    return {kind: [entity for entity in schema[kind] if entity["module"].startswith("Big")] for kind in ("classes", "structs", "enums", "delegates")}


def compare(tree: Path, live: Json) -> list[str]:
    """Where the live dump of the code base differs from the offline one, tier by tier."""
    found: list[str] = []
    live = {**of_code_base(live), "modules": [m for m in live["modules"] if m["name"].startswith("Big")]}
    files = sorted((tree / "codegen").glob("Big*/Big*.schema.json"))
    if {f.parent.name for f in files} != {m["name"] for m in live["modules"]}:
        return [f"the engine has the modules {sorted(m['name'] for m in live['modules'])}, the offline dumps are of {[f.parent.name for f in files]}"]
    for file in files:
        name = file.parent.name
        offline = json.loads(file.read_text(encoding="utf-8"))
        for tier in (helpers.runtime_tier, helpers.without_source):
            for kind in ("modules", "classes", "structs", "enums", "delegates"):
                left, right = tier(offline[kind]), tier([entity for entity in live[kind] if entity.get("module", entity["name"]) == name])
                different = [f"{tier.__name__}: {line}" for line in helpers.differences(left, right, f"{name}/{kind}")]
                if not different and json.dumps(left, sort_keys=True) != json.dumps(right, sort_keys=True):
                    different = [f"{tier.__name__}: {name}/{kind}: the texts differ"]
                found += different
    return found


def counted(schema: Json) -> dict[str, int]:
    """How much a dump holds."""
    kinds = ("classes", "structs", "enums", "delegates")
    return {"functions": sum(len(c["functions"]) for c in schema["classes"]), "properties": sum(len(e["properties"]) for kind in kinds[:2] for e in schema[kind]), **{kind: len(schema[kind]) for kind in kinds}}


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--headers", type=int, default=3000)
    parser.add_argument("--functions", type=int, default=15000)
    parser.add_argument("--properties", type=int, default=55000)
    parser.add_argument("--build", type=Path, default=Path(os.environ.get("SPEAR_BUILD_DIR", ROOT / "build" / "release")), help="build tree of the engine [build/release]")
    parser.add_argument("--work", type=Path, required=True, metavar="DIR", help="folder for the code base and its build tree, about 2 GB; it is kept")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)), help="compilers at once [one for each core]")
    parser.add_argument("--compile-only", action="store_true", help="make and compile the code base, and stop")
    parser.add_argument("--compiled", action="store_true", help="measure what an earlier run compiled, without looking for changes")
    parser.add_argument("--rounds", type=int, default=3, help="engines of each kind, in turns; figures are medians over them [3]")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write all figures")
    parser.add_argument("--live", type=Path, metavar="FILE", help="write the live dump, for `spear schema`")
    args = parser.parse_args()
    work, build = args.work.absolute(), args.build.absolute()
    sys.path.insert(0, str(build / "python"))
    os.environ["SPEAR_BUILD_DIR"] = str(build)
    try:
        for needed in (build / "bin" / "spear-engine", build / "bin" / "spear-bench", build / "bin" / "spear-header-tool"):
            if not needed.is_file():
                raise Failed(f"{needed} is missing; build first (tools/build), or name the build tree by --build")
        tree, seconds = work / "tree", 0.0
        if not args.compiled:
            base, _ = make(work, ["--headers", str(args.headers), "--functions", str(args.functions), "--properties", str(args.properties)])
            tree, seconds = compile_base(work, build, base, args.jobs)
            print(f"compiled in {seconds:.0f} s", file=sys.stderr)
        if args.compile_only:
            return 0
        load = os.getloadavg()[0]
        rounds: list[tuple[dict[str, float], dict[str, float]]] = []
        for number in range(args.rounds):
            print(f"round {number + 1} of {args.rounds} ...", file=sys.stderr, flush=True)
            rounds.append((measure(build, None)[0], (latest := measure(build, tree))[0]))
        live = latest[1]
        if args.live:
            args.live.write_text(json.dumps(live), encoding="utf-8")
        print("compare the dumps ...", file=sys.stderr, flush=True)
        found = compare(tree, live)
    except Failed as error:
        print(f"measure_registered: {error}", file=sys.stderr)
        return 1
    counts = {"code base": counted(of_code_base(live)), "engine with the code base": counted(live)}
    print("; ".join(f"{what}: {', '.join(f'{n:,} {kind}' for kind, n in numbers.items())}" for what, numbers in counts.items()))
    alone = {key: statistics.median(r[0][key] for r in rounds) for key in rounds[0][0]}
    with_base = {key: statistics.median(r[1][key] for r in rounds) for key in rounds[0][1]}
    print(f"{'':<66}{'alone':>10}{'with the code base':>20}    (medians of {args.rounds}, load before {load:.1f})")
    for key, value in with_base.items():
        print(f"{key:<66}{f'{alone[key]:,.2f}' if key in alone else '':>10}{value:>20,.2f}")
    print(f"live dump against offline dump, runtime and editor tier: {len(found)} differences" + "".join(f"\n  {line}" for line in found[:40]))
    if args.json:
        args.json.write_text(json.dumps({"counts": counts, "load": load, "compile_seconds": seconds, "alone": alone, "with_code_base": with_base, "differences": found, "rounds": rounds}, indent=2) + "\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
