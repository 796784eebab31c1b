# SPDX-License-Identifier: MIT
"""generated/ is what the headers say now (tools/regenerate --check), and a change is noticed."""

from __future__ import annotations

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
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)


def test_generated_is_current(source_directory: Path, build_directory: Path) -> None:
    result = regenerate(source_directory, build_directory, "--check")
    assert result.returncode == 0, result.stdout[-6000:] + result.stderr


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
        assert checked_in.pop("tiers") == ["runtime", "editor"]
        found = list(helpers.differences(helpers.without_source(built), helpers.without_source(checked_in)))
        assert not found, "\n".join(found[:20])


def test_check_notices_changes_and_writing_repairs_them(source_directory: Path, build_directory: Path, tmp_path: Path) -> None:
    copy = tmp_path / "generated"
    shutil.copytree(source_directory / "generated", copy)
    assert regenerate(source_directory, build_directory, "--output", str(copy)).returncode == 0
    file = copy / "schema" / "Engine.schema.json"
    good = file.read_text(encoding="utf-8")
    file.write_text(good.replace('"K2_GetActorLocation"', '"K2_GetActorPosition"'), encoding="utf-8")
    (copy / "schema" / "Old.schema.json").write_text("{}", encoding="utf-8")
    result = regenerate(source_directory, build_directory, "--check", "--output", str(copy))
    assert result.returncode == 1
    assert "K2_GetActorPosition" in result.stdout and "Old.schema.json" in result.stdout and "run tools/regenerate" in result.stderr
    assert regenerate(source_directory, build_directory, "--output", str(copy)).returncode == 0
    assert file.read_text(encoding="utf-8") == good and not (copy / "schema" / "Old.schema.json").exists()
    missing = regenerate(source_directory, build_directory, "--header-tool", str(tmp_path / "none"))
    assert missing.returncode == 2 and "build it" in missing.stderr
