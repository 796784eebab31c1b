# SPDX-License-Identifier: MIT
"""Types and names of Unreal as types and names of C++ with the SDK: what proxies, and their reference, are written with. No input or output.

- ``value_type(node, schemas)``: the C++ type that holds a value, as functions return it and properties read it;
- ``MEMBER_WORDS``, ``FIELD_WORDS``, ``TypeNames``: names.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from .names import CPP_WORDS, cpp_name as _marked_name, short_entry_name
from .schema import INTRINSIC_CLASSES, SchemaSet

Entity = Mapping[str, Any]

#: The structs of spear/unreal_types.hpp, with their members: written by hand, used instead of generated ones.
KNOWN_STRUCTS: Mapping[str, tuple[str, ...]] = {
    "FVector": ("X", "Y", "Z"), "FVector2D": ("X", "Y"), "FVector4": ("X", "Y", "Z", "W"), "FRotator": ("Pitch", "Yaw", "Roll"),
    "FQuat": ("X", "Y", "Z", "W"), "FTransform": ("Rotation", "Translation", "Scale3D"), "FLinearColor": ("R", "G", "B", "A"),
    "FColor": ("B", "G", "R", "A"), "FIntPoint": ("X", "Y"), "FIntVector": ("X", "Y", "Z"),
}


def plain_struct(name: str, schemas: SchemaSet) -> str | None:
    """The struct of KNOWN_STRUCTS that a struct is, or derives from without members of its own (FVector_NetQuantize); None for all others."""
    while name not in KNOWN_STRUCTS:
        entity = schemas.structs.get(name)
        if entity is None or entity["properties"] or not entity["super"]:
            return None
        name = entity["super"]
    return name


#: Macros of the C and C++ libraries and compilers that are no names of anything.
_MACROS = frozenset(
    "BIG_ENDIAN BYTE_ORDER DOMAIN EOF FALSE HUGE HUGE_VAL IN INFINITY INT_MAX INT_MIN LITTLE_ENDIAN NAN NULL OUT OVERFLOW PDP_ENDIAN PI RAND_MAX TRUE "
    "UNDERFLOW alloca assert errno i386 linux major makedev minor offsetof setjmp signbit stderr stdin stdout unix va_arg va_copy va_end va_start".split()
)

#: Namespaces that generated code names, and its own words.
_OWN_WORDS = frozenset({"std", "spear", "unreal", "fmt", "SpearBase", "SpearLazy", "spear_call_mode", "spear_target"}) | _MACROS

#: What objects, futures and paths have themselves (object.hpp, future.hpp, typed_property.hpp): functions and properties get an underscore.
MEMBER_WORDS = _OWN_WORDS | {
    "async", "async_get", "async_set", "call", "cast", "class_name", "class_path", "default_object", "derived_classes", "derives_from", "get", "get_class",
    "invoke", "is_a", "is_null", "is_ready", "is_valid", "key", "operation", "path", "path_name", "property", "ref", "send", "send_set", "session", "set",
    "super_class", "unreal_name", "valid", "value_type", "wait", "StaticsOf", "Layers",
}

#: The same for members of structs, which are members of paths too.
FIELD_WORDS = _OWN_WORDS | {"async", "async_get", "async_set", "get", "path", "property", "send", "send_set", "set", "value_type", "Layers"}

_NUMBERS = {
    "bool": "bool", "int8": "std::int8_t", "int16": "std::int16_t", "int32": "std::int32_t", "int64": "std::int64_t", "uint8": "std::uint8_t",
    "uint16": "std::uint16_t", "uint32": "std::uint32_t", "uint64": "std::uint64_t", "float": "float", "double": "double",
}
_TEXTS = frozenset({"string", "utf8_string", "ansi_string", "name", "text", "field_path"})
_OBJECTS = frozenset({"object", "weak_object", "lazy_object", "interface"})
_ENUMS = frozenset({"enum", "byte_enum"})
_ORDERED = frozenset(_NUMBERS) | _TEXTS | _ENUMS | {"soft_object", "soft_class"}


def cpp_name(name: str, words: Iterable[str] = ()) -> str:
    """An identifier of C++ that is none of its words and none of ``words``; a name that ends in an underscore already is no word."""
    marked = _marked_name(name, words)
    return name if marked == name + "_" and name not in CPP_WORDS and name not in words else marked


def is_interface(entity: Entity) -> bool:
    return "Interface" in entity["flags"]


def class_name(entity: Entity) -> str:
    """The name of a class's proxy; interfaces go by their I name."""
    name: str = entity["name"]
    return cpp_name("I" + name[1:] if is_interface(entity) else name, _OWN_WORDS)


def struct_name(name: str) -> str:
    """The name of a struct or enum."""
    return cpp_name(name, _OWN_WORDS)


def proxy_class(name: str, schemas: SchemaSet) -> str | None:
    """The proxy that a reference to a class means; None if it is in no schema."""
    entity = schemas.class_of_reference(name)
    return class_name(entity) if entity else None


def object_type(name: str, schemas: SchemaSet) -> str:
    """The C++ type of a reference to an object of a class: its proxy, spear::Class, or spear::Object for what no schema knows."""
    if name == "UClass":
        return "spear::Class"
    proxy = proxy_class(name, schemas)
    return f"unreal::{proxy}" if proxy else "spear::Object"


def value_type(node: Entity, schemas: SchemaSet, array_dim: int = 1) -> str:
    """The C++ type that holds a value of a type node (of ``array_dim`` of them)."""
    element = _element_type(node, schemas)
    return element if array_dim <= 1 else f"std::array<{element}, {array_dim}>"


def _element_type(node: Entity, schemas: SchemaSet) -> str:
    kind = node["kind"]
    if kind in _NUMBERS:
        return _NUMBERS[kind]
    if kind in _TEXTS:
        return "std::string"
    if kind in _ENUMS:
        return f"unreal::{struct_name(node['name'])}" if node["name"] in schemas.enums else "spear::Value"
    if kind in _OBJECTS:
        return object_type(node["name"], schemas)
    if kind == "class":
        target = proxy_class(node["name"], schemas)
        return f"spear::SubclassOf<unreal::{target}>" if target else "spear::Class"
    if kind in ("soft_object", "soft_class"):
        template = "SoftObject" if kind == "soft_object" else "SoftClass"
        return f"spear::{template}<{object_type(node['name'], schemas)}>"
    if kind == "struct":
        plain = plain_struct(node["name"], schemas)
        return f"unreal::{plain or struct_name(node['name'])}" if plain or node["name"] in schemas.structs else "spear::Value"
    if kind == "array":
        return f"std::vector<{_element_type(node['inner'], schemas)}>"
    if kind == "set":
        container = "std::set" if node["inner"]["kind"] in _ORDERED else "std::vector"
        return f"{container}<{_element_type(node['inner'], schemas)}>"
    if kind == "optional":
        return f"std::optional<{_element_type(node['inner'], schemas)}>"
    if kind == "map":
        ordered = node["key"]["kind"] in _ORDERED and _element_type(node["key"], schemas) != "spear::Value"
        return f"{'std::map' if ordered else 'spear::KeyValues'}<{_element_type(node['key'], schemas)}, {_element_type(node['value'], schemas)}>"
    if kind == "delegate":
        return "spear::Delegate"
    if kind in ("multicast_delegate", "sparse_delegate"):
        return "std::vector<spear::Delegate>"
    return "spear::Value"


def is_object(node: Entity, array_dim: int = 1) -> bool:
    """Whether values are one object (or null)."""
    return node["kind"] in _OBJECTS and array_dim <= 1


def takes_braces(node: Entity, array_dim: int = 1) -> bool:
    """Whether an argument may reasonably be written as a list in braces."""
    return array_dim > 1 or node["kind"] in ("struct", "array", "set", "map", "delegate", "multicast_delegate", "sparse_delegate")


def referred(node: Entity, schemas: SchemaSet, inside: bool = False) -> Iterator[tuple[str, str, bool]]:
    """The generated types that a node names: ("class" | "struct" | "enum", its name in the schemas, whether in a container or by reference)."""
    kind = node["kind"]
    if kind in _ENUMS:
        if node["name"] in schemas.enums:
            yield "enum", node["name"], inside
    elif kind in _OBJECTS or kind in ("class", "soft_object", "soft_class"):
        entity = schemas.class_of_reference(node["name"])
        if entity:
            yield "class", entity["name"], inside and kind in _OBJECTS
    elif kind == "struct":
        if node["name"] in schemas.structs and plain_struct(node["name"], schemas) is None:
            yield "struct", node["name"], inside
    else:
        for part in ("key", "value", "inner"):
            if part in node:
                yield from referred(node[part], schemas, inside or kind != "optional")


def unknown(node: Entity, schemas: SchemaSet) -> Iterator[str]:
    """The names of types in a node that no schema knows, so that it is untyped there."""
    kind = node["kind"]
    if kind in _ENUMS:
        if node["name"] not in schemas.enums:
            yield node["name"]
    elif kind in _OBJECTS or kind in ("class", "soft_object", "soft_class"):
        if schemas.class_of_reference(node["name"]) is None and node["name"] not in INTRINSIC_CLASSES and node["name"] != "IInterface":
            yield node["name"]
    elif kind == "struct":
        if node["name"] not in schemas.structs and node["name"] not in KNOWN_STRUCTS:
            yield node["name"]
    else:
        for part in ("key", "value", "inner"):
            if part in node:
                yield from unknown(node[part], schemas)


_RANGES = {
    "std::uint8_t": (0, 2**8 - 1), "std::int8_t": (-(2**7), 2**7 - 1), "std::uint16_t": (0, 2**16 - 1), "std::int16_t": (-(2**15), 2**15 - 1),
    "std::int32_t": (-(2**31), 2**31 - 1), "std::uint32_t": (0, 2**32 - 1), "std::int64_t": (-(2**63), 2**63 - 1), "std::uint64_t": (0, 2**63 - 1),
}


def underlying_type(entity: Entity) -> str:
    """The integer type of an enum: as the header says if that is known and fits all values, else the first that does."""
    values = [entry["value"] for entry in entity["entries"]] or [0]
    written = _NUMBERS.get(entity.get("source", {}).get("underlying", ""), "")
    for candidate in (written, "std::uint8_t", "std::int32_t", "std::uint32_t", "std::int64_t"):
        low, high = _RANGES.get(candidate, (1, 0))
        if low <= min(values) and max(values) <= high:
            return candidate
    return "std::int64_t"


class CppNames:
    """The C++ names of everything in one scope: distinct ones. Names that need no change come first, then the others in order."""

    def __init__(self, unreal_names: Iterable[str], reserved: Iterable[str] = ()) -> None:
        words = frozenset(reserved)
        listed = list(dict.fromkeys(unreal_names))
        self._names: dict[str, str] = {}
        used: set[str] = set()
        wanted = {unreal: cpp_name(unreal, words) for unreal in listed}
        for unreal in listed:
            if wanted[unreal] == unreal:
                self._names[unreal] = unreal
                used.add(unreal)
        for unreal in listed:
            if unreal not in self._names:
                name, number = wanted[unreal], 1
                while name in used:
                    number += 1
                    name = f"{wanted[unreal]}_{number}"
                self._names[unreal] = name
                used.add(name)

    def __getitem__(self, unreal_name: str) -> str:
        return self._names[unreal_name]


def member_names(entity: Entity) -> CppNames:
    """The names of a class's own functions and properties."""
    own = {class_name(entity), class_name(entity) + "_Members", class_name(entity) + "_Statics"}
    return CppNames([f["name"] for f in entity["functions"]] + [p["name"] for p in entity["properties"]], MEMBER_WORDS | own)


def field_names(entity: Entity, fields: Iterable[Entity]) -> CppNames:
    """The names of a struct's members."""
    return CppNames([p["name"] for p in fields], FIELD_WORDS | {struct_name(entity["name"]), struct_name(entity["name"]) + "_Path"})


def entry_names(entity: Entity) -> list[tuple[str, str, int]]:
    """The entries of an enum: (C++ name, Unreal's short name, value)."""
    short = [short_entry_name(entry["name"]) for entry in entity["entries"]]
    names = CppNames(short, _MACROS)
    return [(names[name], name, entry["value"]) for name, entry in zip(short, entity["entries"], strict=True)]


def parameter_names(names: Iterable[str]) -> CppNames:
    """The names of a function's parameters."""
    return CppNames(names, _OWN_WORDS)


def result_names(names: Iterable[str]) -> CppNames:
    """The members of the result of a function with several outputs."""
    return CppNames(names, _OWN_WORDS)
