# SPDX-License-Identifier: MIT
"""Several schemas made one: engine, plugins and project; headers' facts (source tier) laid over what a running engine says.

For a type that several documents describe, a live dump decides what exists and what the runtime tier says; the editor and source tiers come from whoever
has them. Among documents of one origin the later one decides. Whatever is decided against somebody is a :class:`Conflict`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from .schema import KINDS, Entity

#: Lists of members, matched by name -> what one of them is called.
_MEMBERS = {"functions": "function", "properties": "property", "parameters": "parameter", "entries": "entry"}
#: Who decides: the highest.
_AUTHORITY = {"offline": 0, "merged": 1, "live": 2}


@dataclass(frozen=True)
class Conflict:
    """Two documents say different things about one subject."""

    subject: str  # "AActor.SetOwner(NewOwner): flags"
    winner: str  # file whose statement was kept
    winner_origin: str
    loser: str
    loser_origin: str
    kept: Any
    dropped: Any

    def to_dict(self) -> dict[str, Any]:
        """For JSON."""
        return asdict(self)

    @property
    def text(self) -> str:
        """In words."""
        return f"{self.subject}: {self.winner} ({self.winner_origin}) says {_cut(self.kept)}, {self.loser} ({self.loser_origin}) says {_cut(self.dropped)}; the first is kept"


@dataclass
class _Source:
    name: str
    origin: str


def merge(documents: Sequence[tuple[str, Entity]], progress: Callable[[], object] = lambda: None) -> tuple[Entity, list[Conflict]]:
    """One document out of several (name, document), and what they did not agree upon. The documents themselves stay as they are."""
    if not documents:
        raise ValueError("no schema was given")
    conflicts: list[Conflict] = []
    live_modules = {m["name"]: name for name, d in documents if d["origin"] == "live" for m in d["modules"]}
    # Least authority first; each later one is laid over what is there.
    ordered = sorted(documents, key=lambda item: _AUTHORITY.get(item[1]["origin"], 0))
    modules: dict[str, Entity] = {}
    found: dict[str, dict[tuple[str, str], tuple[Entity, _Source]]] = {kind: {} for kind in KINDS}
    for name, document in ordered:
        source = _Source(name, document["origin"])
        for module in document["modules"]:
            modules[module["name"]] = _module(modules.get(module["name"]), module)
        for kind in KINDS:
            for entity in document[kind]:
                key = (entity.get("owner") or "", entity["name"])
                before = found[kind].get(key)
                found[kind][key] = (entity, source) if before is None else (_overlay(entity, source, *before, _title(entity), conflicts), source)
        progress()
    for kind in KINDS:
        for key, (entity, source) in list(found[kind].items()):
            if source.origin != "live" and entity["module"] in live_modules:
                conflicts.append(Conflict(_title(entity), live_modules[entity["module"]], "live", source.name, source.origin, "(not there)", f"{kind} {entity.get('path')}"))
                del found[kind][key]
    origins = {document["origin"] for _, document in documents}
    merged: Entity = {"format": "spear-schema", "version": 1, "origin": origins.pop() if len(origins) == 1 else "merged"}
    tiers = [set(d["tiers"]) for _, d in documents if "tiers" in d]
    if merged["origin"] == "offline" and tiers:
        merged["tiers"] = sorted(set.intersection(*tiers), key=("runtime", "editor").index)
    merged["modules"] = [modules[name] for name in sorted(modules)]
    for kind in KINDS:
        merged[kind] = sorted((e for e, _ in found[kind].values()), key=lambda e: (e["name"], e.get("path", "")))
    return merged, conflicts


def _module(below: Entity | None, above: Entity) -> Entity:
    """A module's entry; headers of both, the later one first where they differ."""
    if below is None:
        return above
    result = {**below, **above}
    first, second = below.get("source"), above.get("source")
    if first and second:
        headers = {h["path"]: h for h in [*first.get("headers", []), *second.get("headers", [])]}
        result["source"] = {**first, **second, "headers": [headers[path] for path in sorted(headers)]}
    elif first:
        result["source"] = first
    return result


def _overlay(above: Entity, above_source: _Source, below: Entity, below_source: _Source, subject: str, conflicts: list[Conflict]) -> Entity:
    """`above` decides; `below` adds the tiers and keys that it lacks."""

    def conflict(what: str, kept: Any, dropped: Any) -> None:
        conflicts.append(Conflict(f"{subject}{what}", above_source.name, above_source.origin, below_source.name, below_source.origin, kept, dropped))

    result = dict(above)
    for key in sorted(above.keys() | below.keys()):
        if key == "source":
            result.setdefault("source", below.get("source"))
        elif key == "editor":
            if key in above and key in below:
                result["editor"] = _editor(above["editor"], below["editor"], conflict)
            else:
                result.setdefault("editor", below.get("editor"))
        elif key in _MEMBERS:
            result[key] = _members(key, above.get(key) or [], above_source, below.get(key) or [], below_source, subject, conflicts)
        elif key == "returns":
            if above.get("returns") and below.get("returns"):
                result["returns"] = _overlay(above["returns"], above_source, below["returns"], below_source, f"{subject} (return value)", conflicts)
            elif above.get("returns") != below.get("returns"):
                conflict(": returns", _type_of(above.get("returns")), _type_of(below.get("returns")))
        elif above.get(key) != below.get(key):
            conflict(f": {key}", above.get(key), below.get(key))
    return result


def _editor(above: Entity, below: Entity, conflict: Callable[[str, Any, Any], None]) -> Entity:
    result = {**below, **above}
    first, second = below.get("meta", {}), above.get("meta", {})
    for key in sorted(first.keys() & second.keys()):
        if first[key] != second[key]:
            conflict(f": metadata {key}", second[key], first[key])
    result["meta"] = dict(sorted({**first, **second}.items()))
    if "default" in above and "default" in below and above["default"] != below["default"]:
        conflict(": default", above["default"], below["default"])
    return result


def _members(kind: str, above: list[Entity], above_source: _Source, below: list[Entity], below_source: _Source, subject: str, conflicts: list[Conflict]) -> list[Entity]:
    lower = {m["name"]: m for m in below}
    result = []
    for member in above:
        name = f"{subject}({member['name']})" if kind == "parameters" else f"{subject}.{member['name'].rpartition('::')[2]}"
        other = lower.pop(member["name"], None)
        if other is None and below_source.origin == above_source.origin:
            conflicts.append(Conflict(name, above_source.name, above_source.origin, below_source.name, below_source.origin, "(there)", "(not there)"))
        result.append(member if other is None else _overlay(member, above_source, other, below_source, name, conflicts))
    for name in lower:
        full = f"{subject}({name})" if kind == "parameters" else f"{subject}.{name.rpartition('::')[2]}"
        conflicts.append(Conflict(full, above_source.name, above_source.origin, below_source.name, below_source.origin, "(not there)", _MEMBERS[kind]))
    return result


def _title(entity: Entity) -> str:
    owner = entity.get("owner")
    return f"{owner}.{entity['name']}" if isinstance(owner, str) and owner else str(entity["name"])


def _type_of(value: Entity | None) -> str:
    return str(value["type"]["cpp"]) if value else "nothing"


def _cut(value: Any) -> str:
    if isinstance(value, dict) and "cpp" in value:
        value = value["cpp"]
    text = str(value)
    return text if len(text) <= 100 else text[:97] + "..."
