# SPDX-License-Identifier: MIT
"""mypy (--strict) and pyright (strict) over the stubs of the embedded engine, a program that uses them, and a file of mistakes."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent


def run_mypy(project: Path, *arguments: str) -> list[tuple[str, int, str]]:
    """(file, line, message) of each error."""
    command = [sys.executable, "-m", "mypy", "--config-file", "mypy.ini", "--follow-imports=silent", "--no-error-summary", "--hide-error-context",
               "--cache-dir", str(project / ".mypy_cache"), *arguments]
    finished = subprocess.run(command, cwd=project, capture_output=True, text=True)
    assert finished.returncode in (0, 1), finished.stdout + finished.stderr
    found = [re.match(r"(.+?):(\d+): error: (.*)", line) for line in finished.stdout.splitlines()]
    return [(match[1], int(match[2]), match[3]) for match in found if match]


def run_pyright(project: Path, include: list[str]) -> list[tuple[str, int, str]]:
    """(file, line, message) of each error."""
    configuration = json.loads((HERE / "pyrightconfig.json").read_text())
    configuration["include"] = include
    file = project / f"pyright_{len(list(project.glob('pyright_*.json')))}.json"
    file.write_text(json.dumps(configuration))
    finished = subprocess.run([sys.executable, "-m", "pyright", "--outputjson", "-p", file.name, "--pythonpath", sys.executable],
                              cwd=project, capture_output=True, text=True)
    assert finished.returncode in (0, 1), finished.stdout + finished.stderr
    result = json.loads(finished.stdout)
    assert result["summary"]["filesAnalyzed"] > 0, finished.stdout
    return [(Path(d["file"]).name, d["range"]["start"]["line"] + 1, d["message"]) for d in result["generalDiagnostics"] if d["severity"] == "error"]


def test_stubs_have_no_errors_by_mypy(project: Path) -> None:
    assert run_mypy(project, "-p", "spear.unreal", "-m", "spear.typing") == []


def test_stubs_have_no_errors_by_pyright(project: Path) -> None:
    assert run_pyright(project, ["spear/unreal/**/*.pyi", "spear/typing.pyi"]) == []


def test_sample_program_has_no_errors_by_mypy(project: Path) -> None:
    assert run_mypy(project, "sample_program.py") == []


def test_sample_program_has_no_errors_by_pyright(project: Path) -> None:
    assert run_pyright(project, ["sample_program.py"]) == []


def test_every_kind_of_value_by_mypy(round_trip_project: Path) -> None:
    assert run_mypy(round_trip_project, "-m", "round_trip", "-p", "spear.unreal.RoundTrip") == []


def test_every_kind_of_value_by_pyright(round_trip_project: Path) -> None:
    assert run_pyright(round_trip_project, ["round_trip.py", "spear/unreal/RoundTrip"]) == []


def test_odd_shapes_by_mypy(awkward_project: Path) -> None:
    assert run_mypy(awkward_project, "-p", "spear.unreal.Awkward") == []


def test_odd_shapes_by_pyright(awkward_project: Path) -> None:
    assert run_pyright(awkward_project, ["spear/unreal/Awkward"]) == []


def test_modules_without_headers_are_split_by_size(packaged_project: Path) -> None:
    sizes = {path.name: path.stat().st_size for path in (packaged_project / "spear" / "unreal" / "Engine").glob("*.pyi")}
    assert len(sizes) > 3 and max(sizes.values()) < 500_000, sizes


def test_stubs_without_metadata_by_mypy(packaged_project: Path) -> None:
    assert run_mypy(packaged_project, "-p", "spear.unreal") == []


def test_stubs_without_metadata_by_pyright(packaged_project: Path) -> None:
    assert run_pyright(packaged_project, ["spear/unreal/**/*.pyi"]) == []


def expected_errors() -> list[int]:
    lines = (HERE / "errors.py").read_text().splitlines()
    return [number for number, line in enumerate(lines, 1) if "  # error: " in line]


def compare(found: list[tuple[str, int, str]]) -> None:
    expected = expected_errors()
    lines = (HERE / "errors.py").read_text().splitlines()
    missed = [f"{number}: {lines[number - 1]}" for number in expected if number not in {line for _, line, _ in found}]
    surprising = [f"{line}: {message}" for _, line, message in found if line not in expected]
    assert not missed and not surprising, "not reported:\n" + "\n".join(missed) + "\nreported, but no mistake:\n" + "\n".join(surprising)
    assert len(expected) >= 45


def test_mypy_reports_each_mistake_and_nothing_else(project: Path) -> None:
    compare(run_mypy(project, "errors.py"))


def test_pyright_reports_each_mistake_and_nothing_else(project: Path) -> None:
    compare(run_pyright(project, ["errors.py"]))


def test_no_stub_is_too_large_for_editors(project: Path) -> None:
    sizes = {path.relative_to(project): path.stat().st_size for path in (project / "spear" / "unreal").rglob("*.pyi")}
    assert len(sizes) > 90
    assert {path: size for path, size in sizes.items() if size > 500_000} == {}
    assert (project / "spear/unreal/__init__.pyi").stat().st_size < 2_000


def test_every_stub_says_that_it_is_generated(project: Path) -> None:
    for path in (project / "spear" / "unreal").rglob("*.pyi"):
        assert path.read_text().startswith("# generated, do not edit"), path
