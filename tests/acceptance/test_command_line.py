# SPDX-License-Identifier: MIT
"""The front door for people, as people use it: `spear engine`, `spear demo`, `spear schema`."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import helpers
import pytest


@pytest.fixture(scope="module")
def address(build_directory: Path) -> Iterator[str]:
    with helpers.running_engine(build_directory) as running:
        yield running


@pytest.fixture
def spear_command(build_directory: Path) -> list[str]:
    os.environ["PYTHONPATH"] = str(build_directory / "python")
    return [sys.executable, "-m", "spear"]


def test_tools_spear_is_the_same(source_directory: Path, spear_command: list[str]) -> None:
    front_door = source_directory / "tools" / "spear"
    if not (source_directory / "build" / "release" / ".built").exists():
        pytest.skip("tools/spear works on build/release, which is not built")
    assert helpers.run([front_door, "--help"]).stdout == helpers.run([*spear_command, "--help"]).stdout


@pytest.mark.parametrize("words", ["", "engine", "engine run", "engine list", "demo", "schema", "schema live", "schema check", "schema stats", "trace", "bench", "bench calls", "doctor", "completion"])
def test_help(spear_command: list[str], words: str) -> None:
    assert "Usage: spear " + words in helpers.run([*spear_command, *words.split(), "--help"]).stdout


def test_wrong_command_line(spear_command: list[str]) -> None:
    result = subprocess.run([*spear_command, "scheme"], capture_output=True, text=True, check=False)
    assert result.returncode == 2 and "No such command" in result.stderr


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_engine_ends_cleanly(spear_command: list[str], number: signal.Signals, tmp_path: Path) -> None:
    """Ctrl-C and SIGTERM: exit code 0, the socket is gone, within seconds, also in the middle of a session."""
    import spear

    socket = tmp_path / "engine.sock"
    process = subprocess.Popen([*spear_command, "engine", "--scene", "apartment", "--fps", "60", "--address", f"unix:{socket}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        helpers.wait_for(socket.exists, 60, "the engine's socket")
        with spear.connect(f"unix:{socket}") as instance:
            assert instance.get_engine_info()["process_id"] == process.pid  # the engine took the command's place
            process.send_signal(number)
            assert process.wait(20) == 0
        assert not socket.exists()
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()


def test_engine_takes_the_engines_own_options(spear_command: list[str]) -> None:
    assert "--plugin-dir" in helpers.run([*spear_command, "engine", "--", "--help"]).stdout
    output = helpers.run([*spear_command, "engine", "--fps", "0", "--frames", "3", "--log", "display"])
    assert output.returncode == 0
    result = subprocess.run([*spear_command, "engine", "lst"], capture_output=True, text=True, check=False)
    assert result.returncode == 2 and "No such command 'lst'" in result.stderr


def test_engine_list(spear_command: list[str], build_directory: Path) -> None:
    """Engines without an address of their own are found."""
    command = [str(build_directory / "bin" / "spear-engine"), "--scene", "apartment", "--fps", "60"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        def listed() -> list[dict[str, object]]:
            rows = json.loads(helpers.run([*spear_command, "engine", "list", "--json"]).stdout)
            return [row for row in rows if row["process_id"] == process.pid]

        helpers.wait_for(listed, 30, "the engine in the list")
        helpers.wait_for(lambda: listed()[0].get("scene") == "apartment", 30, "the scene in the list")
        assert str(listed()[0]["address"]).startswith("unix:")
        assert listed()[0]["frame"] > 0 and listed()[0]["uptime"] > 0 and listed()[0]["sessions"] == 0  # type: ignore[operator]
        (line,) = (line for line in helpers.run([*spear_command, "engine", "list"]).stdout.splitlines() if line.startswith(f"{process.pid} "))
        assert " apartment " in line and str(listed()[0]["address"]) in line
    finally:
        process.terminate()
        assert process.wait(20) == 0
    assert not listed()


def test_demo_prints_the_same_from_both_languages(spear_command: list[str]) -> None:
    first = helpers.run([*spear_command, "demo"]).stdout
    assert first.rstrip().endswith("Both printed the same.")
    from_cpp, from_python = first.split("--- C++\n")[1].split("--- Python\n")
    lines = from_cpp.splitlines()
    assert lines == from_python.splitlines()[:-1]
    assert lines[0] == "axes at -10.0 280.0 50.0, scaled by 4.0"
    assert [line.split(":")[0] for line in lines[1:11]] == [f"step {step:3d}" for step in range(10, 101, 10)]
    classes, functions, properties = (int(part.split()[0]) for part in lines[11].split(", "))
    assert classes > 50 and functions > 500 and properties > 300
    assert helpers.run([*spear_command, "demo"]).stdout == first  # the ball's track is the same in every run


def test_ball_falls_as_physics_says(spear_command: list[str]) -> None:
    """The track of the demo is computed and not canned: uniform in X, a parabola in Z (gravity 980 cm/s², steps of 1/60 s)."""
    lines = helpers.run([*spear_command, "demo", "--steps", "60"]).stdout.splitlines()
    track = [[float(word) for word in line.split(":")[1].split()] for line in lines if line.startswith("step")][:6]
    for index, (x, y, z) in enumerate(track):
        time = (index + 1) * 10 / 60
        assert x == pytest.approx(300 * time, abs=0.1) and y == 0
        assert z == pytest.approx(200 + 400 * time - 490 * time * time, abs=10)


def test_schema_live_check_stats(spear_command: list[str], address: str, tmp_path: Path) -> None:
    file = tmp_path / "live.schema.json"
    helpers.run([*spear_command, "schema", "live", address, "--module", "Engine", "-o", file])
    assert "a good schema" in helpers.run([*spear_command, "schema", "check", file]).stdout
    counts = json.loads(helpers.run([*spear_command, "schema", "stats", file, "--json"]).stdout)
    document = json.loads(file.read_text(encoding="utf-8"))
    assert counts["Engine"] == counts["total"] and counts["total"]["classes"] == len(document["classes"])
    assert "Engine" in helpers.run([*spear_command, "schema", "stats", file]).stdout
    piped = json.loads(helpers.run([*spear_command, "schema", "live", address, "-m", "Engine"]).stdout)
    assert piped == document


def test_schema_check_finds_what_is_wrong(spear_command: list[str], address: str, tmp_path: Path) -> None:
    file = tmp_path / "live.schema.json"
    helpers.run([*spear_command, "schema", "live", address, "-m", "SpearServer", "-o", file])
    document = json.loads(file.read_text(encoding="utf-8"))
    del document["classes"][0]["super"]
    file.write_text(json.dumps(document), encoding="utf-8")
    result = subprocess.run([*spear_command, "schema", "check", str(file)], capture_output=True, text=True, check=False)
    assert result.returncode == 1 and "'super' is a required property" in result.stderr
    file.write_text("[]", encoding="utf-8")
    result = subprocess.run([*spear_command, "schema", "check", str(file)], capture_output=True, text=True, check=False)
    assert result.returncode == 1 and "no SPEAR schema" in result.stderr


def test_no_engine_there(spear_command: list[str], tmp_path: Path) -> None:
    result = subprocess.run([*spear_command, "schema", "live", f"unix:{tmp_path}/none.sock"], capture_output=True, text=True, check=False)
    assert result.returncode == 1 and result.stderr.startswith("spear: ") and "Traceback" not in result.stderr
