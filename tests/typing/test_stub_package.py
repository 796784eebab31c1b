# SPDX-License-Identifier: MIT
"""The package ``spear-stubs`` of a user's own application, in a real virtual environment: both type checkers find it with no configuration,
and take it instead of the stubs of the embedded engine that come with spear."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

PROGRAM = '''
from typing_extensions import assert_type

import spear
from spear import Future
from spear.typing import Path
from spear.unreal.CoreUObject import FVector
from spear.unreal.Door import ADoor
from spear.unreal.Engine import AActor


def use(door: ADoor, actor: AActor) -> None:
    assert_type(door.Open(Angle=45), None)
    assert_type(door.GetActorScale3D(), FVector)
    assert_type(door.bHidden, Path[bool])
    assert_type(door.async_.GetActorScale3D(), Future[FVector])
    assert_type(actor.OnlyInThisApplication(), int)
    assert_type(spear.cast(ADoor, actor), ADoor)
    door.Open(Angel=45)  # error
'''


def with_own_function(schema: Path) -> dict[str, Any]:
    """The engine of an application that has one function more."""
    document: dict[str, Any] = json.loads(schema.read_text())
    actor = next(entity for entity in document["classes"] if entity["name"] == "AActor")
    function = {
        "name": "OnlyInThisApplication", "flags": ["Native", "Public"], "parameters": [], "editor": {"meta": {}},
        "returns": {"type": {"kind": "int32", "cpp": "int32"}, "flags": ["OutParm", "Parm", "ReturnParm"], "editor": {"meta": {}}},
    }
    actor["functions"] = sorted([*actor["functions"], function], key=lambda f: str(f["name"]))
    return document


@pytest.fixture(scope="module")
def environment(build_directory: Path, module_schemas: dict[str, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A virtual environment with spear as a wheel installs it, and the application's own stubs as the command writes them."""
    folder = tmp_path_factory.mktemp("environment")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(folder / "venv")], check=True)
    (site,) = (folder / "venv" / "lib").glob("python*/site-packages")
    shutil.copytree(build_directory / "python" / "spear", site / "spear", ignore=shutil.ignore_patterns("__pycache__"))
    # What spear depends on, from here: this environment has no network.
    import typing_extensions

    shutil.copy(str(typing_extensions.__file__), site / "typing_extensions.py")
    engine = folder / "Engine.schema.json"
    engine.write_text(json.dumps(with_own_function(module_schemas["Engine"])))
    command = [sys.executable, "-m", "spear", "schema", "stubs", str(module_schemas["CoreUObject"]), str(engine), str(module_schemas["Door"]), "-o", str(site)]
    finished = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(build_directory / "python")})
    assert finished.returncode == 0, finished.stderr
    (folder / "program.py").write_text(PROGRAM)
    return folder


def test_it_is_a_partial_stub_package(environment: Path) -> None:
    (site,) = (environment / "venv" / "lib").glob("python*/site-packages")
    assert (site / "spear-stubs" / "py.typed").read_text() == "partial\n"
    assert (site / "spear-stubs" / "unreal" / "Door" / "facts.json").is_file()


def test_mypy_takes_it(environment: Path) -> None:
    python = environment / "venv" / "bin" / "python"
    finished = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--python-executable", str(python), "program.py"], cwd=environment, capture_output=True, text=True)
    errors = [line for line in finished.stdout.splitlines() if ": error:" in line]
    assert len(errors) == 1 and 'program.py:19: error: Unexpected keyword argument "Angel"' in errors[0], finished.stdout + finished.stderr


def test_pyright_takes_it(environment: Path) -> None:
    (environment / "pyrightconfig.json").write_text(json.dumps({"typeCheckingMode": "strict", "include": ["program.py"], "venvPath": ".", "venv": "venv"}))
    finished = subprocess.run([sys.executable, "-m", "pyright", "--outputjson"], cwd=environment, capture_output=True, text=True)
    found = [d for d in json.loads(finished.stdout)["generalDiagnostics"] if d["severity"] == "error"]
    assert {(d["range"]["start"]["line"] + 1, d["message"].split("\n")[0]) for d in found} == {(19, 'No parameter named "Angel"')}, finished.stdout


def test_the_run_time_knows_the_same_names(environment: Path) -> None:
    program = "from spear.unreal.Door import ADoor; from spear.unreal.Engine import AActor; assert issubclass(ADoor, AActor) and ADoor.unreal_name == 'ADoor'"
    (site,) = (environment / "venv" / "lib").glob("python*/site-packages")
    finished = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(site)})
    assert finished.returncode == 0, finished.stderr
