#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the schema tools at the size of the real engine, against the bars set for them.

Makes the synthetic code base, dumps it in full (with an empty cache) and again after one header changed, checks that this second dump is the
full one byte for byte, and writes stubs, C++ proxies and the reference from it. Prints wall time, processor time, the peak of memory (all
processes of a step together) and the number of files; --check fails if a bar is missed.

examples:
  measure.py                                      # 3,000 headers, 15,000 functions, 55,000 properties
  measure.py --json figures.json --check          # as a test: exit code 1 if a bar is missed
  measure.py --headers 300 --functions 1500 --properties 5500 --work /tmp/small --keep

Exit codes: 0 measured, 1 a step failed or, with --check, a bar was missed, 2 wrong arguments.
"""

from __future__ import annotations

import argparse
import filecmp
import json
import os
import platform
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import asdict, dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent

#: The bars, on two cores.
FULL_SECONDS = 90.0
INCREMENTAL_SECONDS = 3.0
EMIT_SECONDS = 60.0
MEMORY_MIB = 2048.0
STUB_KILOBYTES = 500.0


class Failed(Exception):
    """A step did not do what it should."""


@dataclass
class Step:
    """One command, measured."""

    name: str
    seconds: float
    processor_seconds: float
    peak_mib: float
    files: int = 0
    megabytes: float = 0.0


@dataclass
class Bar:
    """A figure and what it may be at most."""

    name: str
    value: float
    limit: float
    unit: str
    #: what the processors worked for it, if it is a time
    processor_value: float = 0.0

    @property
    def held(self) -> bool:
        """Whether the figure is within the bar."""
        return self.value <= self.limit


def _tree(root: int) -> list[int]:
    """A process and all below it."""
    children: dict[int, list[int]] = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                parent = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
            except (OSError, ValueError, IndexError):
                continue
            children.setdefault(parent, []).append(int(entry.name))
    found, queue = [], [root]
    while queue:
        pid = queue.pop()
        found.append(pid)
        queue += children.get(pid, [])
    return found


def _memory(pid: int) -> int:
    """Its share of memory in KiB (pages shared by forked processes count once in total)."""
    try:
        for line in Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines():
            if line.startswith("Pss:"):
                return int(line.split()[1])
    except OSError:
        pass
    return 0


class _Watch(threading.Thread):
    """Samples the memory of a process and its children."""

    def __init__(self, pid: int):
        super().__init__(daemon=True)
        self.pid, self.peak, self.done = pid, 0, threading.Event()

    def run(self) -> None:
        while not self.done.wait(0.1):
            self.peak = max(self.peak, sum(_memory(pid) for pid in _tree(self.pid)))


def run_step(name: str, command: list[str | Path], environment: dict[str, str] | None = None) -> Step:
    """Runs a command to its end and measures it."""
    print(f"{name} ...", file=sys.stderr, flush=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    started = time.monotonic()
    with tempfile.TemporaryFile() as log:
        process = subprocess.Popen([str(part) for part in command], stdout=log, stderr=log, env=environment)
        watch = _Watch(process.pid)
        watch.start()
        code = process.wait()
        seconds = time.monotonic() - started
        watch.done.set()
        watch.join()
        log.seek(0)
        text = log.read().decode(errors="replace")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if code != 0:
        raise Failed(f"{name}: {' '.join(map(str, command))} ended with exit code {code}:\n{text[-4000:]}")
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    # A command shorter than one sample is known by the largest single process alone.
    return Step(name, seconds, processor, max(watch.peak / 1024, 0.0) or after.ru_maxrss / 1024)


def _count(step: Step, folder: Path) -> Step:
    sizes = [f.stat().st_size for f in ([folder] if folder.is_file() else folder.rglob("*")) if f.is_file()]
    step.files, step.megabytes = len(sizes), sum(sizes) / 1e6
    return step


def change_one_header(base: Path) -> Path:
    """Gives a struct in the middle of the code base one more property, as an edit does."""
    for header in sorted(base.rglob("*Types.h"))[10:]:
        text = header.read_text(encoding="utf-8-sig")
        place = text.find("GENERATED_BODY()")
        if place > 0 and "USTRUCT" in text and "\r" not in text:
            end = text.index("\n", place) + 1
            header.write_text(text[:end] + "\n\t/** Added by the measurement. */\n\tUPROPERTY(EditAnywhere)\n\tint32 AddedByMeasurement = 7;\n" + text[end:], encoding="utf-8")
            return header
    raise Failed("the code base has no header to change")


def measure(work: Path, build: Path, headers: int, functions: int, properties: int) -> tuple[dict[str, int], list[Step], list[Bar]]:
    """All steps, in a folder of their own."""
    base, cache = work / "base", work / "cache"
    tool = build / "bin" / "spear-header-tool"
    engine = [build / "codegen" / m / f"{m}.schema.json" for m in ("CoreUObject", "Engine")]
    for needed in (tool, *engine):
        if not needed.is_file():
            raise Failed(f"{needed} is missing; build first (tools/build), or name the build tree by --build")
    shutil.rmtree(cache, ignore_errors=True)
    environment = {**os.environ, "PYTHONPATH": str(build / "python"), "SPEAR_BUILD_DIR": str(build)}
    size = ["--headers", str(headers), "--functions", str(functions), "--properties", str(properties)]
    steps = [_count(run_step("generate the code base", [sys.executable, ROOT / "tests" / "scale" / "make_code_base.py", *size, "-o", base]), base)]
    imports = [part for file in engine for part in ("--import", str(file))]

    def dump(name: str, output: str, *options: str | Path) -> Step:
        return _count(run_step(name, [tool, "dump", "--quiet", "--module", base, *imports, *options, "-o", work / output]), work / output)

    steps.append(dump("dump, full, empty cache", "schema.json", "--cache", cache))
    steps.append(dump("dump, nothing changed", "same.json", "--cache", cache))
    if not filecmp.cmp(work / "schema.json", work / "same.json", shallow=False):
        raise Failed("a dump out of the cache differs from the full one")
    change_one_header(base)
    steps.append(dump("dump, one header changed", "incremental.json", "--cache", cache))
    steps.append(dump("dump, full, no cache", "full.json", "--no-cache"))
    if not filecmp.cmp(work / "incremental.json", work / "full.json", shallow=False):
        raise Failed("the incremental dump differs from a full one of the same headers")
    if "AddedByMeasurement" not in (work / "incremental.json").read_text(encoding="utf-8"):
        raise Failed("the changed header is not in the incremental dump")
    for command in ("stubs", "cpp", "docs"):
        folder = work / command
        shutil.rmtree(folder, ignore_errors=True)
        steps.append(_count(run_step(command, [sys.executable, "-m", "spear", "schema", command, *engine, work / "full.json", "-o", folder], environment), folder))
    by_name = {step.name: step for step in steps}
    counts = json.loads(subprocess.run([sys.executable, "-m", "spear", "schema", "stats", str(work / "full.json"), "--json"], check=True, capture_output=True, text=True, env=environment).stdout)["total"]
    largest = max((f.stat().st_size for f in (work / "stubs").rglob("*.pyi")), default=0)
    bars = [Bar("dump, full", by_name["dump, full, empty cache"].seconds, FULL_SECONDS, "s", by_name["dump, full, empty cache"].processor_seconds), Bar("dump, one header changed", by_name["dump, one header changed"].seconds, INCREMENTAL_SECONDS, "s", by_name["dump, one header changed"].processor_seconds),
            Bar("dump, memory", max(s.peak_mib for s in steps if s.name.startswith("dump")), MEMORY_MIB, "MiB"), Bar("stubs + C++ + docs", sum(by_name[c].seconds for c in ("stubs", "cpp", "docs")), EMIT_SECONDS, "s",
                                                                                                     sum(by_name[c].processor_seconds for c in ("stubs", "cpp", "docs"))),
            Bar("stubs + C++ + docs, memory", max(by_name[c].peak_mib for c in ("stubs", "cpp", "docs")), MEMORY_MIB, "MiB"), Bar("largest .pyi", largest / 1000, STUB_KILOBYTES, "kB")]
    return counts, steps, bars


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--headers", type=int, default=3000)
    parser.add_argument("--functions", type=int, default=15000)
    parser.add_argument("--properties", type=int, default=55000)
    parser.add_argument("--build", type=Path, default=Path(os.environ.get("SPEAR_BUILD_DIR", ROOT / "build" / "release")), help="build tree [build/release]")
    parser.add_argument("--work", type=Path, help="folder to work in [a temporary one]")
    parser.add_argument("--keep", action="store_true", help="leave what was made in --work")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write all figures")
    parser.add_argument("--check", action="store_true", help="fail if a bar is missed")
    args = parser.parse_args()
    if args.keep and not args.work:
        parser.error("--keep needs --work")
    work = args.work or Path(tempfile.mkdtemp(prefix="spear-scale-"))
    work.mkdir(parents=True, exist_ok=True)
    try:
        counts, steps, bars = measure(work, args.build.absolute(), args.headers, args.functions, args.properties)
    except Failed as error:
        print(f"measure: {error}", file=sys.stderr)
        return 1
    finally:
        if not args.keep:
            for name in ("base", "cache", "stubs", "cpp", "docs"):
                shutil.rmtree(work / name, ignore_errors=True)
            for name in ("schema", "same", "incremental", "full"):
                (work / f"{name}.json").unlink(missing_ok=True)
            if not args.work:
                shutil.rmtree(work, ignore_errors=True)
    machine = {"processor": platform.processor() or platform.machine(), "cores": len(os.sched_getaffinity(0)), "load": os.getloadavg()[0]}
    print(f"{counts['functions']:,} functions, {counts['properties']:,} properties, {counts['headers']:,} headers, {counts['classes']:,} classes, {counts['structs']:,} structs, {counts['enums']:,} enums; "
          f"{machine['cores']} cores, load {machine['load']:.1f}")
    print(f"{'step':<28}{'wall s':>9}{'cpu s':>9}{'peak MiB':>10}{'files':>8}{'MB':>9}")
    for step in steps:
        print(f"{step.name:<28}{step.seconds:>9.2f}{step.processor_seconds:>9.2f}{step.peak_mib:>10.0f}{step.files:>8}{step.megabytes:>9.1f}")
    for bar in bars:
        print(f"{'held  ' if bar.held else 'MISSED'} {bar.name}: {bar.value:,.1f} {bar.unit} (at most {bar.limit:,.0f})")
    if args.json:
        args.json.write_text(json.dumps({"machine": machine, "counts": counts, "steps": [asdict(s) for s in steps], "bars": [{**asdict(b), "held": b.held} for b in bars]}, indent=2) + "\n")
    return 1 if args.check and not all(bar.held for bar in bars) else 0


if __name__ == "__main__":
    sys.exit(main())
