# SPDX-License-Identifier: MIT
"""generated/ (schemas, typed stubs, C++ proxies) is what the headers say now (tools/regenerate --check), and a change is noticed."""

from __future__ import annotations

import ast
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import helpers
import jsonschema


def regenerate(source_directory: Path, build_directory: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(source_directory / "tools" / "regenerate"), "--header-tool", str(build_directory / "bin" / "spear-header-tool"), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)


def test_generated_is_current(source_directory: Path, build_directory: Path) -> None:
    result = regenerate(source_directory, build_directory, "--check")
    assert result.returncode == 0, result.stdout[-6000:] + result.stderr


def test_every_file_says_that_it_is_generated(source_directory: Path) -> None:
    files = [file for file in sorted((source_directory / "generated").rglob("*")) if file.is_file() and file.name not in ("README.md", ".spear-generated.json")]
    assert {file.suffix for file in files} == {".json", ".pyi", ".hpp"}
    for file in files:
        text = file.read_text(encoding="utf-8")
        if file.suffix == ".json":
            first = next(iter(json.loads(text).items()))
            assert first[0] == "$comment" and "do not edit" in first[1].lower(), file
        else:
            assert "do not edit" in "".join(text.splitlines(keepends=True)[:2]).lower(), file
        assert not re.search(r"[\"' ]/(home|work|tmp|root|usr)/", text), f"{file} names a path of a machine"


def test_stubs_are_python_and_small(source_directory: Path) -> None:
    """Editors give up on large stubs: none above 500 KB. Every module of the schemas has its stubs and facts."""
    folder = source_directory / "generated" / "python" / "spear" / "unreal"
    for file in folder.rglob("*.pyi"):
        ast.parse(file.read_text(encoding="utf-8"), str(file))
        assert file.stat().st_size <= 500_000, file
    modules = {file.name.split(".")[0] for file in (source_directory / "generated" / "schema").iterdir()}
    assert {path.name for path in folder.iterdir() if path.is_dir()} == modules
    for module in modules:
        assert (folder / module / "__init__.pyi").is_file() and json.loads((folder / module / "facts.json").read_text(encoding="utf-8"))


def test_files_are_good_schemas_of_this_repository_only(source_directory: Path) -> None:
    rules = jsonschema.Draft202012Validator(json.loads((source_directory / "codegen" / "schema.schema.json").read_text(encoding="utf-8")))
    files = sorted((source_directory / "generated" / "schema").iterdir())
    assert [file.name for file in files] == ["CoreUObject.schema.json", "Engine.schema.json", "SpearServer.schema.json"]
    for file in files:
        text = file.read_text(encoding="utf-8")
        assert file.stat().st_size < 2 << 20
        assert not re.search(r'"/(home|work|tmp|root|usr)/', text), f"{file} names a path of a machine"
        errors = [error.message[:200] for error in rules.iter_errors(json.loads(text))]
        assert not errors, (file, errors[:10])


def test_same_facts_as_the_build_has(source_directory: Path, build_directory: Path) -> None:
    for file in (source_directory / "generated" / "schema").iterdir():
        built = json.loads((build_directory / "codegen" / file.name.split(".")[0] / file.name).read_text(encoding="utf-8"))
        checked_in = json.loads(file.read_text(encoding="utf-8"))
        assert checked_in.pop("tiers") == ["runtime", "editor"] and "do not edit" in checked_in.pop("$comment")
        found = list(helpers.differences(helpers.without_source(built), helpers.without_source(checked_in)))
        assert not found, "\n".join(found[:20])


def test_check_notices_changes_and_writing_repairs_them(source_directory: Path, build_directory: Path, tmp_path: Path) -> None:
    copy = tmp_path / "generated"
    shutil.copytree(source_directory / "generated", copy, ignore=shutil.ignore_patterns(".spear-generated.json"))
    assert regenerate(source_directory, build_directory, "--output", str(copy)).returncode == 0
    file = copy / "schema" / "Engine.schema.json"
    good = {path: path.read_bytes() for path in copy.rglob("*") if path.is_file()}
    file.write_text(file.read_text(encoding="utf-8").replace('"K2_GetActorLocation"', '"K2_GetActorPosition"'), encoding="utf-8")
    (copy / "schema" / "Old.schema.json").write_text("{}", encoding="utf-8")
    stub = next(path for path in sorted(copy.rglob("*.pyi")) if "def K2_GetActorLocation" in path.read_text(encoding="utf-8"))
    stub.write_text(stub.read_text(encoding="utf-8").replace("def K2_GetActorLocation", "def K2_GetActorPlace"), encoding="utf-8")
    proxy = copy / "cpp" / "spear" / "unreal" / "Engine" / "AActor.hpp"
    proxy.unlink()
    (copy / "cpp" / "spear" / "unreal" / "Gone").mkdir()
    (copy / "cpp" / "spear" / "unreal" / "Gone" / "AGone.hpp").write_text("", encoding="utf-8")
    result = regenerate(source_directory, build_directory, "--check", "--output", str(copy))
    assert result.returncode == 1 and "run tools/regenerate" in result.stderr
    for name in ("K2_GetActorPosition", "K2_GetActorPlace", "Old.schema.json", "AActor.hpp", "AGone.hpp"):
        assert name in result.stdout
    assert regenerate(source_directory, build_directory, "--output", str(copy)).returncode == 0
    assert {path: path.read_bytes() for path in copy.rglob("*") if path.is_file()} == good
    assert not (copy / "cpp" / "spear" / "unreal" / "Gone").exists()
    missing = regenerate(source_directory, build_directory, "--header-tool", str(tmp_path / "none"))
    assert missing.returncode == 2 and "build it" in missing.stderr
