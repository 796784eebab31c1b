# SPDX-License-Identifier: MIT
"""The schema's types against the compiler's, for every property, parameter, return value, entry and base class of our own modules."""

from __future__ import annotations

import copy
import json
import shlex
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

import type_checks  # noqa: E402

#: Module -> the fewest assertions that its check must have, so that an empty one is no success.
MODULES = {"CoreUObject": 110, "Engine": 7000, "SpearServer": 5, "RoundTrip": 700, "Door": 10, "ReflectionTest": 300, "EngineTestTypes": 30}


def schema_of(build: Path, module: str) -> dict[str, Any]:
    return dict(json.loads((build / "codegen" / module / f"{module}.schema.json").read_text(encoding="utf-8")))


def compiler_command(build: Path, module: str) -> list[str]:
    """How the module's own generated sources are compiled, without their warnings and output; private members can be named."""
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    words = next(shlex.split(c["command"]) for c in commands if f"SpearUE-{module}-gen.dir" in c["command"])
    compiler = next(i for i, word in enumerate(words) if Path(word).name.split("-")[0] in ("c++", "g++", "clang++"))
    kept: list[str] = []
    for i, word in enumerate(words):
        if word.startswith(("-I", "-D", "-std", "-f", "-stdlib")) and "sanitize" not in word:
            kept.append(word)
        elif word in ("-isystem", "-include") and words[i + 1].endswith(("include", "/")):
            kept += words[i : i + 2]
    return [words[compiler], "-fsyntax-only", "-fno-access-control", "-w", *kept]


def compile_checks(build: Path, module: str, document: dict[str, Any], folder: Path) -> tuple[int, str, int]:
    """(exit code, the compiler's messages, number of assertions)."""
    imports = [schema_of(build, m) for m in ("CoreUObject", "Engine") if m != module]
    text, count = type_checks.write(document, imports)
    file = folder / f"{module}.checks.cpp"
    file.write_text(text, encoding="utf-8")
    result = subprocess.run([*compiler_command(build, module), str(file)], capture_output=True, text=True, check=False, cwd=build)
    return result.returncode, result.stderr, count


@pytest.mark.parametrize("module", MODULES)
def test_schema_has_the_compilers_types(build_directory: Path, tmp_path: Path, module: str) -> None:
    code, messages, count = compile_checks(build_directory, module, schema_of(build_directory, module), tmp_path)
    assert code == 0, "\n".join(line for line in messages.splitlines() if "error" in line)[:4000]
    assert count >= MODULES[module]


def _class(document: dict[str, Any], name: str) -> Any:
    return next(c for kind in ("classes", "structs", "enums") for c in document[kind] if c["name"] == name)


def _function(document: dict[str, Any], owner: str, name: str) -> Any:
    return next(f for f in _class(document, owner)["functions"] if f["name"] == name)


def _property(document: dict[str, Any], owner: str, name: str) -> Any:
    return next(p for p in _class(document, owner)["properties"] if p["name"] == name)


MUTATIONS: dict[str, tuple[Callable[[Any], Any], str]] = {
    "return node": (lambda d: _function(d, "URoundTrip", "EchoDouble")["returns"]["type"].update(kind="float", cpp="float"), "URoundTrip.EchoDouble: the return value means float"),
    "return text": (lambda d: _function(d, "URoundTrip", "EchoDouble")["returns"]["source"].update(type_text="float"), "EchoDouble"),
    "parameter node": (lambda d: _function(d, "URoundTrip", "EchoVector")["parameters"][0]["type"].update(name="FRotator", cpp="FRotator"), "URoundTrip.EchoVector(Value) means FRotator"),
    "parameter text": (lambda d: _function(d, "URoundTripCalls", "Length")["parameters"][0]["source"].update(type_text="FVector&"), "Length"),
    "parameter gone": (lambda d: _function(d, "URoundTripCalls", "Needed")["parameters"].pop(), "Needed"),
    "static": (lambda d: _function(d, "URoundTripCalls", "Add")["source"].update(static=False), "Add"),
    "property node": (lambda d: _property(d, "URoundTrip", "StringMapValue")["type"]["value"].update(kind="int64", cpp="int64"), "URoundTrip.StringMapValue means TMap<FString, int64>"),
    "property text": (lambda d: _property(d, "URoundTrip", "ObjectValue")["source"].update(type_text="UObject*"), "URoundTrip.ObjectValue: UObject*"),
    "bit field": (lambda d: _property(d, "URoundTrip", "bBitOne")["source"].update(type_text="uint32"), "URoundTrip.bBitOne is a bit field"),
    "array": (lambda d: _property(d, "URoundTrip", "FixedValue").update(array_dim=5), "URoundTrip.FixedValue"),
    "int silently": (lambda d: _property(d, "URoundTrip", "VectorValue").update(type={"kind": "int32", "cpp": "int32"}), "URoundTrip.VectorValue means int32"),
    "enum value": (lambda d: _class(d, "ERoundTripMode")["entries"][2].update(value=2), "ERoundTripMode::Reckless is 2"),
    "super": (lambda d: _class(d, "URoundTripCallsChild").update(super="URoundTrip"), "URoundTripCallsChild: super"),
    "interface": (lambda d: _class(d, "URoundTripCalls").update(interfaces=["IRoundTripListener"]), "URoundTripCalls: implements IRoundTripListener"),
}


@pytest.mark.parametrize("mutation", MUTATIONS)
def test_a_wrong_schema_does_not_compile(build_directory: Path, tmp_path: Path, mutation: str) -> None:
    """Each kind of mistake is seen, and named."""
    change, expected = MUTATIONS[mutation]
    document = copy.deepcopy(schema_of(build_directory, "RoundTrip"))
    change(document)
    code, messages, _ = compile_checks(build_directory, "RoundTrip", document, tmp_path)
    assert code != 0, f"a schema with another {mutation} compiled"
    assert expected in messages, messages[:3000]
