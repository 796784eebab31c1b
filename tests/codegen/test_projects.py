# SPDX-License-Identifier: MIT
"""Which modules a run is about: --module, --project, --plugin, --engine; and what happens where a place or a file cannot be used."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest
from header_tool_runs import ROOT, Result, run_tool


def write_module(folder: Path, name: str, body: str, header: str = "Thing.h") -> None:
    (folder / "Public").mkdir(parents=True)
    (folder / f"{name}.Build.cs").write_text(f"public class {name} : ModuleRules {{}}\n")
    stem = header.removesuffix(".h")
    (folder / "Public" / header).write_text(f'#include "{stem}.generated.h"\n{body}\n')


def struct(name: str, members: str = "UPROPERTY() int32 X;") -> str:
    return f"USTRUCT() struct {name} {{ GENERATED_BODY() {members} }};"


@pytest.fixture
def world(tmp_path: Path) -> Path:
    """An engine with a plugin, and a project with two modules, an enabled plugin, one that is not, one of three modules and one elsewhere."""
    engine = tmp_path / "UE" / "Engine"
    write_module(engine / "Source/Runtime/Engine", "Engine", "UCLASS() class UObject { GENERATED_BODY() };\nUCLASS(DefaultToInstanced) class UEngineComponent : public UObject { GENERATED_BODY() };\n" + struct("FEngineStruct"))
    write_module(engine / "Source/Editor/UnrealEd", "UnrealEd", "UENUM() enum class EEditor : int32 { A };")
    write_module(engine / "Source/ThirdParty/zlib", "zlib", struct("FNever"))
    (engine / "Plugins/Fx/Niagara").mkdir(parents=True)
    (engine / "Plugins/Fx/Niagara/Niagara.uplugin").write_text("{}")
    write_module(engine / "Plugins/Fx/Niagara/Source/Niagara", "Niagara", struct("FNiagaraThing"))

    game = tmp_path / "Game"
    write_module(game / "Source/Game", "Game", struct("FGame", "UPROPERTY() UEngineComponent* Part; UPROPERTY() EEditor Kind; UPROPERTY() FNiagaraThing Thing;"))
    write_module(game / "Source/GameEditor", "GameEditor", struct("FGameEditor"))
    for name, enabled in (("Enabled", True), ("Disabled", False)):
        plugin = game / "Plugins" / "Group" / name
        write_module(plugin / "Source" / name, name, struct(f"F{name}"))
        (plugin / f"{name}.uplugin").write_text(json.dumps({"Modules": [{"Name": name}], "EnabledByDefault": enabled}))
    for part in ("One", "Two", "Three"):
        write_module(game / "Plugins/Many/Source" / part, part, struct(f"F{part}"))
    (game / "Plugins/Many/Many.uplugin").write_text("{}")
    write_module(tmp_path / "Shared/Far/Source/Far", "Far", struct("FFar"))
    (tmp_path / "Shared/Far/Far.uplugin").write_text("{}")
    write_module(game / "Intermediate/Old", "Old", struct("FOld"))
    (game / "Game.uproject").write_text(json.dumps({"Modules": [{"Name": "Game"}, {"Name": "Gone"}], "AdditionalPluginDirectories": ["../Shared"],
        "Plugins": [{"Name": "Enabled", "Enabled": True}, {"Name": "Disabled", "Enabled": False}]}))
    return tmp_path


def modules(result: Result) -> list[str]:
    assert result.schema is not None, result.errors
    return [m["name"] for m in result.schema["modules"]]


PROJECT_MODULES = ["Disabled", "Enabled", "Far", "Game", "GameEditor", "One", "Three", "Two"]


@pytest.mark.parametrize("place", ["Game/Game.uproject", "Game"])
def test_project(tool: Path, world: Path, place: str) -> None:
    result = run_tool(tool, world, ["--project", str(world / place)])
    assert result.code == 0 and modules(result) == PROJECT_MODULES
    assert {s["name"] for s in result.schema["structs"]} == {"FGame", "FGameEditor", "FEnabled", "FDisabled", "FOne", "FTwo", "FThree", "FFar"}
    source = next(m for m in result.schema["modules"] if m["name"] == "Game")["source"]
    assert source["build_cs"] == "Game.Build.cs" and source["path"].endswith("Game/Source/Game")
    missing = [e for e in result.report["entries"] if e["rule"] == "missing-module"]
    assert [(e["subject"], Path(e["file"]).name) for e in missing] == [("Gone", "Game.uproject")]


@pytest.mark.parametrize("place", ["UE", "UE/Engine", "UE/"])
def test_engine_makes_its_types_known(tool: Path, world: Path, place: str) -> None:
    project = ["--project", str(world / "Game")]
    alone = run_tool(tool, world, project)
    assert "ContainsInstancedReference" not in str(alone.property("structs", "FGame", "Part")["flags"]) and alone.report["counts"]["assumed-type"] == 3
    assert alone.property("structs", "FGame", "Kind")["type"]["underlying"] == "uint8"
    result = run_tool(tool, world, [*project, "--engine", str(world / place)])
    assert result.code == 0 and modules(result) == PROJECT_MODULES, "the engine's modules are known, not written"
    assert "InstancedReference" in result.property("structs", "FGame", "Part")["flags"]
    assert result.property("structs", "FGame", "Kind")["type"]["underlying"] == "int32"
    assert "assumed-type" not in result.report["counts"]


def test_engine_is_written_alone_or_on_demand(tool: Path, world: Path) -> None:
    engine = ["--engine", str(world / "UE")]
    assert modules(run_tool(tool, world, engine)) == ["Engine", "Niagara", "UnrealEd"]
    both = run_tool(tool, world, [*engine, "--project", str(world / "Game"), "--write-engine"])
    assert modules(both) == sorted([*PROJECT_MODULES, "Engine", "Niagara", "UnrealEd"])


@pytest.mark.parametrize("place", ["Many.uplugin", ""])
def test_plugin(tool: Path, world: Path, place: str) -> None:
    assert modules(run_tool(tool, world, ["--plugin", str(world / "Game/Plugins/Many" / place)])) == ["One", "Three", "Two"]


def test_module_names_come_from_build_files(tool: Path, world: Path) -> None:
    assert modules(run_tool(tool, world, ["--module", str(world / "Game/Source")])) == ["Game", "GameEditor"]
    result = run_tool(tool, world, ["--module", str(world / "Game/Source/Game"), "--module", f"Own={world}/Game/Source/GameEditor"])
    assert modules(result) == ["Game", "Own"]


def test_a_types_own_declaration_wins_over_the_engines(tool: Path, world: Path) -> None:
    write_module(world / "Game/Source/Copy", "Copy", struct("FEngineStruct", "UPROPERTY() FString Mine;"))
    result = run_tool(tool, world, ["--project", str(world / "Game"), "--engine", str(world / "UE")])
    assert result.property("structs", "FEngineStruct", "Mine")


def test_module_found_twice_is_reported(tool: Path, world: Path) -> None:
    write_module(world / "Game/Plugins/Many/Source/Again", "Game", struct("FAgain"))
    result = run_tool(tool, world, ["--project", str(world / "Game")])
    assert result.code == 0 and modules(result) == PROJECT_MODULES
    assert [(e["subject"]) for e in result.report["entries"] if e["rule"] == "duplicate-module"] == ["Game"]


@pytest.mark.parametrize("text", ["", "{", "[]", "\x00\x01", '{"Modules": 7, "AdditionalPluginDirectories": [1, {}]}', '{"Modules": [{}, 3, {"Name": 4}]}', '// comment\n{"Modules": []}'])
def test_bad_descriptors_are_passed_over(tool: Path, world: Path, text: str) -> None:
    (world / "Game/Game.uproject").write_text(text)
    (world / "Game/Plugins/Many/Many.uplugin").write_text(text)
    result = run_tool(tool, world, ["--project", str(world / "Game")])
    assert result.code == 0 and modules(result) == [m for m in PROJECT_MODULES if m != "Far"]
    bad = "bad-descriptor" in result.report["counts"]
    assert bad == (text in ("", "{", "[]", "\x00\x01"))


WRONG_PLACES = [
    (["--project", "nowhere.uproject"], "does not exist"),
    (["--project", "nowhere"], "does not exist"),
    (["--project", "."], "0 *.uproject"),
    (["--project", "Game/Plugins/Many/Many.uplugin"], "is no *.uproject"),
    (["--project", "Empty"], "no *.Build.cs"),
    (["--plugin", "Game"], "0 *.uplugin"),
    (["--plugin", "Bare"], "nothing to read"),
    (["--engine", "nowhere"], "does not exist"),
    (["--engine", "Game/Game.uproject"], "is not a folder"),
    (["--engine", "Empty"], "Source/Runtime"),
    (["--module", "Empty"], "NAME="),
    (["--module", "X=nowhere"], "does not exist"),
]


@pytest.mark.parametrize(("arguments", "expected"), WRONG_PLACES)
def test_wrong_place_is_an_error_and_other_work_is_kept(tool: Path, world: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], expected: str) -> None:
    (world / "Empty").mkdir()
    (world / "Empty/Empty.uproject").write_text("{}")
    (world / "Bare").mkdir()
    (world / "Bare/Bare.uplugin").write_text("{}")
    monkeypatch.chdir(world)
    alone = run_tool(tool, world, arguments)
    assert alone.code == 2 and alone.schema is None
    assert expected in alone.errors and arguments[0] in alone.errors and arguments[1] in alone.errors
    with_others = run_tool(tool, world, [*arguments, "--module", "Game/Source/Game"])
    assert with_others.code == 2 and expected in with_others.errors
    assert modules(with_others) == ["Game"], "the other module is written all the same"


def test_nothing_named(tool: Path) -> None:
    run = subprocess.run([str(tool), "dump", "-o", "x.json"], capture_output=True, text=True)
    assert run.returncode == 2 and "--project" in run.stderr


def test_help_has_examples(tool: Path) -> None:
    text = subprocess.run([str(tool), "dump", "--help"], capture_output=True, text=True).stdout
    for word in ("Examples:", "--project", "--plugin", "--engine", "--write-engine", "--cache", "--no-cache", "--cache-size", "--quiet"):
        assert word in text


def test_quiet_prints_nothing(tool: Path, world: Path) -> None:
    assert run_tool(tool, world, ["--quiet", "--project", str(world / "Game")]).errors == ""
    assert "headers hold reflection" in run_tool(tool, world, ["--project", str(world / "Game")]).errors


def test_progress_is_drawn_on_a_terminal_only(tool: Path, world: Path) -> None:
    command = [str(tool), "dump", "--project", str(world / "Game"), "-o", str(world / "out.json")]
    assert "\r" not in subprocess.run(command, capture_output=True, text=True).stderr
    ours, theirs = os.openpty()
    run = subprocess.Popen(command, stderr=theirs)
    os.close(theirs)
    printed = b""
    while True:
        try:
            piece = os.read(ours, 4096)
        except OSError:  # the other end is closed
            break
        if not piece:
            break
        printed += piece
    os.close(ours)
    assert run.wait() == 0
    assert b"reading    [" in printed and b"checking   [##" in printed
    quiet = subprocess.run([*command, "--quiet"], capture_output=True, text=True)
    assert quiet.stderr == ""


GOOD = struct("FGood")


def test_awkward_files_in_a_module(tool: Path, world: Path) -> None:
    public = world / "Game/Source/GameEditor/Public"
    good = f'#include "X.generated.h"\n{struct("FName")}\n'
    (public / "Huge.h").write_text("UCLASS " + " " * (17 << 20))
    (public / "Folder.h").mkdir()
    (public / "Folder.h" / "Inside.h").write_text(good.replace("FName", "FInside"))
    os.mkfifo(public / "Pipe.h")
    (public / "Loop").symlink_to("..")
    (public / "Self").symlink_to("Self")
    (public / "Broken.h").symlink_to("nowhere.h")
    (public / "Latin.h").write_bytes(good.replace("FName", "FLatin").encode() + b"// caf\xe9 \xff\xfe\n")
    (public / "Utf16.h").write_bytes(good.replace("FName", "FUtf16").encode("utf-16"))
    (public / "Binary.h").write_bytes(b"\x7fELF UCLASS(\0\0" + bytes(range(256)))
    (public / "Odd.h").write_bytes(b"\xff\xfeU")
    (public / "Empty.h").write_text("")
    (public / os.fsdecode(b"bad\xffname.h")).write_text(good.replace("FName", "FOddName"))
    (public / "Deep.h").write_text("namespace a {" * 20000 + "UCLASS() class UDeep : public UObject {" + "}" * 20001)
    (public / "Nested.h").write_text("USTRUCT() struct FNested { UPROPERTY() " + "TArray<" * 20000 + "int32" + ">" * 20000 + " X; };")
    (public / "Brackets.h").write_text("UCLASS() class UB { UPROPERTY() int32 X = " + "(" * 50000 + "1" + ")" * 50000 + "; UPROPERTY(meta=(A=" + "TEXT(" * 20000 + ")))) int32 Y; };")
    (public / "Values.h").write_text("UENUM() enum class EDeep : uint8 { A = " + "(" * 300 + "1" + ")" * 300 + ", B = " + "-" * 9999 + "1 };")
    result = run_tool(tool, world, ["--project", str(world / "Game")])
    assert result.code == 0, result.errors
    names = {s["name"] for s in result.schema["structs"]}
    assert {"FInside", "FLatin", "FUtf16", "FOddName", "FGame", "FOne"} <= names
    rules = {(Path(e["file"]).name, e["rule"]) for e in result.report["entries"]}
    assert {("Huge.h", "too-large"), ("Binary.h", "not-text"), *((f"{n}.h", "too-deep") for n in ("Deep", "Nested", "Brackets", "Values"))} <= rules
    headers = next(m for m in result.schema["modules"] if m["name"] == "GameEditor")["source"]["headers"]
    assert not any("Loop" in h["path"] or "Self" in h["path"] for h in headers), "a folder is read once"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_unreadable_folder(tool: Path, world: Path) -> None:
    folder = world / "Game/Source/GameEditor/Public"
    folder.chmod(0)
    try:
        result = run_tool(tool, world, ["--project", str(world / "Game")])
    finally:
        folder.chmod(0o755)
    assert result.code == 0 and "unreadable" in result.report["counts"] and result.entity("structs", "FGame")


def test_the_embedded_engine_is_an_engine_too(tool: Path, tmp_path: Path) -> None:
    """This repository's plugin against this repository's engine, found by its folders."""
    result = run_tool(tool, tmp_path, ["--module", str(ROOT / "server_plugin/Source"), "--module", f"Engine={ROOT}/engine/Source/Runtime/Engine", "--module", f"CoreUObject={ROOT}/engine/Source/Runtime/CoreUObject"])
    assert result.code == 0 and modules(result) == ["CoreUObject", "Engine", "SpearServer"]
