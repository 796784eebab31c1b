# SPDX-License-Identifier: MIT
"""Stubs and projects that the tests of this folder share."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

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
def awkward_stubs(module_schemas: dict[str, Path], build_directory: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Stubs of every odd shape that headers were found to have."""
    folder = tmp_path_factory.mktemp("awkward") / "unreal"
    awkward = folder.parent / "Awkward.schema.json"
    headers = ROOT / "tests" / "codegen" / "fixtures" / "Awkward"
    dump = [str(build_directory / "bin" / "spear-header-tool"), "dump", "--quiet", "--no-cache", "--module", str(headers), "--output", str(awkward)]
    subprocess.run(dump, check=True, capture_output=True)
    emit_stubs([module_schemas["CoreUObject"], module_schemas["Engine"], awkward], folder)
    return folder


@pytest.fixture(scope="session")
def awkward_project(project: Path, awkward_stubs: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """As `project`, with those stubs."""
    folder = tmp_path_factory.mktemp("awkward_project")
    shutil.copytree(project / "spear", folder / "spear")
    shutil.copytree(awkward_stubs, folder / "spear" / "unreal", dirs_exist_ok=True)
    shutil.copy(HERE / "mypy.ini", folder / "mypy.ini")
    return folder


@pytest.fixture(scope="session")
def packaged_project(project: Path, module_schemas: dict[str, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """As `project`, with what a packaged application tells of the same engine: no metadata, so no headers, comments, defaults."""
    folder = tmp_path_factory.mktemp("packaged_project")
    schemas = []
    for name in ("CoreUObject", "Engine"):
        schemas.append(folder / f"{name}.json")
        schemas[-1].write_text(json.dumps(runtime_tier(json.loads(module_schemas[name].read_text()))))
    shutil.copytree(project / "spear", folder / "spear", ignore=shutil.ignore_patterns("Engine", "CoreUObject", "SpearServer"))
    emit_stubs(schemas, folder / "spear" / "unreal")
    shutil.copy(HERE / "mypy.ini", folder / "mypy.ini")
    return folder


def runtime_tier(value: Any) -> Any:
    """A schema without its other tiers."""
    if isinstance(value, dict):
        return {key: runtime_tier(part) for key, part in value.items() if key not in ("editor", "source")}
    return [runtime_tier(part) for part in value] if isinstance(value, list) else value


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
    with spear.launch(scene="apartment", fixed_dt=0.01, fps=500, arguments=["--plugin-dir", str(build_directory / "test_plugins")]) as running:
        yield running
