# SPDX-License-Identifier: MIT
"""Engines on TCP: found like any other, with a token where others could reach them, and clear errors where they cannot listen."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import helpers
import spear


@pytest.fixture
def spear_command() -> list[str]:
    return [sys.executable, "-m", "spear"]


@pytest.fixture
def own_runtime_directory(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> dict[str, str]:
    """A list of engines of its own, so that other engines on this machine do not matter. Gives an environment."""
    runtime = tmp_path / "runtime"
    runtime.mkdir(mode=0o700)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(runtime))
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(path for path in sys.path if path))
    return {**os.environ}


def test_connect_finds_engines_on_tcp(own_runtime_directory: dict[str, str], spear_command: list[str]) -> None:
    with pytest.raises(spear.EngineNotRunning, match="No engine of this user runs"):
        spear.connect()
    with spear.launch(scene="", fps=0, address="tcp://127.0.0.1:0", channel=False, spin=False) as first:
        assert first.address.startswith("tcp://127.0.0.1:") and not first.address.endswith(":0") and not first.uses_channel
        with spear.connect() as found:
            assert found.address == first.address and found.uses_channel  # shared memory also beside TCP
        with spear.launch(scene="", fps=0) as second:
            with pytest.raises(spear.AmbiguousName) as caught:
                spear.connect()
            text = str(caught.value)
            assert all(one.address in text and f"process {one.process_id}" in text for one in (first, second))
            rows = json.loads(helpers.run([*spear_command, "engine", "list", "--json"], env=own_runtime_directory).stdout)
            assert {row["address"] for row in rows} == {first.address, second.address}
        environment = {**own_runtime_directory, "_SPEAR_COMPLETE": "bash_complete", "COMP_WORDS": "spear schema live t", "COMP_CWORD": "3"}
        assert helpers.run([*spear_command], env=environment).stdout.splitlines() == [f"plain,{first.address}"]


def test_an_engine_that_cannot_listen_ends_and_says_why(own_runtime_directory: dict[str, str], spear_command: list[str]) -> None:
    with spear.launch(scene="", fps=0, address="tcp://127.0.0.1:0") as first:
        with pytest.raises(spear.EngineExited, match="is in use") as caught:
            spear.launch(scene="", fps=0, address=first.address)
        assert "exit code 1" in str(caught.value)
        result = subprocess.run([*spear_command, "engine", "--scene", "", "--address", first.address], capture_output=True, text=True, check=False, env=own_runtime_directory)
        assert result.returncode == 1 and "is in use" in result.stdout + result.stderr
    with pytest.raises(spear.ConnectionError, match="the port is not a number"):
        spear.launch(scene="", fps=0, address="tcp://127.0.0.1:123456")


def test_a_token_where_others_could_come(own_runtime_directory: dict[str, str]) -> None:
    with spear.launch(scene="", fps=0, address="tcp://0.0.0.0:0") as first:  # with a random token
        port = first.address.rsplit(":", 1)[1]
        assert "Token=" not in Path(f"/proc/{first.process_id}/cmdline").read_text()
        for token in ("", "wrong"):
            with pytest.raises(spear.Unauthorized):
                spear.connect(f"tcp://127.0.0.1:{port}", token=token)
    with spear.launch(scene="", fps=0, address="tcp://0.0.0.0:0", token="open sesame") as second:
        with spear.connect(second.address, token="open sesame") as client:
            assert client.is_running()


def test_completion_scripts(spear_command: list[str], own_runtime_directory: dict[str, str]) -> None:
    for shell, part in (("bash", "complete -o nosort"), ("zsh", "#compdef spear"), ("fish", "complete --no-files --command spear")):
        assert part in helpers.run([*spear_command, "completion", shell], env=own_runtime_directory).stdout
    environment = {**own_runtime_directory, "_SPEAR_COMPLETE": "bash_complete", "COMP_WORDS": "spear engine run --plugin Sp", "COMP_CWORD": "4"}
    assert "plain,SpearServer" in helpers.run([*spear_command], env=environment).stdout.splitlines()
