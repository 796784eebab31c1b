# SPDX-License-Identifier: MIT
"""Running the header tool, and what comes out. (Not in conftest.py: with several folders of tests in one run, `import conftest` may give another one.)"""

from __future__ import annotations

import difflib
import json
import os
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

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


#: The fixture `dump`.
Dump = Callable[..., Result]
