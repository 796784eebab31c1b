# SPDX-License-Identifier: MIT
"""Wrong arguments and broken files: a clear text and the right exit code, never a crash, never a lost run."""

from __future__ import annotations

import json
import os
import random
import subprocess
from pathlib import Path

import pytest
from header_tool_runs import FIXTURES, Dump, run_tool

GOOD = '#include "Good.generated.h"\nUSTRUCT() struct FGood { GENERATED_BODY() UPROPERTY() int32 Value; };\n'


def run(tool: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(tool), *arguments], capture_output=True, text=True, timeout=60)


def test_help_explains_every_option(tool: Path) -> None:
    result = run(tool, "dump", "--help")
    assert result.returncode == 0
    for option in ("--module", "--import", "--define", "--strict", "--jobs", "--report", "--depfile", "--output"):
        assert option in result.stdout


@pytest.mark.parametrize("arguments", [[], ["dump"], ["dump", "--module", "A=."], ["dump", "-o", "x"], ["dump", "--no-such-option"], ["frobnicate"]])
def test_usage_errors_exit_with_2(tool: Path, arguments: list[str]) -> None:
    result = run(tool, *arguments)
    assert result.returncode == 2
    assert result.stderr.strip() or result.stdout.strip()


def test_missing_folder(tool: Path, tmp_path: Path) -> None:
    result = run_tool(tool, tmp_path, ["--module", f"A={tmp_path}/nowhere"])
    assert result.code == 2
    assert "nowhere" in result.errors and "does not exist" in result.errors


def test_module_is_a_file(tool: Path, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    result = run_tool(tool, tmp_path, ["--module", f"A={tmp_path}/file"])
    assert result.code == 2 and "is not a folder" in result.errors


def test_no_build_cs(tool: Path, tmp_path: Path) -> None:
    (tmp_path / "dir").mkdir()
    result = run_tool(tool, tmp_path, ["--module", f"{tmp_path}/dir"])
    assert result.code == 2 and "Build.cs" in result.errors and "NAME=" in result.errors


def test_module_twice(tool: Path, tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
    result = run_tool(tool, tmp_path, ["--module", f"A={tmp_path}/a", "--module", f"A={tmp_path}/b"])
    assert result.code == 2 and "found twice" in result.errors


@pytest.mark.parametrize("name", ["", "A-B", "A B"])
def test_bad_module_name(tool: Path, tmp_path: Path, name: str) -> None:
    result = run_tool(tool, tmp_path, ["--module", f"{name}={tmp_path}"])
    assert result.code == 2 and "NAME=DIR" in result.errors


@pytest.mark.parametrize(("content", "expected"), [("{", "not valid JSON"), ("[]", "not a spear-schema"), ('{"format":"spear-schema","version":9}', "version 9"), (None, "cannot read")])
def test_bad_import(tool: Path, tmp_path: Path, content: str | None, expected: str) -> None:
    file = tmp_path / "import.json"
    if content is not None:
        file.write_text(content)
    (tmp_path / "m").mkdir()
    result = run_tool(tool, tmp_path, ["--module", f"A={tmp_path}/m", "--import", str(file)])
    assert result.code == 2
    assert expected in result.errors and "import.json" in result.errors


def test_import_with_missing_members(tool: Path, tmp_path: Path) -> None:
    file = tmp_path / "import.json"
    file.write_text(json.dumps({"format": "spear-schema", "version": 1, "classes": [{}]}))
    (tmp_path / "m").mkdir()
    result = run_tool(tool, tmp_path, ["--module", f"A={tmp_path}/m", "--import", str(file)])
    assert result.code == 2 and "import.json" in result.errors


def test_unwritable_output(tool: Path, tmp_path: Path) -> None:
    (tmp_path / "m").mkdir()
    (tmp_path / "taken").write_text("")
    result = run(tool, "dump", "--module", f"A={tmp_path}/m", "-o", str(tmp_path / "taken" / "out.json"))
    assert result.returncode == 2 and "cannot write" in result.stderr


def test_bad_define(tool: Path, tmp_path: Path) -> None:
    result = run_tool(tool, tmp_path, ["--module", f"A={tmp_path}", "--define", "=1"])
    assert result.code == 2 and "NAME=VALUE" in result.errors


def test_binary_file_is_skipped_and_reported(tool: Path, tmp_path: Path) -> None:
    module = tmp_path / "m"
    module.mkdir()
    (module / "Bad.h").write_bytes(b"UCLASS(\x00\x01\x02" + bytes(range(256)) * 8)
    (module / "Good.h").write_text(GOOD)
    result = run_tool(tool, tmp_path, ["--module", f"A={module}"])
    assert result.code == 0
    assert result.entity("structs", "FGood")
    assert ("not-text", 1) in result.rules()
    assert run_tool(tool, tmp_path, ["--module", f"A={module}", "--strict"]).code == 1


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_unreadable_file_is_reported(tool: Path, tmp_path: Path) -> None:
    module = tmp_path / "m"
    module.mkdir()
    (module / "Bad.h").write_text(GOOD)
    (module / "Bad.h").chmod(0)
    result = run_tool(tool, tmp_path, ["--module", f"A={module}"])
    assert result.code == 0 and ("unreadable", 1) in result.rules()


NOT_CPP = [
    "UCLASS() this is prose, not C++ ( [ {",
    "UCLASS(",
    "UCLASS()",
    "UPROPERTY(EditAnywhere",
    "UENUM() enum",
    "UENUM() enum class",
    "UENUM() namespace",
    "USTRUCT() struct",
    "USTRUCT() struct F {",
    "USTRUCT() struct F { GENERATED_BODY() UPROPERTY() TArray<",
    "USTRUCT() struct F { GENERATED_BODY() UPROPERTY() int32 A[",
    "USTRUCT() struct F { GENERATED_BODY() UPROPERTY() int32 A =",
    "UCLASS() class U : ",
    "UCLASS() class U : public UObject { UFUNCTION() void F(int32 A = (",
    "UCLASS() class U : public UObject { template <",
    "UCLASS() class U : public UObject { U(",
    "DECLARE_DYNAMIC_DELEGATE_OneParam(",
    "DECLARE_DYNAMIC_DELEGATE_OneParam()",
    "DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE(FFoo)",
    "UDELEGATE()",
    "#if\n#if\n#else\nUCLASS()\n#endif",
    '"unterminated UCLASS()',
    'R"(raw UCLASS()',
    "/* open UCLASS()",
    "UPROPERTY",
    "import os  # UCLASS(\ndef f(): return {'UPROPERTY(': 1}\n",
    "<html>UCLASS()</html>",
    "}}}}} UCLASS() {{{{{",
    ") ) ) UFUNCTION() ] } >",
    "UINTERFACE()" * 50,
    "UENUM() enum class E : uint8 { A = };",
    "namespace",
    "template",
    "extern \"C\"",
]


@pytest.mark.parametrize("text", NOT_CPP)
def test_text_that_is_no_header_does_no_harm(dump: Dump, text: str) -> None:
    result = dump({"Bad.h": text, "Good.h": GOOD})
    assert result.code == 0, result.errors
    assert result.property("structs", "FGood", "Value")


def test_damaged_headers_do_no_harm(tool: Path, tmp_path: Path) -> None:
    """Good headers, cut and shuffled at random places (always the same ones)."""
    source = (FIXTURES / "Sample" / "Public" / "SampleActor.h").read_text()
    numbers = random.Random(7)
    module = tmp_path / "m"
    module.mkdir()
    for i in range(150):
        text = source
        for _ in range(numbers.randint(1, 4)):
            a, b = sorted(numbers.randrange(len(text) + 1) for _ in range(2))
            text = numbers.choice([text[:a], text[:a] + text[b:], text[:a] + numbers.choice("(){}<>[];,\"'#\\\n") + text[a:], text[a:b] + text[:a]])
        (module / f"Damaged{i}.h").write_text(text)
    (module / "Good.h").write_text(GOOD)
    result = run_tool(tool, tmp_path, ["--quiet", "--module", f"A={module}"])
    assert result.code == 0, result.errors
    assert result.property("structs", "FGood", "Value")
