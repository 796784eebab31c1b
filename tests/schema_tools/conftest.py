# SPDX-License-Identifier: MIT
"""Schemas made from a few lines of header, and the command line as a user runs it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from schema_commands import Command, Dump

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "acceptance"))

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


@pytest.fixture
def spear_schema(build_directory: Path, tmp_path: Path) -> Command:
    """spear_schema("diff", old, new, code=1) runs the program."""
    return Command(build_directory, tmp_path)


@pytest.fixture
def engine_schemas(build_directory: Path) -> list[Path]:
    """Full offline dumps of the embedded engine."""
    return [build_directory / "codegen" / m / f"{m}.schema.json" for m in ("CoreUObject", "Engine")]
