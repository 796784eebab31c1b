# SPDX-License-Identifier: MIT
"""`python codegen/emit cpp`: same input, same files; nothing written that has not changed; what is not known is said."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCHEMAS = [ROOT / "generated" / "schema" / f"{name}.schema.json" for name in ("CoreUObject", "Engine", "SpearServer")]


def emit(output: Path, *schemas: Path, jobs: int = 0) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(ROOT / "codegen" / "emit"), "cpp", *map(str, schemas), "--output-dir", str(output), "--jobs", str(jobs)]
    return subprocess.run(command, capture_output=True, text=True)


def files(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*.hpp")}


def test_same_output_whatever_the_number_of_processes(tmp_path: Path) -> None:
    assert emit(tmp_path / "one", *SCHEMAS, jobs=1).returncode == 0
    assert emit(tmp_path / "two", *reversed(SCHEMAS), jobs=2).returncode == 0
    one = files(tmp_path / "one")
    assert len(one) > 150
    assert one == files(tmp_path / "two")
    for name, text in one.items():
        assert b"do not edit" in text.splitlines()[0], name


def test_writes_only_what_changed_and_removes_what_is_gone(tmp_path: Path) -> None:
    emit(tmp_path, *SCHEMAS)
    times = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.hpp")}
    assert "0 of" in emit(tmp_path, *SCHEMAS).stderr
    assert times == {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.hpp")}
    (tmp_path / "spear" / "unreal" / "Engine" / "mine.hpp").write_text("not generated")
    assert emit(tmp_path, SCHEMAS[0]).returncode == 0
    left = set(files(tmp_path))
    assert "spear/unreal/Engine/mine.hpp" in left and "spear/unreal/Engine/AActor.hpp" not in left
    assert "spear/unreal/CoreUObject/UObject.hpp" in left


def test_types_of_other_modules_degrade_and_are_reported(tmp_path: Path) -> None:
    done = emit(tmp_path, SCHEMAS[1])  # Engine without CoreUObject
    assert done.returncode == 0
    assert "UObject" in done.stderr and "in no schema" in done.stderr
    actor = (tmp_path / "spear/unreal/Engine/AActor.hpp").read_text()
    assert "class AActor : public spear::Proxy<AActor, AActor_Members<spear::Object>>" in actor
    assert "unreal::FVector K2_" not in actor and "spear::ResultOf<SpearBase, unreal::FVector> K2_GetActorLocation() const" in actor


@pytest.fixture
def schema() -> dict[str, Any]:
    base: dict[str, Any] = {"format": "spear-schema", "version": 1, "origin": "live", "modules": [{"name": "Game"}], "classes": [], "structs": [], "enums": [], "delegates": []}
    return base


def function(name: str, parameters: list[dict[str, Any]]) -> dict[str, Any]:
    return {"name": name, "flags": ["Native", "Public"], "parameters": parameters, "returns": None, "editor": {"meta": {}}}


def game_class(name: str, functions: list[dict[str, Any]]) -> dict[str, Any]:
    return {"name": name, "reflected_name": name[1:], "path": f"/Script/Game.{name[1:]}", "module": "Game", "super": None, "interfaces": [], "flags": [], "within": "UObject",
            "config": "", "functions": functions, "properties": [], "editor": {"meta": {}}}


def test_names_that_are_no_identifiers(tmp_path: Path, schema: dict[str, Any]) -> None:
    integer = {"kind": "int32", "cpp": "int32"}
    parameters = [{"name": name, "type": integer, "flags": ["Parm"], "array_dim": 1} for name in ("In Value", "In_Value", "2D", "class")]
    schema["classes"] = [game_class("UThing", [function("Do It", parameters), function("Do_It", []), function("delete", [])])]
    file = tmp_path / "game.json"
    file.write_text(json.dumps(schema))
    done = emit(tmp_path / "out", file)
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "out/spear/unreal/Game/UThing.hpp").read_text()
    assert 'call_proxy<void>(*this, "Do It"' in text and " Do_It_2(" in text and " Do_It()" in text and " delete_()" in text
    for name in ("& In_Value_2,", "& In_Value,", "& x2D,", "& class_)"):
        assert name in text
    for unreal in ('"In Value", In_Value_2', '"2D", x2D', '"class", class_'):
        assert unreal in text


def test_a_text_that_would_break_a_comment(tmp_path: Path, schema: dict[str, Any]) -> None:
    thing = game_class("UThing", [])
    thing["editor"]["meta"]["ToolTip"] = "Ends in a backslash \\\nNext */ line \x07 \\\\"
    schema["classes"] = [thing]
    file = tmp_path / "game.json"
    file.write_text(json.dumps(schema))
    assert emit(tmp_path / "out", file).returncode == 0
    lines = (tmp_path / "out/spear/unreal/Game/UThing.hpp").read_text().splitlines()
    comments = [line for line in lines if line.startswith("///")]
    assert any("Next */ line" in line for line in comments)
    assert not any(line.endswith("\\") or "\x07" in line for line in comments)
