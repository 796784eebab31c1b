# SPDX-License-Identifier: MIT
"""Initialisers of FPropertyTable, and which headers and generated functions they need."""

from __future__ import annotations

import re
from typing import Any

from .cpp_names import api, delegate_function, enum_function, flags, literal, meta_pairs, qualify, struct_function, value_type
from .schema import Entity, SchemaError, SchemaSet

_KINDS = {
    "bool": "Bool", "int8": "Int8", "int16": "Int16", "int32": "Int32", "int64": "Int64", "uint8": "UInt8", "uint16": "UInt16", "uint32": "UInt32",
    "uint64": "UInt64", "float": "Float", "double": "Double", "string": "String", "name": "Name", "text": "Text", "enum": "Enum", "byte_enum": "ByteEnum",
    "object": "Object", "class": "Class", "weak_object": "WeakObject", "lazy_object": "LazyObject", "soft_object": "SoftObject", "soft_class": "SoftClass",
    "interface": "Interface", "struct": "Struct", "array": "Array", "set": "Set", "map": "Map", "optional": "Optional", "delegate": "Delegate",
    "multicast_delegate": "MulticastDelegate", "sparse_delegate": "SparseDelegate", "field_path": "FieldPath",
}
_WRAPPERS = re.compile(r"^\s*(const\s+)?(TSubclassOf|TSoftObjectPtr|TSoftClassPtr|TWeakObjectPtr|TLazyObjectPtr|TScriptInterface|TAutoWeakObjectPtr)\b")

#: Classes that the run time itself provides ("intrinsic"): in no schema, in these headers.
INTRINSIC_INCLUDES = {
    "UObject": "UObject/Object.h", "UClass": "UObject/Class.h", "UStruct": "UObject/Class.h", "UScriptStruct": "UObject/Class.h", "UField": "UObject/Class.h",
    "UFunction": "UObject/Class.h", "UEnum": "UObject/Class.h", "UPackage": "UObject/Package.h", "UInterface": "UObject/Interface.h",
}


class PropertyTables:
    """Tables of one header's properties; collects the includes and declarations that they need."""

    def __init__(self, schemas: SchemaSet, module_api: str) -> None:
        self.schemas = schemas
        self.api = module_api
        self.includes: set[str] = set()
        self.externs: set[str] = set()

    # References ---------------------------------------------------------------------------------------------------------

    def reference_class(self, name: str) -> str:
        """The address of a function that gives the UClass of a C++ class or interface name."""
        entity = self.schemas.class_of_reference(name)
        if entity is not None:
            self.includes.add(self.schemas.includes[entity["name"]])
            return f"&{entity['name']}::StaticClass"
        name = "UInterface" if name == "IInterface" else name  # FScriptInterface: any interface
        if name in INTRINSIC_INCLUDES:
            self.includes.add(INTRINSIC_INCLUDES[name])
            return f"&{name}::StaticClass"
        raise SchemaError(f"class {name} is in no schema given; is the module that declares it missing from --import (DEPENDS)?")

    def reference_struct(self, name: str) -> str:
        entity = self.schemas.structs.get(name)
        if entity is None:
            raise SchemaError(f"struct {name} is in no schema given; is the module that declares it missing from --import (DEPENDS)?")
        self.includes.add(self.schemas.includes[name])
        self.externs.add(f"{api(entity['module'])} UScriptStruct* {struct_function(entity)}();")
        return f"&{struct_function(entity)}"

    def reference_enum(self, name: str) -> str:
        entity = self.schemas.enums.get(name)
        if entity is None:
            raise SchemaError(f"enum {name} is in no schema given; is the module that declares it missing from --import (DEPENDS)?")
        self.includes.add(self.schemas.includes[name])
        self.externs.add(f"{api(entity['module'])} UEnum* {enum_function(entity)}();")
        return f"&{enum_function(entity)}"

    def reference_delegate(self, node: Entity) -> str:
        entity = self.schemas.delegates.get((node.get("owner") or "", node["name"]))
        if entity is None:
            raise SchemaError(f"delegate {node['name']} is in no schema given; is the module that declares it missing from --import (DEPENDS)?")
        self.includes.add(self.schemas.includes[entity["name"]] if entity["name"] in self.schemas.includes else self.schemas.includes[entity["owner"]])
        self.externs.add(f"{api(entity['module'])} UFunction* {delegate_function(entity)}();")
        return f"&{delegate_function(entity)}"

    # Tables -------------------------------------------------------------------------------------------------------------

    def properties(self, properties: list[Entity], container: str, statics: str) -> list[dict[str, Any]]:
        """Tables of the members of a class or struct."""
        tables = []
        for prop in properties:
            member = prop["source"]["cpp_name"]
            type_text = qualify(prop["source"]["type_text"], prop["type"])
            table = self._table(prop["name"], prop["type"], type_text, prop["flags"], prop["editor"]["meta"], f"Prop_{member}")
            fields = table["fields"]
            if prop["array_dim"] != 1:
                fields["ArrayDim"] = prop["array_dim"]
            if prop["type"].get("bitfield"):
                table["set_bit"] = f"static_cast<{container}*>(Container)->{member} = 1;"
                fields["SetBit"] = f"&{statics}::SetBit_{member}"
                fields["OuterSize"] = f"sizeof({container})"
            else:
                fields["Offset"] = f"SPEAR_OFFSET({container}, {member})"
                fields["ElementSize"] = f"sizeof(std::remove_all_extents_t<decltype({container}::{member})>)"
                table["proof"] = {"actual": f"std::remove_all_extents_t<decltype({container}::{member})>", "written": type_text}
            for key, verb in (("setter", "Setter"), ("getter", "Getter")):
                if prop.get(f"native_{key}"):
                    table[key] = prop["source"][key]
                    fields[verb] = f"&{statics}::{verb}_{member}"
            if prop.get("rep_notify"):
                fields["RepNotify"] = literal(prop["rep_notify"])
            table.update(member=member, container=container, type_text=value_type(type_text), is_bool="bitfield" in prop["type"])
            tables.append(table)
        return tables

    def parameters(self, function: Entity, block: str, statics: str) -> list[dict[str, Any]]:
        """Tables of the parameters of a function, the return value last."""
        entries = list(function["parameters"])
        if function["returns"]:
            entries.append({**function["returns"], "name": "ReturnValue"})
        tables = []
        for entry in entries:
            type_text = qualify(entry["source"]["type_text"], entry["type"])
            name = function.get("name", "")
            table = self._table(entry["name"], entry["type"], type_text, entry["flags"], entry["editor"]["meta"], f"{name}_{entry['name']}")
            if entry.get("array_dim", 1) != 1:
                raise SchemaError(f"{name}: parameter {entry['name']} is a C array; Unreal reflects no such parameters")
            member = entry["name"]
            if entry["type"].get("bitfield"):
                raise SchemaError(f"{name}: parameter {member} is a bit-field")
            table["fields"]["Offset"] = f"SPEAR_OFFSET({block}, {member})"
            table["fields"]["ElementSize"] = f"sizeof({block}::{member})"
            tables.append(table)
        return tables

    def _table(self, name: str, node: Entity, type_text: str, flag_names: list[str], meta: dict[str, str], variable: str) -> dict[str, Any]:
        fields: dict[str, Any] = {"Name": literal(name), "Kind": f"EPropertyKind::{_KINDS[node['kind']]}"}
        children: list[dict[str, Any]] = []
        kind = node["kind"]
        if kind == "enum":
            fields["Underlying"] = f"EPropertyKind::{_KINDS[node['underlying']]}"
        fields["Flags"] = flags("CPF_", flag_names, "uint64")
        if kind in ("enum", "byte_enum"):
            fields["EnumFunc"] = self.reference_enum(node["name"])
        elif kind == "struct":
            fields["StructFunc"] = self.reference_struct(node["name"])
        elif kind in ("object", "class", "weak_object", "lazy_object", "soft_object", "soft_class", "interface"):
            fields["ClassFunc"] = self.reference_class(node["name"])
        elif kind in ("delegate", "multicast_delegate", "sparse_delegate"):
            fields["SignatureFunc"] = self.reference_delegate(node)
        elif kind == "field_path":
            fields["FieldClass"] = literal(node["name"].removeprefix("F"))
        elements = _template_arguments(type_text)
        for index, (part, slot) in enumerate((("key", "Key"), ("inner", "Inner"), ("value", "Inner"))):
            if part in node:
                element_text = elements[1 if part == "value" else 0] if len(elements) > (1 if part == "value" else 0) else ""
                child = self._table(f"{name}_Key" if part == "key" else name, node[part], element_text, _inner_flags(element_text, flag_names), {}, f"{variable}_{part}")
                children.append(child)
                fields[slot] = f"&{{statics}}::{child['variable']}"
        pairs = meta_pairs(meta)
        return {"variable": variable, "fields": fields, "children": children, "meta": pairs, "set_bit": "", "setter": "", "getter": "", "proof": None}


def _inner_flags(element_text: str, outer_flags: list[str]) -> list[str]:
    """Flags of an element, key or value: from its own text, and instancing from the container's."""
    names = []
    if "TObjectPtr" in element_text.split("<")[0]:
        names += ["TObjectPtr", "UObjectWrapper"]
    elif _WRAPPERS.match(element_text):
        names.append("UObjectWrapper")
    if "ContainsInstancedReference" in outer_flags and ("*" in element_text or "TObjectPtr" in element_text):
        names.append("InstancedReference")
        if "Parm" not in outer_flags:
            names.append("ExportObject")
    return names


def _template_arguments(type_text: str) -> list[str]:
    """The arguments of the outermost template, split at its own commas."""
    start = type_text.find("<")
    if start < 0:
        return []
    depth, begin, parts = 0, start + 1, []
    for index in range(start, len(type_text)):
        char = type_text[index]
        depth += (char in "<(") - (char in ">)")
        if (char == "," and depth == 1) or (char == ">" and depth == 0):
            parts.append(type_text[begin:index].strip())
            begin = index + 1
            if depth == 0:
                break
    return parts
