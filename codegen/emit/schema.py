# SPDX-License-Identifier: MIT
"""Schemas in memory: those that things are made from, those they only refer to, and indexes over both."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

Entity = dict[str, Any]

KINDS = ("classes", "structs", "enums", "delegates")

#: Classes that Unreal's run time itself provides ("intrinsic"), with their super: schemas refer to them, but never contain them.
INTRINSIC_CLASSES = {
    "UField": "UObject", "UStruct": "UField", "UScriptStruct": "UStruct", "UClass": "UStruct", "UFunction": "UStruct", "UEnum": "UField",
    "UPackage": "UObject", "UInterface": "UObject",
}


class SchemaError(Exception):
    """A file that is no schema, or one that does not hold what it must."""


def load_schema(path: Path) -> Entity:
    """Reads a schema file. Raises SchemaError naming the file and what is wrong."""
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except UnicodeDecodeError as error:
        raise SchemaError(f"{path} is no text in UTF-8: {error}") from None
    except ValueError as error:
        raise SchemaError(f"{path} is no JSON (cut short?): {error}") from None
    if not isinstance(document, dict) or document.get("format") != "spear-schema":
        raise SchemaError(f"{path} is no SPEAR schema: its \"format\" is not \"spear-schema\"")
    if document.get("version") != 1:
        raise SchemaError(f"{path} has schema version {document.get('version')!r}; this program reads version 1")
    for kind in ("modules", *KINDS):
        if not isinstance(document.get(kind), list):
            raise SchemaError(f"{path} has no list \"{kind}\": it is cut short, or was not written by SPEAR")
    return document


def header_of(entity: Mapping[str, Any]) -> str:
    """The header that declares a class, struct, enum or delegate, relative to its module ("" if neither source nor metadata tell)."""
    header: str = entity.get("source", {}).get("header", "") or entity.get("editor", {}).get("meta", {}).get("ModuleRelativePath", "")
    return header


def line_of(entity: Mapping[str, Any]) -> int:
    """Its line in that header (0 if the schema has no source tier)."""
    line: int = entity.get("source", {}).get("line", 0)
    return line


@dataclass
class Header:
    """The types that one header declares. Path "" holds those whose header is not known."""

    module: str
    path: str
    classes: list[Entity] = field(default_factory=list)
    structs: list[Entity] = field(default_factory=list)
    enums: list[Entity] = field(default_factory=list)
    delegates: list[Entity] = field(default_factory=list)

    def entities(self) -> Iterator[Entity]:
        """All types, by kind."""
        for kind in KINDS:
            yield from getattr(self, kind)


@dataclass
class Module:
    """One module: its entry of the schema and its types, sorted as in the schema."""

    name: str
    entry: Entity
    #: false: only referred to (given by --import)
    main: bool = True
    classes: list[Entity] = field(default_factory=list)
    structs: list[Entity] = field(default_factory=list)
    enums: list[Entity] = field(default_factory=list)
    delegates: list[Entity] = field(default_factory=list)

    def entities(self) -> Iterator[Entity]:
        """All types, by kind."""
        for kind in KINDS:
            yield from getattr(self, kind)

    @cached_property
    def headers(self) -> list[Header]:
        """The headers that declare types, sorted by path; their types sorted by line, then name."""
        found: dict[str, Header] = {}
        for kind in KINDS:
            for entity in getattr(self, kind):
                path = header_of(entity)
                header = found.get(path)
                if header is None:
                    header = found[path] = Header(self.name, path)
                getattr(header, kind).append(entity)
        for header in found.values():
            for kind in KINDS:
                getattr(header, kind).sort(key=lambda e: (line_of(e), e["name"]))
        return [found[path] for path in sorted(found)]


@dataclass
class SchemaSet:
    """One or many schemas with indexes over them. Names are C++ names: ``AActor``, ``FVector``, ``ECollisionChannel``."""

    #: what things are made from: all main files as one document
    main: Entity
    classes: dict[str, Entity] = field(default_factory=dict)
    structs: dict[str, Entity] = field(default_factory=dict)
    enums: dict[str, Entity] = field(default_factory=dict)
    #: by (owner or "", name)
    delegates: dict[tuple[str, str], Entity] = field(default_factory=dict)
    #: type name -> the header that declares it, as C++ includes it (needs the source tier)
    includes: dict[str, str] = field(default_factory=dict)
    #: all modules by name, sorted; those of imports too
    modules: dict[str, Module] = field(default_factory=dict)

    @classmethod
    def load(cls, main: Path, imports: Iterable[Path] = ()) -> SchemaSet:
        """Reads a main schema and those it imports."""
        return cls.of([load_schema(main)], [load_schema(path) for path in imports])

    @classmethod
    def load_all(cls, paths: Iterable[Path], imports: Iterable[Path] = ()) -> SchemaSet:
        """Reads several schemas, all of them main. A module that is in two of them is taken from the later one."""
        return cls.of([load_schema(path) for path in paths], [load_schema(path) for path in imports])

    @classmethod
    def of(cls, documents: list[Entity], imports: Iterable[Entity] = ()) -> SchemaSet:
        """Indexes documents that are in memory."""
        if not documents:
            raise SchemaError("no schema was given")
        result = cls(documents[0] if len(documents) == 1 else _joined(documents))
        for document in imports:
            result._index(document, main=False)
        result._index(result.main, main=True)
        result.modules = dict(sorted(result.modules.items()))
        return result

    def _index(self, document: Entity, main: bool) -> None:
        for kind in ("classes", "structs", "enums"):
            getattr(self, kind).update({entity["name"]: entity for entity in document[kind]})
        self.delegates.update({(d["owner"] or "", d["name"]): d for d in document["delegates"]})
        for module in document["modules"]:
            self.modules[module["name"]] = Module(module["name"], module, main)
            for header in module.get("source", {}).get("headers", []):
                self.includes.update(dict.fromkeys(header["types"], header["include"]))
        for kind in KINDS:
            for entity in document[kind]:
                name = entity["module"]
                if name not in self.modules:
                    self.modules[name] = Module(name, {"name": name}, main)
                getattr(self.modules[name], kind).append(entity)

    # Questions ----------------------------------------------------------------------------------------------------------

    @cached_property
    def main_modules(self) -> list[Module]:
        """The modules that things are made from, sorted by name."""
        return [module for module in self.modules.values() if module.main]

    @cached_property
    def subclasses(self) -> dict[str, list[str]]:
        """Class name -> its direct subclasses, sorted."""
        return _children(self.classes)

    @cached_property
    def derived_structs(self) -> dict[str, list[str]]:
        """Struct name -> the structs that derive from it directly, sorted."""
        return _children(self.structs)

    @cached_property
    def implementers(self) -> dict[str, list[str]]:
        """Interface (``IFoo``) -> the classes that name it in their own base list, sorted."""
        found: dict[str, list[str]] = {}
        for entity in self.classes.values():
            for interface in entity["interfaces"]:
                found.setdefault(interface, []).append(entity["name"])
        return {name: sorted(names) for name, names in sorted(found.items())}

    def class_of_reference(self, name: str) -> Entity | None:
        """The class of a C++ name; interfaces also by their I name."""
        found = self.classes.get(name)
        if found is None and name.startswith("I"):
            found = self.classes.get("U" + name[1:])
        return found

    def delegate_of(self, node: Entity) -> Entity | None:
        """The delegate that a type node means."""
        return self.delegates.get((node.get("owner") or "", node["name"]))

    def type_named(self, name: str) -> Entity | None:
        """The class, interface (also by its I name), struct or enum of a C++ name."""
        return self.class_of_reference(name) or self.structs.get(name) or self.enums.get(name)

    def ancestors(self, name: str) -> list[str]:
        """Super classes (of a class) or super structs, nearest first, up to UObject; as far as they are known."""
        found: list[str] = []
        while True:
            entity = self.classes.get(name) or self.structs.get(name)
            above = entity["super"] if entity else INTRINSIC_CLASSES.get(name)
            if not above or above in found:
                return found
            found.append(above)
            name = above

    def is_a(self, name: str, base: str) -> bool:
        """Whether a class or struct is another one or derives from it."""
        return name == base or base in self.ancestors(name)


def _children(entities: Mapping[str, Entity]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for entity in entities.values():
        if entity["super"]:
            found.setdefault(entity["super"], []).append(entity["name"])
    return {name: sorted(names) for name, names in sorted(found.items())}


def _joined(documents: list[Entity]) -> Entity:
    """Several documents as one, sorted as a dump is. A module counts as it is in the last document that has it."""
    owner = {}
    for number, document in enumerate(documents):
        for module in document["modules"]:
            owner[module["name"]] = number
        for kind in KINDS:
            for entity in document[kind]:
                owner[entity["module"]] = max(number, owner.get(entity["module"], 0))
    joined: Entity = {"format": "spear-schema", "version": 1, "origin": documents[0]["origin"] if len({d["origin"] for d in documents}) == 1 else "merged"}
    joined["modules"] = sorted((m for n, d in enumerate(documents) for m in d["modules"] if owner[m["name"]] == n), key=lambda m: m["name"])
    for kind in KINDS:
        entities = (e for n, d in enumerate(documents) for e in d[kind] if owner[e["module"]] == n)
        joined[kind] = sorted(entities, key=lambda e: (e["name"], e.get("path", "")))
    return joined
