# SPDX-License-Identifier: MIT
"""Schemas made from a few lines of header, and the command line as a user runs it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "acceptance"))

Dump = Callable[..., Path]


@pytest.fixture
def dump(build_directory: Path, tmp_path: Path) -> Dump:
    """dump("old", "text of a header", module="Game") -> the schema's file."""

    def make(name: str, text: str, module: str = "Game") -> Path:
        folder = tmp_path / f"{name}-source" / module
        (folder / "Public").mkdir(parents=True)
        (folder / "Public" / "Game.h").write_text(f'#pragma once\n#include "CoreMinimal.h"\n#include "Game.generated.h"\n{text}\n')
        output = tmp_path / f"{name}.json"
        engine = [part for m in ("CoreUObject", "Engine") for part in ("--import", str(build_directory / "codegen" / m / f"{m}.schema.json"))]
        command = [str(build_directory / "bin" / "spear-header-tool"), "dump", "--quiet", "--no-cache", "--module", f"{module}={folder}", *engine, "-o", str(output)]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        assert result.returncode == 0, result.stderr
        return output

    return make


class Command:
    """`spear schema ...` in a process of its own."""

    def __init__(self, build_directory: Path, folder: Path):
        self.folder = folder
        self.environment = {name: value for name, value in os.environ.items() if name not in ("VIRTUAL_ENV", "CONDA_PREFIX")}
        self.environment |= {"PYTHONPATH": str(build_directory / "python"), "SPEAR_BUILD_DIR": str(build_directory)}

    def __call__(self, *arguments: str | Path, code: int = 0, stdin: str | None = None, **environment: str) -> subprocess.CompletedProcess[str]:
        """Runs it and asserts the exit code; never a traceback."""
        result = subprocess.run([sys.executable, "-m", "spear", "schema", *map(str, arguments)], capture_output=True, text=True, check=False, cwd=self.folder,
                                env={**self.environment, **environment}, input=stdin)
        assert result.returncode == code, f"exit code {result.returncode}:\n{result.stdout[-2000:]}\n{result.stderr[-2000:]}"
        assert "Traceback" not in result.stderr, result.stderr
        return result


@pytest.fixture
def spear_schema(build_directory: Path, tmp_path: Path) -> Command:
    """spear_schema("diff", old, new, code=1) runs the program."""
    return Command(build_directory, tmp_path)


@pytest.fixture
def engine_schemas(build_directory: Path) -> list[Path]:
    """Full offline dumps of the embedded engine."""
    return [build_directory / "codegen" / m / f"{m}.schema.json" for m in ("CoreUObject", "Engine")]


def load(path: Path) -> Any:
    """A JSON file."""
    return json.loads(path.read_text(encoding="utf-8"))
