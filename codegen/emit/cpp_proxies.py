# SPDX-License-Identifier: MIT
"""Typed C++ proxies: one header for each class, struct and enum, ``spear/unreal/MODULE/TYPE.hpp``, over spear/proxy.hpp of the SDK.

A header includes its super class and defines nothing twice; the types that functions merely name are declared, and defined only where the
functions are called. Templates lay out what is worked out here.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import jinja2

from . import documentation as docs
from .cpp_names import literal
from .cpp_proxies_types import (
    KNOWN_STRUCTS, CppNames, class_name, entry_names, field_names, is_interface, is_object, member_names, parameter_names, plain_struct, referred,
    result_names, struct_name, takes_braces, underlying_type, unknown, value_type,
)
from .output import Output
from .parallel import for_each
from .schema import INTRINSIC_CLASSES, Module, SchemaSet
from .signatures import Parameter, Signature, deprecated_text, signature

Entity = Mapping[str, Any]

#: Functions with at least so many parameters that may be left out can be called with named arguments as well.
NAMED_FROM = 3
#: Types handed to a process at a time.
_CHUNK = 64
_WIDTH = 110


def emit(schemas: SchemaSet, output_dir: Path, *, progress: bool = False, jobs: int = 0) -> Output:
    """Writes ``spear/unreal/MODULE/TYPE.hpp`` for every type of the main modules, and reports what stays untyped."""
    environment = _environment()
    writer = _Writer(schemas)
    chunks = [
        (module, kind, entities[start:start + _CHUNK])
        for module in schemas.main_modules
        for kind, entities in _entities(module, schemas)
        for start in range(0, len(entities), _CHUNK)
    ]

    def work(chunk: tuple[Module, str, list[Entity]]) -> tuple[Output, dict[str, int]]:
        module, kind, entities = chunk
        output = Output(output_dir)
        template = environment.get_template(f"{kind}.hpp.j2")
        writer.untyped.clear()
        for entity in entities:
            file = _File(module.name)
            context = getattr(writer, f"describe_{kind}")(entity, file)
            output.write(writer.header_path(entity, kind), template.render(file=file, type=context))
        return output, dict(writer.untyped)

    results = for_each(chunks, work, jobs=jobs, progress=progress, title="C++ proxies")
    untyped: dict[str, int] = {}
    for _, found in results:
        for name, count in found.items():
            untyped[name] = untyped.get(name, 0) + count
    _report(untyped)
    return Output(output_dir).merge_all(output for output, _ in results).finish()


def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).resolve().parent / "templates" / "cpp_proxies"),
        undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True,
    )
    environment.filters["literal"] = literal
    return environment


def _entities(module: Module, schemas: SchemaSet) -> list[tuple[str, list[Entity]]]:
    """The types of a module that get a header; of types with one name only the one that the name means."""
    return [
        ("class", [e for e in module.classes if schemas.classes.get(e["name"]) is e]),
        ("struct", [e for e in module.structs if schemas.structs.get(e["name"]) is e]),
        ("enum", [e for e in module.enums if schemas.enums.get(e["name"]) is e]),
    ]


def _report(untyped: Mapping[str, int]) -> None:
    """Says which types are in no schema, on stderr: what refers to them is spear::Object or spear::Value."""
    if untyped:
        listed = ", ".join(f"{name} ({count})" for name, count in sorted(untyped.items(), key=lambda item: (-item[1], item[0]))[:12])
        more = f" and {len(untyped) - 12} more" if len(untyped) > 12 else ""
        print(f"C++ proxies: {len(untyped)} types are in no schema given, so references to them are spear::Object or spear::Value: {listed}{more}", file=sys.stderr)


@dataclass
class _File:
    """What a header includes and declares."""

    module: str
    includes: list[str] = field(default_factory=lambda: ["spear/proxy.hpp"])
    forward: list[str] = field(default_factory=list)
    more_includes: list[str] = field(default_factory=list)


class _Writer:
    def __init__(self, schemas: SchemaSet) -> None:
        self.schemas = schemas
        #: types in no schema -> how often they were wanted
        self.untyped: dict[str, int] = {}

    # Headers ------------------------------------------------------------------------------------------------------------

    def header_path(self, entity: Entity, kind: str) -> str:
        """The header of a type, as it is included."""
        name = class_name(entity) if kind == "class" else struct_name(entity["name"])
        return f"spear/unreal/{entity['module']}/{name}.hpp"

    def _header_of(self, kind: str, name: str) -> str:
        return self.header_path(getattr(self.schemas, {"class": "classes", "struct": "structs", "enum": "enums"}[kind])[name], kind)

    def _declare(self, kind: str, name: str) -> str:
        if kind == "class":
            return f"class {class_name(self.schemas.classes[name])};"
        if kind == "struct":
            return f"struct {struct_name(name)};"
        return f"enum class {struct_name(name)} : {underlying_type(self.schemas.enums[name])};"

    def _finish(self, file: _File, used: Iterable[tuple[str, str, bool]], own: Entity, needed: Iterable[tuple[str, str]] = (), wanted: Iterable[tuple[str, str]] = ()) -> None:
        """Fills in the declarations of what is used, and the includes of what must be defined before (needed) and after (wanted)."""
        needed, own_key = set(needed), (own["kind"], own["name"])
        file.includes += sorted({self._header_of(*key) for key in needed} - set(file.includes))
        names = {(kind, name) for kind, name, _ in used} - needed | ({own_key} if own["kind"] != "enum" else set())
        file.forward = sorted(self._declare(*key) for key in names if self._header_of(*key) not in file.includes)
        file.more_includes = sorted({self._header_of(*key) for key in wanted if key not in needed and key != own_key} - set(file.includes))

    def _type(self, node: Entity, used: set[tuple[str, str, bool]], array_dim: int = 1) -> str:
        used.update(referred(node, self.schemas))
        for name in unknown(node, self.schemas):
            self.untyped[name] = self.untyped.get(name, 0) + 1
        return value_type(node, self.schemas, array_dim)

    # Classes ------------------------------------------------------------------------------------------------------------

    def describe_class(self, entity: Entity, file: _File) -> dict[str, Any]:
        name = class_name(entity)
        names = member_names(entity)
        used: set[tuple[str, str, bool]] = set()
        described: dict[str, Any] = {
            "name": name, "unreal": name if is_interface(entity) else entity["name"], "comment": self._comment(entity), "attributes": "",
            "interface": is_interface(entity), "functions": [], "statics": [], "properties": [], "results": [], "named": [], "markers": "",
        }
        function_names = {function["name"] for function in entity["functions"]}
        for function in entity["functions"]:
            shape = signature(function, self.schemas)
            if shape.callable:
                described["statics" if shape.static else "functions"].append(self._function(function, shape, names[function["name"]], name, described, used))
        # What calls need is defined behind the class; what properties lead to is for who follows them to include.
        wanted = {(kind, used_name) for kind, used_name, _ in used if kind == "struct"}
        for item in entity["properties"]:
            own = names[item["name"]] + ("_property" if item["name"] in function_names else "")
            described["properties"].append({
                "name": own, "unreal": item["name"], "type": self._type(item["type"], used, item["array_dim"]), "comment": self._property_comment(item),
                "attributes": self._deprecated(deprecated_text(item)),
            })
        self._hierarchy(entity, described, file)
        wanted |= {(kind, used_name) for kind, used_name, _ in used if kind == "enum"}
        self._finish(file, used, {"kind": "class", "name": entity["name"]}, wanted=wanted)
        return described

    def _hierarchy(self, entity: Entity, described: dict[str, Any], file: _File) -> None:
        """Super class and interfaces: the layers that the class is made of."""
        name = described["name"]
        above = self._super_of(entity)
        interfaces = self._interfaces_of(entity)
        base = f"unreal::{class_name(above)}" if above else "spear::Object"
        layers = f"spear::ProxyTraits<spear::unreal::{class_name(above)}>::Layers<Base>" if above else "Base"
        statics = f"spear::ProxyTraits<spear::unreal::{class_name(above)}>::Statics<Base>" if above else "Base"
        if described["statics"]:
            base = f"{name}_Statics<{base}>"
            layers = f"spear::unreal::{name}_Statics<{layers}>"
            statics = f"spear::unreal::{name}_Statics<{statics}>"
        for interface in interfaces:
            base = f"{class_name(interface)}_Members<{base}>"
            layers = f"spear::unreal::{class_name(interface)}_Members<{layers}>"
        described["base"] = f"{name}_Members<{base}>"
        described["layers"] = f"spear::unreal::{name}_Members<{layers}>"
        described["static_layers"] = statics
        described["markers"] = "".join(f", public spear::Implements<{class_name(i)}>" for i in interfaces)
        for other in ([above] if above else []) + interfaces:
            file.includes.append(self.header_path(other, "class"))

    def _super_of(self, entity: Entity) -> Entity | None:
        """The nearest super class that a schema has."""
        if not entity["super"]:
            return None
        for name in (entity["super"], *self.schemas.ancestors(entity["super"])):
            found = self.schemas.classes.get(name)
            if found is not None:
                return found
        if entity["super"] not in INTRINSIC_CLASSES:
            self.untyped[entity["super"]] = self.untyped.get(entity["super"], 0) + 1
        return None

    def _interfaces_of(self, entity: Entity) -> list[Entity]:
        """The interfaces that the class adds to those of its super classes, with the interfaces above them, those last derived last."""
        inherited: set[str] = set()
        above = self._super_of(entity)
        while above is not None:
            inherited.update(found["name"] for found in self._all_interfaces(above))
            above = self._super_of(above)
        return [found for found in self._all_interfaces(entity) if found["name"] not in inherited]

    def _all_interfaces(self, entity: Entity) -> list[Entity]:
        found: dict[str, Entity] = {}
        for reference in entity["interfaces"]:
            interface = self.schemas.class_of_reference(reference)
            if interface is None or not is_interface(interface):
                self.untyped[reference] = self.untyped.get(reference, 0) + 1
                continue
            chain: list[Entity] = [interface]
            while (above := self._super_of(chain[-1])) is not None and is_interface(above):
                chain.append(above)
            for item in reversed(chain):
                found.setdefault(item["name"], item)
        return list(found.values())

    # Functions ----------------------------------------------------------------------------------------------------------

    def _function(self, function: Entity, shape: Signature, name: str, owner: str, described: dict[str, Any], used: set[tuple[str, str, bool]]) -> dict[str, Any]:
        names = parameter_names(p.name for p in shape.inputs)
        result = self._result(function, shape, name, owner, described, used)
        last_required = max((i for i, p in enumerate(shape.inputs) if not p.optional), default=-1)
        templates, parameters, arguments = [], [], ["*this", literal(function["name"])]
        for index, parameter in enumerate(shape.inputs):
            own = names[parameter.name]
            type_text = self._type(parameter.type, used, parameter.array_dim)
            single = is_object(parameter.type, parameter.array_dim)
            braces = takes_braces(parameter.type, parameter.array_dim)
            concept = f"{'Optional' if parameter.optional else ''}{'Object' if single else ''}Argument"
            default = "" if single and not parameter.optional else f" = {type_text if braces or not parameter.optional else 'spear::Omitted'}"
            templates.append(f"spear::{concept}<{type_text}> {own}_T{default}")
            omitted = f" = spear::omitted<{own}_T>" if braces else " = {}"
            parameters.append(f"const {own}_T& {own}{omitted if index > last_required else ''}")
            arguments.append(f"spear::object_input({literal(parameter.name)}, {own})" if single else f"spear::input<{type_text}>({literal(parameter.name)}, {own})")
        optional = [p for p in shape.inputs if p.optional and not p.keyword_only]
        named = ""
        if len(optional) >= NAMED_FROM:
            named = f"{owner}_{name}_Arguments"
            described["named"].append({"name": named, "unreal": "", "function": name, "fields": [
                {"name": names[p.name], "unreal": p.name, "type": self._deferred(value_type(p.type, self.schemas, p.array_dim)), "holder": self._argument_holder(p), "optional": p.optional}
                for p in shape.inputs
            ]})
        return {
            "name": name, "unreal": function["name"], "comment": self._function_comment(function, shape), "attributes": self._deprecated(shape.deprecated),
            "template": ", ".join(templates), "result": result, "parameters": ", ".join(parameters), "arguments": ", ".join(arguments), "named": named,
        }

    @staticmethod
    def _deferred(type_text: str) -> str:
        """The type of a member of a struct that is to be defined where its members' types may only be declared."""
        return f"typename spear::Deferred<{type_text}, SpearLazy>::type" if "unreal::" in type_text and type_text.removeprefix("unreal::") not in KNOWN_STRUCTS else type_text

    @staticmethod
    def _argument_holder(parameter: Parameter) -> str:
        single = is_object(parameter.type, parameter.array_dim)
        return ("" if parameter.optional else "Required") + ("ObjectField" if single else "Field")

    def _result(self, function: Entity, shape: Signature, name: str, owner: str, described: dict[str, Any], used: set[tuple[str, str, bool]]) -> str:
        if shape.returns == "none":
            return "void"
        types = [self._type(output.type, used, output.array_dim) for output in shape.outputs]
        if shape.returns == "single":
            return types[0]
        names = result_names(output.name for output in shape.outputs)
        result = f"{owner}_{name}_Result"
        described["results"].append({"name": result, "unreal": f"{function['name']}_Result", "function": name, "fields": [
            {"name": names[output.name], "unreal": output.name, "type": self._deferred(type_text)} for output, type_text in zip(shape.outputs, types, strict=True)
        ]})
        return f"unreal::{result}"

    # Structs and enums --------------------------------------------------------------------------------------------------

    def describe_struct(self, entity: Entity, file: _File) -> dict[str, Any]:
        name = struct_name(entity["name"])
        if entity["name"] in KNOWN_STRUCTS:
            found = {item["name"] for item in entity["properties"]}
            if found != set(KNOWN_STRUCTS[entity["name"]]):
                print(f"C++ proxies: {entity['name']} has other members in the schema than in spear/unreal_types.hpp, whose are used", file=sys.stderr)
        plain = plain_struct(entity["name"], self.schemas)
        if plain:
            file.includes = ["spear/unreal_types.hpp", "spear/unreal_paths.hpp"]
            return {"name": name, "known": plain, "comment": self._comment(entity)}
        used: set[tuple[str, str, bool]] = set()
        members = self._all_fields(entity)
        names = field_names(entity, members)
        fields = []
        for item in members:
            type_text = self._type(item["type"], used, item["array_dim"])
            target = type_text.removeprefix("unreal::")
            holder = f"spear::ObjectField<{target}>" if is_object(item["type"], item["array_dim"]) else f"spear::Field<{type_text}>"
            fields.append({"name": names[item["name"]], "unreal": item["name"], "type": type_text, "holder": holder, "comment": self._property_comment(item)})
        needed = {(kind, used_name) for kind, used_name, inside in used if kind == "struct" and not inside}
        for item in members:
            if item["array_dim"] > 1:
                needed.update((kind, used_name) for kind, used_name, _ in referred(item["type"], self.schemas) if kind in ("struct", "class"))
        wanted = {(kind, used_name) for kind, used_name, inside in used if inside or kind == "enum"}
        self._finish(file, used, {"kind": "struct", "name": entity["name"]}, needed - {("struct", entity["name"])}, wanted)
        return {"name": name, "unreal": entity["name"], "known": "", "comment": self._comment(entity), "fields": fields}

    def _all_fields(self, entity: Entity) -> list[Entity]:
        """The members, those of the super structs first; of two with one name the derived one's."""
        found: dict[str, Entity] = {}
        chain = [self.schemas.structs[name] for name in reversed(self.schemas.ancestors(entity["name"])) if name in self.schemas.structs]
        for struct in (*chain, entity):
            found.update({item["name"]: item for item in struct["properties"]})
        return list(found.values())

    def describe_enum(self, entity: Entity, file: _File) -> dict[str, Any]:
        file.includes = ["spear/proxy_types.hpp"]
        entries = [
            {"name": name, "unreal": unreal, "value": self._literal(value), "comment": self._comment(entry)}
            for (name, unreal, value), entry in zip(entry_names(entity), entity["entries"])
        ]
        return {
            "name": struct_name(entity["name"]), "unreal": entity["name"], "comment": self._comment(entity), "attributes": "",
            "underlying": underlying_type(entity), "entries": entries, "flags": "Flags" in entity["flags"],
        }

    # Texts --------------------------------------------------------------------------------------------------------------

    @staticmethod
    def _literal(value: int) -> str:
        return "(-9223372036854775807 - 1)" if value == -(2**63) else str(value)

    @staticmethod
    def _deprecated(text: str) -> str:
        if not text:
            return ""
        escaped = "".join(c if c.isprintable() else " " for c in text).replace("\\", "\\\\").replace('"', '\\"')
        return f'[[deprecated("{escaped}")]] '

    @staticmethod
    def _lines(lines: Iterable[str]) -> list[str]:
        """Lines that are safe behind ///: no line continues in the next, nothing is unprintable."""
        result = ["".join(c if c.isprintable() else " " for c in line).rstrip().rstrip("\\").rstrip() for line in lines]
        while result and not result[-1]:
            result.pop()
        return result

    def _comment(self, entity: Entity) -> list[str]:
        return self._lines(docs.body_lines(docs.documentation(entity), _WIDTH))

    def _property_comment(self, item: Entity) -> list[str]:
        lines = docs.body_lines(docs.documentation(item), _WIDTH)
        facts = [text for text in (docs.units_of(item), docs.range_of(item), "editor only" if "EditorOnly" in item["flags"] else "") if text]
        if facts:
            lines.append(f"({', '.join(facts)})")
        return self._lines(lines)

    def _function_comment(self, function: Entity, shape: Signature) -> list[str]:
        documented = docs.documentation(function)
        lines = docs.body_lines(documented, _WIDTH)
        for parameter in shape.inputs:
            text = documented.parameter(parameter.name)
            default = parameter.default_cpp or parameter.default_source or parameter.default_text
            if parameter.keyword_only:
                continue
            if parameter.optional and default is not None:
                text = f"{text.rstrip('.')}{'; ' if text else ''}default {default or 'empty'}"
            if text:
                lines.append(f"@param {parameter.name} {' '.join(text.split())}")
        if documented.returns:
            lines.append(f"@return {documented.returns}")
        lines += [f"{label}: {' '.join(text.split())}" for label, text in documented.notes]
        if shape.latent:
            lines.append("Latent: the result comes when the action has ended, frames later; use async().")
        return self._lines(lines)


__all__ = ["NAMED_FROM", "CppNames", "emit"]
