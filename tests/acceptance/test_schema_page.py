# SPDX-License-Identifier: MIT
"""docs/schema.md says what is so: its programs compile, type-check and run, its commands exist."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

import helpers
import pytest

from spear.cli.schema import schema


@pytest.fixture(scope="module")
def page(source_directory: Path) -> str:
    return (source_directory / "docs" / "schema.md").read_text(encoding="utf-8")


def program(page: str, language: str) -> str:
    found = re.findall(rf"^```{language}\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
    assert len(found) == 1
    return str(found[0])


def test_python_program_runs_and_is_typed(page: str, build_directory: Path, tmp_path: Path) -> None:
    file = tmp_path / "program.py"
    file.write_text(program(page, "python"), encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": str(build_directory / "python"), "MYPYPATH": str(build_directory / "python"), "SPEAR_BUILD_DIR": str(build_directory)}
    assert helpers.run([sys.executable, file], env=environment).stdout == "0.0 True\n"
    helpers.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path / "cache", file], env=environment, cwd=tmp_path)


def test_cpp_program_compiles(page: str, source_directory: Path, tmp_path: Path) -> None:
    lines = program(page, "cpp").splitlines()
    includes = [line for line in lines if line.startswith("#")]
    body = [line for line in lines if not line.startswith("#")]
    file = tmp_path / "program.cpp"
    file.write_text("\n".join([*includes, "int main() {", *body, "    return location.get().X > x ? 1 : 0;", "}", ""]), encoding="utf-8")
    include = [f"-I{source_directory / place}" for place in ("sdk/include", "generated/cpp")]
    helpers.run(["g++", "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", *include, file], timeout=600)


def test_commands_exist(page: str) -> None:
    named = set(re.findall(r"spear schema (\w+)", page))
    assert named >= {"dump", "stubs", "cpp", "docs", "diff", "merge", "stats", "check", "live"}
    assert named <= set(schema.commands)
