# SPDX-License-Identifier: MIT
"""``spear doctor``: is everything there, and what is missing."""

from __future__ import annotations

import os
import re
import shutil
import sys

import click


@click.command()
def doctor() -> None:
    """Check this machine: programs, packages, shared memory, a running engine. Exit code 1 if something needed is missing."""
    import spear
    from spear import _native
    from spear.programs import find_program

    failed = False

    def report(name: str, ok: bool, detail: str, needed: bool = True) -> None:
        nonlocal failed
        failed |= needed and not ok
        mark = click.style("ok", fg="green") if ok else click.style("missing" if needed else "note", fg="red" if needed else "yellow")
        click.echo(f"{name:<22} {mark:<8} {detail}")

    report("Python", sys.version_info >= (3, 10), sys.version.split()[0])
    report("spear", True, f"{spear.__version__} in {os.path.dirname(spear.__file__)}")
    for program in ("spear-engine", "spear-header-tool"):
        try:
            report(program, True, str(find_program(program)))
        except FileNotFoundError as error:
            report(program, False, str(error), needed=False)
    try:
        size = shutil.disk_usage("/dev/shm")
        report(
            "shared memory", size.free >= 64 << 20,
            f"/dev/shm has {size.free >> 20} of {size.total >> 20} MB free" + ("" if size.free >= 64 << 20 else "; without it, sessions go by RPC, slower"),
            needed=False,
        )
    except OSError as error:
        report("shared memory", False, f"/dev/shm: {error}; sessions go by RPC, which is slower", needed=False)
    cores = len(os.sched_getaffinity(0))
    report("cores", cores > 1, f"{cores} of {os.cpu_count()} for this program" + ("" if cores > 1 else "; calls never spin on a single one"), needed=False)
    left = _leftovers()
    report("leftovers", not left, f"{len(left)} of engines that were killed: `spear engine clean` removes them" if left else "none", needed=False)
    engines = _native.list_engines()
    report("running engines", bool(engines), ", ".join(address for address, _ in engines) or "none", needed=False)
    sys.exit(1 if failed else 0)


def _leftovers() -> list[str]:
    """Files in the directory for sockets, and shared memory, whose process is gone."""
    folder = os.path.join(os.environ["XDG_RUNTIME_DIR"], "spear") if os.environ.get("XDG_RUNTIME_DIR") else f"/tmp/spear-{os.getuid()}"
    found = []
    for place, pattern in ((folder, r"(?:engine-)?(\d+)(?:-\d+)?\.(?:sock|json|token|log)"), ("/dev/shm", r"spear-(\d+)-[0-9a-f]+")):
        try:
            names = os.listdir(place)
        except OSError:
            continue
        found += [os.path.join(place, name) for name in names if (match := re.fullmatch(pattern, name)) and not os.path.exists(f"/proc/{match.group(1)}")]
    return found
