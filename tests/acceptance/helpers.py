# SPDX-License-Identifier: MIT
"""Engines that these tests start as a user does, by their program, and the comparison of two schemas."""

from __future__ import annotations

import os
import signal
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

Json = Any


@contextmanager
def running_engine(build_directory: Path, *arguments: str, scene: str = "apartment") -> Iterator[str]:
    """An engine with a socket of its own; gives its address, and ends it by SIGTERM."""
    with tempfile.TemporaryDirectory(prefix="spear-acceptance-") as folder:
        socket = Path(folder) / "engine.sock"
        command = [str(build_directory / "bin" / "spear-engine"), "--scene", scene, "--fps", "200", f"-SpearAddress=unix:{socket}", *arguments]
        log = Path(folder) / "log"
        with log.open("wb") as output:
            process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, cwd=folder)
        try:
            wait_for(lambda: socket.exists() or process.poll() is not None, 300, "the engine's socket")
            assert process.poll() is None, f"the engine ended with exit code {process.returncode}:\n{log.read_text(errors='replace')[-4000:]}"
            yield f"unix:{socket}"
        finally:
            if process.poll() is None:
                process.send_signal(signal.SIGTERM)
            try:
                process.wait(120)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                raise


def wait_for(condition: Any, seconds: float, what: str) -> None:
    """Waits until condition() is true; an AssertionError says what did not come."""
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, f"{what} did not come within {seconds} s"
        time.sleep(0.02)


def run(command: list[str | Path], timeout: float = 120, **options: Any) -> subprocess.CompletedProcess[str]:
    """Runs a program to its end; its output is part of the failure if it fails."""
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=timeout, check=False, **options)
    assert result.returncode == 0, f"{command} failed with exit code {result.returncode}:\n{result.stdout[-3000:]}\n{result.stderr[-3000:]}"
    return result


def bare_environment(**more: str) -> dict[str, str]:
    """The environment without what would lead Python or SPEAR to the build tree."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "SPEAR", "VIRTUAL_ENV"))}
    return {**kept, **more}


def without_source(node: Json) -> Json:
    """The runtime and editor tiers of a schema (codegen/SCHEMA.md section 1)."""
    if isinstance(node, dict):
        return {key: without_source(value) for key, value in node.items() if key not in ("source", "origin")}
    return [without_source(item) for item in node] if isinstance(node, list) else node


def runtime_tier(node: Json) -> Json:
    """What a packaged build knows: neither editor nor source tier."""
    if isinstance(node, dict):
        return {key: runtime_tier(value) for key, value in node.items() if key not in ("source", "origin", "editor")}
    return [runtime_tier(item) for item in node] if isinstance(node, list) else node


def differences(offline: Json, live: Json, where: str = "") -> Iterator[str]:
    """Every place where two schemas differ, in words; members of lists are paired by path or name."""
    if isinstance(offline, dict) and isinstance(live, dict):
        for key in sorted(offline.keys() | live.keys()):
            if key not in live:
                yield f"{where}/{key}: only offline: {str(offline[key])[:200]}"
            elif key not in offline:
                yield f"{where}/{key}: only live: {str(live[key])[:200]}"
            else:
                yield from differences(offline[key], live[key], f"{where}/{key}")
        return
    if isinstance(offline, list) and isinstance(live, list):
        names_offline, names_live = [_label(item) for item in offline], [_label(item) for item in live]
        if names_offline != names_live:
            yield f"{where}: only offline {_minus(names_offline, names_live)}, only live {_minus(names_live, names_offline)}, or another order"
        by_name = dict(zip(names_live, live))
        for name, item in zip(names_offline, offline):
            if name in by_name:
                yield from differences(item, by_name[name], f"{where}[{name}]")
        return
    if type(offline) is not type(live) or offline != live:
        yield f"{where}: offline {offline!r}, live {live!r}"


def _label(item: Json) -> str:
    return str(item.get("path") or item.get("name")) if isinstance(item, dict) else str(item)


def _minus(left: list[str], right: list[str]) -> list[str]:
    there = set(right)
    return [name for name in left if name not in there][:20]
