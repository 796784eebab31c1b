# SPDX-License-Identifier: MIT
"""Members of a class that hide an inherited member of another type: Unreal permits what type checkers report."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from .schema import SchemaSet

Entity = Mapping[str, Any]


class Overrides:
    """Which classes need type checkers to be lenient."""

    def __init__(self, schemas: SchemaSet) -> None:
        self._schemas = schemas
        self._tables: dict[str, dict[str, str]] = {}

    def conflict(self, entity: Entity) -> bool:
        """Whether a member of the class, or of one of its bases, has the name but not the type of a member of another base."""
        own = self._own(entity)
        inherited = [self._own(base) for base in self._bases(entity)]
        if any(table.get(name, shape) != shape for table in inherited for name, shape in own.items()):
            return True
        # An interface beside a super class: their members meet here for the first time.
        seen: dict[str, str] = {}
        if entity["interfaces"]:
            for table in inherited:
                for name, shape in table.items():
                    if seen.setdefault(name, shape) != shape:
                        return True
        return False

    def _bases(self, entity: Entity) -> Iterator[Entity]:
        seen: set[str] = set()
        waiting = [entity]
        while waiting:
            current = waiting.pop()
            names = [current["super"], *current["interfaces"]]
            for name in names:
                base = self._schemas.class_of_reference(name) if name else None
                if base is not None and base["name"] not in seen:
                    seen.add(base["name"])
                    waiting.append(base)
                    yield base

    def _own(self, entity: Entity) -> dict[str, str]:
        table = self._tables.get(entity["name"])
        if table is None:
            table = {f["name"]: self._shape(f) for f in entity["functions"]}
            table.update({p["name"]: json.dumps([p["type"], p["array_dim"]]) for p in entity["properties"]})
            self._tables[entity["name"]] = table
        return table

    @staticmethod
    def _shape(function: Entity) -> str:
        parameters = [[p["name"], p["type"], p["flags"], "editor" in p and "default" in p["editor"]] for p in function["parameters"]]
        return json.dumps([parameters, function["returns"] and function["returns"]["type"]])
