# SPDX-License-Identifier: MIT
"""A typed program over any code base, at least 200 lines: what each function and variable gives is stated by ``assert_type``.

The expected types are worked out here from the schema, on purpose not by the code that writes the stubs.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from subject import Subject

from spear.codegen.names import ScopeNames
from spear.codegen.schema import Entity, SchemaSet
from spear.codegen.signatures import Parameter, signature

LINES = 200
#: At most this many statements of one class, so that many classes are used.
PER_CLASS = 12
_PLAIN = {"bool": "bool", "float": "float", "double": "float", "string": "str", "name": "str", "text": "str",
          **dict.fromkeys(("int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64"), "int")}
_VALUES = {"bool": "True", "float": "0.5", "str": '"text"', "int": "3"}


def write(subject: Subject, lines: int = LINES) -> str:
    """The text of the program: the subject first, then classes from all over the code base."""
    writer = _Writer(subject.schemas)
    chain = [subject.name, *(name for name in subject.schemas.ancestors(subject.name) if name in subject.schemas.classes)]
    others = sorted(name for name, entity in subject.schemas.classes.items() if "Interface" not in entity["flags"] and name not in chain)
    for name in chain + others[:: max(1, len(others) // 200)]:
        if len(writer.body) >= lines:
            break
        writer.add_class(subject.schemas.classes[name])
    return writer.text()


class _Writer:
    def __init__(self, schemas: SchemaSet) -> None:
        self.schemas = schemas
        self.body: list[str] = []
        self.names: dict[str, set[str]] = {}

    def text(self) -> str:
        words = set(re.findall(r"\w+", "\n".join(self.body)))
        imports = [f"from spear.unreal.{module} import {', '.join(sorted(names & words))}" for module, names in sorted(self.names.items()) if names & words]
        head = ['"""A program as users write them, made from the schema."""', "", "from typing import assert_type", "", "from spear import Future", *imports]
        return "\n".join([*head, *self.body]) + "\n"

    def add_class(self, entity: Entity) -> None:
        members = ScopeNames([e["name"] for kind in ("functions", "properties") for e in entity[kind]], "member")
        given: dict[str, str] = {}
        statements = [*self._properties(entity, members), *self._functions(entity, members, given)]
        if not statements:
            return
        half = statements[: PER_CLASS]
        used = {name: annotation for name, annotation in given.items() if any(name in line for line in half)}
        arguments = "".join(f", {name}: {annotation}" for name, annotation in used.items())
        self.body += ["", "", f"def use_{entity['name']}(thing: {self._name(entity)}{arguments}) -> None:", *(f"    {line}" for line in half)]

    def _name(self, entity: Entity) -> str:
        self.names.setdefault(entity["module"], set()).add(entity["name"])
        return str(entity["name"])

    def _type(self, node: Mapping[str, Any], array_dim: int = 1) -> str | None:
        """What a value of a type reads as, for the kinds whose answer leaves no choice."""
        kind = node["kind"]
        if array_dim != 1:
            return None
        if kind in _PLAIN:
            return _PLAIN[kind]
        if kind in ("enum", "byte_enum"):
            return self._name(self.schemas.enums[node["name"]]) if node["name"] in self.schemas.enums else None
        if kind == "struct":
            return self._name(self.schemas.structs[node["name"]]) if node["name"] in self.schemas.structs else None
        if kind == "object":
            return self._name(self.schemas.classes[node["name"]]) if node["name"] in self.schemas.classes else None
        if kind == "array" and node["inner"]["kind"] not in ("object", "uint8"):
            inner = self._type(node["inner"])
            return inner and f"list[{inner}]"
        if kind == "map" and node["key"]["kind"] in ("string", "name", "int32") and node["value"]["kind"] in _PLAIN:
            return f"dict[{_PLAIN[node['key']['kind']]}, {_PLAIN[node['value']['kind']]}]"
        return None

    def _properties(self, entity: Entity, members: ScopeNames) -> Iterator[str]:
        for number, prop in enumerate(entity["properties"][:20]):
            found = self._type(prop["type"], prop["array_dim"])
            if found is None:
                continue
            name = members[prop["name"]]
            yield f"assert_type(thing.{name}.get(), {found})"
            if number % 3 == 0:
                yield f"assert_type(thing.async_.{name}.get(), Future[{found}])"
            if prop["type"]["kind"] in _PLAIN and number % 2 == 0:
                yield f"thing.{name} = {_VALUES[found]}"
                yield f"thing.{name}.set({_VALUES[found]})"

    def _functions(self, entity: Entity, members: ScopeNames, given: dict[str, str]) -> Iterator[str]:
        for number, function in enumerate(entity["functions"][:30]):
            shape = signature(function, self.schemas)
            arguments = [self._argument(p, given) for p in shape.inputs if not p.optional and not p.keyword_only]
            if not shape.callable or None in arguments or shape.returns == "tuple":
                continue
            found: str | None = "None"
            if shape.returns == "single":
                found = self._type(shape.outputs[0].type, shape.outputs[0].array_dim)
                if found and shape.outputs[0].nullable and shape.outputs[0].type["kind"] == "object":
                    found += " | None"
            if found is None:
                continue
            call = f"{members[function['name']]}({', '.join(a for a in arguments if a)})"
            if found == "None":
                yield f"thing.{call}"
                yield f"thing.send_.{call}"
            else:
                yield f"assert_type(thing.{call}, {found})"
            if number % 2 == 0:
                yield f"assert_type(thing.async_.{call}, Future[{found}])"

    def _argument(self, parameter: Parameter, given: dict[str, str]) -> str | None:
        """``Name=value`` for a required parameter; None if no plain value will do."""
        found = self._type(parameter.type, parameter.array_dim)
        kind = parameter.type["kind"]
        if found is None or kind in ("array", "map"):
            return None
        if kind in _PLAIN:
            return f"{parameter.python_name}={_VALUES[found]}"
        name = f"some_{found}"
        given[name] = found
        return f"{parameter.python_name}={name}"
