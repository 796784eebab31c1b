# SPDX-License-Identifier: MIT
"""The module fixtures/Awkward: every odd shape that real headers were found to have, in our own words. Its whole schema and its whole report are golden files;

    SPEAR_UPDATE_GOLDEN=1 build/venv/bin/python -m pytest -q tests/codegen/test_awkward.py

rewrites them: read the difference before it is committed. What follows the two golden tests says in words what matters most in them.
"""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from header_tool_runs import FIXTURES, Result, compare_with_golden, run_tool

AWKWARD = FIXTURES / "Awkward"


@pytest.fixture(scope="module")
def awkward(tool: Path, tmp_path_factory: pytest.TempPathFactory, validator: jsonschema.Draft202012Validator) -> Result:
    result = run_tool(tool, tmp_path_factory.mktemp("awkward"), ["--module", str(AWKWARD)])
    assert result.code == 0, result.errors
    validator.validate(result.schema)
    return result


def portable(document: dict[str, Any]) -> str:
    """JSON text without the path of this checkout."""
    return json.dumps(document, indent=2, ensure_ascii=False, sort_keys=True).replace(str(AWKWARD), "Awkward") + "\n"


def test_schema_is_the_golden_one(awkward: Result) -> None:
    assert awkward.schema is not None
    compare_with_golden(portable(awkward.schema), FIXTURES / "Awkward.schema.json")


def test_report_is_the_golden_one(awkward: Result) -> None:
    assert awkward.report is not None
    compare_with_golden(portable(awkward.report), FIXTURES / "Awkward.report.json")


def test_every_macro_is_declared_or_reported(awkward: Result, tmp_path: Path) -> None:
    """Counted in the text: a line with a reflection macro declares something, or the report names that line."""
    assert awkward.schema is not None and awkward.report is not None
    reported = {(Path(e["file"]).name, e["line"]) for e in awkward.report["entries"] if e["rule"] not in ("assumed-type", "unresolved-super", "macro-blanked")}
    declared: set[tuple[str, int]] = set()
    for kind in ("classes", "structs", "enums", "delegates"):
        for entity in awkward.schema[kind]:
            header = Path(entity["source"]["header"]).name
            for part in [entity, *entity.get("functions", []), *entity.get("properties", [])]:
                declared |= {(header, line) for line in range(part["source"]["line"] - 4, part["source"]["line"] + 1)}
    for header in sorted(AWKWARD.rglob("*.h")):
        text = re.sub(r"^#define.*$", "", header.read_text(), flags=re.M)
        for number, line in enumerate(text.splitlines(), 1):
            code = re.sub(r'//.*|"(\\.|[^"\\])*"', "", line)
            if re.search(r"\b(UCLASS|USTRUCT|UENUM|UINTERFACE|UFUNCTION|UPROPERTY|DECLARE_DYNAMIC_\w+)\s*\(", code):
                near = {(header.name, number + i) for i in range(-1, 4)}
                assert (header.name, number) in declared or near & reported, f"{header.name}:{number}: {line.strip()}"


VALUES = {
    "EAwkwardPlain": [0, 1, 2, 3, 65, 66],
    "EAwkwardSpace": [0, 1, 2],
    "EAwkwardClass": [1, 2, 3, 5, 16, 30, 7, 10, 15, 100, 250],
    "EAwkwardBits": [0, 1, 2**31, 2**32 - 1],
    "EAwkwardSigned": [-(2**63), -1, 2**63 - 1],
    "EAwkwardConditional": [0, 1, 9, 10],
}


@pytest.mark.parametrize("name", VALUES)
def test_values_of_enumerators(awkward: Result, name: str) -> None:
    """As a C++ compiler computes them from the headers as they stand, constants of other headers included."""
    assert [e["value"] for e in awkward.entity("enums", name)["entries"]] == VALUES[name]


DIMENSIONS = {"Fixed": 3, "Slots": 8, "Rows": 6, "PerPlain": 66, "PerClass": 2, "PerSpace": 3, "Depth": 6, "Local": 11, "Hidden": 13, "LocalToo": 12, "A": 1}


@pytest.mark.parametrize("name", DIMENSIONS)
def test_array_dimensions(awkward: Result, name: str) -> None:
    assert awkward.property("structs", "FAwkwardForms", name)["array_dim"] == DIMENSIONS[name]


def test_a_real_compiler_agrees(awkward: Result, tmp_path: Path) -> None:
    """The enums above, compiled with their constants: reflection macros empty, nothing else changed."""
    limits = (AWKWARD / "Public/AwkwardLimits.h").read_text()
    enums = (AWKWARD / "Public/AwkwardEnums.h").read_text()
    enums = re.sub(r"#include.*|ENUM_(CLASS_FLAGS|RANGE_BY_COUNT)\(.*", "", enums)
    checks = []
    for name in VALUES:
        for entry in awkward.entity("enums", name)["entries"]:
            value = f"{entry['value']}ll" if entry["value"] != -(2**63) else "(-9223372036854775807ll - 1)"
            checks.append(f"static_assert(static_cast<long long>({entry['name']}) == {value});")
    assert len(checks) == sum(map(len, VALUES.values()))
    source = tmp_path / "check.cpp"
    macros = "".join(f"#define {name}(...)\n" for name in ("UENUM", "UMETA", "UE_DEPRECATED"))
    types = "using int32 = int; using int64 = long long; using uint8 = unsigned char; using uint32 = unsigned;\n"
    source.write_text(f"{macros}#define INDEX_NONE (-1)\n#define WITH_EDITOR 1\n{types}{limits}{enums}{chr(10).join(checks)}\n")
    run = subprocess.run(["c++", "-std=c++20", "-fsyntax-only", "-w", str(source)], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


KINDS = {
    "Utf8": "FUtf8String", "Ansi": "TArray<FAnsiString>", "Path": "TFieldPath<FProperty>", "Instanced": "FInstancedStruct", "ConstObjectPtr": "UAwkwardObject*",
    "ConstElements": "TArray<UAwkwardObject*>", "EastConst": "UAwkwardObject*", "Spaced": "TEnumAsByte<EAwkwardSpace::Type>", "MaybeNumber": "TOptional<int32>",
    "WithAllocator": "TArray<int32>", "Global": "FVector", "Plainly": "uint32", "Real": "double", "bThird": "bool", "WithSemicolon": "float", "C": "int32",
}


@pytest.mark.parametrize("name", KINDS)
def test_types(awkward: Result, name: str) -> None:
    assert awkward.property("structs", "FAwkwardForms", name)["type"]["cpp"] == KINDS[name]


def test_skipped_things_are_named(awkward: Result) -> None:
    assert awkward.report is not None
    skipped = {e["subject"].rpartition("::")[2] for e in awkward.report["entries"] if e["rule"] in ("unsupported-type", "unnamed-parameter")}
    assert {"Shared", "Standard", "Reference", "Matrix", "Pointer", "Variant", "Verse", "Value", "Callback", "Unnamed", "Unique"} <= skipped
    names = {p["name"] for p in awkward.entity("classes", "UAwkwardSkipped")["properties"]}
    assert names == {"Nested", "Unknown", "Good"}, "one odd member costs no other"


def test_libclang_agrees_on_every_type(awkward: Result) -> None:
    """All but a return type of the C++ library, which is skipped anyway; dynamic delegates' signatures count too."""
    assert awkward.report is not None
    assert awkward.report["ast"]["missing"] == 0
    assert [e["subject"] for e in awkward.report["entries"] if e["rule"] in ("type-differs", "ast-missing")] == ["UAwkwardSkipped::Unique"]


def test_deprecation_and_comment_around_the_macro(awkward: Result) -> None:
    before, behind = (awkward.function("UAwkwardObject", name) for name in ("BeforeTheMacro", "BehindTheMacro"))
    assert before["source"]["deprecated"] == behind["source"]["deprecated"] == '5.2, "Call Newer()."'
    assert before["editor"]["meta"]["ToolTip"] == "Its comment stands above the deprecation."
