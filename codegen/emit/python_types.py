# SPDX-License-Identifier: MIT
"""Types of Unreal as annotations of Python: what is read, what is accepted, the path of a variable.

``PythonTypes`` is given a function that is told each name that an annotation needs, so that stubs can import it. Without one the names are
those that a reader knows: ``PythonTypes(schemas).value(node)`` is ``"list[AActor]"``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from .names import python_name
from .schema import INTRINSIC_CLASSES, SchemaSet
from .signatures import INTEGER_KINDS, NUMBER_KINDS, OBJECT_KINDS, Signature

Node = Mapping[str, Any]

_TEXTS = frozenset({"string", "utf8_string", "ansi_string", "name", "text", "field_path"})
_MULTICAST = frozenset({"multicast_delegate", "sparse_delegate"})
_POINTERS = frozenset({"object", "weak_object", "lazy_object"})


def result_name(owner: str, function: str) -> str:
    """The named tuple of a function with several results."""
    return f"{python_name(owner, 'type')}_{python_name(function, 'type')}_Result"


class PythonTypes:
    """Annotations for type nodes. ``use(name, suffix)`` gives the text by which ``name + suffix`` is known where the annotation stands; the
    suffix is that of a helper (``_in``, ``_path``, ...). ``unknown`` gathers the names that no schema has."""

    def __init__(self, schemas: SchemaSet, use: Callable[[str, str], str] | None = None) -> None:
        self.schemas = schemas
        self.use = use or (lambda name, suffix: python_name(name, "type") + suffix)
        self.unknown: set[str] = set()

    # Names --------------------------------------------------------------------------------------------------------------

    def class_name(self, name: str) -> str:
        """The nearest class that is known: itself, or what its name tells (UObject, AActor for actors)."""
        if name in self.schemas.classes or name in INTRINSIC_CLASSES or name == "UObject":
            return name
        if name.startswith("I") and self.schemas.class_of_reference(name):
            return name
        self.unknown.add(name)
        return "AActor" if name.startswith("A") and "AActor" in self.schemas.classes else "UObject"

    def _helper(self, name: str) -> str:
        """A name of spear.typing or of the standard library."""
        return self.use(name, "")

    def _future(self, text: str) -> str:
        return f"{self._helper('Future')}[{text}]"

    def _known(self, node: Node) -> bool:
        """Whether the struct or enum of a node is in a schema."""
        name = node["name"]
        known = name in (self.schemas.structs if node["kind"] == "struct" else self.schemas.enums)
        if not known:
            self.unknown.add(name)
        return known

    # Values -------------------------------------------------------------------------------------------------------------

    def value(self, node: Node, array_dim: int = 1, nullable: bool = True) -> str:
        """What is read. ``nullable``: an object, or an object in an array or set, may be None."""
        if array_dim > 1:
            return f"list[{self.value(node)}]"
        kind = node["kind"]
        if kind == "bool":
            return "bool"
        if kind in INTEGER_KINDS:
            return "int"
        if kind in NUMBER_KINDS:
            return "float"
        if kind in _TEXTS or kind in ("soft_object", "soft_class"):
            return "str"
        if kind in ("enum", "byte_enum"):
            return self.use(node["name"], "") if self._known(node) else "int"
        if kind in OBJECT_KINDS:
            return self._object(node) + (" | None" if nullable else "")
        if kind == "struct":
            return self.use(node["name"], "") if self._known(node) else self._helper("Any")
        if kind == "array":
            return f"list[{self.value(node['inner'], 1, nullable)}]"
        if kind == "set":
            word = "list" if self._unhashable(node["inner"]) else "set"
            return f"{word}[{self.value(node['inner'], 1, nullable)}]"
        if kind == "map":
            key, value = self.value(node["key"], 1, False), self.value(node["value"])
            return f"list[tuple[{key}, {value}]]" if self._unhashable(node["key"]) else f"dict[{key}, {value}]"
        if kind == "optional":
            inner = self.value(node["inner"], 1, False)
            return inner if inner.endswith("| None") or inner == self._helper("Any") else f"{inner} | None"
        if kind == "delegate":
            return self.use("FScriptDelegate", "")
        if kind in _MULTICAST:
            return f"list[{self.use('FScriptDelegate', '')}]"
        return self._helper("Any")

    def _object(self, node: Node) -> str:
        return self.use("UClass" if node["kind"] == "class" else self.class_name(node["name"]), "")

    def _unhashable(self, node: Node) -> bool:
        return node["kind"] in ("struct", "delegate")

    # Arguments ----------------------------------------------------------------------------------------------------------

    def argument(self, node: Node, array_dim: int = 1, nullable: bool = False) -> str:
        """What is accepted by a parameter or a variable."""
        if array_dim > 1:
            return f"{self._helper('Sequence')}[{self.argument(node, 1, True)}] | {self._future(self.value(node, array_dim))}"
        kind = node["kind"]
        none = " | None" if nullable else ""
        if kind in _POINTERS or kind == "interface":
            name = self._object(node)
            return f"{name} | {self._future(name)}{none}"
        if kind == "class":
            uclass = self._object(node)
            return f"type[{self.use(self.class_name(node['name']), '')}] | {uclass} | str | {self._future(uclass)}{none}"
        if kind in ("soft_object", "soft_class"):
            name = self.use("UClass" if kind == "soft_class" else self.class_name(node["name"]), "")
            return f"str | {name} | {self._future('str')} | {self._future(name)}{none}"
        if kind in ("enum", "byte_enum"):
            return self.use(node["name"], "_in") if self._known(node) else f"int | str | {self._future('int')}"
        if kind == "struct":
            return self.use(node["name"], "_in") if self._known(node) else self._helper("Any")
        if kind in ("array", "set"):
            inner = self.argument(node["inner"], 1, True)
            numbers = f" | {self._helper('Buffer')}" if node["inner"]["kind"] in NUMBER_KINDS else ""
            sets = f" | {self._helper('AbstractSet')}[{inner}]" if kind == "set" else ""
            return f"{self._helper('Sequence')}[{inner}]{sets}{numbers} | {self._future(self.value(node))}"
        if kind == "map":
            if self._unhashable(node["key"]):
                return self._future(self.value(node))
            key, value = self.value(node["key"], 1, False), self.argument(node["value"], 1, True)
            mapping = self._helper("Mapping")
            text = f"{mapping}[{key}, {value}] | {self._future(self.value(node))}"
            return text if key == "str" else f"{mapping}[str, {value}] | {text}"
        if kind == "optional":
            inner = self.argument(node["inner"], 1, True)
            return inner if inner.endswith("| None") or inner == self._helper("Any") else f"{inner} | None"
        if kind == "delegate":
            return f"{self.use('FScriptDelegate', '_in')} | None"
        if kind in _MULTICAST:
            return f"{self._helper('Sequence')}[{self.use('FScriptDelegate', '_in')}] | None"
        plain = self.value(node)
        return plain if plain == self._helper("Any") else f"{plain} | {self._future(plain)}"

    # Paths --------------------------------------------------------------------------------------------------------------

    def path(self, node: Node, array_dim: int = 1, asynchronous: bool = False) -> str:
        """The path of a variable; ``asynchronous``: under ``async_``."""
        if array_dim > 1:
            return self._array_path(self.value(node), self.argument(node, 1, True), node, asynchronous)
        kind = node["kind"]
        mark = "Async" if asynchronous else ""
        if kind in _POINTERS or kind == "interface":
            return self.use(self.class_name(node["name"]), "_async_path" if asynchronous else "_path")
        if kind == "struct" and self._known(node):
            return self.use(node["name"], "_async" if asynchronous else "_path")
        if kind == "array":
            return self._array_path(self.value(node["inner"]), self.argument(node["inner"], 1, True), node["inner"], asynchronous)
        if kind == "map" and not self._unhashable(node["key"]):
            head = f"{self.value(node['key'], 1, False)}, {self.value(node['value'])}, {self.argument(node['value'], 1, True)}"
            twin = self.path(node["value"], 1, True)
            if asynchronous:
                return f"{self._helper('AsyncMapPath')}[{head}, {twin}]"
            return f"{self._helper('MapPath')}[{head}, {self.path(node['value'])}, {twin}]"
        if kind == "set" and not asynchronous and not self._unhashable(node["inner"]):
            return f"{self._helper('SetPath')}[{self.value(node['inner'])}, {self.argument(node['inner'], 1, True)}]"
        if kind == "class":
            name = "AsyncClassPath" if asynchronous else "ClassPath"
            return f"{self._helper(name)}[{self.value(node, 1, False)}, {self.argument(node, 1, True)}]"
        value, argument = self.value(node), self.argument(node, 1, True)
        if kind in NUMBER_KINDS or kind == "bool" or kind in _TEXTS:
            return f"{self._helper(mark + 'Path')}[{value}]"
        return f"{self._helper(mark + 'ValuePath')}[{value}, {argument}]"

    def _array_path(self, value: str, argument: str, element: Node, asynchronous: bool) -> str:
        twin = self.path(element, 1, True)
        if asynchronous:
            return f"{self._helper('AsyncArrayPath')}[{value}, {argument}, {twin}]"
        return f"{self._helper('ArrayPath')}[{value}, {argument}, {self.path(element)}, {twin}]"

    def variable(self, node: Node, array_dim: int = 1, facet: str = "") -> str:
        """The descriptor of a variable: of a class or struct (""), under ``async_`` ("Async") or under ``send_`` ("Send")."""
        kind = node["kind"]
        if array_dim == 1:
            plain = "Int" if kind in INTEGER_KINDS else "Float" if kind in NUMBER_KINDS else "Str" if kind in _TEXTS else "Bool" if kind == "bool" else ""
            if plain:
                return self._helper(f"{facet}{plain}Property")
        argument = self.argument(node, array_dim, True)
        if facet == "Send":
            return f"{self._helper('SendProperty')}[{argument}]"
        return f"{self._helper('Property')}[{self.path(node, array_dim, facet == 'Async')}, {argument}]"

    # Functions ----------------------------------------------------------------------------------------------------------

    def result(self, signature: Signature, owner: str) -> str:
        """What a function returns."""
        if not signature.callable:
            return self._helper("NoReturn")
        if signature.returns == "none":
            return "None"
        if signature.returns == "tuple":
            return result_name(owner, signature.name)
        output = signature.outputs[0]
        return self.value(output.type, output.array_dim, output.nullable)

    def parameters(self, signature: Signature) -> list[str]:
        """The parameters of a function as they stand between its parentheses, ``self`` left out."""
        texts: list[str] = []
        by_keyword = False
        optional_before = False
        for parameter in signature.inputs:
            # A parameter that must be given cannot follow one that may be omitted, but by keyword it can.
            if not by_keyword and (parameter.keyword_only or (optional_before and not parameter.optional)):
                by_keyword = True
                texts.append("*")
            optional_before |= parameter.optional
            text = f"{parameter.python_name}: {self.argument(parameter.type, parameter.array_dim, parameter.nullable)}"
            if parameter.optional:
                text += f" = {self._default(parameter.default_python, parameter.type)}"
            texts.append(text)
        return texts

    def _default(self, text: str | None, node: Node) -> str:
        """The default as a stub states it: itself where it is short and plain, else an ellipsis."""
        kind = node["kind"]
        plain = NUMBER_KINDS | _TEXTS | OBJECT_KINDS | {"bool", "enum", "byte_enum", "soft_object", "soft_class"}
        if text is None or kind not in plain or "float(" in text:
            return "..."
        if kind in ("enum", "byte_enum"):
            return self.use(node["name"], "") + "." + text.partition(".")[2]
        return text if len(text) <= 80 else "..."

    def function(self, signature: Signature, owner: str) -> str:
        """``SetActorScale3D(NewScale3D: FVector_in) -> None``."""
        return f"{python_name(signature.name)}({', '.join(self.parameters(signature))}) -> {self.result(signature, owner)}"
