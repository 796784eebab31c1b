# SPDX-License-Identifier: MIT
"""``spear doctor``: is everything there, and what is missing."""

from __future__ import annotations

import os
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
        free = shutil.disk_usage("/dev/shm").free
        report("shared memory", free >= 256 << 20, f"/dev/shm has {free >> 20} MB free", needed=False)
    except OSError as error:
        report("shared memory", False, f"/dev/shm: {error}", needed=False)
    engines = _native.list_engines()
    report("running engines", bool(engines), ", ".join(address for address, _ in engines) or "none", needed=False)
    sys.exit(1 if failed else 0)
