# SPDX-License-Identifier: MIT
"""`spear schema diff`: each kind of change, how severe it is, and how it is told."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from schema_commands import Command, Dump

CLASS = """
UCLASS()
class UGame : public UObject {{
    GENERATED_BODY()
public:
{}
}};
"""


def changes_between(dump: Dump, run: Command, old: str, new: str, *options: str | Path, code: int = 1) -> list[dict[str, Any]]:
    result = run("diff", dump("old", old), dump("new", new), "--json", *options, code=code)
    document = json.loads(result.stdout)
    assert document["format"] == "spear-schema-diff"
    return list(document["changes"])


def in_class(*lines: str) -> str:
    return CLASS.format("\n".join("    " + line for line in lines))


FUNCTION = "UFUNCTION(BlueprintCallable) "

#: (what, members of the old class, of the new class, expected changes as (severity, change, kind, subject, facet))
CASES: list[tuple[str, list[str], list[str], list[tuple[str, str, str, str, str]]]] = [
    ("removed function", [FUNCTION + "void Go();"], [], [("breaking", "removed", "function", "UGame.Go", "")]),
    ("added function", [], [FUNCTION + "void Go();"], [("compatible", "added", "function", "UGame.Go", "")]),
    ("return type", [FUNCTION + "float Go();"], [FUNCTION + "double Go();"], [("breaking", "changed", "return", "UGame.Go", "type")]),
    ("nothing returned", [FUNCTION + "float Go();"], [FUNCTION + "void Go();"], [("breaking", "changed", "function", "UGame.Go", "returns")]),
    ("return value more special", [FUNCTION + "UActorComponent* Go();"], [FUNCTION + "USceneComponent* Go();"], [("compatible", "changed", "return", "UGame.Go", "type")]),
    ("return value less special", [FUNCTION + "USceneComponent* Go();"], [FUNCTION + "UActorComponent* Go();"], [("breaking", "changed", "return", "UGame.Go", "type")]),
    ("parameter type", [FUNCTION + "void Go(int32 A);"], [FUNCTION + "void Go(FString A);"], [("breaking", "changed", "parameter", "UGame.Go(A)", "type")]),
    ("parameter takes more", [FUNCTION + "void Go(USceneComponent* A);"], [FUNCTION + "void Go(UActorComponent* A);"], [("compatible", "changed", "parameter", "UGame.Go(A)", "type")]),
    ("parameter takes less", [FUNCTION + "void Go(UActorComponent* A);"], [FUNCTION + "void Go(USceneComponent* A);"], [("breaking", "changed", "parameter", "UGame.Go(A)", "type")]),
    ("parameter order", [FUNCTION + "void Go(int32 A, float B);"], [FUNCTION + "void Go(float B, int32 A);"], [("breaking", "changed", "function", "UGame.Go", "order")]),
    ("parameter name", [FUNCTION + "void Go(int32 A);"], [FUNCTION + "void Go(int32 Amount);"], [("breaking", "changed", "function", "UGame.Go", "parameter name")]),
    ("parameter gone", [FUNCTION + "void Go(int32 A, float B);"], [FUNCTION + "void Go(int32 A);"], [("breaking", "removed", "parameter", "UGame.Go(B)", "")]),
    ("parameter new", [FUNCTION + "void Go(int32 A);"], [FUNCTION + "void Go(int32 A, float B);"], [("breaking", "added", "parameter", "UGame.Go(B)", "")]),
    ("parameter new, with default", [FUNCTION + "void Go(int32 A);"], [FUNCTION + "void Go(int32 A, float B = 1);"], [("compatible", "added", "parameter", "UGame.Go(B)", "")]),
    ("output instead of input", [FUNCTION + "void Go(int32 A);"], [FUNCTION + "void Go(int32& A);"], [("breaking", "changed", "parameter", "UGame.Go(A)", "direction")]),
    ("const reference is an input", [FUNCTION + "void Go(FVector A);"], [FUNCTION + "void Go(const FVector& A);"], []),
    ("default gone", [FUNCTION + "void Go(int32 A = 1);"], [FUNCTION + "void Go(int32 A);"], [("breaking", "changed", "parameter", "UGame.Go(A)", "default")]),
    ("another default", [FUNCTION + "void Go(int32 A = 1);"], [FUNCTION + "void Go(int32 A = 2);"], [("compatible", "changed", "parameter", "UGame.Go(A)", "default")]),
    ("static", [FUNCTION + "void Go();"], [FUNCTION + "static void Go();"], [("breaking", "changed", "function", "UGame.Go", "flag")]),
    ("property type", ["UPROPERTY() int32 Count;"], ["UPROPERTY() int64 Count;"], [("breaking", "changed", "property", "UGame.Count", "type")]),
    ("property gone", ["UPROPERTY() int32 Count;"], [], [("breaking", "removed", "property", "UGame.Count", "")]),
    ("array", ["UPROPERTY() int32 Count[2];"], ["UPROPERTY() int32 Count[4];"], [("breaking", "changed", "property", "UGame.Count", "array_dim")]),
    ("bit field", ["UPROPERTY() bool bOn;"], ["UPROPERTY() uint8 bOn : 1;"], [("compatible", "changed", "property", "UGame.bOn", "type")]),
    ("comment", ["/** One. */ UPROPERTY() int32 Count;"], ["/** Two. */ UPROPERTY() int32 Count;"], []),
    ("order of members of a class", ["UPROPERTY() int32 A;", "UPROPERTY() int32 B;"], ["UPROPERTY() int32 B;", "UPROPERTY() int32 A;"], []),
]


@pytest.mark.parametrize("old, new, expected", [pytest.param(old, new, expected, id=name) for name, old, new, expected in CASES])
def test_members(dump: Dump, spear_schema: Command, engine_schemas: list[Path], old: list[str], new: list[str], expected: list[tuple[str, ...]]) -> None:
    found = changes_between(dump, spear_schema, in_class(*old), in_class(*new), "--import", engine_schemas[1], "--tier", "editor", code=1 if expected else 0)
    important = [c for c in found if c["facet"] != "flag" or c["severity"] == "breaking"]
    assert [(c["severity"], c["change"], c["kind"], c["subject"], c["facet"]) for c in important] == expected


def test_types(dump: Dump, spear_schema: Command) -> None:
    old = """
UENUM() enum class EMode : uint8 { Slow, Fast, Gone };
USTRUCT() struct FPair { GENERATED_BODY() UPROPERTY() int32 A; UPROPERTY() int32 B; };
USTRUCT() struct FOld { GENERATED_BODY() };
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FOnGame, int32, Number);
UCLASS() class AGameActor : public APawn { GENERATED_BODY() };
UCLASS() class AOther : public APawn { GENERATED_BODY() };
"""
    new = """
UENUM() enum class EMode : uint8 { Slow, Middle, Fast };
USTRUCT() struct FPair { GENERATED_BODY() UPROPERTY() int32 B; UPROPERTY() int32 A; };
DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(FOnGame, int32, Number, bool, bOn);
UCLASS() class AGameActor : public AActor { GENERATED_BODY() };
UCLASS(Abstract) class AMiddle : public APawn { GENERATED_BODY() };
UCLASS() class AOther : public AMiddle { GENERATED_BODY() };
"""
    found = {(c["severity"], c["kind"], c["subject"], c["facet"]) for c in changes_between(dump, spear_schema, old, new, "--tier", "runtime")}
    assert found == {
        ("breaking", "entry", "EMode.Gone", ""), ("compatible", "entry", "EMode.Middle", ""), ("breaking", "entry", "EMode.Fast", "value"), ("breaking", "struct", "FPair", "order"), ("breaking", "struct", "FOld", ""),
        ("breaking", "parameter", "FOnGame(bOn)", ""), ("breaking", "class", "AGameActor", "super"), ("compatible", "class", "AMiddle", ""), ("compatible", "class", "AOther", "super"), ("compatible", "class", "AGameActor", "config"),
    }


def test_moved_up_is_compatible(dump: Dump, spear_schema: Command) -> None:
    base = "UCLASS() class UBase : public UObject {{ GENERATED_BODY() public: {} }};\nUCLASS() class UChild : public UBase {{ GENERATED_BODY() public: {} }};"
    found = changes_between(dump, spear_schema, base.format("", "UPROPERTY() int32 A; UFUNCTION() void F();"), base.format("UPROPERTY() int32 A; UFUNCTION() void F();", ""), "--tier", "runtime")
    assert {(c["severity"], c["subject"], c["new"]) for c in found if c["change"] == "changed"} == {("compatible", "UChild.A", "UBase"), ("compatible", "UChild.F", "UBase")}
    assert all(c["severity"] == "compatible" for c in found)


def test_tiers(dump: Dump, spear_schema: Command) -> None:
    old = in_class("/** One. */", 'UFUNCTION(BlueprintCallable, meta = (DisplayName = "A")) void Go();')
    new = in_class("/** Two. */", 'UFUNCTION(BlueprintCallable, meta = (DisplayName = "B")) void Go();')
    files = dump("old", old), dump("new", new)
    assert spear_schema("diff", *files, "--tier", "runtime").stdout.endswith("no difference to show\n")
    editor = json.loads(spear_schema("diff", *files, "--json", code=1).stdout)["changes"]
    assert [c["facet"] for c in editor] == ["meta DisplayName"]
    source = json.loads(spear_schema("diff", *files, "--tier", "source", "--json", code=1).stdout)["changes"]
    assert {c["facet"] for c in source} == {"meta DisplayName", "meta Comment", "meta ToolTip", "source comment"}


def test_human_text_and_exit_codes(dump: Dump, spear_schema: Command) -> None:
    old, new = dump("old", in_class(FUNCTION + "void Go();", FUNCTION + "void Stay();")), dump("new", in_class(FUNCTION + "void Stay();", FUNCTION + "void Come(int32 A);"))
    text = spear_schema("diff", old, new, code=1).stdout
    assert text.splitlines() == ["Breaking (1)", "  Game", "    - function UGame.Go is gone", "Compatible (1)", "  Game", "    + function UGame.Come is new: void Come(int32 A)",
                                 "1 breaking, 1 compatible: 1 removed, 0 changed, 1 added"]
    assert "\x1b" not in text  # colours on a terminal alone
    assert "Compatible" not in spear_schema("diff", old, new, "--only", "breaking", code=1).stdout
    assert "Breaking" not in spear_schema("diff", old, new, "--only", "added", code=1).stdout
    spear_schema("diff", old, new, "--only", "changed", code=0)
    spear_schema("diff", old, old, code=0)
    assert "UGame.Go" in spear_schema("diff", "-", new, code=1, stdin=old.read_text()).stdout
    spear_schema("diff", old, new, "--module", "Other", code=0)


def test_trouble_has_its_own_exit_code(dump: Dump, spear_schema: Command, tmp_path: Path) -> None:
    good = dump("old", in_class())
    cut = tmp_path / "cut.json"
    cut.write_text(good.read_text()[:500])
    for bad, word in ((cut, "cut short"), (tmp_path / "none.json", "does not exist"), (tmp_path, "is a folder")):
        result = spear_schema("diff", good, bad, code=2)
        assert word in result.stderr and str(bad) in result.stderr and not result.stdout
    assert "only once" in spear_schema("diff", "-", "-", code=2, stdin="{}").stderr


def test_engine_against_itself_with_one_change(spear_schema: Command, engine_schemas: list[Path], tmp_path: Path) -> None:
    """At the size of a real module nothing else is found than what was changed."""
    document = json.loads(engine_schemas[1].read_text())
    actor = next(c for c in document["classes"] if c["name"] == "AActor")
    actor["functions"] = [f for f in actor["functions"] if f["name"] != "K2_GetActorLocation"]
    changed = tmp_path / "changed.json"
    changed.write_text(json.dumps(document))
    assert "function AActor.K2_GetActorLocation is gone" in spear_schema("diff", engine_schemas[1], changed, "--tier", "source", code=1).stdout
    assert spear_schema("diff", engine_schemas[1], changed, "--tier", "source", code=1).stdout.count("\n") == 4


def test_colours_on_a_terminal(dump: Dump) -> None:
    from click.testing import CliRunner

    from spear.cli.schema import schema

    old, new = dump("old", in_class(FUNCTION + "void Go();")), dump("new", in_class(FUNCTION + "void Come();"))
    result = CliRunner().invoke(schema, ["diff", str(old), str(new)], color=True)
    assert result.exit_code == 1
    assert "\x1b[31m    - \x1b[0m" in result.output and "\x1b[32m    + \x1b[0m" in result.output
