# SPDX-License-Identifier: MIT
"""`spear trace`: a program and its engine in one trace, and a running engine; summary and picture."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

import helpers
import spear
from spear import trace


@pytest.fixture
def command() -> list[str]:
    return [sys.executable, "-m", "spear", "trace"]


@pytest.fixture(autouse=True)
def python_path(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(path for path in sys.path if path))


def test_a_program(command: list[str], source_directory: Path, tmp_path: Path) -> None:
    program = source_directory / "examples" / "steady_state" / "steady_state.py"
    file, picture = tmp_path / "out.json", tmp_path / "out.png"
    output = helpers.run([*command, "-o", file, "--png", picture, "--frames", "3", "--", sys.executable, program, "--actors", "5", "--transactions", "20"]).stdout
    assert "20 transactions of 5 operations" in output and "waiting for clients" in output
    assert "21 transactions" in output or "20 transactions" in output  # the first spawns the actors; the last frame may be cut off
    recorded = trace.read(file)
    assert len(recorded.processes) == 2 and len(recorded.game_threads()) == 1
    assert len([span for span in recorded.spans if span.name == "begin_frame block"]) == 21
    with Image.open(picture) as image:
        assert image.width > 1000 and len(image.getcolors(1 << 20) or ()) > 5
    numbers = [span.arguments["frame"] for span in recorded.spans if trace.is_frame(span)]
    helpers.run([*command, "--read", file, "--png", picture, "--first-frame", str(numbers[1])])
    result = subprocess.run([*command, "--read", str(file), "--png", str(picture), "--first-frame", "1000000000"], capture_output=True, text=True, check=False)
    assert result.returncode == 1 and f"has {numbers[0]} to {numbers[-1]}" in result.stderr


def test_a_running_engine(command: list[str], instance: spear.Instance, tmp_path: Path) -> None:
    file = tmp_path / "out.json"
    output = helpers.run([*command, "--seconds", "0.1", "-o", file, "--address", instance.address]).stdout
    assert "per second" in output and "world tick" in output
    assert len(trace.read(file).game_threads()) == 1


def test_a_program_that_fails(command: list[str], tmp_path: Path) -> None:
    result = subprocess.run([*command, "-o", str(tmp_path / "no.json"), "--", sys.executable, "-c", "raise SystemExit(3)"], capture_output=True, text=True, check=False)
    assert result.returncode == 1 and "connected to no engine" in result.stderr
    result = subprocess.run([*command, "--", "no-such-program-of-spear"], capture_output=True, text=True, check=False)
    assert result.returncode == 1 and "cannot be run" in result.stderr and "Traceback" not in result.stderr
