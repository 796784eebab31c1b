# SPDX-License-Identifier: MIT
"""`spear engine clean` and `spear doctor`: what killed engines leave is found and removed, and nothing else."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from engine import BUILD  # noqa: E402


def spear_command(*arguments: str, runtime: Path) -> str:
    environment = {**os.environ, "PYTHONPATH": str(BUILD / "python"), "XDG_RUNTIME_DIR": str(runtime)}
    return subprocess.run([sys.executable, "-m", "spear", *arguments], capture_output=True, text=True, check=True, env=environment).stdout


def listen(path: Path, stays: bool) -> socket.socket:
    made = socket.socket(socket.AF_UNIX)
    made.bind(str(path))
    made.listen()
    if not stays:
        made.close()
    return made


@pytest.fixture
def dead() -> int:
    """The number of a process that has ended."""
    process = subprocess.Popen(["true"])
    process.wait()
    return process.pid


def test_clean_removes_what_the_dead_left_and_nothing_else(tmp_path: Path, dead: int) -> None:
    folder = tmp_path / "spear"
    folder.mkdir(mode=0o700)
    left = [folder / f"engine-{dead}.json", folder / f"engine-{dead}-1.token", folder / f"engine-{dead}-1.log", folder / f"engine-{dead}.json.new"]
    for path in left:
        path.write_text("{}")
    region = Path(f"/dev/shm/spear-{dead}-0123456789abcdef0123456789abcdef")
    region.write_bytes(b"\0")
    left.append(region)
    for name in (f"engine-{dead}-1.sock", f"{dead}.sock"):
        listen(folder / name, stays=False)
        left.append(folder / name)
    kept = [folder / f"engine-{os.getpid()}.json", folder / f"engine-{os.getpid()}-1.log", folder / "engine.log", folder / "mine.txt", folder / f"engine-{dead}-2.sock"]
    for path in kept[:-1]:
        path.write_text("{}")
    with listen(kept[-1], stays=True):  # somebody answers there, whatever its name says
        assert "`spear engine clean` removes them" in spear_command("doctor", runtime=tmp_path)
        # (Any engine that starts meanwhile removes shared memory too.)
        assert {str(path) for path in left if path != region} <= set(json.loads(spear_command("engine", "clean", "--json", runtime=tmp_path)))
        assert not [path for path in left if path.exists()]
        assert [path for path in kept if not path.exists()] == []


def test_clean_with_nothing_to_do(tmp_path: Path) -> None:
    assert [path for path in json.loads(spear_command("engine", "clean", "--json", runtime=tmp_path)) if str(tmp_path) in path] == []
    assert not any((tmp_path / "spear").iterdir())
