# SPDX-License-Identifier: MIT
"""How things are written in Python and in C++, as the stubs and the proxies have them, shortened for readers.

What is shortened: an argument also takes a ``Future`` of its type, a struct also a dictionary of its members; the first page says so once.
"""

from __future__ import annotations

from dataclasses import dataclass
from html import escape

from markupsafe import Markup

from .cpp_proxies import NAMED_FROM
from .cpp_proxies_types import (
    class_name, entry_names, field_names, is_object, member_names, parameter_names, plain_struct, result_names, struct_name, value_type,
)
from .names import ScopeNames, python_name, short_entry_name
from .python_stub_pieces import PieceWriter, environment, own_members
from .python_types import Node, PythonTypes, result_name
from .reference_site import Entity, Page, Site
from .signatures import OBJECT_KINDS, Parameter, Signature, meta_value

#: A signature that is longer is broken into one line for each parameter.
_WIDTH = 62
#: What is no longer stands beside the language's name, without a line of its own.
_SHORT = 50


@dataclass
class Spelling:
    """Python and C++, as HTML."""

    python: str
    cpp: str
    #: one line each
    short: bool = False

    @property
    def html(self) -> Markup:
        """Both, side by side."""
        kind = "spell short" if self.short else "spell"
        return Markup(f'<div class="{kind}"><pre class="py" data-of="Python">{self.python}</pre><pre class="cpp" data-of="C++">{self.cpp}</pre></div>')


class _ReaderTypes(PythonTypes):
    """Annotations without what every argument takes anyway."""

    _FUTURE = "\0"

    def __init__(self, site: Site) -> None:
        super().__init__(site.schemas, self._text)
        self._arguments: dict[tuple[str, str, int, bool], str] = {}

    @staticmethod
    def _text(name: str, suffix: str) -> str:
        if name.startswith("TypeVar:"):
            return "T"
        return python_name(name, "type") + ("" if suffix == "_in" else suffix)

    def _future(self, text: str) -> str:
        return self._FUTURE

    def argument(self, node: Node, array_dim: int = 1, nullable: bool = False) -> str:
        key = (node["cpp"], node.get("owner") or "", array_dim, nullable)
        found = self._arguments.get(key)
        if found is None:
            found = super().argument(node, array_dim, nullable)
            for text in (f" | {self._FUTURE}", f"{self._FUTURE} | "):
                found = found.replace(text, "")
            found = self._arguments[key] = found if self._FUTURE not in found else f"Future[{self.value(node, array_dim)}]"
        return found


class Speller:
    """Spells types, functions, properties and entries of a site."""

    def __init__(self, site: Site) -> None:
        self.site = site
        self.schemas = site.schemas
        self.types = _ReaderTypes(site)
        self._stubs = PieceWriter(self.schemas, environment(), self.types.use)
        self._stubs.types = self.types
        self._names_of: tuple[str, str] | None = None
        self._cpp_values: dict[tuple[str, str, int], str] = {}

    # Types -----------------------------------------------------------------------------------------------------------------

    def type(self, page: Page) -> Spelling:
        """How a type is made known, and what there is to begin with."""
        entity = page.entity
        python, cpp = self._type_names(page)
        python_lines = [f"from spear.unreal.{python_name(page.module, 'type')} import {python}"]
        cpp_lines = [f"#include <spear/unreal/{page.module}/{cpp}.hpp>"]
        if page.kind == "class" and any("Static" in function["flags"] for function in entity["functions"]):
            python_lines += ["# static functions:", f"statics = game.get_class({python})"]
            cpp_lines += ["// static functions:", f"auto statics = game.get_class<unreal::{cpp}>();"]
        elif page.kind == "struct":
            self._name_members(page)
            shown = [field["name"] for field in self._all_fields(entity)[:3]]
            python_lines.append(f"{python}({', '.join(f'{self._python[n]}=...' for n in shown)})")
            cpp_lines.append(f"unreal::{cpp}{{{', '.join(f'.{self._cpp[n]} = ...' for n in shown)}}}")
        elif page.kind == "enum" and entity["entries"]:
            first, second = self.entry(page, entity["entries"][0])
            python_lines.append(first)
            cpp_lines.append(second)
        return _spelling(python_lines, cpp_lines)

    def _type_names(self, page: Page) -> tuple[str, str]:
        python = python_name(page.title if page.kind == "interface" else page.entity["name"], "type")
        return python, class_name(page.entity) if page.kind in ("class", "interface") else struct_name(page.entity["name"])

    def _all_fields(self, entity: Entity) -> list[Entity]:
        """The fields of a struct, those of the structs above it first."""
        chain = [self.schemas.structs[name] for name in reversed(self.schemas.ancestors(entity["name"])) if name in self.schemas.structs]
        return [field for struct in (*chain, entity) for field in struct["properties"]]

    def entry(self, page: Page, entity: Entity) -> tuple[str, str]:
        """An entry of an enum: Python, C++."""
        self._name_members(page)
        short = short_entry_name(entity["name"])
        python, cpp = self._type_names(page)
        return f"{python}.{self._python[short]}", f"unreal::{cpp}::{self._cpp_entries[short]}"

    def _name_members(self, page: Page) -> None:
        """The names of a page's members; kept until the next page."""
        key = (page.path, page.kind)
        if key == self._names_of:
            return
        self._names_of = key
        entity = page.entity
        if page.kind in ("class", "interface"):
            self._python = own_members(entity)
            self._cpp = member_names(entity)
            self._functions = {f["name"] for f in entity["functions"]}
        elif page.kind == "struct":
            fields = self._all_fields(entity)
            self._python = ScopeNames((p["name"] for p in fields), "field")
            self._cpp = field_names(entity, fields)
            self._functions = set()
        elif page.kind == "enum":
            self._python = ScopeNames((short_entry_name(e["name"]) for e in entity["entries"]), "entry")
            self._cpp_entries = {unreal: cpp for cpp, unreal, _ in entry_names(entity)}

    # Functions -------------------------------------------------------------------------------------------------------------

    def function(self, page: Page, function: Entity, call: Signature) -> Spelling:
        """A function: called and waited for, then asynchronously."""
        self._name_members(page)
        owner_cpp = self._type_names(page)[1]
        python, cpp = self._python[function["name"]], self._cpp[function["name"]]
        result, outputs = self._python_result(call, result_name(page.entity["name"], function["name"]))
        parameters = self.types.parameters(call)
        generic = self._stubs.generic(function, call)
        if generic:  # the result is of the class given
            chosen = (meta_value(function, "DeterminesOutputType") or "").lower()
            parameters = [f"{p.partition(':')[0]}: type[T]" if p.partition(":")[0].lower() == chosen else p for p in parameters]
            result = generic[0][1]
        python_lines = [_signature(f"{python}(", parameters, f") -> {result}"), *outputs]
        if not call.callable:
            return _spelling([*python_lines, "# cannot be called from outside"], ["// not there: cannot be called from outside"])
        cpp_result, cpp_outputs = self._cpp_result(call, f"unreal::{owner_cpp}_{cpp}_Result")
        cpp_lines = [_signature(f"{cpp_result} {cpp}(", self._cpp_parameters(call), ")"), *cpp_outputs]
        if sum(p.optional and not p.keyword_only for p in call.inputs) >= NAMED_FROM:
            cpp_lines.append(f"// or by name: {cpp}({{.{parameter_names(p.name for p in call.inputs)[call.inputs[-1].name]} = …}})")
        some = "…" if call.inputs else ""
        return _spelling(python_lines, cpp_lines, f"async_.{python}({some}) -> Future[{result}]", f"spear::Future<{cpp_result}> async().{cpp}({some})")

    def delegate(self, page: Page, call: Signature) -> Spelling:
        """What a function looks like that a delegate may call."""
        name = python_name(page.entity["name"], "type")
        result, outputs = self._python_result(call, "tuple")
        cpp_result, cpp_outputs = self._cpp_result(call, "struct")
        return _spelling([_signature(f"{name}(", self.types.parameters(call), f") -> {result}"), *outputs],
                         [_signature(f"{cpp_result} {name}(", self._cpp_parameters(call), ")"), *cpp_outputs])

    def _python_result(self, call: Signature, tuple_name: str) -> tuple[str, list[str]]:
        """The result, and lines that tell the members of a tuple."""
        if not call.callable:
            return "NoReturn", []
        if call.returns == "none":
            return "None", []
        if call.returns == "single":
            return self.types.value(call.outputs[0].type, call.outputs[0].array_dim, call.outputs[0].nullable), []
        return tuple_name, [f"# .{o.python_name}: {self.types.value(o.type, o.array_dim, o.nullable)}" for o in call.outputs]

    def _cpp_result(self, call: Signature, struct: str) -> tuple[str, list[str]]:
        if call.returns == "none":
            return "void", []
        if call.returns == "single":
            return self._cpp_value(call.outputs[0].type, call.outputs[0].array_dim), []
        names = result_names(o.name for o in call.outputs)
        return struct, [f"// .{names[o.name]}: {self._cpp_value(o.type, o.array_dim)}" for o in call.outputs]

    def _cpp_parameters(self, call: Signature) -> list[str]:
        names = parameter_names(p.name for p in call.inputs)
        return [f"{self._cpp_value(p.type, p.array_dim)} {names[p.name]}{self._cpp_default(p)}" for p in call.inputs]

    @staticmethod
    def _cpp_default(parameter: Parameter) -> str:
        if not parameter.optional:
            return ""
        text = parameter.default_cpp
        if parameter.keyword_only or not text:
            return " = {}"
        return f" = {'unreal::' if parameter.type['kind'] in ('enum', 'byte_enum', 'struct') else ''}{text}"

    def _cpp_value(self, node: Node, array_dim: int) -> str:
        key = (node["cpp"], node.get("owner") or "", array_dim)
        found = self._cpp_values.get(key)
        if found is None:
            found = self._cpp_values[key] = value_type(node, self.schemas, array_dim)
        return found

    # Properties ------------------------------------------------------------------------------------------------------------

    def property(self, page: Page, entity: Entity) -> Spelling:
        """A property: read, written, read asynchronously; a field of a struct as the member it is."""
        self._name_members(page)
        node, dim = entity["type"], entity["array_dim"]
        python, cpp = self._python[entity["name"]], self._cpp[entity["name"]]
        is_reference = node["kind"] in OBJECT_KINDS and dim == 1
        value = self.types.value(node, dim, not is_reference)
        cpp_value = self._cpp_value(node, dim)
        if page.kind == "struct":
            holder = "{}" if plain_struct(page.entity["name"], self.schemas) else "spear::ObjectField<{}>" if is_object(node, dim) else "spear::Field<{}>"
            return _spelling([f"{python}: {value}{' | None' if is_reference else ''}"], [f"{holder.format(cpp_value)} {cpp}"])
        if entity["name"] in self._functions:  # the name means the function
            return _spelling([f'get("{entity["name"]}") -> {value}', f'set("{entity["name"]}", value)'],
                             [f"{cpp_value} {cpp}_property().get()", f"void {cpp}_property().set({cpp_value} value)"])
        python_lines = [f"{python}.get() -> {value}"]
        if is_reference:
            python_lines.append(f"{python}.get_or_none() -> {value} | None")
        python_lines.append(f"{python} = value  # {self.types.argument(node, dim, True)}")
        return _spelling(python_lines, [f"{cpp_value} {cpp}().get()", f"void {cpp}().set({cpp_value} value)"],
                         f"async_.{python}.get() -> Future[{value}]", f"spear::Future<{cpp_value}> async().{cpp}().get()")

    # Example ---------------------------------------------------------------------------------------------------------------

    def example(self) -> Spelling:
        """A program with the engine's own classes; it runs on every engine."""
        python = """import spear
from spear.unreal.CoreUObject import FVector
from spear.unreal.Engine import AStaticMeshActor

with spear.launch() as instance:
    game = instance.get_game()
    with instance.begin_frame():
        thing = game.spawn_actor(AStaticMeshActor)
        thing.SetActorScale3D(FVector(X=4, Y=4, Z=4))
        # a Future[FVector]:
        location = thing.async_.K2_GetActorLocation()
        hidden = thing.bHidden.get()
    with instance.end_frame():
        pass
    print(location.get(), hidden)"""
        cpp = """#include <spear/spear.hpp>
#include <spear/unreal/Engine/AStaticMeshActor.hpp>
namespace unreal = spear::unreal;

int main() {
    spear::Instance instance = spear::launch();
    spear::Game game = instance.game();
    spear::Future<unreal::FVector> location;
    {
        auto frame = instance.begin_frame();
        auto thing = game.spawn_actor<unreal::AStaticMeshActor>();
        thing.SetActorScale3D({4, 4, 4});
        location = thing.async().K2_GetActorLocation();
        bool hidden = thing.bHidden().get();
        frame.execute();
    }
    instance.end_frame().execute();
    double x = location.get().X;
}"""
        return _spelling([python], [cpp])


def _signature(head: str, parameters: list[str], tail: str) -> str:
    """A signature on one line where it is short, else with a line for each parameter."""
    line = head + ", ".join(parameters) + tail
    if len(line) <= _WIDTH or not parameters:
        return line
    return head + "\n    " + ",\n    ".join(parameters) + "\n" + tail


def _spelling(python: list[str], cpp: list[str], python_async: str = "", cpp_async: str = "") -> Spelling:
    short = not python_async and all(len(lines) == 1 and len(lines[0]) <= _SHORT and "\n" not in lines[0] for lines in (python, cpp))
    return Spelling(_code(python, python_async), _code(cpp, cpp_async), short)


def _code(lines: list[str], asynchronous: str) -> str:
    text = escape("\n".join(lines), quote=False)
    return f"{text}\n<i>{escape(asynchronous, quote=False)}</i>" if asynchronous else text
