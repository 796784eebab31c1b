# SPDX-License-Identifier: MIT
"""Small schemas by hand."""

from __future__ import annotations

import json
from typing import Any

from emit.schema import SchemaSet

Entity = dict[str, Any]


def _type(kind: str = "int32", cpp: str = "", **more: Any) -> Entity:
    return {"kind": kind, "cpp": cpp or kind, **more}


def _parameter(name: str, node: Entity, flags: tuple[str, ...] = ("Parm",), **source: Any) -> Entity:
    return {"name": name, "type": node, "array_dim": 1, "flags": list(flags), "editor": {"meta": {}}, "source": source}


def _documented(comment: str) -> Entity:
    return {"meta": {"ToolTip": comment} if comment else {}}


class SchemaMaker:
    """Makes a small schema: ``maker.add_class("AThing", functions=[maker.function("Open")])``."""

    type = staticmethod(_type)
    parameter = staticmethod(_parameter)

    def __init__(self) -> None:
        self.document: Entity = {"format": "spear-schema", "version": 1, "origin": "offline", "modules": [], "classes": [], "structs": [], "enums": [], "delegates": []}

    def function(self, name: str, parameters: tuple[Entity, ...] = (), returns: Entity | None = None, comment: str = "",
                 flags: tuple[str, ...] = ("Native", "Public"), line: int = 7, **meta: str) -> Entity:
        """A function."""
        result = None if returns is None else {"type": returns, "flags": ["OutParm", "Parm", "ReturnParm"], "editor": {"meta": {}}, "source": {}}
        return {"name": name, "flags": list(flags), "parameters": list(parameters), "returns": result, "editor": {"meta": {**_documented(comment)["meta"], **meta}},
                "source": {"line": line}}

    def property(self, name: str, node: Entity | None = None, comment: str = "", flags: tuple[str, ...] = (), array_dim: int = 1, **source: Any) -> Entity:
        """A property."""
        return {"name": name, "type": node or _type(), "flags": list(flags), "array_dim": array_dim, "editor": _documented(comment), "source": {"line": 9, **source}}

    def add_class(self, name: str, module: str = "Game", super_class: str | None = None, functions: tuple[Entity, ...] = (), properties: tuple[Entity, ...] = (), comment: str = "",
                  flags: tuple[str, ...] = (), interfaces: tuple[str, ...] = ()) -> None:
        """A class of a module."""
        self._add("classes", name, module, {"super": super_class, "interfaces": list(interfaces), "flags": list(flags), "within": "UObject", "config": "", "functions": list(functions),
                                            "properties": list(properties)}, comment)

    def add_struct(self, name: str, module: str = "Game", super_struct: str | None = None, properties: tuple[Entity, ...] = (), comment: str = "") -> None:
        """A struct of a module."""
        self._add("structs", name, module, {"super": super_struct, "flags": [], "properties": list(properties)}, comment)

    def add_enum(self, name: str, entries: dict[str, int], module: str = "Game", comment: str = "") -> None:
        """An enum class of a module."""
        listed = [{"name": f"{name}::{entry}", "value": value, "editor": {"meta": {}}, "source": {}} for entry, value in entries.items()]
        self._add("enums", name, module, {"form": "class", "cpp_type": name, "flags": [], "entries": listed}, comment)

    def add_delegate(self, name: str, owner: str | None = None, parameters: tuple[Entity, ...] = (), module: str = "Game", comment: str = "") -> None:
        """A multicast delegate of a module."""
        self._add("delegates", name, module, {"owner": owner, "kind": "multicast", "flags": [], "parameters": list(parameters), "returns": None}, comment)

    def _add(self, kind: str, name: str, module: str, more: Entity, comment: str) -> None:
        if module not in [m["name"] for m in self.document["modules"]]:
            self.document["modules"].append({"name": module, "source": {"headers": []}})
        self.document[kind].append({"name": name, "reflected_name": name[1:], "path": f"/Script/{module}.{name[1:]}", "module": module, "editor": _documented(comment),
                                    "source": {"header": f"Public/{name[1:]}.h", "line": 5}, **more})

    def schemas(self) -> SchemaSet:
        """All that was added."""
        return SchemaSet.of([json.loads(json.dumps(self.document))])
