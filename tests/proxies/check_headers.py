#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles generated proxies in ways that a test program cannot.

    check_headers.py alone DIR...    every header below the folders compiles on its own, with -Wall -Wextra -Werror
    check_headers.py refuse DIR      every program below the folder compiles, and not with -DREFUSED: that ends in the error that
                                     the comment `// refused: TEXT` on its second line names
    check_headers.py cost HEADER     what including a header costs, compared with <spear/spear.hpp> alone (median of --rounds)

Each takes --compiler and --include DIR (repeatable). Exit codes: 0 as it should be, 1 not.
"""

from __future__ import annotations

import argparse
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Werror"]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("--include", action="append", default=[], metavar="DIR")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("alone", "refuse", "cost"):
        command = commands.add_parser(name)
        command.add_argument("paths", nargs="+", type=Path)
        command.add_argument("--include", action="append", default=argparse.SUPPRESS, metavar="DIR")
        command.add_argument("--rounds", type=int, default=9)
        command.add_argument("--limit", type=int, default=0, help="at most so many headers, evenly chosen")
    known, includes = parser.parse_args(), re.findall(r"\0--include\0([^\0]+)", "\0" + "\0".join(sys.argv[1:]))
    base = [known.compiler, *FLAGS, *(f"-I{directory}" for directory in includes)]
    return {"alone": alone, "refuse": refuse, "cost": cost}[known.command](base, known)


def run(command: list[str], text: str) -> tuple[bool, str]:
    """Compiles a text; gives whether that went well, and what the compiler said."""
    done = subprocess.run([*command, "-x", "c++", "-"], input=text, capture_output=True, text=True)
    return done.returncode == 0, done.stdout + done.stderr


@contextmanager
def precompiled(base: list[str]) -> Iterator[list[str]]:
    """The command that checks a text, with what every generated header includes first compiled beforehand."""
    with tempfile.TemporaryDirectory(prefix="spear-proxies-") as folder:
        common = Path(folder) / "common.hpp"
        common.write_text("#include <spear/proxy.hpp>\n")
        is_clang = "clang" in subprocess.run([base[0], "--version"], capture_output=True, text=True).stdout
        compiled = Path(f"{common}.{'pch' if is_clang else 'gch'}")
        subprocess.run([*base, "-x", "c++-header", str(common), "-o", str(compiled)], check=True)
        yield [*base, "-fsyntax-only", *(["-include-pch", str(compiled)] if is_clang else ["-include", str(common)])]


def alone(base: list[str], options: argparse.Namespace) -> int:
    headers = sorted({path.resolve() for folder in options.paths for path in folder.rglob("*.hpp")})
    if options.limit and len(headers) > options.limit:
        headers = headers[:: -(-len(headers) // options.limit)]
    if not headers:
        print(f"there is no header below {' '.join(map(str, options.paths))}", file=sys.stderr)
        return 1
    started = time.monotonic()
    with precompiled(base) as command:
        # Once each, then once more: a header that another header includes again does no harm.
        texts = [f'#include "{header}"\n#include "{header}"\n' for header in headers]
        with ThreadPoolExecutor(options.jobs) as pool:
            results = list(pool.map(lambda text: run(command, text), texts))
    failed = [(header, said) for header, (good, said) in zip(headers, results, strict=True) if not good]
    for header, said in failed[:10]:
        print(f"{header} does not compile on its own:\n{said[:3000]}", file=sys.stderr)
    print(f"{len(headers) - len(failed)} of {len(headers)} headers compile on their own with {base[0]}, {time.monotonic() - started:.1f} s on {options.jobs} processes")
    return 1 if failed else 0


def refuse(base: list[str], options: argparse.Namespace) -> int:
    programs = sorted(path for folder in options.paths for path in folder.rglob("*.cpp"))
    problems: list[str] = []

    def check(program: Path, command: list[str]) -> None:
        lines = program.read_text().splitlines()
        expected = re.fullmatch(r"// refused: (.+)", lines[1])
        if not expected:
            problems.append(f"{program}: the second line must say `// refused: TEXT`")
            return
        good, said = run(command, program.read_text())
        if not good:
            problems.append(f"{program} must compile as it stands, but:\n{said[:3000]}")
        good, said = run([*command, "-DREFUSED"], program.read_text())
        if good:
            problems.append(f"{program} must not compile with -DREFUSED, but does")
        elif not re.search(expected[1], said):
            problems.append(f"{program} is refused, but not with {expected[1]!r}:\n{said[:3000]}")

    with precompiled(base) as command, ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(lambda program: check(program, command), programs))
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"{len(programs)} programs with {base[0]}, {len(problems)} problems")
    return 1 if problems or not programs else 0


def cost(base: list[str], options: argparse.Namespace) -> int:
    def seconds(text: str) -> float:
        before = os.times()
        good, said = run([*base, "-fsyntax-only"], text)
        if not good:
            raise SystemExit(said)
        after = os.times()
        return after.children_user + after.children_system - before.children_user - before.children_system

    sdk, header = "#include <spear/spear.hpp>\n", f"#include <{options.paths[0]}>\n"
    rounds = [(seconds(sdk), seconds(sdk + header)) for _ in range(options.rounds)]
    alone_ms, both_ms = (statistics.median(column) * 1000 for column in zip(*rounds))
    print(f"{base[0]}: <spear/spear.hpp> {alone_ms:.0f} ms, with <{options.paths[0]}> {both_ms:.0f} ms: {both_ms - alone_ms:+.0f} ms "
          f"({100 * (both_ms / alone_ms - 1):+.0f} %), CPU time of -fsyntax-only, median of {options.rounds}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
