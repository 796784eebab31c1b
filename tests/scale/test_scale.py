# SPDX-License-Identifier: MIT
"""The synthetic code base is what it claims to be, and the tools hold their bars on it."""

from __future__ import annotations

import filecmp
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).resolve().parent


def make(target: Path, *options: str) -> dict[str, Any]:
    """Runs the generator; what it says it made."""
    subprocess.run([sys.executable, str(HERE / "make_code_base.py"), "-o", str(target), *options], check=True, capture_output=True)
    return dict(json.loads((target / ".synthetic-code-base.json").read_text()))


def files(folder: Path) -> list[Path]:
    return sorted(f.relative_to(folder) for f in folder.rglob("*") if f.is_file())


SMALL = ["--headers", "120", "--functions", "700", "--properties", "2400"]


def dump(build: Path, base: Path, target: Path, *options: str | Path) -> Any:
    imports = [part for m in ("CoreUObject", "Engine") for part in ("--import", str(build / "codegen" / m / f"{m}.schema.json"))]
    command = [str(build / "bin" / "spear-header-tool"), "dump", "--quiet", "--no-cache", "--module", str(base), *imports, *map(str, options), "-o", str(target)]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr[-3000:]
    return json.loads(target.read_text())


@pytest.mark.parametrize("options", [[], ["--compilable"]], ids=["any", "compilable"])
def test_same_arguments_same_files(tmp_path: Path, options: list[str]) -> None:
    first, second, other = tmp_path / "first", tmp_path / "second", tmp_path / "other"
    made = make(first, *SMALL, *options)
    assert made == make(second, *SMALL, *options) == make(second, *SMALL, *options)  # also over itself
    assert files(first) == files(second) and all(filecmp.cmp(first / f, second / f, shallow=False) for f in files(first))
    assert made["headers"] == 120 and made["functions"] >= 700 and made["properties"] >= 2400
    make(other, *SMALL, *options, "--seed", "2")
    assert files(other) != files(first)


def test_never_over_somebody_elses_files(tmp_path: Path) -> None:
    (tmp_path / "precious.txt").write_text("kept")
    result = subprocess.run([sys.executable, str(HERE / "make_code_base.py"), *SMALL, "-o", str(tmp_path)], capture_output=True, text=True, check=False)
    assert result.returncode == 2 and "not written by this program" in result.stderr and (tmp_path / "precious.txt").read_text() == "kept"


def test_schema_has_what_was_made(build_directory: Path, tmp_path: Path) -> None:
    made = make(tmp_path / "base", *SMALL)
    schema = dump(build_directory, tmp_path / "base", tmp_path / "schema.json", "--report", tmp_path / "report.json")
    assert sum(len(c["functions"]) for c in schema["classes"]) == made["functions"]
    assert sum(len(t["properties"]) for t in schema["classes"] + schema["structs"]) == made["properties"]
    assert {k: len(schema[k]) for k in ("classes", "structs", "enums", "delegates", "modules")} == {k: made[k] for k in ("classes", "structs", "enums", "delegates", "modules")}
    # What is unknown here is unknown on purpose (no engine has it); nothing was lost or guessed besides.
    report = json.loads((tmp_path / "report.json").read_text())
    assert set(report["counts"]) <= {"assumed-type", "unresolved-type", "unresolved-super", "prefix"}, report["counts"]
    assert report["ast"]["missing"] == 0


def test_compilable_keeps_unreals_rules(build_directory: Path, tmp_path: Path) -> None:
    make(tmp_path / "base", *SMALL, "--compilable")
    dump(build_directory, tmp_path / "base", tmp_path / "schema.json", "--strict", "--report", tmp_path / "report.json")
    assert json.loads((tmp_path / "report.json").read_text())["entries"] == []
    assert "spear_unreal_module(NAME BigCore" in (tmp_path / "base" / "CMakeLists.txt").read_text()


def test_compilable_hides_no_member(build_directory: Path, tmp_path: Path) -> None:
    """Neither Unreal's header tool nor -Wshadow takes a parameter with the name of a variable of its class, inherited or of the engine; crowded classes show it."""
    make(tmp_path / "base", "--headers", "60", "--functions", "6000", "--properties", "6000", "--compilable")
    schema = dump(build_directory, tmp_path / "base", tmp_path / "schema.json")
    classes = {c["name"]: c for m in ("CoreUObject", "Engine") for c in json.loads((build_directory / "codegen" / m / f"{m}.schema.json").read_text())["classes"]}
    classes |= {c["name"]: c for c in schema["classes"]}
    for class_ in schema["classes"]:
        names: set[str] = {"bounds"}  # a variable of USceneComponent that is not reflected
        functions: list[str] = []
        at: Any = class_
        while at:
            names |= {p["name"].lower() for p in at["properties"]}
            functions += [f["name"].lower() for f in at["functions"]]
            at = classes.get(at["super"])
        assert len(functions) == len(set(functions)), f"{class_['name']} has a function twice"
        for function in class_["functions"]:
            hidden = names & {p["name"].lower() for p in function["parameters"]}
            assert not hidden, f"{class_['name']}::{function['name']}: {hidden}"
    arrays = {p["name"] for c in schema["classes"] for p in c["properties"] if p["array_dim"] > 1}
    assert arrays and not [p["name"] for c in schema["classes"] for p in c["properties"] if p["array_dim"] > 1 and (p.get("native_getter") or p.get("native_setter"))]


def test_shapes_of_the_full_code_base(scale_schema: Path) -> None:
    """Large where real code is large: a deep hierarchy, a class with over 1,000 inherited members, a library with hundreds of functions."""
    schema = json.loads(scale_schema.read_text(encoding="utf-8"))
    classes = {c["name"]: c for c in schema["classes"]}

    def chain(name: str) -> list[dict[str, Any]]:
        found = []
        while name in classes:
            found.append(classes[name])
            name = classes[name]["super"]
        return found

    depth = {name: len(chain(name)) for name in classes}
    members = {name: sum(len(c["functions"]) + len(c["properties"]) for c in chain(name)) for name in classes}
    headers = sum(len(m["source"]["headers"]) for m in schema["modules"])
    assert headers >= 3000 and sum(len(c["functions"]) for c in schema["classes"]) >= 15000
    assert sum(len(t["properties"]) for t in schema["classes"] + schema["structs"]) >= 55000
    assert max(depth.values()) >= 8 and max(members.values()) - len(classes["AAncientDragon"]["functions"]) >= 1000
    assert max(len(c["functions"]) for c in schema["classes"]) >= 400
    functions = [f for c in schema["classes"] for f in c["functions"]]
    flags = {flag for f in functions for flag in f["flags"]}
    assert {"Static", "Net", "NetServer", "NetClient", "NetMulticast", "NetValidate", "BlueprintEvent", "Exec", "Const", "BlueprintPure", "HasOutParms", "Private", "Protected", "EditorOnly"} <= flags
    meta = {key for f in functions for key in f["editor"]["meta"]}
    assert {"WorldContext", "Latent", "DeterminesOutputType", "AutoCreateRefTerm", "DeprecatedFunction", "CompactNodeTitle", "CallInEditor", "Comment"} <= meta
    kinds = {p["type"]["kind"] for t in schema["classes"] + schema["structs"] for p in t["properties"]}
    assert kinds >= {"bool", "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64", "float", "double", "string", "name", "text", "enum", "byte_enum", "object", "class", "weak_object", "lazy_object",
                     "soft_object", "soft_class", "interface", "struct", "array", "set", "map", "optional", "delegate", "multicast_delegate"}
    assert {e["form"] for e in schema["enums"]} == {"class", "regular", "namespaced"} and any("Flags" in e["flags"] for e in schema["enums"])
    names = {f["name"] for f in functions} | {p["name"] for t in schema["classes"] + schema["structs"] for p in t["properties"]}
    assert names >= {"lambda", "def", "pass", "get", "set", "async_", "send_"}


def test_bars(build_directory: Path, tmp_path: Path) -> None:
    """The bars are times on two free cores. Where others keep the machine busy, processor time on two cores has to hold them instead."""
    busy = os.getloadavg()[0] > 1.0
    figures = tmp_path / "figures.json"
    result = subprocess.run([sys.executable, str(HERE / "measure.py"), "--build", str(build_directory), "--work", str(tmp_path / "work"), "--json", str(figures)], capture_output=True, text=True, check=False)
    print(result.stdout)
    assert result.returncode == 0, result.stdout + result.stderr
    document = json.loads(figures.read_text())
    for bar in document["bars"]:
        value = bar["value"]
        if busy and bar["unit"] == "s":
            value = min(value, bar["processor_value"] / 2)
        assert value <= bar["limit"], f"{bar['name']}: {value:.1f} {bar['unit']}, at most {bar['limit']}\n{result.stdout}"
