# SPDX-License-Identifier: MIT
"""What to ask an editor about, chosen from a schema: the class with the most inherited members, documented functions of it, a sample program."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from spear.codegen.names import python_name
from spear.codegen.schema import Entity, SchemaSet
from spear.codegen.signatures import Signature, signature


@dataclass(frozen=True)
class Function:
    """A function of the subject, with the words that its documentation must show."""

    owner: str
    signature: Signature
    words: str

    @property
    def name(self) -> str:
        return python_name(self.signature.name)


class Subject:
    """A class of a schema, and what is known about it there."""

    def __init__(self, schemas: SchemaSet, name: str = "") -> None:
        self.schemas = schemas
        self.name = name or max(sorted(schemas.classes), key=lambda candidate: len(self._inherited(candidate)))
        self.module: str = schemas.classes[self.name]["module"]
        #: Unreal's names of all functions and properties that come from super classes and interfaces
        self.inherited = self._inherited(self.name)
        #: with its own
        self.members = self.inherited | set(self._own(schemas.classes[self.name]))

    def _owners(self, name: str) -> Iterator[Entity]:
        todo = [name]
        seen = set()
        while todo:
            current = todo.pop()
            entity = self.schemas.class_of_reference(current)
            if entity is None or entity["name"] in seen:
                continue
            seen.add(entity["name"])
            if current != name:
                yield entity
            todo += [entity["super"] or "", *entity["interfaces"]]

    def _own(self, entity: Entity) -> Iterator[str]:
        for function in entity["functions"]:
            if signature(function, self.schemas).callable:
                yield function["name"]
        for prop in entity["properties"]:
            yield prop["name"]

    def _inherited(self, name: str) -> set[str]:
        return {member for owner in self._owners(name) for member in self._own(owner)}

    def functions(self, count: int) -> list[Function]:
        """Inherited functions with at least two parameters and a comment of a few words, spread over the hierarchy."""
        found = []
        for owner in self._owners(self.name):
            for function in owner["functions"]:
                shape = signature(function, self.schemas)
                words = _first_words(function)
                if shape.callable and len([p for p in shape.inputs if not p.keyword_only]) >= 2 and words and python_name(shape.name) == shape.name:
                    found.append(Function(owner["name"], shape, words))
        step = max(1, len(found) // count)
        return found[::step][:count]

    def documented_properties(self, count: int) -> list[tuple[str, str]]:
        """Inherited properties with comments: name, first words."""
        properties = (p for owner in self._owners(self.name) for p in owner["properties"])
        found = [(p["name"], _first_words(p)) for p in properties if _first_words(p) and python_name(p["name"]) == p["name"]]
        step = max(1, len(found) // count)
        return found[::step][:count]


def _first_words(entity: Entity) -> str:
    """The first words of a comment that are plain letters, enough of them to be no chance."""
    text = entity.get("editor", {}).get("meta", {}).get("ToolTip", "")
    match = re.match(r"[A-Za-z]+(?: [a-z]+){2,5}", text)
    return match.group(0) if match else ""
