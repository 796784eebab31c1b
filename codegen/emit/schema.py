# SPDX-License-Identifier: MIT
"""Schemas in memory: one that things are made from, and those it imports."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

Entity = dict[str, Any]


class SchemaError(Exception):
    """A file that is no schema, or one that does not hold what it must."""


def load_schema(path: Path) -> Entity:
    """Reads a schema file. Raises SchemaError naming the file and what is wrong."""
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise SchemaError(f"{path} is no JSON (cut short?): {error}") from None
    if not isinstance(document, dict) or document.get("format") != "spear-schema":
        raise SchemaError(f"{path} is no SPEAR schema: its \"format\" is not \"spear-schema\"")
    if document.get("version") != 1:
        raise SchemaError(f"{path} has schema version {document.get('version')!r}; this program reads version 1")
    return document


@dataclass
class SchemaSet:
    """A main schema and indexes over it and its imports."""

    main: Entity
    classes: dict[str, Entity] = field(default_factory=dict)
    structs: dict[str, Entity] = field(default_factory=dict)
    enums: dict[str, Entity] = field(default_factory=dict)
    #: by (owner or "", name)
    delegates: dict[tuple[str, str], Entity] = field(default_factory=dict)
    #: type name -> the header that declares it, as C++ includes it
    includes: dict[str, str] = field(default_factory=dict)

    @classmethod
    def load(cls, main: Path, imports: list[Path]) -> SchemaSet:
        """Reads the main schema and its imports."""
        result = cls(load_schema(main))
        for document in [*map(load_schema, imports), result.main]:
            result._index(document)
        return result

    def _index(self, document: Entity) -> None:
        for kind in ("classes", "structs", "enums"):
            getattr(self, kind).update({entity["name"]: entity for entity in document[kind]})
        self.delegates.update({(d["owner"] or "", d["name"]): d for d in document["delegates"]})
        for module in document["modules"]:
            for header in module["source"]["headers"]:
                self.includes.update(dict.fromkeys(header["types"], header["include"]))

    def class_of_reference(self, name: str) -> Entity | None:
        """The class of a C++ name; interfaces also by their I name."""
        found = self.classes.get(name)
        if found is None and name.startswith("I"):
            found = self.classes.get("U" + name[1:])
        return found
