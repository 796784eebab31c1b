# SPDX-License-Identifier: MIT
"""Fixtures of the header tool's tests: where the binary is, and how to run it on headers written in a test."""

from __future__ import annotations

import difflib
import json
import os
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jsonschema
import pytest

ROOT = Path(__file__).resolve().parents[2]
FIXTURES = Path(__file__).resolve().parent / "fixtures"


def compare_with_golden(text: str, golden: Path) -> None:
    """Fails with a difference; SPEAR_UPDATE_GOLDEN=1 in the environment rewrites the file instead."""
    if os.environ.get("SPEAR_UPDATE_GOLDEN"):
        golden.write_text(text)
    expected = golden.read_text() if golden.exists() else ""
    if text != expected:
        difference = "\n".join(list(difflib.unified_diff(expected.splitlines(), text.splitlines(), "golden", "found", lineterm=""))[:80])
        pytest.fail(f"the output differs from {golden.name} (SPEAR_UPDATE_GOLDEN=1 rewrites it):\n{difference}")


def find_tool() -> Path:
    named = os.environ.get("SPEAR_HEADER_TOOL")
    candidates = [Path(named)] if named else sorted(ROOT.glob("build/*/bin/spear-header-tool"), key=lambda p: (p.parts[-3] != "release", p))
    for candidate in candidates:
        if candidate.is_file():
            return candidate
    pytest.fail("spear-header-tool is not built: build the target spear-header-tool, or set SPEAR_HEADER_TOOL to the binary")


@dataclass
class Result:
    code: int
    errors: str  # what was printed
    schema: dict[str, Any] | None
    report: dict[str, Any] | None

    def entity(self, kind: str, name: str) -> dict[str, Any]:
        assert self.schema is not None, self.errors
        found = [e for e in self.schema[kind] if e["name"] == name]
        assert len(found) == 1, f"{len(found)} {kind} named {name}; there are {[e['name'] for e in self.schema[kind]]}"
        return found[0]

    def function(self, class_name: str, name: str) -> dict[str, Any]:
        return next(f for f in self.entity("classes", class_name)["functions"] if f["name"] == name)

    def property(self, kind: str, owner: str, name: str) -> dict[str, Any]:
        return next(p for p in self.entity(kind, owner)["properties"] if p["name"] == name)

    def rules(self) -> list[tuple[str, int]]:
        assert self.report is not None
        return [(e["rule"], e["line"]) for e in self.report["entries"]]


@pytest.fixture(scope="session", autouse=True)
def _own_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Tests neither use nor fill the user's cache."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("xdg-cache")))
        yield


@pytest.fixture(scope="session")
def tool() -> Path:
    return find_tool()


@pytest.fixture(scope="session")
def validator() -> jsonschema.Draft202012Validator:
    schema = json.loads((ROOT / "codegen" / "schema.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def run_tool(tool: Path, folder: Path, arguments: list[str]) -> Result:
    output, report = folder / "out.schema.json", folder / "out.report.json"
    for old in (output, report):
        old.unlink(missing_ok=True)
    run = subprocess.run([str(tool), "dump", *arguments, "-o", str(output), "--report", str(report)], capture_output=True, text=True, errors="replace", timeout=120)
    return Result(
        run.returncode,
        run.stderr + run.stdout,
        json.loads(output.read_text()) if output.exists() else None,
        json.loads(report.read_text()) if report.exists() else None,
    )


Dump = Callable[..., Result]


@pytest.fixture
def dump(tool: Path, tmp_path: Path, validator: jsonschema.Draft202012Validator) -> Dump:
    """dump({"Foo.h": text, ...}, "--strict", ...) writes the headers into a module `Test` and reads them. Output is always validated."""

    def run(headers: dict[str, str], *arguments: str) -> Result:
        module = tmp_path / "Test"
        for name, text in headers.items():
            path = module / "Public" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        result = run_tool(tool, tmp_path, ["--module", f"Test={module}", *arguments])
        if result.schema is not None:
            validator.validate(result.schema)
        return result

    return run


@pytest.fixture
def dump_class(dump: Dump) -> Dump:
    """dump_class(members, ...) reads one class `UTest` with these members; its first member stands on line 8."""

    def run(members: str, *arguments: str, before: str = "") -> Result:
        text = f'#pragma once\n#include "UObject/Object.h"\n#include "Test.generated.h"\n{before}\nUCLASS()\nclass UTest : public UObject {{ GENERATED_BODY()\npublic:\n{members}\n}};\n'
        return dump({"Test.h": text}, *arguments)

    return run
