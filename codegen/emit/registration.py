# SPDX-License-Identifier: MIT
"""Registration code of a module: ``*.generated.h``, ``*.gen.cpp``, ``MODULE.init.gen.cpp``.

The schema says what is reflected, its source tier how it is spelled in C++. The result fills the tables of
``UObject/GeneratedTables.h``; templates only lay out what is worked out here.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jinja2

from .cpp_names import (
    api, delegate_function, enum_function, file_id, flags, literal, meta_pairs, qualify, struct_function, value_type,
)
from .output import Output
from .property_tables import PropertyTables
from .schema import Entity, SchemaError, SchemaSet

_LEGACY = {"GENERATED_UCLASS_BODY", "GENERATED_UINTERFACE_BODY", "GENERATED_IINTERFACE_BODY"}
_DELEGATE_FORMS = {"single": 1, "multicast": 2, "sparse": 3}
_ENUM_FORMS = {"regular": 0, "namespaced": 1, "class": 2}


def emit(schemas: SchemaSet, output_dir: Path) -> Output:
    """Writes the registration code of the main schema's only module."""
    modules = schemas.main["modules"]
    if len(modules) != 1:
        raise SchemaError(f"registration code is made for one module at a time; the schema has {len(modules)}")
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).resolve().parent / "templates" / "registration"),
        undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True,
    )
    environment.filters["literal"] = literal
    module = modules[0]
    writer = _ModuleWriter(schemas, module["name"])
    output = Output(output_dir)
    for header in module["source"]["headers"]:
        if not header["generated"]:
            continue
        context = writer.header(header)
        stem = header["generated"].removesuffix(".generated.h")
        output.write(f"include/{stem}.generated.h", environment.get_template("header.h.j2").render(context))
        output.write(f"{stem}.gen.cpp", environment.get_template("source.cpp.j2").render(context))
    output.write(f"{module['name']}.init.gen.cpp", environment.get_template("module.cpp.j2").render(module=module["name"]))
    return output


class _ModuleWriter:
    def __init__(self, schemas: SchemaSet, module: str) -> None:
        self.schemas = schemas
        self.module = module
        self.api = api(module)
        self.package = f'TEXT("/Script/{module}")'

    # Headers ------------------------------------------------------------------------------------------------------------

    def header(self, header: Entity) -> dict[str, Any]:
        """Everything the two templates of a header need."""
        main = self.schemas.main
        path = header["path"]
        self.tables = PropertyTables(self.schemas, self.api)
        mine = {kind: [e for e in main[kind] if e["source"]["header"] == path] for kind in ("classes", "structs", "enums", "delegates")}
        for kind in ("classes", "structs"):
            mine[kind].sort(key=lambda e: e["source"]["line"])
        context: dict[str, Any] = {
            "module": self.module, "api": self.api, "package": self.package, "include": header["include"], "path": path,
            "generated": header["generated"], "file_id": file_id(self.module, path),
            "enums": [self.enum(e) for e in mine["enums"]],
            "delegates": [self.delegate(d) for d in mine["delegates"]],
            "structs": [self.struct(s) for s in mine["structs"]],
            "classes": [self.reflected_class(c) for c in mine["classes"]],
        }
        context["includes"] = sorted(self.tables.includes - {header["include"]})
        context["externs"] = sorted(self.tables.externs)
        return context

    # Enums, delegates, structs ------------------------------------------------------------------------------------------

    def enum(self, entity: Entity) -> dict[str, Any]:
        return {
            "name": entity["name"], "reflected_name": entity["reflected_name"], "cpp_type": entity["cpp_type"], "function": enum_function(entity),
            "form": _ENUM_FORMS[entity["form"]], "flags": 1 if "Flags" in entity["flags"] else 0, "meta": meta_pairs(entity["editor"]["meta"]),
            "entries": [{"name": e["name"], "value": e["value"], "meta": meta_pairs(e["editor"]["meta"])} for e in entity["entries"]],
        }

    def delegate(self, entity: Entity) -> dict[str, Any]:
        sparse = entity["source"].get("sparse") or {}
        block = f"{delegate_function(entity)}_Parms"
        return {
            "name": entity["reflected_name"], "function": delegate_function(entity), "statics": delegate_function(entity) + "_Statics", "block": block,
            "form": _DELEGATE_FORMS[entity["kind"]], "owner": entity["owner"], "sparse_owner": sparse.get("owner", "").removeprefix("A").removeprefix("U"),
            "sparse_property": sparse.get("property", ""), **self._callable(entity, block, delegate_function(entity) + "_Statics"),
        }

    def struct(self, entity: Entity) -> dict[str, Any]:
        source = entity["source"]
        body = source["generated_body"]
        statics = struct_function(entity) + "_Statics"
        no_export = body is None
        # A NoExport struct's C++ type lies elsewhere and may name its members otherwise: a mirror gives the offsets.
        container = f"{statics}::FMirror" if no_export else entity["name"]
        properties = self.tables.properties(entity["properties"], container, statics)
        if entity["super"]:
            self.tables.reference_struct(entity["super"])
        return {
            "name": entity["name"], "reflected_name": entity["reflected_name"], "function": struct_function(entity), "statics": statics,
            "super": entity["super"], "super_function": struct_function(self.schemas.structs[entity["super"]]) if entity["super"] in self.schemas.structs else None,
            "body_line": body["line"] if body else 0, "no_export": no_export,
            "mirror": [f"{qualify(p['source']['type_text'], p['type'])} {p['source']['cpp_name']};" for p in entity["properties"]] if no_export else [],
            "flags": flags("STRUCT_", [*entity["flags"], "Native"], "EStructFlags"), "properties": properties, "meta": meta_pairs(entity["editor"]["meta"]),
        }

    # Functions ----------------------------------------------------------------------------------------------------------

    def _callable(self, entity: Entity, block: str, statics: str) -> dict[str, Any]:
        """Parameter block and tables of a function or delegate."""
        members = []
        parameters = []
        for parameter in entity["parameters"]:
            type_text = qualify(parameter["source"]["type_text"], parameter["type"])
            parameters.append({"name": parameter["name"], "type_text": type_text, "is_reference": type_text.rstrip().endswith("&"),
                               "is_out": "OutParm" in parameter["flags"] and "ConstParm" not in parameter["flags"]})
            members.append({"name": parameter["name"], "type": self._stored_type(type_text, parameter["type"])})
        returns = entity["returns"]
        return_text = "void"
        if returns:
            return_text = qualify(returns["source"]["type_text"], returns["type"])
            members.append({"name": "ReturnValue", "type": self._stored_type(return_text, returns["type"])})
        return {
            "members": members, "parameters": parameters, "return_text": return_text, "has_return": bool(returns),
            "return_type": members[-1]["type"] if returns else "void",
            "tables": self.tables.parameters(entity, block, statics), "flags": flags("FUNC_", entity["flags"], "EFunctionFlags"),
            "meta": meta_pairs(entity["editor"]["meta"]),
        }

    @staticmethod
    def _stored_type(type_text: str, node: Entity) -> str:
        """The type of a parameter in its block. Plain C enums are stored as one byte, as their property is."""
        stored = value_type(type_text)
        return node["cpp"] if node["kind"] == "byte_enum" and not stored.startswith("TEnumAsByte") else stored

    def function(self, entity: Entity, owner: Entity, statics: str, cpp_class: str) -> dict[str, Any]:
        source = entity["source"]
        flag_names = set(entity["flags"])
        block = f"{owner['name']}_event{entity['name']}_Parms"
        described = self._callable(entity, block, statics)
        is_static = "Static" in flag_names
        is_const = bool(source["const"])
        arguments = ", ".join(
            f"reinterpret_cast<{p['type_text']}>(Parms.{p['name']})"
            if p["is_reference"] and m["type"].startswith("TEnumAsByte") and "TEnumAsByte" not in p["type_text"] else f"Parms.{p['name']}"
            for p, m in zip(described["parameters"], described["members"])
        )
        declaration = ", ".join(f"{p['type_text']} {p['name']}" for p in described["parameters"])
        types = ", ".join(p["type_text"] for p in described["parameters"])
        target = source["implementation"] or entity["name"]
        pointer = f"{described['return_text']} (*)({types})" if is_static else f"{described['return_text']} ({cpp_class}::*)({types}){' const' if is_const else ''}"
        return {
            "name": entity["name"], "statics": statics, "block": block, "is_static": is_static, "is_const": is_const, "is_event": "Event" in flag_names,
            "is_native": "Native" in flag_names, "custom_thunk": source["custom_thunk"], "target": target, "arguments": arguments, "declaration": declaration,
            "pointer": pointer, "validation": source["validation"], "needs_implementation": bool(source["implementation"]) and not source["implementation_declared"],
            "needs_validation": bool(source["validation"]) and not source["validation_declared"], **described,
        }

    # Classes ------------------------------------------------------------------------------------------------------------

    def reflected_class(self, entity: Entity) -> dict[str, Any]:
        source = entity["source"]
        name = entity["name"]
        statics = f"Z_Construct_UClass_{name}_Statics"
        interface = source.get("interface")
        body = source["generated_body"]
        cpp_class = interface["name"] if interface else name
        if entity["super"]:
            self.tables.reference_class(entity["super"])
        self.tables.reference_class(entity["within"])
        interfaces = []
        for used in entity["interfaces"]:
            self.tables.reference_class(used)
            interfaces.append({"name": used, "class": "U" + used[1:]})
        super_entity = self.schemas.classes.get(entity["super"] or "")
        inherited_within = super_entity["within"] if super_entity else "UObject"
        return {
            "name": name, "reflected_name": entity["reflected_name"], "statics": statics, "super": entity["super"],
            "super_cpp": entity["super"] or name, "within": entity["within"], "declares_within": entity["within"] != inherited_within and body is not None,
            "flags": flags("CLASS_", entity["flags"], "EClassFlags"), "config": entity["config"],
            "body_line": body["line"] if body else 0, "no_export": body is None, "legacy": bool(body) and body["macro"] in _LEGACY,
            "access": body["access"] if body else "", "constructor": self._constructor(entity), "interface": self._interface(interface), "interfaces": interfaces, "cpp_class": cpp_class,
            "functions": [self.function(f, entity, statics, cpp_class) for f in entity["functions"]],
            "properties": self.tables.properties(entity["properties"], name, statics), "meta": meta_pairs(entity["editor"]["meta"]),
            "declares_interfaces": bool(entity["interfaces"]),
        }

    @staticmethod
    def _interface(interface: Entity | None) -> dict[str, Any] | None:
        if interface is None:
            return None
        body = interface["generated_body"]
        return {"name": interface["name"], "body_line": body["line"], "legacy": body["macro"] in _LEGACY, "access": body["access"], "bases": [b["name"] for b in interface["bases"]]}

    def _constructor(self, entity: Entity) -> str:
        """How the class is made: "default" or "initializer" if it declares that constructor, "make_default"/"make_initializer" if the
        generated code has to declare it, depending on what its super class can take."""
        body = entity["source"]["generated_body"]
        kinds = {c["kind"] for c in entity["source"].get("constructors", []) if not c["deleted"]}
        if body and body["macro"] in _LEGACY:
            return "declare_initializer"
        if "object_initializer" in kinds:
            return "initializer"
        if "default" in kinds:
            return "default"
        return "make_initializer" if self._takes_initializer(entity["super"]) else "make_default"

    def _takes_initializer(self, name: str | None) -> bool:
        entity = self.schemas.classes.get(name or "")
        if entity is None:
            return True  # UObject, UInterface
        return self._constructor(entity) in ("initializer", "make_initializer", "declare_initializer")
