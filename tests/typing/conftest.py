# SPDX-License-Identifier: MIT
"""Stubs and projects that the tests of this folder share."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import spear

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


@pytest.fixture(scope="session")
def project(build_directory: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the package as it is built (stubs included) and the programs, configured as we advise users to."""
    folder = tmp_path_factory.mktemp("typed_project")
    shutil.copytree(build_directory / "python" / "spear", folder / "spear", ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    for name in ("sample_program.py", "errors.py", "mypy.ini"):
        shutil.copy(HERE / name, folder / name)
    return folder


@pytest.fixture(scope="session")
def module_schemas(build_directory: Path) -> dict[str, Path]:
    """Full schemas (source tier included) of the modules that the build has dumped."""
    return {path.stem.removesuffix(".schema"): path for path in (build_directory / "codegen").glob("*/*.schema.json")}


@pytest.fixture(scope="session")
def round_trip_stubs(module_schemas: dict[str, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Stubs of CoreUObject, Engine and the test module RoundTrip."""
    folder = tmp_path_factory.mktemp("round_trip") / "unreal"
    emit_stubs([module_schemas[name] for name in ("CoreUObject", "Engine", "RoundTrip")], folder)
    return folder


@pytest.fixture(scope="session")
def round_trip_project(project: Path, round_trip_stubs: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """As `project`, with the stubs of RoundTrip too."""
    folder = tmp_path_factory.mktemp("round_trip_project")
    shutil.copytree(project / "spear", folder / "spear")
    shutil.copytree(round_trip_stubs, folder / "spear" / "unreal", dirs_exist_ok=True)
    for name in ("round_trip.py", "mypy.ini"):
        shutil.copy(HERE / name, folder / name)
    return folder


def emit_stubs(schemas: list[Path], folder: Path) -> str:
    """Runs the emitter as users of the build do; gives what it said."""
    command = [sys.executable, str(ROOT / "codegen" / "emit"), "stubs", *map(str, schemas), "--output-dir", str(folder)]
    finished = subprocess.run(command, capture_output=True, text=True)
    assert finished.returncode == 0, finished.stderr
    return finished.stderr


@pytest.fixture(scope="session")
def round_trip_engine(build_directory: Path) -> Iterator[spear.Instance]:
    """An engine with the test module RoundTrip."""
    with spear.launch(scene="apartment", fixed_dt=0.01, fps=0, arguments=["--plugin-dir", str(build_directory / "test_plugins")]) as running:
        yield running


#: Set to 1 to write the golden files anew instead of comparing.
UPDATE = os.environ.get("SPEAR_UPDATE_GOLDEN") == "1"
