# SPDX-License-Identifier: MIT
"""Writes the whole code base: headers, sources, Build.cs, .uplugin and, if it is to be compiled, the CMake glue."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from pathlib import Path

from .headers import Writer
from .model import ClassType, Header, Module
from .plan import ENGINE_TYPES, choose_parent, make_headers
from .types import ENGINE_INCLUDES, Types, visible
from .vocabulary import ENGINE_MEMBERS, MODULES


def build(target: Path, headers: int, functions: int, properties: int, seed: int, compilable: bool, progress: Callable[[int, int], None] = lambda done, total: None) -> dict[str, int]:
    """Writes the code base below `target` and gives what it made."""
    r = random.Random(seed)
    modules = [Module(name, topics, i) for i, (name, (_, topics)) in enumerate(MODULES.items())]
    planned = make_headers(r, modules, headers, functions, properties, compilable)
    types = Types(r, modules, compilable)
    type_names = {h.stem.lower() for h in planned} | ENGINE_TYPES
    writer = Writer(r, types, type_names, compilable)
    used: dict[str, int] = {}
    chain: ClassType | None = None
    longest = 0
    for number, header in enumerate(planned):
        header.module.headers.append(header)
        lines, class_ = _header(r, writer, modules, header, chain, used, compilable)
        if header.kind == "chain":
            chain = class_
        if class_:
            longest = max(longest, class_.members)
        _save(target, header, lines, compilable)
        progress(number + 1, len(planned))
    modules = [m for m in modules if m.headers]
    for module in modules:
        _module_files(target, module, modules, compilable)
    (target / "BigBase.uplugin").write_text(json.dumps({"FileVersion": 3, "VersionName": "1.0", "FriendlyName": "Big base", "Description": "A synthetic code base.",
        "Modules": [{"Name": m.name, "Type": "Runtime", "LoadingPhase": "Default"} for m in modules]}, indent=4) + "\n")
    if compilable:
        (target / "CMakeLists.txt").write_text(_cmake(modules))
    return {"headers": len(planned), "modules": len(modules), "functions": writer.made_functions, "properties": writer.made_properties, "classes": sum(len(m.classes) + len(m.interfaces) for m in modules),
            "structs": sum(len(m.structs) for m in modules), "enums": sum(len(m.enums) for m in modules), "delegates": sum(len(m.delegates) for m in modules), "largest_class_members": longest}


def _header(r: random.Random, writer: Writer, modules: list[Module], header: Header, chain: ClassType | None, used: dict[str, int], compilable: bool) -> tuple[list[str], ClassType | None]:
    lines: list[str] = []
    kind = header.kind
    properties = header.properties
    if kind == "enums":
        for _ in range(r.randint(2, 7)):
            lines += writer.enum(header)
        return lines, None
    if kind == "types":
        for _ in range(r.choice([0, 0, 1, 2])):
            lines += writer.enum(header)
        while properties > 0:
            count = min(properties, max(2, int(r.lognormvariate(1.9, 0.6))))
            properties -= count
            lines += writer.struct(header, count)
        if r.random() < 0.3:
            lines += writer.delegate(header, None)
        return lines, None
    if kind == "interface":
        found = ClassType("U" + header.stem, header, "interface", None, "UInterface")
        lines += writer.interface(header, found, header.functions)
        return lines, None
    for _ in range(r.choice([0, 0, 0, 1, 1, 2])):
        lines += writer.enum(header)
    if kind != "library":
        for _ in range(r.choice([0, 0, 0, 1, 1, 2])):
            count = min(properties // 2, r.randint(2, 9))
            if count > 0:
                properties -= count
                lines += writer.struct(header, count)
        for _ in range(r.choice([0, 0, 0, 1, 1, 2, 3])):
            lines += writer.delegate(header, None)
    found = _class(r, modules, header, chain, used, compilable)
    found.members += header.functions + properties + (found.parent.members if found.parent else 0)
    lines += writer.class_(header, found, header.functions, properties)
    return lines, found


def _class(r: random.Random, modules: list[Module], header: Header, chain: ClassType | None, used: dict[str, int], compilable: bool) -> ClassType:
    kind = {"chain": "actor"}.get(header.kind, header.kind)
    prefix = "A" if kind == "actor" else "U"
    name = prefix + header.stem
    if kind == "library":
        found = ClassType(name, header, kind, None, "UBlueprintFunctionLibrary")
    elif header.kind == "chain":
        found = ClassType(name, header, kind, chain, chain.name if chain else "APawn")
    else:
        parent, base = choose_parent(r, modules, header, kind, compilable, used)
        found = ClassType(name, header, kind, parent, base)
    if found.parent:
        found.depth = found.parent.depth + 1
        found.names = set(found.parent.names)
        if found.parent.header is not header:
            header.includes.add(found.parent.header.include)
    else:
        found.names = set(ENGINE_MEMBERS)
        if found.base in ENGINE_INCLUDES:
            header.includes.add(ENGINE_INCLUDES[found.base])
    found.names.add(header.stem.lower())
    found.old_body = header.style.old_bodies and kind != "library" and "initializer" in found.super_constructors
    if kind in ("actor", "component", "object") and r.random() < 0.15:
        interface = visible(r, modules, header.module, "interfaces")
        inherited = _ancestors(found)
        if isinstance(interface, ClassType) and not any("I" + interface.name[1:] in c.interfaces for c in inherited) and not (interface.names & found.names):
            found.interfaces.append("I" + interface.name[1:])
            found.names |= interface.names
            header.includes.add(interface.header.include)
    return found


def _ancestors(class_: ClassType) -> list[ClassType]:
    found = []
    parent = class_.parent
    while parent:
        found.append(parent)
        parent = parent.parent
    return found


def _save(target: Path, header: Header, lines: list[str], compilable: bool) -> None:
    own = {c.name for c in header.module.classes if c.header is header}
    top = ["// Copyright Big Base. A synthetic code base, made by tests/scale/make_code_base.py: do not edit.", "", "#pragma once", ""]
    top += ['#include "CoreMinimal.h"', *(f'#include "{i}"' for i in sorted(header.includes)), f'#include "{header.stem}.generated.h"', ""]
    forwards = sorted(header.forwards - own)
    if forwards:
        top += [*(f"class {name};" for name in forwards), ""]
    text = "\n".join([*top, *lines]).rstrip("\n") + "\n"
    if header.style.crlf:
        text = text.replace("\n", "\r\n")
    path = target / "Source" / header.module.name / header.path
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes((b"\xef\xbb\xbf" if header.style.bom else b"") + text.encode())
    if compilable and header.source:
        source = target / "Source" / header.module.name / "Private" / (header.stem + ".cpp")
        source.parent.mkdir(parents=True, exist_ok=True)
        # Bodies pass incomplete types on by pointer only; what they return or take by value needs nothing else.
        source.write_text(f'#include "{header.include}"\n\n' + "\n".join(header.source) + "\n")


def _module_files(target: Path, module: Module, modules: list[Module], compilable: bool) -> None:
    folder = target / "Source" / module.name
    dependencies = ["Core", "CoreUObject", "Engine", *(m.name for m in modules[: module.index])]
    listed = ", ".join(f'"{name}"' for name in dependencies)
    (folder / f"{module.name}.Build.cs").write_text(
        f"using UnrealBuildTool;\n\npublic class {module.name} : ModuleRules\n{{\n\tpublic {module.name}(ReadOnlyTargetRules Target) : base(Target)\n\t{{\n"
        f"\t\tPCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;\n\t\tPublicDependencyModuleNames.AddRange(new string[] {{ {listed} }});\n\t}}\n}}\n")
    private = folder / "Private"
    private.mkdir(parents=True, exist_ok=True)
    (private / f"{module.name}Module.cpp").write_text(f'#include "Modules/ModuleManager.h"\n\nIMPLEMENT_MODULE(FDefaultModuleImpl, {module.name})\n')


def _cmake(modules: list[Module]) -> str:
    lines = ["# Registers the synthetic code base in the embedded engine: add_subdirectory(DIR ${CMAKE_BINARY_DIR}/big_base) from the engine's own build,",
             "# behind the engine's modules. Load it with --plugin-dir <build>/big_base_plugins."]
    for module in modules:
        dependencies = " ".join(["Core", "CoreUObject", "Engine", *(m.name for m in modules[: modules.index(module)])])
        lines += [f'spear_unreal_module(NAME {module.name} DIRECTORY "${{CMAKE_CURRENT_SOURCE_DIR}}/Source/{module.name}" DEPENDS {dependencies})',
                  f"set_target_properties(SpearUE-{module.name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 40)"]
    lines.append('configure_file(BigBase.uplugin "${CMAKE_BINARY_DIR}/big_base_plugins/BigBase/BigBase.uplugin" COPYONLY)')
    return "\n".join(lines) + "\n"
