# SPDX-License-Identifier: MIT
"""The other commands of `spear schema`, and what all of them do with bad input."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner
from schema_commands import Command, Dump, load

GAME = "UENUM() enum class EMode : uint8 { Slow, Fast };\nUSTRUCT() struct FPair { GENERATED_BODY() UPROPERTY() int32 A; UPROPERTY() int32 B; };\nUCLASS() class UGame : public UObject { GENERATED_BODY() public: UPROPERTY() EMode Mode; UFUNCTION() void Go(int32 A, FPair B); };"


@pytest.fixture
def bad_files(dump: Dump, tmp_path: Path) -> dict[str, tuple[Path, str]]:
    """Kind of trouble -> a file with it, and a word that its message must have."""
    good = dump("bad-source", GAME).read_text()
    texts = {"truncated": (good[: len(good) // 2], "cut short"), "other version": (good.replace('"version": 1', '"version": 7'), "version 7"), "other json": ('{"a": 1}', "no SPEAR schema"), "list": ("[1, 2]", "no SPEAR schema"),
             "empty": ("", "cut short"), "no lists": ('{"format": "spear-schema", "version": 1, "origin": "live"}', "no list"), "text": ("#include <x>", "no JSON")}
    found = {name: (tmp_path / f"{name.replace(' ', '-')}.json", word) for name, (_, word) in texts.items()}
    for name, (text, _) in texts.items():
        found[name][0].write_text(text)
    binary = tmp_path / "binary.json"
    binary.write_bytes(b"\xff\xfe\x00\x9f{")
    return {**found, "binary": (binary, "UTF-8"), "missing": (tmp_path / "none.json", "does not exist"), "folder": (tmp_path, "is a folder")}


BAD = ["truncated", "other version", "other json", "list", "empty", "no lists", "text", "binary", "missing", "folder"]


@pytest.mark.parametrize("command", [["check"], ["stats"], ["merge", "-o", "out"], ["stubs", "-o", "out"], ["cpp", "-o", "out"], ["docs", "-o", "out"]], ids=lambda c: c[0])
def test_bad_schemas(command: list[str], spear_schema: Command, bad_files: dict[str, tuple[Path, str]], dump: Dump, tmp_path: Path) -> None:
    good = dump("good", GAME)
    for name in BAD:
        file, word = bad_files[name]
        result = spear_schema(*command, good, file, code=1)
        assert word in result.stderr and str(file) in result.stderr, (name, result.stderr)
        assert len(result.stderr.strip().splitlines()) == 1, (name, result.stderr)
        assert not (tmp_path / "out").exists(), f"{command[0]} wrote something although {name}"
    if command[0] == "check":  # the others are told about all the same
        assert f"{good}: a good schema" in spear_schema("check", bad_files["truncated"][0], good, code=1).stdout
    if command[0] == "stats":
        assert "Game" in spear_schema("stats", bad_files["truncated"][0], good, code=1).stdout


@pytest.mark.skipif(os.geteuid() == 0, reason="root reads and writes everything")
def test_unreadable_and_unwritable(spear_schema: Command, dump: Dump, tmp_path: Path) -> None:
    file = dump("good", GAME)
    file.chmod(0)
    assert "cannot be read" in spear_schema("check", file, code=1).stderr
    file.chmod(0o600)
    (tmp_path / "locked").mkdir(mode=0o500)
    assert "cannot write" in spear_schema("merge", file, "-o", "locked/out.json", code=1).stderr


def test_output_that_cannot_be(spear_schema: Command, dump: Dump, tmp_path: Path) -> None:
    good = dump("good", GAME)
    (tmp_path / "file").write_text("kept")
    for command in (["merge", "-o", "file/out.json"], ["docs", "-o", "file/site"], ["stubs", "-o", "file/stubs"], ["cpp", "-o", "file/include"]):
        assert "cannot write" in spear_schema(*command, good, code=1).stderr
    assert "is a folder" in spear_schema("merge", "-o", tmp_path, good, code=1).stderr
    assert (tmp_path / "file").read_text() == "kept"


def test_check_names_the_place(spear_schema: Command, engine_schemas: list[Path], tmp_path: Path) -> None:
    document = load(engine_schemas[1])
    document["classes"][70]["properties"][0]["array_dim"] = "one"
    document["enums"][3]["entries"][1]["valeu"] = 3
    (tmp_path / "bad.json").write_text(json.dumps(document))
    lines = spear_schema("check", "bad.json", code=1).stderr.splitlines()
    assert any(line.startswith("bad.json: /classes/70/properties/0/array_dim: ") and "integer" in line for line in lines), lines
    assert any(line.startswith("bad.json: /enums/3/entries/1") and "valeu" in line for line in lines), lines
    assert lines[-1] == "bad.json: 2 errors"
    assert json.loads(spear_schema("check", "--rules").stdout)["title"] == "spear-schema"


def test_check_works_from_an_installed_package(build_directory: Path, dump: Dump, tmp_path: Path) -> None:
    """The JSON Schema is a file of the package; the source tree is not needed."""
    from spear import codegen

    assert (Path(codegen.__file__).parent / "schema.schema.json").is_file()
    copy = tmp_path / "site"
    shutil.copytree(build_directory / "python" / "spear", copy / "spear", ignore=shutil.ignore_patterns("unreal", "__pycache__"))
    environment = {k: v for k, v in os.environ.items() if k != "SPEAR_BUILD_DIR"} | {"PYTHONPATH": str(copy)}
    result = subprocess.run([sys.executable, "-m", "spear", "schema", "check", str(dump("good", GAME))], capture_output=True, text=True, check=False, env=environment, cwd=tmp_path)
    assert result.returncode == 0 and "a good schema" in result.stdout, result.stderr


def test_stats(spear_schema: Command, dump: Dump, engine_schemas: list[Path]) -> None:
    game = dump("game", GAME)
    counts = json.loads(spear_schema("stats", "--json", game).stdout)
    assert counts["Game"] == counts["total"] == {"headers": 1, "classes": 1, "structs": 1, "enums": 1, "delegates": 0, "functions": 1, "parameters": 2, "properties": 3, "entries": 2}
    several = json.loads(spear_schema("stats", "--json", *engine_schemas, game, game).stdout)
    assert list(several) == ["CoreUObject", "Engine", "Game", "total"] and several["Game"] == counts["Game"]
    assert several["total"]["functions"] == several["Engine"]["functions"] + several["CoreUObject"]["functions"] + 1 > 1000
    assert spear_schema("stats", "-", stdin=game.read_text()).stdout.splitlines()[-1].split() == ["total", "1", "1", "1", "1", "0", "1", "2", "3", "2"]


def test_dump_is_the_header_tool(spear_schema: Command, dump: Dump, tmp_path: Path) -> None:
    expected = dump("game", GAME)
    assert spear_schema("dump", "--module", f"Game={tmp_path / 'game-source' / 'Game'}", "-q", "-o", "again.json").returncode == 0
    assert load(tmp_path / "again.json")["structs"] == load(expected)["structs"] != []
    text = spear_schema("dump", "--help").stdout
    assert "spear schema dump" in text and "--module" in text and "spear-header-tool" not in text
    assert spear_schema("dump", "--nonsense", code=2).stderr
    assert "none" in spear_schema("dump", "--module", "none", "-o", "x.json", code=2).stderr


def test_stubs_are_a_package(spear_schema: Command, dump: Dump, engine_schemas: list[Path], tmp_path: Path) -> None:
    game = dump("game", GAME)
    spear_schema("stubs", *engine_schemas, game, "-o", "typings")
    package = tmp_path / "typings" / "spear-stubs"
    assert (package / "py.typed").read_text() == "partial\n"
    assert "class UGame" in "".join(f.read_text() for f in (package / "unreal" / "Game").glob("_*.pyi"))
    import spear

    own = Path(spear.__file__).parent
    expected = {f.relative_to(own).as_posix() for f in own.rglob("*.pyi") if f.relative_to(own).parts[0] not in ("unreal", "codegen")}
    assert expected and {f.relative_to(package).as_posix() for f in package.rglob("*.pyi") if f.relative_to(package).parts[0] != "unreal"} == expected
    before = {f: f.stat().st_mtime_ns for f in package.rglob("*") if f.is_file()}
    assert ", 0 changed" in spear_schema("stubs", *engine_schemas, game, "-o", "typings").stderr
    assert before == {f: f.stat().st_mtime_ns for f in package.rglob("*") if f.is_file()}
    assert "removed" in spear_schema("stubs", *engine_schemas, "-o", "typings").stderr and not (package / "unreal" / "Game").exists()
    assert "no schema declares UObject" in spear_schema("stubs", game, "-o", "alone").stderr


def test_stubs_go_into_the_active_environment(spear_schema: Command, engine_schemas: list[Path], tmp_path: Path) -> None:
    """VIRTUAL_ENV is the environment that the user activated, whatever Python runs the program."""
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(tmp_path / "env")], check=True)
    spear_schema("stubs", *engine_schemas, VIRTUAL_ENV=str(tmp_path / "env"))
    packages = list((tmp_path / "env").glob("lib/python*/site-packages/spear-stubs"))
    assert len(packages) == 1 and (packages[0] / "unreal" / "Engine" / "__init__.pyi").is_file()


def test_cpp_and_docs(spear_schema: Command, dump: Dump, engine_schemas: list[Path], tmp_path: Path) -> None:
    game = dump("game", GAME)
    spear_schema("cpp", *engine_schemas, game, "-o", "include")
    assert (tmp_path / "include" / "spear" / "unreal" / "Game" / "UGame.hpp").is_file()
    spear_schema("docs", *engine_schemas, game, "-o", "site", "--title", "My very own game")
    assert "My very own game" in (tmp_path / "site" / "index.html").read_text()


@pytest.mark.parametrize("command", ["diff", "merge", "check", "stats", "live", "stubs", "cpp", "docs"])
def test_help_has_an_example(command: str) -> None:
    from spear.cli.schema import schema

    result = CliRunner().invoke(schema, [command, "--help"], prog_name="spear schema")
    assert result.exit_code == 0 and "Example" in result.output and f"spear schema {command}" in result.output.replace("| ", "")


def test_live_without_an_engine(spear_schema: Command, tmp_path: Path) -> None:
    result = spear_schema("live", f"unix:{tmp_path}/none.sock", "-o", "live.json", code=1)
    assert "none.sock" in result.stderr and not (tmp_path / "live.json").exists()
