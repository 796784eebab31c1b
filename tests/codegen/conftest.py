# SPDX-License-Identifier: MIT
"""Fixtures of the header tool's tests: where the binary is, and how to run it on headers written in a test."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path

import jsonschema
import pytest
from header_tool_runs import ROOT, Dump, Result, run_tool


def find_tool() -> Path:
    named = os.environ.get("SPEAR_HEADER_TOOL")
    candidates = [Path(named)] if named else sorted(ROOT.glob("build/*/bin/spear-header-tool"), key=lambda p: (p.parts[-3] != "release", p))
    for candidate in candidates:
        if candidate.is_file():
            return candidate
    pytest.fail("spear-header-tool is not built: build the target spear-header-tool, or set SPEAR_HEADER_TOOL to the binary")


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
