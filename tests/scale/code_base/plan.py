# SPDX-License-Identifier: MIT
"""What goes where: modules, headers, classes and how many members each gets."""

from __future__ import annotations

import random

from .model import ClassType, Header, Module, Style
from .vocabulary import ACTOR_SUFFIXES, COMPONENT_SUFFIXES, MODULES, NOUNS, OBJECT_SUFFIXES, QUALIFIERS

HEADER_KINDS = [("actor", 20), ("component", 19), ("object", 24), ("types", 24), ("interface", 4), ("library", 4), ("enums", 5)]
SUFFIXES = {"actor": ACTOR_SUFFIXES, "component": COMPONENT_SUFFIXES, "object": OBJECT_SUFFIXES, "types": ["Types", "Structs", "Data", "Definitions"], "interface": ["Interface", "Receiver", "Provider"],
            "library": ["Library", "FunctionLibrary", "Statics", "BlueprintLibrary"], "enums": ["Enums", "Constants", "Types"]}

#: The longest hierarchy: eight classes, each with so many functions and properties, so that the last inherits over 1,000 members.
CHAIN = [(50, 80), (60, 100), (50, 90), (70, 120), (60, 90), (60, 100), (60, 90), (30, 40)]
CHAIN_NAMES = ["Being", "Animal", "Creature", "Beast", "Predator", "Dragon", "ElderDragon", "AncientDragon"]
LIBRARY_FUNCTIONS = 420
#: Type names that the engine has, lower case, without prefix.
ENGINE_TYPES = {"cameracomponent", "cameraactor", "cameratypes", "timerhandle", "worldsettings"}


def styles(r: random.Random, compilable: bool) -> Style:
    """How the team that owns one header formats it."""
    old = r.random() < 0.08
    return Style(indent=r.choice(["\t", "\t", "    ", "  "]), brace_below=r.random() < 0.75, one_line_properties=r.random() < 0.1, object_pointers=not old and r.random() < 0.7, old_bodies=old,
                 comment=r.choices(["block", "line", "star_less"], [75, 20, 5])[0], crlf=r.random() < 0.1, bom=r.random() < 0.03)


def apportion(r: random.Random, total: int, weights: list[float]) -> list[int]:
    """`total` things over as many places as there are weights, to the last one."""
    whole = sum(weights)
    if not whole:
        return [0] * len(weights)
    exact = [total * w / whole for w in weights]
    out = [int(x) for x in exact]
    order = sorted(range(len(out)), key=lambda i: exact[i] - out[i], reverse=True)
    for i in order[: total - sum(out)]:
        out[i] += 1
    return out


def make_headers(r: random.Random, modules: list[Module], count: int, functions: int, properties: int, compilable: bool) -> list[Header]:
    """Empty headers with their share of functions and properties, in order of dependency."""
    per_module = apportion(r, count, [MODULES[m.name][0] for m in modules])
    headers: list[Header] = []
    for module, number in zip(modules, per_module, strict=True):
        taken: set[str] = set(ENGINE_TYPES)
        layout = r.choice(["Public", "Public", "Classes", "flat"]) if not compilable else "Public"
        for i in range(number):
            kind = "enums" if i == 0 else "types" if i == 1 else r.choices([k for k, _ in HEADER_KINDS], [w for _, w in HEADER_KINDS])[0]
            topic = r.choice(module.topics)
            for attempt in range(1000):
                first = r.choice([topic, topic, module.name if attempt == 0 and not i else topic])
                stem = first + (r.choice(NOUNS) if r.random() < 0.8 or attempt > 3 else "") + (r.choice(QUALIFIERS) if attempt > 8 else "") + r.choice(SUFFIXES[kind])
                if stem.lower() not in taken:
                    break
            taken.add(stem.lower())
            below = topic if r.random() < 0.75 else ""
            if layout == "flat":
                folder = below
            else:
                first = "Private" if kind in ("object", "component") and r.random() < 0.04 and not compilable else layout
                folder = f"{first}/{below}" if below else first
            headers.append(Header(module, folder, stem, kind, topic, 0, 0, styles(r, compilable), serial=len(headers)))
    _share_out(r, headers, functions, properties)
    return headers


def _share_out(r: random.Random, headers: list[Header], functions: int, properties: int) -> None:
    special = [h for h in headers if h.kind == "actor" and h.module.name == "BigCharacter"][: len(CHAIN)]
    scale = min(1.0, functions * 0.1 / sum(f for f, _ in CHAIN), properties * 0.1 / sum(p for _, p in CHAIN))
    if len(special) == len(CHAIN):
        for header, (f, p), name in zip(special, CHAIN, CHAIN_NAMES, strict=True):
            header.kind, header.stem, header.folder = "chain", name, header.folder
            header.functions, header.properties = int(f * scale), int(p * scale)
    else:
        special = []
    library = next((h for h in headers if h.kind == "library"), None)
    if library:
        library.functions = min(LIBRARY_FUNCTIONS, functions // 20)
        special.append(library)
    rest = [h for h in headers if h not in special]
    weight_f = [{"actor": 1.0, "component": 1.0, "object": 0.6, "interface": 0.5, "library": 2.5}.get(h.kind, 0.0) * r.lognormvariate(0, 0.8) for h in rest]
    weight_p = [{"actor": 1.0, "component": 1.0, "object": 0.9, "types": 1.3}.get(h.kind, 0.0) * r.lognormvariate(0, 0.8) for h in rest]
    for h, n in zip(rest, apportion(r, max(0, functions - sum(h.functions for h in special)), weight_f), strict=True):
        h.functions = n
    for h, n in zip(rest, apportion(r, max(0, properties - sum(h.properties for h in special)), weight_p), strict=True):
        h.properties = n


ENGINE_BASES = {"actor": ["AActor", "AActor", "AActor", "APawn", "AInfo"], "component": ["UActorComponent", "UActorComponent", "USceneComponent", "USceneComponent", "UStaticMeshComponent"],
                "object": ["UObject", "UObject", "UObject", "UWorldSubsystem", "UGameInstanceSubsystem"]}
UNKNOWN_BASES = {"actor": ["ACharacter"], "component": ["UCharacterMovementComponent"], "object": ["UDataAsset", "UPrimaryDataAsset", "UUserWidget", "UDeveloperSettings", "UAnimInstance"]}
SUBSYSTEMS = 12  # every one is created when a world starts


def choose_parent(r: random.Random, modules: list[Module], header: Header, kind: str, compilable: bool, made: dict[str, int]) -> tuple[ClassType | None, str]:
    """A class of the code base to derive from, or the name of one of the engine."""
    if r.random() < 0.45:
        reachable = [c for m in modules[: header.module.index + 1] for c in m.classes[-40:] if c.kind == kind and c.depth < 8 and not c.name.endswith("Dragon")]
        if reachable:
            parent = r.choice(reachable)
            return parent, parent.name
    if not compilable and r.random() < 0.2:
        return None, r.choice(UNKNOWN_BASES[kind])
    base = r.choice(ENGINE_BASES[kind])
    if base.endswith("Subsystem"):
        if made.get("subsystems", 0) >= SUBSYSTEMS:
            return None, "UObject"
        made["subsystems"] = made.get("subsystems", 0) + 1
    return None, base
