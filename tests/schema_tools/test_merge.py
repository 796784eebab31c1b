# SPDX-License-Identifier: MIT
"""`spear schema merge`: several files as one, and the facts of headers over what a real engine says."""

from __future__ import annotations

import json
from pathlib import Path

import helpers
import pytest
from schema_commands import Command, Dump, load

GAME = "UCLASS() class UGame : public UObject { GENERATED_BODY() public: /** Speed in cm/s. */ UPROPERTY(EditAnywhere) float Speed = 3.f; UFUNCTION() void Go(int32 Amount = 2); };"


def live_of(offline: Path, target: Path) -> dict:  # type: ignore[type-arg]
    """What a running engine would say of a dump: no source tier."""
    document = helpers.without_source(load(offline))
    document["origin"] = "live"
    target.write_text(json.dumps(document))
    return dict(document)


def test_modules_are_put_together(spear_schema: Command, engine_schemas: list[Path], dump: Dump, tmp_path: Path) -> None:
    result = spear_schema("merge", *engine_schemas, dump("game", GAME), "-o", "all.json")
    merged = load(tmp_path / "all.json")
    assert [m["name"] for m in merged["modules"]] == ["CoreUObject", "Engine", "Game"] and merged["origin"] == "offline"
    assert "0 conflicts" in result.stderr
    for kind in ("classes", "structs", "enums", "delegates"):
        assert len(merged[kind]) == sum(len(load(f)[kind]) for f in [*engine_schemas, tmp_path / "game.json"])
        assert merged[kind] == sorted(merged[kind], key=lambda e: (e["name"], e["path"]))
    assert "a good schema" in spear_schema("check", "all.json").stdout
    assert spear_schema("merge", *engine_schemas).stdout == spear_schema("merge", *reversed(engine_schemas)).stdout


def test_source_over_live(spear_schema: Command, dump: Dump, tmp_path: Path) -> None:
    offline = dump("game", GAME)
    live_of(offline, tmp_path / "live.json")
    for order in (["live.json", "game.json"], ["game.json", "live.json"]):
        spear_schema("merge", *order, "-o", "merged.json", "--strict")
        merged = load(tmp_path / "merged.json")
        assert merged["origin"] == "merged"
        assert {k: v for k, v in merged.items() if k != "origin"} == {k: v for k, v in load(offline).items() if k != "origin"}
        assert "a good schema" in spear_schema("check", "merged.json").stdout


def test_live_wins_and_says_so(spear_schema: Command, dump: Dump, tmp_path: Path) -> None:
    offline = dump("game", GAME)
    live = live_of(offline, tmp_path / "live.json")
    game = live["classes"][0]
    game["properties"][0]["type"] = {"kind": "double", "cpp": "double"}
    game["functions"] = []
    (tmp_path / "live.json").write_text(json.dumps(live))
    result = spear_schema("merge", "live.json", offline, "-o", "merged.json", "--report", "conflicts.json")
    merged = load(tmp_path / "merged.json")["classes"][0]
    assert merged["properties"][0]["type"]["kind"] == "double" and merged["functions"] == []
    assert merged["properties"][0]["source"]["comment"] == "/** Speed in cm/s. */"
    conflicts = {c["subject"]: c for c in load(tmp_path / "conflicts.json")["conflicts"]}
    assert set(conflicts) == {"UGame.Speed: type", "UGame.Go"}
    speed = conflicts["UGame.Speed: type"]
    assert (speed["winner"], speed["winner_origin"], speed["loser"], speed["loser_origin"]) == ("live.json", "live", str(offline), "offline")
    assert "UGame.Speed: type: live.json (live) says double" in result.stderr and "says float" in result.stderr
    (tmp_path / "merged.json").unlink()
    assert "2 conflicts" in spear_schema("merge", "live.json", offline, "-o", "merged.json", "--strict", code=1).stderr
    assert not (tmp_path / "merged.json").exists()


def test_later_of_two_offline_files_wins(spear_schema: Command, dump: Dump, tmp_path: Path) -> None:
    old, new = dump("old", GAME), dump("new", GAME.replace("float Speed = 3.f", "double Speed = 3.0"))
    assert load(tmp_path / "old.json")["classes"][0]["properties"][0]["type"]["kind"] == "float"
    result = spear_schema("merge", old, new, "-o", "merged.json")
    assert load(tmp_path / "merged.json")["classes"][0]["properties"][0]["type"]["kind"] == "double"
    assert "UGame.Speed: type" in result.stderr


@pytest.fixture(scope="module")
def live_engine(build_directory: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What a real engine process says, read by the program itself."""
    folder = tmp_path_factory.mktemp("live")
    run = Command(build_directory, folder)
    with helpers.running_engine(build_directory) as address:
        run("live", address, "-o", "live.json")
        assert "no module 'NoSuch'" in run("live", address, "-m", "NoSuch", "-o", "live.json", code=1).stderr  # and the file stays as it was
    assert "a good schema" in run("check", "live.json").stdout
    return folder / "live.json"


def test_headers_over_a_real_engine(spear_schema: Command, engine_schemas: list[Path], live_engine: Path, tmp_path: Path) -> None:
    """Offline and live agree, so the merge is the offline dump for its modules, and what only the engine has beside it."""
    result = spear_schema("merge", live_engine, *engine_schemas, "-o", "merged.json", "--report", "conflicts.json")
    assert load(tmp_path / "conflicts.json")["conflicts"] == [], result.stderr
    merged, live = load(tmp_path / "merged.json"), load(live_engine)
    assert [m["name"] for m in merged["modules"]] == [m["name"] for m in live["modules"]]
    assert helpers.without_source(merged) == helpers.without_source(live)
    offline = {e["name"]: e for f in engine_schemas for e in load(f)["classes"]}
    classes = {e["name"]: e for e in merged["classes"]}
    assert len(offline) > 70 and all(classes[name] == entity for name, entity in offline.items())
    assert "source" not in classes["USpearServerSettings"] if "USpearServerSettings" in classes else True
    assert "a good schema" in spear_schema("check", "merged.json").stdout
    spear_schema("diff", live_engine, "merged.json", code=0)
